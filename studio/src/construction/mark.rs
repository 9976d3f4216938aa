//! Marks with a size in pixels.

use super::Place;
use mech_core::colors::INK;
use mech_runtime::overlay::{arrow, moment};
use mech_runtime::{Canvas, Outline, Pose};

/// The radius of a dot, in pixels.
const DOT: f64 = 3.5;
/// The thickness of arrows, relative to the usual one, and the radius of that of a torque, in pixels.
const SIZE: f32 = 0.8;
const TURN: f32 = 12.0;
/// The width of curves, in pixels.
const CURVE: f64 = 1.5;
/// A circle with a greater diameter, in pixels, is a straight line where it is seen.
const STRAIGHT: f64 = 1e5;
/// The width of a letter, and the height of one, in pixels.
const LETTER: [f64; 2] = [6.0, 7.0];
/// How far a text is from what it names, in pixels.
const BESIDE: f64 = 5.0;

/// A mark in the scene.
#[derive(Clone, Debug)]
pub(super) enum Mark {
    /// A thin line.
    Line {
        ends: [Place; 2],
        color: u8,
    },
    Arrow {
        ends: [Place; 2],
        color: u8,
    },
    /// A line through places of a link in this pose.
    Curve {
        places: Vec<Place>,
        pose: Pose<f64>,
        color: u8,
    },
    /// A circle through the ends of its diameter.
    Circle {
        ends: [Place; 2],
        color: u8,
    },
    /// The arrow of a torque.
    Turn {
        at: Place,
        to_the_left: bool,
        color: u8,
    },
    Dot(Place),
    /// A text that begins so far from a place, in pixels.
    Text {
        at: Place,
        away: Place,
        text: String,
    },
}

impl Mark {
    /// A text beside a place, on the side to which this vector points.
    pub(super) fn name(at: Place, [right, up]: Place, text: String) -> Self {
        #[expect(clippy::cast_precision_loss, reason = "no text has 2⁵² letters")]
        let width = LETTER[0] * text.chars().count() as f64;
        let x = if right < 0.0 { -BESIDE - width } else { BESIDE };
        let y = if up < 0.0 { -BESIDE - LETTER[1] } else { BESIDE };
        let away = [x, y];
        Self::Text { at, away, text }
    }

    /// The same at other places; curves and circles are never moved.
    pub(super) fn map(&self, to: impl Fn(Place) -> Place) -> Self {
        match self.clone() {
            same @ (Self::Curve { .. } | Self::Circle { .. }) => same,
            Self::Line { ends, color } => Self::Line { ends: ends.map(to), color },
            Self::Arrow { ends, color } => Self::Arrow { ends: ends.map(to), color },
            Self::Turn { at, to_the_left, color } => Self::Turn { at: to(at), to_the_left, color },
            Self::Dot(at) => Self::Dot(to(at)),
            Self::Text { at, away, text } => Self::Text { at: to(at), away, text },
        }
    }

    /// The places for which a picture has room, if they are not far away.
    pub(super) fn places(&self) -> &[Place] {
        match self {
            Self::Dot(at) => std::slice::from_ref(at),
            Self::Curve { places, pose, .. } if *pose == Pose::identity() => places,
            _ => &[],
        }
    }

    /// What is written, if it is a text.
    #[cfg(feature = "editor")]
    pub(super) fn text(&self) -> Option<&str> {
        match self {
            Self::Text { text, .. } => Some(text),
            _ => None,
        }
    }

    pub(super) fn paint(&self, canvas: &mut impl Canvas<f64>) {
        let pixel = 1.0 / canvas.scale();
        match self {
            Self::Line { ends, color } => {
                // No trace: that would stay where it was in a moving picture.
                let line = Outline::Line { points: &ends[..], width: pixel };
                canvas.fill(line, Pose::identity(), *color);
            }
            Self::Curve { places, pose, color } => {
                let curve = Outline::Line { points: &places[..], width: CURVE * pixel };
                canvas.fill(curve, *pose, *color);
            }
            Self::Circle { ends, color } => circle(*ends, pixel, *color, canvas),
            Self::Arrow { ends, color } => arrow(canvas, *ends, SIZE, *color),
            Self::Turn { at, to_the_left, color } => {
                moment(canvas, *at, *to_the_left, TURN, SIZE, *color);
            }
            Self::Dot(at) => {
                let dot = Outline::Circle { center: *at, radius: DOT * pixel };
                canvas.fill(dot, Pose::identity(), INK);
            }
            Self::Text { at, away, text } => {
                let place = [at[0] + away[0] * pixel, at[1] + away[1] * pixel];
                canvas.text(place, text, INK);
            }
        }
    }
}

/// Paints a circle through both ends of its diameter. The first is seen: where the second is very far away, a tangent is the circle.
fn circle([near, far]: [Place; 2], pixel: f64, color: u8, canvas: &mut impl Canvas<f64>) {
    let width = CURVE * pixel;
    let [x, y] = [0, 1].map(|part| far[part] - near[part]);
    let diameter = x.hypot(y);
    if diameter > STRAIGHT * pixel {
        let reach = STRAIGHT * pixel / diameter;
        let points = [
            [near[0] - reach * y, near[1] + reach * x],
            [near[0] + reach * y, near[1] - reach * x],
        ];
        let points = &points[..];
        canvas.fill(Outline::Line { points, width }, Pose::identity(), color);
    } else {
        let ring = Outline::Ring {
            center: [0, 1].map(|part| f64::midpoint(near[part], far[part])),
            radius: 0.5 * (diameter + width),
            hole: 0.5 * (diameter - width),
        };
        canvas.fill(ring, Pose::identity(), color);
    }
}
