//! Inverse kinematics: the mechanism in which a point is given and motors follow.

use super::{compile, surplus};
use crate::compiled::InverseMechanism;
use crate::digits::significant;
use crate::evaluate::{Machine, Stop};
use crate::kinematics::LinkFrames;
use crate::model::{Inverse, JointId, LinkId, Model, MotorId, Near, Start, StartValue};
use crate::program::{self, Program};
use crate::structure::{Diagnosis, InverseTrouble};

/// Why a point does not come to a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unreachable {
    /// This stops the mechanism in which the point is given.
    Stopped(Stop),
    /// This motor would leave its range.
    OutOfRange(MotorId),
    /// On the way motors and point part: the mechanism would have to be assembled otherwise.
    Apart,
    /// The motors, more than are needed, do not move it that way there.
    Undetermined,
}

/// The mechanism in which the point is given, if motors follow one. It starts where the given program does.
///
/// # Errors
/// The obstacle that keeps the motors from following.
pub(super) fn invert(
    model: &Model,
    program: &Program,
    moving: Option<&Program>,
) -> Result<Option<Box<InverseMechanism>>, Diagnosis> {
    let Some(inverse) = &model.inverse else {
        return Ok(None);
    };
    if inverse.is_least {
        return check_least(model, inverse, program, moving).map(|()| None);
    }
    let inverted = inverted(model, inverse, program);
    starts_within(inverse, &inverted)?;
    let mut compiled = compile(&inverted).map_err(|found| {
        let mut found = diagnosis(model, inverse, program, &found);
        if let Diagnosis::Inverse { trouble: InverseTrouble::Region { proved, .. } } = &mut found {
            *proved = smaller_region(inverse, &inverted);
        }
        found
    })?;
    compiled.timing = program::build_trajectory(&inverted, inverse, model.effects);
    Ok(Some(Box::new(InverseMechanism { model: inverted, compiled })))
}

/// Checks whether motors follow, as far as the start shows.
///
/// # Errors
/// As [`invert`].
pub(super) fn check(
    model: &Model,
    program: &Program,
    moving: impl FnOnce() -> Option<Program>,
) -> Result<(), Diagnosis> {
    let Some(inverse) = &model.inverse else {
        return Ok(());
    };
    if inverse.is_least {
        return check_least(model, inverse, program, moving().as_ref());
    }
    let checked = super::check(&inverted(model, inverse, program));
    checked.map_err(|found| diagnosis(model, inverse, program, &found))
}

fn inverted(model: &Model, inverse: &Inverse, program: &Program) -> Model {
    let mut inverted = model.inverted(inverse);
    inverted.start = start(model, inverse, &inverted, program);
    inverted
}

/// The start of the inverted mechanism: everything is where it is at the start of the program.
fn start(model: &Model, inverse: &Inverse, inverted: &Model, program: &Program) -> Start {
    let frames = LinkFrames::of_some(model, &program.stored, &program.start.poses);
    let origin = inverse.origin;
    let coordinate = |joint: JointId| {
        let given = model.start.values.iter().find(|value| value.joint == joint);
        let value = given.map_or_else(|| frames.coordinate(joint), |given| Some(given.value))?;
        Some(StartValue { joint, value, origin })
    };
    let followed = |motor: &MotorId| inverse.motors.contains(motor);
    let held = model.motor_ids().filter(|motor| !followed(motor));
    let held = held.filter_map(|motor| coordinate(model.motor(motor).joint));
    let place = place(model, inverse, &frames);
    let given = inverse.motors.iter().zip(place);
    let given = given.map(|(motor, value)| StartValue {
        joint: inverted.motor(*motor).joint,
        value,
        origin,
    });
    let links = program.stored.iter().zip(&program.start.poses);
    let declared = links.filter(|(link, _)| model.link(**link).die.is_none());
    let near =
        declared.map(|(&link, [cos, sin, ..])| Near { link, angle: sin.atan2(*cos), origin });
    Start {
        values: held.chain(given).collect(),
        near: near.collect(),
        known: model.joint_ids().filter_map(coordinate).collect(),
    }
}

/// What is given, where it is at the start: the place of the point, and the angle of its link.
pub(super) fn place(model: &Model, inverse: &Inverse, frames: &LinkFrames<'_>) -> [f64; 3] {
    let at = inverse.point.map_or([0.0; 2], |point| model.axis(point).at);
    let [x, y] = frames.place_of(inverse.link, at);
    [x, y, frames.turn(LinkId::GROUND, inverse.link)]
}

/// What keeps the motors from following, of all that is wrong with the inverted mechanism.
fn diagnosis(
    model: &Model,
    inverse: &Inverse,
    program: &Program,
    diagnoses: &[Diagnosis],
) -> Diagnosis {
    // Its own joints come after all that were declared.
    let declared = |joints: &[JointId]| {
        let declared = joints.iter().copied();
        let declared = declared.filter(|joint| joint.index() < model.joints.len());
        declared.collect::<Vec<JointId>>()
    };
    if let Err(idle) = find_idle(model, inverse, program) {
        return idle;
    }
    let trouble = match diagnoses.first() {
        Some(Diagnosis::DeadStart { unknowns }) => {
            InverseTrouble::DeadStart { unknowns: declared(unknowns) }
        }
        Some(Diagnosis::NotSequential { waiting, .. }) => {
            InverseTrouble::Coupled { waiting: declared(waiting) }
        }
        Some(Diagnosis::Range { motor, unknowns, trouble }) => InverseTrouble::Region {
            motor: *motor,
            unknowns: declared(unknowns),
            trouble: trouble.clone(),
            proved: Vec::new(),
        },
        _ => InverseTrouble::Bound,
    };
    Diagnosis::Inverse { trouble }
}

