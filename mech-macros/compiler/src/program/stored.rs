//! Which poses a position stores: those that are asked for, and those that the next move begins with.

use super::node::{Op, Slot};
use super::{Position, Program};
use crate::bug::bug;
use crate::model::LinkId;
use crate::model::Number;

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
