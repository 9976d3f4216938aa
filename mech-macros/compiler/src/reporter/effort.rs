//! Rates and forces that are expected: why they are not measured, and how motors move where they are.

use super::Words;
use crate::bug::bug;
use crate::digits::significant;
use crate::repair::Offers;
use crate::structure::RequirementTrouble;

impl Words<'_> {
    /// Why rates or forces of a requirement cannot be measured.
    pub(super) fn no_effort(
        &self,
        written: &str,
        trouble: &RequirementTrouble,
        offers: &Offers,
    ) -> String {
        let not_proved = format!("it could not be proved that `{written}`");
        match trouble {
            RequirementTrouble::NoEffect { effects } => {
                let list = effects.iter().map(|effect| format!("`{effect}`"));
                let list: Vec<String> = list.collect();
                format!(
                    "`{written}` measures what nothing asks for: {} {} not declared{}",
                    list.join(" and "),
                    if list.len() == 1 { "is" } else { "are" },
                    self.help(offers)
                )
            }
            RequirementTrouble::NoForces => format!(
                "{not_proved}: joints of the mechanism are redundant, so the forces within it are not determined"
            ),
            RequirementTrouble::Together => format!(
                "{not_proved}: what is measured takes many linear equations that are solved together, for which there is no proof"
            ),
            RequirementTrouble::NoTimes { goes_on } => {
                let why = if *goes_on {
                    "what is measured goes on with every period of the laws"
                } else {
                    "it is not known after what time laws have everything where it was"
                };
                format!(
                    "{not_proved}: {why}\nhelp: say for which times it holds, as `for t in 0 ..= 2`"
                )
            }
            RequirementTrouble::Jumps { motor, at, is_rate } => {
                let name = &self.model.joint(self.model.motor(*motor).joint).name;
                let [what, lost] = if *is_rate {
                    ["the velocity of motor", "acceleration"]
                } else {
                    ["motor", "velocity"]
                };
                format!(
                    "{not_proved}: {what} `{name}` jumps at {}, or bounds cannot tell; it has no {lost} there\nhelp: choose a law that does not, as \
                     `rise ... over ... with cycloidal`, or other times",
                    time_value(*at)
                )
            }
            RequirementTrouble::Astray { at } => format!(
                "{not_proved}: laws lead the motors to where a loop does not close, at {}\nhelp: change a law, or say for which times it holds, as \
                 `for t in LOW ..= HIGH`",
                time_value(*at)
            ),
            RequirementTrouble::NoRate { motors } => {
                let names = motors.iter();
                let names =
                    names.map(|motor| &self.model.joint(self.model.motor(*motor).joint).name);
                let names: Vec<&str> = names.map(String::as_str).collect();
                format!(
                    "{not_proved}: rates are those where one motor moves at a rate of 1, and `{}` may\nhelp: say where all but one stand, as `at {} = \
                     VALUE`, or give motors laws of time",
                    names.join("`, `"),
                    names.last().unwrap_or(&"MOTOR")
                )
            }
            _ => bug!("a trouble of another kind is told as one of rates and forces"),
        }
    }

    /// The note how motors move and what acts, where rates or forces are measured.
    pub(super) fn circumstances(&self, number: usize) -> String {
        let requirement = &self.model.requirements[number];
        let (rates, forces) = (requirement.is_about_rates(), requirement.is_about_forces());
        let mut notes = Vec::new();
        if (rates || forces) && self.model.lawful_motors().next().is_some() {
            notes.push("motors move as fast as their laws say".to_owned());
        } else {
            if rates && let Ok(motor) = requirement.moving_motor(self.model) {
                let name = &self.model.joint(self.model.motor(motor).joint).name;
                notes.push(format!("motor `{name}` moves at a rate of 1"));
            }
            if forces {
                notes.push("forces are those at rest".to_owned());
            }
        }
        for (load, numbers) in self.model.actions.loads_with(&requirement.loads) {
            if numbers.iter().any(|number| *number != 0.0) {
                let text = match numbers {
                    [torque] => format!("`{} = {torque}`", load.name),
                    numbers => {
                        let numbers: Vec<String> = numbers.iter().map(f64::to_string).collect();
                        format!("`{} = ({})`", load.name, numbers.join(", "))
                    }
                };
                notes.push(format!("{text} acts"));
            }
        }
        if notes.is_empty() {
            return String::new();
        }
        format!("\nnote: {}", notes.join(", "))
    }
}

/// A time as one would write it in a text.
pub(super) fn time_value(time: f64) -> String {
    format!("`t = {}`", significant(time, 7, None))
}
