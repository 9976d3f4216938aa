//! A dyad's closed form.

use super::node::Value;
use crate::plan::Dyad;

/// A loop that is solved in closed form: its block is straight-line, with a margin to be tested.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ClosedForm {
    /// The number of its loop in the plan.
    pub number: usize,
    /// The joints of the loop whose coordinates are unknown, for messages.
    pub place: String,
    /// The discriminant of its dyad: negative if the loop does not close.
    pub discriminant: Value,
    /// The tolerance by which rounding may push the discriminant below zero where the loop does close.
    pub tolerance: Value,
    /// The discriminant and the tolerance together: not negative if the loop closes. A constant if it always does.
    pub margin: Value,
    /// The sine of the transmission angle, as a part of its greatest, with the sign of the side on which the dyad lies.
    pub sine: Value,
    /// The square of a sine below which rounding hides its sign.
    pub rounding_square: Value,
    /// Whether its dyad has two sides to lie on: where two lines cut each other it has none.
    pub has_branches: bool,
    /// The unknowns, as they are found.
    pub found: Vec<Value>,
    /// The circles and lines that it intersects.
    pub(crate) dyad: Dyad<Value>,
    /// The sum of the lengths of its goal and arms at the start, in scene units; where pins all but meet then, a part of what they
    /// reach. The sine of a turning line is relative to it.
    pub size: f64,
}

impl ClosedForm {
    /// The same with other values.
    pub(super) fn map(&self, other: impl Fn(Value) -> Value) -> Self {
        Self {
            number: self.number,
            place: self.place.clone(),
            discriminant: other(self.discriminant),
            tolerance: other(self.tolerance),
            margin: other(self.margin),
            sine: other(self.sine),
            rounding_square: other(self.rounding_square),
            has_branches: self.has_branches,
            found: self.found.iter().map(|found| other(*found)).collect(),
            dyad: self.dyad.map(other),
            size: self.size,
        }
    }
}
