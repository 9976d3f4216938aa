//! Random mechanisms with racks, cams and what nearly is a parallelogram, whose places are anywhere or on a lattice.

use super::{Grown, direction, point};
use crate::{Dice, add_cam, cross};
use mech_compiler::model::{JointKind, LinkId, Ratio};

/// Grows a mechanism as [`grow`](super::grow) or [`grow_coupled`](super::grow_coupled) does, with more kinds of additions. It may be none
/// that moves: a lattice takes dyads to their dead points.
#[must_use]
pub fn grow_wild(dice: &mut Dice, coupled: bool) -> Grown {
    let mut grown = Grown::new(dice, coupled);
    for addition in 0..=dice.below(6) {
        match dice.below(9) {
            0 => grown.racked(dice),
            1 => {
                add_cam(&mut grown.model, dice);
            }
            2 | 3 => grown.parallelogram(dice),
            4 => grown.fast_gear(dice),
            _ if coupled => grown.add_coupled(dice, addition == 0),
            _ => grown.add(dice),
        }
    }
    let lattice = *dice.pick(&[None, Some(0.01), Some(1.0)]);
    if let Some(lattice) = lattice {
        let rounded = |part: f64| (part / lattice).round() * lattice + 0.0;
        for axis in &mut grown.model.axes {
            axis.at = axis.at.map(rounded);
            // None of them becomes zero: a direction is a unit vector.
            axis.direction = axis.direction.map(|part| rounded(1.4 * part));
        }
    }
    grown.finish(dice)
}

impl Grown {
    /// A pin that turns one link on another: both, the ground not the second, and where it is.
    fn turning(&self, dice: &mut Dice) -> Option<([LinkId; 2], [f64; 2])> {
        let pins = self.model.joints.iter().filter_map(|joint| match joint.kind {
            JointKind::Revolute(a, b) => Some([a, b].map(|axis| self.model.axis(axis))),
            _ => None,
        });
        let pins: Vec<_> = pins.collect();
        let [a, b] = *pins.get(dice.below(pins.len().max(1)))?;
        let turn = dice.once_in(2) && a.link != LinkId::GROUND || b.link == LinkId::GROUND;
        let links = if turn { [b, a] } else { [a, b] };
        Some((links.map(|axis| axis.link), a.at))
    }

    /// A bar that a wheel drives, on what carries the wheel.
    fn racked(&mut self, dice: &mut Dice) {
        let Some(([carrier, pinion], _)) = self.turning(dice) else {
            return;
        };
        let bar = self.link();
        self.prismatic(carrier, bar, point(dice), direction(dice));
        let radius = *dice.pick(&[1.0, 0.378, 0.1, 0.5, 3.0, 8.0, 20.0]);
        self.joint(JointKind::Rack { pinion, bar, radius, on: Some(carrier) });
    }

    /// A wheel that another one turns much faster, or slower.
    fn fast_gear(&mut self, dice: &mut Dice) {
        let Some(([carrier, wheel], _)) = self.turning(dice) else {
            return;
        };
        let driven = self.link();
        self.revolute(carrier, driven, point(dice));
        let (a, b) = *dice.pick(&[(1, 40), (40, 1), (70, 10), (1, 7), (60, 17), (20, -60)]);
        self.joint(JointKind::Gear {
            a: wheel,
            b: driven,
            ratio: Ratio::Teeth(a, b),
            on: Some(carrier),
        });
    }

    /// A link that turns as another does, which turns on the same: by how much it is none is a small part of its size.
    fn parallelogram(&mut self, dice: &mut Dice) {
        let Some(([base, crank], p)) = self.turning(dice) else {
            return;
        };
        let (q, shift) = (point(dice), point(dice));
        if cross([q[0] - p[0], q[1] - p[1]], shift).abs() < 0.3 {
            return;
        }
        let off = *dice.pick(&[0.0, 0.0, 0.0, 1e-2, -1e-3, 1e-4, -1e-5]);
        let [coupler, follower] = [(); 2].map(|()| self.link());
        self.revolute(base, follower, [p[0] + shift[0], p[1] + shift[1]]);
        self.revolute(crank, coupler, q);
        let end = [0, 1].map(|part| q[part] + shift[part] * (1.0 + off));
        self.revolute(coupler, follower, end);
    }
}
