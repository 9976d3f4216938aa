//! Inverse kinematics: a point is led, and motors follow.

use super::journey::Move;
use super::{Motors, MoveLimits, Position, Stop, advance};
use crate::blocked::Input;
use crate::{Blocked, Cause, Pose, Real, Scalar};
use mech_core::journey::Journey;
use mech_core::motors;
use mech_core::pieces::{between, in_pieces};

/// The way cannot be followed at once.
const TOO_FAR: Stop = Stop::new("", Cause::TooFar);

/// Where the sine of a loop is less than this, a position is solved for by itself.
const LEAST_SINE: f64 = 0.25;

/// So many whole turns of an angle that gears follow are tried.
const MOST_TURNS: i32 = 32;

/// A mechanism and what moves it.
pub struct Mover<'a, T: 'static, const M: usize, const L: usize, const K: usize, const W: usize, S>
{
    /// The position.
    pub position: &'a mut Position<T, M, L, K>,
    /// The limits of its moves.
    pub limits: &'a MoveLimits<T, M, W>,
    /// The step for any values of the motors.
    pub step: S,
}

/// What is led, and the motors that follow: `N` of each.
pub struct Led<T, const N: usize> {
    /// The indices of the motors among all inputs. In the inverse, what is given stands there.
    pub motors: [usize; N],
    /// Which of the motors turn.
    pub turning: [bool; N],
    /// The number of links that both have: the first of each.
    pub links: usize,
    /// The size of the links, in scene units: rounding is a part of it.
    pub size: T,
    /// What is given.
    pub given: &'static [Input; N],
    /// Its present value: the place of a point, or that and the angle of its link.
    pub here: [T; N],
    /// Whether the poses of links are all of a position, but for sines of loops that change no faster than links turn. Then whole turns are
    /// counted for motors alone.
    pub direct: bool,
}

/// Leads the point to `place` on the straight way, by the inverse of a mechanism, and lets motors and everything else follow. The first
/// links of both are the same; `coordinates` are those of the joints whose motors follow.
///
/// # Errors
/// If a number is not finite, a loop cannot be closed on the way, or a motor would leave its range. Nothing has moved then.
pub fn reach<
    T: Scalar,
    const N: usize,
    const M: usize,
    const L: usize,
    const K: usize,
    const W: usize,
    const ALL: usize,
    const STATE: usize,
    const WATCHED: usize,
>(
    mechanism: Mover<
        '_,
        T,
        M,
        L,
        K,
        W,
        impl Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
    >,
    inverse: Mover<
        '_,
        T,
        M,
        ALL,
        STATE,
        WATCHED,
        impl Fn(&Position<T, M, ALL, STATE>, Motors<T, M>) -> Result<Position<T, M, ALL, STATE>, Stop>,
    >,
    led: Led<T, N>,
    place: [T; N],
    coordinates: impl Fn(&Position<T, M, ALL, STATE>) -> [T; N],
) -> Result<(), Blocked<[T; N]>> {
    let mut named = place.iter().zip(led.given);
    if let Some((_, input)) = named.find(|(number, _)| !Real::is_finite(**number)) {
        return Err(led.blocked(Stop::new(input.name(), Cause::NotFinite), led.here));
    }
    let mut way = Way { mechanism, inverse, led, coordinates };
    if way.led.agree(way.mechanism.position, way.inverse.position) {
        let end = way.led.nearest(place, &way.inverse.position.motors);
        if way.go_at_once(end)?.is_none() {
            return Ok(());
        }
    }
    way.go_in_pieces(place)
}

/// A way on which a point is led.
struct Way<
    'a,
    T: 'static,
    const N: usize,
    const M: usize,
    const L: usize,
    const K: usize,
    const W: usize,
    const ALL: usize,
    const STATE: usize,
    const WATCHED: usize,
    S,
    R,
    C,
