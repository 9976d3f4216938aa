//! Pieces that are alike: what they have in common, and how each differs.

use super::Term;
use super::row::Row;
use super::shape::Shape;
use crate::bug::bug;
use crate::program::{Program, Value};
use std::collections::BTreeMap;

/// From so many on, pieces that are alike share a function.
pub(super) const LEAST: usize = 4;

/// Pieces that are alike. The first stands for all.
pub(super) struct Class {
    pub(super) shape: Shape,
    /// One for each piece, that of the first included.
    pub(super) rows: Vec<Row>,
    /// The pieces, by number.
    pub(super) pieces: Vec<usize>,
    /// The results of the function that the pieces share, in the order in which they are computed.
    pub(super) outputs: Vec<Output>,
}

/// A result of the function that pieces share.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Output {
    /// The position of the operation that makes it.
    pub(super) position: usize,
    /// Whether it is the opposite of that operation's result.
    pub(super) negative: bool,
}

impl Class {
    /// The classes among these pieces. A piece is in no class if too few others are like it.
    pub(super) fn find(shapes: Vec<(usize, Shape)>) -> Vec<Self> {
        let mut classes: Vec<Self> = Vec::new();
        // Most classes need not be compared with.
        let mut similar: BTreeMap<Vec<u64>, Vec<usize>> = BTreeMap::new();
        for (piece, shape) in shapes {
            let similar = similar.entry(shape.hashes()).or_default();
            let found = similar.iter().find_map(|&class| {
                let row = Row::of(&classes[class].shape, &shape)?;
                Some((row, class))
            });
            let found = found.map(|(row, class)| (row, &mut classes[class]));
            if let Some((row, class)) = found {
                class.rows.push(row);
                class.pieces.push(piece);
            } else if let Some(row) = Row::of(&shape, &shape) {
                similar.push(classes.len());
                classes.push(Self {
                    shape,
                    rows: vec![row],
                    pieces: vec![piece],
                    outputs: Vec::new(),
                });
            }
        }
        classes.retain(|class| class.rows.len() >= LEAST);
        classes
    }

    /// Whether the dyad of any row lies on the other side.
    pub(super) fn has_sides(&self) -> bool {
        let mut rows = self.rows.iter();
        rows.any(|row| row.is_on_other_side(&self.shape))
    }

    /// Which result of the shared function a value is that the piece of this row computes.
    pub(super) fn output(&self, program: &Program, row: usize, value: Value) -> Output {
        let term = Term::of(program, value);
        let Some(&position) = self.rows[row].positions.get(&term.value) else {
            bug!("a piece gives what it does not make");
        };
        Output { position, negative: term.negative != self.rows[row].opposite[position] }
    }
}
