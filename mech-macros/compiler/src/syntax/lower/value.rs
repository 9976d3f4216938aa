//! Computing numbers. What is wrong with one is reported where it is wrong, and there is no value then.

use super::Lowering;
use super::param::Quantity;
use super::report::Report;
use crate::bug::bug;
use crate::model::{Formula, FormulaId, Function};
use crate::syntax::Place;
use crate::syntax::ast::{Expr, ExprKind, Pair};
use std::f64::consts::PI;

impl Lowering {
    /// The value of an expression: a finite number, and how it follows from params.
    pub(super) fn quantity(&mut self, expr: &Expr) -> Option<Quantity> {
        match &expr.kind {
            ExprKind::Integer(digits) | ExprKind::Decimal(digits) => {
                self.literal(digits, expr.place).map(Quantity::fixed)
            }
            ExprKind::Pi => Some(Quantity::fixed(PI)),
            ExprKind::Constant(name) => self.constants.value(name, &mut self.report),
            ExprKind::Negative(inner) => {
                let inner = self.quantity(inner)?;
                let params = &mut self.model.params;
                Some(Quantity {
                    value: -inner.value,
                    formula: inner
                        .formula
                        .map(|inner| params.formula(Formula::Neg(inner))),
                })
            }
            ExprKind::Degrees(inner) => {
                let inner = self.quantity(inner)?;
                let degree = self.formula(Quantity::fixed(PI / 180.0), inner);
                let formula = inner.formula.zip(degree);
                let params = &mut self.model.params;
                Some(Quantity {
                    value: inner.value.to_radians(),
                    formula: formula
                        .map(|(inner, degree)| params.formula(Formula::Mul(inner, degree))),
                })
            }
            ExprKind::Sum(terms) => self.chain(terms, Chain::Sum),
            ExprKind::Product(factors) => self.chain(factors, Chain::Product),
            ExprKind::Call(function, argument) => {
                let argument = self.quantity(argument)?;
                self.call(*function, argument, expr.place)
            }
            ExprKind::Extreme(extreme, parts) => {
                let [a, b] = &**parts;
                let (a, b) = (self.value(a), self.value(b));
                Some(Quantity::fixed(extreme.of(a?, b?)))
            }
        }
    }

    /// The value of an expression that is made from integers alone.
    pub(super) fn integer(&self, expr: &Expr) -> Option<i64> {
        let chain = |parts: &[(bool, Expr)], join: fn(i64, i64, bool) -> Option<i64>| {
            let mut parts = parts.iter();
            let (_, first) = parts.next()?;
            parts.try_fold(self.integer(first)?, |sum, (inverse, part)| {
                join(sum, self.integer(part)?, *inverse)
            })
        };
        match &expr.kind {
            ExprKind::Integer(digits) => digits.parse().ok(),
            ExprKind::Constant(name) => self.constants.integer(name),
            ExprKind::Negative(inner) => self.integer(inner)?.checked_neg(),
            ExprKind::Sum(terms) => chain(terms, |sum, term, is_less| {
                if is_less {
                    sum.checked_sub(term)
                } else {
                    sum.checked_add(term)
                }
            }),
            ExprKind::Product(factors) => chain(factors, |product, factor, divides| {
                (!divides).then(|| product.checked_mul(factor))?
            }),
            _ => None,
        }
    }

    fn literal(&mut self, digits: &str, place: Place) -> Option<f64> {
        // The digits come from a literal, so they are a number; one that is too large is read as infinite.
        let Ok(value) = digits.parse() else {
            bug!("`{digits}` is no number");
        };
        finite(value, place, &mut self.report)
    }

    /// The formula of a number; none unless something beside it depends on a param.
    fn formula(&mut self, quantity: Quantity, beside: Quantity) -> Option<FormulaId> {
        beside.formula.or(quantity.formula)?;
        let params = &mut self.model.params;
        let constant = Formula::Constant(quantity.value);
        Some(quantity.formula.unwrap_or_else(|| params.formula(constant)))
    }

    /// Computes from left to right. All parts are looked at, so that all of their errors are reported.
    fn chain(&mut self, parts: &[(bool, Expr)], chain: Chain) -> Option<Quantity> {
        let values: Vec<_> = parts.iter().map(|(_, part)| self.quantity(part)).collect();
        let mut parts = parts.iter().zip(values);
        let ((_, first), value) = parts.next()?;
        let mut result = value?;
        for ((inverse, part), value) in parts {
            let place = first.place.to(part.place);
            let value = value?;
            match chain.combine(result.value, value.value, *inverse) {
                Ok(combined) => {
                    let combined = finite(combined, place, &mut self.report)?;
                    let (a, b) = (self.formula(result, value), self.formula(value, result));
                    let both = a.zip(b);
                    let formula = both.map(|(a, b)| chain.formula(a, b, *inverse));
                    result = Quantity {
                        value: combined,
                        formula: formula.map(|formula| self.model.params.formula(formula)),
                    };
                }
                Err(trouble) => {
                    self.report.error(place, trouble);
                    return None;
                }
            }
        }
        Some(result)
    }

