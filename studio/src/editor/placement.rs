//! Where links are drawn while nothing moves them: as far as it goes, where their joints want them.

use mech_compiler::model::{AxisId, Joint, JointKind, LinkId, Model};

/// A pose in scene units.
pub(crate) type Pose = mech_runtime::Pose<f64>;

/// The pose of the scene itself.
pub(crate) const SCENE: Pose = Pose { cos: 1.0, sin: 0.0, x: 0.0, y: 0.0 };

/// The pose of each link: as known, or as its joints to those that are known want it, or that of the scene.
pub(super) fn placed(model: &Model, mut known: Vec<Option<Pose>>) -> Vec<Pose> {
    known.resize(model.links.len(), None);
    known[LinkId::GROUND.index()] = Some(SCENE);
    for link in model.link_ids().filter(|link| model.link(*link).drawn) {
        known[link.index()].get_or_insert(SCENE);
    }
    // Each round places one link at least, or is the last.
    while let Some((link, pose)) = next(model, &known) {
        known[link.index()] = Some(pose);
    }
    known.into_iter().map(|pose| pose.unwrap_or(SCENE)).collect()
}

/// The poses of links after what a joint joins that is drawn apart has jumped there.
pub(super) fn closed(model: &Model, mut poses: Vec<Pose>) -> Vec<Pose> {
    let tolerance = 1e-6 * model.size();
    let (closed, open): (Vec<&Joint>, Vec<&Joint>) = model
        .joints
        .iter()
        .partition(|joint| jump(model, &poses, joint).is_none_or(|jump| jump.is_within(tolerance)));
    if !open.is_empty() {
        let mut islands = Islands((0..poses.len()).collect());
        for [a, b] in closed.iter().filter_map(|joint| links(model, joint)) {
            islands.merge(a, b);
        }
        for joint in open {
            islands.close(model, joint, &mut poses);
        }
    }
    poses
}

/// The links that a joint makes coincide somewhere.
fn links(model: &Model, joint: &Joint) -> Option<[LinkId; 2]> {
    Some(joint.kind.axes()?.map(|axis| model.axis(axis).link))
}

/// Links that are drawn together: each has the number of its island.
struct Islands(Vec<usize>);

impl Islands {
    /// Lets the second island of a joint jump to the first, or the first to the second if that has the ground.
    fn close(&mut self, model: &Model, joint: &Joint, poses: &mut [Pose]) {
        let (Some(ends), Some(jump)) = (links(model, joint), jump(model, poses, joint)) else {
            return;
        };
        let [first, second] = ends.map(|link| self.0[link.index()]);
        if first == second {
            return;
        }
        let (moved, jump) = if second == self.0[LinkId::GROUND.index()] {
            (first, jump.back())
        } else {
            (second, jump)
        };
        for (pose, island) in poses.iter_mut().zip(&self.0) {
            if *island == moved {
                *pose = jump.carry(*pose);
            }
        }
        self.merge(ends[0], ends[1]);
    }

    fn merge(&mut self, a: LinkId, b: LinkId) {
        let [to, from] = [a, b].map(|link| self.0[link.index()]);
        for island in &mut self.0 {
            if *island == from {
                *island = to;
            }
        }
    }
}

/// A link that a joint to a placed one can place.
fn next(model: &Model, known: &[Option<Pose>]) -> Option<(LinkId, Pose)> {
    model.joints.iter().find_map(|joint| {
        let [a, b] = joint.kind.axes()?;
        let link = |axis: AxisId| model.axis(axis).link;
        let [one, other] = [link(a), link(b)].map(|link| known[link.index()]);
        let turns = matches!(joint.kind, JointKind::Revolute(..));
        match (one, other) {
            (Some(pose), None) => Some((link(b), beside(model, (a, pose), b, turns))),
            (None, Some(pose)) => Some((link(a), beside(model, (b, pose), a, turns))),
            _ => None,
        }
    })
}

