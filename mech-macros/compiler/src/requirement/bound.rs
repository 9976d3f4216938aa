//! What is known of a least value, and what is asked of it.

use crate::certify::Interval;

/// A least value: nothing is less than `proved`, and `seen` is at a place.
#[derive(Clone, Debug)]
pub(super) struct Bound {
    pub(super) proved: f64,
    pub(super) seen: f64,
    pub(super) place: Vec<f64>,
}

impl Default for Bound {
    fn default() -> Self {
        Self { proved: f64::NEG_INFINITY, seen: f64::INFINITY, place: Vec::new() }
    }
}

impl Bound {
    /// Takes a value at a place, if it is the least so far.
    pub(super) fn see(&mut self, value: Option<Interval>, place: &[f64]) {
        if let Some(value) = value
            && value.high() < self.seen
        {
            self.seen = value.high();
            self.place = place.to_vec();
        }
    }

    /// How far what is seen may be from the least.
    pub(super) fn gap(&self) -> f64 {
        self.seen - self.proved
    }
}

/// What is nearer to zero than this part of the slack cannot be told from it.
const ALIKE: f64 = 1e-3;

/// What a least value has to be.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limit {
    /// Whether it may not be zero.
    pub(super) is_strict: bool,
    /// How far below zero rounding may push what is zero.
    pub(super) slack: f64,
}

impl Limit {
    /// Whether it is certainly kept.
    pub(super) fn is_kept(self, bound: &Bound) -> bool {
        if self.is_strict { bound.proved > 0.0 } else { bound.proved >= -self.slack }
    }

    /// Whether it is broken at the place that was seen.
    pub(super) fn is_broken(self, bound: &Bound) -> bool {
        if self.is_strict {
            // Equal but for rounding is equal.
            bound.seen <= ALIKE * self.slack
        } else {
            bound.seen < -self.slack
        }
    }
}
