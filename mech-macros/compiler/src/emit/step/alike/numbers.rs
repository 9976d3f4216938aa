//! The numbers of pieces that are alike: a table with a row for each piece.

use super::class::Class;

/// The place of a number in the function that pieces share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cell {
    /// It is the same in all rows.
    Same(f64),
    /// It differs, and is in this column of the table.
    Column(usize),
}

/// The numbers of a class.
pub(super) struct Numbers {
    /// The cells of the numbers of its operations.
    pub(super) cells: Vec<Cell>,
    /// The columns of its table, each with a number for each row.
    pub(super) columns: Vec<Vec<f64>>,
}

impl Numbers {
    pub(super) fn of(class: &Class) -> Self {
        let mut numbers = Self { cells: Vec::new(), columns: Vec::new() };
        for place in 0..class.rows[0].numbers.len() {
            let column: Vec<f64> = class.rows.iter().map(|row| row.numbers[place]).collect();
            let cell = numbers.cell(column);
            numbers.cells.push(cell);
        }
        if class.has_sides() {
            let sides = class
                .rows
                .iter()
                .map(|row| if row.is_on_other_side(&class.shape) { -1.0 } else { 1.0 });
            numbers.columns.push(sides.collect());
        }
        numbers
    }

    fn cell(&mut self, column: Vec<f64>) -> Cell {
        let first = column[0];
        if column.iter().all(|number| is_same(*number, first)) {
            return Cell::Same(first);
        }
        let known = self.columns.iter().position(|known| {
            let mut pairs = known.iter().zip(&column);
            pairs.all(|(a, b)| is_same(*a, *b))
        });
        Cell::Column(known.unwrap_or_else(|| {
            self.columns.push(column);
            self.columns.len() - 1
        }))
    }
}

fn is_same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}
