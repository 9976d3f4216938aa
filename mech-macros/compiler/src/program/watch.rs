//! Loops that are watched while the mechanism moves.

use super::node::BlockId;
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
