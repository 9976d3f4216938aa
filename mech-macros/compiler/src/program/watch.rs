//! Loops that are watched while the mechanism moves.

use super::node::{BlockId, Op, Value};
use super::{BlockKind, Dyad, Program};
use mech_core::journey::{AtZero, Growth};

/// A loop that has dead points or change points.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Watch {
    /// Its block.
    pub block: BlockId,
    /// The index in the state of the sine of its transmission angle.
    pub sine: usize,
    /// The index in the state of the square of a sine below which rounding hides its sign.
    pub rounding_square: usize,
    /// The number of its loop in the plan.
    pub number: usize,
    /// The greatest rate of the square of that sine with each motor.
    pub rates: Vec<f64>,
    /// The causes that increase it: loops by their place among those that are watched.
    pub growth: Vec<Growth<f64>>,
    /// Whether these are no bounds but guesses.
    pub guessed: bool,
    /// Its behaviour at change points.
    pub at_zero: AtZero,
    /// Whether it is solved by iteration, which fails at a change point.
    pub iterated: bool,
}

/// An angle that is followed over whole turns.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Follow {
    /// The index in the state of the angle.
    pub angle: usize,
    /// Its greatest rate with each motor.
    pub rates: Vec<f64>,
    /// The causes that increase it: loops by their place among those that are watched.
    pub growth: Vec<Growth<f64>>,
    /// Whether these are no bounds but guesses.
    pub guessed: bool,
}

impl Program {
    /// Whether poses of links determine the rest of a position, but for sines of loops that change no faster than links turn: every loop
    /// has a closed form whose arms and lines have fixed directions in their links.
    #[must_use]
    pub(crate) fn turns_with_links(&self) -> bool {
        let motors = self.motors.len();
        let moves = self.depends_on(|op| match op {
            Op::Input(input) => input.motor(motors).is_some(),
            op => matches!(op, Op::Turns(_) | Op::PartOfTurns(..) | Op::Last(_)),
        });
        let is_fixed = |vector: &[Value; 2]| vector.iter().all(|part| !moves[part.index()]);
        let has_fixed_directions = |dyad: &Dyad<Value>| match dyad {
            Dyad::TwoCircles { arms, .. } => arms.iter().all(is_fixed),
            Dyad::CircleAndLine { arm, .. } => is_fixed(arm),
            Dyad::TwoLines { .. } => true,
            // Its sine depends on how far it is drawn out.
            Dyad::TurningLine { .. } => false,
        };
        self.follows.is_empty()
            && self.ssa.blocks.iter().all(|block| match &block.kind {
                BlockKind::Straight => true,
                BlockKind::ClosedForm(closed) => has_fixed_directions(&closed.dyad),
                BlockKind::Newton(_) => false,
            })
    }
}
