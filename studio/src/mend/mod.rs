//! Repairs of a mechanism, as changes of its text.

mod likeness;
mod rewrite;

use crate::document::{Declaration, Document, Faults, Reading, Source};
use crate::failure::Failure;
pub(crate) use likeness::are_alike;
use mech_compiler::catch;
use mech_compiler::model::{LinkId, Model, Near, Origin};
use mech_compiler::repair::{Offers, Repair, apply_all};
use mech_compiler::reporter;
use mech_compiler::structure::Diagnosis;
pub(crate) use rewrite::Rewriter;
use rewrite::{rewrite, rewrite_start};
use std::fmt::Display;
use std::ops::Range;

/// A repair that was tried, and compiles.
#[derive(Clone, Debug, PartialEq)]
pub struct Mending {
    /// What it changes, in words.
    pub words: String,
    /// What is left to do after it, if anything is.
    pub remainder: Remainder,
    /// The whole text of the file after it; none if it cannot be written as a change of the text, as within a part.
    pub text: Option<String>,
    /// The mechanism that it promises.
    pub promised: Model,
}

impl Mending {
    /// The whole text of the file after it, which has this number.
    pub(crate) fn text_of(&self, number: impl Display) -> Result<&str, Failure> {
        self.text.as_deref().ok_or_else(|| {
            Failure::mechanism(format!(
                "repair {number} cannot be made by a change of the text alone: {}",
                self.words
            ))
        })
    }
}

/// What is left to do after a repair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remainder {
    /// Nothing, but at most to choose one of several assemblies.
    Nothing,
    /// With the start that is given it does not close: it has to start elsewhere.
    OtherStart,
    /// Other things are wrong, too.
    OtherFaults,
}

/// The repairs of a mechanism, the likeliest first; none if nothing is wrong with it, or if its text cannot be read.
///
/// Each is written as a change of the text, which is read again: it has to declare what the repair promises.
///
/// # Errors
/// If the compiler itself fails, which is a mistake of ours.
pub fn mendings(
    document: &Document,
    declaration: &Declaration,
    reading: &Reading,
) -> Result<Vec<Mending>, Failure> {
    let Err(Faults {
        offers, diagnoses, ..
    }) = &reading.result
    else {
        return Ok(Vec::new());
    };
    let repairs = offers.iter().flat_map(repairs);
    let starts = diagnoses
        .iter()
        .flat_map(|diagnosis| starts(diagnosis, &reading.model));
    let mut found: Vec<Mending> = Vec::new();
    for candidate in repairs.chain(starts) {
        let Some(promised) = candidate.promised(&reading.model) else {
            continue;
        };
        let mending = Mending {
            words: candidate.words(&reading.model)?,
            remainder: candidate.remainder(),
            text: text(
                document,
                declaration,
                &reading.model,
                (&candidate, &promised),
            )?,
            promised,
        };
        // Several faults may have the same cure.
        if !found.iter().any(|known| known.words == mending.words) {
            found.push(mending);
        }
    }
    Ok(found)
}

/// What may be done.
enum Candidate {
    /// Repairs that are made together.
    Repairs(Vec<Repair>, Remainder),
    /// A choice of one of several assemblies.
    Start {
        /// Clauses of `start`: `coupler near 30 deg;`.
        clauses: String,
        words: String,
    },
}

impl Candidate {
    /// The mechanism after it.
    fn promised(&self, model: &Model) -> Option<Model> {
        match self {
            Self::Repairs(repairs, _) => apply_all(repairs, model),
            Self::Start { clauses, .. } => {
                let mut model = model.clone();
                for clause in clauses.split_terminator(';') {
                    let (link, angle) = clause.trim().split_once(" near ")?;
                    let degrees: f64 = angle.strip_suffix(" deg")?.parse().ok()?;
                    let is_it = |id: &LinkId| model.link(*id).name == link;
                    let near = Near {
                        link: model.declared_links().find(is_it)?,
                        angle: degrees.to_radians(),
                        origin: Origin::default(),
                    };
                    model.start.near.push(near);
                }
                Some(model)
            }
        }
    }

    fn words(&self, model: &Model) -> Result<String, Failure> {
        match self {
            Self::Repairs(repairs, _) => {
                catch(|| reporter::repair_text(repairs, model)).map_err(Failure::internal)
            }
            Self::Start { words, .. } => Ok(words.clone()),
        }
    }

    fn remainder(&self) -> Remainder {
        match self {
            Self::Repairs(_, remainder) => *remainder,
            Self::Start { .. } => Remainder::Nothing,
        }
    }

    fn rewrite(&self, text: &str, body: &Range<usize>, model: &Model) -> Option<String> {
        match self {
            Self::Repairs(repairs, _) => rewrite(text, body, model, repairs),
            Self::Start { clauses, .. } => rewrite_start(text, body, model, clauses),
        }
    }
}

/// The choices of an assembly.
fn starts(diagnosis: &Diagnosis, model: &Model) -> Vec<Candidate> {
    let assemblies = reporter::assemblies(diagnosis, model).into_iter();
    assemblies
        .map(|[clauses, words]| Candidate::Start { clauses, words })
        .collect()
}

/// What is offered, in the order of the messages.
fn repairs(offers: &Offers) -> Vec<Candidate> {
    let single = offers.single.iter().map(|repair| vec![repair.clone()]);
    let coupled = offers.coupled.iter();
    let coupled = coupled.map(|repair| vec![repair.clone(), Repair::AllowCoupled]);
    let pairs = offers.pairs.iter().map(|pair| pair.to_vec());
    let enough = single.chain(coupled).chain(pairs);
    let alone = |repairs: &[Repair], remainder| {
        let repairs = repairs.iter().cloned();
        let repairs = repairs.map(|repair| Candidate::Repairs(vec![repair], remainder));
        repairs.collect::<Vec<_>>()
    };
    let enough = enough.map(|repairs| Candidate::Repairs(repairs, Remainder::Nothing));
    enough
        .chain(alone(&offers.elsewhere, Remainder::OtherStart))
        .chain(alone(&offers.partial, Remainder::OtherFaults))
        .collect()
}

/// The text after a change, if it declares what that promises.
fn text(
    document: &Document,
    declaration: &Declaration,
    model: &Model,
    (candidate, promised): (&Candidate, &Model),
) -> Result<Option<String>, Failure> {
    let source = document.source();
    let Some(body) = &declaration.body else {
        return Ok(None);
    };
    let Some(text) = candidate.rewrite(source.text(), body, model) else {
        return Ok(None);
    };
    let changed = Document::of(Source::new(source.path(), text));
    let index = document.index_of(declaration)?;
    let found = match changed.declarations().get(index) {
        Some(found) => changed.model(found)?,
        None => None,
    };
    let is_kept = found.is_some_and(|found| are_alike(&found, promised));
    Ok(is_kept.then(|| changed.source().text().to_owned()))
}
