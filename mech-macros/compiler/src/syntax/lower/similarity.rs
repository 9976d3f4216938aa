//! Where the numbers of a part end up: mirrored, scaled, turned and moved.

use super::Lowering;
use super::param::{Quantity, Spot};
use super::value::finite;
use crate::model::{FORWARD, Formula, FormulaId};
use crate::syntax::Place;

/// A similarity: `p ↦ offset + turn · scale · p`, where `p` may change sides before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Similarity {
    /// Whether the x axis changes its direction first.
    pub(super) is_mirrored: bool,
    /// The factor of lengths, greater than zero.
    pub(super) scale: Quantity,
    /// The cosine and sine of the angle by which everything is turned.
    pub(super) turn: Spot,
    /// Where the origin comes to.
    pub(super) offset: Spot,
}

impl Similarity {
    /// Nothing changes.
    pub(super) const IDENTITY: Self = Self {
        is_mirrored: false,
        scale: Quantity {
            value: Some(1.0),
            formula: None,
        },
        turn: (FORWARD, [None; 2]),
        offset: ([0.0; 2], [None; 2]),
    };

    /// The angle by which everything is turned, in radians at the start.
    pub(super) fn angle(&self) -> f64 {
        let [cos, sin] = self.turn.0;
        libm::atan2(sin, cos)
    }

    /// One, or minus one if senses of rotation are reversed.
    pub(super) fn sense(&self) -> f64 {
        if self.is_mirrored { -1.0 } else { 1.0 }
    }
}

/// The two numbers of a pair.
fn parts((numbers, formulas): Spot) -> [Quantity; 2] {
    [0, 1].map(|part| Quantity {
        value: Some(numbers[part]),
        formula: formulas[part],
    })
}

impl Lowering {
    /// A place after a similarity. The place in the text is what is wrong if that is too far away.
    pub(super) fn transform(&mut self, spot: Spot, by: &Similarity, place: Place) -> Option<Spot> {
        let spot = self.transform_direction(spot, by);
        let [x, y] = parts(spot).map(|part| self.product(part, by.scale));
        let [dx, dy] = parts(by.offset);
        let moved = [self.sum(x, dx), self.sum(y, dy)];
        self.spot_of(moved, place)
    }

    /// A direction after a similarity.
    pub(super) fn transform_direction(&mut self, direction: Spot, by: &Similarity) -> Spot {
        let [mut x, y] = parts(direction);
        if by.is_mirrored {
            x = self.negative(x);
        }
        if by.turn == Similarity::IDENTITY.turn {
            return join([x, y]);
        }
        let [cos, sin] = parts(by.turn);
        let [cx, sy, sx, cy] = [
            self.product(x, cos),
            self.product(y, sin),
            self.product(x, sin),
            self.product(y, cos),
        ];
        let less = self.negative(sy);
        join([self.sum(cx, less), self.sum(sx, cy)])
    }

    /// First the inner similarity, then the outer.
    pub(super) fn compose(
        &mut self,
        outer: &Similarity,
        inner: &Similarity,
        place: Place,
    ) -> Option<Similarity> {
        let [cos, mut sin] = parts(inner.turn);
        if outer.is_mirrored {
            sin = self.negative(sin);
        }
        let unmirrored = Similarity {
            is_mirrored: false,
            ..*outer
        };
        Some(Similarity {
            is_mirrored: outer.is_mirrored != inner.is_mirrored,
            scale: self.product(inner.scale, outer.scale),
            turn: self.transform_direction(join([cos, sin]), &unmirrored),
            offset: self.transform(inner.offset, outer, place)?,
        })
    }

    /// A number times another.
    pub(super) fn product(&mut self, a: Quantity, b: Quantity) -> Quantity {
        match (a, b) {
            (number, one) | (one, number) if one == Quantity::fixed(1.0) => number,
            _ => self.combine(a, b, |a, b| a * b, Formula::Mul),
        }
    }

    /// A number divided by another.
    pub(super) fn quotient(&mut self, a: Quantity, b: Quantity) -> Quantity {
        if b == Quantity::fixed(1.0) {
            return a;
        }
        self.combine(a, b, |a, b| a / b, Formula::Div)
    }

    /// A number with the opposite sign.
    pub(super) fn negative(&mut self, number: Quantity) -> Quantity {
        Quantity {
            value: number.value.map(|value| -value),
            formula: number
                .formula
                .map(|formula| self.formulas().add(Formula::Neg(formula))),
        }
    }

    fn sum(&mut self, a: Quantity, b: Quantity) -> Quantity {
        if b == Quantity::fixed(0.0) {
            return a;
        }
        self.combine(a, b, |a, b| a + b, Formula::Add)
    }

    fn combine(
        &mut self,
        a: Quantity,
        b: Quantity,
        values: fn(f64, f64) -> f64,
        formulas: fn(FormulaId, FormulaId) -> Formula,
    ) -> Quantity {
        let both = self.as_formulas([a, b]);
        Quantity {
            value: a.value.zip(b.value).map(|(a, b)| values(a, b)),
            formula: both.map(|[a, b]| self.formulas().add(formulas(a, b))),
        }
    }

    fn spot_of(&mut self, quantities: [Quantity; 2], place: Place) -> Option<Spot> {
        let (numbers, formulas) = join(quantities);
        for number in numbers {
            finite(number, place, &mut self.report)?;
        }
        Some((numbers, formulas))
    }
}

/// Two numbers as a pair. Those of places have values at the start.
fn join([x, y]: [Quantity; 2]) -> Spot {
    let value = |quantity: Quantity| {
        quantity
            .value
            .unwrap_or_else(|| crate::bug::bug!("a place depends on the variable of a law"))
    };
    ([value(x), value(y)], [x.formula, y.formula])
}
