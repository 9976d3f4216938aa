//! A dyad's closed form.

use super::node::Value;

/// A loop that is solved in closed form: its block is straight-line, with a margin to be tested.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForm {
    /// Which loop of the plan it closes.
    pub number: usize,
    /// The joints of the loop whose coordinates are unknown, for messages.
    pub place: String,
    /// What must not be negative for the loop to close: the discriminant of its dyad.
    pub discriminant: Value,
    /// How far rounding may push the discriminant below zero where the loop does close.
    pub tolerance: Value,
    /// The slack and the floor together: not negative if the loop closes. A constant if it always does.
    pub margin: Value,
    /// The sine of the transmission angle, as a part of its greatest, with the sign of the side on which the dyad lies.
    pub sine: Value,
    /// The square of a sine below which rounding hides its sign.
    pub rounding_square: Value,
    /// Whether its dyad has two sides to lie on: where two lines cut each other it has none.
    pub has_branches: bool,
    /// The unknowns, when they are found.
    pub found: Vec<Value>,
    /// What is cut with what.
    pub form: Form,
}

/// What a closed form cuts with what: every vector by its two coordinates, in the frame of the loop's first cluster.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// Two circles: the arms turn, and reach the goal together.
    TwoCircles {
        /// Where both arms together reach.
        goal: [Value; 2],
        /// The arms, each in its own frame.
        arms: [[Value; 2]; 2],
    },
    /// A circle and a line: an arm turns, and a way along a known direction leads on to the goal.
    CircleAndLine {
        /// Where the arm and the way reach.
        goal: [Value; 2],
        /// The arm, in its own frame.
        arm: [Value; 2],
        /// The direction of the way.
        along: [Value; 2],
    },
    /// A line that turns with an arm, and reaches the goal.
    TurningLine {
        /// Where the arm and the way reach.
        goal: [Value; 2],
        /// The arm, in its own frame.
        arm: [Value; 2],
        /// The direction of the way, in the arm's frame.
        along: [Value; 2],
        /// The length at the start to which the loop's sine is relative.
        size: f64,
    },
    /// Two lines: two ways along known directions.
    TwoLines {
        /// Where both ways lead.
        goal: [Value; 2],
        /// Their directions.
        lines: [[Value; 2]; 2],
    },
}

impl Form {
    /// All vectors that it is made from, the goal first.
    pub(crate) fn vectors(&self) -> Vec<[Value; 2]> {
        match *self {
            Self::TwoCircles { goal, arms: [a, b] }
            | Self::TwoLines {
                goal,
                lines: [a, b],
            } => {
                vec![goal, a, b]
            }
            Self::CircleAndLine { goal, arm, along }
            | Self::TurningLine {
                goal, arm, along, ..
            } => {
                vec![goal, arm, along]
            }
        }
    }
}
