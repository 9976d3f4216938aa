//! The text of a mechanism that stays read while it changes.

use super::{Declaration, Document};
use crate::failure::Failure;
use crate::text::{Replacement, TokenPlaces};
use mech_compiler::catch;
use mech_compiler::model::Model;
use mech_compiler::syntax::{Edits, Rewriter, Source};
use std::ops::Range;

/// The text of a mechanism as tokens and as a tree, in which only those statements are read again that change.
pub(crate) struct TextTree {
    source: Source,
    places: TokenPlaces,
}

impl Document {
    /// The text of one of its mechanisms as a tree; none if it cannot be read statement by statement.
    pub(crate) fn tree(&self, declaration: &Declaration) -> Result<Option<TextTree>, Failure> {
        proc_macro2::extra::invalidate_current_thread_spans();
        let tokens = match self.text_of(declaration) {
            Ok(tokens) => tokens,
            // A part is not known.
            Err(_) => match self.tokens_of(declaration) {
                Ok(tokens) => tokens,
                Err(_) => return Ok(None),
            },
        };
        let source = catch(|| Source::read(tokens)).map_err(Failure::internal)?;
        let places = TokenPlaces::of(source.tokens());
        Ok(Some(TextTree { source, places }))
    }
}

impl TextTree {
    pub(crate) fn source(&self) -> &Source {
        &self.source
    }

    /// No change of it yet.
    pub(crate) fn rewriter(&self) -> Rewriter<'_> {
        Rewriter::new(self.source.tokens())
    }

    /// Where tokens stand in the file, in bytes.
    pub(crate) fn bytes(&self, tokens: &Range<usize>) -> Range<usize> {
        self.places.bytes(tokens)
    }

    /// Changes of it as replacements in the file, which has this text; in the order of their places.
    pub(crate) fn replacements(&self, text: &str, edits: &Edits) -> Vec<Replacement> {
        self.places.replacements(text, edits)
    }

    /// Reads the model after changes; none if the text is wrong then.
    pub(crate) fn model_with(&self, edits: &Edits) -> Result<Option<Model>, Failure> {
        catch(|| self.source.model_with(edits)).map_err(Failure::internal)
    }

    /// Reads the model after replacements; none if the text is wrong then, or if they begin or end within tokens.
    pub(crate) fn model_after(&self, edits: &[Replacement]) -> Result<Option<Model>, Failure> {
        match self.places.edits(edits) {
            Some(edits) => self.model_with(&edits),
            None => Ok(None),
        }
    }
}
