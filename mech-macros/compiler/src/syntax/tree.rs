//! A text that stays read while numbers in it change.

use super::ast::{Statement, Text};
use super::lower::lower;
use super::{Place, grammar};
use crate::model::Model;
use proc_macro2::TokenStream;
use std::collections::BTreeMap;

/// The text of a mechanism as a tree, in which single statements can be read anew: that takes a fraction of the time for the whole text.
pub struct SyntaxTree(Text);

impl SyntaxTree {
    /// Reads the body of a `mechanism!`.
    #[must_use]
    pub fn read(input: TokenStream) -> Self {
        Self(grammar::read(input))
    }

    /// Where the statements begin that can be replaced, with their numbers, in the order of the text. A statement reaches to the next one.
    pub fn beginnings(&self) -> impl Iterator<Item = (usize, Place)> {
        let beginnings = self.0.beginnings.iter();
        beginnings.map(|(number, begin)| (*number, Place::at(*begin)))
    }

    /// What the text says with other statements at these numbers: none if it is wrong, or if one of them is not one statement. The
    /// tree stays as it was.
    pub fn model_with(&mut self, changes: BTreeMap<usize, TokenStream>) -> Option<Model> {
        let read = |(number, tokens)| {
            (number < self.0.statements.len()).then_some(())?;
            Some((number, grammar::read_statement(tokens)?))
        };
        let mut others = changes.into_iter().map(read).collect::<Option<Vec<_>>>()?;
        self.exchange(&mut others);
        let lowered = lower(&mut self.0);
        self.exchange(&mut others);
        let is_right = lowered.errors.is_empty() && self.0.header.is_some();
        is_right.then_some(lowered.model)
    }

    fn exchange(&mut self, others: &mut [(usize, Statement)]) {
        for (number, other) in others {
            std::mem::swap(&mut self.0.statements[*number], other);
        }
    }
}
