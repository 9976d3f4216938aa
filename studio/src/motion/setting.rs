//! Values of motors as they are typed and shown: degrees for what turns, scene units for what slides.

use super::{Mover, motor_name, obstacle};
use crate::failure::Failure;
use crate::text::quoted;
use mech_compiler::Compiled;
use mech_compiler::model::{JointId, Model, MotorId};

/// The value of a motor, as it is typed: `a=30`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Setting {
    /// The name of the motor's joint.
    pub(crate) motor: String,
    /// Its value.
    pub(crate) value: Typed,
}

/// A motor by the name of its joint, and its value in degrees or scene units.
impl From<(String, f64)> for Setting {
    fn from((motor, value): (String, f64)) -> Self {
        let value = value.into();
        Self { motor, value }
    }
}

/// The value of a motor, as it is typed: in degrees, which may be said, or in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Typed {
    /// In degrees or scene units.
    pub(crate) number: f64,
    /// Whether the number was typed with the unit of degrees.
    is_angle: bool,
}

impl From<f64> for Typed {
    fn from(number: f64) -> Self {
        Self { number, is_angle: false }
    }
}

impl std::str::FromStr for Typed {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let angle = text.strip_suffix("deg").or(text.strip_suffix('°'));
        Ok(Self { number: read_value(angle.unwrap_or(text))?, is_angle: angle.is_some() })
    }
}

impl Typed {
    /// The value of a motor, in radians or scene units, which is in its declared range.
    pub(super) fn of(self, model: &Model, motor: MotorId) -> Result<f64, Failure> {
        let joint = model.motor(motor).joint;
        if self.is_angle && !model.turns(joint) {
            let name = motor_name(model, motor);
            return Err(Failure::usage(format!(
                "motor `{name}` slides: its values are in scene units, not in degrees"
            )));
        }
        keep_in_range(model, motor, from_shown(model, joint, self.number))
    }
}

impl std::str::FromStr for Setting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (motor, value) =
            text.split_once('=').ok_or("expected a motor and its value, as `a=30`")?;
        Ok(Self { motor: motor.trim().to_owned(), value: value.parse()? })
    }
}

impl Setting {
    /// The motor and its value, in radians or scene units, which is in its declared range.
    pub(crate) fn resolve(&self, model: &Model) -> Result<(MotorId, f64), Failure> {
        let motor = motor_of(model, &self.motor)?;
        Ok((motor, self.value.of(model, motor)?))
    }
}

/// A mechanism at its start with its motors set; others stay where they are.
pub(crate) fn posed<'c>(
    mut machine: Mover<'c>,
    model: &Model,
    compiled: &'c Compiled,
    settings: &[Setting],
) -> Result<Mover<'c>, Failure> {
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
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Span {
    pub(crate) from: Option<Typed>,
    pub(crate) to: Option<Typed>,
}

/// A finite number.
pub(crate) fn read_value(text: &str) -> Result<f64, String> {
    let value: f64 = text.trim().parse().map_err(|_| format!("`{text}` is not a number"))?;
    if value.is_finite() { Ok(value) } else { Err(format!("`{text}` is not finite")) }
}

/// A value of a motor that is in its declared range. What is outside by rounding alone is at its end.
fn keep_in_range(model: &Model, motor: MotorId, value: f64) -> Result<f64, Failure> {
    let Some([low, high]) = range_of(model, motor) else {
        return Ok(value);
    };
    let inside = value.clamp(low, high);
    if (inside - value).abs() <= 1e-9 * (high - low) {
        return Ok(inside);
    }
    let joint = model.motor(motor).joint;
    let [value, low, high] = [value, low, high].map(|value| show_value(model, joint, value));
    let name = motor_name(model, motor);
    Err(Failure::usage(format!(
        "{value} is outside of the declared range of motor `{name}`, {low} to {high}"
    )))
}

/// The motor of this name.
pub(crate) fn motor_of(model: &Model, name: &str) -> Result<MotorId, Failure> {
    let named = |id: &MotorId| model.joint(model.motor(*id).joint).name == name;
    model.motor_ids().find(named).ok_or_else(|| {
        let motors = model.motors.iter();
        let names = motors.map(|motor| &model.joint(motor.joint).name);
        Failure::usage(format!("`{}` has no motor `{name}`; it has {}", model.name, quoted(names)))
    })
}

/// A coordinate as it is shown, in radians or scene units.
pub(super) fn from_shown(model: &Model, joint: JointId, value: f64) -> f64 {
    if model.turns(joint) { value.to_radians() } else { value }
}

/// The unit in which a coordinate is shown.
pub(crate) fn unit_of(model: &Model, joint: JointId) -> &'static str {
    if model.turns(joint) { " deg" } else { "" }
}

/// A coordinate in its unit.
pub(crate) fn shown(model: &Model, joint: JointId, value: f64) -> f64 {
    if model.turns(joint) { value.to_degrees() } else { value }
}

/// A coordinate with its unit, rounded for a reader.
pub(crate) fn show_value(model: &Model, joint: JointId, value: f64) -> String {
    let rounded = (shown(model, joint, value) * 1e4).round() / 1e4;
    // Zero has no sign.
    format!("{}{}", rounded + 0.0, unit_of(model, joint))
}

/// The ends of a motor's declared range, if it has one.
pub(crate) fn range_of(model: &Model, motor: MotorId) -> Option<[f64; 2]> {
    let range = model.motor(motor).range.as_ref()?;
    let ends = [range.low, range.high];
    ends.iter().all(|end| end.is_finite()).then_some(ends)
}
