//! Mechanisms that counting condemns and that move all the same, because their lengths match exactly: parallelograms with a
//! crank too many. Tested by moving.

use crate::evaluate::{self, Machine};
use crate::model::{Allowances, AxisId, Joint, JointId, JointKind, LinkId, Model, MotorId};
use crate::plan::{self, Plan, Step};
use crate::program::{self, Program};
use crate::structure::{self, Factor, Rolling, RollingEnd, Structure};
use std::f64::consts::TAU;

/// How far each motor is moved, in radians, or as a part of the mechanism's size: far enough for a link that only touches its
/// circle to leave it, by any order of contact that occurs. The first must be possible in one direction at least; where the
/// others are, the joints must close there too.
const NUDGES: [f64; 3] = [0.02, 0.11, 0.37];

/// A mechanism that moves because its lengths match.
pub(crate) struct Matched {
    pub(crate) structure: Structure,
    pub(crate) plan: Plan,
    pub(crate) program: Program,
}

/// Tries to assemble and to move a mechanism whose joints hold each other more than once.
pub(crate) fn matched(model: &Model) -> Option<Matched> {
    let lenient = Model {
        allow: Allowances {
            redundant: true,
            ..model.allow
        },
        ..model.clone()
    };
    let mut structure = structure::layout(&lenient).ok()?;
    let plan = plan::plan(&lenient, &structure).ok()?;
    let mut program = program::build(&lenient, &plan);
    evaluate::settle(&mut program).ok()?;
    let rollings = structure.rollings.clone();
    let moves = |motor: MotorId| {
        let ways = [1.0, -1.0]
            .map(|sign| NUDGES.map(|way| nudged(&lenient, &rollings, &program, motor, sign * way)));
        let closes = ways
            .iter()
            .flatten()
            .all(|outcome| *outcome != Outcome::Open);
        closes && ways.iter().any(|way| way[0] == Outcome::Moved)
    };
    if model.motors.is_empty() || !model.motor_ids().all(moves) {
        return None;
    }
    structure.redundant = too_many(&lenient, &plan);
    Some(Matched {
        structure,
        plan,
        program,
    })
}

/// What became of a nudge.
#[derive(Clone, Copy, PartialEq)]
enum Outcome {
    /// It went there.
    Moved,
    /// It could not go there.
    Stopped,
    /// It went there, but some joint that no loop needs does not close.
    Open,
}

fn nudged(
    model: &Model,
    rollings: &[Rolling],
    program: &Program,
    motor: MotorId,
    way: f64,
) -> Outcome {
    let mut machine = Machine::<f64>::new(program);
    let mut motors = machine.position().motors.clone();
    let slides = matches!(
        model.joint(model.motor(motor).joint).kind,
        JointKind::Prismatic(..)
    );
    let size = model
        .axes
        .iter()
        .fold(0.0_f64, |size, axis| size.max(axis.at[0].hypot(axis.at[1])));
    motors[motor.index()] += if slides { way * size } else { way };
    if machine.move_to(&motors).is_err() {
        return Outcome::Stopped;
    }
    let reach = machine
        .position()
        .poses
        .iter()
        .fold(size, |reach, pose| reach.max(pose[2].hypot(pose[3])));
    let poses = &machine.position().poses;
    let slips = || {
        rollings
            .iter()
            .any(|rolling| slip(model, rolling, &program.start.poses, poses).abs() > 1e-9)
    };
    // Turns are only known up to whole ones: the least nudge tells.
    let open = gap(model, poses) > 1e-9 * reach || (way.abs() <= NUDGES[0] && slips());
    if open { Outcome::Open } else { Outcome::Moved }
}

