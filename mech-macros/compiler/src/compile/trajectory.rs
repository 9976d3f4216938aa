//! The path of a point that motors follow: whether they can.

use super::inverse::Unreachable;
use super::lead::lead;
use crate::compiled::{Compiled, InverseMechanism};
use crate::evaluate::{Machine, Stop};
use crate::model::{Inverse, Law, Model, Range};
use crate::structure::{Diagnosis, InverseTrouble, TrajectoryStop};

/// So many places are looked at until the path comes back.
const PLACES: i32 = 360;

/// Leads the point to where its path begins, and along it, if it comes back after a time that is known.
///
/// # Errors
/// If it is stopped at a place that is looked at.
pub(super) fn check(model: &Model, compiled: &Compiled) -> Result<(), Diagnosis> {
    let (Some(led), Some(inverted)) = (&model.inverse, &compiled.inverse) else {
        return Ok(());
    };
    if led.trajectory.is_empty() {
        return Ok(());
    }
    let laws: Vec<&Law> = led.trajectory.iter().map(|law| model.law(*law)).collect();
    let params: Vec<f64> = model.params.values().collect();
    let mut mechanism = Machine::<f64>::new(&compiled.program);
    let mut inverse = Machine::<f64>::new(&inverted.compiled.program);
    let times = model.period().map_or(vec![0.0], |period| {
        let places = (0..=PLACES).map(f64::from);
        places.map(|place| period * place / f64::from(PLACES)).collect()
    });
    for time in times {
        let given: Vec<f64> = laws.iter().map(|law| law.at(time, &params)).collect();
        let stop = outside(led, &given).or_else(|| {
            let both = (&mut mechanism, &mut inverse);
            let led = lead(model, compiled, both, &given);
            led.err().map(|why| obstacle(model, inverted, why))
        });
        if let Some(stop) = stop {
            let trouble = InverseTrouble::Trajectory { time, given, stop };
            return Err(Diagnosis::Inverse { trouble });
        }
    }
    Ok(())
}

/// Why a place cannot be given: it is none, or outside of the region.
fn outside(led: &Inverse, given: &[f64]) -> Option<TrajectoryStop> {
    if given.iter().any(|value| !value.is_finite()) {
        return Some(TrajectoryStop::Law);
    }
    let mut ranges = led.region.iter().zip(given);
    let left = ranges.position(|(Range { low, high, .. }, value)| !(low..=high).contains(&value));
    left.map(TrajectoryStop::Region)
}

fn obstacle(model: &Model, inverted: &InverseMechanism, why: Unreachable) -> TrajectoryStop {
    let stop = match why {
        Unreachable::OutOfRange(motor) => return TrajectoryStop::Range(motor),
        Unreachable::Apart | Unreachable::Undetermined => return TrajectoryStop::Apart,
        Unreachable::Stopped(stop) => stop,
    };
    let (plan, program) = (&inverted.compiled.plan, &inverted.compiled.program);
    let number = match stop {
        Stop::Open(block) | Stop::DeadPoint(block) | Stop::ChangePoint(block) => {
            program.loop_of(block)
        }
        Stop::Singular(number) => Some(number),
        _ => None,
    };
    let ring = number.and_then(|number| plan.loops().nth(number));
    ring.map_or(TrajectoryStop::TooLarge, |ring| {
        let declared = ring.unknowns().into_iter();
        let declared = declared.filter(|joint| joint.index() < model.joints.len());
        TrajectoryStop::Loop(declared.collect())
    })
}
