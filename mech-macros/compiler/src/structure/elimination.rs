//! Sparse elimination, row by row, that remembers how each row came about.

use super::field::{Dice, Element};
use crate::bug::bug;
use crate::cancel;

/// A sparse row or combination: columns in ascending order, no zeros.
pub(crate) type Sparse = Vec<(usize, Element)>;

/// Builds a sparse row from entries in any order; entries of the same column are added.
pub(crate) fn sparse(mut entries: Sparse) -> Sparse {
    entries.sort_by_key(|&(column, _)| column);
    let mut row: Sparse = Vec::with_capacity(entries.len());
    for (column, value) in entries {
        match row.last_mut() {
            Some(last) if last.0 == column => last.1 = last.1 + value,
            _ => row.push((column, value)),
        }
    }
    row.retain(|&(_, value)| !value.is_zero());
    row
}

/// `a + factor · b`.
fn add_scaled(a: &Sparse, factor: Element, b: &Sparse) -> Sparse {
    let mut sum = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    loop {
        match (a.get(i), b.get(j)) {
            (Some(&x), Some(&y)) if x.0 == y.0 => {
                let value = x.1 + factor * y.1;
                if !value.is_zero() {
                    sum.push((x.0, value));
                }
                i += 1;
                j += 1;
            }
            (Some(&x), Some(&y)) if x.0 < y.0 => {
                sum.push(x);
                i += 1;
            }
            (Some(&x), None) => {
                sum.push(x);
                i += 1;
            }
            (_, Some(&y)) => {
                sum.push((y.0, factor * y.1));
                j += 1;
            }
            (None, None) => return sum,
        }
    }
}

/// A row in echelon form: its last entry is its pivot, and is one.
#[derive(Clone, Debug)]
struct Pivot {
    row: Sparse,
    /// Which of the added rows it is made of.
    made_of: Sparse,
}

/// The kind of a row that was added.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum RowKind {
    /// It says something new.
    Independent,
    /// It follows from these earlier rows (and names itself): the support of a left null vector.
    Dependent(Vec<usize>),
}

/// Rows in echelon form, over columns `0..columns`.
#[derive(Clone, Debug)]
pub(crate) struct Elimination {
    pivots: Vec<Option<Pivot>>,
    added: usize,
    rank: usize,
}

impl Elimination {
    pub(crate) fn new(columns: usize) -> Self {
        Self { pivots: vec![None; columns], added: 0, rank: 0 }
    }

    /// The number of columns that no row determines.
    pub(crate) fn freedom(&self) -> usize {
        self.pivots.len() - self.rank
    }

    /// Adds a row.
    pub(crate) fn add(&mut self, row: Sparse) -> RowKind {
        let made_of = vec![(self.added, Element::ONE)];
        self.added += 1;
        match self.reduce(row, made_of) {
            None => RowKind::Independent,
            Some(made_of) => {
                RowKind::Dependent(made_of.into_iter().map(|(index, _)| index).collect())
            }
        }
    }

    /// The same rows, without what they are made of.
    pub(crate) fn forgetful(&self) -> Self {
        let mut rows = self.clone();
        for pivot in rows.pivots.iter_mut().flatten() {
            pivot.made_of = Sparse::new();
        }
        rows
    }

    /// Adds a row without remembering how it came about, as all rows before it; whether it says something new.
    pub(crate) fn extend(&mut self, row: Sparse) -> bool {
        self.reduce(row, Sparse::new()).is_none()
    }

    /// Subtracts the known rows from a new one, and keeps what is left as a pivot. If nothing is left, gives the rows that it follows
    /// from.
    fn reduce(&mut self, row: Sparse, mut made_of: Sparse) -> Option<Sparse> {
        cancel::check();
        let mut row = sparse(row);
        while let Some(&(column, value)) = row.last() {
            cancel::check();
            if let Some(pivot) = &self.pivots[column] {
                row = add_scaled(&row, -value, &pivot.row);
                made_of = add_scaled(&made_of, -value, &pivot.made_of);
            } else {
                let factor = value.inverse();
                for (_, value) in row.iter_mut().chain(&mut made_of) {
                    *value = *value * factor;
                }
                self.pivots[column] = Some(Pivot { row, made_of });
                self.rank += 1;
                return None;
            }
        }
        Some(made_of)
    }

    /// A random vector of the right null space: one value a column, all zero if nothing is free.
    pub(crate) fn random_motion(&self, dice: &mut Dice) -> Vec<Element> {
        let mut motion = Vec::with_capacity(self.pivots.len());
        for pivot in &self.pivots {
            let value = match pivot {
                None => dice.roll(),
                Some(Pivot { row, .. }) => {
                    let Some((_, remainder)) = row.split_last() else {
                        bug!("an equation that stands for an unknown is empty");
                    };
                    let sum = remainder
                        .iter()
                        .fold(Element::ZERO, |sum, &(column, value)| sum + value * motion[column]);
                    -sum
                }
            };
            motion.push(value);
        }
        motion
    }
}
