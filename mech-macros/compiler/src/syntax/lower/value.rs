//! Computing numbers. What is wrong with one is reported where it is wrong, and there is no value then.

use super::angle::{is_angle, is_degrees_perhaps};
use super::constant::{INSTANCE, Value};
use super::quantity::{Length, Quantity, Spot, as_formulas};
use super::reader::Reader;
use crate::bug::bug;
use crate::model::{BinaryFunction, Formula, FormulaId, Function};
use crate::syntax::Place;
use crate::syntax::ast::{Expr, ExprKind, Pair};
use proc_macro2::Ident;
use std::f64::consts::{PI, TAU};

impl Reader<'_> {
    /// The value of an expression: a finite number, and how it follows from params, or from the variable of the law that is read.
    pub(super) fn quantity(&mut self, expr: &Expr) -> Option<Quantity> {
        match &expr.kind {
            ExprKind::Integer(digits) | ExprKind::Decimal(digits) => {
                self.literal(digits, expr.place).map(Quantity::fixed)
            }
            ExprKind::Pi => Some(Quantity::fixed(PI)),
            ExprKind::Constant(name) => self.constant(name, expr.place),
            ExprKind::Negative(inner) => Some(self.quantity(inner)?.negative(self.formulas())),
            ExprKind::Degrees(inner) => {
                let inner = self.quantity(inner)?;
                let formula = inner.formula.map(|inner| {
                    let degree = self.formulas().add(Formula::constant(PI / 180.0));
                    self.formulas().add(Formula::Mul(inner, degree))
                });
                Some(Quantity { value: inner.value.map(f64::to_radians), formula })
            }
            ExprKind::Sum(terms) => self.chain(terms, Chain::Sum),
            ExprKind::Product(factors) => self.chain(factors, Chain::Product),
            ExprKind::Rpm(inner) => {
                let inner = self.quantity(inner)?;
                let speed = Quantity::fixed(TAU / 60.0);
                Some(inner.times(speed, self.formulas()))
            }
            ExprKind::Call(function, of) => {
                let argument = self.quantity(of)?;
                if let (true, Some(angle)) = (function.is_of_angle(), argument.value)
                    && is_degrees_perhaps(self.report, of, angle)
                {
                    return None;
                }
                self.call(*function, argument, expr.place)
            }
            ExprKind::CallBoth(function, parts) => {
                let [a, b] = &**parts;
                let (a, b) = (self.quantity(a), self.quantity(b));
                self.call_both(*function, [a?, b?], expr.place)
            }
            ExprKind::Measured(measured) => match self.measuring {
                Some(measuring) => measuring.measure(self, measured, expr.place),
                None => self.report.refuse(expr.place, "only `expect` measures"),
            },
            ExprKind::Motion(_) => {
                let text =
                    "segments are a whole law of a motor or a cam; nothing is computed with them";
                self.report.refuse(expr.place, text)
            }
        }
    }

    /// The value of an expression, and the same as an integer.
    pub(super) fn both(&mut self, expr: &Expr) -> Value {
        Value { quantity: self.quantity(expr), integer: self.integer(expr) }
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
            ExprKind::Constant(name) => match self.passing.instance {
                Some(instance) if name == INSTANCE => i64::try_from(instance).ok(),
                _ => self.constants().integer(name),
            },
            ExprKind::Negative(inner) => self.integer(inner)?.checked_neg(),
            ExprKind::Sum(terms) => {
                chain(
                    terms,
                    |sum, term, is_less| {
                        if is_less { sum.checked_sub(term) } else { sum.checked_add(term) }
                    },
                )
            }
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
        self.report.finite(value, place)
    }

    /// Returns the value of a name: of the variable of the law, the number of the instance, or a constant.
    pub(super) fn constant(&mut self, name: &Ident, place: Place) -> Option<Quantity> {
        let passing = self.passing;
        if passing.variable.is_some_and(|variable| name == variable) {
            if self.constants().has(&name.to_string()) {
                let text = format!(
                    "`{name}` is the variable of this law, and a constant too; give the constant another name"
                );
                return self.report.refuse(place, text);
            }
            return Some(self.variable());
        }
        #[expect(clippy::cast_precision_loss, reason = "there are not so many instances")]
        let known = match passing.instance {
            Some(instance) if name == INSTANCE => Quantity::fixed(instance as f64),
            _ => match self.constants().value(name, passing, self.report.statement()) {
                Ok(known) => known?,
                Err(text) => {
                    let unknown = self.unknown_number(name);
                    let place = Place::at(name.span());
                    return self.report.refuse_unknown(unknown, place, text);
                }
            },
        };
        Some(self.in_this_law(known))
    }

    /// The variable of the law that is read.
    pub(super) fn variable(&mut self) -> Quantity {
        let variable =
            Quantity { value: None, formula: Some(self.formulas().add(Formula::Variable(0))) };
        let input = self.law.as_ref().map(|law| law.input);
        let input = self.in_this_law(input.unwrap_or(Quantity::fixed(1.0)));
        variable.over(input, self.formulas())
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
            // Whatever is divided by zero is an error.
            let combined = match (result.value, value.value) {
                (first, Some(second)) => chain
                    .combine(first.unwrap_or(0.0), second, *inverse)
                    .map(|combined| first.map(|_| combined)),
                (_, None) => Ok(None),
            };
            let combined = match combined {
                Ok(combined) => combined,
                Err(trouble) => return self.report.refuse(place, trouble),
            };
            let formulas = as_formulas([result, value], self.formulas());
            let formula = formulas.map(|[a, b]| self.formulas().add(chain.formula(a, b, *inverse)));
            result = self.finite_quantity(combined, formula, place)?;
        }
        Some(result)
    }

    fn call(&mut self, function: Function, of: Quantity, place: Place) -> Option<Quantity> {
        if let Some(value) = of.value
            && let Some(trouble) = function.trouble_at(value)
        {
            let text = format!("{} {trouble}", format_number(value));
            return self.report.refuse(place, text);
        }
        let value = of.value.map(|value| function.at(value));
        let formula = of.formula.map(|of| Formula::Of(function, of));
        let formula = formula.map(|formula| self.formulas().add(formula));
        self.finite_quantity(value, formula, place)
    }

    fn call_both(
        &mut self,
        function: BinaryFunction,
        of @ [a, b]: [Quantity; 2],
        place: Place,
    ) -> Option<Quantity> {
        let both = a.value.zip(b.value);
        // Whatever is divided by zero is an error.
        let trouble = match (both, b.value) {
            (Some((a, b)), _) => function.trouble_at(a, b),
            (None, Some(b)) => function.trouble_at(1.0, b),
            (None, None) => None,
        };
        if let Some(trouble) = trouble {
            return self.report.refuse(place, trouble);
        }
        let value = both.map(|(a, b)| function.at(a, b));
        let formula = as_formulas(of, self.formulas())
            .map(|[a, b]| self.formulas().add(Formula::OfBoth(function, a, b)));
        self.finite_quantity(value, formula, place)
    }

    /// A number that was computed; nothing, if its value is known and too large.
    fn finite_quantity(
        &mut self,
        value: Option<f64>,
        formula: Option<FormulaId>,
        place: Place,
    ) -> Option<Quantity> {
        let value = match value {
            None => None,
            Some(value) => Some(self.report.finite(value, place)?),
        };
        Some(Quantity { value, formula })
    }

    /// The value of a number that may not depend on a param.
    pub(super) fn value(&mut self, expr: &Expr) -> Option<f64> {
        let Quantity { value, formula } = self.quantity(expr)?;
        if formula.is_none() {
            return value;
        }
        self.refuse_param(expr);
        None
    }

    /// The values of a pair that may not depend on a param. Both are looked at, so that the errors of both are reported.
    pub(super) fn pair(&mut self, pair: &Pair) -> Option<[f64; 2]> {
        let (x, y) = (self.value(&pair.x), self.value(&pair.y));
        Some([x?, y?])
    }

    /// A place in a link, which may depend on params.
    pub(super) fn spot(&mut self, pair: &Pair) -> Option<Spot> {
        let [x, y] = [&pair.x, &pair.y].map(|length| {
            let is_angle = is_angle(self.report, length, "a length");
            self.quantity(length).filter(|_| !is_angle)
        });
        let (x, y) = (x?, y?);
        Some(([x.value?, y.value?], [x.formula, y.formula]))
    }

    /// Complains about a number that would change with a param where none may.
    fn refuse_param(&mut self, expr: &Expr) {
        let Some(name) = self.first_dependent(expr) else {
            return;
        };
        let what = match self.constants().word_for(name) {
            "param" => format!("`{name}` is a param: it may change while the mechanism runs"),
            _ => {
                format!("`{name}` is computed from a param: it may change while the mechanism runs")
            }
        };
        let why = self.why_fixed.unwrap_or(
            "only laws, points, lines, joints in a drawing and shapes may depend on one",
        );
        let text = format!("{what}; {why}; use a `const` here");
        self.report.error(Place::at(name.span()), text);
    }

    /// The first name in an expression that stands for something that depends on a param.
    fn first_dependent<'e>(&self, expr: &'e Expr) -> Option<&'e Ident> {
        match &expr.kind {
            ExprKind::Constant(name) => self.constants().depends(name).then_some(name),
            ExprKind::Negative(inner)
            | ExprKind::Degrees(inner)
            | ExprKind::Rpm(inner)
            | ExprKind::Call(_, inner) => self.first_dependent(inner),
            ExprKind::Sum(parts) | ExprKind::Product(parts) => {
                parts.iter().find_map(|(_, part)| self.first_dependent(part))
            }
            ExprKind::CallBoth(_, parts) => {
                parts.iter().find_map(|part| self.first_dependent(part))
            }
            ExprKind::Motion(motion) => {
                motion.numbers().find_map(|number| self.first_dependent(number))
            }
            ExprKind::Integer(_) | ExprKind::Decimal(_) | ExprKind::Pi | ExprKind::Measured(_) => {
                None
            }
        }
    }

    /// A whole number of these bounds.
    pub(super) fn whole(&mut self, expr: &Expr, what: &str, bounds: [i32; 2]) -> Option<i32> {
        let value = self.value(expr)?;
        let [low, high] = bounds;
        if value < f64::from(low) || value > f64::from(high) || value.fract() != 0.0 {
            let number = format_number(value);
            let text = format!("{what} is a whole number from {low} to {high}, not {number}");
            return self.report.refuse(expr.place, text);
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
        if is_angle(self.report, expr, what) {
            return None;
        }
        let value = self.value(expr)?;
        self.check_positive(value, expr, what)
    }

    /// A length greater than zero, at the start if it depends on params.
    pub(super) fn length(&mut self, expr: &Expr, what: &str) -> Option<Length> {
        if is_angle(self.report, expr, what) {
            return None;
        }
        let Quantity { value, formula } = self.quantity(expr)?;
        let value = self.check_positive(value?, expr, what)?;
        Some((value, formula))
    }

    /// A number that is not less than zero.
    pub(super) fn not_negative(&mut self, expr: &Expr, what: &str) -> Option<f64> {
        if is_angle(self.report, expr, what) {
            return None;
        }
        let value = self.value(expr)?;
        if value >= 0.0 {
            return Some(value);
        }
        let text = format!("{what} cannot be negative, but this is {value}");
        self.report.refuse(expr.place, text)
    }

    fn check_positive(&mut self, value: f64, expr: &Expr, what: &str) -> Option<f64> {
        if value > 0.0 {
            return Some(value);
        }
        let number = format_number(value);
        let text = format!("{what} must be greater than zero, not {number}");
        self.report.refuse(expr.place, text)
    }
}

/// The kind of a chain of numbers.
#[derive(Clone, Copy)]
enum Chain {
    Sum,
    Product,
}

impl Chain {
    fn combine(self, a: f64, b: f64, inverse: bool) -> Result<f64, &'static str> {
        match (self, inverse) {
            (Self::Sum, false) => Ok(a + b),
            (Self::Sum, true) => Ok(a - b),
            (Self::Product, false) => Ok(a * b),
            (Self::Product, true) if b == 0.0 => Err("division by zero"),
            (Self::Product, true) => Ok(a / b),
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
pub(super) fn format_number(value: f64) -> String {
    if value == 0.0 || (1e-4..1e15).contains(&value.abs()) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}
