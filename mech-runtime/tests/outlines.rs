//! Any shape there is.

use mech_runtime::{Canvas, OwnedOutline, Pose};
use proptest::prelude::*;

/// A shape with its own numbers.
#[derive(Clone, Debug)]
pub(crate) enum Any {
    Outline(OwnedOutline<f64>),
    Text([f64; 2], String),
}

impl Any {
    pub(crate) fn draw(&self, canvas: &mut impl Canvas<f64>, color: u8) {
        self.draw_at(Pose::identity(), canvas, color);
    }

    pub(crate) fn draw_at(&self, pose: Pose<f64>, canvas: &mut impl Canvas<f64>, color: u8) {
        match self {
            Self::Outline(outline) => canvas.fill(outline.borrowed(), pose, color),
            Self::Text(place, text) => canvas.text(pose.apply(*place), text, color),
        }
    }
}

/// Shapes whose places are such numbers.
pub(crate) fn any(
    number: impl Strategy<Value = f64> + Clone + 'static,
) -> impl Strategy<Value = Any> {
    let place = prop::array::uniform2(number.clone());
    let places = prop::collection::vec(place.clone(), 0..9);
    let arc = |(center, start, angle, width)| OwnedOutline::Arc { center, start, angle, width };
    let outline = prop_oneof![
        (place.clone(), number.clone(), number.clone()).prop_map(round),
        places.clone().prop_map(OwnedOutline::Polygon),
        places.clone().prop_map(OwnedOutline::Winding),
        (places, number.clone()).prop_map(|(points, width)| OwnedOutline::Line { points, width }),
        (place.clone(), place.clone(), -7.0..7.0, number).prop_map(arc),
    ];
    prop_oneof![
        5 => outline.prop_map(Any::Outline),
        1 => (place, ".{0,12}").prop_map(|(at, text)| Any::Text(at, text)),
    ]
}

/// A ring, or a circle if the hole has no radius.
fn round((center, radius, hole): ([f64; 2], f64, f64)) -> OwnedOutline<f64> {
    if hole > 0.0 {
        OwnedOutline::Ring { center, radius, hole }
    } else {
        OwnedOutline::Circle { center, radius }
    }
}
