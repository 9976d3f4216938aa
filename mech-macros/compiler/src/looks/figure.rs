//! Declared shapes that stand for a part of a machine.

use super::outline::{Outline, Painted, fixed, painted};
use super::scene::Scene;
use super::tooth::Side;
use super::wheel::{Wheel, Wheels};
use super::{ground, rolling};
use crate::model::{Figure, LinkId, Measure, Place, Shape};
use mech_core::font::{ADVANCE, HEIGHT, glyph};
use nalgebra::{Point2, Rotation2, Vector2};

/// Coils of a drawn spring, and its wire as a part of its width.
const COILS: u32 = 6;
const WIRE: f64 = 0.2;
/// Radii that differ by less than this part are the same.
const SAME: f64 = 1e-6;

/// The outlines of a figure, from back to front.
pub(super) fn outlines(
    scene: &Scene<'_>,
    wheels: &Wheels,
    link: LinkId,
    shape: &Shape,
    figure: &Figure,
) -> Vec<Painted> {
    let outlines = match figure {
        Figure::Gear { center, radius, teeth, turned } => {
            gear(scene, wheels, link, (*center, *radius, *teeth, *turned), shape.color)
        }
        Figure::Stand { at, height, turned } => {
            let usual = ground::HEIGHT * scene.width;
            let height = height.unwrap_or(usual);
            let down = Rotation2::new(*turned) * Vector2::new(0.0, -1.0);
            let width = scene.width * height / usual;
            ground::stand(fixed(*at), down, [width, height], shape.color)
        }
        Figure::Rail { ends, width } => {
            let [from, to] = ends.map(Point2::from);
            let along = (to - from).normalize();
            let width = width.map_or(scene.width, |width| width / ground::RAIL);
            vec![ground::rail(
                [from, to],
                Vector2::new(along.y, -along.x),
                0.0,
                (width, shape.color),
            )]
        }
        Figure::Spring { ends, width } => {
            vec![(spring(ends.map(Point2::from), *width), shape.color)]
        }
        Figure::Text { at, height, turned, text } => lettering(*at, *height, *turned, text)
            .into_iter()
            .map(|outline| (outline, shape.color))
            .collect(),
    };
    painted(link, shape.plane, outlines).collect()
}

/// A gear: what is not given of it is that of the wheel of this link that has as many teeth.
fn gear(
    scene: &Scene<'_>,
    wheels: &Wheels,
    link: LinkId,
    (center, radius, teeth, turned): ([f64; 2], Option<f64>, u32, Option<f64>),
    color: u8,
) -> Vec<(Outline, u8)> {
    let mut own = wheels.on(link).filter(|wheel| {
        let same = |radius: f64| (radius - wheel.radius).abs() < SAME * wheel.radius;
        wheel.side == Side::Outside && radius.is_none_or(same)
    });
    let exact = |wheel: &&Wheel| wheel.teeth == Some(teeth);
    let first = own.next();
    let meshing = first.into_iter().chain(own).find(exact).or(first);
    let Some(radius) = radius.or(meshing.map(|wheel| wheel.radius)) else {
        return Vec::new();
    };
    let meshing_phase = meshing.filter(exact).map_or(0.0, |wheel| wheel.phase);
    let wheel = Wheel {
        link,
        center: Point2::from(center),
        radius,
        teeth: Some(teeth),
        side: Side::Outside,
        phase: turned.unwrap_or(meshing_phase),
    };
    rolling::wheel(scene, &wheel, color)
}

/// A zigzag from end to end.
fn spring([from, to]: [Point2<f64>; 2], width: f64) -> Outline {
    let along = to - from;
    let across = Vector2::new(-along.y, along.x).normalize() * (0.5 * width);
    let lead = 0.12;
    let steps = 2 * COILS;
    let place = |part: f64, side: f64| {
        let place = from + along * part + across * side;
        fixed([place.x, place.y])
    };
    let peaks = (0..steps).map(|number| {
        let part = lead + (1.0 - 2.0 * lead) * (f64::from(number) + 0.5) / f64::from(steps);
        place(part, if number % 2 == 0 { 1.0 } else { -1.0 })
    });
    let first = [place(0.0, 0.0), place(lead, 0.0)].into_iter();
    let last = [place(1.0 - lead, 0.0), place(1.0, 0.0)];
    Outline::Line {
        points: first.chain(peaks).chain(last).collect(),
        width: Measure::fixed(WIRE * width),
    }
}

/// A text whose first letter has its lower left corner at a place; none if it has no dots.
fn lettering(at: [f64; 2], height: f64, turned: f64, text: &str) -> Option<Outline> {
    let dot = height / f64::from(HEIGHT);
    let turn = Rotation2::new(turned);
    let place = |column: f64, row: f64| {
        let place = Point2::from(at) + turn * Vector2::new(column * dot, row * dot);
        fixed([place.x, place.y])
    };
    let mut strokes: Vec<[Place; 4]> = Vec::new();
    let mut left = 0.0;
    for character in text.chars() {
        for (column, dots) in (0_u8..).zip(glyph(character)) {
            let left = left + f64::from(column);
            for [from, to] in runs(dots) {
                let [low, high] = [to, from].map(|line| f64::from(HEIGHT) - f64::from(line));
                strokes.push([
                    place(left, low),
                    place(left + 1.0, low),
                    place(left + 1.0, high),
                    place(left, high),
                ]);
            }
        }
        left += f64::from(ADVANCE);
    }
    let start = strokes.first()?[0];
    // One polygon: each stroke is a detour from the first corner, and back the same way.
    let corners = strokes.into_iter().flat_map(|[a, b, c, d]| [start, a, b, c, d, a]);
    Some(Outline::Polygon(corners.collect()))
}

/// The runs of dots in a column: where each begins and ends, from above.
fn runs(dots: u8) -> Vec<[u8; 2]> {
    let mut all: Vec<[u8; 2]> = Vec::new();
    for line in (0..HEIGHT).filter(|line| dots >> line & 1 == 1) {
        match all.last_mut() {
            Some([_, end]) if *end == line => *end += 1,
            _ => all.push([line, line + 1]),
        }
    }
    all
}
