//! Values of motors as they are typed and shown: degrees for what turns, scene units for what slides.

use super::obstacle;
use crate::failure::Failure;
use crate::text::quoted;
use mech_compiler::Compiled;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointId, JointKind, Model, MotorId};

/// The value of a motor, as it is typed: `a=30`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Setting {
    /// The name of the motor's joint.
    pub(crate) motor: String,
    /// In degrees or scene units.
    pub(crate) value: f64,
}

impl std::str::FromStr for Setting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (motor, value) = text
            .split_once('=')
            .ok_or("expected a motor and its value, as `a=30`")?;
        Ok(Self {
            motor: motor.trim().to_owned(),
            value: read_value(value)?,
        })
    }
}

impl Setting {
    /// The motor and its value, in radians or scene units.
    pub(crate) fn resolve(&self, model: &Model) -> Result<(MotorId, f64), Failure> {
        let motor = motor_of(model, &self.motor)?;
        Ok((
            motor,
            from_shown(model, model.motor(motor).joint, self.value),
        ))
    }
}

/// A mechanism with its motors set; others stand as at the start.
pub(crate) fn posed<'c>(
    model: &Model,
    compiled: &'c Compiled,
    settings: &[Setting],
) -> Result<Machine<'c, f64>, Failure> {
    let mut machine = Machine::<f64>::new(&compiled.program);
    let mut motors = machine.position().motors[..model.motors.len()].to_vec();
    for setting in settings {
        let (motor, value) = setting.resolve(model)?;
        motors[motor.index()] = value;
    }
    machine.move_to(&motors).map_err(|stop| {
        let why = obstacle(model, compiled, stop);
        Failure::mechanism(format!("the motors cannot come to these values: {why}"))
    })?;
    Ok(machine)
}

/// From where to where a motor moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Span {
    pub(crate) from: Option<f64>,
    pub(crate) to: Option<f64>,
}

/// A finite number.
pub(crate) fn read_value(text: &str) -> Result<f64, String> {
    let value: f64 = text
        .trim()
        .parse()
        .map_err(|_| format!("`{text}` is not a number"))?;
    if value.is_finite() {
        Ok(value)
    } else {
        Err(format!("`{text}` is not finite"))
    }
}

/// The motor of this name.
pub(crate) fn motor_of(model: &Model, name: &str) -> Result<MotorId, Failure> {
    let named = |id: &MotorId| model.joint(model.motor(*id).joint).name == name;
    model.motor_ids().find(named).ok_or_else(|| {
        let motors = model.motors.iter();
        let names = motors.map(|motor| &model.joint(motor.joint).name);
        Failure::usage(format!(
            "`{}` has no motor `{name}`; it has {}",
            model.name,
            quoted(names)
        ))
    })
}

/// Whether the coordinate of a joint is an angle.
pub(crate) fn turns(model: &Model, joint: JointId) -> bool {
    matches!(model.joint(joint).kind, JointKind::Revolute(..))
}

/// A coordinate as it is shown, in radians or scene units.
pub(crate) fn from_shown(model: &Model, joint: JointId, value: f64) -> f64 {
    if turns(model, joint) {
        value.to_radians()
    } else {
        value
    }
}

/// The unit in which a coordinate is shown.
pub(crate) fn unit_of(model: &Model, joint: JointId) -> &'static str {
    if turns(model, joint) { " deg" } else { "" }
}

/// A coordinate with its unit, rounded for a reader.
pub(crate) fn show_value(model: &Model, joint: JointId, value: f64) -> String {
    let shown = if turns(model, joint) {
        value.to_degrees()
    } else {
        value
    };
    let rounded = (shown * 1e4).round() / 1e4;
    // Zero has no sign.
    format!("{}{}", rounded + 0.0, unit_of(model, joint))
}
