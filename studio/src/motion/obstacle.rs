//! Obstacles to the motion of a mechanism, in words.

use mech_compiler::Compiled;
use mech_compiler::evaluate::Stop;
use mech_compiler::model::{JointId, Model, MotorId};
use mech_compiler::program::BlockId;

/// Describes the obstacle that stops a mechanism: `the loop of joints b, c, d does not close`.
pub(crate) fn obstacle(model: &Model, compiled: &Compiled, stop: Stop) -> String {
    let ring = |block: BlockId| {
        let number = compiled.program.loop_of(block);
        ring_name(model, compiled, number)
    };
    match stop {
        Stop::Open(block) => format!("{} does not close there", ring(block)),
        Stop::DeadPoint(block) => format!("{} is at a dead point there", ring(block)),
        Stop::ChangePoint(block) => format!("{} is at a change point there", ring(block)),
        Stop::Singular(number) => {
            format!(
                "{} is at a dead point or change point",
                ring_name(model, compiled, Some(number))
            )
        }
        Stop::TooFar => "that is too far for one move".to_owned(),
        Stop::Overflow => "a coordinate becomes too large there".to_owned(),
        Stop::NotFinite(motor) => match model.motors.get(motor) {
            Some(motor) => {
                format!("the value of motor `{}` is not finite", model.joint(motor.joint).name)
            }
            None => "a param is not finite".to_owned(),
        },
        Stop::MotorCount | Stop::Unasked => "the program was not asked for that".to_owned(),
    }
}

fn ring_name(model: &Model, compiled: &Compiled, number: Option<usize>) -> String {
    let joints = joints_of_ring(model, compiled, number);
    let names: Vec<String> =
        joints.iter().map(|joint| format!("`{}`", model.joint(*joint).name)).collect();
    if names.is_empty() { "a loop".to_owned() } else { format!("the loop of {}", names.join(", ")) }
}

/// The joints of the loop that keeps a mechanism from going on; none if it is no loop that does.
pub(crate) fn joints_in_the_way(model: &Model, compiled: &Compiled, stop: Stop) -> Vec<JointId> {
    let number = match stop {
        Stop::Open(block) | Stop::DeadPoint(block) | Stop::ChangePoint(block) => {
            compiled.program.loop_of(block)
        }
        Stop::Singular(number) => Some(number),
        _ => None,
    };
    joints_of_ring(model, compiled, number)
}

/// The joints of a loop whose coordinates it determines, each name once.
fn joints_of_ring(model: &Model, compiled: &Compiled, number: Option<usize>) -> Vec<JointId> {
    let Some(ring) = number.and_then(|number| compiled.plan.loops().nth(number)) else {
        return Vec::new();
    };
    let mut joints: Vec<JointId> = Vec::new();
    for joint in ring.unknowns() {
        let name = |id: JointId| &model.joint(id).name;
        if !joints.iter().any(|known| name(*known) == name(joint)) {
            joints.push(joint);
        }
    }
    joints
}

/// The name of a motor.
pub(crate) fn motor_name(model: &Model, motor: MotorId) -> &str {
    &model.joint(model.motor(motor).joint).name
}
