//! Rounds as a `for` loop over rows of a table.

use super::Term;
use super::class::Output;
use super::pieces::Place;
use super::roll::{Argument, Given, Roll};
use super::writer::Writer;
use crate::bug::bug;
use crate::emit::tokens::{integer, number, scalar};
use crate::program::Value;
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use std::collections::BTreeSet;

/// A `for` loop that is being written.
pub(super) struct Rounds<'r, 'w, 'p> {
    writer: &'r mut Writer<'w, 'p>,
    roll: &'r Roll,
    /// The values that something after it needs.
    needed: &'r BTreeSet<Value>,
    /// The variable that counts the rounds.
    row: Ident,
    before: TokenStream,
    body: TokenStream,
    /// The statements that a round leaves to the next.
    after: TokenStream,
    /// The variables of the results that a round has computed.
    results: Vec<(usize, Output, Ident)>,
    /// The variables of the results of the round before.
    carried: Vec<(Given, Term, Ident)>,
}

impl<'r, 'w, 'p> Rounds<'r, 'w, 'p> {
    pub(super) fn new(
        writer: &'r mut Writer<'w, 'p>,
        roll: &'r Roll,
        needed: &'r BTreeSet<Value>,
    ) -> Self {
        let row = writer.scope.fresh("row");
        Self {
            writer,
            roll,
            needed,
            row,
            before: TokenStream::new(),
            body: TokenStream::new(),
            after: TokenStream::new(),
            results: Vec::new(),
            carried: Vec::new(),
        }
    }

    pub(super) fn statements(mut self) -> TokenStream {
        for piece in 0..self.roll.arguments.len() {
            self.write_piece(piece);
        }
        for (given, _, variable) in std::mem::take(&mut self.carried) {
            let result = self.result(given);
            self.after.extend(quote!(#variable = #result;));
        }
        let Self { row, before, body, after, .. } = self;
        let rows = integer(self.roll.rounds.len());
        quote! {
            #before
            for #row in 0..#rows {
                #body
                #after
            }
        }
    }

    /// The places of a piece in its class, round by round.
    fn places(&self, piece: usize) -> Vec<Place> {
        let rounds = self.roll.rounds.iter();
        let pieces = rounds.filter_map(|round| self.writer.pieces.all[round[piece]].row);
        pieces.collect()
    }

    /// The statements of one of the pieces of a round.
    fn write_piece(&mut self, piece: usize) {
        let places = self.places(piece);
        let class = places[0].class;
        let roll = self.roll;
        let mut arguments = Vec::new();
        for argument in &roll.arguments[piece] {
            arguments.push(self.argument(argument));
        }
        arguments.extend(self.columns(&places));
        let name = self.writer.shared[class].clone();
        let outputs = &self.writer.pieces.classes[class].outputs;
        let mut results = Vec::new();
        let mut stores = TokenStream::new();
        for &output in outputs {
            let values: Vec<Option<Value>> = roll
                .rounds
                .iter()
                .zip(&places)
                .map(|(round, &place)| {
                    self.writer.given(&self.writer.pieces.all[round[piece]], place, output)
                })
                .collect();
            let Some(first) = values.iter().copied().flatten().next() else {
                results.push(quote!(_));
                continue;
            };
            let variable = self.writer.fresh_like(first);
            stores.extend(self.store(&values, first, &variable));
            results.push(quote!(#variable));
            self.results.push((piece, output, variable));
        }
        self.body.extend(quote!(let (#(#results),*) = #name(#(#arguments),*); #stores));
    }

    /// The statement that keeps a result for what comes after the loop.
    fn store(&mut self, values: &[Option<Value>], first: Value, variable: &Ident) -> TokenStream {
        let needed =
            |value: &Option<Value>| value.is_some_and(|value| self.needed.contains(&value));
        if !values.iter().any(needed) {
            return TokenStream::new();
        }
        let array = self.writer.fresh_like(first);
        let rows = integer(values.len());
        self.before.extend(quote!(let mut #array = [0.0; #rows];));
        for (row, value) in values.iter().enumerate() {
            if let Some(value) = value {
                self.writer.scope.place(*value, array.clone(), row, values.len());
            }
        }
        let row = &self.row;
        quote!(#array[#row] = #variable;)
    }

    /// An argument of a piece as an expression.
    fn argument(&mut self, argument: &Argument) -> TokenStream {
        match argument {
            Argument::Same(term) => self.writer.term(*term),
            Argument::Now(given) => self.result(*given),
            Argument::Before(given, first) => self.carry(*given, *first),
            Argument::Each(terms) => self.each(terms),
        }
    }

    /// A result that a piece of the present round has given.
    fn result(&self, given: Given) -> TokenStream {
        let mut results = self.results.iter();
        let found =
            results.find(|(piece, output, _)| (*piece, *output) == (given.piece, given.output));
        let Some((_, _, variable)) = found else { bug!("a round reads what it has not computed") };
        if given.negative { quote!(-#variable) } else { quote!(#variable) }
    }

    /// A result of the round before.
    fn carry(&mut self, given: Given, first: Term) -> TokenStream {
        let mut carried = self.carried.iter();
        if let Some((_, _, variable)) = carried.find(|known| (known.0, known.1) == (given, first)) {
            return quote!(#variable);
        }
        let begins = self.writer.term(first);
        let variable = self.writer.fresh_like(first.value);
        self.before.extend(quote!(let mut #variable = #begins;));
        let tokens = quote!(#variable);
        self.carried.push((given, first, variable));
        tokens
    }

    /// Writes an argument that is known before the loop, and differs from round to round.
    fn each(&mut self, terms: &[Term]) -> TokenStream {
        let row = self.row.clone();
        if let Some(array) = self.writer.scope.array(terms.iter().map(|term| term.value)) {
            let is_negative = |negative: bool| terms.iter().all(|term| term.negative == negative);
            if is_negative(false) {
                return quote!(#array[#row]);
            }
            if is_negative(true) {
                return quote!(-#array[#row]);
            }
        }
        let values: Vec<TokenStream> = terms.iter().map(|&term| self.writer.term(term)).collect();
        let array = self.writer.fresh_like(terms[0].value);
        self.before.extend(quote!(let #array = [#(#values),*];));
        quote!(#array[#row])
    }

    /// The numbers of a row of the table, which is put before the loop.
    fn columns(&mut self, places: &[Place]) -> Vec<TokenStream> {
        let program = self.writer.scope.program;
        let columns = &self.writer.numbers[places[0].class].columns;
        if columns.is_empty() {
            return Vec::new();
        }
        let rows = columns.iter().map(|column| {
            let numbers = places.iter().map(|place| number(program.precision, column[place.row]));
            quote!([#(#numbers),*])
        });
        let rows: Vec<TokenStream> = rows.collect();
        let [height, width] = [places.len(), columns.len()].map(integer);
        let scalar = scalar(program.precision);
        let table = self.writer.scope.fresh("NUMBERS");
        let row = &self.row;
        let cells = (0..columns.len()).map(|column| {
            let column = integer(column);
            quote!(#table[#column][#row])
        });
        let cells = cells.collect();
        self.before.extend(quote!(static #table: [[#scalar; #height]; #width] = [#(#rows),*];));
        cells
    }
}
