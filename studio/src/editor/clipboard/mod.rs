//! Copy and paste.

mod copies;
mod fragment;
mod pasting;
pub(super) use copies::gesture_of_copies;
pub(super) use pasting::pasted;

use crate::edit::Workspace;
use crate::text::TokenPlaces;
use mech_compiler::syntax::{StatementText, Tokens};
use std::collections::BTreeSet;
use std::ops::Range;

#[derive(Default)]
pub(super) struct Clipboard {
    pub(super) copied: String,
    pub(super) next: Option<String>,
}

impl Clipboard {
    /// Notes links as statements, with what is between them. Tells what was copied, or why nothing was.
    pub(super) fn copy(
        &mut self,
        links: &BTreeSet<String>,
        workspace: &Workspace,
    ) -> Result<String, String> {
        let found = fragment::copied(&workspace.document(), workspace.index(), links);
        let copied = found
            .map_err(|failure| failure.to_string())?
            .ok_or("links are copied; select one that is declared here")?;
        self.next = Some(copied.clone());
        self.copied = copied;
        Ok(match links.len() {
            1 => "copied a link".to_owned(),
            count => format!("copied {count} links"),
        })
    }

    /// Returns the text to paste: this one, or the copied statements if it is empty. None if it cannot be pasted.
    pub(super) fn to_paste(&self, text: &str) -> Option<String> {
        let text = if text.is_empty() { &self.copied } else { text };
        pasting::can_be_pasted(text).then(|| text.to_owned())
    }
}

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
        Some(Self { text, tokens, places })
    }

    pub(super) fn statements(&self) -> Vec<StatementText<'_>> {
        self.tokens.statements()
    }

    /// Where tokens stand in the text, in bytes.
    pub(super) fn bytes(&self, tokens: &Range<usize>) -> Range<usize> {
        self.places.bytes(tokens)
    }

    pub(super) fn text_of(&self, statement: &StatementText<'_>) -> &'t str {
        &self.text[self.places.bytes(&statement.range())]
    }
}
