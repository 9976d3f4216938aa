//! Numbers, and how they follow from params or from the variable of a law.

use crate::bug::bug;
use crate::model::{Formula, FormulaId, Formulas};

/// A number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Quantity {
    /// Its value at the start; none if that depends on the variable of a law.
    pub(super) value: Option<f64>,
    /// Its formula, if it depends on a param or on the variable of a law.
    pub(super) formula: Option<FormulaId>,
}

/// A pair of numbers, and how each is computed that depends on a param.
pub(super) type Spot = ([f64; 2], [Option<FormulaId>; 2]);

/// A length, and how it is computed if it depends on a param.
pub(super) type Length = (f64, Option<FormulaId>);

impl Quantity {
    /// A number that never changes.
    pub(super) const fn fixed(value: f64) -> Self {
        Self { value: Some(value), formula: None }
    }

    /// This number times another.
    pub(super) fn times(self, other: Self, formulas: &mut Formulas) -> Self {
        match (self, other) {
            (number, one) | (one, number) if one == Self::fixed(1.0) => number,
            (a, b) => a.combine(b, |a, b| a * b, Formula::Mul, formulas),
        }
    }

    /// This number divided by another.
    pub(super) fn over(self, other: Self, formulas: &mut Formulas) -> Self {
        if other == Self::fixed(1.0) {
            return self;
        }
        self.combine(other, |a, b| a / b, Formula::Div, formulas)
    }

    /// This number and another together.
    pub(super) fn plus(self, other: Self, formulas: &mut Formulas) -> Self {
        if other == Self::fixed(0.0) {
            return self;
        }
        self.combine(other, |a, b| a + b, Formula::Add, formulas)
    }

    /// This number with the opposite sign.
    pub(super) fn negative(self, formulas: &mut Formulas) -> Self {
        Self {
            value: self.value.map(|value| -value),
            formula: self.formula.map(|formula| formulas.add(Formula::Neg(formula))),
        }
    }

    /// This number as a formula.
    pub(super) fn as_formula(self, formulas: &mut Formulas) -> FormulaId {
        match (self.formula, self.value) {
            (Some(formula), _) => formula,
            (None, Some(value)) => formulas.add(Formula::constant(value)),
            (None, None) => bug!("a number has neither a value nor a formula"),
        }
    }

    fn combine(
        self,
        other: Self,
        values: fn(f64, f64) -> f64,
        formula: fn(FormulaId, FormulaId) -> Formula,
        formulas: &mut Formulas,
    ) -> Self {
        let both = as_formulas([self, other], formulas);
        Self {
            value: self.value.zip(other.value).map(|(a, b)| values(a, b)),
            formula: both.map(|[a, b]| formulas.add(formula(a, b))),
        }
    }
}

/// Numbers as formulas; none if none of them depends on anything.
pub(super) fn as_formulas<const N: usize>(
    all: [Quantity; N],
    formulas: &mut Formulas,
) -> Option<[FormulaId; N]> {
    if all.iter().all(|quantity| quantity.formula.is_none()) {
        return None;
    }
    Some(all.map(|quantity| quantity.as_formula(formulas)))
}

/// The two numbers of a pair.
pub(super) fn parts((numbers, formulas): Spot) -> [Quantity; 2] {
    [0, 1].map(|part| Quantity { value: Some(numbers[part]), formula: formulas[part] })
}

/// Two numbers as a pair. Those of places have values at the start.
pub(super) fn join([x, y]: [Quantity; 2]) -> Spot {
    let value = |quantity: Quantity| match quantity.value {
        Some(value) => value,
        None => bug!("a place depends on the variable of a law"),
    };
    ([value(x), value(y)], [x.formula, y.formula])
}
