//! The ranges of motors, and what each drives.

use super::words::{Driver, with_unit};
use crate::failure::{Failure, FailureKind};
use crate::motion::{Basis, Drive, Reach, Span, motor_name, obstacle};
use crate::quantity::{self, FLAT, Measurement, Summary, Units, summarize};
use crate::text::quoted;
use mech_compiler::Compiled;
use mech_compiler::model::{LinkId, Measurand, Model, MotorId, Quantity};

/// So many motors are moved, one after the other.
const MOST_MOTORS: usize = 8;
/// The ends of a range are told with so many digits.
const DIGITS: usize = 5;
/// So many joints are told that a motor drives.
const MOST_JOINTS: usize = 12;
/// A turn has so many steps, between which extremes are looked for.
const STEPS: u32 = 180;
/// Of more turns, each has fewer.
const MOST_TURNS: u32 = 12;

/// What each motor does and drives, as the lines of a report: a label and a text.
pub(super) fn lines(model: &Model, compiled: &Compiled) -> Result<Vec<(String, String)>, Failure> {
    let mut lines = Vec::new();
    let mut drives = Vec::new();
    if model.lawful_motors().next().is_some() {
        drives.push((None, Drive::new(model, compiled, None, Span::default(), &[])?));
    }
    for (motor, reach) in reaches(model, compiled)? {
        let range = range(model, compiled, motor, &reach);
        if model.lawful_motors().any(|(lawful, _)| lawful == motor) {
            lines.push(("motor".to_owned(), range));
            continue;
        }
        let drive = Drive::through(motor, start(model, compiled), &reach);
        let drive = drive.completed(model, compiled);
        let range = match drive.turns(model) {
            1 => range,
            turns => format!("{range}; all is back after {turns} turns"),
        };
        drives.push((Some((motor, range)), drive));
    }
    for (motor, drive) in drives {
        let mut driver = Driver {
            name: "t".to_owned(),
            unit: "s",
            size: model.size(),
            precision: model.precision,
            is_cyclic: drive.is_cyclic(model),
        };
        if let Some((motor, range)) = motor {
            lines.push(("motor".to_owned(), range));
            motor_name(model, motor).clone_into(&mut driver.name);
            let is_angle = model.turns(model.motor(motor).joint);
            driver.unit = if is_angle { "deg" } else { "" };
        }
        let driven = driven_lines(model, compiled, &drive, &driver)?;
        lines.extend(driven.into_iter().map(|text| (String::new(), text)));
    }
    let left = model.motors.len().saturating_sub(MOST_MOTORS);
    if left > 0 {
        lines.push((String::new(), format!("and {left} motors more")));
    }
    Ok(lines)
}

/// How far each motor goes, and what ends it.
pub(super) fn ranges(model: &Model, compiled: &Compiled) -> Result<Vec<String>, Failure> {
    let reaches = reaches(model, compiled)?.into_iter();
    let lines = reaches.map(|(motor, reach)| range(model, compiled, motor, &reach));
    Ok(lines.collect())
}

/// The reach of each motor from the start.
fn reaches(model: &Model, compiled: &Compiled) -> Result<Vec<(MotorId, Reach)>, Failure> {
    let motors = model.motor_ids().take(MOST_MOTORS);
    let found = motors.map(|motor| {
        let reach = Reach::of(model, compiled, motor, start(model, compiled))?;
        Ok((motor, reach))
    });
    found.collect()
}

/// The values of all motors at the start.
fn start<'c>(model: &Model, compiled: &'c Compiled) -> &'c [f64] {
    &compiled.program.start.motors[..model.motors.len()]
}

