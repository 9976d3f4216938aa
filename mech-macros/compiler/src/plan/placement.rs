//! Where the links are, cluster by cluster, while the steps are followed.

use super::algebra::{Algebra, Pose};
use super::cluster::Clusters;
use super::step::{Connection, ConnectionKind};
use crate::bug::bug;
use crate::model::{Axis, AxisId, JointId, JointKind, LinkId, Model};

/// The coordinate of a connection.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Coordinate<S> {
    /// The cosine and sine of an angle.
    Turn([S; 2]),
    /// A length.
    Slide(S),
}

/// The poses of all links, each relative to the base of its cluster.
#[derive(Clone, Debug)]
pub(crate) struct Placement<'m, S> {
    pub(crate) model: &'m Model,
    pub(crate) clusters: Clusters,
    poses: Vec<Pose<S>>,
}

impl<'m, S: Copy> Placement<'m, S> {
    /// Nothing is known but each link to itself.
    pub(crate) fn new<A: Algebra<Scalar = S>>(algebra: &mut A, model: &'m Model) -> Self {
        let identity = Pose::identity(algebra);
        Self {
            model,
            clusters: Clusters::new(model.links.len()),
            poses: vec![identity; model.links.len()],
        }
    }

    /// The pose of a link relative to the base of its cluster.
    pub(crate) fn pose(&self, link: LinkId) -> Pose<S> {
        self.poses[link.index()]
    }

    pub(crate) fn axis(&self, id: AxisId) -> &'m Axis {
        self.model.axis(id)
    }

    /// Whether a sliding connection is walked in the direction in which its joint was declared.
    pub(crate) fn as_declared(&self, connection: Connection) -> bool {
        matches!(self.model.joint(connection.joint).kind, JointKind::Prismatic(from, _) if from == connection.from)
    }

    /// The coordinate of a sliding joint whose links are in one cluster.
    pub(crate) fn sliding_coordinate<A: Algebra<Scalar = S>>(
        &self,
        algebra: &mut A,
        joint: JointId,
    ) -> S {
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

    /// The base of the cluster in which an axis is.
    pub(crate) fn base(&self, axis: AxisId) -> LinkId {
        self.clusters.base(self.axis(axis).link)
    }

    /// The origin of an axis, relative to the base of its cluster.
    pub(crate) fn spot<A: Algebra<Scalar = S>>(&self, algebra: &mut A, id: AxisId) -> [S; 2] {
        let axis = self.axis(id);
        self.pose(axis.link).carry(algebra, axis)
    }

    /// The direction of an axis, relative to the base of its cluster.
    pub(crate) fn heading<A: Algebra<Scalar = S>>(&self, algebra: &mut A, id: AxisId) -> [S; 2] {
        let axis = self.axis(id);
        self.pose(axis.link).heading(algebra, axis)
    }

    /// The way from one axis to another in the same cluster, relative to its base.
    pub(crate) fn span<A: Algebra<Scalar = S>>(
        &self,
        algebra: &mut A,
        from: AxisId,
        to: AxisId,
    ) -> [S; 2] {
        let (start, end) = (self.axis(from), self.axis(to));
        if start.link == end.link {
            // Only to be turned: it is what it is in the link.
            let span = algebra.between(start, end);
            return algebra.turned(self.pose(start.link).direction, span);
        }
        let (start, end) = (self.spot(algebra, from), self.spot(algebra, to));
        algebra.minus(end, start)
    }

    /// Brings two clusters together over a connection of known coordinate.
    pub(crate) fn connect<A: Algebra<Scalar = S>>(
        &mut self,
        algebra: &mut A,
        connection: Connection,
        coordinate: Coordinate<S>,
    ) {
        let heading = self.heading(algebra, connection.from);
        let spot = self.spot(algebra, connection.from);
        let (facing, meeting) = match coordinate {
            Coordinate::Turn(turn) => (algebra.turned(heading, turn), spot),
            Coordinate::Slide(displacement) => {
                let offset = algebra.scaled(displacement, heading);
                (heading, algebra.plus(spot, offset))
            }
        };
        let own = algebra.mirrored_direction(self.axis(connection.to));
        let direction = algebra.turned(facing, own);
        self.hang(algebra, connection, meeting, direction);
    }

    /// Puts the second link of a connection so that it points in this direction and its axis lies at `meeting`.
    fn hang<A: Algebra<Scalar = S>>(
        &mut self,
        algebra: &mut A,
        connection: Connection,
        meeting: [S; 2],
        direction: [S; 2],
    ) {
        let to = self.axis(connection.to);
        let at = algebra.place(to);
        let arm = algebra.turned(direction, at);
        let origin = algebra.minus(meeting, arm);
        self.put(
            algebra,
            self.axis(connection.from).link,
            to.link,
            Pose { direction, origin },
        );
    }

    /// Brings two clusters together over a revolute connection, with the direction of the second cluster's base, relative
    /// to the first's, known.
    pub(crate) fn pivot<A: Algebra<Scalar = S>>(
        &mut self,
        algebra: &mut A,
        connection: Connection,
        direction: [S; 2],
    ) {
        debug_assert_eq!(connection.kind, ConnectionKind::Revolute);
        let meeting = self.spot(algebra, connection.from);
        let spot = self.spot(algebra, connection.to);
        let arm = algebra.turned(direction, spot);
        let origin = algebra.minus(meeting, arm);
        let base = self.base(connection.to);
        self.put(
            algebra,
            self.axis(connection.from).link,
            base,
            Pose { direction, origin },
        );
    }

    /// Merges the cluster of `link` into that of `beside`, `link` being at `pose` relative to the base of the latter.
    fn put<A: Algebra<Scalar = S>>(
        &mut self,
        algebra: &mut A,
        beside: LinkId,
        link: LinkId,
        pose: Pose<S>,
    ) {
        let (stay, come) = (self.clusters.base(beside), self.clusters.base(link));
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

    fn move_cluster<A: Algebra<Scalar = S>>(
        &mut self,
        algebra: &mut A,
        base: LinkId,
        pose: Pose<S>,
    ) {
        let links: Vec<LinkId> = self.clusters.links(base).collect();
        for link in links {
            let old = self.poses[link.index()];
            self.poses[link.index()] = if link == base {
                pose
            } else {
                pose.then(algebra, old)
            };
        }
    }
}
