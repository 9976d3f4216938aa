//! Mechanisms with params. Inside, a param is an input like a motor, after all motors; outside, the two are apart.

use super::{Motors, Position, Rates, Stop};
use crate::{Blocked, Cause, Reached, Real, Scalar, Velocity};

/// The values of the motors among those of all inputs.
#[must_use]
pub fn motors_of<T: Scalar, const ALL: usize, const MOTORS: usize>(all: [T; ALL]) -> [T; MOTORS] {
    const { assert!(MOTORS <= ALL, "every motor is an input") }
    core::array::from_fn(|motor| all.get(motor).copied().unwrap_or(T::ZERO))
}

/// The values of the params among those of all inputs: the last.
#[must_use]
pub fn params_of<T: Scalar, const ALL: usize, const PARAMS: usize>(all: [T; ALL]) -> [T; PARAMS] {
    const { assert!(PARAMS <= ALL, "every param is an input") }
    let motors = ALL - PARAMS;
    core::array::from_fn(|param| all.get(motors + param).copied().unwrap_or(T::ZERO))
}

/// All inputs: the motors at these values, the params as they are.
#[inline]
#[must_use]
pub fn inputs<T: Scalar, const ALL: usize, const MOTORS: usize>(
    motors: [T; MOTORS],
    present: &Motors<T, ALL>,
) -> Motors<T, ALL> {
    let mut values = present.values;
    for (value, motor) in values.iter_mut().zip(motors) {
        *value = motor;
    }
    Motors::new(values)
}

/// The error with the values of the motors alone.
#[must_use]
pub fn blocked_motors<T: Scalar, const ALL: usize, const MOTORS: usize>(
    blocked: Blocked<[T; ALL]>,
) -> Blocked<[T; MOTORS]> {
    blocked.map(motors_of)
}

/// The error with the values of the params alone.
#[must_use]
pub fn blocked_params<T: Scalar, const ALL: usize, const PARAMS: usize>(
    blocked: Blocked<[T; ALL]>,
) -> Blocked<[T; PARAMS]> {
    blocked.starting_at(ALL - PARAMS).map(params_of)
}

/// The end of a move with the values of the motors alone.
pub fn reached_by_motors<T: Scalar, const ALL: usize, const MOTORS: usize>(
    reached: Reached<[T; ALL]>,
) -> Reached<[T; MOTORS]> {
    match reached {
        Reached::Target => Reached::Target,
        Reached::Limit(blocked) => Reached::Limit(blocked_motors(blocked)),
    }
}

/// The sensitivities to a param: of links, points and joints.
type ParamRates<T, const LINKS: usize, const POINTS: usize, const JOINTS: usize> =
    ([Velocity<T>; LINKS], [[T; 2]; POINTS], [T; JOINTS]);

impl<T: Scalar, const LINKS: usize, const POINTS: usize, const JOINTS: usize, const PARAMS: usize>
    Rates for [ParamRates<T, LINKS, POINTS, JOINTS>; PARAMS]
{
    fn is_finite(&self) -> bool {
        self.iter().all(|(links, points, joints)| {
            let mut numbers = points.as_flattened().iter().chain(joints);
            links.is_finite() && numbers.all(|number| Real::is_finite(*number))
        })
    }
}

/// The sensitivities at the present position.
///
/// # Errors
/// If they are not determined, or not finite.
#[inline]
pub fn followed<T, R, const M: usize, const L: usize, const K: usize>(
    position: &Position<T, M, L, K>,
    rates: impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<R, Stop>,
) -> Result<R, Stop>
where
    T: Scalar,
    R: Rates,
{
    match rates(position, position.motors) {
        Ok(rates) if rates.is_finite() => Ok(rates),
        Ok(_) => Err(Stop::new("", Cause::Overflow)),
        // A loop that closed here and now does not is at its limit.
        Err(stop) => Err(Stop::new(stop.place, Cause::Singular)),
    }
}
