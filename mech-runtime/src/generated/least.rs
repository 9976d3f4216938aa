//! Inverse kinematics with more motors than needed: a point is led, and motors move as little as they can.

use super::inverse::Mover;
use super::{Motors, Position, Stop, advance};
use crate::blocked::Input;
use crate::{Blocked, Cause, Real, Scalar};
use mech_core::surplus::{SurplusMotors, lead, least};

/// What is led, `G` numbers, and the motors that follow: `N`, more than are needed.
#[derive(Clone, Copy, Debug)]
pub struct Surplus<T: 'static, const N: usize, const G: usize> {
    /// The indices of the motors among all inputs.
    pub motors: [usize; N],
    /// The square of how far each goes as easily as another turns by a radian.
    pub weights: [T; N],
    /// What is given.
    pub given: &'static [Input; G],
    /// The loop that what is led makes with the motors, in words.
    pub name: &'static str,
    /// The size of the links, in scene units: rounding is a part of it.
    pub size: T,
}

/// Leads a point to `place` on the straight way. In each piece of it the motors go as little as they can, by the sum of the squares of how
/// far they go; one that comes to the end of its range stays there. `given` is what is given at a position, and `influence` its rates for
/// rates of all motors.
///
/// # Errors
/// If a number is not finite, the motors cannot move what is given so, or something stops them. Nothing has moved then.
pub fn reach_least<
    T: Scalar,
    const N: usize,
    const G: usize,
    const M: usize,
    const L: usize,
    const K: usize,
    const W: usize,
    const RATES: usize,
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
    surplus: Surplus<T, N, G>,
    place: [T; G],
    given: impl Fn(&Position<T, M, L, K>) -> [T; G],
    influence: impl Fn(&Position<T, M, L, K>, [T; RATES]) -> Result<[T; G], Stop>,
) -> Result<(), Blocked<[T; G]>> {
    let start = *mechanism.position;
    let blocked =
        |stop: Stop, reached| Blocked::new(stop.place, stop.cause, reached).of(surplus.given);
    let mut named = place.iter().zip(surplus.given);
    if let Some((_, input)) = named.find(|(number, _)| !Real::is_finite(**number)) {
        return Err(blocked(Stop::new(input.name(), Cause::NotFinite), given(&start)));
    }
    let mut led = Led { mechanism, surplus, rest: [T::ZERO; RATES], given, influence };
    let there = lead(&mut led, &start, place);
    *led.mechanism.position = there.map_err(|(stop, reached)| blocked(stop, reached))?;
    Ok(())
}

/// The least rates of all motors at which what is given moves at these rates: motors that do not follow rest. `rates` computes the rates of
/// links for rates of motors, and `led` those of what is given; both are linear.
///
/// # Errors
/// If rates are not determined, or the motors cannot move what is given so.
pub fn least_rates<T: Scalar, L, const N: usize, const G: usize, const M: usize>(
    surplus: &Surplus<T, N, G>,
    given: [T; G],
    rates: impl Fn([T; M]) -> Result<L, Stop>,
    led: impl Fn(&L) -> [T; G],
) -> Result<[T; M], Stop> {
    let influence = surplus.influence([T::ZERO; M], |unit| Ok(led(&rates(unit)?)))?;
    let found = least(&influence, &surplus.weights, &[T::ZERO; N], &[None; N], given);
    let found = found.ok_or(surplus.undetermined())?;
    let mut all = [T::ZERO; M];
    for (motor, rate) in surplus.motors.into_iter().zip(found) {
        if let Some(place) = all.get_mut(motor) {
            *place = rate;
        }
    }
    Ok(all)
}

impl<T: Scalar, const N: usize, const G: usize> Surplus<T, N, G> {
    /// The influence of each motor on what is given.
    fn influence<const M: usize>(
        &self,
        rest: [T; M],
        influence: impl Fn([T; M]) -> Result<[T; G], Stop>,
    ) -> Result<[[T; G]; N], Stop> {
        let mut columns = [[T::ZERO; G]; N];
        for (column, motor) in columns.iter_mut().zip(self.motors) {
            let mut unit = rest;
            if let Some(rate) = unit.get_mut(motor) {
                *rate = T::ONE;
            }
            *column = influence(unit)?;
        }
        Ok(columns)
    }

    fn undetermined(&self) -> Stop {
        Stop::new(self.name, Cause::Singular)
    }
}

/// A mechanism whose point is led by more motors than it needs.
struct Led<
    'a,
    T: 'static,
    const N: usize,
    const G: usize,
    const M: usize,
    const L: usize,
    const K: usize,
    const W: usize,
    const RATES: usize,
    S,
    P,
    I,
> {
    mechanism: Mover<'a, T, M, L, K, W, S>,
    surplus: Surplus<T, N, G>,
    /// The rates of all motors where none moves.
    rest: [T; RATES],
    given: P,
    influence: I,
}

impl<
    T: Scalar,
    const N: usize,
    const G: usize,
    const M: usize,
    const L: usize,
    const K: usize,
    const W: usize,
    const RATES: usize,
    S,
    P,
    I,
> SurplusMotors<T, G> for Led<'_, T, N, G, M, L, K, W, RATES, S, P, I>
where
    S: Fn(&Position<T, M, L, K>, Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
    P: Fn(&Position<T, M, L, K>) -> [T; G],
    I: Fn(&Position<T, M, L, K>, [T; RATES]) -> Result<[T; G], Stop>,
{
    type Position = Position<T, M, L, K>;
    type Stop = Stop;
    type Values = [T; N];
    type Held = [Option<T>; N];
    type Influence = [[T; G]; N];

    fn given(&self, at: &Self::Position) -> [T; G] {
        (self.given)(at)
    }

    fn influence(&mut self, at: &Self::Position) -> Result<Self::Influence, Stop> {
        self.surplus.influence(self.rest, |unit| (self.influence)(at, unit))
    }

    fn values(&self, at: &Self::Position) -> [T; N] {
        let all = at.motors.total();
        self.surplus.motors.map(|motor| all.get(motor).copied().unwrap_or(T::ZERO))
    }

    fn free(&self) -> Self::Held {
        [None; N]
    }

    fn go(&mut self, from: &Self::Position, values: &[T; N]) -> Result<Self::Position, Stop> {
        let (mut to, mut motors) = (*from, from.motors);
        for (motor, value) in self.surplus.motors.into_iter().zip(values) {
            motors.set(motor, *value, 0);
        }
        let Mover { limits, step, .. } = &self.mechanism;
        let moved = advance(&mut to, motors, limits, step, step);
        moved.map_err(|blocked| Stop::new(blocked.place, blocked.cause))?;
        Ok(to)
    }

    fn weights(&self) -> &[T] {
        &self.surplus.weights
    }

    fn range(&self, number: usize) -> Option<[T; 2]> {
        let motor = self.surplus.motors.get(number)?;
        self.mechanism.limits.range.as_ref()?.get(*motor).copied()
    }

    fn is_angle(&self, number: usize) -> bool {
        matches!(self.surplus.given.get(number), Some(Input::Turning(_)))
    }

    fn size(&self) -> T {
        self.surplus.size
    }

    fn undetermined(&self) -> Stop {
        self.surplus.undetermined()
    }

    fn unreached(&self) -> Stop {
        Stop::new(self.surplus.name, Cause::Open)
    }
}
