//! Starts at which everything is aligned: a parallelogram laid flat. There two ways of going on cross, and no loop can be
//! assembled, because its equations are singular. It is assembled a little beside, and moved to where it shall start.

use crate::model::{LinkId, Model, Near, Origin, StartValue};
use crate::plan::{self, Plan};
use crate::structure::{Diagnosis, Structure};

/// How far beside: in radians, and for what slides as a part of the mechanism's size.
const BESIDE: f64 = 0.02;

/// A plan beside the start; none if it is not a change point but a dead point, beyond which there is no way.
pub(crate) fn beside(model: &Model, structure: &Structure) -> Option<Plan> {
    let before = at(model, structure, -BESIDE);
    let behind = at(model, structure, BESIDE);
    match (before, behind) {
        (Some(_), Some(plan)) => Some(plan),
        _ => None,
    }
}

/// The plan of the mechanism with its motors this much farther. Of several ways to go on, that on which links turn least.
fn at(model: &Model, structure: &Structure, way: f64) -> Option<Plan> {
    let moved = moved(model, way);
    match plan::plan(&moved, structure) {
        Ok(plan) => Some(plan),
        Err(Diagnosis::SeveralAssemblies { links, angles, .. }) => {
            let behind = at_least_turning(model, structure, &links, &angles, way)?;
            plan::plan(&near(&moved, &links, behind), structure).ok()
        }
        Err(_) => None,
    }
}

/// Of several assemblies beside the start that whose links turn least over it.
fn at_least_turning<'a>(
    model: &Model,
    structure: &Structure,
    links: &[LinkId],
    angles: &'a [Vec<f64>],
    way: f64,
) -> Option<&'a Vec<f64>> {
    let across = moved(model, -way);
    let Err(Diagnosis::SeveralAssemblies { angles: others, .. }) = plan::plan(&across, structure)
    else {
        return None;
    };
    // On the other side the same way is that which goes on straightest: the sum of its turns is least.
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
pub(crate) fn start(model: &Model) -> Vec<f64> {
    let motors = model.motors.iter();
    motors.map(|motor| model.start.value(motor.joint)).collect()
}

fn moved(model: &Model, way: f64) -> Model {
    let mut moved = model.clone();
    for (index, motor) in model.motors.iter().enumerate() {
        #[expect(clippy::cast_precision_loss, reason = "a handful of motors")]
        let way = way * (1.0 + 0.1 * index as f64);
        let known = moved
            .start
            .values
            .iter_mut()
            .find(|value| value.joint == motor.joint);
        match known {
            Some(value) => value.value += way,
            None => moved.start.values.push(StartValue {
                joint: motor.joint,
                value: way,
                origin: motor.origin,
            }),
        }
    }
    moved
}

fn near(model: &Model, links: &[LinkId], angles: &[f64]) -> Model {
    let mut nearer = model.clone();
    nearer.start.near.retain(|near| !links.contains(&near.link));
    let wishes = links.iter().zip(angles).map(|(&link, &angle)| Near {
        link,
        angle,
        origin: Origin::default(),
    });
    nearer.start.near.extend(wishes);
    nearer
}
