//! Moves as journeys of `mech_core::journey`.

use super::{Motors, MoveLimits, Position, Stepping, Stop, Watched};
use crate::{Blocked, Cause, Scalar};
use mech_core::journey::{AtZero, Growth, Journey, Standing, Turn, Watch};
use mech_core::motors;

/// A move from a position to a target.
pub(super) struct Move<
    'a,
    T: 'static,
    const M: usize,
    const L: usize,
    const K: usize,
    const W: usize,
    S,
> {
    limits: &'a MoveLimits<T, M, W>,
    start: &'a Position<T, M, L, K>,
    target: Motors<T, M>,
    displacements: [T; M],
    step: &'a S,
}

impl<'a, T, const M: usize, const L: usize, const K: usize, const W: usize, S>
    Move<'a, T, M, L, K, W, S>
where
    T: Scalar,
    S: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
{
    #[inline]
    pub(super) fn new(
        limits: &'a MoveLimits<T, M, W>,
        start: &'a Position<T, M, L, K>,
        target: Motors<T, M>,
        step: &'a S,
    ) -> Self {
        Self { displacements: start.motors.displacement_to(&target), limits, start, target, step }
    }

    #[inline]
    pub(super) fn to(
        &self,
        last: &Position<T, M, L, K>,
        motors: Motors<T, M>,
    ) -> Result<Position<T, M, L, K>, Stop> {
        let position = (self.step)(last, motors)?;
        if self.limits.overflows && !position.is_finite() {
            return Err(Stop::new("", Cause::Overflow));
        }
        Ok(position)
    }

    pub(super) fn motors(&self, part: T) -> Motors<T, M> {
        if part >= T::ONE {
            return self.target;
        }
        let mut motors = self.start.motors;
        for (value, displacement) in motors.values.iter_mut().zip(self.displacements) {
            *value += displacement * part;
        }
        motors
    }

    /// The error of a move that stops after this part of it.
    #[cold]
    pub(super) fn error_at(&self, part: T, stop: Stop) -> Blocked<[T; M]> {
        Blocked::new(stop.place, stop.cause, self.motors(part).total()).of(self.limits.inputs)
    }

    /// The index in the state of the number that tells where a watched loop is beside a change point.
    fn place_of_standing(&self, index: usize) -> Option<usize> {
        Some(self.limits.motion_signs? + M + index)
    }

    /// A number of the state by which a loop is watched. `None` for a loop that does not exist.
    fn state(
        &self,
        position: &Position<T, M, L, K>,
        index: usize,
        place: impl Fn(&Watched<T, M>) -> usize,
    ) -> Option<T> {
        let place = self.limits.watched.get(index).map(place);
        place.and_then(|place| position.state.get(place).copied())
    }
}

