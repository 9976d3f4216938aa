//! Measures every loop at the start: tolerances are relative to what is found there.

use super::node::{BlockId, Op, Value};
use super::{BlockKind, Limits, Newton, Program};
use mech_core::dense::solve;

/// Sets the limits of all loops.
pub(super) fn calibrate(program: &mut Program) {
    let values = at_start(program);
    let length = |[x, y]: [Value; 2]| values[x.index()].hypot(values[y.index()]);
    let norm = |column: &[Value]| {
        column
            .iter()
            .map(|value| values[value.index()].powi(2))
            .sum::<f64>()
            .sqrt()
    };
    let det = |newton: &Newton| {
        if !newton.dense {
            return values[newton.det.index()];
        }
        let rate = |row: usize, column: usize| values[newton.columns[column][row].index()];
        let row = |row: usize| -> Vec<f64> {
            (0..newton.columns.len())
                .map(|column| rate(row, column))
                .collect()
        };
        let mut rows: Vec<Vec<f64>> = (0..newton.gap.len()).map(row).collect();
        solve(&mut rows, &mut vec![0.0; newton.gap.len()])
    };
    let nodes = &program.nodes;
    // Where a side is carried its sign is taken out of the determinant.
    let sided =
        |newton: &Newton| newton.dense && !matches!(nodes[newton.det.index()].op, Op::Dense(..));
    for block in &mut program.blocks {
        if let BlockKind::Newton(newton) = &mut block.kind {
            newton.limits = Limits {
                size: newton.sides.iter().map(|&side| length(side)).sum(),
                reach: newton.columns.iter().map(|column| norm(column)).product(),
                det: det(newton).abs(),
                positive: sided(newton) || det(newton) > 0.0,
            };
        }
    }
}

/// All values at the start, where every loop is already closed.
pub(crate) fn at_start(program: &Program) -> Vec<f64> {
    let mut values: Vec<f64> = Vec::with_capacity(program.nodes.len());
    // What a loop finds that is left out, because nothing shown needs it, is read by nobody.
    let first = |block: BlockId, index: usize| {
        let newton = program.newton(block)?;
        Some(newton.scalars[index].first)
    };
    for node in &program.nodes {
        let get = |value: Value| values[value.index()];
        let value = match node.op {
            Op::Unknown(block, index) | Op::Solved(block, index) => {
                first(block, index).map_or(0.0, get)
            }
            op => op.at_start(&program.start, get),
        };
        values.push(value);
    }
    values
}
