//! Which motors move a loop, and which loop a link waits for.

use crate::program::{BlockKind, Op, Program, Value};

/// The motors and loops on which some values depend.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Influence {
    /// For each motor whether it moves them.
    pub(super) motors: Vec<bool>,
    /// For each loop whether it has to be closed before.
    pub(super) loops: Vec<bool>,
}

impl Influence {
    /// On the links, one after the other.
    pub(super) fn on_links(program: &Program, loops: usize) -> Vec<Self> {
        let poses = program.poses.iter();
        poses.map(|pose| Self::on(program, loops, pose.to_vec())).collect()
    }

    /// On the loops, in the order in which they are closed; each has influence on itself.
    pub(super) fn on_loops(program: &Program, loops: usize) -> Vec<Self> {
        let mut found: Vec<Self> =
            (0..loops).map(|_| Self::on(program, loops, Vec::new())).collect();
        for (number, roots) in program.ssa.blocks.iter().filter_map(|block| roots(&block.kind)) {
            found[number] = Self::on(program, loops, roots);
            found[number].loops[number] = true;
        }
        found
    }

    fn on(program: &Program, loops: usize, mut waiting: Vec<Value>) -> Self {
        let mut influence =
            Self { motors: vec![false; program.inputs()], loops: vec![false; loops] };
        let mut seen = vec![false; program.ssa.nodes.len()];
        while let Some(value) = waiting.pop() {
            if std::mem::replace(&mut seen[value.index()], true) {
                continue;
            }
            let node = program.node(value);
            match node.op {
                Op::Input(input) | Op::Turns(input) | Op::PartOfTurns(input, ..) => {
                    influence.motors[input.index()] = true;
                }
                _ => {}
            }
            waiting.extend(node.op.operands());
            match &program.ssa.blocks[node.block.index()].kind {
                BlockKind::Straight => {}
                BlockKind::ClosedForm(closed) => influence.note(closed.number),
                kind @ BlockKind::Newton(newton) => {
                    influence.note(newton.number);
                    waiting.extend(roots(kind).into_iter().flat_map(|(_, roots)| roots));
                }
            }
        }
        influence
    }

    fn note(&mut self, number: usize) {
        self.loops[number] = true;
    }
}

/// The loop that a block closes, and what is made by closing it.
fn roots(kind: &BlockKind) -> Option<(usize, Vec<Value>)> {
    match kind {
        BlockKind::Straight => None,
        BlockKind::ClosedForm(closed) => {
            Some((closed.number, vec![closed.discriminant, closed.sine]))
        }
        BlockKind::Newton(newton) => {
            let next = newton.scalars.iter().map(|scalar| scalar.next);
            let rates = newton.columns.iter().flatten();
            let all = newton.gap.iter().chain(rates).copied().chain(next);
            Some((newton.number, all.collect()))
        }
    }
}
