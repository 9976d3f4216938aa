//! More motors than needed, which follow a point: whether they move it every way.

use crate::evaluate::Machine;
use crate::model::{Inverse, Model};
use crate::program::Program;
use crate::structure::{Diagnosis, InverseTrouble};
use nalgebra::DMatrix;

/// So far motors are moved to see whether they are bound elsewhere, too: in radians, or parts of the size.
const STEP: f64 = 0.05;

/// A matrix whose least singular value is a smaller part of the greatest has no full rank.
const ROUNDING: f64 = 1e-7;

/// Tests that the motors move what is given every way at the start.
///
/// # Errors
/// Whether they do so nowhere, or not at the start.
pub(super) fn check(model: &Model, inverse: &Inverse, moving: &Program) -> Result<(), Diagnosis> {
    if moves_every_way(model, inverse, moving, 0.0) {
        return Ok(());
    }
    let is_bound =
        ![STEP, -STEP].into_iter().any(|step| moves_every_way(model, inverse, moving, step));
    let trouble = if is_bound {
        InverseTrouble::Bound
    } else {
        let unknowns = Vec::new();
        InverseTrouble::DeadStart { unknowns }
    };
    Err(Diagnosis::Inverse { trouble })
}

/// Whether the motors move what is given every way, where each has gone a step from the start, none as far as another. Not where they do
/// not come.
fn moves_every_way(model: &Model, inverse: &Inverse, moving: &Program, step: f64) -> bool {
    let size = model.size().max(f64::MIN_POSITIVE);
    let mut machine = Machine::<f64>::new(moving);
    let mut motors = machine.position().motors[..model.motors.len()].to_vec();
    for (number, motor) in (1_i32..).zip(&inverse.motors) {
        motors[motor.index()] += step * model.unit_of(*motor) / f64::from(number);
    }
    if step != 0.0 && machine.move_to(&motors).is_err() {
        return false;
    }
    let at = inverse.point.map_or([0.0; 2], |point| model.axis(point).at);
    let Some(stored) = moving.stored.iter().position(|link| *link == inverse.link) else {
        return false;
    };
    let [cos, sin, ..] = machine.position().poses[stored];
    let arm = [cos * at[0] - sin * at[1], sin * at[0] + cos * at[1]];
    let rest = vec![0.0; motors.len()];
    let columns = inverse.motors.iter().map(|motor| {
        let mut rates = rest.clone();
        rates[motor.index()] = model.unit_of(*motor);
        let found = machine.motion(&rates, &rest).ok()?;
        let [angular, x, y] = found.velocities[stored];
        Some([x - angular * arm[1], y + angular * arm[0], size * angular])
    });
    let Some(columns) = columns.collect::<Option<Vec<[f64; 3]>>>() else {
        return false;
    };
    let matrix =
        DMatrix::from_fn(inverse.given().len(), columns.len(), |row, column| columns[column][row]);
    let singular = matrix.singular_values();
    singular.min() > ROUNDING * singular.max()
}
