//! The numbers of a shape.

use crate::syntax::ast::{Expr, Outline as Figure, Pair};

/// The points of an outline, and its other numbers with the words before them.
pub(super) fn figure_numbers(outline: &Figure) -> (Vec<&Pair>, Vec<(&'static str, &Expr)>) {
    let mut lengths = Vec::new();
    let points = match outline {
        Figure::Circle { center, radius } => {
            lengths.push(("radius", radius));
            vec![center]
        }
        Figure::Ring {
            center,
            radius,
            hole,
        } => {
            lengths.extend([("radius", radius), ("hole", hole)]);
            vec![center]
        }
        Figure::Polygon { corners, .. } => corners.iter().collect(),
        Figure::Bar { pins, width, .. } => {
            lengths.push(("width", width));
            pins.iter().collect()
        }
        Figure::Gear {
            center,
            radius,
            teeth,
            turned,
        } => {
            lengths.extend(radius.iter().map(|radius| ("radius", radius)));
            lengths.push(("teeth", teeth));
            lengths.extend(turned.iter().map(|angle| ("turned", angle)));
            vec![center]
        }
        Figure::Stand { at, height, turned } => {
            lengths.extend(height.iter().map(|height| ("height", height)));
            lengths.extend(turned.iter().map(|angle| ("turned", angle)));
            vec![at]
        }
        Figure::Rail { ends, width, .. } => {
            lengths.extend(width.iter().map(|width| ("width", width)));
            ends.iter().collect()
        }
        Figure::Spring { ends, width, .. } => {
            lengths.push(("width", width));
            ends.iter().collect()
        }
        Figure::Text {
            at, height, turned, ..
        } => {
            lengths.push(("height", height));
            lengths.extend(turned.iter().map(|angle| ("turned", angle)));
            vec![at]
        }
    };
    (points, lengths)
}
