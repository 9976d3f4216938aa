//! The layout of the numbers in a position's state.

use super::node::{Op, Slot};
use super::{Position, Program};
use crate::bug::bug;
use crate::model::{FormulaId, JointId, LinkId, Number};

/// The places in the state of all numbers that have a meaning outside of the loops.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StateLayout {
    /// The first of the signs of the inputs' last motions, if a loop passes change points: one number for each motor and
    /// param. After them comes one for each watched loop: that of its `mech_core::journey::Standing`.
    pub motion_signs: Option<usize>,
    /// The coordinates of joints over any number of turns, where they are asked for or torsional springs need them.
    pub joint_angles: Vec<JointAngle>,
    /// Numbers of axes and shapes that depend on params.
    pub places: Vec<Place>,
}

/// The coordinate of a joint, over any number of turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct JointAngle {
    /// The joint.
    pub joint: JointId,
    /// The index in the state.
    pub state: usize,
}

/// A number that depends on params: of the place or direction of an axis in its link, or of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Place {
    /// The formula that computes it.
    pub formula: FormulaId,
    /// The index in the state.
    pub state: usize,
}

impl Program {
    /// The index in the state of a joint's coordinate; none if no position carries it.
    #[must_use]
    pub fn angle_state(&self, joint: JointId) -> Option<usize> {
        let mut angles = self.layout.joint_angles.iter();
        let found = angles.find(|angle| angle.joint == joint);
        found.map(|angle| angle.state)
    }

    /// The index in the state of what a formula of params gives; none if it is not exposed.
    #[must_use]
    pub fn formula_state(&self, formula: FormulaId) -> Option<usize> {
        let mut places = self.layout.places.iter();
        let found = places.find(|place| place.formula == formula);
        found.map(|place| place.state)
    }
}

/// The number of a link's pose among those of all declared links: so poses are numbered while a program is built, until it is known which
/// of them it stores.
pub(super) fn number_among_all(link: LinkId) -> Option<usize> {
    link.index().checked_sub(1)
}

impl Program {
    /// The index of a link's pose among those that are stored; none if it is not, and for the ground, which does not move.
    #[must_use]
    pub fn place_of(&self, link: LinkId) -> Option<usize> {
        self.stored.binary_search(&link).ok()
    }

    /// The index of a pose that is known to be stored.
    pub(crate) fn pose_index(&self, link: LinkId) -> usize {
        let Some(place) = self.place_of(link) else {
            bug!("the pose of link {} is not state", link.index());
        };
        place
    }

    /// The links whose last pose is read, while poses are numbered among those of all links.
    pub(super) fn read_back(&self) -> Vec<LinkId> {
        let read = self.live_values().filter_map(|value| match self.node(value).op {
            Op::Last(Slot::Pose(number, _)) => Some(LinkId::new(number + 1)),
            _ => None,
        });
        read.collect()
    }

    /// Reduces positions to the stored poses, and numbers these anew.
    pub(super) fn number_stored(&mut self) {
        let Position { poses, .. } = &mut self.start;
        let all = std::mem::take(poses);
        let numbers = self.stored.iter().filter_map(|&link| number_among_all(link));
        poses.extend(numbers.map(|number| all[number]));
        for node in &mut self.ssa.nodes {
            if let Op::Last(Slot::Pose(number, part)) = node.op {
                let place = self.stored.binary_search(&LinkId::new(number + 1));
                node.op = match place {
                    Ok(place) => Op::Last(Slot::Pose(place, part)),
                    // Nothing reads it.
                    Err(_) => Op::Constant(Number::new(all[number][part.index()])),
                };
            }
        }
    }
}
