//! Loops that are watched while the mechanism moves.

use super::node::BlockId;
use mech_core::journey::{AtZero, Growth};

/// A loop that has dead points or change points.
#[derive(Clone, Debug, PartialEq)]
pub struct Watch {
    /// Its block.
    pub block: BlockId,
    /// The index in the state of the sine of its transmission angle.
    pub sine: usize,
    /// The index in the state of the square of a sine below which rounding hides its sign.
    pub rounding_square: usize,
    /// Which loop of the plan it closes.
    pub number: usize,
    /// By how much the square of that sine changes with each motor, at most.
    pub rates: Vec<f64>,
    /// What increases that: loops by their place among those that are watched.
    pub growth: Vec<Growth<f64>>,
    /// Whether these are no bounds but guesses.
    pub guessed: bool,
    /// What happens at a change point.
    pub at_zero: AtZero,
    /// Whether it is solved by iteration, which fails at a change point.
    pub iterated: bool,
}

/// An angle that is followed over whole turns.
#[derive(Clone, Debug, PartialEq)]
pub struct Follow {
    /// By how much it changes with each motor, at most.
    pub rates: Vec<f64>,
    /// What increases that: loops by their place among those that are watched.
    pub growth: Vec<Growth<f64>>,
}
