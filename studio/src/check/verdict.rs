//! The verdict on each mechanism of a document.

use crate::document::{Declaration, Document, Message, Reading};
use crate::failure::Failure;
use crate::mend::{Mending, mendings};
use mech_compiler::Compiled;
use mech_compiler::model::Model;
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
    },
}

/// Judges the mechanism of this name; without a name, all mechanisms and the parts for other files. Looks for repairs if
/// `are_repairs_asked`.
pub(crate) fn verdicts(
    document: &Document,
    name: Option<&str>,
    are_repairs_asked: bool,
) -> Result<Vec<Verdict>, Failure> {
    let verdict = |declaration| verdict(document, declaration, are_repairs_asked);
    if name.is_some() {
        return Ok(vec![verdict(document.choose(name)?)?]);
    }
    let mechanisms = document.declarations().iter().map(verdict);
    let mut verdicts = mechanisms.collect::<Result<Vec<_>, _>>()?;
    let messages = document.faults_of_parts()?;
    if !messages.is_empty() {
        verdicts.push(Verdict::Faulty {
            name: None,
            place: 0..document.source().text().len(),
            messages,
            repairs: Vec::new(),
        });
    }
    Ok(verdicts)
}

fn verdict(
    document: &Document,
    declaration: &Declaration,
    are_repairs_asked: bool,
) -> Result<Verdict, Failure> {
    let reading = document.check(declaration)?;
    let repairs = if are_repairs_asked {
        mendings(document, declaration, &reading)?
    } else {
        Vec::new()
    };
    let Reading { model, result, .. } = reading;
    let place = declaration.whole.clone();
    Ok(match result {
        Ok(compiled) => Verdict::Moves {
            line: verdict_line(&model, &compiled),
            name: model.name,
            place,
            notes: compiled.notes,
        },
        Err(faults) => Verdict::Faulty {
            name: declaration.name.clone(),
            place,
            messages: faults.messages,
            repairs,
        },
    })
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
