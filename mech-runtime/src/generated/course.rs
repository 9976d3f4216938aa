//! A move: in one step where nothing is in the way, else as a journey.

use super::{Motors, Position, Stop, finite};
use crate::blocked::Input;
use crate::{Blocked, Cause, Pose, Reached, Scalar};
use mech_core::journey::{self, AtZero, Growth, Journey, Watch};
use mech_core::motors;

/// A loop that has dead points or change points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watched<T: 'static, const MOTORS: usize> {
    /// Where the sine of its transmission angle is kept; after it, the square of a sine below which rounding hides its sign.
    pub kept: usize,
    /// By how much the square of the sine changes with each motor, at most.
    pub rates: [T; MOTORS],
    /// What makes that more.
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
    /// What makes that more.
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
pub struct Course<T: 'static, const MOTORS: usize, const WATCHED: usize> {
    /// The motors, and after them the params.
    pub inputs: &'static [Input; MOTORS],
    /// The loops that are watched.
    pub watched: [Watched<T, MOTORS>; WATCHED],
    /// The angles that are followed over whole turns.
    pub follows: &'static [Followed<T, MOTORS>],
    /// Where the senses of the motors are kept, if a loop passes change points.
    pub senses: Option<usize>,
    /// How a position is found from the last one.
    pub stepping: Stepping,
    /// Whether something may move beyond the range of the numbers.
    pub overflows: bool,
    /// Up to this value of every motor all angles are within the range of the polynomials of sine and cosine.
    pub reach: T,
    /// How far each motor may go in one piece, where nothing tells how far coupled loops may leap.
    pub strides: Option<[T; MOTORS]>,
    /// The least and the greatest value of each motor, if any has a declared range.
    pub range: Option<[[T; 2]; MOTORS]>,
}

