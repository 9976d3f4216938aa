//! Which poses a position keeps: those that are asked for, and those that the next move begins with.

use super::node::{Op, Slot};
use super::{Position, Program};
use crate::bug::bug;
use crate::model::LinkId;
use crate::model::Number;

/// The number of a link's pose among those of all declared links: so poses are numbered while a program is written, as long as
/// nobody knows which of them will be kept.
pub(super) fn number_among_all(link: LinkId) -> Option<usize> {
    link.index().checked_sub(1)
}

impl Program {
    /// The position of a link's pose among those that are kept; none if it is not, and of the ground, which does not move.
    #[must_use]
    pub fn place_of(&self, link: LinkId) -> Option<usize> {
        self.stored.binary_search(&link).ok()
    }

    /// The position of a pose that is kept, where only these are asked for.
    pub(crate) fn pose_index(&self, link: LinkId) -> usize {
        let Some(place) = self.place_of(link) else {
            bug!("the pose of link {} is not state", link.index());
        };
        place
    }

    /// The links whose last pose is read, while poses are numbered among those of all links.
    pub(super) fn read_back(&self) -> Vec<LinkId> {
        let read = self
            .live_values()
            .filter_map(|value| self.node(value).op.read());
        read.map(|number| LinkId::new(number + 1)).collect()
    }

    /// From here on a position holds only the poses that are kept, and these are numbered anew.
    pub(super) fn number_stored(&mut self) {
        let Position { poses, .. } = &mut self.start;
        let all = std::mem::take(poses);
        let numbers = self
            .stored
            .iter()
            .filter_map(|&link| number_among_all(link));
        poses.extend(numbers.map(|number| all[number]));
        for node in &mut self.nodes {
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

impl Op {
    /// The number of the last pose that it reads, if it reads one.
    fn read(self) -> Option<usize> {
        match self {
            Self::Last(Slot::Pose(number, _)) => Some(number),
            _ => None,
        }
    }
}
