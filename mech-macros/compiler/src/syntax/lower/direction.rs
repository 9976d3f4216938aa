//! Directions, which may depend on params.

use super::angle::is_degrees_perhaps;
use super::quantity::{Spot, as_formulas, parts};
use super::reader::Reader;
use crate::model::{BinaryFunction, Formula, Function};
use crate::syntax::Place;
use crate::syntax::ast::{Direction, Expr, Pair};
use std::f64::consts::FRAC_PI_2;

impl Reader<'_> {
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
        if is_degrees_perhaps(self.report, expr, value) {
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
        let mut reader = self.fixed(why);
        for number in numbers {
            reader.value(number);
        }
    }

    fn direction_of_parts(&mut self, pair: &Pair) -> Option<Spot> {
        let [x, y] = [self.quantity(&pair.x), self.quantity(&pair.y)];
        let parts = [x?, y?];
        let [x, y] = [parts[0].value?, parts[1].value?];
        // Scaled first: the squares of very long or short ones would overflow or vanish.
        let scale = x.abs().max(y.abs());
        if scale == 0.0 {
            return self
                .report
                .refuse(pair.place, "a direction cannot be (0, 0); give it a length");
        }
        let (x, y) = (x / scale, y / scale);
        let length = libm::hypot(x, y);
        let formulas = as_formulas(parts, self.formulas()).map(|[x, y]| {
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
        self.near((turned, [None; 2]), place)?;
        let ([x, y], [cos, sin]) = (parts(vector), parts(by));
        let Some([x, y, cos, sin]) = as_formulas([x, y, cos, sin], self.formulas()) else {
            return Some((turned, [None; 2]));
        };
        let mut product = |a, b| self.formulas().add(Formula::Mul(a, b));
        let [cx, sy, sx, cy] = [product(cos, x), product(sin, y), product(sin, x), product(cos, y)];
        let formulas = [Formula::Sub(cx, sy), Formula::Add(sx, cy)];
        Some((turned, formulas.map(|formula| Some(self.formulas().add(formula)))))
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
