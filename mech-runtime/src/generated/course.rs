//! A move: in one step where nothing is in the way, else as a journey.

use super::{Motors, Position, Stop};
use crate::{Blocked, Cause, Reached, Scalar};
use mech_core::journey::{self, AtZero, Halt, Journey, Watch};

/// A loop in closed form that has dead points or change points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watched<T, const MOTORS: usize> {
    /// Where the sine of its transmission angle is kept; after it, the square of a sine below which rounding hides its sign.
    pub kept: usize,
    /// By how much the square of the sine changes with each motor, at most.
    pub rates: [T; MOTORS],
    /// What happens at a change point.
    pub at_zero: AtZero,
    /// The joints of the loop whose coordinates are unknown.
    pub place: &'static str,
}

/// What is known at compile time about every move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Course<T: 'static, const MOTORS: usize, const WATCHED: usize> {
    /// The names of the motors.
    pub names: [&'static str; MOTORS],
    /// The loops that are watched.
    pub watched: [Watched<T, MOTORS>; WATCHED],
    /// Where the senses of the motors are kept, if a loop passes change points.
    pub senses: Option<usize>,
    /// Whether steps that fail are subdivided.
    pub subdivides: bool,
    /// Whether something may move beyond the range of the numbers.
    pub overflows: bool,
}

/// A move under way.
struct Way<'a, T: 'static, const M: usize, const L: usize, const K: usize, const W: usize, S> {
    course: &'a Course<T, M, W>,
    start: &'a Position<T, M, L, K>,
    target: Motors<T, M>,
    way: [T; M],
    step: S,
}

impl<T, const M: usize, const L: usize, const K: usize, const W: usize, S> Way<'_, T, M, L, K, W, S>
where
    T: Scalar,
    S: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
{
    #[inline]
    fn to(
        &self,
        last: &Position<T, M, L, K>,
        motors: Motors<T, M>,
    ) -> Result<Position<T, M, L, K>, Stop> {
        let position = (self.step)(last, motors)?;
        if self.course.overflows {
            position.checked()
        } else {
            Ok(position)
        }
    }

    fn motors(&self, part: T) -> Motors<T, M> {
        if part >= T::ONE {
            return self.target;
        }
        let mut motors = self.start.motors;
        for (value, way) in motors.values.iter_mut().zip(self.way) {
            *value += way * part;
        }
        motors
    }

    fn kept(&self, position: &Position<T, M, L, K>, index: usize) -> T {
        let kept = self.course.watched.get(index).map(|watched| watched.kept);
        kept.and_then(|kept| position.kept.get(kept).copied())
            .unwrap_or(T::ONE)
    }
}

impl<T, const M: usize, const L: usize, const K: usize, const W: usize, S> Journey<T>
    for Way<'_, T, M, L, K, W, S>
where
    T: Scalar,
    S: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
{
    type Position = Position<T, M, L, K>;
    type Stop = Stop;

    fn at(&self, last: &Self::Position, part: T) -> Result<Self::Position, Stop> {
        self.to(last, self.motors(part))
    }

    #[inline]
    fn watches(&self) -> usize {
        W
    }

    #[inline]
    fn watch(&self, index: usize) -> Watch<T> {
        let watched = &self.course.watched[index];
        let mut change = T::ZERO;
        for (rate, way) in watched.rates.iter().zip(self.way) {
            change += *rate * mech_core::Real::abs(way);
        }
        Watch {
            change,
            at_zero: watched.at_zero,
        }
    }

    #[inline]
    fn sine(&self, position: &Self::Position, index: usize) -> T {
        self.kept(position, index)
    }

    fn tiny_square(&self, position: &Self::Position, index: usize) -> T {
        let kept = self.course.watched.get(index).map(|watched| watched.kept);
        kept.and_then(|kept| position.kept.get(kept + 1).copied())
            .unwrap_or(T::ZERO)
    }

    fn turn_over(&self, position: &mut Self::Position, index: usize) {
        if let Some(watched) = self.course.watched.get(index)
            && let Some(sine) = position.kept.get_mut(watched.kept)
        {
            *sine = -*sine;
        }
    }

    fn goes_on(&self, position: &Self::Position, index: usize) -> bool {
        let (Some(first), Some(watched)) = (self.course.senses, self.course.watched.get(index))
        else {
            return false;
        };
        let mut along = T::ZERO;
        for (motor, (rate, way)) in watched.rates.iter().zip(self.way).enumerate() {
            let sense = position.kept.get(first + motor).copied();
            along += *rate * way * sense.unwrap_or(T::ZERO);
        }
        along > T::ZERO
    }

    #[inline]
    fn note_sense(&self, position: &mut Self::Position) {
        let Some(first) = self.course.senses else {
            return;
        };
        for (sense, way) in position.kept.iter_mut().skip(first).zip(self.way) {
            if way != T::ZERO {
                *sense = mech_core::Real::copysign(T::ONE, way);
            }
        }
    }

    fn stopped_at(&self, index: usize) -> Stop {
        let place = self.course.watched.get(index).map(|watched| watched.place);
        Stop::new(place.unwrap_or_default(), Cause::ChangePoint)
    }

    fn too_far(&self) -> Stop {
        Stop::new("", Cause::TooFar)
    }

    fn subdivides(&self) -> bool {
        self.course.subdivides
    }
}

