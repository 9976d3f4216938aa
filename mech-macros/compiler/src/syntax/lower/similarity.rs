//! Where the numbers of a part end up: mirrored, scaled, turned and moved.

use super::quantity::{Quantity, Spot, join, parts};
use crate::bug::bug;
use crate::model::{FORWARD, Formulas};

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
        scale: Quantity::fixed(1.0),
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

    /// The factor of lengths at the start.
    pub(super) fn start_scale(&self) -> f64 {
        let Some(scale) = self.scale.value else {
            bug!("a scale has no value at the start");
        };
        scale
    }

    /// Where a place comes to.
    pub(super) fn place(&self, spot: Spot, formulas: &mut Formulas) -> Spot {
        let [x, y] =
            parts(self.direction(spot, formulas)).map(|part| part.times(self.scale, formulas));
        let [dx, dy] = parts(self.offset);
        join([x.plus(dx, formulas), y.plus(dy, formulas)])
    }

    /// Mirrors and turns a direction.
    pub(super) fn direction(&self, direction: Spot, formulas: &mut Formulas) -> Spot {
        let [mut x, y] = parts(direction);
        if self.is_mirrored {
            x = x.negative(formulas);
        }
        if self.turn == Self::IDENTITY.turn {
            return join([x, y]);
        }
        let [cos, sin] = parts(self.turn);
        let [cx, sy, sx, cy] =
            [(x, cos), (y, sin), (x, sin), (y, cos)].map(|(a, b)| a.times(b, formulas));
        let less = sy.negative(formulas);
        join([cx.plus(less, formulas), sx.plus(cy, formulas)])
    }

    /// First another similarity, then this one.
    pub(super) fn after(&self, inner: &Self, formulas: &mut Formulas) -> Self {
        let [cos, mut sin] = parts(inner.turn);
        if self.is_mirrored {
            sin = sin.negative(formulas);
        }
        let unmirrored = Self { is_mirrored: false, ..*self };
        Self {
            is_mirrored: self.is_mirrored != inner.is_mirrored,
            scale: inner.scale.times(self.scale, formulas),
            turn: unmirrored.direction(join([cos, sin]), formulas),
            offset: self.place(inner.offset, formulas),
        }
    }
}
