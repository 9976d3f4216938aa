//! Loops that are alike are one function: blocks that are the same up to their numbers, which become a table.
//!
//! Blocks are divided in `pieces`. A `row` is what a piece has in the places of another; pieces of one `class` share a function, which
//! `template` writes. `roll` finds those that are computed in a loop.

mod class;
mod entries;
mod pieces;
mod roll;
mod rounds;
mod row;
mod schedule;
mod shape;
mod template;
#[cfg(test)]
mod tests;
mod writer;

use super::Blocks;
use super::scope::Scope;
use crate::program::{Op, Program, Value};
use pieces::Pieces;
use roll::{calls, entries};
use schedule::{in_order, side_by_side};
use std::collections::BTreeSet;
use writer::Writer;

/// Whether enough loops of a program are alike.
pub(super) fn has_alike(program: &Program) -> bool {
    Pieces::of(program).is_some()
}

/// The statements of each block of a step in which enough loops are alike; none if there are none.
pub(super) fn blocks(scope: &mut Scope<'_>, names: &mut BTreeSet<String>) -> Option<Blocks> {
    let program = scope.program;
    let pieces = Pieces::of(program)?;
    let orders = [in_order(&pieces), side_by_side(&pieces)];
    let entries = orders.map(|order| entries(program, &pieces, &order));
    let shortest = entries.into_iter().min_by_key(|entries| calls(entries))?;
    Some(Writer::new(&pieces, &shortest, scope, names).write(&shortest))
}

/// A value, or its opposite: changes of sign are exact, so they are no operations here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Term {
    value: Value,
    negative: bool,
}

impl Term {
    /// The value whose sign was changed to make this one, and whether it was changed.
    fn of(program: &Program, value: Value) -> Self {
        let (mut value, mut negative) = (value, false);
        while let Op::Neg(inner) = program.node(value).op {
            (value, negative) = (inner, !negative);
        }
        Self { value, negative }
    }

    /// The same with its sign changed, if `negative`.
    fn signed(self, negative: bool) -> Self {
        Self { negative: self.negative != negative, ..self }
    }
}