/// The greatest distance, and sine of an angle, by which axes that a joint makes coincide do not.
fn gap(model: &Model, declared: &[[f64; 4]]) -> f64 {
    let mut poses = vec![[1.0, 0.0, 0.0, 0.0]];
    poses.extend_from_slice(declared);
    let placed = |poses: &[[f64; 4]], id: AxisId| {
        let axis = model.axis(id);
        let [cos, sin, x, y] = poses
            .get(axis.link.index())
            .copied()
            .unwrap_or([1.0, 0.0, 0.0, 0.0]);
        let turned = |[a, b]: [f64; 2]| [cos * a - sin * b, sin * a + cos * b];
        let [u, v] = turned(axis.at);
        ([x + u, y + v], turned(axis.direction))
    };
    // A die is where its pin is, and points where its slot does.
    for (pin, guide) in model.links.iter().filter_map(|link| link.die) {
        let ([x, y], [cos, sin]) = (placed(&poses, pin).0, placed(&poses, guide).1);
        poses.push([cos, sin, x, y]);
    }
    let cross = |a: [f64; 2], b: [f64; 2]| (a[0] * b[1] - a[1] * b[0]).abs();
    let apart = |joint: &Joint| match joint.kind {
        JointKind::Revolute(a, b) | JointKind::Weld(a, b) | JointKind::Prismatic(a, b) => {
            let ((from, along), (to, other)) = (placed(&poses, a), placed(&poses, b));
            let way = [to[0] - from[0], to[1] - from[1]];
            match joint.kind {
                JointKind::Revolute(..) => way[0].hypot(way[1]),
                JointKind::Weld(..) => way[0].hypot(way[1]).max(cross(along, other)),
                _ => cross(along, way).max(cross(along, other)),
            }
        }
        // What rolls is looked at apart.
        JointKind::Gear { .. } | JointKind::Belt { .. } | JointKind::Rack { .. } => 0.0,
    };
    model.joints.iter().map(apart).fold(0.0, f64::max)
}

/// How much the two parts that roll on each other have slipped since the start, as a part of their size.
fn slip(model: &Model, rolling: &Rolling, start: &[[f64; 4]], now: &[[f64; 4]]) -> f64 {
    let pose = |poses: &[[f64; 4]], link: LinkId| {
        let index = link.index().checked_sub(1);
        index
            .and_then(|index| poses.get(index).copied())
            .unwrap_or([1.0, 0.0, 0.0, 0.0])
    };
    let turn = |poses: &[[f64; 4]], link: LinkId| {
        let ([a, b, ..], [c, d, ..]) = (pose(poses, rolling.carrier), pose(poses, link));
        (a * d - b * c).atan2(a * c + b * d)
    };
    let way = |poses: &[[f64; 4]], slide: JointId| match model.joint(slide).kind {
        JointKind::Prismatic(from, to) => {
            let place = |id: AxisId| {
                let axis = model.axis(id);
                let [cos, sin, x, y] = pose(poses, axis.link);
                [
                    x + cos * axis.at[0] - sin * axis.at[1],
                    y + sin * axis.at[0] + cos * axis.at[1],
                ]
            };
            let [cos, sin, ..] = pose(poses, model.axis(from).link);
            let [u, v] = model.axis(from).direction;
            let ([a, b], [c, d]) = (place(from), place(to));
            (c - a) * (cos * u - sin * v) + (d - b) * (sin * u + cos * v)
        }
        _ => 0.0,
    };
    let size = |factor: Factor| match factor {
        #[expect(
            clippy::cast_precision_loss,
            reason = "a wheel of 2^53 teeth does not exist"
        )]
        Factor::Whole(value) => value as f64,
        Factor::Float(value) => value,
    };
    let moved = rolling.ends.map(|(end, factor)| {
        let moved = match end {
            RollingEnd::Wheel(wheel) => {
                let off = turn(now, wheel) - turn(start, wheel);
                off - TAU * (off / TAU).round()
            }
            RollingEnd::Bar {
                slide, forwards, ..
            } => {
                let off = way(now, slide) - way(start, slide);
                if forwards { off } else { -off }
            }
        };
        size(factor) * moved
    });
    let largest = rolling
        .ends
        .iter()
        .map(|(_, factor)| size(*factor).abs())
        .fold(0.0, f64::max);
    (moved[0] + moved[1]) / largest
}

/// The joints that were not needed to find where everything is.
fn too_many(model: &Model, plan: &Plan) -> Vec<JointId> {
    let needed: Vec<JointId> = plan
        .steps
        .iter()
        .flat_map(|step| match step {
            Step::Weld(connection) => vec![connection.joint],
            Step::Drive(drive) => vec![drive.connection.joint],
            Step::Mesh(mesh) => vec![mesh.connection.joint],
            Step::Close(closing) if closing.is_redundant() => Vec::new(),
            Step::Close(closing) => closing.unknowns(),
        })
        .collect();
    let idle = |joint: &JointId| !needed.contains(joint) && !model.joint(*joint).kind.rolls();
    model.joint_ids().filter(idle).collect()
}