impl<T, const M: usize, const L: usize, const K: usize, const W: usize, S> Journey<T>
    for Move<'_, T, M, L, K, W, S>
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
        // A loop that does not exist stops every move. The compiler cannot see that nobody asks for it.
        let Some(watched) = self.limits.watched.get(index) else {
            return Watch {
                change: T::ONE / T::ZERO,
                guessed: false,
                at_zero: AtZero::Stop,
                iterated: false,
            };
        };
        Watch {
            change: motors::change(watched.rates, &self.displacements),
            guessed: watched.guessed,
            at_zero: watched.at_zero,
            iterated: watched.iterated,
        }
    }

    #[inline]
    fn sine(&self, position: &Self::Position, index: usize) -> T {
        self.state(position, index, |watched| watched.sine).unwrap_or(T::ONE)
    }

    #[inline]
    fn growth(&self, index: usize) -> impl Iterator<Item = Growth<T>> {
        let watched = self.limits.watched.get(index);
        let growth = watched.map(|watched| watched.growth);
        growth.into_iter().flatten().copied()
    }

    #[inline]
    fn follows(&self) -> usize {
        self.limits.follows.len()
    }

    #[inline]
    fn turn(&self, index: usize) -> Turn<T> {
        let followed = self.limits.follows.get(index);
        let rates = followed.map(|followed| followed.rates);
        Turn {
            change: motors::change(rates.into_iter().flatten(), &self.displacements),
            guessed: followed.is_some_and(|followed| followed.guessed),
        }
    }

    #[inline]
    fn angle(&self, position: &Self::Position, index: usize) -> T {
        let followed = self.limits.follows.get(index);
        let angle = followed.and_then(|followed| position.state.get(followed.angle));
        angle.copied().unwrap_or(T::ZERO)
    }

    #[inline]
    fn turn_growth(&self, index: usize) -> impl Iterator<Item = Growth<T>> {
        let growth = self.limits.follows.get(index).map(|followed| followed.growth);
        growth.into_iter().flatten().copied()
    }

    #[inline]
    fn input(&self, position: &Self::Position, input: usize) -> T {
        position.motors.total().get(input).copied().unwrap_or(T::ZERO)
    }

    fn rounding_square(&self, position: &Self::Position, index: usize) -> T {
        self.state(position, index, |watched| watched.rounding_square).unwrap_or(T::ZERO)
    }

    fn turn_over(&self, position: &mut Self::Position, index: usize) {
        if let Some(watched) = self.limits.watched.get(index)
            && let Some(sine) = position.state.get_mut(watched.sine)
        {
            *sine = -*sine;
        }
    }

    fn standing(&self, position: &Self::Position, index: usize) -> Standing {
        let place = self.place_of_standing(index);
        let number = place.and_then(|place| position.state.get(place));
        number.map_or(Standing::Away, |number| Standing::of(*number))
    }

    fn set_standing(&self, position: &mut Self::Position, index: usize, standing: Standing) {
        let place = self.place_of_standing(index);
        if let Some(number) = place.and_then(|place| position.state.get_mut(place)) {
            *number = standing.number();
        }
    }

    fn beyond(&self, before: &Self::Position, at: &Self::Position) -> Self::Position {
        let mut beyond = *at;
        for (pose, before) in beyond.poses.iter_mut().zip(before.poses) {
            *pose = motors::mirrored_pose(before.into(), (*pose).into()).into();
        }
        let watched = self.limits.watched.iter();
        let watched = watched.map(|watched| [watched.sine, watched.rounding_square]);
        motors::mirror_state(&mut beyond.state, &before.state, self.limits.motion_signs, &watched);
        beyond
    }

    fn sense(&self, position: &Self::Position, index: usize) -> T {
        let (Some(first), Some(watched)) =
            (self.limits.motion_signs, self.limits.watched.get(index))
        else {
            return T::ZERO;
        };
        let motion_signs = position.state.get(first..).unwrap_or_default();
        motors::along(watched.rates, &self.displacements, motion_signs)
    }

    #[inline]
    fn note_motion_signs(&self, position: &mut Self::Position) {
        self.limits.note_motion_signs(position, &self.displacements);
    }

    fn is_open(&self, stop: &Stop, index: usize) -> bool {
        let place = self.limits.watched.get(index).map(|watched| watched.place);
        stop.cause == Cause::Open && place == Some(stop.place)
    }

    fn stopped_at(&self, index: usize) -> Stop {
        let place = self.limits.watched.get(index).map(|watched| watched.place);
        Stop::new(place.unwrap_or_default(), Cause::ChangePoint)
    }

    fn too_far(&self) -> Stop {
        Stop::new("", Cause::TooFar)
    }

    #[inline]
    fn pieces(&self) -> T {
        motors::pieces(self.limits.max_steps.into_iter().flatten(), &self.displacements)
    }

    #[inline]
    fn is_one_piece(&self) -> bool {
        motors::in_one_piece(self.limits.max_steps.into_iter().flatten(), &self.displacements)
    }

    fn subdivides(&self) -> bool {
        self.limits.stepping == Stepping::Subdivided
    }
}
