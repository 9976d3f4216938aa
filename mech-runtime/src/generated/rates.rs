//! Moves with the rates of everything.

use super::advance::follow;
use super::beside;
use super::interpolation::Interpolated;
use super::journey::Move;
use super::{Motors, MoveLimits, Position, Stop};
use crate::{Blocked, Cause, Scalar};
use mech_core::journey;

/// Moves to the target and returns the rates there. `step_full` computes positions and rates for any motor values, `step_reduced` only
/// within the limits' reduced range; `step` computes positions alone.
///
/// # Errors
/// If a motor's value is not finite, something stops the move, or rates are not determined at its end. The position then stays the same.
#[expect(
    clippy::inline_always,
    reason = "the half of it that is hot is a few comparisons around the step"
)]
#[inline(always)]
pub fn advance_with<T, R, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &mut Position<T, M, L, K>,
    target: Motors<T, M>,
    limits: &MoveLimits<T, M, W>,
    step_reduced: impl Fn(
        &Position<T, M, L, K>,
        Motors<T, M>,
    ) -> Result<(Position<T, M, L, K>, R), Stop>,
    step_full: impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<(Position<T, M, L, K>, R), Stop>,
    step: impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<R, Blocked<[T; M]>>
where
    T: Scalar,
    R: Interpolated<T>,
{
    // As in `advance`.
    #[cfg(not(feature = "std"))]
    let step_reduced = {
        let _ = step_reduced;
        &step_full
    };
    if target.is_within(limits.reduced_range)
        && limits.contains(&target)
        && let Ok((mut there, rates)) = step_reduced(position, target)
        && rates.is_finite()
        && (!limits.overflows || there.is_finite())
    {
        let going = Move::new(limits, position, target, &step);
        let is_sure = !limits.is_near_change_point(&there);
        if limits.is_free() || is_sure && journey::is_clear(&going, position, &there, T::ONE) {
            journey::Journey::note_motion_signs(&going, &mut there);
            *position = there;
            return Ok(rates);
        }
    }
    follow_with(position, target, limits, &step_full, &step)
}

/// The same where something may stop the move.
#[cold]
#[inline(never)]
fn follow_with<T, R, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &mut Position<T, M, L, K>,
    target: Motors<T, M>,
    limits: &MoveLimits<T, M, W>,
    step_full: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<(Position<T, M, L, K>, R), Stop>,
    step: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<R, Blocked<[T; M]>>
where
    T: Scalar,
    R: Interpolated<T>,
{
    let start = *position;
    follow(position, target, limits, step)?;
    rates_at(position, limits, step_full, step).map_err(|stop| {
        let reached = position.motors.total();
        *position = start;
        Blocked::new(stop.place, stop.cause, reached).of(limits.inputs)
    })
}

/// The rates at the present position: beside a change point their limit, if they have one.
///
/// # Errors
/// If they are not determined, or not finite.
pub fn rates_at<T, R, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &Position<T, M, L, K>,
    limits: &MoveLimits<T, M, W>,
    step_full: impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<(Position<T, M, L, K>, R), Stop>,
    step: impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<R, Stop>
where
    T: Scalar,
    R: Interpolated<T>,
{
    if limits.is_near_change_point(position)
        && let Some(rates) = beside::rates(position, limits, &step_full, &step)
        && rates.is_finite()
    {
        return Ok(rates);
    }
    match step_full(position, position.motors) {
        Ok((_, rates)) if rates.is_finite() => Ok(rates),
        Ok(_) => Err(Stop::new("", Cause::Overflow)),
        // A loop that closed here and now does not is at its limit.
        Err(stop) => Err(Stop::new(stop.place, Cause::Singular)),
    }
}