impl<T: Scalar, const MOTORS: usize, const WATCHED: usize> Course<T, MOTORS, WATCHED> {
    /// Whether nothing can be on any way.
    #[inline]
    pub(super) const fn is_free(&self) -> bool {
        WATCHED == 0 && self.senses.is_none() && self.strides.is_none() && self.follows.is_empty()
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

    /// Where the straight way to these values leaves the declared ranges, if it does.
    fn leaves(
        &self,
        from: &Motors<T, MOTORS>,
        to: &Motors<T, MOTORS>,
    ) -> Option<(Stop, Motors<T, MOTORS>)> {
        let range = self.range.as_ref()?;
        let (start, end, ways) = (from.total(), to.total(), from.way_to(to));
        let mut first: Option<(usize, T, T)> = None;
        let motors = range.iter().zip(start).zip(end).zip(ways);
        for (motor, ((([low, high], start), end), way)) in motors.enumerate() {
            let bound = if end < *low {
                *low
            } else if end > *high {
                *high
            } else {
                continue;
            };
            let part = (bound - start) / way;
            if first.is_none_or(|(_, least, _)| part < least) {
                first = Some((motor, part, bound));
            }
        }
        let (motor, part, bound) = first?;
        let mut reached = start;
        for (value, way) in reached.iter_mut().zip(ways) {
            *value += way * part;
        }
        // Not a rounding beyond the end of its range.
        if let Some(value) = reached.get_mut(motor) {
            *value = bound;
        }
        let name = self.inputs.get(motor).map_or("", Input::name);
        Some((Stop::new(name, Cause::OutOfRange), Motors::new(reached)))
    }
}

/// A move under way.
pub(super) struct Way<
    'a,
    T: 'static,
    const M: usize,
    const L: usize,
    const K: usize,
    const W: usize,
    S,
> {
    course: &'a Course<T, M, W>,
    start: &'a Position<T, M, L, K>,
    target: Motors<T, M>,
    ways: [T; M],
    step: &'a S,
}

impl<'a, T, const M: usize, const L: usize, const K: usize, const W: usize, S>
    Way<'a, T, M, L, K, W, S>
where
    T: Scalar,
    S: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
{
    #[inline]
    pub(super) fn new(
        course: &'a Course<T, M, W>,
        start: &'a Position<T, M, L, K>,
        target: Motors<T, M>,
        step: &'a S,
    ) -> Self {
        Self {
            ways: start.motors.way_to(&target),
            course,
            start,
            target,
            step,
        }
    }

    #[inline]
    fn to(
        &self,
        last: &Position<T, M, L, K>,
        motors: Motors<T, M>,
    ) -> Result<Position<T, M, L, K>, Stop> {
        let position = (self.step)(last, motors)?;
        if self.course.overflows && !position.is_finite() {
            return Err(Stop::new("", Cause::Overflow));
        }
        Ok(position)
    }

    fn motors(&self, part: T) -> Motors<T, M> {
        if part >= T::ONE {
            return self.target;
        }
        let mut motors = self.start.motors;
        for (value, way) in motors.values.iter_mut().zip(self.ways) {
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
        // Of a loop that is not there nothing is passed: the compiler cannot see that nobody asks.
        let Some(watched) = self.course.watched.get(index) else {
            return Watch {
                change: T::ONE / T::ZERO,
                guessed: false,
                at_zero: AtZero::Stop,
                iterated: false,
            };
        };
        Watch {
            change: motors::change(watched.rates, &self.ways),
            guessed: watched.guessed,
            at_zero: watched.at_zero,
            iterated: watched.iterated,
        }
    }

    #[inline]
    fn sine(&self, position: &Self::Position, index: usize) -> T {
        self.kept(position, index)
    }

    #[inline]
    fn growth(&self, index: usize) -> impl Iterator<Item = Growth<T>> {
        let watched = self.course.watched.get(index);
        let growth = watched.map(|watched| watched.growth);
        growth.into_iter().flatten().copied()
    }

    #[inline]
    fn follows(&self) -> usize {
        self.course.follows.len()
    }

    #[inline]
    fn turn(&self, index: usize) -> T {
        let rates = self
            .course
            .follows
            .get(index)
            .map(|followed| followed.rates);
        motors::change(rates.into_iter().flatten(), &self.ways)
    }

    #[inline]
    fn turn_growth(&self, index: usize) -> impl Iterator<Item = Growth<T>> {
        let growth = self
            .course
            .follows
            .get(index)
            .map(|followed| followed.growth);
        growth.into_iter().flatten().copied()
    }

    #[inline]
    fn input(&self, position: &Self::Position, input: usize) -> T {
        position
            .motors
            .total()
            .get(input)
            .copied()
            .unwrap_or(T::ZERO)
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

    fn beyond(&self, before: &Self::Position, at: &Self::Position) -> Self::Position {
        let mut beyond = *at;
        for (pose, before) in beyond.poses.iter_mut().zip(before.poses) {
            let parts = |pose: Pose<T>| [pose.cos, pose.sin, pose.x, pose.y];
            let [cos, sin, x, y] = motors::mirrored_pose(parts(before), parts(*pose));
            *pose = Pose { cos, sin, x, y };
        }
        let sines = self.course.watched.iter().map(|watched| watched.kept);
        motors::mirror_carried(&mut beyond.kept, &before.kept, self.course.senses, &sines);
        beyond
    }

    fn goes_on(&self, position: &Self::Position, index: usize) -> bool {
        let (Some(first), Some(watched)) = (self.course.senses, self.course.watched.get(index))
        else {
            return false;
        };
        let senses = position.kept.get(first..).unwrap_or_default();
        motors::along(watched.rates, &self.ways, senses) > T::ZERO
    }

    #[inline]
    fn note_sense(&self, position: &mut Self::Position) {
        if let Some(senses) = self
            .course
            .senses
            .and_then(|first| position.kept.get_mut(first..))
        {
            motors::note_senses(senses, &self.ways);
        }
    }

    fn is_open(&self, stop: &Stop, index: usize) -> bool {
        let place = self.course.watched.get(index).map(|watched| watched.place);
        stop.cause == Cause::Open && place == Some(stop.place)
    }

    fn stopped_at(&self, index: usize) -> Stop {
        let place = self.course.watched.get(index).map(|watched| watched.place);
        Stop::new(place.unwrap_or_default(), Cause::ChangePoint)
    }

    fn too_far(&self) -> Stop {
        Stop::new("", Cause::TooFar)
    }

    #[inline]
    fn pieces(&self) -> T {
        motors::pieces(self.course.strides.into_iter().flatten(), &self.ways)
    }

    #[inline]
    fn is_one_piece(&self) -> bool {
        motors::in_one_piece(self.course.strides.into_iter().flatten(), &self.ways)
    }

    fn subdivides(&self) -> bool {
        self.course.stepping == Stepping::Subdivided
    }
}

/// Moves to the target. `near` is the step for motor values within the course's reach, `step` that for any.
///
/// # Errors
/// If a motor's value is not finite, or something is in the way: then with the motors' values where it would have stopped.
#[expect(
    clippy::inline_always,
    reason = "the half of it that is hot is a few comparisons around the step"
)]
#[inline(always)]
pub fn advance<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &mut Position<T, M, L, K>,
    target: Motors<T, M>,
    course: &Course<T, M, W>,
    near: impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
    step: impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<(), Blocked<[T; M]>>
where
    T: Scalar,
{
    // Without an operating system memory is scarce: there all moves share one step.
    #[cfg(not(feature = "std"))]
    let near = {
        if course.stepping == Stepping::Afresh {
            return straight(position, target, course, &step);
        }
        let _ = near;
        &step
    };
    if target.is_within(course.reach) && course.contains(&target) {
        if course.is_free() {
            if let Ok(there) = near(position, target)
                && (!course.overflows || there.is_finite())
            {
                *position = there;
                return Ok(());
            }
        } else {
            let way = Way::new(course, position, target, &near);
            if let Ok(mut there) = way.to(position, target)
                && journey::is_clear(&way, position, &there, T::ONE)
            {
                way.note_sense(&mut there);
                *position = there;
                return Ok(());
            }
        }
    }
    follow(position, target, course, &step)
}

/// The same where something may be in the way.
#[cold]
#[inline(never)]
pub(super) fn follow<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &mut Position<T, M, L, K>,
    target: Motors<T, M>,
    course: &Course<T, M, W>,
    step: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<(), Blocked<[T; M]>>
where
    T: Scalar,
{
    if course.stepping == Stepping::Afresh {
        return straight(position, target, course, step);
    }
    if let Err(stop) = finite(target.values, course.inputs) {
        return Err(position.refuse(stop, course.inputs));
    }
    if let Some((stop, reached)) = course.leaves(&position.motors, &target) {
        return Err(Blocked::new(stop.place, stop.cause, reached.total()).of(course.inputs));
    }
    let start = *position;
    let way = Way::new(course, &start, target, step);
    match journey::go(&way, &start) {
        Ok(there) => {
            *position = there;
            Ok(())
        }
        Err(halt) => Err(blocked(&way, halt.part, halt.stop)),
    }
}

/// The same where a position depends on the motors alone.
#[inline]
fn straight<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &mut Position<T, M, L, K>,
    target: Motors<T, M>,
    course: &Course<T, M, W>,
    step: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<(), Blocked<[T; M]>>
where
    T: Scalar,
{
    if course.overflows {
        straight_by(position, target, course, &|last, motors| {
            take::<_, _, _, _, true>(step, last, motors)
        })
    } else {
        straight_by(position, target, course, &|last, motors| {
            take::<_, _, _, _, false>(step, last, motors)
        })
    }
}

#[inline]
fn straight_by<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &mut Position<T, M, L, K>,
    target: Motors<T, M>,
    course: &Course<T, M, W>,
    take: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Result<(), Blocked<[T; M]>>
where
    T: Scalar,
{
    if target.is_finite()
        && course.contains(&target)
        && let Ok(there) = take(position, target)
    {
        *position = there;
        return Ok(());
    }
    Err(stopped(position, target, course, take))
}

/// A step that may end beyond the range of the numbers. Where memory is scarce it is in one place, for all who take it.
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

/// Why and where a move stops, where a position depends on the motors alone.
#[cold]
#[inline(never)]
fn stopped<T, const M: usize, const L: usize, const K: usize, const W: usize>(
    position: &Position<T, M, L, K>,
    target: Motors<T, M>,
    course: &Course<T, M, W>,
    take: &impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
) -> Blocked<[T; M]>
where
    T: Scalar,
{
    if let Err(stop) = finite(target.values, course.inputs) {
        return position.refuse(stop, course.inputs);
    }
    if let Some((stop, reached)) = course.leaves(&position.motors, &target) {
        return Blocked::new(stop.place, stop.cause, reached.total()).of(course.inputs);
    }
    let way = Way::new(course, position, target, take);
    let stop = |part| take(position, way.motors(part)).err();
    let (part, beyond) = journey::halved(|part| stop(part).is_some());
    blocked(&way, part, stop(beyond).unwrap_or(way.too_far()))
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
    if let Err(stop) = finite(target.values, course.inputs) {
        return Err(position.refuse(stop, course.inputs));
    }
    let start = *position;
    let (end, target) = match course.leaves(&start.motors, &target) {
        None => (Reached::Target, target),
        Some((stop, reached)) => {
            let blocked = Blocked::new(stop.place, stop.cause, reached.total()).of(course.inputs);
            (Reached::Limit(blocked), reached)
        }
    };
    let way = Way::new(course, &start, target, &step);
    match journey::go(&way, &start) {
        Ok(arrived) => {
            *position = arrived;
            Ok(end)
        }
        Err(halt) => {
            *position = halt.position;
            Ok(Reached::Limit(blocked(&way, halt.part, halt.stop)))
        }
    }
}

#[cold]
fn blocked<T, const M: usize, const L: usize, const K: usize, const W: usize, S>(
    way: &Way<'_, T, M, L, K, W, S>,
    part: T,
    stop: Stop,
) -> Blocked<[T; M]>
where
    T: Scalar,
    S: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
{
    Blocked::new(stop.place, stop.cause, way.motors(part).total()).of(way.course.inputs)
}
