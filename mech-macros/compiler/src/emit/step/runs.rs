//! Rows of results that are elements of the same arrays: they are put together in loops.

use super::scope::{Place, Scope};
use crate::emit::tokens::{integer, number};
use crate::program::{Op, Program, Value};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// From so many rows on, a loop puts them together.
const LEAST: usize = 4;

/// Numbers at equal distances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Progression {
    first: usize,
    step: usize,
}

/// A number of a row.
#[derive(Clone, Debug, PartialEq)]
enum Part {
    /// An element of an array.
    Element(Ident, usize),
    Number(f64),
    /// Something else.
    Other,
}

/// Rows at equal distances whose numbers are at equal distances in the same arrays.
struct Run {
    rows: Progression,
    count: usize,
    parts: Vec<RunPart>,
}

#[derive(Clone, Debug, PartialEq)]
enum RunPart {
    Elements(Ident, Progression),
    Number(f64),
}

/// Results that loops put together in an array.
pub(super) struct Gathered {
    pub(super) array: Ident,
    pub(super) statements: TokenStream,
}

impl Gathered {
    /// Rows of values in an array of this name, each written by `row` from its numbers. None if a loop would gain nothing.
    pub(super) fn of<const N: usize>(
        wanted: &str,
        rows: &[[Value; N]],
        zero: &TokenStream,
        row: impl Fn(&[TokenStream]) -> TokenStream,
        scope: &mut Scope<'_>,
    ) -> Option<Self> {
        let (runs, others) = runs(rows, scope);
        if runs.is_empty() {
            return None;
        }
        let (array, counter) = (scope.fresh(wanted), scope.fresh("row"));
        let count = integer(rows.len());
        let mut statements = quote!(let mut #array = [#zero; #count];);
        for run in runs {
            statements.extend(run.statement(&array, &counter, scope.program, &row));
        }
        for index in others {
            let (row, index) = (row(&scope.expressions(&rows[index])), integer(index));
            statements.extend(quote!(#array[#index] = #row;));
        }
        Some(Self { array, statements })
    }
}

/// The runs of rows of values, and the rows that are in none.
fn runs<const N: usize>(rows: &[[Value; N]], scope: &Scope<'_>) -> (Vec<Run>, Vec<usize>) {
    if !scope.has_arrays() {
        return (Vec::new(), Vec::new());
    }
    let parts: Vec<Vec<Part>> =
        rows.iter().map(|row| row.iter().map(|&value| part(value, scope)).collect()).collect();
    let (mut runs, mut others) = (Vec::new(), Vec::new());
    let mut is_free = vec![true; rows.len()];
    for first in 0..rows.len() {
        if !is_free[first] {
            continue;
        }
        let mut seconds = (first + 1..rows.len()).filter(|&second| is_free[second]);
        match seconds.find_map(|second| Run::of(&parts, &is_free, [first, second])) {
            Some(run) => {
                run.indices().for_each(|index| is_free[index] = false);
                runs.push(run);
            }
            None => others.push(first),
        }
    }
    (runs, others)
}

/// Returns the form of a value in a function: an element of an array, or a number.
fn part(value: Value, scope: &Scope<'_>) -> Part {
    match (scope.place_of(value), scope.program.node(value).op) {
        (Some(Place { array, row }), _) => Part::Element(array, row),
        (None, Op::Constant(constant)) => Part::Number(constant.get()),
        (None, _) => Part::Other,
    }
}

impl Run {
    /// The run that begins with two rows, if it is long enough.
    fn of(rows: &[Vec<Part>], is_free: &[bool], [first, second]: [usize; 2]) -> Option<Self> {
        let parts = rows[first].iter().zip(&rows[second]);
        let parts = parts.map(|pair| match pair {
            (Part::Element(array, first), Part::Element(other, second)) if array == other => {
                let step = second.checked_sub(*first)?;
                let progression = Progression { first: *first, step };
                Some(RunPart::Elements(array.clone(), progression))
            }
            (Part::Number(first), Part::Number(second)) if first.to_bits() == second.to_bits() => {
                Some(RunPart::Number(*first))
            }
            _ => None,
        });
        let step = second - first;
        let mut run = Self {
            rows: Progression { first, step },
            count: 0,
            parts: parts.collect::<Option<_>>()?,
        };
        let count = (0..)
            .map_while(|number| {
                let index = first + number * step;
                (rows.get(index)? == &run.row(number) && is_free[index]).then_some(())
            })
            .count();
        run.count = count;
        (count >= LEAST).then_some(run)
    }

    /// Returns the row that must have this number in the run.
    fn row(&self, number: usize) -> Vec<Part> {
        let parts = self.parts.iter().map(|part| match part {
            RunPart::Elements(array, Progression { first, step }) => {
                Part::Element(array.clone(), first + number * step)
            }
            RunPart::Number(number) => Part::Number(*number),
        });
        parts.collect()
    }

    fn indices(&self) -> impl Iterator<Item = usize> + use<> {
        let Progression { first, step } = self.rows;
        (0..self.count).map(move |number| first + number * step)
    }

    /// The loop that puts its rows into an array: `row` writes one from its numbers.
    fn statement(
        &self,
        array: &Ident,
        counter: &Ident,
        program: &Program,
        row: impl Fn(&[TokenStream]) -> TokenStream,
    ) -> TokenStream {
        let parts = self.parts.iter().map(|part| match part {
            RunPart::Elements(array, progression) => {
                let index = progression.index(counter);
                quote!(#array[#index])
            }
            RunPart::Number(value) => number(program.precision, *value),
        });
        let parts: Vec<TokenStream> = parts.collect();
        let (index, row, count) = (self.rows.index(counter), row(&parts), integer(self.count));
        quote!(for #counter in 0..#count { #array[#index] = #row; })
    }
}

impl Progression {
    /// The number of this place as an expression.
    fn index(self, counter: &Ident) -> TokenStream {
        let (first, step) = (integer(self.first), integer(self.step));
        match (self.first, self.step) {
            (_, 0) => quote!(#first),
            (0, 1) => quote!(#counter),
            (0, _) => quote!(#step * #counter),
            (_, 1) => quote!(#first + #counter),
            _ => quote!(#first + #step * #counter),
        }
    }
}
