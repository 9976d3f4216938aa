//! The results of the compiler for a coherent mechanism.

use crate::cost::Cost;
use crate::model::Model;
use crate::motion::accuracy::{Prediction, SolvedLoop};
use crate::motion::near_miss::NearMiss;
use crate::plan::Plan;
use crate::program::{Program, Timing};
use crate::structure::Structure;

/// A coherent mechanism, analysed and compiled.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Compiled {
    /// The loops, the open chains and the mobility.
    pub structure: Structure,
    /// The order in which positions become known, and the assembly at the start.
    pub plan: Plan,
    /// The program of positions.
    pub program: Program,
    /// The program of velocities and accelerations, if they are asked for.
    pub moving: Option<Program>,
    /// The programs of forces, as far as they are asked for.
    pub forced: ForcePrograms,
    /// The laws of the motors, if any motor has one.
    pub timing: Option<Timing>,
    /// The program of the sensitivities to the params, if they are asked for.
    pub sensitive: Option<Program>,
    /// The mechanism in which a point is given, if motors follow one.
    pub inverse: Option<Box<InverseMechanism>>,
    /// The method of each loop, in the order in which they are solved.
    pub loops: Vec<SolvedLoop>,
    /// The error that is estimated. There is one if an accuracy is declared, or if a loop is solved in a fixed number of steps and the steps of all
    /// motors that move it are declared.
    pub prediction: Option<Prediction>,
    /// The operations that are saved because only what is shown is computed; none if nothing is left out.
    pub saved: Option<Cost>,
    /// The places where loops come near change points.
    pub near_misses: Vec<NearMiss>,
    /// These in words.
    pub notes: Vec<String>,
    /// All of this in words.
    pub report: String,
}

impl Compiled {
    /// The program beside that of positions by which the point of `follow` is led: that of its inverse, or of rates where there are more
    /// motors than needed. None if no point is led.
    #[must_use]
    pub fn leading(&self, model: &Model) -> Option<&Program> {
        if model.inverse.as_ref()?.is_least {
            return self.moving.as_ref();
        }
        self.inverse.as_ref().map(|inverted| &inverted.compiled.program)
    }
}

/// The mechanism in which a point is given and motors follow. Its joints are those of the other, and after them those that carry the point;
/// so are its links, but for the dies of slots, which come last.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct InverseMechanism {
    /// Its parts. Motors of what is given stand in place of those that follow.
    pub model: Model,
    /// Its programs.
    pub compiled: Compiled,
}

/// The programs that compute forces at a position.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ForcePrograms {
    /// The torques or forces of the motors that hold the mechanism at rest.
    pub holding: Option<Program>,
    /// The torques of the motors and the reactions in all joints for a given motion; none if joints are redundant.
    pub inverse_dynamics: Option<Program>,
    /// The inertia and the forces as the motors feel them.
    pub inertia: Option<Program>,
}