> {
    mechanism: Mover<'a, T, M, L, K, W, S>,
    inverse: Mover<'a, T, M, ALL, STATE, WATCHED, R>,
    led: Led<T, N>,
    coordinates: C,
}

impl<
    T: Scalar,
    const N: usize,
    const M: usize,
    const L: usize,
    const K: usize,
    const W: usize,
    const ALL: usize,
    const STATE: usize,
    const WATCHED: usize,
    S,
    R,
    C,
> Way<'_, T, N, M, L, K, W, ALL, STATE, WATCHED, S, R, C>
where
    S: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
    R: Fn(&Position<T, M, ALL, STATE>, Motors<T, M>) -> Result<Position<T, M, ALL, STATE>, Stop>,
    C: Fn(&Position<T, M, ALL, STATE>) -> [T; N],
{
    /// Goes to `place` in one piece. Gives the reason if it stays where it is, as the piece is too long.
    ///
    /// # Errors
    /// If a loop cannot be closed on the way.
    fn go_at_once(&mut self, place: [T; N]) -> Result<Option<Stop>, Blocked<[T; N]>> {
        let Self { mechanism, inverse, led, coordinates } = self;
        let start = *inverse.position;
        let (target, limits) = (led.inputs(&start.motors, place), inverse.limits);
        let at = &mut *inverse.position;
        advance(at, target, limits, &inverse.step, &inverse.step)
            .map_err(|blocked| led.chosen(blocked))?;
        let coordinates = [&start, &*at].map(&*coordinates);
        let following = led.following(&mechanism.position.motors, coordinates);
        let stop = following.map_or(Some(TOO_FAR), |motors| {
            let poses = led.shared(&at.poses);
            // Near a dead point rounding tears what a loop joins.
            let is_closed = led.direct && limits.are_far(at, T::from_f64(LEAST_SINE));
            if is_closed && mechanism.put(motors, poses) {
                limits.count_from_zero(at);
                return None;
            }
            let stop = mechanism.carry(motors, poses, led.size);
            // To the bit, so that it is known next time that both agree.
            let known = led.shared(&mechanism.position.poses);
            for (pose, known) in at.poses.iter_mut().zip(known) {
                *pose = *known;
            }
            stop
        });
        if stop.is_some() {
            *at = start;
        }
        Ok(stop)
    }

    /// Goes to `place` in as many pieces as it takes, from where the inverse may not know that it is. It stays where it is if that fails.
    #[cold]
    #[inline(never)]
    fn go_in_pieces(&mut self, place: [T; N]) -> Result<(), Blocked<[T; N]>> {
        let start = (*self.mechanism.position, *self.inverse.position);
        let moved = self.try_pieces(place);
        if moved.is_err() {
            (*self.mechanism.position, *self.inverse.position) = start;
        }
        moved
    }

    fn try_pieces(&mut self, place: [T; N]) -> Result<(), Blocked<[T; N]>> {
        let (at, from) = (&*self.mechanism.position, &*self.inverse.position);
        if !self.led.agree(at, from) {
            // Only its poses are known: a beginning of its own keeps the digits that whole turns would take.
            self.inverse.limits.count_from_zero(self.inverse.position);
            let from = &*self.inverse.position;
            let here = self.led.nearest(self.led.here, &from.motors);
            let here = self.led.inputs(&at.motors, here);
            let poses = self.led.shared(&at.poses);
            let found = self.inverse.position_beside(here, poses, self.led.size);
            *self.inverse.position = found.ok_or(self.led.blocked(TOO_FAR, self.led.here))?;
        }
        let start = self.led.values(&self.inverse.position.motors);
        let end = self.led.nearest(place, &self.inverse.position.motors);
        let way = |part| between(start, end, part);
        in_pieces(TOO_FAR, |part| self.go_at_once(way(part)))?
            .map_err(|(stop, done)| self.led.blocked(stop, way(done)))
    }
}