/// Checks whether more motors than needed move what is given every way.
fn check_least(
    model: &Model,
    inverse: &Inverse,
    program: &Program,
    moving: Option<&Program>,
) -> Result<(), Diagnosis> {
    find_idle(model, inverse, program)?;
    moving.map_or(Ok(()), |moving| surplus::check(model, inverse, moving))
}

/// Tests that each motor moves what is given.
///
/// # Errors
/// The motors that do not.
fn find_idle(model: &Model, inverse: &Inverse, program: &Program) -> Result<(), Diagnosis> {
    let motors = inverse.motors.iter().copied();
    let idle = motors.filter(|motor| is_idle(model, inverse, program, *motor));
    let idle: Vec<MotorId> = idle.collect();
    if idle.is_empty() {
        return Ok(());
    }
    let trouble = InverseTrouble::Idle { motors: idle };
    Err(Diagnosis::Inverse { trouble })
}

/// A smaller region for which it can be proved that the point comes everywhere within it, as large as a few trials find; none if none do.
fn smaller_region(inverse: &Inverse, inverted: &Model) -> Vec<[f64; 2]> {
    /// So many regions are tried, none of large mechanisms.
    const TRIED: usize = 8;
    const MOST_LINKS: usize = 64;
    let region_of = |share: f64| -> Vec<[f64; 2]> {
        let ranges = inverse.motors.iter().zip(&inverse.region);
        let ranges = ranges.enumerate().map(|(given, (motor, range))| {
            let start = inverted.start.value(inverted.motor(*motor).joint);
            // As one writes them: angles in degrees.
            let unit = if given < 2 { 1.0 } else { 1_f64.to_radians() };
            [(range.low, true), (range.high, false)].map(|(end, upwards)| {
                let end = (start + share * (end - start)) / unit;
                unit * significant(end, 3, Some(upwards))
            })
        });
        ranges.collect()
    };
    let is_proved = |region: &[[f64; 2]]| {
        let mut smaller = inverted.clone();
        for (motor, [low, high]) in inverse.motors.iter().zip(region) {
            if let Some(range) = &mut smaller.motors[motor.index()].range {
                (range.low, range.high) = (*low, *high);
            }
        }
        starts_within(inverse, &smaller).is_ok() && compile(&smaller).is_ok()
    };
    let (mut known, mut open, mut proved) = (0.0, 1.0, Vec::new());
    let is_large = inverted.links.len() > MOST_LINKS;
    for _ in 0..if is_large { 0 } else { TRIED } {
        let middle = 0.5 * (known + open);
        let region = region_of(middle);
        if is_proved(&region) {
            (known, proved) = (middle, region);
        } else {
            open = middle;
        }
    }
    proved
}

/// Tests that the point starts in its region.
fn starts_within(inverse: &Inverse, inverted: &Model) -> Result<(), Diagnosis> {
    let starts = inverse.motors.iter().map(|motor| {
        let joint = inverted.motor(*motor).joint;
        inverted.start.value(joint)
    });
    let motors = inverse.motors.iter();
    let ranges = motors.filter_map(|motor| inverted.motor(*motor).range);
    for (given, (start, range)) in starts.zip(ranges).enumerate() {
        let is_within = range.low <= start && start <= range.high;
        if !is_within {
            let trouble = InverseTrouble::StartsOutside { given, start };
            return Err(Diagnosis::Inverse { trouble });
        }
    }
    Ok(())
}

/// Whether a motor does not move what is given.
fn is_idle(model: &Model, inverse: &Inverse, program: &Program, motor: MotorId) -> bool {
    /// So far it is moved, in radians or parts of the size. By the square of that at least, the point moves at a dead point.
    const STEP: f64 = 1e-3;
    /// What moves less, in parts of the size, does not move.
    const ROUNDING: f64 = 1e-10;
    let size = model.size().max(f64::MIN_POSITIVE);
    let place_of = |machine: &Machine<'_, f64>| {
        let poses = &machine.position().poses;
        place(model, inverse, &LinkFrames::of_some(model, &program.stored, poses))
    };
    let mut moved = [STEP, -STEP].into_iter().filter_map(|step| {
        let mut machine = Machine::<f64>::new(program);
        let before = place_of(&machine);
        let mut motors = machine.position().motors.clone();
        motors[motor.index()] += step * model.unit_of(motor);
        machine.move_to(&motors).ok()?;
        let after = place_of(&machine);
        let parts = [0, 1, 2].map(|part| (after[part] - before[part]).abs());
        Some(parts[0].max(parts[1]).max(size * parts[2]))
    });
    let given = moved.next().map(|first| moved.fold(first, f64::max));
    given.is_some_and(|moved| moved < ROUNDING * size)
}
