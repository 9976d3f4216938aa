//! Painting of outlines in the scene on surfaces of pixels.

use super::arc::Arc;
use super::crossings::Rule;
use super::font;
use super::polygon;
use super::spans::Spans;
use super::stroke::Stroke;
use super::turn::Turn;
use super::view::Projection;
use super::{circle, fixed};
use crate::{Outline, Pose, Real, Scalar};

/// The most steps around an end of a line, or along an arc: thousands of pixels are still round.
const MOST: u32 = 1000;

/// A surface of pixels that can be filled.
pub(super) trait Fill {
    /// The number of straight sides of a circle whose radius is one pixel.
    const FINENESS: f32;

    /// Fills a circle, but for a hole with the same centre, if there is one.
    fn ring<T: Scalar>(&mut self, center: [T; 2], radius: T, hole: T, color: u8);

    /// Fills a polygon. `corner` gives the corners by their number.
    fn polygon<T: Scalar>(
        &mut self,
        corner: &(impl Fn(usize) -> [T; 2] + Clone),
        count: usize,
        rule: Rule,
        color: u8,
    );

    /// Fills what an outline surrounds, by the non-zero rule.
    fn path<T: Scalar>(&mut self, corners: &(impl Iterator<Item = [T; 2]> + Clone), color: u8);
}

/// Pixels belong to a shape or do not.
impl<S: Spans> Fill for S {
    // An error of a 32nd of a pixel.
    const FINENESS: f32 = 12.6;

    fn ring<T: Scalar>(&mut self, center: [T; 2], radius: T, hole: T, color: u8) {
        circle::fill(self, center, radius, hole, color);
    }

    fn polygon<T: Scalar>(
        &mut self,
        corner: &(impl Fn(usize) -> [T; 2] + Clone),
        count: usize,
        rule: Rule,
        color: u8,
    ) {
        polygon::fill(self, corner, count, rule, color);
    }

    fn path<T: Scalar>(&mut self, corners: &(impl Iterator<Item = [T; 2]> + Clone), color: u8) {
        polygon::fill_path(self, corners, Rule::NonZero, color);
    }
}

/// Fills an outline given in the frame of a link that is at `pose`.
#[inline]
pub(super) fn outline<T: Scalar>(
    surface: &mut impl Fill,
    projection: Projection<T>,
    outline: Outline<'_, T>,
    pose: Pose<T>,
    color: u8,
) {
    let place = projection.of(pose);
    match outline {
        Outline::Circle { center, radius } => {
            let radius = projection.length(radius);
            surface.ring(place.point(center), radius, T::ZERO, color);
        }
        Outline::Ring { center, radius, hole } => {
            let [radius, hole] = [radius, hole].map(|length| projection.length(length));
            surface.ring(place.point(center), radius, hole, color);
        }
        Outline::Polygon(corners) => {
            polygon_of(surface, place, corners, Rule::EvenOdd, color);
        }
        Outline::Winding(corners) => {
            polygon_of(surface, place, corners, Rule::NonZero, color);
        }
        Outline::Line { points, width } => {
            let half = <T as Real>::HALF * projection.length(width);
            line(surface, place, points, half, color);
        }
        Outline::Arc { center, start, angle, width } => {
            let half = <T as Real>::HALF * projection.length(width);
            let ends = [center, start].map(|point| place.point(point));
            // The picture's y axis points down.
            arc(surface, ends, -angle, half, color);
        }
    }
}

fn polygon_of<T: Scalar>(
    surface: &mut impl Fill,
    place: super::view::Place<T>,
    corners: &[[T; 2]],
    rule: Rule,
    color: u8,
) {
    let corner = |index: usize| {
        let corner = corners.get(index).copied();
        place.point(corner.unwrap_or([T::ZERO; 2]))
    };
    surface.polygon(&corner, corners.len(), rule, color);
}

fn line<T: Scalar, S: Fill>(
    surface: &mut S,
    place: super::view::Place<T>,
    points: &[[T; 2]],
    half: T,
    color: u8,
) {
    if !(half > T::ZERO && Real::is_finite(half)) {
        return;
    }
    let point = |index: usize| {
        let point = points.get(index).copied();
        place.point(point.unwrap_or([T::ZERO; 2]))
    };
    let is_finite = |index| point(index).iter().all(|&part| Real::is_finite(part));
    if !(0..points.len()).all(is_finite) {
        return;
    }
    let turn = Turn::new(<T as Real>::HALF * T::TURN, half, S::FINENESS, MOST);
    if let Some(stroke) = Stroke::new(point, points.len(), half, turn) {
        surface.path(&stroke, color);
    }
}

/// An arc around the first of two places, from the second. An arc of a whole turn or more is a ring.
fn arc<T: Scalar, S: Fill>(
    surface: &mut S,
    [center, start]: [[T; 2]; 2],
    angle: T,
    half: T,
    color: u8,
) {
    if !(half > T::ZERO && Real::is_finite(half) && Real::is_finite(angle)) {
        return;
    }
    let [x, y] = [start[0] - center[0], start[1] - center[1]];
    let radius = Real::sqrt(x * x + y * y);
    let is_arc = radius > T::ZERO && Real::abs(angle) < T::TURN;
    if !is_arc {
        surface.ring(center, radius + half, radius - half, color);
        return;
    }
    let around = Real::copysign(<T as Real>::HALF * T::TURN, angle);
    let along = Turn::new(angle, radius + half, S::FINENESS, MOST);
    let around = Turn::new(around, half, S::FINENESS, MOST);
    let direction = [x / radius, y / radius];
    let arc = Arc::new(center, radius, direction, half, along, around);
    surface.path(&arc, color);
}

/// Writes a text, its lower left corner at a place in pixels.
pub(super) fn text<T: Scalar>(surface: &mut impl Spans, [x, y]: [T; 2], text: &str, color: u8) {
    if !(Real::is_finite(x) && Real::is_finite(y)) {
        return;
    }
    let [left, bottom] = [x, y].map(|at| fixed::nearest(at));
    font::write(surface, left, bottom, text, color);
}
