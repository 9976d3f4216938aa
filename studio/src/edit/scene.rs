//! A mechanism in its file, for commands to work on.

use super::Refusal;
use crate::document::{Declaration, Document, Listing, Reading, Source, TextTree};
use crate::text::{Replacement, written};
use mech_compiler::model::Model;
use mech_compiler::syntax::Rewriter;
use std::cell::OnceCell;
use std::sync::Arc;

/// A mechanism in its file whose text is right, and what the compiler makes of it: what is known is not found out again.
#[derive(Clone, Copy)]
pub struct Known<'k> {
    /// The file.
    pub document: &'k Document,
    /// The number of the mechanism in the file.
    pub index: usize,
    /// The result of [`Document::analyse`].
    pub reading: &'k Arc<Reading>,
    /// The result of [`Document::listing`].
    pub listing: &'k Listing,
}

pub(super) struct Scene {
    pub(super) document: Document,
    pub(super) declaration: Declaration,
    /// The number of the mechanism in the file.
    pub(super) index: usize,
    /// The model of the text; of a wrong text, as much as could be understood.
    pub(super) model: Model,
    pub(super) is_readable: bool,
    pub(super) listing: Listing,
    /// The compiler's reading of the text, once it is needed.
    reading: OnceCell<Arc<Reading>>,
    /// The text as a tree, once somebody changes it; none if it is no text of Rust.
    tree: OnceCell<Option<TextTree>>,
}

impl Scene {
    /// The mechanism with this number in a file.
    pub(super) fn open(document: &Document, index: usize) -> Result<Self, Refusal> {
        let declaration = declaration_of(document, index)?.clone();
        let listing = document.listing(&declaration)?.unwrap_or_default();
        let reading = OnceCell::new();
        let model = document.model(&declaration)?;
        let is_readable = model.is_some();
        let model = if let Some(model) = model {
            model
        } else {
            let partial = document.analyse(&declaration)?;
            reading.get_or_init(|| Arc::new(partial)).model.clone()
        };
        Ok(Self {
            document: document.clone(),
            declaration,
            index,
            model,
            is_readable,
            listing,
            reading,
            tree: OnceCell::new(),
        })
    }

    /// The mechanism with this number in a file whose text could be read, and was.
    pub(super) fn of(known: Known<'_>) -> Result<Self, Refusal> {
        Ok(Self {
            document: known.document.clone(),
            declaration: declaration_of(known.document, known.index)?.clone(),
            index: known.index,
            model: known.reading.model.clone(),
            is_readable: true,
            listing: known.listing.clone(),
            reading: known.reading.clone().into(),
            tree: OnceCell::new(),
        })
    }

    pub(super) fn text(&self) -> &str {
        self.document.source().text()
    }

    /// Returns the compiler's reading of the text before the command.
    pub(super) fn reading(&self) -> Result<&Reading, Refusal> {
        if let Some(reading) = self.reading.get() {
            return Ok(reading);
        }
        let reading = self.document.analyse(&self.declaration)?;
        Ok(self.reading.get_or_init(|| Arc::new(reading)))
    }

    pub(super) fn rewriter(&self) -> Result<Rewriter<'_>, Refusal> {
        Ok(self.tree()?.rewriter())
    }

    /// Reads the model after changes in the order of their places; none if the text cannot be read.
    pub(super) fn model_after(&self, edits: &[Replacement]) -> Result<Option<Model>, Refusal> {
        if let Ok(tree) = self.tree()
            && let Some(model) = tree.model_after(edits)?
        {
            return Ok(Some(model));
        }
        let document = self.document_after(edits);
        match document.declarations().get(self.index) {
            Some(declaration) => Ok(document.model(declaration)?),
            None => Ok(None),
        }
    }

    pub(super) fn tree(&self) -> Result<&TextTree, Refusal> {
        if self.tree.get().is_none() {
            let tree = self.document.tree(&self.declaration)?;
            self.tree.get_or_init(|| tree);
        }
        let tree = self.tree.get().and_then(Option::as_ref);
        tree.ok_or_else(|| {
            Refusal::of("a quote or a bracket of the mechanism is without its partner")
        })
    }

    pub(super) fn document_after(&self, edits: &[Replacement]) -> Document {
        let source = self.document.source();
        Document::of(Source::new(source.path(), written(self.text(), edits)))
    }
}

/// The mechanism with this number in a file.
pub(super) fn declaration_of(document: &Document, index: usize) -> Result<&Declaration, Refusal> {
    let declaration = document.declarations().get(index);
    declaration.ok_or_else(|| Refusal::of("there is no mechanism yet; begin with `mechanism NAME`"))
}
