//! Notes about laws that jump, or whose rates do.

use crate::model::{JointId, Jump, Model};

/// Times up to which laws of motors are looked at: of mechanisms that are quick, and of slow ones.
const TIMES: [f64; 6] = [0.01, 0.1, 1.0, 10.0, 100.0, 1000.0];

/// What is smaller than this part of a jump is nothing.
const NOTHING: f64 = 1e-6;

/// Returns the notes on laws of motors and cams.
pub(super) fn notes(model: &Model) -> impl Iterator<Item = String> {
    let params: Vec<f64> = model.params.values().collect();
    let motors = model.lawful_motors().filter_map({
        let params = params.clone();
        move |(motor, law)| {
            let joint = model.motor(motor).joint;
            let is_angle = model.turns(joint);
            let mut found = TIMES.into_iter();
            let jump = found.find_map(|time| law.first_jump([0.0, time], &params, is_angle))?;
            let place = format!("at t = {}", tidy(jump.at));
            Some(note(model, &jump, joint, ["its law", &place, ""]))
        }
    });
    let cams = model.cams().filter_map(move |(cam, shaft, follower, law)| {
        // A slide has no turn to look at.
        if !model.turns(shaft) {
            return None;
        }
        let jump = law.first_jump_in_turn(&params, model.turns(follower))?;
        let by = format!("cam `{}`", model.joint(cam).name);
        let degrees = jump.at.to_degrees();
        let degrees = if degrees.abs() < 1e-9 { 0.0 } else { tidy(degrees) };
        let place = format!("at q = {degrees} deg");
        let per = format!(" for each radian of `{}`", model.joint(shaft).name);
        Some(note(model, &jump, follower, [&by, &place, &per]))
    });
    motors.chain(cams)
}

/// ``by its law the rate of `a` jumps at t = 1, from 0 to 2: nothing that has mass can follow``.
fn note(model: &Model, jump: &Jump, joint: JointId, [by, place, per]: [&str; 3]) -> String {
    let name = &model.joint(joint).name;
    let what = if jump.is_rate { "the rate of " } else { "" };
    let per = if jump.is_rate { per } else { "" };
    // Beside the jump either is a little off.
    let size = (jump.ends[1] - jump.ends[0]).abs();
    let [before, after] = jump.ends.map(|end| {
        let is_nothing = end.abs() < NOTHING * size;
        if is_nothing { 0.0 } else { tidy(end) }
    });
    format!(
        "by {by} {what}`{name}` jumps {place}, from {before} to {after}{per}: nothing that has mass can follow"
    )
}

/// Five digits of a number.
fn tidy(number: f64) -> f64 {
    let rounded = format!("{number:.4e}").parse();
    rounded.unwrap_or(number)
}