/// Moves to the target.
///
/// # Errors
/// If a motor's value is not finite, or something is in the way: then with the motors' values where it would have stopped.
#[inline]
pub fn advance<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    start: &Position<T, M, L, K>,
    target: Motors<T, M>,
    course: &Course<T, M, W>,
    step: impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<Position<T, M, L, K>, Blocked<[T; M]>>
where
    T: Scalar,
{
    if let Some(stop) = target.not_finite(&course.names) {
        return Err(start.refuse(stop));
    }
    let way = Way {
        way: start.motors.way_to(&target),
        course,
        start,
        target,
        step,
    };
    if let Ok(mut position) = way.to(start, target)
        && journey::is_clear(&way, start, &position, T::ONE)
    {
        way.note_sense(&mut position);
        return Ok(position);
    }
    travel(&way).map_err(|halt| blocked(&way, &halt))
}

/// Moves towards the target, as far as it can.
///
/// # Errors
/// If a motor's value is not finite.
pub fn approach<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &mut Position<T, M, L, K>,
    target: Motors<T, M>,
    course: &Course<T, M, W>,
    step: impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<Reached<[T; M]>, Blocked<[T; M]>>
where
    T: Scalar,
{
    if let Some(stop) = target.not_finite(&course.names) {
        return Err(position.refuse(stop));
    }
    let start = *position;
    let way = Way {
        way: start.motors.way_to(&target),
        course,
        start: &start,
        target,
        step,
    };
    match travel(&way) {
        Ok(arrived) => {
            *position = arrived;
            Ok(Reached::Target)
        }
        Err(halt) => {
            *position = halt.position;
            Ok(Reached::Limit(blocked(&way, &halt)))
        }
    }
}

#[cold]
#[inline(never)]
fn travel<T: Scalar, J: Journey<T>>(way: &J) -> Result<J::Position, Halt<J::Position, J::Stop, T>>
where
    J: Start<T>,
{
    journey::go(way, way.start())
}

/// Where a journey begins.
trait Start<T: Scalar>: Journey<T> {
    fn start(&self) -> &Self::Position;
}

impl<T, const M: usize, const L: usize, const K: usize, const W: usize, S> Start<T>
    for Way<'_, T, M, L, K, W, S>
where
    T: Scalar,
    S: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
{
    fn start(&self) -> &Self::Position {
        self.start
    }
}

#[cold]
fn blocked<T, const M: usize, const L: usize, const K: usize, const W: usize, S>(
    way: &Way<'_, T, M, L, K, W, S>,
    halt: &Halt<Position<T, M, L, K>, Stop, T>,
) -> Blocked<[T; M]>
where
    T: Scalar,
    S: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
{
    let reached = way.motors(halt.part).total();
    Blocked::new(halt.stop.place, halt.stop.cause, reached)
}
