//! Any shape there is.

use mech_runtime::{Canvas, Outline, Pose};
use proptest::prelude::*;

/// A shape with its own numbers.
#[derive(Clone, Debug)]
pub(crate) enum Any {
    Ring([f64; 2], f64, f64),
    Polygon(Vec<[f64; 2]>),
    Winding(Vec<[f64; 2]>),
    Line(Vec<[f64; 2]>, f64),
    Arc([f64; 2], [f64; 2], f64, f64),
    Text([f64; 2], String),
}

impl Any {
    pub(crate) fn draw(&self, canvas: &mut impl Canvas<f64>, color: u8) {
        let outline = match *self {
            Self::Ring(center, radius, hole) if hole > 0.0 => Outline::Ring {
                center,
                radius,
                hole,
            },
            Self::Ring(center, radius, _) => Outline::Circle { center, radius },
            Self::Polygon(ref corners) => Outline::Polygon(corners),
            Self::Winding(ref corners) => Outline::Winding(corners),
            Self::Line(ref points, width) => Outline::Line { points, width },
            Self::Arc(center, start, angle, width) => Outline::Arc {
                center,
                start,
                angle,
                width,
            },
            Self::Text(place, ref text) => {
                canvas.text(place, text, color);
                return;
            }
        };
        canvas.fill(outline, Pose::identity(), color);
    }
}

/// Shapes whose places are such numbers.
pub(crate) fn any(
    number: impl Strategy<Value = f64> + Clone + 'static,
) -> impl Strategy<Value = Any> {
    let place = prop::array::uniform2(number.clone());
    let places = prop::collection::vec(place.clone(), 0..9);
    prop_oneof![
        (place.clone(), number.clone(), number.clone()).prop_map(|(at, r, h)| Any::Ring(at, r, h)),
        places.clone().prop_map(Any::Polygon),
        places.clone().prop_map(Any::Winding),
        (places, number.clone()).prop_map(|(points, width)| Any::Line(points, width)),
        (place.clone(), place.clone(), -7.0..7.0, number)
            .prop_map(|(center, start, angle, width)| Any::Arc(center, start, angle, width)),
        (place, ".{0,12}").prop_map(|(at, text)| Any::Text(at, text)),
    ]
}
