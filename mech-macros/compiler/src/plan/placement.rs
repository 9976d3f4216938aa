//! Where the links are, cluster by cluster, while the steps are followed.

use super::algebra::{Algebra, Pose};
use super::cluster::Clusters;
use super::equation::Solution;
use super::step::{Connection, ConnectionKind};
use crate::bug::bug;
use crate::model::{Axis, AxisId, JointId, JointKind, LinkId, Model};

/// The poses of all links, each relative to the base of its cluster.
#[derive(Clone, Debug)]
pub(crate) struct Placement<'m, S> {
    pub(crate) model: &'m Model,
    pub(crate) clusters: Clusters,
    poses: Vec<Pose<S>>,
    /// The links that have moved in their cluster's frame since they were last asked for.
    moved: Vec<LinkId>,
}

impl<'m, S: Copy> Placement<'m, S> {
    /// Knows no relative position yet: each link is a cluster of its own.
    pub(crate) fn new(algebra: &mut impl Algebra<S>, model: &'m Model) -> Self {
        let identity = Pose::identity(algebra);
        Self {
            model,
            clusters: Clusters::new(model.links.len()),
            poses: vec![identity; model.links.len()],
            moved: Vec::new(),
        }
    }

    /// The pose of a link relative to the base of its cluster.
    pub(crate) fn pose(&self, link: LinkId) -> Pose<S> {
        self.poses[link.index()]
    }

    pub(crate) fn axis(&self, id: AxisId) -> &'m Axis {
        self.model.axis(id)
    }

    /// Whether a sliding connection leads from the first axis of its joint to the second.
    pub(crate) fn as_declared(&self, connection: Connection) -> bool {
        matches!(self.model.joint(connection.joint).kind, JointKind::Prismatic(from, _) if from == connection.from)
    }

    /// The coordinate of a sliding joint whose links are in one cluster.
    pub(crate) fn sliding_coordinate(&self, algebra: &mut impl Algebra<S>, joint: JointId) -> S {
        let joint = self.model.joint(joint);
        let JointKind::Prismatic(from, to) = joint.kind else {
            bug!(
                "joint `{}` does not slide and is asked how far it did",
                joint.name
            );
        };
        let heading = self.heading(algebra, from);
        let span = self.span(algebra, from, to);
        algebra.dot(heading, span)
    }

    /// The links whose poses have changed since this was last asked, in order: a step asks for them, so that it looks at no other.
    pub(crate) fn take_moved(&mut self) -> Vec<LinkId> {
        let mut moved = std::mem::take(&mut self.moved);
        moved.sort_unstable();
        moved.dedup();
        moved
    }

    /// The base of the cluster in which an axis is.
    pub(crate) fn base(&self, axis: AxisId) -> LinkId {
        self.clusters.base(self.axis(axis).link)
    }

    /// The origin of an axis, relative to the base of its cluster.
    pub(crate) fn spot(&self, algebra: &mut impl Algebra<S>, id: AxisId) -> [S; 2] {
        let axis = self.axis(id);
        self.pose(axis.link).carry(algebra, axis)
    }

    /// The direction of an axis, relative to the base of its cluster.
    pub(crate) fn heading(&self, algebra: &mut impl Algebra<S>, id: AxisId) -> [S; 2] {
        let axis = self.axis(id);
        self.pose(axis.link).heading(algebra, axis)
    }

    /// The vector from one axis to another in the same cluster, relative to its base.
    pub(crate) fn span(&self, algebra: &mut impl Algebra<S>, from: AxisId, to: AxisId) -> [S; 2] {
        let (start, end) = (self.axis(from), self.axis(to));
        if start.link == end.link {
            // Only to be turned: it is what it is in the link.
            let span = algebra.between(start, end);
            return algebra.rotate(self.pose(start.link).direction, span);
        }
        let (start, end) = (self.spot(algebra, from), self.spot(algebra, to));
        algebra.minus(end, start)
    }

    /// Brings two clusters together over a connection of known coordinate: the cosine and sine of an angle, or a length.
    pub(crate) fn connect(
        &mut self,
        algebra: &mut impl Algebra<S>,
        connection: Connection,
        coordinate: Solution<S>,
    ) {
        let heading = self.heading(algebra, connection.from);
        let spot = self.spot(algebra, connection.from);
        let (facing, meeting) = match coordinate {
            Solution::Direction(turn) => (algebra.rotate(heading, turn), spot),
            Solution::Slide(displacement) => {
                let offset = algebra.scale(displacement, heading);
                (heading, algebra.plus(spot, offset))
            }
        };
        let to = self.axis(connection.to);
        let own = algebra.mirrored_direction(to);
        let direction = algebra.rotate(facing, own);
        let spot = algebra.place(to);
        self.hang(
            algebra,
            connection.from,
            to.link,
            [meeting, spot],
            direction,
        );
    }

    /// Brings two clusters together over a revolute connection, with the direction of the second cluster's base, relative
    /// to the first's, known.
    pub(crate) fn pivot(
        &mut self,
        algebra: &mut impl Algebra<S>,
        connection: Connection,
        direction: [S; 2],
    ) {
        debug_assert_eq!(connection.kind, ConnectionKind::Revolute);
        let meeting = self.spot(algebra, connection.from);
        let spot = self.spot(algebra, connection.to);
        let base = self.base(connection.to);
        self.hang(algebra, connection.from, base, [meeting, spot], direction);
    }

    /// Merges the cluster of `link` into that of an axis: there the link points in this direction, and the spot, which is given in the link,
    /// lies at `meeting`.
    fn hang(
        &mut self,
        algebra: &mut impl Algebra<S>,
        from: AxisId,
        link: LinkId,
        [meeting, spot]: [[S; 2]; 2],
        direction: [S; 2],
    ) {
        let arm = algebra.rotate(direction, spot);
        let origin = algebra.minus(meeting, arm);
        let pose = Pose { direction, origin };
        let (stay, come) = (self.base(from), self.clusters.base(link));
        let seen_from_link = self.pose(link).inverse(algebra);
        let base = if come == link {
            pose
        } else {
            pose.then(algebra, seen_from_link)
        };
        if stay < come {
            self.move_cluster(algebra, come, base);
        } else {
            let back = base.inverse(algebra);
            self.move_cluster(algebra, stay, back);
        }
        self.clusters.merge(&[stay, come]);
    }

    fn move_cluster(&mut self, algebra: &mut impl Algebra<S>, base: LinkId, pose: Pose<S>) {
        for link in self.clusters.links(base) {
            self.moved.push(link);
            let old = self.poses[link.index()];
            self.poses[link.index()] = if link == base {
                pose
            } else {
                pose.then(algebra, old)
            };
        }
    }
}
