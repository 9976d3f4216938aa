//! Positions that close to thirty digits, straight from the definition of the joints.
//!
//! The compiler folds lengths into constants of seventeen digits. So even with more digits, its program has the error of their rounding, as
//! the judged positions have. A few steps of Newton's iteration on all joints at once remove this error. The gaps have all digits, the
//! rates are floats.

use crate::octuple::Octuple;
use mech_compiler::model::{AxisId, JointKind, LinkId, Model};
use mech_core::dense;
use mech_runtime::Real;

/// The size of a gap that counts as closed, relative to the mechanism's.
const CLOSED: f64 = 1e-28;
/// The most rounds. Each gives some fourteen digits.
const ROUNDS: usize = 6;

type Vector = [Octuple; 2];

/// A condition on the position: its gap, and the rates of the gap for the rotation and translation of each link.
struct Condition {
    gap: Octuple,
    rates: Vec<(usize, f64)>,
}

/// An axis in the scene.
struct Placed {
    /// The first unknown of its link, if that moves.
    first: Option<usize>,
    at: Vector,
    /// The vector from the origin of its link.
    arm: Vector,
    direction: Vector,
}

/// Corrects the poses until the joints close and the motor's coordinate has the given value.
///
/// # Errors
/// If the joints do not close, or one of them rolls.
pub(crate) fn close(
    model: &Model,
    size: f64,
    motor: f64,
    poses: &mut [[Octuple; 4]],
) -> Result<(), String> {
    for _ in 0..ROUNDS {
        let conditions = conditions(model, motor, poses)?;
        let gaps = conditions.iter().map(|condition| condition.gap.to_f64().abs());
        if gaps.fold(0.0, f64::max) < CLOSED * size {
            return Ok(());
        }
        let steps = solve(&conditions, 3 * poses.len()).ok_or("its joints are singular")?;
        let (steps, _) = steps.as_chunks::<3>();
        for (pose, &[turn, dx, dy]) in poses.iter_mut().zip(steps) {
            let [cos, sin, x, y] = *pose;
            let turn = Octuple::from(turn);
            let (cos, sin) = (cos - sin * turn, sin + cos * turn);
            let length = (cos * cos + sin * sin).sqrt();
            *pose = [cos / length, sin / length, x + dx.into(), y + dy.into()];
        }
    }
    Err(format!("its joints do not close at {motor}"))
}

fn conditions(model: &Model, motor: f64, poses: &[[Octuple; 4]]) -> Result<Vec<Condition>, String> {
    let mut conditions = Vec::new();
    for id in model.joint_ids() {
        let joint = model.joint(id);
        match joint.kind {
            JointKind::Revolute(a, b) => {
                let (a, b) = (place(model, poses, a), place(model, poses, b));
                conditions.extend(meeting(&a, &b));
                if model.motor_of(id).is_some() {
                    let (sin, cos) = Octuple::from(motor).sin_cos();
                    let turned = rotate(a.direction, cos, sin);
                    conditions.push(parallel(&Placed { direction: turned, ..a }, &b));
                }
            }
            JointKind::Prismatic(a, b) if model.motor_of(id).is_none() => {
                let (a, b) = (place(model, poses, a), place(model, poses, b));
                conditions.extend([on_line(&a, &b), parallel(&a, &b)]);
            }
            _ => return Err(format!("no reference for joint `{}`", joint.name)),
        }
    }
    Ok(conditions)
}

fn place(model: &Model, poses: &[[Octuple; 4]], id: AxisId) -> Placed {
    let axis = model.axis(id);
    let (at, direction) = (axis.at.map(Octuple::from), axis.direction.map(Octuple::from));
    if axis.link == LinkId::GROUND {
        return Placed { first: None, at, arm: at, direction };
    }
    let link = axis.link.index() - 1;
    let [cos, sin, x, y] = poses[link];
    let arm = rotate(at, cos, sin);
    Placed {
        first: Some(3 * link),
        at: [x + arm[0], y + arm[1]],
        arm,
        direction: rotate(direction, cos, sin),
    }
}

fn rotate([x, y]: Vector, cos: Octuple, sin: Octuple) -> Vector {
    [cos * x - sin * y, sin * x + cos * y]
}

fn cross([a, b]: Vector, [c, d]: Vector) -> Octuple {
    a * d - b * c
}

fn dot([a, b]: Vector, [c, d]: Vector) -> f64 {
    (a * c + b * d).to_f64()
}

/// The conditions that two points coincide.
fn meeting(a: &Placed, b: &Placed) -> [Condition; 2] {
    let condition = |coordinate: usize| {
        let mut rates = Vec::new();
        for (axis, sign) in [(a, -1.0), (b, 1.0)] {
            if let Some(first) = axis.first {
                let [x, y] = axis.arm.map(Real::to_f64);
                let turning = if coordinate == 0 { -y } else { x };
                rates.extend([(first, sign * turning), (first + 1 + coordinate, sign)]);
            }
        }
        Condition { gap: b.at[coordinate] - a.at[coordinate], rates }
    };
    [condition(0), condition(1)]
}

/// The condition that two axes have the same direction.
fn parallel(a: &Placed, b: &Placed) -> Condition {
    let rate = dot(a.direction, b.direction);
    let rates = [(a, -rate), (b, rate)].into_iter();
    Condition {
        gap: cross(a.direction, b.direction),
        rates: rates.filter_map(|(axis, rate)| Some((axis.first?, rate))).collect(),
    }
}

/// The condition that the second point is on the first line.
fn on_line(a: &Placed, b: &Placed) -> Condition {
    let between = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
    let [x, y] = a.direction.map(Real::to_f64);
    let mut rates = Vec::new();
    for (axis, sign) in [(a, -1.0), (b, 1.0)] {
        if let Some(first) = axis.first {
            let turning = dot(a.direction, axis.arm);
            rates.extend([(first, sign * turning), (first + 1, -sign * y), (first + 2, sign * x)]);
        }
    }
    if let Some(first) = a.first {
        rates.push((first, -dot(a.direction, between)));
    }
    Condition { gap: cross(a.direction, between), rates }
}

/// The steps that close the gaps. `None` if the conditions are singular.
fn solve(conditions: &[Condition], unknowns: usize) -> Option<Vec<f64>> {
    if conditions.len() != unknowns {
        return None;
    }
    let row = |condition: &Condition| {
        let mut row = vec![0.0; unknowns];
        for &(unknown, rate) in &condition.rates {
            row[unknown] += rate;
        }
        row
    };
    let mut rows: Vec<Vec<f64>> = conditions.iter().map(row).collect();
    let gaps = conditions.iter().map(|condition| condition.gap.to_f64());
    let mut steps: Vec<f64> = gaps.map(|gap| -gap).collect();
    let _ = dense::solve(&mut rows, &mut steps);
    steps.iter().all(|step| step.is_finite()).then_some(steps)
}
