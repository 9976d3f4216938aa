//! Declared ranges that cannot stand.

use super::Words;
use crate::digits::round_to;
use crate::model::{JointKind, MotorId, Origin};
use crate::structure::RangeTrouble;

impl Words<'_> {
    pub(super) fn range(
        &self,
        motor: MotorId,
        unknowns: &[crate::model::JointId],
        trouble: &RangeTrouble,
    ) -> (Origin, String) {
        let declared = self.model.motor(motor);
        let name = self.joint(declared.joint);
        // A motor may have none, where others have.
        let origin = declared.range.map_or(declared.origin, |range| range.origin);
        let at = |value: f64| self.motor_value(motor, value);
        let text = match trouble {
            RangeTrouble::Blocked { limit, until, others } => {
                let others: Vec<String> = others
                    .iter()
                    .map(|(other, value)| {
                        let joint = self.joint(self.model.motor(*other).joint);
                        format!("{joint} at {}", self.motor_value(*other, *value))
                    })
                    .collect();
                let others = if others.is_empty() {
                    String::new()
                } else {
                    format!(" with {}", others.join(" and "))
                };
                let start = self.model.start.value(declared.joint);
                let end = if *limit < start { "begin" } else { "end" };
                format!(
                    "motor {name} is blocked at {}, within its range{others}\nnote: coming from its start at {} it meets a dead \
                     point there; from there to {} {} close the loop\nhelp: let the range {end} at {}, or change a length",
                    at(*limit),
                    at(start),
                    at(*until),
                    self.the_joints(unknowns, ["cannot", "cannot"]),
                    self.value_before(motor, *limit, start)
                )
            }
            RangeTrouble::Cam(cam) => format!(
                "it cannot be proved that motor {name} moves through its range: there is no proof for cams, and {} is a cam\nhelp: leave \
                 the range out; every move is then tested as it is made",
                self.joint(*cam)
            ),
            RangeTrouble::Stops => format!(
                "motor {name} cannot move through its range: {} at a change point in it, and `at change points stop` was declared\nhelp: \
                 narrow the range, or leave `at change points stop` out",
                self.the_joints(unknowns, ["is", "are"])
            ),
            RangeTrouble::Undecided { between } => format!(
                "it could not be proved that motor {name} moves through its range, nor that it does not\nnote: it could not be decided whether \
                 the loop of {} closes {}\nhelp: narrow the range, or leave it out; every move is then tested as it is made",
                self.joints(unknowns),
                self.places(motor, between)
            ),
            RangeTrouble::Iterated => format!(
                "the range of motor {name} cannot be proved: the loop of {} is solved by iteration, for which there is no proof\nhelp: \
                 leave the range out; every move is then tested as it is made{}",
                self.joints(unknowns),
                if self.model.method.is_some() { "; or write `method exact`" } else { "" }
            ),
            RangeTrouble::Varies { param } => {
                let param = self.param(*param);
                format!(
                    "the range of motor {name} is proved for one shape of the mechanism, which param `{param}` may change\nhelp: \
                     leave the range out; every move is then tested as it is made; or write `const {param}`"
                )
            }
            RangeTrouble::Missing => format!(
                "motor {name} has no range, though another motor has one\nnote: what it moves never comes back to where it was, so that \
                 nothing can be proved of all its values\nhelp: declare a range for {name} too, as `motor {} in LOW ..= HIGH`",
                self.model.joint(declared.joint).name
            ),
        };
        (origin, text)
    }

    /// Where motors are, in words: `with joint a at 30 deg`. If it is this motor alone, without its name.
    fn places(&self, motor: MotorId, places: &[(MotorId, (f64, f64))]) -> String {
        let place = |&(other, (low, high)): &(MotorId, (f64, f64))| {
            let [low, high] = [low, high].map(|value| self.motor_value(other, value));
            let place =
                if low == high { format!("at {low}") } else { format!("between {low} and {high}") };
            if other == motor && places.len() == 1 {
                place
            } else {
                format!("with {} {place}", self.joint(self.model.motor(other).joint))
            }
        };
        let places: Vec<String> = places.iter().map(place).collect();
        places.join(" and ")
    }

    /// A value that is short of a dead point, as one would write it: a thousandth at most of an angle or of the mechanism's size, and less
    /// where the start is nearer.
    fn value_before(&self, motor: MotorId, limit: f64, start: f64) -> String {
        /// No number has more.
        const MOST: usize = 15;
        let (unit, limit, start) = match self.model.joint(self.model.motor(motor).joint).kind {
            JointKind::Revolute(..) => (" deg", limit.to_degrees(), start.to_degrees()),
            _ => ("", limit, start),
        };
        let inwards = (start - limit).signum();
        let usual = self.usual_places(motor, 3);
        let mut offers = (usual..).take(MOST).map(|places| {
            let scale = 10_f64.powi(places);
            let short = inwards * (inwards * limit * scale).ceil() / scale;
            round_to(short, usize::try_from(places).unwrap_or(0))
        });
        let short = offers.find(|short| inwards * (start - short) > 0.0);
        format!("`{}{unit}`", short.unwrap_or(start))
    }

    /// So many places of a motor's values, or of lengths where the mechanism's size is 1: more where it is small, fewer where it is large.
    fn usual_places(&self, motor: MotorId, places: i32) -> i32 {
        let size = match self.model.joint(self.model.motor(motor).joint).kind {
            JointKind::Revolute(..) => 1.0,
            _ => self.model.size(),
        };
        #[expect(clippy::cast_possible_truncation, reason = "a power of ten that numbers have")]
        let power = size.log10().floor().clamp(-250.0, 250.0) as i32;
        places - power
    }

    /// A motor's value as one would write it: zero where only rounding has left something.
    pub(super) fn motor_value(&self, motor: MotorId, value: f64) -> String {
        const ROUNDING: f64 = 1e-9;
        let (unit, value) = match self.model.joint(self.model.motor(motor).joint).kind {
            JointKind::Revolute(..) if value.abs() < ROUNDING => (" deg", 0.0),
            JointKind::Revolute(..) => (" deg", value.to_degrees()),
            _ if value.abs() < ROUNDING * self.model.size() => ("", 0.0),
            _ => ("", value),
        };
        let places = usize::try_from(self.usual_places(motor, 4)).unwrap_or(0);
        format!("`{}{unit}`", round_to(value, places.max(4)))
    }
}
