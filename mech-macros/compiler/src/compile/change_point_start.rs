//! Starts at a change point, as of a parallelogram that lies flat. Two branches of its motion cross there, and no loop can be assembled,
//! because its equations are singular. It is assembled a little beside the start, and moved to it.

use crate::model::{LinkId, Model, Near, Origin, StartValue};
use crate::plan::{self, Plan};
use crate::structure::{Diagnosis, Structure};

/// The distance from the start at which it is assembled: in radians, and for slides as a part of the mechanism's size.
const DISTANCE: f64 = 0.02;

/// A plan beside the start; none if the start is not a change point but a dead point, beyond which the mechanism cannot move.
pub(super) fn plan_beside(model: &Model, structure: &Structure) -> Option<Plan> {
    let before = plan_at(model, structure, -DISTANCE);
    let behind = plan_at(model, structure, DISTANCE);
    match (before, behind) {
        (Some(_), Some(plan)) => Some(plan),
        _ => None,
    }
}

/// The plan of the mechanism with its motors displaced from the start. Of several assemblies, that whose links turn least.
fn plan_at(model: &Model, structure: &Structure, displacement: f64) -> Option<Plan> {
    let moved = displace_start(model, displacement);
    match plan::plan(&moved, structure) {
        Ok(plan) => Some(plan),
        Err(Diagnosis::SeveralAssemblies { links, angles, .. }) => {
            let behind = least_turning(model, structure, &links, &angles, displacement)?;
            plan::plan(&prefer_assembly(&moved, &links, behind), structure).ok()
        }
        Err(_) => None,
    }
}

/// Of several assemblies beside the start that whose links turn least over it.
fn least_turning<'a>(
    model: &Model,
    structure: &Structure,
    links: &[LinkId],
    angles: &'a [Vec<f64>],
    displacement: f64,
) -> Option<&'a Vec<f64>> {
    let across = displace_start(model, -displacement);
    let Err(Diagnosis::SeveralAssemblies { angles: others, .. }) = plan::plan(&across, structure)
    else {
        return None;
    };
    // The branch that goes on straight from the other side is that with the least sum of turns.
    let turn = |angles: &&Vec<f64>| {
        let turns = others.iter().map(|others| {
            let pairs = angles.iter().zip(others).take(links.len());
            pairs
                .map(|(a, b)| {
                    let (sin, cos) = (a - b).sin_cos();
                    sin.atan2(cos).abs()
                })
                .sum::<f64>()
        });
        turns.fold(f64::INFINITY, f64::min)
    };
    angles.iter().min_by(|a, b| turn(a).total_cmp(&turn(b)))
}

/// The values of the motors at the start.
pub(super) fn motors(model: &Model) -> Vec<f64> {
    let motors = model.motors.iter();
    motors.map(|motor| model.start.value(motor.joint)).collect()
}

/// The mechanism with its motors displaced from the start.
fn displace_start(model: &Model, displacement: f64) -> Model {
    let mut moved = model.clone();
    for (index, motor) in model.motors.iter().enumerate() {
        #[expect(clippy::cast_precision_loss, reason = "a handful of motors")]
        let displacement = displacement * (1.0 + 0.1 * index as f64);
        let known = moved.start.values.iter_mut().find(|value| value.joint == motor.joint);
        match known {
            Some(value) => value.value += displacement,
            None => moved.start.values.push(StartValue {
                joint: motor.joint,
                value: displacement,
                origin: motor.origin,
            }),
        }
    }
    moved
}

/// The mechanism, to be assembled with its links near these angles.
fn prefer_assembly(model: &Model, links: &[LinkId], angles: &[f64]) -> Model {
    let mut preferring = model.clone();
    preferring.start.near.retain(|near| !links.contains(&near.link));
    let wishes = links.iter().zip(angles).map(|(&link, &angle)| Near {
        link,
        angle,
        origin: Origin::default(),
    });
    preferring.start.near.extend(wishes);
    preferring
}
