//! Repairs of a mechanism, as changes of its text.

mod near;
mod slip;

use crate::document::{Declaration, Document, Faults, Reading};
use crate::failure::Failure;
use crate::text::written;
use mech_compiler::repair::{self, Offers, Repair};
use mech_compiler::syntax::Edits;
use mech_compiler::{catch, reporter};

/// A repair that was tried, and compiles.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub struct Mending {
    /// A description of the change, in words.
    pub words: String,
    /// The work that remains after it, if any.
    pub remainder: Remainder,
    /// The whole text of the file after it.
    pub text: String,
}

/// The work that remains after a repair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub enum Remainder {
    /// Nothing, but at most to choose one of several assemblies.
    Nothing,
    /// With the start that is given it does not close: it has to start elsewhere.
    OtherStart,
    /// Other things are wrong, too.
    OtherFaults,
}

/// The repairs of a mechanism, the likeliest first; none if nothing is wrong with it.
///
/// # Errors
/// If the compiler itself fails, which is a mistake of ours.
pub fn mendings(
    document: &Document,
    declaration: &Declaration,
    reading: &Reading,
) -> Result<Vec<Mending>, Failure> {
    let Err(Faults { offers, diagnoses, messages }) = &reading.result else {
        return Ok(Vec::new());
    };
    if diagnoses.is_empty() {
        return slip::mendings_of_slips(document, declaration, messages, &reading.model);
    }
    let Some(tree) = document.tree(declaration)? else {
        return Ok(Vec::new());
    };
    let model = &reading.model;
    let mut found: Vec<Mending> = Vec::new();
    let mut add = |words: String, remainder, edits: Option<Edits>| {
        // Several faults may have the same cure.
        let is_known = found.iter().any(|known| known.words == words);
        let Some(edits) = edits.filter(|_| !is_known) else {
            return Ok(());
        };
        if tree.model_with(&edits)?.is_some() {
            let text = document.source().text();
            let text = written(text, &tree.replacements(text, &edits));
            found.push(Mending { words, remainder, text });
        }
        Ok::<(), Failure>(())
    };
    for (repairs, remainder) in offers.iter().flat_map(offered) {
        let words = catch(|| reporter::repair_text(&repairs, model)).map_err(Failure::internal)?;
        let edits = repair::edits(&repairs, model, tree.source().tokens());
        add(words, remainder, edits)?;
    }
    // The choices of an assembly.
    for diagnosis in diagnoses {
        for [clauses, words] in reporter::assemblies(diagnosis, model) {
            let mut rewriter = tree.rewriter();
            let done = rewriter.add_to_start(&clauses);
            let edits = done.map(|()| rewriter.edits);
            add(words, Remainder::Nothing, edits)?;
        }
    }
    Ok(found)
}

/// Lists the offered repairs in the order of the messages; each entry holds the repairs that are made together.
fn offered(offers: &Offers) -> Vec<(Vec<Repair>, Remainder)> {
    let single = offers.single.iter().map(|repair| vec![repair.clone()]);
    let coupled = offers.coupled.iter();
    let coupled = coupled.map(|repair| vec![repair.clone(), Repair::AllowCoupled]);
    let pairs = offers.pairs.iter().map(|pair| pair.to_vec());
    let enough = single.chain(coupled).chain(pairs);
    let alone = |repairs: &[Repair], remainder| {
        let repairs = repairs.iter().cloned();
        let repairs = repairs.map(|repair| (vec![repair], remainder));
        repairs.collect::<Vec<_>>()
    };
    enough
        .map(|repairs| (repairs, Remainder::Nothing))
        .chain(alone(&offers.elsewhere, Remainder::OtherStart))
        .chain(alone(&offers.partial, Remainder::OtherFaults))
        .collect()
}
