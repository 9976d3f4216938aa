//! Repairs of a mechanism, as changes of its text.

mod draft;
mod likeness;
mod rewrite;
mod statement;

use crate::document::{Declaration, Document, Faults, Reading, Source};
use crate::failure::Failure;
use likeness::are_alike;
use mech_compiler::catch;
use mech_compiler::model::Model;
use mech_compiler::repair::{Offers, Repair, apply_all};
use mech_compiler::reporter;
use rewrite::rewrite;

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

/// What is left to do after a repair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remainder {
    /// Nothing, but at most to choose one of several assemblies.
    Nothing,
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
    let Err(Faults { offers, .. }) = &reading.result else {
        return Ok(Vec::new());
    };
    let mut found: Vec<Mending> = Vec::new();
    for (repairs, remainder) in offers.iter().flat_map(candidates) {
        let Some(promised) = apply_all(&repairs, &reading.model) else {
            continue;
        };
        let words = catch(|| reporter::repair_text(&repairs, &reading.model));
        let mending = Mending {
            words: words.map_err(|what| Failure::internal(format!("internal error: {what}")))?,
            remainder,
            text: text(document, declaration, &reading.model, (&repairs, &promised))?,
            promised,
        };
        // Several faults may have the same cure.
        if !found.iter().any(|known| known.words == mending.words) {
            found.push(mending);
        }
    }
    Ok(found)
}

/// What is offered, in the order of the messages.
fn candidates(offers: &Offers) -> Vec<(Vec<Repair>, Remainder)> {
    let single = offers.single.iter().map(|repair| vec![repair.clone()]);
    let coupled = offers.coupled.iter();
    let coupled = coupled.map(|repair| vec![repair.clone(), Repair::AllowCoupled]);
    let pairs = offers.pairs.iter().map(|pair| pair.to_vec());
    let enough = single.chain(coupled).chain(pairs);
    let partial = offers.partial.iter().map(|repair| vec![repair.clone()]);
    let enough = enough.map(|repairs| (repairs, Remainder::Nothing));
    enough
        .chain(partial.map(|repairs| (repairs, Remainder::OtherFaults)))
        .collect()
}

/// The text after repairs, if it declares what they promise.
fn text(
    document: &Document,
    declaration: &Declaration,
    model: &Model,
    (repairs, promised): (&[Repair], &Model),
) -> Result<Option<String>, Failure> {
    let source = document.source();
    let Some(body) = &declaration.body else {
        return Ok(None);
    };
    let Some(text) = rewrite(source.text(), body, model, repairs) else {
        return Ok(None);
    };
    let changed = Document::of(Source::new(source.path(), text));
    let index = document
        .declarations()
        .iter()
        .position(|one| one == declaration);
    let found = index.and_then(|index| changed.declarations().get(index));
    let found = match found {
        Some(found) => changed.model(found)?,
        None => None,
    };
    let is_kept = found.is_some_and(|found| are_alike(&found, promised));
    Ok(is_kept.then(|| changed.source().text().to_owned()))
}
