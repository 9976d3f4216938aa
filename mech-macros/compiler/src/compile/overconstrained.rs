//! Overconstrained mechanisms: counting finds them rigid, but they move, because their lengths match exactly. A parallelogram with
//! three cranks is one. They are tested by moving them.

use super::closure::{moved, size, slides, unit};
use crate::bug::bug;
use crate::evaluate::{self, Machine};
use crate::kinematics::LinkFrames;
use crate::model::{Allowances, JointId, Model, MotorId};
use crate::plan::{self, Plan, Step};
use crate::program::{self, Program};
use crate::structure::{self, Diagnosis, Rolling, Structure};

/// By so much each motor is tried, in radians, or as a part of the mechanism's size. That is far enough for a link that only touches its
/// circle to leave it. The first displacement, or a smaller one between dead points, must succeed in one direction at least. Wherever the
/// others succeed, all joints must close.
const DISPLACEMENTS: [f64; 3] = [0.02, 0.11, 0.37];
const LESS: [f64; 2] = [0.002, 0.0002];

/// Joints count as closed if their gap is at most this part of the mechanism's size. Where lengths do not match, gaps grow with the
/// square of a displacement.
const CLOSED: f64 = 1e-9;

/// Joints that open so many times as far from one step to the next do not bend: a loop has come to another assembly beyond a dead point.
const LEAP: f64 = 1e3;

/// A mechanism that moves because its lengths match.
pub(super) struct Overconstrained {
    pub(super) structure: Structure,
    pub(super) plan: Plan,
    /// Which loops wait for each other, if they were solved together without being allowed to be.
    pub(super) waits: Option<Diagnosis>,
}

/// Assembles and moves a mechanism whose joints hold each other more than once; none if it does not move.
pub(super) fn assemble(model: &Model) -> Option<Overconstrained> {
    // A cam that does not fit would go unnoticed.
    if model.motors.is_empty() || model.cams().next().is_some() {
        return None;
    }
    let mut lenient = Model {
        allow: Allowances { redundant: true, ..model.allow },
        // Links that are not shown must close too.
        show: None,
        ..model.clone()
    };
    let mut structure = structure::layout(&lenient).ok()?;
    structure.still = structure::still_pins(&lenient);
    let (plan, waits) = match plan::plan(&lenient, &structure) {
        Ok(plan) => (plan, None),
        Err(waits @ Diagnosis::NotSequential { .. }) if !model.allow.coupled => {
            lenient.allow.coupled = true;
            (plan::plan(&lenient, &structure).ok()?, Some(waits))
        }
        Err(_) => return None,
    };
    let mut program = program::build(&lenient, &plan);
    evaluate::settle(&mut program).ok()?;
    let rollings = structure.rollings.clone();
    let moves = |motor: MotorId| {
        let both = |displacement: f64| {
            [displacement, -displacement]
                .map(|displacement| displace(&lenient, &rollings, &program, motor, displacement))
        };
        let [near, farther @ ..] = DISPLACEMENTS;
        // A motor that cannot move at all is not tried farther.
        let mut first = both(near);
        for less in LESS {
            if first == [Outcome::Stopped; 2] {
                first = both(less);
            }
        }
        let closes = |outcomes: [Outcome; 2]| !outcomes.contains(&Outcome::Open);
        first.contains(&Outcome::Moved)
            && closes(first)
            && farther.into_iter().all(|displacement| closes(both(displacement)))
    };
    // A motor whose joint others move is not driven.
    let is_driven = |motor: MotorId| {
        let drives = |step: &Step| matches!(step, Step::Drive(drive) if drive.motor == motor);
        plan.steps.iter().any(drives)
    };
    if !model.motor_ids().all(|motor| is_driven(motor) && moves(motor)) {
        return None;
    }
    // Of motors that move one by one, but never together, one is too many.
    let together = |displacement: f64| all_move(&lenient, &program, displacement);
    let near = LESS.into_iter().chain([DISPLACEMENTS[0]]);
    let mut near = near.flat_map(|near| [near, -near]);
    if model.motors.len() > 1 && !near.any(together) {
        return None;
    }
    structure.redundant = redundant_joints(&lenient, &plan);
    Some(Overconstrained { structure, plan, waits })
}

