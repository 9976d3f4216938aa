//! What is found out about a mechanism before it is played.

use super::motion::Motion;
use crate::failure::Failure;
use mech_compiler::model::Model;
use mech_compiler::{Compiled, Looks, compile, looks};

/// What takes time to find out about a mechanism before it can be played.
#[derive(Clone)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Prepared {
    pub(super) looks: Looks,
    /// The box around its whole motion: lower left and upper right corner.
    pub(super) extent: [[f64; 2]; 2],
    pub(super) motion: Motion,
    /// The mechanism with what it was compiled for once more; none where that is not possible.
    pub(super) derived: Vec<(Derived, Option<Box<Compiled>>)>,
}

impl Prepared {
    /// Prepares a coherent mechanism to be played.
    pub(super) fn of(model: &Model, compiled: &Compiled) -> Result<Self, Failure> {
        let looks = looks(model, compiled);
        let extent = looks.extent(model, compiled);
        Ok(Self { looks, extent, motion: Motion::new(model, compiled)?, derived: Vec::new() })
    }
}

/// What a mechanism computes besides positions, if it is compiled once more for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub enum Derived {
    /// The rates of all links and of laws.
    Rates,
    /// The forces in all joints.
    Forces,
}

impl Derived {
    /// The mechanism with it; none if that is not possible. It takes as long as the mechanism itself took.
    pub(crate) fn compile(self, model: &Model, compiled: &Compiled) -> Option<Box<Compiled>> {
        let mut model = model.clone();
        model.effects.velocity = true;
        model.effects.acceleration = true;
        model.effects.force |= self == Self::Forces;
        // Positions have to mean the same in both.
        let found = compile(&model).ok();
        found.filter(|other| other.program == compiled.program).map(Box::new)
    }
}
