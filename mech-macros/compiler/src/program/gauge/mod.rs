//! A program that computes what a requirement measures, beside positions.

mod measures;
mod moved;

use super::Program;
use super::builder::SsaBuilder;
use super::forced::Circumstances;
use super::node::{Op, Slot, Value};
use crate::bug::bug;
use crate::model::{JointId, Measured, Model, Quantity, Rate, Requirement};
use crate::plan::{Arithmetic, Plan};
use measures::Measures;

/// A program to positions, with the operations of a requirement after its own.
#[derive(Clone, Debug)]
pub(crate) struct Gauge {
    pub(crate) program: Program,
    /// The values of the requirement's formulas, by their numbers.
    pub(crate) formulas: Vec<Value>,
    /// The angles over whole turns: those that it measures, and those that the program follows for gears, racks and cams.
    pub(crate) angles: Vec<GaugedAngle>,
    /// For each variable that sums up the motion the state in which its value is put.
    pub(crate) summaries: Vec<Option<usize>>,
    /// The values whose derivatives are taken. No derivative goes through an iteration.
    pub(crate) differentiated: Vec<Value>,
}

/// The detail of a mechanism that a requirement is about, where it is about each of several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Detail {
    /// It is about all of it.
    Whole,
    /// The dyad of this number.
    Dyad(usize),
    /// The corner of this number, of two bodies that keep clear.
    Corner(usize),
}

/// An angle over whole turns: a reference, and the angle from there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct GaugedAngle {
    /// The state in which the reference is put.
    pub(crate) reference: usize,
    /// The angle from the reference, between −π and π.
    pub(crate) beyond: Value,
    /// True if the requirement measures it, false if the program only moves something by it.
    pub(crate) is_measured: bool,
}

impl Gauge {
    /// Adds what a requirement measures to a program that finds the poses of all links in closed form; nothing if it asks for a dyad
    /// that there is not.
    pub(crate) fn new(
        model: &Model,
        (plan, program): (&Plan, &Program),
        circumstances: &Circumstances<'_>,
        requirement: &Requirement,
        detail: Detail,
        dyad_of: impl Fn(JointId) -> Option<usize>,
    ) -> Option<Self> {
        let mut measures = Measures::new(model, plan, program, &circumstances.motion);
        let forces = measures.ssa.add_forces(program, circumstances);
        let mut summaries = Vec::new();
        for measured in &requirement.measured {
            let (value, state) = match *measured {
                Measured::Quantity(Quantity::Transmission(joint)) => {
                    let dyad = match (joint, detail) {
                        (Some(joint), _) => dyad_of(joint)?,
                        (None, Detail::Dyad(dyad)) => dyad,
                        (None, _) => bug!("no dyad is chosen of all"),
                    };
                    (measures.transmission(dyad)?, None)
                }
                Measured::Quantity(Quantity::Clearance(links)) => {
                    let Detail::Corner(corner) = detail else {
                        bug!("no corner is chosen of all");
                    };
                    (measures.clearance(links, corner)?, None)
                }
                Measured::Quantity(quantity) if quantity.needs_equilibrium() => {
                    let acting = (forces.as_ref()?, measures.motion);
                    let value = measures.ssa.force(model, acting, quantity)?;
                    (value, None)
                }
                Measured::Quantity(quantity) => (measures.quantity(quantity, circumstances), None),
                Measured::Influence(of, motor) => {
                    let value = requirement.formulas.evaluate_one(of, &mut measures.ssa);
                    let mut tangents = measures.by_motor(motor);
                    (measures.rate(value, &mut tangents), None)
                }
                Measured::Rate(rate, of) => {
                    let value = requirement.formulas.evaluate_one(of, &mut measures.ssa);
                    let mut tangents = measures.by_time();
                    let velocity = measures.rate(value, &mut tangents);
                    let value = match rate {
                        Rate::Velocity => velocity,
                        Rate::Acceleration => tangents.of_all_up_to(&mut measures.ssa, velocity),
                    };
                    (value, None)
                }
                Measured::Summary(..) => {
                    let carried = measures.ssa.carry(0.0);
                    (carried.last, Some(carried.index))
                }
            };
            measures.ssa.variables.push(value);
            summaries.push(state);
        }
        let Measures { mut ssa, mut angles, differentiated, .. } = measures;
        let formulas = requirement.formulas.evaluate(&mut ssa);
        angles.extend(followed(program, &mut ssa));
        let SsaBuilder { ssa, start, state, .. } = ssa;
        Some(Self {
            program: Program { ssa, state, start, ..program.clone() },
            formulas,
            angles,
            summaries,
            differentiated,
        })
    }
}

/// The angles that a program follows over whole turns.
fn followed(program: &Program, ssa: &mut SsaBuilder) -> Vec<GaugedAngle> {
    let states = program.follows.iter().map(|follow| follow.angle);
    let angles = states.map(|state| {
        let last = ssa.make(Op::Last(Slot::State(state)));
        GaugedAngle {
            reference: state,
            beyond: ssa.sub(program.state[state], last),
            is_measured: false,
        }
    });
    angles.collect()
}
