//! Sensitivities by interpretation.

use super::Stop;
use super::run::{Given, Runner};
use crate::program::{Position, Program};
use mech_core::Real;

/// The rates of everything if one param alone changes, at a rate of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Followed<T> {
    /// For each moving link its angular velocity, and the rates of x and y.
    pub links: Vec<[T; 3]>,
    /// For each exposed point the rates of its place.
    pub points: Vec<[T; 2]>,
    /// For each exposed joint the rate of its coordinate.
    pub joints: Vec<T>,
}

/// The rates of everything with each param at a position, by the program that computes them.
///
/// # Errors
/// If a loop is at a dead point or a change point, where that is not determined, or if the program does not compute it.
pub fn sensitivities<T: Real>(
    program: &Program,
    at: &Position<T>,
) -> Result<Vec<Followed<T>>, Stop> {
    let sensitivity = program.sensitivity.as_ref().ok_or(Stop::Unasked)?;
    let given = Given {
        rates: &[],
        accelerations: &[],
        loads: &[],
    };
    let values = Runner::new(program).determined_values(at, given)?;
    let get = |value: &crate::program::Value| values[value.index()];
    let of_params = sensitivity.of_params.iter().map(|rates| Followed {
        links: rates
            .links
            .iter()
            .map(|link| link.each_ref().map(get))
            .collect(),
        points: rates
            .points
            .iter()
            .map(|point| point.each_ref().map(get))
            .collect(),
        joints: rates.joints.iter().map(get).collect(),
    });
    let of_params: Vec<Followed<T>> = of_params.collect();
    let numbers = of_params.iter().flat_map(|followed| {
        let links = followed.links.iter().flatten();
        let points = followed.points.iter().flatten();
        links.chain(points).chain(&followed.joints)
    });
    if numbers.into_iter().all(|number| number.is_finite()) {
        Ok(of_params)
    } else {
        Err(Stop::Overflow)
    }
}
