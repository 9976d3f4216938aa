//! Bounds of moves, from compile time.

use super::{Motors, Position, Stop};
use crate::blocked::Input;
use crate::{Cause, Scalar};
use mech_core::journey::{AtZero, Growth, Standing};
use mech_core::{limit, motors};

/// A loop that has dead points or change points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watched<T: 'static, const MOTORS: usize> {
    /// The index in the state of the sine of its transmission angle.
    pub sine: usize,
    /// The index in the state of the square of a sine below which rounding hides its sign.
    pub rounding_square: usize,
    /// The greatest rate of the square of the sine for each motor.
    pub rates: [T; MOTORS],
    /// The inputs that increase this rate.
    pub growth: &'static [Growth<T>],
    /// Whether these are guesses, not bounds.
    pub guessed: bool,
    /// The behaviour at a change point.
    pub at_zero: AtZero,
    /// Whether it is solved by iteration.
    pub iterated: bool,
    /// The joints of the loop whose coordinates are unknown.
    pub place: &'static str,
}

/// An angle that is followed over whole turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Followed<T: 'static, const MOTORS: usize> {
    /// The index in the state of the angle.
    pub angle: usize,
    /// The greatest rate of the angle for each motor.
    pub rates: [T; MOTORS],
    /// The inputs that increase this rate.
    pub growth: &'static [Growth<T>],
    /// Whether these are guesses, not bounds.
    pub guessed: bool,
}

/// The dependence of a position on the last one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stepping {
    /// It depends on the motors alone: every loop has a closed form, and there is no state.
    Afresh,
    /// It depends on the last position too.
    Onwards,
    /// The same, and steps that fail are subdivided.
    Subdivided,
}

/// Bounds of moves, from compile time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MoveLimits<T: 'static, const MOTORS: usize, const WATCHED: usize> {
    /// The motors, and after them the params.
    pub inputs: &'static [Input; MOTORS],
    /// The loops that are watched.
    pub watched: [Watched<T, MOTORS>; WATCHED],
    /// The angles that are followed over whole turns.
    pub follows: &'static [Followed<T, MOTORS>],
    /// The index in the state of the signs of the motors' last motion, if a loop passes change points.
    pub motion_signs: Option<usize>,
    /// The dependence of a position on the last one.
    pub stepping: Stepping,
    /// Whether a coordinate may overflow.
    pub overflows: bool,
    /// The greatest value of the motors for which no angle must be reduced before its sine and cosine are computed.
    pub reduced_range: T,
    /// The longest displacement of each motor in one step, where no bound is known for coupled loops.
    pub max_steps: Option<[T; MOTORS]>,
    /// The least and the greatest value of each motor, if any has a declared range.
    pub range: Option<[[T; 2]; MOTORS]>,
}

impl<T: Scalar, const MOTORS: usize, const WATCHED: usize> MoveLimits<T, MOTORS, WATCHED> {
    /// Whether nothing can stop any move.
    #[inline]
    pub(super) const fn is_free(&self) -> bool {
        WATCHED == 0
            && self.motion_signs.is_none()
            && self.max_steps.is_none()
            && self.follows.is_empty()
    }

    /// The loops that pass change points.
    #[inline]
    pub(super) fn passing(&self) -> impl Iterator<Item = &Watched<T, MOTORS>> {
        let passes = |watched: &&Watched<T, MOTORS>| watched.at_zero == AtZero::ChangeBranch;
        self.watched.iter().filter(passes)
    }

    /// Whether a loop is so near its change point that rounding spoils rates.
    #[inline]
    pub(super) fn is_near_change_point<const L: usize, const K: usize>(
        &self,
        position: &Position<T, MOTORS, L, K>,
    ) -> bool {
        let mut sines = self.passing().filter_map(|watched| position.state.get(watched.sine));
        sines.any(|sine| limit::is_near(*sine))
    }

    /// Whether no watched loop has a sine less than this.
    #[inline]
    pub(super) fn are_far<const L: usize, const K: usize>(
        &self,
        position: &Position<T, MOTORS, L, K>,
        least: T,
    ) -> bool {
        let mut watched = self.watched.iter();
        watched.all(|watched| {
            let sine = position.state.get(watched.sine);
            sine.is_some_and(|sine| sine.abs() >= least)
        })
    }

    /// Notes the sense in which the motors went to a position.
    #[inline]
    pub(super) fn note_motion_signs<const L: usize, const K: usize>(
        &self,
        position: &mut Position<T, MOTORS, L, K>,
        displacements: &[T],
    ) {
        let first = self.motion_signs;
        if let Some(signs) = first.and_then(|first| position.state.get_mut(first..)) {
            motors::note_motion_signs(signs, displacements);
        }
    }

    /// Notes that a position is beside no change point to which it came.
    #[inline]
    pub(super) fn stand_away<const L: usize, const K: usize>(
        &self,
        position: &mut Position<T, MOTORS, L, K>,
    ) {
        if let Some(signs) = self.motion_signs {
            let standings = position.state.iter_mut().skip(signs + MOTORS);
            standings.for_each(|standing| *standing = Standing::Away.number());
        }
    }

    /// Takes whole turns from angles that have turned more than once: digits are lost in large numbers.
    #[inline]
    pub(super) fn count_from_zero<const L: usize, const K: usize>(
        &self,
        position: &mut Position<T, MOTORS, L, K>,
    ) {
        for followed in self.follows {
            if let Some(angle) = position.state.get_mut(followed.angle)
                && angle.abs() > T::TURN
                && let Some((_, rest)) = angle.whole_turns()
            {
                *angle = rest;
            }
        }
    }

    /// Whether these values are within the declared ranges.
    #[inline]
    pub fn contains(&self, motors: &Motors<T, MOTORS>) -> bool {
        match &self.range {
            None => true,
            Some(range) => motors
                .total()
                .iter()
                .zip(range)
                .all(|(value, [low, high])| low <= value && value <= high),
        }
    }

    /// The place where the straight move to these values leaves the declared ranges, if it does.
    pub(super) fn leaves(
        &self,
        from: &Motors<T, MOTORS>,
        to: &Motors<T, MOTORS>,
    ) -> Option<(Stop, Motors<T, MOTORS>)> {
        let range = self.range.as_ref()?;
        let (start, end, displacements) = (from.total(), to.total(), from.displacement_to(to));
        let mut first: Option<(usize, &Input, T, T)> = None;
        let motors = self.inputs.iter().zip(range).zip(start).zip(end);
        for (index, (motor, displacement)) in motors.zip(displacements).enumerate() {
            let (((input, [low, high]), start), end) = motor;
            let bound = if end < *low {
                *low
            } else if end > *high {
                *high
            } else {
                continue;
            };
            let part = (bound - start) / displacement;
            if first.is_none_or(|(_, _, least, _)| part < least) {
                first = Some((index, input, part, bound));
            }
        }
        let (motor, input, part, bound) = first?;
        let mut reached = start;
        for (index, (value, displacement)) in reached.iter_mut().zip(displacements).enumerate() {
            // Rounding must not carry the motor beyond the end of its range.
            *value = if index == motor { bound } else { *value + displacement * part };
        }
        let stop = Stop::new(input.name(), Cause::OutOfRange);
        Some((stop, Motors::new(reached)))
    }
}
