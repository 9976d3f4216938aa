//! The values of motors for which what is expected does not hold, as far as samples show: for pictures.

use super::Judged;
use crate::failure::Failure;
use crate::motion::{Basis, Reach};
use mech_compiler::model::{Model, MotorId, Requirement};
use mech_compiler::requirement::failing;
use mech_compiler::{Compiled, catch};
use std::f64::consts::PI;

/// Finds for which values of motors what is expected does not hold.
pub(super) fn sample(
    judged: &mut [Judged],
    model: &Model,
    compiled: &Compiled,
) -> Result<(), Failure> {
    let motors: Vec<MotorId> = model.motor_ids().collect();
    for (one, requirement) in judged.iter_mut().zip(&model.requirements) {
        let places = one.places.iter().map(|place| {
            let place = place.iter();
            place.map(|(motor, value)| (motors[*motor], *value)).collect()
        });
        let places: Vec<Vec<(MotorId, f64)>> = places.collect();
        let found = catch(|| intervals(model, compiled, requirement, &places));
        one.intervals = found.map_err(Failure::internal)?;
    }
    Ok(())
}

/// The values of each motor of these places, with others there, for which a requirement does not hold.
fn intervals(
    model: &Model,
    compiled: &Compiled,
    requirement: &Requirement,
    places: &[Vec<(MotorId, f64)>],
) -> Vec<(usize, [f64; 2])> {
    let mut all = Vec::new();
    for place in places {
        let mut base = compiled.program.start.motors[..model.motors.len()].to_vec();
        for (motor, value) in place {
            base[motor.index()] = *value;
        }
        for (motor, value) in place {
            let mut cases = requirement.cases.iter();
            let case = cases.find(|case| case.motor == *motor);
            let ends = case.map(|case| case.ends).or_else(|| {
                let reach = Reach::of(model, compiled, *motor, &base);
                reach.ok().map(|reach| match reach.basis {
                    Basis::Round => [value - PI, value + PI],
                    _ => reach.ends,
                })
            });
            let found = ends.map_or(Vec::new(), |ends| {
                failing(model, compiled, requirement, (*motor, ends), place)
            });
            all.extend(found.into_iter().map(|ends| (motor.index(), ends)));
        }
    }
    all
}
