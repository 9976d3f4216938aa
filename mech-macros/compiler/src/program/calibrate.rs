//! Measures every loop at the start: tolerances are relative to what is found there.

use super::node::{BlockId, Op, Value};
use super::{BlockKind, Limits, Newton, Program};
use mech_core::dense::solve;

/// Sets the limits of all loops.
pub(super) fn calibrate(program: &mut Program) {
    let values = program.values_at_start();
    let length = |[x, y]: [Value; 2]| values[x.index()].hypot(values[y.index()]);
    let number = |value: Value| values[value.index()];
    let det = |newton: &Newton| {
        if newton.dense { determinant(&newton.columns, number) } else { number(newton.det) }
    };
    let nodes = &program.ssa.nodes;
    // Where a side is carried its sign is taken out of the determinant.
    let sided =
        |newton: &Newton| newton.dense && !matches!(nodes[newton.det.index()].op, Op::Dense(..));
    for block in &mut program.ssa.blocks {
        if let BlockKind::Newton(newton) = &mut block.kind {
            newton.limits = Limits {
                size: newton.sides.iter().map(|&side| length(side)).sum(),
                reach: reach(&newton.columns, number),
                det: det(newton).abs(),
                positive: sided(newton) || det(newton) > 0.0,
            };
        }
    }
}

/// The determinant of columns, as many as each has numbers.
pub(super) fn determinant(columns: &[Vec<Value>], number: impl Fn(Value) -> f64) -> f64 {
    let row = |row: usize| columns.iter().map(|column| number(column[row])).collect();
    let mut rows: Vec<Vec<f64>> = (0..columns.len()).map(row).collect();
    solve(&mut rows, &mut vec![0.0; columns.len()])
}

/// The greatest determinant that columns of these lengths allow: the product of the lengths.
pub(super) fn reach(columns: &[Vec<Value>], number: impl Fn(Value) -> f64) -> f64 {
    let square = |column: &Vec<Value>| column.iter().map(|&value| number(value).powi(2)).sum();
    columns.iter().map(square).map(f64::sqrt).product()
}

impl Program {
    /// All values at the start, where every loop is already closed.
    pub(crate) fn values_at_start(&self) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(self.ssa.nodes.len());
        // Nobody reads the unknowns of a loop that is left out because nothing shown needs it.
        let first = |block: BlockId, index: usize| {
            let newton = self.newton(block)?;
            Some(newton.scalars[index].first)
        };
        for node in &self.ssa.nodes {
            let get = |value: Value| values[value.index()];
            let value = match node.op {
                Op::Unknown(block, index) | Op::Solved(block, index) => {
                    first(block, index).map_or(0.0, get)
                }
                op => op.at_start(&self.start, get),
            };
            values.push(value);
        }
        values
    }
}
