//! Where the tokens of a text stand in it.

use super::{Draft, Replacement};
use mech_compiler::syntax::{Edit, Edits, Tokens};
use std::ops::Range;

/// Where each token of a text stands in it, in bytes.
#[derive(Clone, Debug)]
pub(crate) struct TokenPlaces(Vec<Range<usize>>);

impl TokenPlaces {
    /// The places of tokens that were read from a text just now: those of the text before are forgotten by then.
    pub(crate) fn of(tokens: &Tokens) -> Self {
        Self(tokens.places().map(|place| place.start.byte_range()).collect())
    }

    /// From the beginning of the first of some tokens to the end of the last.
    pub(crate) fn bytes(&self, tokens: &Range<usize>) -> Range<usize> {
        match &self.0[tokens.clone()] {
            [first, .., last] => first.start..last.end,
            [only] => only.clone(),
            [] => 0..0,
        }
    }

    /// The tokens that fill a range; none if it begins or ends elsewhere.
    fn tokens(&self, bytes: &Range<usize>) -> Option<Range<usize>> {
        let first = self.0.iter().position(|place| place.start == bytes.start)?;
        let count = self.0[first..].iter().position(|place| place.end == bytes.end)?;
        Some(first..first + count + 1)
    }

    /// Replacements as changes of tokens; none if one of them begins or ends within a token.
    pub(crate) fn edits(&self, replacements: &[Replacement]) -> Option<Edits> {
        let mut edits = Edits::default();
        for Replacement { range, text } in replacements {
            edits.replace(self.tokens(range)?, text.clone());
        }
        Some(edits)
    }

    /// Changes of tokens as replacements in the text, in the order of their places.
    pub(crate) fn replacements(&self, text: &str, edits: &Edits) -> Vec<Replacement> {
        let mut draft = Draft::new(text);
        for edit in edits.iter() {
            match edit {
                Edit::Replace(tokens, by) => draft.replace(self.bytes(tokens), by),
                Edit::Before(token, by) => draft.insert(self.0[*token].start, by),
                Edit::After(token, by) => draft.insert(self.0[*token].end, by),
                Edit::Remove(tokens) => draft.remove(&self.bytes(tokens)),
                Edit::Add(after, by) => draft.insert_after(&self.bytes(after), by),
            }
        }
        draft.edits()
    }
}