/// The rates of all motors at which what is given moves at these rates: motors that do not follow rest. `rates` computes the rates of links
/// for rates of motors, and `led` those of what is given; both are linear.
///
/// # Errors
/// If rates are not determined, or the motors cannot move what is given so.
pub fn led_rates<T: Scalar, L, const N: usize, const M: usize>(
    motors: [usize; N],
    given: [T; N],
    name: &'static str,
    rates: impl Fn([T; M]) -> Result<L, Stop>,
    led: impl Fn(&L) -> [T; N],
) -> Result<[T; M], Stop> {
    let with = |mut all: [T; M], motor: usize, rate: T| {
        if let Some(place) = all.get_mut(motor) {
            *place = rate;
        }
        all
    };
    let rest = [T::ZERO; M];
    let mut rows = [[T::ZERO; N]; N];
    for (column, motor) in motors.into_iter().enumerate() {
        let influence = led(&rates(with(rest, motor, T::ONE))?);
        for (row, part) in rows.iter_mut().zip(influence) {
            if let Some(entry) = row.get_mut(column) {
                *entry = part;
            }
        }
    }
    let mut following = given;
    mech_core::dense::solve(&mut rows, &mut following);
    if following.iter().any(|rate| !Real::is_finite(*rate)) {
        return Err(Stop::new(name, Cause::Singular));
    }
    let pairs = motors.into_iter().zip(following);
    Ok(pairs.fold(rest, |all, (motor, rate)| with(all, motor, rate)))
}

/// The differences of two sets of numbers.
#[must_use]
pub fn less<T: Scalar, const N: usize>(given: [T; N], others: [T; N]) -> [T; N] {
    let mut less = given;
    for (number, other) in less.iter_mut().zip(others) {
        *number -= other;
    }
    less
}

impl<T: Scalar, const N: usize> Led<T, N> {
    /// The error of a mechanism that stays where it is.
    fn blocked(&self, stop: Stop, reached: [T; N]) -> Blocked<[T; N]> {
        Blocked::new(stop.place, stop.cause, reached).of(self.given)
    }

    /// The error of a move of the inverse, with the values of what is given alone.
    fn chosen<const M: usize>(&self, blocked: Blocked<[T; M]>) -> Blocked<[T; N]> {
        blocked.map(|all| self.choose(&all)).of(self.given)
    }

    /// The poses that a mechanism and its inverse share.
    fn shared<'p>(&self, poses: &'p [Pose<T>]) -> &'p [Pose<T>] {
        poses.get(..self.links).unwrap_or_default()
    }

    /// What is given, among all inputs.
    fn choose(&self, all: &[T]) -> [T; N] {
        let chosen = |motor: usize| all.get(motor).copied().unwrap_or(T::ZERO);
        self.motors.map(chosen)
    }

    /// The values of what is given.
    fn values<const M: usize>(&self, motors: &Motors<T, M>) -> [T; N] {
        self.choose(&motors.total())
    }

    /// The same place, with its angle less than half a turn from the present one.
    fn nearest<const M: usize>(&self, place: [T; N], present: &Motors<T, M>) -> [T; N] {
        // Places alone have no angle.
        if N < 3 {
            return place;
        }
        let mut near = place;
        let values = near.iter_mut().zip(self.values(present)).zip(self.given);
        for ((value, present), input) in values {
            if let Input::Turning(_) = input
                && let Some((_, displacement)) = (*value - present).whole_turns()
            {
                *value = present + displacement;
            }
        }
        near
    }

    /// The inputs of the inverse: what is given at these values, the others as they are.
    fn inputs<const M: usize>(&self, present: &Motors<T, M>, values: [T; N]) -> Motors<T, M> {
        let mut inputs = *present;
        for (motor, value) in self.motors.into_iter().zip(values) {
            inputs.set(motor, value, 0);
        }
        inputs
    }

    /// Whether a mechanism and its inverse are where the last move left them.
    fn agree<
        const M: usize,
        const L: usize,
        const K: usize,
        const ALL: usize,
        const STATE: usize,
    >(
        &self,
        mechanism: &Position<T, M, L, K>,
        inverse: &Position<T, M, ALL, STATE>,
    ) -> bool {
        let (there, here) = (&inverse.motors, &mechanism.motors);
        let mut others = (0..M).filter(|input| !self.motors.contains(input));
        others.all(|input| {
            there.values.get(input) == here.values.get(input)
                && there.turns.get(input) == here.turns.get(input)
        }) && self.shared(&inverse.poses) == self.shared(&mechanism.poses)
    }

    /// The motors where their joints have come from one set of coordinates to another. None beyond 2³¹ turns.
    fn following<const M: usize>(
        &self,
        present: &Motors<T, M>,
        [before, after]: [[T; N]; 2],
    ) -> Option<Motors<T, M>> {
        let mut motors = *present;
        let pairs = before.into_iter().zip(after).zip(self.turning);
        for (motor, ((before, after), is_turning)) in self.motors.into_iter().zip(pairs) {
            let (value, turns) = (*present.values.get(motor)?, *present.turns.get(motor)?);
            if is_turning {
                // Both count whole turns from a beginning of their own.
                let apart = value - before;
                let apart =
                    if apart.abs() <= T::HALF * T::TURN { 0 } else { apart.whole_turns()?.0 };
                let (value, turns) = motors::reduced(after, turns.checked_add(apart)?);
                motors.set(motor, value, turns);
            } else {
                motors.set(motor, after, 0);
            }
        }
        Some(motors)
    }
}

