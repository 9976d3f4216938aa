//! What the compiler found out about a coherent mechanism.

use crate::cost::Cost;
use crate::motion::accuracy::{Prediction, SolvedLoop};
use crate::plan::Plan;
use crate::program::{Program, Timing};
use crate::structure::Structure;

/// A mechanism that was found coherent, and all that was found out about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Compiled {
    /// What is connected, what moves, what is trunk and what is arm.
    pub structure: Structure,
    /// In which order positions become known, and where everything is at the start.
    pub plan: Plan,
    /// The operations that move it.
    pub program: Program,
    /// The operations that move it and go on to velocities, if these were asked for.
    pub moving: Option<Program>,
    /// The operations that go on to forces, if these were asked for.
    pub forced: ForcePrograms,
    /// The laws of the motors, if any has one.
    pub timing: Option<Timing>,
    /// The operations that tell how everything follows the params, if that was asked for.
    pub sensitive: Option<Program>,
    /// How each loop is solved, in the order in which they are closed.
    pub loops: Vec<SolvedLoop>,
    /// How exact it will be, if an accuracy is declared, or if a loop is solved in a fixed number of steps and the steps of all
    /// motors are declared that move it.
    pub prediction: Option<Prediction>,
    /// What it saves that only what is shown is computed, if something is left out.
    pub saved: Option<Cost>,
    /// All of this in words.
    pub report: String,
}

/// The programs that go on from positions to forces, as far as these were asked for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ForcePrograms {
    /// To what it takes to hold it at rest.
    pub holding: Option<Program>,
    /// To what it takes to move in a given way, in every joint; not where joints are redundant.
    pub inverse_dynamics: Option<Program>,
    /// To inertia and forces as the motors feel them.
    pub inertia: Option<Program>,
}