/// A motor with its range in words.
fn range(model: &Model, compiled: &Compiled, motor: MotorId, reach: &Reach) -> String {
    let is_angle = model.turns(model.motor(motor).joint);
    let shown = |value: f64| {
        if is_angle {
            with_unit(value.to_degrees(), "deg", DIGITS)
        } else {
            with_unit(value, "", DIGITS)
        }
    };
    let [low, high] = reach.ends.map(shown);
    let goes = match reach.basis {
        Basis::Round => "turns right round".to_owned(),
        Basis::Declared => format!("goes from {low} to {high}, as declared"),
        Basis::Walked => {
            let why = |stop| {
                let why = obstacle(model, compiled, stop);
                let why = why.strip_suffix(" there").unwrap_or(&why);
                why.to_owned()
            };
            match reach.stops {
                [None, None] => "slides, and nothing stops it".to_owned(),
                [Some(stop), None] => {
                    format!("goes down to {low}, where {}; above nothing stops it", why(stop))
                }
                [None, Some(stop)] => {
                    format!("goes up to {high}, where {}; below nothing stops it", why(stop))
                }
                [Some(one), Some(other)] if one == other => {
                    format!("goes from {low} to {high}; at both ends {}", why(one))
                }
                [Some(below), Some(above)] => format!(
                    "goes from {low}, where {}, to {high}, where {}",
                    why(below),
                    why(above)
                ),
            }
        }
    };
    format!("`{}` {goes}", motor_name(model, motor))
}

/// What the ground carries and this motion drives, and the least transmission angle.
fn driven_lines(
    model: &Model,
    compiled: &Compiled,
    drive: &Drive,
    driver: &Driver,
) -> Result<Vec<String>, Failure> {
    let units = &Units::default();
    let measurement = Measurement {
        model,
        drive,
        over: None,
        rate: None,
        steps: STEPS * drive.turns(model).min(MOST_TURNS),
        loads: &[],
        units,
    };
    let mut joints = quantity::usual(model);
    joints.retain(|one| is_carried(model, one));
    let left = joints.len().saturating_sub(MOST_JOINTS);
    joints.truncate(MOST_JOINTS);
    // What another motor moves is told there.
    let is_told = |one: &Summary| model.motors.len() == 1 || !driver.is_still(one);
    let mut lines = Vec::new();
    if !joints.is_empty() {
        let mut summaries = summarize(&measurement, &joints, None)?;
        summaries.retain(is_told);
        lines.extend(summaries.iter().map(|summary| driver.joint_line(summary)));
    }
    if left > 0 {
        lines.push(format!("and {left} joints more"));
    }
    if compiled.plan.loops().next().is_some() {
        let angles = quantity::transmissions(model, &compiled.plan)?;
        match summarize(&measurement, &angles, None) {
            Ok(mut summaries) => {
                summaries.retain(is_told);
                lines.extend(transmission(&summaries, driver));
            }
            // Not determined: joints are redundant, or loops are solved together.
            Err(failure) if failure.kind() == FailureKind::Mechanism => {}
            Err(failure) => return Err(failure),
        }
    }
    Ok(lines)
}

/// Whether it is the coordinate of a joint that the ground carries, and that no motor moves.
fn is_carried(model: &Model, measurand: &Measurand) -> bool {
    let Some(Quantity::Coordinate(joint)) = measurand.quantity() else {
        return false;
    };
    let (a, b) = model.ends(joint);
    (a == LinkId::GROUND || b == LinkId::GROUND) && model.motor_of(joint).is_none()
}

fn transmission(summaries: &[Summary], driver: &Driver) -> Option<String> {
    let worst = summaries.iter().min_by(|a, b| a.least.value.total_cmp(&b.least.value))?;
    let joints = worst.name.strip_prefix("transmission of")?;
    let joints = quoted(joints.split_whitespace());
    Some(if worst.least.value < FLAT {
        let mut flat = worst.least;
        flat.value = 0.0;
        format!(
            "the transmission angle falls to {}, in the loop of {joints}",
            driver.at(flat, "deg")
        )
    } else {
        format!(
            "the least transmission angle is {}, in the loop of {joints}",
            driver.at(worst.least, "deg")
        )
    })
}
