//! The text of a mechanism as it is asked and changed: its tokens, and the tree that was read from them.

mod edit;
mod rewriter;
mod statement;
mod token;

pub use edit::{Edit, Edits};
pub use rewriter::Rewriter;
pub use statement::StatementText;

use super::ast::{Statement, Text};
use super::lower::{Lowered, lower};
use super::{Place, grammar};
use crate::model::Model;
use proc_macro2::{LexError, TokenStream};
use std::cell::{OnceCell, Ref, RefCell};
use std::ops::Range;
use token::Token;

/// The tokens of a text one after the other, brackets among them.
#[derive(Clone, Debug)]
pub struct Tokens {
    all: Vec<Token>,
    /// Where the statements are among them.
    statements: Vec<Range<usize>>,
}

impl Tokens {
    /// The tokens of a stream.
    #[must_use]
    pub fn of(stream: TokenStream) -> Self {
        Self::new(token::flat(stream))
    }

    /// The tokens of a text.
    ///
    /// # Errors
    /// If a quote or a bracket is without its partner.
    pub fn read(text: &str) -> Result<Self, LexError> {
        token::read(text).map(Self::new)
    }

    fn new(all: Vec<Token>) -> Self {
        let statements = statement::split(&all, 0..all.len());
        let statements = statements.iter().map(StatementText::range).collect();
        Self { all, statements }
    }

    /// The statements, the `struct` line among them.
    #[must_use]
    pub fn statements(&self) -> Vec<StatementText<'_>> {
        let ranges = self.statements.iter();
        ranges.map(|range| StatementText::new(&self.all, range.clone())).collect()
    }

    /// Where each token stands.
    pub fn places(&self) -> impl Iterator<Item = Place> {
        self.all.iter().map(|token| Place::at(token.span()))
    }

    /// The tokens of a statement with these changes in it, which stand in the order of their places.
    fn changed(&self, statement: &Range<usize>, changes: &[&Edit]) -> Option<Vec<Token>> {
        let mut tokens = Vec::new();
        let mut at = statement.start;
        for change in changes {
            let (range, by) = change.splice();
            if range.start < at || statement.end < range.end {
                return None;
            }
            tokens.extend_from_slice(&self.all[at..range.start]);
            tokens.extend(token::read(by).ok()?);
            at = range.end;
        }
        tokens.extend_from_slice(&self.all[at..statement.end]);
        Some(tokens)
    }
}

/// The text of a mechanism, read once. What it says after a change takes reading only the statements that change.
pub struct Source {
    input: TokenStream,
    /// Made when they are asked for: only who changes the text needs them.
    tokens: OnceCell<Tokens>,
    tree: RefCell<Text>,
}

/// A statement of a changed text.
enum Written {
    /// It is as it was, under this number in the tree.
    Kept(usize),
    New(Box<Statement>),
}

impl Source {
    /// Reads the body of a `mechanism!`.
    #[must_use]
    pub fn read(input: TokenStream) -> Self {
        let tree = grammar::read(input.clone());
        // What is beyond a limit is not taken apart, either.
        let input = if tree.is_beyond { TokenStream::new() } else { input };
        Self { tree: RefCell::new(tree), input, tokens: OnceCell::new() }
    }

    /// Its tokens.
    pub fn tokens(&self) -> &Tokens {
        self.tokens.get_or_init(|| Tokens::of(self.input.clone()))
    }

    pub(super) fn tree(&self) -> Ref<'_, Text> {
        self.tree.borrow()
    }

    pub(super) fn lower(&self) -> Lowered {
        lower(&mut self.tree.borrow_mut(), &self.input)
    }

    /// Returns the model of the text with these changes; none if the text is wrong then, or was before.
    pub fn model_with(&self, edits: &Edits) -> Option<Model> {
        let written = self.written(edits)?;
        let tree = &mut *self.tree.borrow_mut();
        let mut old: Vec<Option<Statement>> =
            std::mem::take(&mut tree.statements).into_iter().map(Some).collect();
        let mut kept = Vec::new();
        for (place, statement) in written.into_iter().enumerate() {
            match statement {
                Written::Kept(number) => {
                    tree.statements.extend(old[number].take());
                    kept.push((place, number));
                }
                Written::New(statement) => tree.statements.push(*statement),
            }
        }
        let lowered = lower(tree, &self.input);
        let changed = std::mem::take(&mut tree.statements);
        let mut kept = kept.into_iter().peekable();
        for (place, statement) in changed.into_iter().enumerate() {
            if let Some((_, number)) = kept.next_if(|(known, _)| *known == place) {
                old[number] = Some(statement);
            }
        }
        tree.statements = old.into_iter().flatten().collect();
        lowered.errors.is_empty().then_some(lowered.model)
    }

    /// The statements of the changed text.
    fn written(&self, edits: &Edits) -> Option<Vec<Written>> {
        let tokens = self.tokens();
        let statements = tokens.statements();
        let (_, others) = statements.split_first()?;
        let tree = self.tree();
        let numbers = &tree.beginnings;
        if tree.header.is_none() || others.len() != numbers.len() {
            return None;
        }
        let mut edits: Vec<&Edit> = edits.iter().collect();
        // Stable: what is inserted at one place stays in order.
        edits.sort_by_key(|edit| (edit.anchor(), edit.splice().0.start));
        let mut edits = &edits[..];
        let mut all = Vec::new();
        let numbers = numbers.iter().map(|(number, _)| Some(*number));
        let mut next = 0;
        for (statement, number) in statements.iter().zip([None].into_iter().chain(numbers)) {
            if let Some(number) = number {
                // A statement that reports a mistake of another begins nowhere.
                all.extend((next..number).map(Written::Kept));
                next = number + 1;
            }
            let range = statement.range();
            let count = edits.iter().take_while(|edit| edit.anchor() < range.end);
            let (here, later) = edits.split_at(count.count());
            edits = later;
            let (added, inside): (Vec<&Edit>, Vec<&Edit>) = here
                .iter()
                .partition(|edit| matches!(edit, Edit::Add(after, _) if *after == range));
            match number {
                Some(number) if inside.is_empty() => all.push(Written::Kept(number)),
                // The `struct` line stays.
                None if inside.is_empty() => {}
                None => return None,
                Some(_) => {
                    let changed = tokens.changed(&range, &inside)?;
                    if !changed.is_empty() {
                        all.push(read_again(&changed)?);
                    }
                }
            }
            for edit in added {
                all.push(read_again(&token::read(edit.splice().1).ok()?)?);
            }
        }
        all.extend((next..tree.statements.len()).map(Written::Kept));
        edits.is_empty().then_some(all)
    }
}

/// Reads a statement; none if these tokens are anything else.
fn read_again(tokens: &[Token]) -> Option<Written> {
    let statement = grammar::read_statement(token::stream(tokens)?)?;
    Some(Written::New(Box::new(statement)))
}
