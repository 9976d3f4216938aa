//! Where a mechanism comes to rest, in words.

use super::Analysed;
use crate::failure::Failure;
use crate::motion::{Mover, Setting, find_rest, motor_name, posed, show_value};
use crate::quantity::{Load, compiled, four_digits, load_numbers};
use mech_compiler::model::{Model, MotorId, Precision};
use std::fmt::Write;

/// A mechanism whose motors are let go, but for those that are held.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Rest {
    /// Motors that are held, and where.
    pub(crate) at: Vec<Setting>,
    pub(crate) loads: Vec<Load>,
}

impl Rest {
    pub(super) fn run(&self, analysed: &Analysed) -> Result<String, Failure> {
        let mut model = Model { show: None, precision: Precision::F64, ..analysed.model.clone() };
        model.effects.force = true;
        let compiled = compiled(&model)?;
        let held = self.at.iter().map(|setting| setting.resolve(&model));
        let held = held.collect::<Result<Vec<_>, _>>()?;
        let is_held = |motor: &MotorId| held.iter().any(|(own, _)| own == motor);
        let is_driven = |motor: &MotorId| model.lawful_motors().any(|(own, _)| own == *motor);
        let free = model.motor_ids().filter(|motor| !is_held(motor) && !is_driven(motor));
        let free: Vec<MotorId> = free.collect();
        if free.is_empty() {
            return Err(Failure::usage(
                "every motor is held, by `--at` or by its law: none is left that could come to rest",
            ));
        }
        let machine = posed(Mover::new(&model, &compiled), &model, &compiled, &self.at)?;
        let loads = load_numbers(&model, &self.loads)?;
        let before = machine.position().motors;
        let found = find_rest(&model, &compiled, machine, &free, &loads)?;
        let mut text = format!("{} comes to rest:\n", model.name);
        for motor in model.motor_ids() {
            let number = motor.index();
            let joint = model.motor(motor).joint;
            let value = |value| show_value(&model, joint, value);
            let name = motor_name(&model, motor);
            let at = value(found.motors[number]);
            let torque = found.torques[number].abs();
            let how = if is_driven(&motor) {
                ", where its law holds it".to_owned()
            } else if is_held(&motor) {
                ", where it is held".to_owned()
            } else if torque > 0.0 {
                let torque = four_digits(torque);
                format!(", its end, against which it leans with {torque}")
            } else {
                format!(", from {}", value(before[number]))
            };
            let _ = writeln!(text, "  motor `{name}` at {at}{how}");
        }
        Ok(text)
    }
}
