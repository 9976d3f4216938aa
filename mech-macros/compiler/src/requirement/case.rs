//! A condition that is proved, and how it is measured.

use super::Verdicts;
use super::circumstances::Setting;
use super::sides::Ways;
use crate::compiled::Compiled;
use crate::evaluate::Machine;
use crate::model::{JointId, Model, MotorId, Requirement};
use crate::plan::Loop;
use crate::program::{Detail, Gauge, Motion, Position, Program};
use crate::structure::{RequirementTrouble, WitnessPlace};

/// A condition, for one detail if it is about each.
#[derive(Clone, Copy)]
pub(super) struct Case<'a, 'w> {
    pub(super) model: &'a Model,
    pub(super) compiled: &'a Compiled,
    pub(super) verdicts: &'a Verdicts<'a>,
    pub(super) ways: &'a Ways<'w>,
    pub(super) requirement: &'a Requirement,
    pub(super) setting: &'a Setting,
    pub(super) detail: Detail,
}

impl Case<'_, '_> {
    /// The program that measures it.
    pub(super) fn gauge(&self) -> Result<Gauge, RequirementTrouble> {
        self.gauge_of(self.setting.positions(self.compiled), None)
    }

    /// The program that measures it beside one of positions, if motors move so, or else as they do.
    pub(super) fn gauge_of(
        &self,
        positions: &Program,
        motion: Option<Motion<'_>>,
    ) -> Result<Gauge, RequirementTrouble> {
        let Self { model, compiled, requirement, setting, .. } = *self;
        let forces = setting.forces(model, compiled, requirement)?;
        let mut circumstances = setting.circumstances(requirement, forces.as_deref());
        if let Some(motion) = motion {
            circumstances.motion = motion;
        }
        let gauge = Gauge::new(
            model,
            (&compiled.plan, positions),
            &circumstances,
            requirement,
            self.detail,
            |joint| compiled.plan.number_of_loop(joint),
        );
        gauge.ok_or_else(|| {
            if requirement.is_about_forces() {
                return RequirementTrouble::NoForces;
            }
            let unknowns = self.unknowns();
            RequirementTrouble::NoDyad { unknowns }
        })
    }

    /// The unknown joints of the loop that it is about, if it is about one.
    pub(super) fn unknowns(&self) -> Vec<JointId> {
        let Detail::Dyad(number) = self.detail else {
            return Vec::new();
        };
        let ring = self.compiled.plan.loops().nth(number);
        ring.map_or(Vec::new(), Loop::unknowns)
    }

    /// A place, of which some motors are told, and those that follow laws.
    pub(super) fn place(&self, place: &[f64], told: impl Fn(MotorId) -> bool) -> WitnessPlace {
        if let Some(timed) = self.setting.timed() {
            return timed.place(place, told);
        }
        let motors = self.model.motor_ids().zip(place);
        let told = motors.filter(|(motor, _)| told(*motor));
        WitnessPlace { time: None, motors: told.map(|(motor, value)| (motor, *value)).collect() }
    }

    /// The position at a place, as the mechanism comes there from its start.
    pub(super) fn visit(&self, place: &[f64]) -> Option<Position<f64>> {
        let program = &self.compiled.program;
        match self.setting.timed() {
            Some(timed) => timed.visit(program, place),
            None => visit(program, place),
        }
    }
}

/// The position at a place to which the motors go together, or one after the other.
fn visit(program: &Program, place: &[f64]) -> Option<Position<f64>> {
    let mut machine = Machine::<f64>::new(program);
    if machine.move_to(place).is_err() {
        let mut values = program.start.motors.clone();
        for (motor, goal) in place.iter().enumerate() {
            values[motor] = *goal;
            machine.move_to(&values).ok()?;
        }
    }
    Some(machine.into_position())
}
