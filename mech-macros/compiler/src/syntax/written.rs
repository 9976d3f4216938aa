//! Numbers as they were written, for messages that offer them again.

use super::ast::{Expr, ExprKind};
use crate::model::{Extreme, Function};
use std::fmt::{self, Display, Formatter};

/// How tightly the parts of an expression hold together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Bond {
    Sum,
    Product,
    Sign,
    Unit,
    Whole,
}

impl Display for Expr {
    fn fmt(&self, formatter: &mut Formatter) -> fmt::Result {
        match &self.kind {
            ExprKind::Integer(digits) | ExprKind::Decimal(digits) => write!(formatter, "{digits}"),
            ExprKind::Pi => write!(formatter, "PI"),
            ExprKind::Constant(name) => write!(formatter, "{name}"),
            ExprKind::Negative(inner) => {
                write!(formatter, "-")?;
                part(inner, Bond::Unit, formatter)
            }
            ExprKind::Sum(terms) => chain(terms, [" + ", " - "], Bond::Product, formatter),
            ExprKind::Product(factors) => chain(factors, [" * ", " / "], Bond::Sign, formatter),
            ExprKind::Degrees(inner) => {
                part(inner, Bond::Whole, formatter)?;
                write!(formatter, " deg")
            }
            ExprKind::Call(function, argument) => {
                write!(formatter, "{}({argument})", word_for(*function))
            }
            ExprKind::Extreme(extreme, parts) => {
                let [a, b] = &**parts;
                let word = match extreme {
                    Extreme::Least => "min",
                    Extreme::Greatest => "max",
                };
                write!(formatter, "{word}({a}, {b})")
            }
        }
    }
}

fn chain(
    parts: &[(bool, Expr)],
    [one, other]: [&str; 2],
    bond: Bond,
    formatter: &mut Formatter,
) -> fmt::Result {
    for (number, (inverse, expr)) in parts.iter().enumerate() {
        if number > 0 {
            write!(formatter, "{}", if *inverse { other } else { one })?;
        }
        part(expr, bond, formatter)?;
    }
    Ok(())
}

/// A part of an expression: in brackets if it is held together less tightly than this.
fn part(expr: &Expr, bond: Bond, formatter: &mut Formatter) -> fmt::Result {
    if bond_of(expr) < bond {
        write!(formatter, "({expr})")
    } else {
        write!(formatter, "{expr}")
    }
}

fn bond_of(expr: &Expr) -> Bond {
    match expr.kind {
        ExprKind::Sum(_) => Bond::Sum,
        ExprKind::Product(_) => Bond::Product,
        ExprKind::Negative(_) => Bond::Sign,
        ExprKind::Degrees(_) => Bond::Unit,
        ExprKind::Integer(_)
        | ExprKind::Decimal(_)
        | ExprKind::Pi
        | ExprKind::Constant(_)
        | ExprKind::Call(..)
        | ExprKind::Extreme(..) => Bond::Whole,
    }
}

fn word_for(function: Function) -> &'static str {
    match function {
        Function::Sqrt => "sqrt",
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::Atan => "atan",
        Function::Exp => "exp",
        Function::Abs => "abs",
    }
}