/// The outcome of a displacement.
#[derive(Clone, Copy, PartialEq)]
enum Outcome {
    /// The motor went there.
    Moved,
    /// The motor could not go there.
    Stopped,
    /// The motor went there, but a joint that no loop needs does not close.
    Open,
}

/// Moves one motor from the start in small steps, which stay on their assembly, and tests whether all joints close there.
fn displace(
    model: &Model,
    rollings: &[Rolling],
    program: &Program,
    motor: MotorId,
    displacement: f64,
) -> Outcome {
    let mut machine = Machine::<f64>::new(program);
    let mut motors = machine.position().motors.clone();
    let (slides, size) = (slides(model, model.motor(motor)), model.size());
    let (from, unit) = (motors[motor.index()], unit(model, model.motor(motor)));
    let start = LinkFrames::of_some(model, &program.stored, &program.start.poses);
    let steps = (displacement.abs() / DISPLACEMENTS[0]).ceil();
    let (mut step, mut before) = (1.0, None);
    let (now, reach) = loop {
        motors[motor.index()] = from + displacement * unit * step / steps;
        if machine.move_to(&motors).is_err() {
            return Outcome::Stopped;
        }
        let poses = &machine.position().poses;
        let far = |reach: f64, pose: &[f64; 4]| reach.max(pose[2].hypot(pose[3]));
        let reach = poses.iter().fold(size, far);
        let now = LinkFrames::of_some(model, &program.stored, poses);
        let gap = now.gap().max(CLOSED * reach);
        if before.is_some_and(|before| gap > LEAP * before) {
            return Outcome::Stopped;
        }
        if step >= steps {
            break (now, reach);
        }
        (step, before) = (step + 1.0, Some(gap));
    };
    let slips = || rollings.iter().any(|rolling| slip(rolling, &start, &now).abs() > 1e-9);
    // A motor between links that other joints hold to each other moves nothing.
    let idle = || {
        let joint = model.motor(motor).joint;
        let [now, start] = [&now, &start].map(|frames| frames.coordinate(joint));
        let (Some(now), Some(start)) = (now, start) else {
            bug!("a motor drives what has no coordinate");
        };
        let wanted = motors[motor.index()] - program.start.motors[motor.index()];
        let off = now - start - wanted;
        let off = if slides { off } else { off.sin() };
        off.abs() > 1e-9 * if slides { reach } else { 1.0 }
    };
    // Turns are only known up to whole ones: the least displacement is decisive.
    let closed = CLOSED * (displacement.abs() / DISPLACEMENTS[0]).min(1.0);
    let open =
        now.gap() > closed * reach || idle() || (displacement.abs() <= DISPLACEMENTS[0] && slips());
    if open { Outcome::Open } else { Outcome::Moved }
}

/// Whether all motors go so far from the start together.
fn all_move(model: &Model, program: &Program, displacement: f64) -> bool {
    let mut machine = Machine::<f64>::new(program);
    let mut motors = machine.position().motors.clone();
    for motor in model.motor_ids() {
        motors[motor.index()] += displacement * unit(model, model.motor(motor));
    }
    machine.move_to(&motors).is_ok()
}

/// Returns the slip of the two parts that roll on each other, from one scene to another, as a part of their size.
fn slip(rolling: &Rolling, start: &LinkFrames<'_>, now: &LinkFrames<'_>) -> f64 {
    let sizes = rolling.ends.map(|(_, factor)| size(factor).abs());
    let moved = moved(rolling, start, now);
    (moved[0] + moved[1]) / sizes[0].max(sizes[1])
}

/// The joints that were not needed to find where everything is.
fn redundant_joints(model: &Model, plan: &Plan) -> Vec<JointId> {
    let needed: Vec<JointId> = plan
        .steps
        .iter()
        .flat_map(|step| match step {
            Step::Weld(weld) => vec![weld.connection.joint],
            Step::Drive(drive) => vec![drive.connection.joint],
            Step::Mesh(mesh) => vec![mesh.connection.joint],
            Step::Cam(cam) => vec![cam.connection.joint],
            Step::Close(closing) if closing.is_redundant() => Vec::new(),
            Step::Close(closing) => closing.unknowns(),
        })
        .collect();
    let idle = |joint: &JointId| !needed.contains(joint) && !model.joint(*joint).kind.ties();
    model.joint_ids().filter(idle).collect()
}
