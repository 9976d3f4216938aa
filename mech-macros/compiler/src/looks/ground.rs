//! The body of the ground: stands under fixed pivots, and rails under blocks.

use super::outline::{Outline, fixed};
use super::scene::Scene;
use super::survey::Slide;
use super::wheel::{Wheel, Wheels};
use crate::model::{LinkId, Measure, Place};
use mech_core::colors::{GROUND, darker};
use nalgebra::{Point2, Vector2, distance};

/// A stand, in widths of a bar: its height, half of its top and of its foot, half of its base.
pub(super) const HEIGHT: f64 = 4.0;
const TOP: f64 = 0.8;
const FOOT: f64 = 1.5;
const BASE: f64 = 2.4;
/// So much longer than usual a stand is at most, so that its base is level with others, and than the radius of its wheel.
const MOST_LONGER: f64 = 6.0;
const BEHIND: f64 = 1.2;
/// A base or a rail, in widths of a bar: how thick it is; its strokes of hatching: how far apart, how long and how wide.
const THICK: f64 = 0.24;
const STEP: f64 = 0.9;
const STROKE: f64 = 0.75;
const THIN: f64 = 0.26;
/// The width of a rail with its hatching, in widths of a bar.
pub(super) const RAIL: f64 = THICK + STROKE;
/// A rail goes so much farther than the block at each end.
const BEYOND: f64 = 1.7;
/// The middle line of a block is so high above its rail.
const ABOVE: f64 = 0.95;
/// The rails of a slot are so far from the middle of its pin.
const BESIDE_PIN: f64 = 0.4;
/// Mounts that move about a pivot count as below it if their mean height is below the pivot by this part of their mean distance.
const BELOW: f64 = 0.3;

/// A fixed pivot that is to have a stand.
struct Stand {
    place: Place,
    at: Point2<f64>,
    /// Whether what it carries hangs from it.
    hangs: bool,
    /// Its height, in scene units.
    height: f64,
}

/// The stands of all fixed pivots, from back to front. Their bases are on one level, as far as no stand gets too long.
pub(super) fn stands(scene: &Scene<'_>, wheels: &Wheels) -> Vec<(Outline, u8)> {
    let mut stands = pivots(scene, wheels);
    for hangs in [false, true] {
        let up = if hangs { 1.0 } else { -1.0 };
        let own = stands.iter().filter(|stand| stand.hangs == hangs);
        let base = own.map(|stand| up * stand.at.y + stand.height).reduce(f64::max);
        let own = stands.iter_mut().filter(|stand| stand.hangs == hangs);
        for (stand, base) in own.zip(base.into_iter().cycle()) {
            let height = base - up * stand.at.y;
            if height <= stand.height + MOST_LONGER * scene.width {
                stand.height = height;
            }
        }
    }
    let stands = stands.into_iter().flat_map(|stand| {
        let up = if stand.hangs { 1.0 } else { -1.0 };
        self::stand(stand.place, Vector2::new(0.0, up), [scene.width, stand.height], GROUND)
    });
    stands.collect()
}

/// The fixed pivots of links that are shown, each place once, except those on shapes of the ground.
fn pivots(scene: &Scene<'_>, wheels: &Wheels) -> Vec<Stand> {
    let mut all: Vec<Stand> = Vec::new();
    for pin in &scene.structure.pins {
        let Some(axis) = pin.axis_of(LinkId::GROUND) else {
            continue;
        };
        let axis = scene.model.axis(axis);
        let at = Point2::from(axis.at);
        let movers: Vec<LinkId> = pin.members.iter().map(|member| member.0).collect();
        let is_seen = movers.iter().any(|&link| scene.is_shown(link) && link != LinkId::GROUND);
        let is_seen = is_seen && !scene.is_covered(LinkId::GROUND, at);
        let is_new = all.iter().all(|known| distance(&known.at, &at) > 0.5 * scene.width);
        if is_seen && is_new {
            // A stand looks out from behind a wheel.
            let on_pivot =
                |wheel: &&Wheel| movers.contains(&wheel.link) && wheel.link != LinkId::GROUND;
            let radii = wheels.all.iter().filter(on_pivot).map(|wheel| wheel.radius);
            let radius = radii.fold(0.0, f64::max);
            all.push(Stand {
                place: axis.place(),
                at,
                hangs: hangs(scene, at, &movers),
                height: (HEIGHT * scene.width).max(radius + BEHIND * scene.width),
            });
        }
    }
    all
}

/// Whether what turns about a fixed pivot is below it: then it hangs from its stand.
fn hangs(scene: &Scene<'_>, pivot: Point2<f64>, movers: &[LinkId]) -> bool {
    let (mut height, mut reach) = (0.0, 0.0);
    for &link in movers.iter().filter(|link| **link != LinkId::GROUND) {
        let mounts = scene.mounts(link);
        let frames = scene.survey.positions.iter();
        for frame in frames.filter_map(|frames| frames.frame(link)) {
            for mount in mounts {
                let offset = frame * mount.at - pivot;
                height += offset.y;
                reach += offset.norm();
            }
        }
    }
    height < -BELOW * reach
}

