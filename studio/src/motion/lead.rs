//! A point that `follow` leads to a place: the values of the motors that follow it.

use super::{Mover, motor_name, obstacle, range_of, read_value, show_value};
use crate::failure::Failure;
use mech_compiler::model::{Inverse, Model};
use mech_compiler::{Compiled, Unreachable};

/// The place to which a point is led, as it is typed: `1.5,2`, or with the angle of its link in degrees, `1.5,2,30`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Goal(Vec<f64>);

impl std::str::FromStr for Goal {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let values: Vec<f64> = text.split(',').map(read_value).collect::<Result<_, _>>()?;
        match values.len() {
            2 | 3 => Ok(Self(values)),
            _ => Err("expected x and y, as `1.5,2`, or the angle of the link, too".to_owned()),
        }
    }
}

impl Goal {
    /// Leads the point of a mechanism to the place, straight from where it is.
    pub(crate) fn lead(
        &self,
        model: &Model,
        compiled: &Compiled,
        machine: &mut Mover<'_>,
    ) -> Result<(), Failure> {
        let (Some(inverse), Some(leading)) = (&model.inverse, compiled.leading(model)) else {
            let why = "it has no statement as `follow pen.tip by a, b;`";
            return Err(Failure::usage(format!("`{}` leads no point: {why}", model.name)));
        };
        let name = inverse.name(model);
        let Self(mut place) = self.clone();
        if place.len() != inverse.given().len() {
            let given = if inverse.gives_angle() {
                "x, y and the angle of its link, as `--reach 1.5,2,30`"
            } else {
                "x and y, as `--reach 1.5,2`"
            };
            return Err(Failure::usage(format!("`{name}` is led by {given}")));
        }
        if let Some(angle) = place.get_mut(Inverse::ANGLE) {
            *angle = angle.to_radians();
        }
        let mut other = Mover::of(model, leading);
        let led = machine.lead(model, compiled, &mut other, &place);
        led.map_err(|why| {
            let why = unreachable(model, compiled, why);
            let numbers: Vec<String> = self.0.iter().map(f64::to_string).collect();
            let place = numbers.join(", ");
            Failure::mechanism(format!("`{name}` cannot be led to ({place}): {why}"))
        })
    }
}

/// The failure of a motion along a path that is stopped at a time.
pub(super) fn stopped_on_path(
    model: &Model,
    compiled: &Compiled,
    time: f64,
    why: Unreachable,
) -> Failure {
    let what = model.inverse.as_ref().map(|inverse| inverse.name(model));
    let (what, why) = (what.unwrap_or_default(), unreachable(model, compiled, why));
    Failure::mechanism(format!("`{what}` cannot follow its path until t = {time}: {why}"))
}

/// Describes why a point does not come to a place.
fn unreachable(model: &Model, compiled: &Compiled, why: Unreachable) -> String {
    match (why, &compiled.inverse) {
        (Unreachable::Stopped(stop), Some(inverted)) => {
            obstacle(&inverted.model, &inverted.compiled, stop)
        }
        (Unreachable::Stopped(stop), None) => obstacle(model, compiled, stop),
        (Unreachable::Undetermined, _) => {
            "on the way there its motors do not move it every way".to_owned()
        }
        (Unreachable::OutOfRange(motor), _) => {
            let joint = model.motor(motor).joint;
            let ends = range_of(model, motor).map_or(String::new(), |ends| {
                let [low, high] = ends.map(|end| show_value(model, joint, end));
                format!(", {low} to {high}")
            });
            let name = motor_name(model, motor);
            format!("motor `{name}` would leave its declared range{ends}")
        }
        _ => "on the way there the motors cannot follow it".to_owned(),
    }
}
