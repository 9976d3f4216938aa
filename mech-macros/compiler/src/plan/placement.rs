//! Where the links are, cluster by cluster, while the steps are followed.

use super::algebra::{Algebra, Pose, are_equal};
use super::cluster::Clusters;
use super::step::{Connection, ConnectionKind};
use super::tree::{Joining, Leg, Route, Tree};
use super::unknown::Solution;
use crate::bug::bug;
use crate::model::{Axis, AxisId, JointId, JointKind, LinkId, Model};

/// The vector between two axes that are equally far from a pin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Chord<S> {
    pub(crate) vector: [S; 2],
    /// A vector at right angles to it. Where the axes nearly meet, its length is one.
    pub(crate) across: [S; 2],
}

/// The poses of all links, each relative to the base of its cluster.
#[derive(Clone, Debug)]
pub(crate) struct Placement<'m, S> {
    pub(crate) model: &'m Model,
    pub(crate) clusters: Clusters,
    poses: Vec<Pose<S>>,
    /// Along which joints each cluster was brought together.
    tree: Tree<S>,
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
            tree: Tree::new(model.links.len()),
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
            bug!("joint `{}` does not slide and is asked how far it did", joint.name);
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
        if self.are_far_off(algebra, from, to) == Some(true) {
            return self.add_up(algebra, &self.route(from, to).legs);
        }
        let (start, end) = (self.spot(algebra, from), self.spot(algebra, to));
        algebra.minus(end, start)
    }

    /// The vector between two axes that are equally far from the pin on which their links turn; none if they are not. Where the axes meet, only
    /// rounding is left of the difference of their legs. But it is at right angles to the sum of these: what is not so is taken away.
    pub(crate) fn chord(
        &self,
        algebra: &mut impl Algebra<S>,
        from: AxisId,
        to: AxisId,
    ) -> Option<Chord<S>> {
        let route = self.route(from, to);
        let [Leg::Within(_, pin), Leg::Over(joining, _), Leg::Within(other, _)] = route.legs[..]
        else {
            return None;
        };
        let axes = [from, pin, other, to].map(|axis| self.axis(axis));
        let length = |[a, b]: [&Axis; 2]| f64::hypot(b.at[0] - a.at[0], b.at[1] - a.at[1]);
        let [a, b] = [length([axes[0], axes[1]]), length([axes[2], axes[3]])];
        let alike = a > 0.0 && are_equal(a, b, self.model.precision.epsilon());
        if joining.displacement.is_some() || axes.iter().any(|axis| axis.varies()) || !alike {
            return None;
        }
        let (to_pin, from_pin) = (self.span(algebra, from, pin), self.span(algebra, other, to));
        let sum = algebra.plus(to_pin, from_pin);
        let difference = algebra.minus(from_pin, to_pin);
        let scale = algebra.constant(0.5 / a);
        let across = algebra.scale(scale, difference);
        let off = algebra.dot(sum, across);
        let off = algebra.scale(off, across);
        Some(Chord { vector: algebra.minus(sum, off), across })
    }

    /// Whether two axes of a cluster are much farther from its base, or from the origins of their links, than from each other, or may come so
    /// far: then the vector between them is no difference of places, which rounding would shift. None for axes that always lie on each other.
    pub(crate) fn are_far_off(
        &self,
        algebra: &impl Algebra<S>,
        from: AxisId,
        to: AxisId,
    ) -> Option<bool> {
        /// So many times farther.
        const FAR: f64 = 16.0;
        let route = self.route(from, to);
        if route.carriers.iter().any(|joining| self.travels(joining)) {
            return Some(true);
        }
        let length = |leg: &Leg<S>| match *leg {
            Leg::Within(a, b) => {
                let [[a, b], [c, d]] = [a, b].map(|axis| self.axis(axis).at);
                f64::hypot(c - a, d - b)
            }
            Leg::Over(joining, _) => {
                let displacement = joining.displacement;
                displacement.map_or(0.0, |slid| algebra.number_at_start(slid).abs())
            }
        };
        let near: f64 = route.legs.iter().map(length).sum();
        let far = [from, to].map(|axis| {
            let axis = self.axis(axis);
            let [x, y] = self.pose(axis.link).origin;
            let [x, y] = [x, y].map(|part| algebra.number_at_start(part));
            x.hypot(y) + axis.at[0].hypot(axis.at[1])
        });
        (near > 0.0).then_some(far[0].max(far[1]) > FAR * near)
    }

    fn route(&self, from: AxisId, to: AxisId) -> Route<S> {
        let [start, end] = [from, to].map(|axis| (self.axis(axis).link, axis));
        self.tree.route(start, end)
    }

    /// Whether a joint may slide any distance: its motor has no range.
    fn travels(&self, joining: &Joining<S>) -> bool {
        let motor = self.model.motor_of(joining.connection.joint);
        joining.displacement.is_some()
            && motor.is_some_and(|motor| self.model.motor(motor).range.is_none())
    }

    /// The sum of the legs of a way.
    fn add_up(&self, algebra: &mut impl Algebra<S>, legs: &[Leg<S>]) -> [S; 2] {
        let mut sum: Option<[S; 2]> = None;
        for leg in legs {
            let part = match *leg {
                Leg::Within(a, b) if a == b => continue,
                Leg::Within(a, b) => self.span(algebra, a, b),
                Leg::Over(joining, forwards) => {
                    let Some(displacement) = joining.displacement else {
                        continue;
                    };
                    let [x, y] = self.heading(algebra, joining.connection.from);
                    let along = if forwards { [x, y] } else { [algebra.neg(x), algebra.neg(y)] };
                    algebra.scale(displacement, along)
                }
            };
            sum = Some(sum.map_or(part, |sum| algebra.plus(sum, part)));
        }
        sum.unwrap_or_else(|| algebra.vector([0.0, 0.0]))
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
        self.hang(algebra, connection.from, to.link, [meeting, spot], direction);
        let displacement = match coordinate {
            Solution::Direction(_) => None,
            Solution::Slide(displacement) => Some(displacement),
        };
        self.hold(connection, displacement);
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
        self.hold(connection, None);
    }

    /// Notes what a connection has brought together, and how far it slides.
    fn hold(&mut self, connection: Connection, displacement: Option<S>) {
        let links = [connection.from, connection.to].map(|axis| self.axis(axis).link);
        let joining = Joining { connection, displacement };
        self.tree.join(links, joining);
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
        let base = if come == link { pose } else { pose.then(algebra, seen_from_link) };
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
            self.poses[link.index()] = if link == base { pose } else { pose.then(algebra, old) };
        }
    }
}
