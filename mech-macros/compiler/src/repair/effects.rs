//! The effects that compute what a requirement measures.

use super::{Repair, edits};
use crate::model::Model;
use crate::syntax::Source;

/// Asks for these effects; nothing if the mechanism does not compile with them, as `compiles` tells.
pub(crate) fn add_effects(
    model: &Model,
    source: &Source,
    words: &[String],
    compiles: impl Fn(&Model) -> bool,
) -> Option<Repair> {
    let repair = Repair::AddEffects(words.to_vec());
    let edits = edits(std::slice::from_ref(&repair), model, source.tokens())?;
    let changed = source.model_with(&edits)?;
    compiles(&changed).then_some(repair)
}