/// The pose of the link of an axis that coincides with one that is placed.
fn beside(model: &Model, (fixed, pose): (AxisId, Pose), axis: AxisId, turns: bool) -> Pose {
    let [cos, sin] = if turns {
        near(model, model.axis(axis).link)
    } else {
        turn(pose, model.axis(fixed).direction, model.axis(axis).direction)
    };
    let place = pose.apply(model.axis(fixed).at);
    moved([cos, sin], model.axis(axis).at, place)
}

/// The pose of this direction that takes a place to another.
fn moved([cos, sin]: [f64; 2], from: [f64; 2], to: [f64; 2]) -> Pose {
    let [x, y] = Pose { cos, sin, ..SCENE }.turn(from);
    Pose::from([cos, sin, to[0] - x, to[1] - y])
}

/// The shortest motion of the second link of a joint that closes it.
struct Jump {
    /// Where it takes the scene.
    pose: Pose,
    /// By how far the ends are apart, and turned.
    gap: [f64; 2],
}

impl Jump {
    /// Where it takes a pose.
    fn carry(&self, pose: Pose) -> Pose {
        let [cos, sin] = self.pose.turn([pose.cos, pose.sin]);
        let [x, y] = self.pose.apply([pose.x, pose.y]);
        Pose { cos, sin, x, y }
    }

    /// The motion of the first link that closes the joint.
    fn back(&self) -> Self {
        let Pose { cos, sin, .. } = self.pose;
        let [x, y] = self.pose.relative([0.0, 0.0]);
        let pose = Pose::from([cos, -sin, x, y]);
        Self { pose, ..*self }
    }

    fn is_within(&self, tolerance: f64) -> bool {
        self.gap[0] <= tolerance && self.gap[1] <= 1e-6
    }
}

/// Computes the jump that closes a joint. A sliding link keeps its place along the line.
fn jump(model: &Model, poses: &[Pose], joint: &Joint) -> Option<Jump> {
    let [(to, onto), (from, of)] = joint.kind.axes()?.map(|axis| {
        let axis = model.axis(axis);
        let pose = poses[axis.link.index()];
        (pose.apply(axis.at), pose.turn(axis.direction))
    });
    let [cos, sin] = match joint.kind {
        JointKind::Revolute(..) => [1.0, 0.0],
        _ => turn(SCENE, onto, of),
    };
    let mut way = [to[0] - from[0], to[1] - from[1]];
    if let JointKind::Prismatic(..) = joint.kind {
        let along = way[0] * onto[0] + way[1] * onto[1];
        way = [way[0] - along * onto[0], way[1] - along * onto[1]];
    }
    Some(Jump {
        pose: moved([cos, sin], from, [from[0] + way[0], from[1] + way[1]]),
        gap: [way[0].hypot(way[1]), (cos - 1.0).hypot(sin)],
    })
}

/// Where the ends of a joint are drawn: of its first link, or the nearest on its line, and of its second.
pub(super) fn ends(model: &Model, poses: &[Pose], joint: &Joint) -> Option<[[f64; 2]; 2]> {
    let axis = model.axis(joint.kind.axes()?[1]);
    let second = poses[axis.link.index()].apply(axis.at);
    let first = jump(model, poses, joint)?.pose.apply(second);
    Some([first, second])
}

/// The angle near which a link was said to start, as a direction.
fn near(model: &Model, link: LinkId) -> [f64; 2] {
    let near = model.start.near.iter().find(|near| near.link == link);
    near.map_or([1.0, 0.0], |near| [near.angle.cos(), near.angle.sin()])
}

/// The turn that brings a direction of one link onto that of another.
fn turn(pose: Pose, of: [f64; 2], onto: [f64; 2]) -> [f64; 2] {
    let [u, v] = pose.turn(of);
    [u * onto[0] + v * onto[1], v * onto[0] - u * onto[1]]
}
