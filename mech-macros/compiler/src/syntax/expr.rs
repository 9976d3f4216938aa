//! Numbers and places, as they were written.

use super::{Message, Place};
use crate::model::{BinaryFunction, Function};
use proc_macro2::Ident;

/// A part of the text, or what is wrong with it.
pub(super) type Read<T> = Result<T, Message>;

/// `(x, y)`
pub(super) struct Pair {
    /// The first number.
    pub x: Expr,
    /// The second number.
    pub y: Expr,
    /// From bracket to bracket.
    pub place: Place,
}

/// A number to be computed.
pub(super) struct Expr {
    /// Its operation.
    pub kind: ExprKind,
    /// From its first token to its last.
    pub place: Place,
}

/// The operation that computes a number. Chains are flat, so that a long one cannot exhaust the stack.
pub(super) enum ExprKind {
    /// A literal without a decimal point or an exponent: its decimal digits.
    Integer(String),
    /// A literal with one of them.
    Decimal(String),
    /// `PI`
    Pi,
    /// The name of a constant.
    Constant(Ident),
    /// `-a`
    Negative(Box<Expr>),
    /// `a + b - c`; the flag says that the term is taken away.
    Sum(Vec<(bool, Expr)>),
    /// `a * b / c`; the flag says that the factor divides.
    Product(Vec<(bool, Expr)>),
    /// `a deg`
    Degrees(Box<Expr>),
    /// `sqrt(a)`
    Call(Function, Box<Expr>),
    /// `min(a, b)`
    CallBoth(BinaryFunction, Box<[Expr; 2]>),
}
