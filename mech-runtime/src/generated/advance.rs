//! Moves: in one step where nothing can stop them, else as a journey.

use super::journey::Move;
use super::{Motors, MoveLimits, Position, Stepping, Stop, finite};
use crate::{Blocked, Cause, Reached, Scalar};
use mech_core::journey::{self, Journey};

/// Moves to the target. `step` computes a position for any motor values, `step_reduced` only for those within the limits' reduced range.
///
/// # Errors
/// If a motor's value is not finite, or something stops the move: then with the motors' values where it would have stopped.
#[expect(
    clippy::inline_always,
    reason = "the half of it that is hot is a few comparisons around the step"
)]
#[inline(always)]
pub fn advance<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &mut Position<T, M, L, K>,
    target: Motors<T, M>,
    limits: &MoveLimits<T, M, W>,
    step_reduced: impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
    step: impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<(), Blocked<[T; M]>>
where
    T: Scalar,
{
    // Without an operating system memory is scarce: there all moves share one step.
    #[cfg(not(feature = "std"))]
    let step_reduced = {
        if limits.stepping == Stepping::Afresh {
            return straight(position, target, limits, &step);
        }
        let _ = step_reduced;
        &step
    };
    if target.is_within(limits.reduced_range) && limits.contains(&target) {
        if limits.is_free() {
            if let Ok(there) = step_reduced(position, target)
                && (!limits.overflows || there.is_finite())
            {
                *position = there;
                return Ok(());
            }
        } else {
            let going = Move::new(limits, position, target, &step_reduced);
            if let Ok(mut there) = going.to(position, target)
                && journey::is_clear(&going, position, &there, T::ONE)
            {
                going.note_motion_signs(&mut there);
                *position = there;
                return Ok(());
            }
        }
    }
    follow(position, target, limits, &step)
}

/// The same where something may stop the move.
#[cold]
#[inline(never)]
pub(super) fn follow<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &mut Position<T, M, L, K>,
    target: Motors<T, M>,
    limits: &MoveLimits<T, M, W>,
    step: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<(), Blocked<[T; M]>>
where
    T: Scalar,
{
    if limits.stepping == Stepping::Afresh {
        return straight(position, target, limits, step);
    }
    if let Some(blocked) = refusal(position, &target, limits) {
        return Err(blocked);
    }
    let start = *position;
    let going = Move::new(limits, &start, target, step);
    match journey::travel(&going, &start) {
        Ok(there) => {
            *position = there;
            Ok(())
        }
        Err(halt) => Err(going.error_at(halt.part, halt.stop)),
    }
}

/// The error of a target that is refused before anything moves: a value is not finite, or outside its range.
fn refusal<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &Position<T, M, L, K>,
    target: &Motors<T, M>,
    limits: &MoveLimits<T, M, W>,
) -> Option<Blocked<[T; M]>>
where
    T: Scalar,
{
    if let Err(stop) = finite(target.values, limits.inputs) {
        return Some(position.refuse(stop, limits.inputs));
    }
    let (stop, reached) = limits.leaves(&position.motors, target)?;
    Some(Blocked::new(stop.place, stop.cause, reached.total()).of(limits.inputs))
}

/// The same where a position depends on the motors alone.
#[inline]
fn straight<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &mut Position<T, M, L, K>,
    target: Motors<T, M>,
    limits: &MoveLimits<T, M, W>,
    step: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<(), Blocked<[T; M]>>
where
    T: Scalar,
{
    if limits.overflows {
        straight_by(position, target, limits, &|last, motors| {
            take::<_, _, _, _, true>(step, last, motors)
        })
    } else {
        straight_by(position, target, limits, &|last, motors| {
            take::<_, _, _, _, false>(step, last, motors)
        })
    }
}

#[inline]
fn straight_by<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &mut Position<T, M, L, K>,
    target: Motors<T, M>,
    limits: &MoveLimits<T, M, W>,
    take: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<(), Blocked<[T; M]>>
where
    T: Scalar,
{
    if target.is_finite()
        && limits.contains(&target)
        && let Ok(there) = take(position, target)
    {
        *position = there;
        return Ok(());
    }
    Err(obstacle(position, target, limits, take))
}

/// A step that may overflow. Where memory is scarce, all moves share it.
#[cfg_attr(feature = "std", inline)]
#[cfg_attr(not(feature = "std"), inline(never))]
fn take<T, const M: usize, const L: usize, const K: usize, const OVERFLOWS: bool>(
    step: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
    last: &Position<T, M, L, K>,
    motors: Motors<T, M>,
) -> Result<Position<T, M, L, K>, Stop>
where
    T: Scalar,
{
    let found = step(last, motors);
    if OVERFLOWS
        && let Ok(there) = &found
        && !there.is_finite()
    {
        return Err(Stop::new("", Cause::Overflow));
    }
    found
}

/// The error of a move whose position depends on the motors alone.
#[cold]
#[inline(never)]
fn obstacle<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &Position<T, M, L, K>,
    target: Motors<T, M>,
    limits: &MoveLimits<T, M, W>,
    take: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Blocked<[T; M]>
where
    T: Scalar,
{
    if let Some(blocked) = refusal(position, &target, limits) {
        return blocked;
    }
    let going = Move::new(limits, position, target, take);
    let stop = |part| take(position, going.motors(part)).err();
    let (part, beyond) = journey::bisect(|part| stop(part).is_some());
    going.error_at(part, stop(beyond).unwrap_or(going.too_far()))
}

/// Moves towards the target, as far as it can.
///
/// # Errors
/// If a motor's value is not finite.
pub fn approach<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &mut Position<T, M, L, K>,
    target: Motors<T, M>,
    limits: &MoveLimits<T, M, W>,
    step: impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<Reached<[T; M]>, Blocked<[T; M]>>
where
    T: Scalar,
{
    if let Err(stop) = finite(target.values, limits.inputs) {
        return Err(position.refuse(stop, limits.inputs));
    }
    let start = *position;
    let (end, target) = match limits.leaves(&start.motors, &target) {
        None => (Reached::Target, target),
        Some((stop, reached)) => {
            let blocked = Blocked::new(stop.place, stop.cause, reached.total()).of(limits.inputs);
            (Reached::Limit(blocked), reached)
        }
    };
    let going = Move::new(limits, &start, target, &step);
    match journey::travel(&going, &start) {
        Ok(arrived) => {
            *position = arrived;
            Ok(end)
        }
        Err(halt) => {
            *position = halt.position;
            Ok(Reached::Limit(going.error_at(halt.part, halt.stop)))
        }
    }
}
