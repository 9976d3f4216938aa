//! Entries as statements: pieces by themselves, and loops.

use super::pieces::{Part, Piece, Place};
use super::roll::{Entry, Roll};
use super::rounds::Rounds;
use super::writer::Writer;
use crate::emit::step::block::values_in_place;
use crate::emit::step::flow::Flow;
use crate::emit::step::stages::{Act, count_lets};
use crate::emit::step::{Blocks, whole_block};
use crate::emit::tokens::number;
use crate::program::Value;
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::BTreeSet;

impl Writer<'_, '_> {
    /// The statements of all entries, and the functions that they call.
    pub(super) fn write(mut self, entries: &[Entry]) -> Blocks {
        let acts = entries.iter().map(|entry| match entry {
            Entry::One(piece) => self.one(&self.pieces.all[*piece]),
            Entry::Roll(roll) => self.roll(roll),
        });
        Blocks { acts: acts.collect(), functions: self.functions }
    }

    /// A piece by itself.
    fn one(&mut self, piece: &Piece) -> Act {
        match (piece.row, piece.part) {
            (Some(place), _) => self.call(piece, place),
            (None, Part::Whole) => {
                whole_block(piece.block, &piece.flow, self.scope, self.names, &mut self.functions)
            }
            (None, Part::Before | Part::Solution) => {
                let statements = values_in_place(&piece.values, &piece.flow, self.scope);
                Act {
                    lets: count_lets(&statements),
                    statements,
                    flow: piece.flow.clone(),
                    fails: false,
                    takes_sines: false,
                }
            }
        }
    }

    /// A call of the function of a class, with the numbers of one row.
    fn call(&mut self, piece: &Piece, place: Place) -> Act {
        let (program, class) = (self.scope.program, &self.pieces.classes[place.class]);
        let row = &class.rows[place.row];
        let mut arguments: Vec<TokenStream> =
            row.arguments.iter().map(|&term| self.term(term)).collect();
        for column in &self.numbers[place.class].columns {
            arguments.push(number(program.precision, column[place.row]));
        }
        let results = class.outputs.iter().map(|&output| {
            let Some(value) = self.given(piece, place, output) else {
                return quote!(_);
            };
            let name = self.scope.bind(value);
            quote!(#name)
        });
        let results: Vec<TokenStream> = results.collect();
        let name = &self.shared[place.class];
        Act {
            statements: quote!(let (#(#results),*) = #name(#(#arguments),*);),
            lets: 1,
            flow: piece.flow.clone(),
            fails: false,
            takes_sines: false,
        }
    }

    /// Several pieces in a loop.
    fn roll(&mut self, roll: &Roll) -> Act {
        let flow = self.flow(roll);
        let statements = Rounds::new(self, roll, &flow.gives).statements();
        Act { lets: count_lets(&statements), statements, flow, fails: false, takes_sines: false }
    }

    /// The flow of a loop: values that it takes from outside, and values of it that others need.
    fn flow(&self, roll: &Roll) -> Flow {
        let inside: BTreeSet<usize> = roll.rounds.iter().flatten().copied().collect();
        let all = || self.pieces.all.iter().enumerate();
        let program = self.scope.program;
        let margins = program.margins().map(|(_, closed)| closed.margin);
        let mut needed: BTreeSet<Value> = program.roots().chain(margins).collect();
        let mut flow = Flow::default();
        let mut made = BTreeSet::new();
        for (number, piece) in all() {
            if inside.contains(&number) {
                flow.takes.extend(&piece.flow.takes);
                flow.reads_last |= piece.flow.reads_last;
                made.extend(&piece.flow.gives);
            } else {
                needed.extend(&piece.flow.takes);
            }
        }
        flow.takes.retain(|value| !made.contains(value));
        flow.gives = made.intersection(&needed).copied().collect();
        flow
    }
}
