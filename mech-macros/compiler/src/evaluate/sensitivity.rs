//! Sensitivities by interpretation.

use super::Stop;
use super::run::{MotionInputs, Runner};
use crate::program::{ParamRates, Position, Program, Value};
use mech_core::Real;

/// The rates of everything with each param at a position, by the program that computes them.
///
/// # Errors
/// If a loop is at a dead point or a change point, where that is not determined, or if the program does not compute it.
pub fn sensitivities<T: Real>(
    program: &Program,
    at: &Position<T>,
) -> Result<Vec<ParamRates<T>>, Stop> {
    let sensitivity = program.sensitivity().ok_or(Stop::Unasked)?;
    let given = MotionInputs {
        rates: &[],
        accelerations: &[],
        loads: &[],
    };
    let values = Runner::new(program).determined_values(at, given)?;
    let rates = sensitivity.of_params.iter();
    let rates: Vec<ParamRates<T>> = rates
        .map(|rates| rates.map(|value: Value| values[value.index()]))
        .collect();
    let is_finite = |rates: &ParamRates<T>| rates.roots().all(Real::is_finite);
    if rates.iter().all(is_finite) {
        Ok(rates)
    } else {
        Err(Stop::Overflow)
    }
}
