//! Requirements that are not met.

use super::Words;
use super::effort::time_value;
use crate::digits::{round_to, significant};
use crate::model::{Condition, JointKind, MotorId, Origin};
use crate::repair::Offers;
use crate::structure::{RequirementTrouble, Witness, WitnessPlace};

/// A value is told with so many digits, or more if it would seem to keep its limit.
const DIGITS: i32 = 4;

impl Words<'_> {
    pub(super) fn unmet(
        &self,
        number: usize,
        trouble: &RequirementTrouble,
        offers: &Offers,
    ) -> (Origin, String) {
        let requirement = &self.model.requirements[number];
        let written = &requirement.written;
        let why = requirement.why.iter();
        let why: String = why.map(|why| format!(" ({why})")).collect();
        let not_proved = format!("it could not be proved that `{written}`");
        let text = match trouble {
            RequirementTrouble::Fails(witness) => self.fails(number, witness, &why),
            RequirementTrouble::Stops { motor, limit, unknowns } => {
                let name = &self.model.joint(self.model.motor(*motor).joint).name;
                format!(
                    "`{written}` does not hold{why}: motor `{name}` goes to {} only, where {} close the loop",
                    self.motor_value(*motor, *limit),
                    self.the_joints(unknowns, ["cannot", "cannot"])
                )
            }
            RequirementTrouble::Limited { motor } => {
                let name = &self.model.joint(self.model.motor(*motor).joint).name;
                format!(
                    "`{written}` does not hold{why}: the range of motor `{name}` is less than a turn\nhelp: leave its range out"
                )
            }
            RequirementTrouble::Undecided { value, at, open } => {
                self.undecided(number, [&not_proved, &why], (*value, at, *open))
            }
            RequirementTrouble::TooHard => format!(
                "{not_proved}: the mechanism has too many loops for a proof, or too many ways in which they may be assembled"
            ),
            RequirementTrouble::Iterated { unknowns } => format!(
                "{not_proved}: the loop of {} is solved by iteration, for which there is no proof",
                self.joints(unknowns)
            ),
            RequirementTrouble::NoEffect { .. }
            | RequirementTrouble::NoForces
            | RequirementTrouble::Together
            | RequirementTrouble::NoTimes { .. }
            | RequirementTrouble::Jumps { .. }
            | RequirementTrouble::Astray { .. }
            | RequirementTrouble::NoRate { .. } => self.no_effort(written, trouble, offers),
            RequirementTrouble::NoDyad { unknowns } if unknowns.is_empty() => format!(
                "`{written}` is about a transmission angle, and there is no loop that has one"
            ),
            RequirementTrouble::NoDyad { unknowns } => format!(
                "`{written}` is about a transmission angle, and the loop of {} has none: its joints are solved together",
                self.joints(unknowns)
            ),
            RequirementTrouble::Varies { param } => {
                let param = self.param(*param);
                format!(
                    "{not_proved}: a proof holds for one shape of the mechanism, which param `{param}` may change\nhelp: write `const {param}`"
                )
            }
            RequirementTrouble::NoRange { motor } => {
                let name = &self.model.joint(self.model.motor(*motor).joint).name;
                format!(
                    "{not_proved}: it is not known how far motor `{name}` goes\nhelp: give the motor a range, as `motor {name} in LOW ..= HIGH`, \
                     or the condition values, as `for {name} in LOW ..= HIGH`"
                )
            }
            RequirementTrouble::SeveralMotors { motors, is_in_time } => {
                self.several_motors(written, motors, *is_in_time)
            }
            RequirementTrouble::NotToAndFro { motor } => self.not_to_and_fro(written, *motor),
            RequirementTrouble::Endless { motor } => {
                let name = &self.model.joint(self.model.motor(*motor).joint).name;
                format!(
                    "`{written}` does not hold{why}: what is measured goes on with every turn of motor `{name}`\nhelp: say for which values of \
                     the motor it holds, as `for {name} in LOW ..= HIGH`"
                )
            }
            RequirementTrouble::Follows { motor, origin } => {
                return (*origin, self.follows(*motor));
            }
            RequirementTrouble::Unreachable { motor, limit, origin } => {
                let name = &self.model.joint(self.model.motor(*motor).joint).name;
                let text = format!(
                    "motor `{name}` does not come to all of these values: it goes to {} only",
                    self.motor_value(*motor, *limit)
                );
                return (*origin, text);
            }
        };
        (requirement.origin, text)
    }

    /// What came nearest to a limit, and how much is open elsewhere.
    fn undecided(
        &self,
        number: usize,
        [not_proved, why]: [&str; 2],
        (value, at, open): (f64, &WitnessPlace, f64),
    ) -> String {
        let value = self.measured(number, value, None);
        let more = self.measured(number, open, None);
        format!(
            "{not_proved}, nor that it does not hold{why}\nnote: what came nearest is {value} {}; elsewhere it may be beyond that by {more}{}\nhelp: \
             give the limit more room, or say for which {} it holds, as `for {} in LOW ..= HIGH`",
            self.at_values(at),
            self.circumstances(number),
            if at.time.is_some() { "times" } else { "values of the motors" },
            self.first_input(at)
        )
    }

    /// What is measured does not go there and back.
    fn not_to_and_fro(&self, written: &str, motor: Option<MotorId>) -> String {
        let whole = match motor {
            Some(motor) => {
                let name = &self.model.joint(self.model.motor(motor).joint).name;
                format!(
                    "whole turns of motor `{name}`, and one greatest and one least place in them"
                )
            }
            None => "a period of the laws, and one greatest and one least place in it".to_owned(),
        };
        format!(
            "`{written}` is about a way there and back, and there is none: a time ratio takes {whole}"
        )
    }

    /// Values are given to a motor that has those of its law.
    fn follows(&self, motor: MotorId) -> String {
        let name = &self.model.joint(self.model.motor(motor).joint).name;
        format!(
            "motor `{name}` follows its law, which says where it is and how fast it moves there\nhelp: say for which times it holds, as `for t in LOW \
             ..= HIGH`"
        )
    }

    /// The way of one motor is to be summed up, and these move.
    fn several_motors(&self, written: &str, motors: &[MotorId], is_in_time: bool) -> String {
        let names = motors.iter();
        let names = names.map(|motor| &self.model.joint(self.model.motor(*motor).joint).name);
        let names: Vec<&str> = names.map(String::as_str).collect();
        let Some(last) = names.last() else {
            return format!("`{written}` sums up the way of a motor, and none moves there");
        };
        if is_in_time {
            return format!(
                "it could not be proved that `{written}`: it sums up what goes on in time, and `{}` may stand anywhere\nhelp: say where, as `at {last} = \
                 VALUE`",
                names.join("`, `")
            );
        }
        format!(
            "it could not be proved that `{written}`: it sums up the way of one motor, and `{}` have a part in it\nhelp: say where all but one stand, \
             as `at {last} = VALUE`",
            names.join("`, `")
        )
    }

    fn fails(&self, number: usize, witness: &Witness, why: &str) -> String {
        let requirement = &self.model.requirements[number];
        let written = &requirement.written;
        let places: Vec<String> = witness.places.iter().map(|at| self.at_values(at)).collect();
        let places =
            if places.is_empty() { String::new() } else { format!(" {}", places.join(" and ")) };
        let of = if witness.unknowns.is_empty() {
            String::new()
        } else {
            format!(", in the loop of {}", self.joints(&witness.unknowns))
        };
        let limit = witness.proved.map(|proved| {
            let sign = if witness.is_upper { "at most" } else { "at least" };
            let proved = self.measured(number, proved, Some(witness.is_upper));
            let all = if witness.is_in_time { "at all times" } else { "wherever the motors are" };
            format!("\nhelp: it is {sign} {proved}, {all}")
        });
        format!(
            "`{written}` does not hold{why}: it is {}{places}{of}{}{}",
            self.measured(number, witness.value, None),
            self.circumstances(number),
            limit.unwrap_or_default()
        )
    }

    /// A place in words: ``at `t = 0.5`, `a = 30 deg` ``.
    fn at_values(&self, at: &WitnessPlace) -> String {
        let motors = at.motors.iter().map(|(motor, value)| {
            let name = &self.model.joint(self.model.motor(*motor).joint).name;
            format!("`{name} = {}`", self.bare_motor_value(*motor, *value))
        });
        let time = at.time.map(time_value).into_iter();
        let values: Vec<String> = time.chain(motors).collect();
        if values.is_empty() {
            "wherever the motors are".to_owned()
        } else {
            format!("at {}", values.join(", "))
        }
    }

    /// The name of the first input that a place tells.
    fn first_input(&self, at: &WitnessPlace) -> &str {
        if at.time.is_some() {
            return "t";
        }
        let motor = at.motors.first().map(|(motor, _)| *motor);
        let motor = motor.or_else(|| self.model.motor_ids().next());
        motor.map_or("MOTOR", |motor| &self.model.joint(self.model.motor(motor).joint).name)
    }

    /// A motor's value as one would write it in a text.
    fn bare_motor_value(&self, motor: MotorId, value: f64) -> String {
        match self.model.joint(self.model.motor(motor).joint).kind {
            JointKind::Revolute(..) => format!("{} deg", round_to(value.to_degrees(), 4)),
            _ => format!("{}", significant(value, 7, None)),
        }
    }

    /// What is measured by a requirement, as one would write it; rounded upwards or downwards, if that is said.
    fn measured(&self, number: usize, value: f64, upwards: Option<bool>) -> String {
        let is_angle = match &self.model.requirements[number].condition {
            Condition::Bounds { is_angle, .. } => *is_angle,
            Condition::Turns(_) => true,
        };
        let (value, unit) = if is_angle { (value.to_degrees(), " deg") } else { (value, "") };
        format!("`{}{unit}`", significant(value, DIGITS, upwards))
    }
}
