//! Clusters: sets of links whose relative positions are known.

use crate::bug::bug;
use crate::model::LinkId;

/// A partition of the links. A cluster is named by its base: the ground if it is in it, else its first link.
#[derive(Clone, Debug)]
pub(crate) struct Clusters {
    base: Vec<LinkId>,
}

impl Clusters {
    /// Every link by itself.
    pub(crate) fn new(links: usize) -> Self {
        Self {
            base: (0..links).map(LinkId::new).collect(),
        }
    }

    /// The base of the cluster this link is in.
    pub(crate) fn base(&self, link: LinkId) -> LinkId {
        self.base[link.index()]
    }

    /// Whether the relative position of two links is known.
    pub(crate) fn are_joined(&self, a: LinkId, b: LinkId) -> bool {
        self.base(a) == self.base(b)
    }

    /// The links of the cluster with this base.
    pub(crate) fn links(&self, base: LinkId) -> impl Iterator<Item = LinkId> + '_ {
        self.base
            .iter()
            .enumerate()
            .filter(move |(_, known)| **known == base)
            .map(|(index, _)| LinkId::new(index))
    }

    /// Merges the clusters with these bases; gives the base of the whole.
    pub(crate) fn merge(&mut self, bases: &[LinkId]) -> LinkId {
        let Some(whole) = bases.iter().copied().min() else {
            bug!("no clusters are merged");
        };
        for base in &mut self.base {
            if bases.contains(base) {
                *base = whole;
            }
        }
        whole
    }

    /// Whether everything is known.
    pub(crate) fn is_one(&self) -> bool {
        self.base.iter().all(|&base| base == LinkId::GROUND)
    }
}
