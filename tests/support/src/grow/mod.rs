//! Random mechanisms, grown from dyads, gears and arms, so that the truth about them is known by construction: they are
//! coherent and sequential, with as many loops as there are dyads.

mod coupled;
mod wild;

use crate::{Dice, add_axis, on_any_ground, shuffled};
pub use coupled::{grow_coupled, grow_coupled_from};
use mech_compiler::model::{
    Axis, AxisId, AxisKind, Joint, JointId, JointKind, Link, LinkId, Model, Motor, Near, Origin,
    Ratio, StartValue,
};
use mech_compiler::plan::{self, Step};
use mech_compiler::structure;
use std::cmp::Ordering;
use std::collections::BTreeSet;
pub use wild::grow_wild;

/// A mechanism and what is known about it.
#[derive(Clone, Debug)]
pub struct Grown {
    /// The mechanism, as drawn: every link's frame is the scene's at the start.
    pub model: Model,
    /// How many loops of three unknowns it has.
    pub loops: usize,
    /// How many gears it has.
    pub gears: usize,
    /// How many joints belong to no loop.
    pub arms: usize,
    /// Whether dyads have equal pairs.
    has_equals: bool,
    /// Slots that are still to be added.
    slots: Vec<(AxisId, AxisId)>,
}

type Point = [f64; 2];

/// The least sine of the transmission angle at the start: well away from any dead point.
const LEAST_SINE: f64 = 0.3;

/// Grows a mechanism: a motor, then as many additions as asked for. It stands on any of its links, and is declared in any order.
#[must_use]
pub fn grow(dice: &mut Dice, additions: usize) -> Grown {
    let mut grown = Grown::new(dice, false);
    for _ in 0..additions {
        grown.add(dice);
    }
    grown.finish(dice)
}

/// Grows a mechanism as [`grow`] does, each of whose additions draws from dice of its own: it stays when another is left out.
#[must_use]
pub fn grow_from(motor: &mut Dice, additions: &[Dice]) -> Grown {
    let mut grown = Grown::new(motor, false);
    for addition in additions {
        grown.add(&mut addition.clone());
    }
    grown.finish(motor)
}

impl Grown {
    /// A motor on the ground.
    fn new(dice: &mut Dice, coupled: bool) -> Self {
        let mut model = Model::new("Grown", Origin::default());
        model.allow.coupled = coupled;
        let mut grown = Self {
            model,
            loops: 0,
            gears: 0,
            arms: 0,
            has_equals: dice.once_in(4),
            slots: Vec::new(),
        };
        grown.arm(dice, LinkId::GROUND);
        grown
    }

    /// Adds anything that is solved loop by loop.
    fn add(&mut self, dice: &mut Dice) {
        match dice.below(12) {
            0 => {
                let base = self.any_link(dice);
                self.arm(dice, base);
            }
            1 => self.gear(dice),
            2 => self.belt(dice),
            3 => self.weld(dice),
            4 => self.slotted(dice),
            _ => self.dyad(dice),
        }
    }

    /// Adds what has to come last, and then forgets in which order it has grown, and on what it stood.
    fn finish(mut self, dice: &mut Dice) -> Self {
        // Dies come after all links that are declared.
        for (point, line) in std::mem::take(&mut self.slots) {
            let name = format!("j{}", self.model.joints.len());
            self.model.add_slot(&name, Origin::default(), point, line);
        }
        self.model = shuffled(&on_any_ground(&self.model, dice), dice);
        self.count_arms();
        self
    }

    fn any_link(&self, dice: &mut Dice) -> LinkId {
        LinkId::new(dice.below(self.model.links.len()))
    }

    fn link(&mut self) -> LinkId {
        let id = LinkId::new(self.model.links.len());
        let mut link = Link::new(&format!("l{}", id.index()), Origin::default());
        link.drawn = true;
        self.model.links.push(link);
        id
    }

    fn axis(&mut self, link: LinkId, kind: AxisKind, at: Point, direction: Point) -> AxisId {
        add_axis(&mut self.model, link, kind, at, direction)
    }