impl<T, const M: usize, const L: usize, const K: usize, const W: usize, S>
    Mover<'_, T, M, L, K, W, S>
where
    T: Scalar,
    S: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
{
    /// Puts everything where the motors have these values and the links these poses, if links have turned so little that every watched loop
    /// certainly stays on its side. Gives whether it did.
    #[inline]
    fn put(&mut self, motors: Motors<T, M>, poses: &[Pose<T>]) -> bool {
        if poses.len() != L || !self.limits.contains(&motors) {
            return false;
        }
        let pairs = poses.iter().zip(&self.position.poses);
        let turned = pairs.fold(T::ZERO, |turned, (to, from)| {
            turned.max((to.cos - from.cos).abs() + (to.sin - from.sin).abs())
        });
        // Two links turn, and an arc is a little longer than its chord.
        let lost = turned * T::from_f64(2.1);
        if !self.limits.are_far(self.position, T::from_f64(LEAST_SINE) + lost) {
            return false;
        }
        let position = &mut *self.position;
        let displacements = position.motors.displacement_to(&motors);
        position.motors = motors;
        position.poses.copy_from_slice(poses);
        for watched in &self.limits.watched {
            if let Some(sine) = position.state.get_mut(watched.sine) {
                let toward_zero = if *sine < T::ZERO { lost } else { -lost };
                *sine += toward_zero;
            }
        }
        self.limits.stand_away(position);
        self.limits.note_motion_signs(position, &displacements);
        true
    }

    /// Goes to where the motors have these values and the first links these poses, to rounding. Gives the reason if it stays: a motor would
    /// leave its range, or the way is too long for angles to be certain.
    #[inline]
    fn carry(&mut self, motors: Motors<T, M>, poses: &[Pose<T>], size: T) -> Option<Stop> {
        if let Some((stop, _)) = self.limits.leaves(&self.position.motors, &motors) {
            return Some(stop);
        }
        let going = Move::new(self.limits, self.position, motors, &self.step);
        let found = match going.to(self.position, motors) {
            Ok(found) if apart(&found.poses, poses, size) == 0 => Some(found),
            _ => self.position_beside(motors, poses, size),
        };
        let Some(mut found) = found else {
            return Some(TOO_FAR);
        };
        self.limits.stand_away(&mut found);
        going.note_motion_signs(&mut found);
        if !self.turned_little(&found) {
            return Some(TOO_FAR);
        }
        *self.position = found;
        None
    }

    /// The position at these values of the motors in which the first links have these poses, to rounding, on any side of loops and after
    /// whole turns of angles that gears follow. None if there is none.
    #[cold]
    #[inline(never)]
    fn position_beside(
        &self,
        motors: Motors<T, M>,
        poses: &[Pose<T>],
        size: T,
    ) -> Option<Position<T, M, L, K>> {
        let mut from = *self.position;
        for (pose, known) in from.poses.iter_mut().zip(poses) {
            *pose = *known;
        }
        self.limits.stand_away(&mut from);
        let going = Move::new(self.limits, self.position, motors, &self.step);
        let goal = (motors, poses, size);
        let mut nearest = Nearest { from, found: None, apart: usize::MAX };
        nearest.consider(&going, goal, from.state);
        for watched in &self.limits.watched {
            let mut state = nearest.from.state;
            if let Some(sine) = state.get_mut(watched.sine) {
                *sine = -*sine;
            }
            nearest.consider(&going, goal, state);
        }
        for followed in self.limits.follows {
            let mut turns = (1..=MOST_TURNS).flat_map(|turns| [turns, -turns]);
            turns.find(|turns| {
                let mut state = nearest.from.state;
                if let Some(angle) = state.get_mut(followed.angle) {
                    *angle += T::TURN * T::from_i32(*turns);
                }
                nearest.consider(&going, goal, state)
            });
        }
        nearest.found.filter(|_| nearest.apart == 0)
    }

    /// Whether the angles that gears follow have turned so little that their whole turns are certain.
    fn turned_little(&self, to: &Position<T, M, L, K>) -> bool {
        let quarter = T::HALF * T::HALF * T::TURN;
        self.limits.follows.iter().all(|followed| {
            let angles = [&*self.position, to].map(|position| position.state.get(followed.angle));
            let [Some(before), Some(after)] = angles else {
                return false;
            };
            (*after - *before).abs() <= quarter
        })
    }
}

