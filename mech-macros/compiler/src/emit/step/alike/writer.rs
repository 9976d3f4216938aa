//! The writer of pieces: the functions of their classes, and names.

use super::Term;
use super::class::Output;
use super::pieces::{Part, Piece, Pieces, Place};
use super::roll::Entry;
use super::template::Numbers;
use super::template::{Shared, within_instance};
use crate::emit::step::scope::Scope;
use crate::program::Value;
use proc_macro2::{Ident, TokenStream};
use std::collections::BTreeSet;

/// Writes the pieces of a step.
pub(super) struct Writer<'w, 'p> {
    pub(super) pieces: &'w Pieces,
    pub(super) numbers: Vec<Numbers>,
    /// The names of the functions of the classes.
    pub(super) shared: Vec<Ident>,
    pub(super) scope: &'w mut Scope<'p>,
    pub(super) names: &'w mut BTreeSet<String>,
    pub(super) functions: TokenStream,
}

impl<'w, 'p> Writer<'w, 'p> {
    /// A writer that has written the functions of the classes.
    pub(super) fn new(
        pieces: &'w Pieces,
        entries: &[Entry],
        scope: &'w mut Scope<'p>,
        names: &'w mut BTreeSet<String>,
    ) -> Self {
        let program = scope.program;
        let numbers: Vec<Numbers> = pieces.classes.iter().map(Numbers::of).collect();
        let (mut shared, mut functions) = (Vec::new(), TokenStream::new());
        for (class, numbers) in pieces.classes.iter().zip(&numbers) {
            let first = &pieces.all[class.pieces[0]];
            let block = &program.ssa.blocks[first.block.index()];
            let wanted = match first.part {
                Part::Before => format!("before_{}", block.name),
                Part::Whole | Part::Solution => block.name.clone(),
            };
            let name = scope.fresh_function(names, &wanted);
            let template = Shared {
                program,
                class,
                numbers,
                name: &name,
                title: &block.title,
                part: first.part,
                in_loops: !class.pieces.iter().any(|&piece| is_one(entries, piece)),
            };
            functions.extend(template.function());
            shared.push(name);
        }
        Self { pieces, numbers, shared, scope, names, functions }
    }

    /// The value that a piece gives as an output of its class, if something needs it.
    pub(super) fn given(&self, piece: &Piece, place: Place, output: Output) -> Option<Value> {
        let (program, class) = (self.scope.program, &self.pieces.classes[place.class]);
        let mut gives = piece.flow.gives.iter().copied();
        gives.find(|&value| class.output(program, place.row, value) == output)
    }

    /// A value or its opposite as an expression.
    pub(super) fn term(&self, term: Term) -> TokenStream {
        if term.negative {
            self.scope.negation(term.value)
        } else {
            self.scope.expression(term.value)
        }
    }

    /// A name for a variable that holds such a value.
    pub(super) fn fresh_like(&mut self, value: Value) -> Ident {
        let name = self.scope.program.node(value).name.as_deref();
        self.scope.fresh(within_instance(name.unwrap_or("part")))
    }
}

/// Whether a piece is computed by itself.
fn is_one(entries: &[Entry], piece: usize) -> bool {
    let is_it = |entry: &Entry| matches!(entry, Entry::One(one) if *one == piece);
    entries.iter().any(is_it)
}
