//! The operations of a piece without its numbers: two pieces of one shape may be alike.

use super::Term;
use crate::emit::step::flow::is_given;
use crate::program::{Op, Program, Value};
use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::mem::{Discriminant, discriminant};

/// The kind of an operation. A difference is a sum with one sign changed: both give the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    Sum,
    Product,
    Other(Discriminant<Op>),
}

impl Kind {
    /// Whether the order of its operands makes no difference.
    pub(super) fn commutes(self) -> bool {
        matches!(self, Self::Sum | Self::Product)
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Operand {
    /// The result of an operation of the same piece, or its opposite.
    Inner { position: usize, negative: bool },
    /// A value that is known before the piece.
    Outer(Term),
    /// A number.
    Number(f64),
}

/// An operation of a piece.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Operation {
    pub(super) value: Value,
    pub(super) kind: Kind,
    pub(super) operands: Vec<Operand>,
    /// A number that is equal for operations made in the same way, whatever their constants and the order of their operands.
    pub(super) hash: u64,
    /// Whether it is the root that distinguishes the two sides of a dyad.
    pub(super) is_root: bool,
}

/// The operations of a piece in the order in which they are made, without changes of sign.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Shape {
    pub(super) operations: Vec<Operation>,
    pub(super) positions: BTreeMap<Value, usize>,
    /// The positions of the operations that no other one is made from.
    pub(super) ends: Vec<usize>,
}

impl Shape {
    /// The shape of these values of one block; none if one of them is no plain operation.
    pub(super) fn of(program: &Program, values: &[Value]) -> Option<Self> {
        let inside: BTreeSet<Value> = values.iter().copied().collect();
        let mut shape =
            Self { operations: Vec::new(), positions: BTreeMap::new(), ends: Vec::new() };
        for &value in values {
            match program.node(value).op {
                // The opposite of what is known outside would belong to nobody.
                Op::Neg(_) if !inside.contains(&Term::of(program, value).value) => return None,
                Op::Neg(_) => {}
                op => {
                    let operation = shape.operation(program, value, op)?;
                    shape.positions.insert(value, shape.operations.len());
                    shape.operations.push(operation);
                }
            }
        }
        shape.find_ends();
        Some(shape)
    }

    /// Returns the hashes of its ends: shapes that are alike have the same.
    pub(super) fn hashes(&self) -> Vec<u64> {
        let ends = self.ends.iter();
        ends.map(|&position| self.operations[position].hash).collect()
    }

    fn find_ends(&mut self) {
        let mut is_end = vec![true; self.operations.len()];
        let operands = self.operations.iter().flat_map(|operation| &operation.operands);
        for operand in operands {
            if let Operand::Inner { position, .. } = operand {
                is_end[*position] = false;
            }
        }
        self.ends = (0..is_end.len()).filter(|&position| is_end[position]).collect();
    }

    /// The position of the operation that makes a value.
    fn position(&self, value: Value) -> Option<usize> {
        self.positions.get(&value).copied()
    }

    /// The values that it reads from outside, in the order in which they are first read.
    pub(super) fn outers(&self) -> Vec<Value> {
        let mut outers = Vec::new();
        let operands = self.operations.iter().flat_map(|operation| &operation.operands);
        for operand in operands {
            if let Operand::Outer(term) = operand
                && !outers.contains(&term.value)
            {
                outers.push(term.value);
            }
        }
        outers
    }

    fn operation(&self, program: &Program, value: Value, op: Op) -> Option<Operation> {
        if is_given(op) {
            return None;
        }
        let kind = match op {
            Op::Add(..) | Op::Sub(..) => Kind::Sum,
            Op::Mul(..) => Kind::Product,
            Op::Constant(_)
            | Op::Last(_)
            | Op::Unknown(..)
            | Op::Solved(..)
            | Op::Dense(..)
            | Op::Linear(..) => return None,
            _ => Kind::Other(discriminant(&op)),
        };
        let mut operands: Vec<Operand> =
            op.operands().map(|operand| self.operand(program, operand)).collect();
        if let (Op::Sub(..), [_, second]) = (op, &mut operands[..]) {
            *second = second.opposite();
        }
        let is_root = is_root(program, value);
        Some(Operation {
            value,
            kind,
            hash: self.hash(kind, &operands, is_root),
            operands,
            is_root,
        })
    }

    /// The hash of an operation.
    fn hash(&self, kind: Kind, operands: &[Operand], is_root: bool) -> u64 {
        let hashes = operands.iter().map(|operand| match operand {
            Operand::Inner { position, .. } => self.operations[*position].hash,
            Operand::Outer(_) => 0,
            Operand::Number(_) => 1,
        });
        let mut hashes: Vec<u64> = hashes.collect();
        if kind.commutes() {
            hashes.sort_unstable();
        }
        let mut hasher = DefaultHasher::new();
        (kind, hashes, is_root).hash(&mut hasher);
        hasher.finish()
    }

    fn operand(&self, program: &Program, operand: Value) -> Operand {
        let term = Term::of(program, operand);
        match (program.node(term.value).op, self.position(term.value)) {
            (Op::Constant(number), _) => Operand::Number(signed(number.get(), term.negative)),
            (_, Some(position)) => Operand::Inner { position, negative: term.negative },
            (_, None) => Operand::Outer(term),
        }
    }
}

impl Operand {
    fn opposite(self) -> Self {
        match self {
            Self::Inner { position, negative } => Self::Inner { position, negative: !negative },
            Self::Outer(term) => Self::Outer(term.signed(true)),
            Self::Number(number) => Self::Number(-number),
        }
    }
}

/// A number with its sign changed, if `negative`.
fn signed(number: f64, negative: bool) -> f64 {
    if negative { -number } else { number }
}

/// Whether a value is the root of the discriminant of its block's dyad.
fn is_root(program: &Program, value: Value) -> bool {
    let node = program.node(value);
    let (Op::Sqrt(square), Some(closed)) = (node.op, program.closed_form(node.block)) else {
        return false;
    };
    square == closed.discriminant
        || matches!(program.node(square).op, Op::Max(a, b) if [a, b].contains(&closed.discriminant))
}
