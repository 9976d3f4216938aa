//! Texts that are copied and pasted, as their tokens.

use crate::text::TokenPlaces;
use mech_compiler::syntax::{StatementText, Tokens};
use std::ops::Range;

/// A text as its tokens, each with its place.
pub(super) struct Lexed<'t> {
    text: &'t str,
    tokens: Tokens,
    places: TokenPlaces,
}

impl<'t> Lexed<'t> {
    /// Reads a text; none if a quote or a bracket in it is without its partner.
    pub(super) fn read(text: &'t str) -> Option<Self> {
        proc_macro2::extra::invalidate_current_thread_spans();
        let tokens = Tokens::read(text).ok()?;
        let places = TokenPlaces::of(&tokens);
        Some(Self {
            text,
            tokens,
            places,
        })
    }

    pub(super) fn statements(&self) -> Vec<StatementText<'_>> {
        self.tokens.statements()
    }

    /// Where tokens stand in the text, in bytes.
    pub(super) fn bytes(&self, tokens: &Range<usize>) -> Range<usize> {
        self.places.bytes(tokens)
    }

    /// A statement as it stands in the text.
    pub(super) fn text_of(&self, statement: &StatementText<'_>) -> &'t str {
        &self.text[self.places.bytes(&statement.range())]
    }
}
