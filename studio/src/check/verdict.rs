//! The verdict on each mechanism of a document.

use crate::document::{Declaration, Document, Message, Reading};
use crate::failure::Failure;
use crate::mend::{Mending, mendings};
use crate::motion::shown;
use crate::report::ranges;
use mech_compiler::Compiled;
use mech_compiler::limits::Limit;
use mech_compiler::model::{Condition, Model};
use mech_compiler::structure::Diagnosis;
use std::ops::Range;

/// The verdict on a mechanism, or on the parts of a document.
pub(crate) enum Verdict {
    /// It moves.
    Moves {
        /// Its name.
        name: String,
        /// Where it stands, in bytes.
        place: Range<usize>,
        /// This in one line.
        line: String,
        /// How far each motor goes: `` `a` turns right round``.
        motors: Vec<String>,
        /// Notes on its motion that are worth knowing.
        notes: Vec<String>,
    },
    /// Something is wrong.
    Faulty {
        /// The name of the mechanism; none of parts, and where the name cannot be read.
        name: Option<String>,
        /// Where it stands, in bytes.
        place: Range<usize>,
        /// The faults.
        messages: Vec<Message>,
        /// The repairs, if the user asked for them.
        repairs: Vec<Mending>,
        /// The places where it breaks what is expected of it.
        witnesses: Vec<Witness>,
    },
}

/// Judges the mechanism of this name; without a name, all mechanisms and the parts for other files. Looks for repairs if
/// `are_repairs_asked`.
pub(crate) fn verdicts(
    document: &Document,
    name: Option<&str>,
    are_repairs_asked: bool,
) -> Result<Vec<Verdict>, Failure> {
    let chosen = match name {
        Some(_) => vec![document.choose(name)?],
        None => document.declarations().iter().collect(),
    };
    let mut verdicts = Vec::new();
    let mut links = 0;
    for declaration in chosen {
        if links > Limit::Links.most() {
            verdicts.push(unchecked(declaration));
            break;
        }
        let reading = document.check(declaration)?;
        // The ground is among them, so that nothing counts for none.
        links += reading.model.links.len().max(1);
        verdicts.push(verdict(document, declaration, reading, are_repairs_asked)?);
    }
    if name.is_some() {
        return Ok(verdicts);
    }
    let messages = document.faults_of_parts()?;
    if !messages.is_empty() {
        verdicts.push(Verdict::Faulty {
            name: None,
            place: 0..document.source().text().len(),
            messages,
            repairs: Vec::new(),
            witnesses: Vec::new(),
        });
    }
    Ok(verdicts)
}

/// The verdict on a mechanism that is not looked at, as too many are before it.
fn unchecked(declaration: &Declaration) -> Verdict {
    let most = Limit::Links.most();
    let text = format!(
        "this mechanism, and what follows it, is not checked\n\nnote: the mechanisms before have more than {most} links together, which is the limit of one run\n\nhelp: name a mechanism with `--mechanism`"
    );
    Verdict::Faulty {
        name: declaration.name.clone(),
        place: declaration.whole.clone(),
        messages: vec![Message { place: declaration.whole.clone(), text }],
        repairs: Vec::new(),
        witnesses: Vec::new(),
    }
}

fn verdict(
    document: &Document,
    declaration: &Declaration,
    reading: Reading,
    are_repairs_asked: bool,
) -> Result<Verdict, Failure> {
    let repairs =
        if are_repairs_asked { mendings(document, declaration, &reading)? } else { Vec::new() };
    let Reading { model, result, .. } = reading;
    let place = declaration.whole.clone();
    Ok(match result {
        Ok(compiled) => Verdict::Moves {
            line: verdict_line(&model, &compiled),
            motors: ranges(&model, &compiled)?,
            name: model.name,
            place,
            notes: compiled.notes,
        },
        Err(faults) => Verdict::Faulty {
            name: declaration.name.clone(),
            place,
            witnesses: witnesses(&model, &faults.diagnoses),
            messages: faults.messages,
            repairs,
        },
    })
}

/// A place where a mechanism breaks what is expected of it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Witness {
    /// The condition as it was written.
    pub(crate) expect: String,
    /// The motors by the names of their joints, with their values as `--at` takes them: in degrees if they turn.
    pub(crate) at: Vec<(String, f64)>,
    /// When it comes there, if motors follow laws.
    pub(crate) time: Option<f64>,
    /// The value of what is measured there: in degrees if it is an angle.
    pub(crate) value: f64,
}

fn witnesses(model: &Model, diagnoses: &[Diagnosis]) -> Vec<Witness> {
    let mut all = Vec::new();
    for (requirement, found) in diagnoses.iter().filter_map(Diagnosis::witness) {
        let requirement = &model.requirements[requirement];
        let is_angle = matches!(requirement.condition, Condition::Bounds { is_angle: true, .. });
        let value = if is_angle { found.value.to_degrees() } else { found.value };
        for place in &found.places {
            let at = place.motors.iter().map(|(motor, value)| {
                let joint = model.motor(*motor).joint;
                (model.joint(joint).name.clone(), shown(model, joint, *value))
            });
            all.push(Witness {
                expect: requirement.written.clone(),
                at: at.collect(),
                time: place.time,
                value,
            });
        }
    }
    all
}

/// `FourBar moves: 3 moving links, 4 joints, 1 motor, 1 loop`.
pub(crate) fn verdict_line(model: &Model, compiled: &Compiled) -> String {
    let loops = compiled.plan.loops().count();
    let counts = [
        counted(model.declared_links().count(), "moving link"),
        counted(model.declared_joints().count(), "joint"),
        counted(model.motors.len(), "motor"),
        counted(loops, "loop"),
    ];
    format!("{} moves: {}", model.name, counts.join(", "))
}

fn counted(count: usize, what: &str) -> String {
    let ending = if count == 1 { "" } else { "s" };
    format!("{count} {what}{ending}")
}