    fn joint(&mut self, kind: JointKind) -> JointId {
        let id = JointId::new(self.model.joints.len());
        self.model.joints.push(Joint {
            name: format!("j{}", id.index()),
            origin: Origin::default(),
            kind,
            hidden: false,
        });
        id
    }

    fn revolute(&mut self, a: LinkId, b: LinkId, at: Point) -> JointId {
        let a = self.axis(a, AxisKind::Point, at, [1.0, 0.0]);
        let b = self.axis(b, AxisKind::Point, at, [1.0, 0.0]);
        self.joint(JointKind::Revolute(a, b))
    }

    fn prismatic(&mut self, a: LinkId, b: LinkId, at: Point, along: Point) -> JointId {
        let a = self.axis(a, AxisKind::Line, at, along);
        let b = self.axis(b, AxisKind::Line, at, along);
        self.joint(JointKind::Prismatic(a, b))
    }

    /// A link on a motor.
    fn arm(&mut self, dice: &mut Dice, base: LinkId) {
        let link = self.link();
        let at = point(dice);
        let joint = if dice.once_in(4) {
            self.prismatic(base, link, at, direction(dice))
        } else {
            self.revolute(base, link, at)
        };
        self.model.motors.push(Motor::new(joint, Origin::default()));
    }

    /// A link that is one with another.
    fn weld(&mut self, dice: &mut Dice) {
        let base = self.any_link(dice);
        let link = self.link();
        let at = point(dice);
        let a = self.axis(base, AxisKind::Point, at, [1.0, 0.0]);
        let b = self.axis(link, AxisKind::Point, at, [1.0, 0.0]);
        self.joint(JointKind::Weld(a, b));
    }

    /// A link that turns on one link and whose pin slides in a slot of another.
    fn slotted(&mut self, dice: &mut Dice) {
        let (first, second) = (self.any_link(dice), self.any_link(dice));
        let (p, q, d) = (point(dice), point(dice), direction(dice));
        if first == second || !well_placed("RPR", [p, q, q], [d, d]) {
            return self.slotted(dice);
        }
        let link = self.link();
        self.revolute(first, link, p);
        let pin = self.axis(link, AxisKind::Point, q, [1.0, 0.0]);
        let line = self.axis(second, AxisKind::Line, q, d);
        self.slots.push((pin, line));
        self.loops += 1;
    }

    /// A wheel that a belt drives.
    fn belt(&mut self, dice: &mut Dice) {
        self.rolling(dice, |dice, a, b| JointKind::Belt {
            a,
            b,
            ratio: Ratio::Radii(dice.between(0.3, 2.0), 1.0),
            on: None,
        });
    }

    /// A wheel that a gear drives.
    fn gear(&mut self, dice: &mut Dice) {
        self.rolling(dice, |dice, a, b| {
            let teeth = [12, 17, 20, 31, 40, 60];
            let (own, other) = (*dice.pick(&teeth), *dice.pick(&teeth));
            let is_internal = dice.once_in(3);
            // The ring is the larger.
            let ratio = match (is_internal, own.cmp(&other)) {
                (true, Ordering::Less) => Ratio::Teeth(own, -other),
                (true, Ordering::Greater) => Ratio::Teeth(-own, other),
                _ => Ratio::Teeth(own, other),
            };
            JointKind::Gear { a, b, ratio, on: None }
        });
    }

    /// A wheel driven by a link that turns on another.
    fn rolling(&mut self, dice: &mut Dice, kind: impl Fn(&mut Dice, LinkId, LinkId) -> JointKind) {
        let turning = |joint: &Joint| match joint.kind {
            JointKind::Revolute(a, b) => Some((self.model.axis(a).link, self.model.axis(b).link)),
            _ => None,
        };
        let pairs: Vec<(LinkId, LinkId)> = self.model.joints.iter().filter_map(turning).collect();
        if pairs.is_empty() {
            return;
        }
        let (mut carrier, mut wheel) = *dice.pick(&pairs);
        if dice.once_in(2) {
            (carrier, wheel) = (wheel, carrier);
        }
        let driven = self.link();
        let at = point(dice);
        let (a, b) = if dice.once_in(2) { (carrier, driven) } else { (driven, carrier) };
        self.revolute(a, b, at);
        let (a, b) = if dice.once_in(2) { (wheel, driven) } else { (driven, wheel) };
        let kind = kind(dice, a, b);
        self.joint(kind);
        self.gears += 1;
    }

