//! Angles between links that are linear in the motors: what gears need, unwrapped over any number of turns.

use super::algebra::Algebra;
use crate::model::LinkId;

/// For each link the angle of its frame relative to that of another link, its root.
#[derive(Clone, Debug)]
pub(crate) struct Angles<S> {
    entries: Vec<(LinkId, S)>,
}

impl<S: Copy> Angles<S> {
    pub(crate) fn new<A: Algebra<Scalar = S>>(algebra: &mut A, links: usize) -> Self {
        let zero = algebra.constant(0.0);
        Self {
            entries: (0..links).map(|link| (LinkId::new(link), zero)).collect(),
        }
    }

    /// The angle from the frame of `from` to that of `to`, if it is known without solving a loop.
    pub(crate) fn between<A: Algebra<Scalar = S>>(
        &self,
        algebra: &mut A,
        from: LinkId,
        to: LinkId,
    ) -> Option<S> {
        let (root, start) = self.entries[from.index()];
        let (other, end) = self.entries[to.index()];
        (root == other).then(|| algebra.sub(end, start))
    }

    /// Notes that the angle from the frame of `from` to that of `to` is `angle`.
    pub(crate) fn join<A: Algebra<Scalar = S>>(
        &mut self,
        algebra: &mut A,
        from: LinkId,
        to: LinkId,
        angle: S,
    ) {
        let (root, start) = self.entries[from.index()];
        let (old, end) = self.entries[to.index()];
        if root == old {
            return;
        }
        let there = algebra.add(start, angle);
        let shift = algebra.sub(there, end);
        for entry in &mut self.entries {
            if entry.0 == old {
                *entry = (root, algebra.add(entry.1, shift));
            }
        }
    }
}
