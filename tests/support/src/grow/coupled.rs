//! Random mechanisms in which something has to be solved together: platforms on three legs, and rings that rolling ties.

use super::{Grown, direction, point};
use crate::Dice;
use mech_compiler::model::{JointKind, LinkId, Ratio};

/// Grows a mechanism as [`grow`](super::grow) does, with platforms and tied rings among its additions. One of these comes first.
#[must_use]
pub fn grow_coupled(dice: &mut Dice, additions: usize) -> Grown {
    let mut grown = Grown::new(dice, true);
    for addition in 0..additions {
        grown.add_coupled(dice, addition == 0);
    }
    grown.finish(dice)
}

/// Grows a mechanism as [`grow_coupled`] does, each of whose additions draws from dice of its own.
#[must_use]
pub fn grow_coupled_from(motor: &mut Dice, additions: &[Dice]) -> Grown {
    let mut grown = Grown::new(motor, true);
    for (number, addition) in additions.iter().enumerate() {
        grown.add_coupled(&mut addition.clone(), number == 0);
    }
    grown.finish(motor)
}

impl Grown {
    /// Adds anything; what waits for something else, if it has to.
    pub(super) fn add_coupled(&mut self, dice: &mut Dice, must_wait: bool) {
        match dice.below(if must_wait { 4 } else { 8 }) {
            0 => self.platform(dice),
            1 => self.geared_ring(dice),
            2 | 3 => self.racked_ring(dice),
            _ => self.add(dice),
        }
    }

    /// A link on three legs.
    fn platform(&mut self, dice: &mut Dice) {
        let bases = [0; 3].map(|_| self.any_link(dice));
        let platform = self.link();
        for base in bases {
            let leg = self.link();
            self.revolute(base, leg, point(dice));
            self.revolute(leg, platform, point(dice));
        }
        self.loops += 1;
    }

    /// Three links in a chain between two links, of which one is geared to the last but one before it.
    fn geared_ring(&mut self, dice: &mut Dice) {
        let (first, last) = self.two_links(dice);
        let [a, b, c] = [0; 3].map(|_| self.link());
        self.revolute(first, a, point(dice));
        self.revolute(a, b, point(dice));
        self.revolute(b, c, point(dice));
        if dice.once_in(3) {
            self.prismatic(c, last, point(dice), direction(dice));
        } else {
            self.revolute(c, last, point(dice));
        }
        let (wheel, on, other) = *dice.pick(&[(first, a, b), (a, b, c)]);
        let ratio = Ratio::Teeth(20, *dice.pick(&[60, 40, -50, 17]));
        self.joint(JointKind::Gear { a: wheel, b: other, ratio, on: Some(on) });
        self.loops += 1;
    }

    /// Three links in a chain between two links, of which two slide on each other and are driven by a rack.
    fn racked_ring(&mut self, dice: &mut Dice) {
        let (first, last) = self.two_links(dice);
        let [a, b, c] = [0; 3].map(|_| self.link());
        self.revolute(first, a, point(dice));
        self.revolute(a, b, point(dice));
        let (from, to) = if dice.once_in(2) { (b, c) } else { (c, b) };
        self.prismatic(from, to, point(dice), direction(dice));
        self.revolute(c, last, point(dice));
        let (pinion, on, bar) = *dice.pick(&[(a, b, c), (last, c, b)]);
        let radius = dice.between(0.2, 1.0) * if dice.once_in(3) { -1.0 } else { 1.0 };
        self.joint(JointKind::Rack { pinion, bar, radius, on: Some(on) });
        self.loops += 1;
    }

    fn two_links(&self, dice: &mut Dice) -> (LinkId, LinkId) {
        let first = self.any_link(dice);
        loop {
            let last = self.any_link(dice);
            if last != first {
                return (first, last);
            }
        }
    }
}
