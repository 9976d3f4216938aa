//! The text of a mechanism that stays read while numbers in it change.

use super::reading::{range_of, tokens_of};
use super::{Declaration, Document};
use crate::failure::Failure;
use crate::text::{Replacement, written};
use mech_compiler::model::Model;
use mech_compiler::syntax::SyntaxTree;
use mech_compiler::{Import, catch};
use proc_macro2::TokenStream;
use std::collections::BTreeMap;
use std::ops::Range;

/// The text of a mechanism as a tree, in which only those statements are read again that change.
pub(crate) struct TextTree {
    tree: SyntaxTree,
    /// In the order of the text, and without gaps between them.
    statements: Vec<Stretch>,
}

/// A statement in the file, with what stands between it and the next one.
struct Stretch {
    number: usize,
    range: Range<usize>,
}

impl TextTree {
    /// Reads a mechanism; none if its text takes parts from elsewhere, or is no text of Rust.
    pub(super) fn read(
        document: &Document,
        declaration: &Declaration,
    ) -> Result<Option<Self>, Failure> {
        proc_macro2::extra::invalidate_current_thread_spans();
        let (Ok(tokens), Some(body)) = (tokens_of(document, declaration), &declaration.body) else {
            return Ok(None);
        };
        if Import::first(&tokens).is_some() {
            return Ok(None);
        }
        let tree = catch(|| SyntaxTree::read(tokens)).map_err(Failure::internal)?;
        let starts = tree.beginnings();
        let starts: Vec<(usize, usize)> = starts
            .map(|(number, place)| (number, range_of(place, &declaration.whole).start))
            .collect();
        let ends = starts.iter().skip(1).map(|(_, start)| *start);
        let ends = ends.chain([body.end]);
        let statements = starts
            .iter()
            .zip(ends)
            .map(|(&(number, start), end)| Stretch {
                number,
                range: start..end,
            });
        Ok(Some(Self {
            statements: statements.collect(),
            tree,
        }))
    }

    /// What the text says after changes that stand in the order of their places; none if that cannot be found out statement by statement.
    pub(crate) fn model_with(
        &mut self,
        text: &str,
        edits: &[Replacement],
    ) -> Result<Option<Model>, Failure> {
        let Some(changes) = self.changes(text, edits) else {
            return Ok(None);
        };
        catch(|| self.tree.model_with(changes)).map_err(Failure::internal)
    }

    /// The tokens of each statement that changes.
    fn changes(&self, text: &str, edits: &[Replacement]) -> Option<BTreeMap<usize, TokenStream>> {
        let mut changes = BTreeMap::new();
        let mut edits = edits;
        while let Some(first) = edits.first() {
            let stretch = self.stretch_of(&first.range)?;
            let is_within = |edit: &&Replacement| edit.range.end <= stretch.range.end;
            let count = edits.iter().take_while(is_within).count();
            let (inside, others) = edits.split_at(count);
            let before = stretch.range.start;
            let moved = inside.iter().map(|edit| Replacement {
                range: edit.range.start - before..edit.range.end - before,
                text: edit.text.clone(),
            });
            let moved: Vec<Replacement> = moved.collect();
            let statement = written(&text[stretch.range.clone()], &moved);
            changes.insert(stretch.number, statement.parse().ok()?);
            edits = others;
        }
        Some(changes)
    }

    /// The statement in which all of a range stands.
    fn stretch_of(&self, range: &Range<usize>) -> Option<&Stretch> {
        let after = self
            .statements
            .partition_point(|one| one.range.start <= range.start);
        let stretch = self.statements.get(after.checked_sub(1)?)?;
        (range.end <= stretch.range.end).then_some(stretch)
    }
}
