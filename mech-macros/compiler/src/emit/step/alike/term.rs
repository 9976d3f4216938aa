//! A value or its opposite.

use crate::program::{Op, Program, Value};

/// A value, or its opposite: changes of sign are exact, so they are no operations here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Term {
    pub(super) value: Value,
    pub(super) negative: bool,
}

impl Term {
    /// The value whose sign was changed to make this one, and whether it was changed.
    pub(super) fn of(program: &Program, value: Value) -> Self {
        let (mut value, mut negative) = (value, false);
        while let Op::Neg(inner) = program.node(value).op {
            (value, negative) = (inner, !negative);
        }
        Self { value, negative }
    }

    /// The same with its sign changed, if `negative`.
    pub(super) fn signed(self, negative: bool) -> Self {
        Self { negative: self.negative != negative, ..self }
    }
}
