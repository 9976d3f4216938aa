//! Texts as outlines: the dots of the font of labels, in the frame of a link.

use super::outline::{Outline, fixed};
use crate::model::Place;
use mech_core::font::{ADVANCE, HEIGHT, glyph};
use nalgebra::{Point2, Rotation2, Vector2};

/// A text whose first letter has its lower left corner at a place; none if it has no dots.
pub(super) fn lettering(at: [f64; 2], height: f64, turned: f64, text: &str) -> Option<Outline> {
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
    let corners = strokes
        .into_iter()
        .flat_map(|[a, b, c, d]| [start, a, b, c, d, a]);
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
