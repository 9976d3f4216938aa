//! What a mechanism computes besides positions.

use mech_compiler::model::Model;
use mech_compiler::{Compiled, compile};

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
        found
            .filter(|other| other.program == compiled.program)
            .map(Box::new)
    }
}