/// A stand with its head at a place, whose base is in a direction from it: outlines and their colours, from back to front.
pub(super) fn stand(
    place: Place,
    down: Vector2<f64>,
    [width, height]: [f64; 2],
    color: u8,
) -> Vec<(Outline, u8)> {
    let across = Vector2::new(-down.y, down.x);
    let at = |ahead: f64, below: f64| moved(place, (across * ahead + down * below) * width);
    let height = height / width;
    let body = [(-FOOT, height), (FOOT, height), (TOP, 0.0), (-TOP, 0.0)];
    let body = body.map(|(ahead, below)| at(ahead, below));
    let radius = Measure::fixed(TOP * width);
    let base = hatched([-BASE, BASE], height);
    let base = base.into_iter().map(|[ahead, below]| at(ahead, below));
    vec![
        (Outline::Polygon(body.into_iter().collect()), color),
        (Outline::Circle { center: place, radius }, color),
        (Outline::Polygon(base.collect()), darker(color)),
    ]
}

/// A strip with strokes of hatching below it, as one simple polygon in widths of a bar: how far ahead, and how far below.
fn hatched([from, to]: [f64; 2], top: f64) -> Vec<[f64; 2]> {
    let bottom = top + THICK;
    let mut corners = vec![[from, top], [to, top], [to, bottom]];
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few hundred strokes"
    )]
    let strokes = ((to - from) / STEP).clamp(1.0, 400.0) as u32;
    for number in 0..strokes {
        let right = to - STEP * f64::from(number) - 0.1;
        corners.extend([
            [right, bottom],
            [right - STROKE, bottom + STROKE],
            [right - STROKE - THIN, bottom + STROKE],
            [right - THIN * 1.4, bottom],
        ]);
    }
    corners.push([from, bottom]);
    corners
}

/// The rails of everything that slides on the ground.
pub(super) fn rails(scene: &Scene<'_>) -> Vec<(Outline, u8)> {
    let on_ground = |slide: &Slide| {
        let [guide, block] = scene.ends(*slide);
        let line = scene.model.axis(slide.guide);
        let is_drawn = scene.is_covered(LinkId::GROUND, line.at.into());
        guide == LinkId::GROUND && scene.is_shown(block) && !is_drawn
    };
    let slides = scene.slides().filter(on_ground);
    slides.flat_map(|slide| rails_of(scene, slide).unwrap_or_default()).collect()
}

/// The rail of a slide on the ground, or both of a pin in a slot; none if it is never seen.
fn rails_of(scene: &Scene<'_>, slide: Slide) -> Option<Vec<(Outline, u8)>> {
    let [low, high] = scene.travel(slide)?;
    let guide = scene.model.axis(slide.guide);
    let (at, along) = (Point2::from(guide.at), Vector2::from(guide.direction));
    let width = scene.width;
    let ends = [low - BEYOND * width, high + BEYOND * width].map(|offset| at + along * offset);
    let (below, style) = (side(along), (width, darker(GROUND)));
    Some(if slide.pin.is_some() {
        [below, -below].map(|side| rail(ends, side, BESIDE_PIN, style)).to_vec()
    } else {
        vec![rail(ends, below, ABOVE, style)]
    })
}

/// On which side of a line its rail is: below, or to the right where it is upright.
fn side(along: Vector2<f64>) -> Vector2<f64> {
    let right = Vector2::new(along.y, -along.x);
    let is_below = along.x > 1e-9 || (along.x > -1e-9 && along.y > 0.0);
    if is_below { right } else { -right }
}

/// A hatched rail beside a line from end to end, so many widths of a bar away from it.
pub(super) fn rail(
    [from, to]: [Point2<f64>; 2],
    side: Vector2<f64>,
    above: f64,
    (width, color): (f64, u8),
) -> (Outline, u8) {
    let length = distance(&from, &to);
    let along = (to - from) / length.max(f64::MIN_POSITIVE);
    let corners = hatched([0.0, length / width], above);
    let corners = corners.into_iter().map(|[ahead, below]| {
        let place = from + along * (ahead * width) + side * (below * width);
        fixed([place.x, place.y])
    });
    (Outline::Polygon(corners.collect()), color)
}

/// A place that is moved with another: where that depends on params, so does this.
fn moved(place: Place, by: Vector2<f64>) -> Place {
    // A sum has no formula of its own: what params move keeps its shape where it was at the start.
    let [x, y] = place.map(Measure::at_start);
    fixed([x + by.x, y + by.y])
}