/// The position nearest to given poses that was found so far.
struct Nearest<T, const M: usize, const L: usize, const K: usize> {
    /// The position from which it was found.
    from: Position<T, M, L, K>,
    found: Option<Position<T, M, L, K>>,
    /// The number of links that are elsewhere.
    apart: usize,
}

impl<T: Scalar, const M: usize, const L: usize, const K: usize> Nearest<T, M, L, K> {
    /// Looks whether another state is nearer: whether all links are in place, or more than before.
    #[inline(never)]
    fn consider<const W: usize, S>(
        &mut self,
        going: &Move<'_, T, M, L, K, W, S>,
        (motors, poses, size): (Motors<T, M>, &[Pose<T>], T),
        state: [T; K],
    ) -> bool
    where
        S: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
    {
        if self.apart == 0 {
            return true;
        }
        let from = Position { state, ..self.from };
        let Ok(found) = going.to(&from, motors) else {
            return false;
        };
        let apart = apart(&found.poses, poses, size);
        let is_nearer = apart < self.apart;
        if is_nearer {
            *self = Self { from, found: Some(found), apart };
        }
        is_nearer
    }
}

/// The number of links that are elsewhere, by more than rounding tears loops that are nearly straight.
fn apart<T: Scalar>(poses: &[Pose<T>], wanted: &[Pose<T>], size: T) -> usize {
    let rounding = T::from_f64(16.0 * Real::sqrt(T::EPSILON));
    let size = wanted.iter().fold(size, |size, pose| size.max(pose.x.abs()).max(pose.y.abs()));
    let is_apart = |(a, b): &(&Pose<T>, &Pose<T>)| {
        let turned = (a.cos - b.cos).abs().max((a.sin - b.sin).abs());
        let moved = (a.x - b.x).abs().max((a.y - b.y).abs());
        // Also true of what is no number.
        !(turned <= rounding && moved <= rounding * size)
    };
    poses.iter().zip(wanted).filter(is_apart).count()
}
