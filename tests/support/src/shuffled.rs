//! The same mechanism, declared in another order, standing on another link, or driven elsewhere.

use crate::Dice;
use mech_compiler::compile;
use mech_compiler::model::{
    Actions, Axis, AxisId, Joint, JointId, JointKind, Link, LinkId, Model, Ratio,
};

/// The same mechanism, declared in another order: links, axes, joints and motors, and the two ends of each joint. What turns round with
/// its joint, as a motor's range, is given its other sign; [`reordered`] does that with the values of motors.
///
/// # Panics
/// If the mechanism has what would have to be shuffled with it and is not: actions, traces, instances or what is shown.
#[must_use]
pub fn shuffled(model: &Model, dice: &mut Dice) -> Model {
    let bare = model.actions == Actions::default() && model.show.is_none();
    assert!(bare && model.traces.is_empty() && model.instances.is_empty());
    let order = Order::random(model, dice);
    let turned: Vec<bool> =
        model.joint_ids().map(|joint| may_turn(model, joint) && dice.once_in(2)).collect();
    let mut other = model.clone();
    for (index, old) in model.links.iter().enumerate() {
        let die = old.die.map(|axes| order.axes(axes));
        other.links[order.links[index]] = Link { die, ..old.clone() };
    }
    for (index, old) in model.axes.iter().enumerate() {
        let link = order.link(old.link);
        other.axes[order.axes[index]] = Axis { link, ..old.clone() };
    }
    for (id, old) in model.joint_ids().zip(&model.joints) {
        let mut kind = order.kind(old.kind);
        if turned[id.index()] {
            kind = turned_round(kind);
        }
        other.joints[order.joint(id).index()] = Joint { kind, ..old.clone() };
    }
    for value in &mut other.start.values {
        if turned[value.joint.index()] {
            value.value = -value.value;
        }
        value.joint = order.joint(value.joint);
    }
    for near in &mut other.start.near {
        near.link = order.link(near.link);
    }
    for joint in &mut other.continuous {
        *joint = order.joint(*joint);
    }
    for motor in &mut other.motors {
        if let Some(range) = motor.range.as_mut().filter(|_| turned[motor.joint.index()]) {
            (range.low, range.high) = (-range.high, -range.low);
        }
        motor.joint = order.joint(motor.joint);
    }
    shuffle(&mut other.motors, dice);
    other
}

/// The values of the motors of one mechanism as those of the same one in another order.
///
/// # Panics
/// If it is another mechanism.
#[must_use]
pub fn reordered(values: &[f64], from: &Model, to: &Model) -> Vec<f64> {
    let first = |model: &Model, joint: JointId| model.link(model.ends(joint).0).name.clone();
    let value = |joint: JointId| {
        let named = |id: &JointId| from.joint(*id).name == to.joint(joint).name;
        let same = from.motors.iter().map(|motor| motor.joint);
        let (place, same) = same.enumerate().find(|(_, id)| named(id)).expect("the same motors");
        if first(from, same) == first(to, joint) { values[place] } else { -values[place] }
    };
    to.motors.iter().map(|motor| value(motor.joint)).collect()
}

/// The same mechanism as drawn, standing on any of its links.
#[must_use]
pub fn on_any_ground(model: &Model, dice: &mut Dice) -> Model {
    let links: Vec<LinkId> = model.declared_links().chain([LinkId::GROUND]).collect();
    standing_on(model, *dice.pick(&links))
}

/// The same mechanism as drawn, standing on a link of its first motor that is not a die.
#[must_use]
pub fn driven_on_the_ground(model: &Model) -> Model {
    let (a, b) = model.ends(model.motors[0].joint);
    standing_on(model, if model.link(a).die.is_none() { a } else { b })
}

/// The same mechanism as drawn, standing on this link: the ground moves in its place.
fn standing_on(model: &Model, ground: LinkId) -> Model {
    let mut other = model.clone();
    let moved = |link: LinkId| match link {
        LinkId::GROUND => ground,
        link if link == ground => LinkId::GROUND,
        link => link,
    };
    for axis in &mut other.axes {
        axis.link = moved(axis.link);
    }
    for joint in &mut other.joints {
        match &mut joint.kind {
            JointKind::Gear { a, b, on, .. }
            | JointKind::Belt { a, b, on, .. }
            | JointKind::Rack { pinion: a, bar: b, on, .. } => {
                (*a, *b, *on) = (moved(*a), moved(*b), on.map(moved));
            }
            _ => {}
        }
    }
    other
}

