//! What is known at compile time about every move.

use super::{Motors, Stop};
use crate::blocked::Input;
use crate::{Cause, Scalar};
use mech_core::journey::{AtZero, Growth};

/// A loop that has dead points or change points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watched<T: 'static, const MOTORS: usize> {
    /// The index in the state of the sine of its transmission angle.
    pub sine: usize,
    /// The index in the state of the square of a sine below which rounding hides its sign.
    pub rounding_square: usize,
    /// By how much the square of the sine changes with each motor, at most.
    pub rates: [T; MOTORS],
    /// What increases that.
    pub growth: &'static [Growth<T>],
    /// Whether these are no bounds but guesses.
    pub guessed: bool,
    /// What happens at a change point.
    pub at_zero: AtZero,
    /// Whether it is solved by iteration.
    pub iterated: bool,
    /// The joints of the loop whose coordinates are unknown.
    pub place: &'static str,
}

/// An angle that is followed over whole turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Followed<T: 'static, const MOTORS: usize> {
    /// By how much it changes with each motor, at most.
    pub rates: [T; MOTORS],
    /// What increases that.
    pub growth: &'static [Growth<T>],
}

/// How a position is found from the last one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stepping {
    /// It depends on the motors alone: every loop is closed in closed form, and nothing is carried.
    Afresh,
    /// It depends on the last one too.
    Onwards,
    /// The same, and steps that fail are subdivided.
    Subdivided,
}

/// What is known at compile time about every move.
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
    /// How a position is found from the last one.
    pub stepping: Stepping,
    /// Whether something may move beyond the range of the numbers.
    pub overflows: bool,
    /// Up to this value of every motor no angle has to be reduced before its sine and cosine are computed.
    pub reduced_range: T,
    /// The longest displacement of each motor in one piece, where no bound is known for coupled loops.
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

    /// Where the straight displacement to these values leaves the declared ranges, if it does.
    pub(super) fn leaves(
        &self,
        from: &Motors<T, MOTORS>,
        to: &Motors<T, MOTORS>,
    ) -> Option<(Stop, Motors<T, MOTORS>)> {
        let range = self.range.as_ref()?;
        let (start, end, displacements) = (from.total(), to.total(), from.displacement_to(to));
        let mut first: Option<(usize, T, T)> = None;
        let motors = range.iter().zip(start).zip(end).zip(displacements);
        for (motor, ((([low, high], start), end), displacement)) in motors.enumerate() {
            let bound = if end < *low {
                *low
            } else if end > *high {
                *high
            } else {
                continue;
            };
            let part = (bound - start) / displacement;
            if first.is_none_or(|(_, least, _)| part < least) {
                first = Some((motor, part, bound));
            }
        }
        let (motor, part, bound) = first?;
        let mut reached = start;
        for (value, displacement) in reached.iter_mut().zip(displacements) {
            *value += displacement * part;
        }
        // Not a rounding beyond the end of its range.
        if let Some(value) = reached.get_mut(motor) {
            *value = bound;
        }
        let name = self.inputs.get(motor).map_or("", Input::name);
        Some((Stop::new(name, Cause::OutOfRange), Motors::new(reached)))
    }
}
