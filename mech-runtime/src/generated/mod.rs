//! The functions and types of generated code. They change without notice.

mod advance;
mod arrows;
mod beside;
mod coordinates;
mod dynamics;
mod forces;
mod interpolation;
mod inverse;
mod joints;
mod journey;
mod least;
mod limits;
mod loops;
mod many;
pub mod parameters;
mod params;
mod position;
mod rates;
mod rest;
mod shapes;

pub use crate::blocked::Input;
pub use crate::overlay::{Arrows, Overlay, Spot, Symbol};
pub use crate::{
    Acceleration, BlockedAt, Columns, Cost, Frame, InRange, Smooth, Trace, Vector2, Velocity,
};
pub use crate::{Anchor, Coordinate, JointInfo, JointKind};
pub use crate::{
    Blocked, Canvas, Isometry2, Mechanism, Outline, Palette, Phase, Point2, Pose, Reached, Shape,
};
pub use crate::{Forces, GaussLegendre, Reaction};
pub use advance::{advance, approach};
pub use arrows::{draw_accelerations, draw_force, draw_reactions, draw_velocities};
pub use coordinates::{
    angle, atan2, exp, max, round, sin_cos, slide, slide_acceleration, slide_rate, sqrt,
};
pub use dynamics::{Moment, Simulated, simulate};
pub use forces::{Holding, Inertia, not_finite, pull};
pub use interpolation::Rates;
pub use inverse::{Led, Mover, led_rates, less, reach};
pub use joints::pins;
pub use least::{Surplus, least_rates, reach_least};
pub use limits::{Followed, MoveLimits, Stepping, Watched};
pub use loops::{closed, closes, determined, solve};
pub use many::{FullRange, Reduced, Sines, min_margin, move_many, move_many_then, solve_many};
pub use mech_core::contraction::{before_first, contracts};
pub use mech_core::journey::{AtZero, Growth};
pub use mech_core::motors::turned;
pub use mech_core::{MotionLaw, Real, Staircase};
pub use params::{
    blocked_motors, blocked_params, followed, inputs, motors_of, params_of, reached_by_motors,
};
pub use position::{Motors, Position, finite};
pub use rates::{advance_with, rates_at};
pub use rest::come_to_rest;
pub use shapes::shapes;
pub use shapes::{ring, rounded_f32, rounded_f64, wheel};

// Generated code takes the language's own items from here, because their names may mean something else where it stands.
pub use core::clone::Clone;
pub use core::cmp::PartialEq;
pub use core::default::Default;
pub use core::fmt::Debug;
pub use core::iter::Iterator;
pub use core::marker::{Copy, Sized};
pub use core::ops::Fn;
pub use core::option::Option::{self, None, Some};
pub use core::primitive::{bool, f32, f64, str, usize};
pub use core::result::Result::{self, Err, Ok};

use crate::{Cause, Scalar};

/// The cause and the place of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stop {
    /// The motor or the loop that stopped it.
    pub place: &'static str,
    /// The cause.
    pub cause: Cause,
}

impl Stop {
    /// A cause at a place.
    #[must_use]
    pub const fn new(place: &'static str, cause: Cause) -> Self {
        Self { place, cause }
    }
}

/// A mechanism that traces points.
pub trait Traced {
    /// Records the places of the points.
    fn record(&mut self);
}

/// Paints shapes that are already in painting order.
pub fn paint<T: Scalar>(shapes: &[Shape<T>], poses: &[Pose<T>], canvas: &mut impl Canvas<T>) {
    for shape in shapes {
        if let Some(pose) = Pose::of_link(shape.link, poses) {
            canvas.fill(shape.outline, pose, shape.color);
        }
    }
}

/// Paints symbols over shapes. `pixel` is the size of one of their pixels in scene units.
pub fn paint_symbols<T: Scalar>(
    symbols: &[Symbol<T>],
    poses: &[Pose<T>],
    pixel: T,
    canvas: &mut impl Canvas<T>,
) {
    let size = (pixel * canvas.scale()).to_f32();
    Overlay::new().size(size).draw(symbols, poses, canvas);
}

/// The number of an instance of a part.
///
/// # Panics
/// If there are not so many.
#[track_caller]
#[must_use]
pub fn instance_number(name: &str, k: usize, count: usize) -> usize {
    assert!(k < count, "`{name}` has {count} instances; there is no `{name}({k})`");
    k
}