    /// Two links, joined to each other and to two that are there.
    fn dyad(&mut self, dice: &mut Dice) {
        let first = self.any_link(dice);
        let second = self.any_link(dice);
        if first == second {
            return self.dyad(dice);
        }
        let kinds = *dice.pick(&["RRR", "RRR", "RRP", "RPR", "PRR", "PRP", "RPP", "PPR"]);
        let (p, mut q, r) = (point(dice), point(dice), point(dice));
        let (d, e) = (direction(dice), direction(dice));
        if self.has_equals && kinds == "RRR" {
            q = self.equal(dice, [first, second], [p, r]);
        }
        if !well_placed(kinds, [p, q, r], [d, e]) {
            return self.dyad(dice);
        }
        let (a, b) = (self.link(), self.link());
        match kinds {
            "RRP" => {
                self.revolute(first, a, p);
                self.revolute(a, b, q);
                self.prismatic(second, b, r, d);
            }
            "RPR" => {
                self.revolute(first, a, p);
                self.prismatic(a, b, r, d);
                self.revolute(b, second, q);
            }
            "PRR" => {
                self.prismatic(a, first, r, d);
                self.revolute(a, b, p);
                self.revolute(second, b, q);
            }
            "PRP" => {
                self.prismatic(first, a, p, d);
                self.revolute(a, b, q);
                self.prismatic(second, b, r, e);
            }
            "RPP" => {
                self.revolute(first, a, p);
                self.prismatic(b, a, q, d);
                self.prismatic(second, b, r, e);
            }
            "PPR" => {
                self.prismatic(a, first, p, d);
                self.prismatic(a, b, q, e);
                self.revolute(b, second, r);
            }
            _ => {
                self.revolute(first, a, p);
                self.revolute(b, a, q);
                self.revolute(second, b, r);
            }
        }
        self.loops += 1;
    }

    /// Where the middle pin of a dyad makes equal pairs: of an isosceles triangle; and where its ends have a pin in common, of a parallelogram
    /// or of a kite.
    fn equal(&self, dice: &mut Dice, [first, second]: [LinkId; 2], [p, r]: [Point; 2]) -> Point {
        let joins = |joint: &&Joint| match joint.kind {
            JointKind::Revolute(a, b) => {
                let links = [a, b].map(|axis| self.model.axis(axis).link);
                links == [first, second] || links == [second, first]
            }
            _ => false,
        };
        let common = self.model.joints.iter().find(joins);
        let common = common.and_then(|joint| joint.kind.axes());
        let along = [r[0] - p[0], r[1] - p[1]];
        match common.map(|[axis, _]| self.model.axis(axis).at) {
            Some([x, y]) if dice.once_in(2) => [p[0] + r[0] - x, p[1] + r[1] - y],
            Some([x, y]) => {
                // Its mirror image in the line through both ends.
                let square = along[0] * along[0] + along[1] * along[1];
                let off = along[0] * (y - p[1]) - along[1] * (x - p[0]);
                let back = 2.0 * off / square;
                [x + back * along[1], y - back * along[0]]
            }
            None => {
                let height = dice.between(-1.5, 1.5);
                [
                    p[0] + 0.5 * along[0] - height * along[1],
                    p[1] + 0.5 * along[1] + height * along[0],
                ]
            }
        }
    }

    /// Joints whose removal disconnects the mechanism, found by the slow and obvious method.
    fn count_arms(&mut self) {
        let parts = |without: usize| {
            let mut group: Vec<usize> = (0..self.model.links.len()).collect();
            for id in self.model.joint_ids().filter(|id| id.index() != without) {
                let (a, b) = self.model.ends(id);
                let (a, b) = (group[a.index()], group[b.index()]);
                group.iter_mut().filter(|entry| **entry == b).for_each(|entry| *entry = a);
            }
            group.sort_unstable();
            group.dedup();
            group.len()
        };
        self.arms = (0..self.model.joints.len()).filter(|&joint| parts(joint) > 1).count();
    }
}

