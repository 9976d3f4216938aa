//! Clusters: sets of links whose relative positions are known.

use crate::bug::bug;
use crate::model::LinkId;

/// A partition of the links. A cluster is named by its base: the ground if it is in it, else its first link.
#[derive(Clone, Debug)]
pub(crate) struct Clusters {
    base: Vec<LinkId>,
    /// For each link the next one round its cluster, so that none is looked through to find the links of another.
    next: Vec<LinkId>,
}

impl Clusters {
    /// Every link by itself.
    pub(crate) fn new(links: usize) -> Self {
        let base: Vec<LinkId> = (0..links).map(LinkId::new).collect();
        Self { next: base.clone(), base }
    }

    /// The base of the cluster this link is in.
    pub(crate) fn base(&self, link: LinkId) -> LinkId {
        self.base[link.index()]
    }

    /// Whether the relative position of two links is known.
    pub(crate) fn are_joined(&self, a: LinkId, b: LinkId) -> bool {
        self.base(a) == self.base(b)
    }

    /// The links of the cluster with this base, in their order.
    pub(crate) fn links(&self, base: LinkId) -> Vec<LinkId> {
        let mut links = vec![base];
        let mut link = self.next[base.index()];
        while link != base {
            links.push(link);
            link = self.next[link.index()];
        }
        links.sort_unstable();
        links
    }

    /// Merges the clusters with these bases; gives the base of the whole.
    pub(crate) fn merge(&mut self, bases: &[LinkId]) -> LinkId {
        let Some(whole) = bases.iter().copied().min() else {
            bug!("no clusters are merged");
        };
        for &base in bases {
            // One that stands there twice is in it already.
            if self.base(base) != whole {
                for link in self.links(base) {
                    self.base[link.index()] = whole;
                }
                self.next.swap(whole.index(), base.index());
            }
        }
        whole
    }

    /// Whether everything is known.
    pub(crate) fn is_one(&self) -> bool {
        self.base.iter().all(|&base| base == LinkId::GROUND)
    }
}
