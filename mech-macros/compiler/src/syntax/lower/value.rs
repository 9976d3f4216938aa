//! Computing numbers. What is wrong with one is reported where it is wrong, and there is no value then.

use super::Lowering;
use super::report::Report;
use crate::model::Function;
use crate::syntax::Place;
use crate::syntax::ast::{Expr, ExprKind, Pair};
use std::f64::consts::PI;

impl Lowering {
    /// The value of an expression: a finite number.
    pub(super) fn value(&mut self, expr: &Expr) -> Option<f64> {
        match &expr.kind {
            ExprKind::Integer(digits) | ExprKind::Decimal(digits) => {
                self.literal(digits, expr.place)
            }
            ExprKind::Pi => Some(PI),
            ExprKind::Constant(name) => self.constants.value(name, &mut self.report),
            ExprKind::Negative(inner) => self.value(inner).map(|value| -value),
            ExprKind::Degrees(inner) => self.value(inner).map(f64::to_radians),
            ExprKind::Sum(terms) => self.chain(terms, |sum, term, minus| Ok(add(sum, term, minus))),
            ExprKind::Product(factors) => self.chain(factors, multiply),
            ExprKind::Call(function, argument) => {
                let argument = self.value(argument)?;
                self.call(*function, argument, expr.place)
            }
            ExprKind::Extreme(extreme, parts) => {
                let [a, b] = &**parts;
                let (a, b) = (self.value(a), self.value(b));
                Some(extreme.of(a?, b?))
            }
        }
    }

    fn literal(&mut self, digits: &str, place: Place) -> Option<f64> {
        // The digits come from a literal, so they are a number; but one may be too large.
        let value = digits.parse().unwrap_or(f64::INFINITY);
        finite(value, place, &mut self.report)
    }

    /// Computes from left to right. All parts are looked at, so that all of their errors are reported.
    fn chain(
        &mut self,
        parts: &[(bool, Expr)],
        combine: fn(f64, f64, bool) -> Result<f64, &'static str>,
    ) -> Option<f64> {
        let values: Vec<_> = parts.iter().map(|(_, part)| self.value(part)).collect();
        let mut parts = parts.iter().zip(values);
        let ((_, first), value) = parts.next()?;
        let mut result = value?;
        for ((inverse, part), value) in parts {
            let place = first.place.to(part.place);
            match combine(result, value?, *inverse) {
                Ok(value) => result = finite(value, place, &mut self.report)?,
                Err(trouble) => {
                    self.report.tell(place, trouble);
                    return None;
                }
            }
        }
        Some(result)
    }

    pub(super) fn call(&mut self, function: Function, argument: f64, place: Place) -> Option<f64> {
        if function == Function::Sqrt && argument < 0.0 {
            self.report.tell(
                place,
                format!("{} has no square root; it is negative", shown(argument)),
            );
            return None;
        }
        finite(function.at(argument), place, &mut self.report)
    }

    /// The values of a pair. Both are looked at, so that the errors of both are reported.
    pub(super) fn pair(&mut self, pair: &Pair) -> Option<[f64; 2]> {
        let (x, y) = (self.value(&pair.x), self.value(&pair.y));
        Some([x?, y?])
    }

    /// A pair as a direction of length one.
    pub(super) fn direction(&mut self, pair: &Pair) -> Option<[f64; 2]> {
        let [x, y] = self.pair(pair)?;
        // Scaled first: the squares of very long or short ones would overflow or vanish.
        let scale = x.abs().max(y.abs());
        if scale == 0.0 {
            self.report
                .tell(pair.place, "a direction cannot be (0, 0); give it a length");
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
            self.report.tell(expr.place, text);
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
        self.report.tell(
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
    report.tell(
        place,
        "this number is too large; the largest is about 1.8e308",
    );
    None
}