fn point(dice: &mut Dice) -> Point {
    [dice.between(-5.0, 5.0), dice.between(-5.0, 5.0)]
}

fn direction(dice: &mut Dice) -> Point {
    let (sin, cos) = dice.between(-3.1, 3.1).sin_cos();
    [cos, sin]
}

/// Whether a dyad is well away from its dead points, by its determinant (twists about the origin).
fn well_placed(kinds: &str, [p, q, r]: [Point; 3], [d, e]: [Point; 2]) -> bool {
    let minus = |a: Point, b: Point| [a[0] - b[0], a[1] - b[1]];
    let cross = |a: Point, b: Point| a[0] * b[1] - a[1] * b[0];
    let length = |a: Point| a[0].hypot(a[1]);
    let along = |a: Point, d: Point| (a[0] * d[0] + a[1] * d[1]).abs() / length(a);
    match kinds {
        "RRR" => {
            let (u, v) = (minus(q, p), minus(r, q));
            length(u) > 0.5
                && length(v) > 0.5
                && cross(u, v).abs() > LEAST_SINE * length(u) * length(v)
        }
        "RRP" | "RPR" | "PRR" => length(minus(q, p)) > 0.5 && along(minus(q, p), d) > LEAST_SINE,
        _ => cross(d, e).abs() > LEAST_SINE,
    }
}

/// The same mechanism with every link given in a frame of its own, and a start that says how it is assembled: `poses` are
/// where the links then are.
#[must_use]
pub fn in_own_frames(model: &Model, dice: &mut Dice) -> (Model, Vec<[f64; 4]>) {
    let mut own = model.clone();
    let angles: Vec<f64> = model
        .link_ids()
        .map(|link| if link == LinkId::GROUND { 0.0 } else { dice.between(-3.0, 3.0) })
        .collect();
    let poses: Vec<[f64; 4]> = model
        .link_ids()
        .map(|link| {
            let (sin, cos) = angles[link.index()].sin_cos();
            let [x, y] = if link == LinkId::GROUND { [0.0; 2] } else { point(dice) };
            [cos, sin, x, y]
        })
        .collect();
    let welded = |id: usize| {
        let on = |joint: &Joint| matches!(joint.kind, JointKind::Weld(a, b) if a.index() == id || b.index() == id);
        model.joints.iter().any(on)
    };
    let declared = |axis: &Axis| model.link(axis.link).die.is_none();
    for (id, axis) in own.axes.iter_mut().enumerate().filter(|(_, axis)| declared(axis)) {
        let [cos, sin, x, y] = poses[axis.link.index()];
        let back = |[a, b]: Point| [cos * a + sin * b, cos * b - sin * a];
        axis.at = back([axis.at[0] - x, axis.at[1] - y]);
        axis.direction = match axis.kind {
            AxisKind::Line => back(axis.direction),
            AxisKind::Point if welded(id) => back(axis.direction),
            AxisKind::Point => axis.direction,
        };
    }
    for link in own.declared_links().collect::<Vec<_>>() {
        own.links[link.index()].drawn = false;
        own.start.near.push(Near { link, angle: angles[link.index()], origin: Origin::default() });
    }
    for joint in free_joints(model) {
        let (a, b) = own.ends(joint);
        if let JointKind::Revolute(..) = own.joint(joint).kind {
            let value = angles[b.index()] - angles[a.index()];
            own.start.values.push(StartValue { joint, value, origin: Origin::default() });
        }
    }
    (own, poses)
}

/// The joints whose starts may be chosen: those of motors, and of what a gear could be said to move, those that the plan says it moves.
fn free_joints(model: &Model) -> BTreeSet<JointId> {
    let structure = structure::analyse(model).expect("coherent");
    let plan = plan::plan(model, &structure).expect("sequential");
    let meshed = plan.steps.iter().filter_map(|step| match step {
        Step::Mesh(mesh) => Some(mesh.connection.joint),
        _ => None,
    });
    let motored = model.motors.iter().map(|motor| motor.joint);
    meshed.chain(motored).collect()
}