/// The same mechanism with one of its motors on another joint, if it moves so.
#[must_use]
pub fn driven_elsewhere(model: &Model, dice: &mut Dice) -> Option<Model> {
    let can_be_driven = |joint: &JointId| {
        let Joint { kind, hidden, .. } = model.joint(*joint);
        let moves = matches!(kind, JointKind::Revolute(..) | JointKind::Prismatic(..));
        moves && !hidden && model.motor_of(*joint).is_none()
    };
    let joints: Vec<JointId> = model.joint_ids().filter(can_be_driven).collect();
    if joints.is_empty() || model.motors.is_empty() {
        return None;
    }
    let mut other = model.clone();
    other.allow.coupled = true;
    let motor = dice.below(other.motors.len());
    other.motors[motor].joint = *dice.pick(&joints);
    compile(&other).is_ok().then_some(other)
}

/// Where links, axes and joints go.
struct Order {
    links: Vec<usize>,
    axes: Vec<usize>,
    joints: Vec<usize>,
}

impl Order {
    fn random(model: &Model, dice: &mut Dice) -> Self {
        let places = |count: usize| (0..count).collect::<Vec<usize>>();
        let mut links = places(model.links.len());
        // The ground comes first, and dies after all links that are declared.
        shuffle(&mut links[1..=model.declared_links().count()], dice);
        let (mut axes, mut joints) = (places(model.axes.len()), places(model.joints.len()));
        shuffle(&mut axes, dice);
        shuffle(&mut joints, dice);
        Self { links, axes, joints }
    }

    fn link(&self, link: LinkId) -> LinkId {
        LinkId::new(self.links[link.index()])
    }

    fn joint(&self, joint: JointId) -> JointId {
        JointId::new(self.joints[joint.index()])
    }

    fn axes(&self, (a, b): (AxisId, AxisId)) -> (AxisId, AxisId) {
        let axis = |axis: AxisId| AxisId::new(self.axes[axis.index()]);
        (axis(a), axis(b))
    }

    fn kind(&self, mut kind: JointKind) -> JointKind {
        match &mut kind {
            JointKind::Revolute(a, b) | JointKind::Prismatic(a, b) | JointKind::Weld(a, b) => {
                (*a, *b) = self.axes((*a, *b));
            }
            JointKind::Gear { a, b, on, .. }
            | JointKind::Belt { a, b, on, .. }
            | JointKind::Rack { pinion: a, bar: b, on, .. } => {
                let link = |link| self.link(link);
                (*a, *b, *on) = (link(*a), link(*b), on.map(link));
            }
            JointKind::Cam { shaft, follower, .. } => {
                (*shaft, *follower) = (self.joint(*shaft), self.joint(*follower));
            }
        }
        kind
    }
}

/// Whether the ends of a joint may be exchanged: no law speaks of its coordinate, and it is no part of a slot.
fn may_turn(model: &Model, joint: JointId) -> bool {
    let mut lawful = model
        .motors
        .iter()
        .filter(|motor| motor.law.is_some())
        .map(|motor| motor.joint)
        .chain(model.cams().flat_map(|(_, shaft, follower, _)| [shaft, follower]));
    let (a, b) = model.ends(joint);
    let in_slot = [a, b].iter().any(|&link| model.link(link).die.is_some());
    !in_slot && !lawful.any(|other| other == joint)
}

/// A joint with its ends exchanged.
fn turned_round(kind: JointKind) -> JointKind {
    let exchanged = |ratio| match ratio {
        Ratio::Teeth(a, b) => Ratio::Teeth(b, a),
        Ratio::Radii(a, b) => Ratio::Radii(b, a),
    };
    match kind {
        JointKind::Revolute(a, b) => JointKind::Revolute(b, a),
        JointKind::Prismatic(a, b) => JointKind::Prismatic(b, a),
        JointKind::Weld(a, b) => JointKind::Weld(b, a),
        JointKind::Gear { a, b, ratio, on } => {
            JointKind::Gear { a: b, b: a, ratio: exchanged(ratio), on }
        }
        JointKind::Belt { a, b, ratio, on } => {
            JointKind::Belt { a: b, b: a, ratio: exchanged(ratio), on }
        }
        kind @ (JointKind::Rack { .. } | JointKind::Cam { .. }) => kind,
    }
}

/// Puts these in any order.
pub fn shuffle<T>(values: &mut [T], dice: &mut Dice) {
    for index in (1..values.len()).rev() {
        values.swap(index, dice.below(index + 1));
    }
}
