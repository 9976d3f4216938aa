//! The kinematic graph: links are its vertices, joints its edges.

use crate::model::{JointId, LinkId, Model};
use petgraph::algo::{bridges::bridges, connected_components};
use petgraph::graph::{NodeIndex, UnGraph};
use petgraph::visit::{Dfs, EdgeRef};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// For a link with more joints than this, the joints of the other link are looked through instead.
const MANY: usize = 8;

/// The kinematic graph of a mechanism.
#[derive(Clone, Debug)]
pub(crate) struct KinematicGraph(UnGraph<LinkId, JointId>);

impl KinematicGraph {
    pub(crate) fn new(model: &Model) -> Self {
        let mut graph = UnGraph::with_capacity(model.links.len(), model.joints.len());
        for link in model.link_ids() {
            graph.add_node(link);
        }
        for joint in model.joint_ids() {
            let (a, b) = model.ends(joint);
            graph.add_edge(NodeIndex::new(a.index()), NodeIndex::new(b.index()), joint);
        }
        Self(graph)
    }

    /// The links without any joint, then the pieces that are joined in themselves but not to the ground.
    pub(crate) fn pieces_off_ground(&self) -> Vec<Vec<LinkId>> {
        if connected_components(&self.0) == 1 {
            return Vec::new();
        }
        let mut seen = vec![false; self.0.node_count()];
        let mut pieces = Vec::new();
        for start in self.0.node_indices() {
            if seen[start.index()] {
                continue;
            }
            let mut piece = Vec::new();
            let mut search = Dfs::new(&self.0, start);
            while let Some(node) = search.next(&self.0) {
                seen[node.index()] = true;
                piece.push(self.0[node]);
            }
            piece.sort();
            if piece.first() != Some(&LinkId::GROUND) {
                pieces.push(piece);
            }
        }
        pieces
    }

    /// The joints that belong to no loop: the arms.
    pub(crate) fn arms(&self) -> Vec<JointId> {
        // `bridges` is for simple graphs: two joints between the same two links are a loop.
        let alone = |a, b| self.0.edges_connecting(a, b).count() == 1;
        let mut arms: Vec<JointId> = bridges(&self.0)
            .filter(|edge| alone(edge.source(), edge.target()))
            .map(|edge| *edge.weight())
            .collect();
        arms.sort();
        arms
    }

    /// A path between two links over joints that have a level. Its highest level is as low as possible, and among such paths it is a
    /// shortest.
    pub(crate) fn path(
        &self,
        from: LinkId,
        to: LinkId,
        level: impl Fn(JointId) -> Option<usize>,
    ) -> Vec<JointId> {
        if from == to {
            return Vec::new();
        }
        if let Some(joint) = self.lowest_between(from, to, &level) {
            return vec![joint];
        }
        let mut came_by: Vec<Option<(LinkId, JointId)>> = vec![None; self.0.node_count()];
        let mut done = vec![false; self.0.node_count()];
        let mut queue = BinaryHeap::from([Reverse(((0, 0), from, None))]);
        while let Some(Reverse(((highest, length), link, by))) = queue.pop() {
            if std::mem::replace(&mut done[link.index()], true) {
                continue;
            }
            came_by[link.index()] = by;
            if link == to {
                break;
            }
            for (joint, next) in self.joints(link) {
                if let (false, Some(level)) = (done[next.index()], level(joint)) {
                    let cost = (highest.max(level), length + 1);
                    queue.push(Reverse((cost, next, Some((link, joint)))));
                }
            }
        }
        let mut path = Vec::new();
        let mut at = to;
        while let Some((previous, joint)) = came_by[at.index()] {
            path.push(joint);
            at = previous;
        }
        path.reverse();
        path
    }

    /// The joint between two links, if no other joint of one of them has a lower level: then no path can be better.
    fn lowest_between(
        &self,
        from: LinkId,
        to: LinkId,
        level: impl Fn(JointId) -> Option<usize>,
    ) -> Option<JointId> {
        let joints = |link: LinkId| self.joints(link);
        // The ground may have very many joints: the other link tells as much.
        let [near, far] = if joints(from).nth(MANY).is_some() { [to, from] } else { [from, to] };
        let known = |(joint, other)| Some((level(joint)?, joint, other));
        let lowest = joints(near).filter_map(known).map(|(level, ..)| level);
        let lowest = lowest.min()?;
        let direct = joints(near).filter_map(known);
        let direct = direct.filter(|&(level, _, other)| other == far && level == lowest);
        direct.map(|(_, joint, _)| joint).min()
    }

    /// The joints of a link, each with the link on its other side.
    pub(crate) fn joints(&self, link: LinkId) -> impl Iterator<Item = (JointId, LinkId)> + '_ {
        let edges = self.0.edges(NodeIndex::new(link.index()));
        edges.map(move |edge| {
            let other =
                if edge.source().index() == link.index() { edge.target() } else { edge.source() };
            (*edge.weight(), self.0[other])
        })
    }
}