    pub(super) fn call(
        &mut self,
        function: Function,
        argument: Quantity,
        place: Place,
    ) -> Option<Quantity> {
        let Quantity {
            value: argument,
            formula,
        } = argument;
        if function == Function::Sqrt && argument < 0.0 {
            self.report.error(
                place,
                format!("{} has no square root; it is negative", shown(argument)),
            );
            return None;
        }
        if formula.is_some() && matches!(function, Function::Atan | Function::Exp | Function::Abs) {
            let text = "of what depends on a param there are only `sqrt`, `sin`, `cos` and `tan` yet; use a `const`";
            self.report.error(place, text);
            return None;
        }
        let value = function.at(argument);
        let value = finite(value, place, &mut self.report)?;
        let params = &mut self.model.params;
        let formula = formula.map(|argument| match function {
            Function::Sqrt => params.formula(Formula::Sqrt(argument)),
            Function::Sin => params.formula(Formula::Sin(argument)),
            Function::Cos => params.formula(Formula::Cos(argument)),
            Function::Tan => {
                let sin = params.formula(Formula::Sin(argument));
                let cos = params.formula(Formula::Cos(argument));
                params.formula(Formula::Div(sin, cos))
            }
            // Refused above.
            Function::Atan | Function::Exp | Function::Abs => argument,
        });
        Some(Quantity { value, formula })
    }

    /// A pair as a direction of length one.
    pub(super) fn direction(&mut self, pair: &Pair) -> Option<[f64; 2]> {
        let [x, y] = self.pair(pair)?;
        // Scaled first: the squares of very long or short ones would overflow or vanish.
        let scale = x.abs().max(y.abs());
        if scale == 0.0 {
            self.report
                .error(pair.place, "a direction cannot be (0, 0); give it a length");
            return None;
        }
        let (x, y) = (x / scale, y / scale);
        let length = libm::hypot(x, y);
        Some([x / length, y / length])
    }

    /// A whole number of these bounds.
    pub(super) fn whole(&mut self, expr: &Expr, what: &str, bounds: [i32; 2]) -> Option<i32> {
        let value = self.value(expr)?;
        let [low, high] = bounds;
        if value < f64::from(low) || value > f64::from(high) || value.fract() != 0.0 {
            let text = format!(
                "{what} is a whole number from {low} to {high}, not {}",
                shown(value)
            );
            self.report.error(expr.place, text);
            return None;
        }
        #[expect(
            clippy::cast_possible_truncation,
            reason = "it is a whole number between two others"
        )]
        let value = value as i32;
        Some(value)
    }

    /// A number greater than zero.
    pub(super) fn positive(&mut self, expr: &Expr, what: &str) -> Option<f64> {
        let value = self.value(expr)?;
        if value > 0.0 {
            return Some(value);
        }
        self.report.error(
            expr.place,
            format!("{what} must be greater than zero, not {}", shown(value)),
        );
        None
    }
}

pub(super) fn add(sum: f64, term: f64, minus: bool) -> f64 {
    if minus { sum - term } else { sum + term }
}

pub(super) fn multiply(product: f64, factor: f64, divide: bool) -> Result<f64, &'static str> {
    match (divide, factor) {
        (true, 0.0) => Err("division by zero"),
        (true, _) => Ok(product / factor),
        (false, _) => Ok(product * factor),
    }
}

/// What a chain of numbers is.
#[derive(Clone, Copy)]
enum Chain {
    Sum,
    Product,
}

impl Chain {
    fn combine(self, a: f64, b: f64, inverse: bool) -> Result<f64, &'static str> {
        match (self, inverse) {
            (Self::Sum, inverse) => Ok(add(a, b, inverse)),
            (Self::Product, inverse) => multiply(a, b, inverse),
        }
    }

    fn formula(self, a: FormulaId, b: FormulaId, inverse: bool) -> Formula {
        match (self, inverse) {
            (Self::Sum, false) => Formula::Add(a, b),
            (Self::Sum, true) => Formula::Sub(a, b),
            (Self::Product, false) => Formula::Mul(a, b),
            (Self::Product, true) => Formula::Div(a, b),
        }
    }
}

/// A number for people: without a row of zeros.
pub(super) fn shown(value: f64) -> String {
    if value == 0.0 || (1e-4..1e15).contains(&value.abs()) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

pub(super) fn finite(value: f64, place: Place, report: &mut Report) -> Option<f64> {
    if value.is_finite() {
        return Some(value);
    }
    report.error(
        place,
        "this number is too large; the largest is about 1.8e308",
    );
    None
}
