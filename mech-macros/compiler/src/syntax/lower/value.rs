//! Computing numbers. What is wrong with one is reported where it is wrong, and there is no value then.

use super::Lowering;
use super::param::{Length, Quantity, Spot};
use super::report::Report;
use crate::bug::bug;
use crate::model::{BinaryFunction, Formula, FormulaId, Function};
use crate::syntax::Place;
use crate::syntax::ast::{Direction, Expr, ExprKind, Pair};
use std::f64::consts::{FRAC_PI_2, PI};

impl Lowering {
    /// The value of an expression: a finite number, and how it follows from params, or from the variable of the law that is read.
    pub(super) fn quantity(&mut self, expr: &Expr) -> Option<Quantity> {
        match &expr.kind {
            ExprKind::Integer(digits) | ExprKind::Decimal(digits) => {
                self.literal(digits, expr.place).map(Quantity::fixed)
            }
            ExprKind::Pi => Some(Quantity::fixed(PI)),
            ExprKind::Constant(name) if self.constants().is_variable(name) => {
                self.variable(name, expr.place)
            }
            ExprKind::Constant(name) => {
                let known = self.scopes.here().constants.value(name, &mut self.report)?;
                Some(self.in_this_law(known))
            }
            ExprKind::Negative(inner) => {
                let inner = self.quantity(inner)?;
                Some(Quantity {
                    value: inner.value.map(|value| -value),
                    formula: inner
                        .formula
                        .map(|inner| self.formulas().add(Formula::Neg(inner))),
                })
            }
            ExprKind::Degrees(inner) => {
                let inner = self.quantity(inner)?;
                let formula = inner.formula.map(|inner| {
                    let degree = self.formulas().add(Formula::constant(PI / 180.0));
                    self.formulas().add(Formula::Mul(inner, degree))
                });
                Some(Quantity {
                    value: inner.value.map(f64::to_radians),
                    formula,
                })
            }
            ExprKind::Sum(terms) => self.chain(terms, Chain::Sum),
            ExprKind::Product(factors) => self.chain(factors, Chain::Product),
            ExprKind::Call(function, argument) => {
                let argument = self.quantity(argument)?;
                self.call(*function, argument, expr.place)
            }
            ExprKind::CallBoth(function, parts) => {
                let [a, b] = &**parts;
                let (a, b) = (self.quantity(a), self.quantity(b));
                self.call_both(*function, [a?, b?], expr.place)
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
            ExprKind::Constant(name) => self.constants().integer(name),
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

    /// Numbers as formulas; none if none of them depends on anything.
    pub(super) fn as_formulas<const N: usize>(
        &mut self,
        all: [Quantity; N],
    ) -> Option<[FormulaId; N]> {
        if all.iter().all(|quantity| quantity.formula.is_none()) {
            return None;
        }
        Some(
            all.map(|quantity| match (quantity.formula, quantity.value) {
                (Some(formula), _) => formula,
                (None, Some(value)) => self.formulas().add(Formula::constant(value)),
                (None, None) => bug!("a number has neither a value nor a formula"),
            }),
        )
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
                Err(trouble) => {
                    self.report.error(place, trouble);
                    return None;
                }
            };
            let formulas = self.as_formulas([result, value]);
            let formula = formulas.map(|[a, b]| self.formulas().add(chain.formula(a, b, *inverse)));
            result = self.finite_quantity(combined, formula, place)?;
        }
        Some(result)
    }

    fn call(&mut self, function: Function, of: Quantity, place: Place) -> Option<Quantity> {
        if let Some((value, trouble)) = of
            .value
            .and_then(|value| Some((value, function.trouble_at(value)?)))
        {
            self.report
                .error(place, format!("{} {trouble}", format_number(value)));
            return None;
        }
        let value = of.value.map(|value| function.at(value));
        let formula = of
            .formula
            .map(|of| self.formulas().add(Formula::Of(function, of)));
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
            self.report.error(place, trouble);
            return None;
        }
        let value = both.map(|(a, b)| function.at(a, b));
        let formula = self
            .as_formulas(of)
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
            Some(value) => Some(finite(value, place, &mut self.report)?),
        };
        Some(Quantity { value, formula })
    }

    /// A direction, of length one, which may depend on params.
    pub(super) fn direction(&mut self, direction: &Direction) -> Option<Spot> {
        match direction {
            Direction::Parts(pair) => self.direction_of_parts(pair),
            Direction::Angle(expr) => self.direction_at_angle(expr),
        }
    }

    /// The direction at an angle, which may depend on params.
    pub(super) fn direction_at_angle(&mut self, expr: &Expr) -> Option<Spot> {
        let angle = self.quantity(expr)?;
        let value = angle.value?;
        if self.is_degrees_perhaps(expr, value) {
            return None;
        }
        let formulas = [Function::Cos, Function::Sin].map(|function| {
            let formula = Formula::Of(function, angle.formula?);
            Some(self.formulas().add(formula))
        });
        Some((direction_at(value), formulas))
    }

    /// A direction that may not depend on params.
    pub(super) fn fixed_direction(&mut self, direction: &Direction) -> Option<Spot> {
        let found = self.direction(direction)?;
        if found.1 == [None; 2] {
            return Some(found);
        }
        match direction {
            Direction::Parts(pair) => self.refuse_turning_point(&[&pair.x, &pair.y]),
            Direction::Angle(angle) => self.refuse_turning_point(&[angle]),
        }
        None
    }

    /// Complains about numbers that turn the direction of a point.
    pub(super) fn refuse_turning_point(&mut self, numbers: &[&Expr]) {
        let why = "the joints of a point count angles from its direction; only lines may turn";
        self.with_fixed_numbers(why, |lowering| {
            for number in numbers {
                lowering.value(number);
            }
        });
    }

    fn direction_of_parts(&mut self, pair: &Pair) -> Option<Spot> {
        let [x, y] = [self.quantity(&pair.x), self.quantity(&pair.y)];
        let parts = [x?, y?];
        let [x, y] = [parts[0].value?, parts[1].value?];
        // Scaled first: the squares of very long or short ones would overflow or vanish.
        let scale = x.abs().max(y.abs());
        if scale == 0.0 {
            self.report
                .error(pair.place, "a direction cannot be (0, 0); give it a length");
            return None;
        }
        let (x, y) = (x / scale, y / scale);
        let length = libm::hypot(x, y);
        let formulas = self.as_formulas(parts).map(|[x, y]| {
            let length = Formula::OfBoth(BinaryFunction::Hypot, x, y);
            let length = self.formulas().add(length);
            [x, y].map(|part| self.formulas().add(Formula::Div(part, length)))
        });
        let formulas = formulas.map_or([None; 2], |formulas| formulas.map(Some));
        Some(([x / length, y / length], formulas))
    }

    /// A vector turned by the angle of a direction. The place is what is wrong if that is too large.
    pub(super) fn turn(&mut self, vector: Spot, by: Spot, place: Place) -> Option<Spot> {
        let ([x, y], [cos, sin]) = (vector.0, by.0);
        let turned = [cos * x - sin * y, sin * x + cos * y];
        for part in turned {
            finite(part, place, &mut self.report)?;
        }
        let quantities = |(numbers, formulas): Spot| {
            [0, 1].map(|part| Quantity {
                value: Some(numbers[part]),
                formula: formulas[part],
            })
        };
        let ([x, y], [cos, sin]) = (quantities(vector), quantities(by));
        let Some([x, y, cos, sin]) = self.as_formulas([x, y, cos, sin]) else {
            return Some((turned, [None; 2]));
        };
        let mut product = |a, b| self.formulas().add(Formula::Mul(a, b));
        let [cx, sy, sx, cy] = [
            product(cos, x),
            product(sin, y),
            product(sin, x),
            product(cos, y),
        ];
        let formulas = [Formula::Sub(cx, sy), Formula::Add(sx, cy)];
        Some((
            turned,
            formulas.map(|formula| Some(self.formulas().add(formula))),
        ))
    }

    /// A whole number of these bounds.
    pub(super) fn whole(&mut self, expr: &Expr, what: &str, bounds: [i32; 2]) -> Option<i32> {
        let value = self.value(expr)?;
        let [low, high] = bounds;
        if value < f64::from(low) || value > f64::from(high) || value.fract() != 0.0 {
            let text = format!(
                "{what} is a whole number from {low} to {high}, not {}",
                format_number(value)
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
        self.check_positive(value, expr, what)
    }

    /// A length greater than zero, at the start if it depends on params.
    pub(super) fn length(&mut self, expr: &Expr, what: &str) -> Option<Length> {
        let Quantity { value, formula } = self.quantity(expr)?;
        let value = self.check_positive(value?, expr, what)?;
        Some((value, formula))
    }

    fn check_positive(&mut self, value: f64, expr: &Expr, what: &str) -> Option<f64> {
        if value > 0.0 {
            return Some(value);
        }
        self.report.error(
            expr.place,
            format!(
                "{what} must be greater than zero, not {}",
                format_number(value)
            ),
        );
        None
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

/// The direction at an angle. Quarters of a turn are exact: no angle in radians is exactly one.
fn direction_at(angle: f64) -> [f64; 2] {
    let quarters = libm::round(angle / FRAC_PI_2);
    if (angle - quarters * FRAC_PI_2).abs() > 2.0 * f64::EPSILON * angle.abs() {
        return [libm::cos(angle), libm::sin(angle)];
    }
    match quarters.rem_euclid(4.0) {
        0.0 => [1.0, 0.0],
        1.0 => [0.0, 1.0],
        2.0 => [-1.0, 0.0],
        _ => [0.0, -1.0],
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
