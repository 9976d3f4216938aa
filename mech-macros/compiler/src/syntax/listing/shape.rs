//! The numbers of a shape.

use crate::syntax::ast::{Expr, Outline, Pair};

/// The points of an outline, and its other numbers with the words before them.
pub(super) fn shape_numbers(outline: &Outline) -> (Vec<&Pair>, Vec<(&'static str, &Expr)>) {
    let mut lengths = Vec::new();
    let points = match outline {
        Outline::Circle { center, radius } => {
            lengths.push(("radius", radius));
            vec![center]
        }
        Outline::Ring { center, radius, hole } => {
            lengths.extend([("radius", radius), ("hole", hole)]);
            vec![center]
        }
        Outline::Polygon { corners, .. } => corners.iter().collect(),
        Outline::Bar { pins, width, .. } => {
            lengths.push(("width", width));
            pins.iter().collect()
        }
        Outline::Gear { center, radius, teeth, turned } => {
            lengths.extend(radius.iter().map(|radius| ("radius", radius)));
            lengths.push(("teeth", teeth));
            lengths.extend(turned.iter().map(|angle| ("turned", angle)));
            vec![center]
        }
        Outline::Stand { at, height, turned } => {
            lengths.extend(height.iter().map(|height| ("height", height)));
            lengths.extend(turned.iter().map(|angle| ("turned", angle)));
            vec![at]
        }
        Outline::Rail { ends, width, .. } => {
            lengths.extend(width.iter().map(|width| ("width", width)));
            ends.iter().collect()
        }
        Outline::Spring { ends, width, .. } => {
            lengths.push(("width", width));
            ends.iter().collect()
        }
        Outline::Text { at, height, turned, .. } => {
            lengths.push(("height", height));
            lengths.extend(turned.iter().map(|angle| ("turned", angle)));
            vec![at]
        }
    };
    (points, lengths)
}
