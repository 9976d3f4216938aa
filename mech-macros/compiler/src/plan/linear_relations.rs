//! The relations of angles and slides by gears, belts, racks, slides and welds: linear relations with constant rational coefficients,
//! solved exactly.

use crate::bug::bug;
use crate::model::{JointId, LinkId};
use num_rational::BigRational;
use num_traits::{One, ToPrimitive as _, Zero};
use std::collections::BTreeMap;

/// An exact rational number.
pub type Rational = BigRational;

/// The nearest float of an exact number.
pub(crate) fn float_of(exact: &Rational) -> f64 {
    let Some(float) = exact.to_f64() else {
        bug!("{exact} is no number");
    };
    float
}

/// A ratio as a fraction; where that comes from a pitch radius and is long, as a decimal number.
pub(crate) fn fraction(part: &Rational) -> String {
    /// No wheel has more teeth.
    const MOST: i64 = 100_000;
    let is_short = |whole: Option<i64>| whole.is_some_and(|whole| whole.abs() <= MOST);
    match part.to_f64() {
        Some(value) if !(is_short(part.numer().to_i64()) && is_short(part.denom().to_i64())) => {
            format!("{value}")
        }
        _ => part.to_string(),
    }
}

/// A displacement since the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Variable {
    /// A link, by angle. The ground never turns.
    Turn(LinkId),
    /// A sliding joint, by its coordinate.
    Slide(JointId),
    /// A source: a quantity that is known, by its number in the plan.
    Source(usize),
}

/// A linear combination; no coefficient is zero.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct LinearForm(BTreeMap<Variable, Rational>);

impl LinearForm {
    fn term(variable: Variable) -> Self {
        Self(BTreeMap::from([(variable, Rational::one())]))
    }

    /// The turn of a link relative to another.
    pub(crate) fn turn(from: LinkId, to: LinkId) -> Self {
        let of = |link| {
            if link == LinkId::GROUND { Self::default() } else { Self::term(Variable::Turn(link)) }
        };
        of(to).plus(&-Rational::one(), &of(from))
    }

    /// The displacement of a sliding joint.
    pub(crate) fn slide(joint: JointId) -> Self {
        Self::term(Variable::Slide(joint))
    }

    /// A source.
    pub(crate) fn source(number: usize) -> Self {
        Self::term(Variable::Source(number))
    }

    /// `self + factor · other`.
    #[must_use]
    pub(crate) fn plus(mut self, factor: &Rational, other: &Self) -> Self {
        for (variable, coefficient) in &other.0 {
            let sum = self.0.entry(*variable).or_insert_with(Rational::zero);
            *sum += factor * coefficient;
            if sum.is_zero() {
                self.0.remove(variable);
            }
        }
        self
    }

    fn scale(self, factor: &Rational) -> Self {
        Self::default().plus(factor, &self)
    }
}

/// The relations so far, each solved for one variable.
#[derive(Clone, Debug, Default)]
pub(crate) struct LinearRelations(BTreeMap<Variable, LinearForm>);

impl LinearRelations {
    /// Notes that a combination is constant.
    pub(crate) fn add(&mut self, combination: &LinearForm) {
        let mut remainder = self.reduce(combination);
        let pivot = remainder
            .0
            .keys()
            .rev()
            .find(|variable| !matches!(variable, Variable::Source(_)))
            .copied();
        // A remainder without a pivot follows from the relations before: this relation is redundant.
        let Some(pivot) = pivot else { return };
        let Some(coefficient) = remainder.0.remove(&pivot) else {
            return;
        };
        let value = remainder.scale(&-coefficient.recip());
        for known in self.0.values_mut() {
            if let Some(coefficient) = known.0.remove(&pivot) {
                *known = std::mem::take(known).plus(&coefficient, &value);
            }
        }
        self.0.insert(pivot, value);
    }

    /// A combination, written with sources alone; none if it is not known by them.
    pub(crate) fn value(&self, combination: &LinearForm) -> Option<Vec<(usize, Rational)>> {
        let reduced = self.reduce(combination).0.into_iter();
        reduced
            .map(|(variable, coefficient)| match variable {
                Variable::Source(number) => Some((number, coefficient)),
                Variable::Turn(_) | Variable::Slide(_) => None,
            })
            .collect()
    }

    /// For each of these combinations, how it follows from those before it and from sources, if it does.
    pub(crate) fn ties(&self, combinations: &[LinearForm]) -> Vec<Option<Parts>> {
        // Each combination gets a name of its own, a source beyond all others, and is solved for as the ledger itself is.
        let mut relations = self.clone();
        combinations
            .iter()
            .enumerate()
            .map(|(index, combination)| {
                let found =
                    relations.value(combination).map(|parts| split(parts, combinations.len()));
                if found.is_none() {
                    let own = LinearForm::source(usize::MAX - index);
                    relations.add(&combination.clone().plus(&-Rational::one(), &own));
                }
                found
            })
            .collect()
    }

    fn reduce(&self, combination: &LinearForm) -> LinearForm {
        combination.0.iter().fold(LinearForm::default(), |sum, (variable, coefficient)| match self
            .0
            .get(variable)
        {
            Some(value) => sum.plus(coefficient, value),
            None => sum.plus(coefficient, &LinearForm::term(*variable)),
        })
    }
}

/// Parts of earlier combinations, by their place, and of sources, by their number.
pub(crate) type Parts = (Vec<(usize, Rational)>, Vec<(usize, Rational)>);

fn split(parts: Vec<(usize, Rational)>, combinations: usize) -> Parts {
    let (own, sources): (Vec<_>, Vec<_>) =
        parts.into_iter().partition(|(number, _)| usize::MAX - number < combinations);
    (own.into_iter().map(|(number, part)| (usize::MAX - number, part)).collect(), sources)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole(value: i64) -> Rational {
        Rational::from_integer(value.into())
    }

    /// Sun of 5, planet of 1, ring of 7 on the ground, arm: the arm turns 5/12 of the sun, exactly.
    #[test]
    fn planetary() {
        let [ground, sun, arm, planet] = [0, 1, 2, 3].map(LinkId::new);
        let mut relations = LinearRelations::default();
        let sun_planet = LinearForm::turn(arm, sun)
            .scale(&whole(5))
            .plus(&whole(1), &LinearForm::turn(arm, planet));
        let planet_ring =
            LinearForm::turn(arm, planet).plus(&whole(-7), &LinearForm::turn(arm, ground));
        relations.add(&sun_planet);
        relations.add(&planet_ring);
        assert_eq!(relations.value(&LinearForm::turn(ground, arm)), None);
        relations.add(&LinearForm::turn(ground, sun).plus(&whole(-1), &LinearForm::source(0)));
        let five_twelfths = Rational::new(5.into(), 12.into());
        assert_eq!(relations.value(&LinearForm::turn(ground, arm)), Some(vec![(0, five_twelfths)]));
    }
}
