//! What is expected of a mechanism, and whether it was proved.

use crate::failure::Failure;
use mech_compiler::model::Model;
use mech_compiler::requirement::{Proof, judge};
use mech_compiler::structure::Diagnosis;
use mech_compiler::{Compiled, catch, reporter};

/// A requirement, and what was found out about it.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Judged {
    /// The condition as it was written.
    pub(crate) written: String,
    /// How it was proved, or what is wrong with it, in words.
    pub(crate) text: String,
    /// Whether it was proved.
    pub(crate) is_met: bool,
    /// The places where it does not hold: motors, by their numbers, with their values in radians or scene units.
    pub(crate) places: Vec<Vec<(usize, f64)>>,
    /// The values of a motor, by its number, for which it does not hold while other motors stand at one of these places, as far as samples
    /// show.
    pub(crate) intervals: Vec<(usize, [f64; 2])>,
}

#[cfg(feature = "editor")]
impl Judged {
    /// The values of the motor of this number for which it does not hold.
    pub(crate) fn failing(&self, motor: usize) -> impl Iterator<Item = [f64; 2]> {
        let own = self.intervals.iter();
        own.filter(move |(of, _)| *of == motor).map(|(_, ends)| *ends)
    }
}

/// Judges what is expected of a mechanism.
pub(super) fn judged(model: &Model, compiled: &Compiled) -> Result<Vec<Judged>, Failure> {
    let judged = catch(|| judge(model, compiled)).map_err(Failure::internal)?;
    let requirements = model.requirements.iter().zip(judged);
    let judged = requirements.map(|(requirement, judged)| Judged {
        written: requirement.written.clone(),
        is_met: judged.is_ok(),
        text: match &judged {
            Ok(Proof { effort: 0 }) => "proved".to_owned(),
            Ok(Proof { effort }) => format!("proved, by {effort} intervals"),
            Err(unmet) => reporter::text(unmet, model),
        },
        places: judged.err().as_ref().map_or(Vec::new(), places),
        intervals: Vec::new(),
    });
    Ok(judged.collect())
}

/// Each requirement, as a line of a report: a label and a text.
pub(super) fn lines(judged: &[Judged]) -> Vec<(String, String)> {
    let lines = judged.iter().map(|one| {
        let text = one.text.lines().next().unwrap_or_default();
        let text = if one.is_met { format!("`{}`: {text}", one.written) } else { text.to_owned() };
        ("expects".to_owned(), text)
    });
    lines.collect()
}

fn places(unmet: &Diagnosis) -> Vec<Vec<(usize, f64)>> {
    let places = unmet.witness().into_iter();
    let places = places.flat_map(|(_, witness)| &witness.places);
    let numbered = places.map(|place| {
        let motors = place.motors.iter();
        motors.map(|(motor, value)| (motor.index(), *value)).collect()
    });
    numbered.collect()
}
