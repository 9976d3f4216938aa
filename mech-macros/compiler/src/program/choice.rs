//! The choices of how each loop is solved and watched.

use super::newton::Rounds;
use crate::model::{Method, Model};
use crate::plan::Bound;
use mech_core::journey::AtZero;

/// More rounds than this never help: Newton's iteration doubles its digits in each.
pub(super) const MOST_ROUNDS: u32 = 24;

/// The solver of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Solver {
    /// In closed form, if it is a dyad; else by Newton's iteration until it closes.
    ClosedForm,
    /// By one linear step from the last position.
    Linear,
    /// By Newton's iteration.
    Newton(Rounds),
}

/// The watch over a loop.
#[derive(Clone, Debug, PartialEq)]
pub struct Watching {
    /// The greatest rate of the square of its sine with each motor.
    pub bound: Bound,
    /// Its behaviour at change points.
    pub at_zero: AtZero,
}

/// The decisions about a loop before its program is built.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// Its solver.
    pub solver: Solver,
    /// From how many differences its iteration is started, 0 to 3, as long as the motors move by equal steps.
    pub predictor: u8,
    /// Whether it is watched, because it has dead points or change points. If it goes over to its other side there, on which
    /// side its dyad lies is carried from position to position, and it is solved in closed form.
    pub watching: Option<Watching>,
    /// Whether it was proved to close wherever the motors may go, so that nothing has to be tested.
    pub proved: bool,
    /// Whether the pins that its dyad joins come so near each other that rounding stretches its links, unless their directions are
    /// brought back to length one.
    pub pins_near: bool,
    /// On which side its dyad lies at the start, where the start itself does not determine it.
    pub side: Option<bool>,
}

impl Choice {
    /// Whether its dyad goes over to its other side at change points.
    #[must_use]
    pub fn changes_branch(&self) -> bool {
        matches!(&self.watching, Some(watching) if watching.at_zero == AtZero::ChangeBranch)
    }

    /// All loops as the mechanism declares it: in closed form, if it declares no method.
    #[must_use]
    pub fn declared(model: &Model) -> Self {
        Self { predictor: model.predictor, ..Self::by(model.method.unwrap_or_default()) }
    }

    /// All loops by this method.
    #[must_use]
    pub fn by(method: Method) -> Self {
        let solver = match method {
            Method::Exact => Solver::ClosedForm,
            Method::Linear => Solver::Linear,
            Method::Newton => Solver::Newton(Rounds::UntilClosed(MOST_ROUNDS)),
            Method::NewtonSteps(rounds) => Solver::Newton(Rounds::Exactly(rounds)),
        };
        Self { solver, predictor: 0, watching: None, proved: false, pins_near: false, side: None }
    }
}
