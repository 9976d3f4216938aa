//! A step of time under forces, by Gauss–Legendre collocation.
//!
//! The second rates at the stages are found by iteration. Each stage is a position of its own that is moved along, so that dead points and
//! limits are noticed as in any move. The methods are those of Gauss and Legendre for equations of second order: symmetric, of twice the order
//! of their stages. See Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations I*, II.14.

use super::{Inertia, Motors, Position, Stop};
use crate::blocked::Input;
use crate::{Blocked, Cause, GaussLegendre, Real, Scalar};

/// The most stages of a method.
const STAGES: usize = 3;
/// The most rounds until the second rates at the stages are settled.
const ROUNDS: usize = 64;
/// So often at most is a step halved whose iteration does not settle.
const HALVINGS: u32 = 6;
/// After so many rounds without progress the iteration is as exact as rounding allows, which is worse beside dead points and change
/// points.
const STALLED: usize = 4;
/// After so many rounds without progress it will not settle: the step is too long.
const HOPELESS: usize = 8;

/// The end of a step of time. The inputs are the motors and, after them, the params, which stay constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Simulated<
    T,
    const INPUTS: usize,
    const MOTORS: usize,
    const LINKS: usize,
    const STATE: usize,
> {
    /// The new position.
    pub position: Position<T, INPUTS, LINKS, STATE>,
    /// The rates of the motors there.
    pub rates: [T; MOTORS],
    /// Their second rates there.
    pub accelerations: [T; MOTORS],
}

/// The rates, torques and constants that move a position.
#[derive(Clone, Copy, Debug)]
pub struct Moment<T: 'static, const INPUTS: usize, const MOTORS: usize> {
    /// The rates of the motors.
    pub rates: [T; MOTORS],
    /// Their torques, which stay as they are during the step.
    pub torques: [T; MOTORS],
    /// The duration of the step.
    pub time: T,
    /// The motors, and the params after them.
    pub inputs: &'static [Input; INPUTS],
    /// Whether each motor turns, and may turn any number of times.
    pub turning: &'static [bool; MOTORS],
    /// A radian for each that turns, the size of the mechanism for each that slides: what their values are rounded against.
    pub scales: &'static [T; MOTORS],
}

/// A method: for each stage its time, its weight, and the shares of all stages' second rates in its rate and its place.
struct Tableau<T> {
    times: [T; STAGES],
    weights: [T; STAGES],
    rates: [[T; STAGES]; STAGES],
    places: [[T; STAGES]; STAGES],
    /// The shares of the stages' second rates in the place at the end.
    end: [T; STAGES],
    count: usize,
}

impl<T: Scalar> Tableau<T> {
    fn of(method: GaussLegendre) -> Self {
        let (count, times, weights, rates) = match method {
            GaussLegendre::Order2 => {
                (1, [0.5, 0.0, 0.0], [1.0, 0.0, 0.0], [[0.5, 0.0, 0.0], [0.0; 3], [0.0; 3]])
            }
            GaussLegendre::Order4 => {
                // √3 / 6
                let part = 0.288_675_134_594_812_9;
                (
                    2,
                    [0.5 - part, 0.5 + part, 0.0],
                    [0.5, 0.5, 0.0],
                    [[0.25, 0.25 - part, 0.0], [0.25 + part, 0.25, 0.0], [0.0; 3]],
                )
            }
            GaussLegendre::Order6 => {
                // √15
                let root = 3.872_983_346_207_417;
                let (far, near) = (5.0 / 36.0, 2.0 / 9.0);
                (
                    3,
                    [0.5 - root / 10.0, 0.5, 0.5 + root / 10.0],
                    [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0],
                    [
                        [far, near - root / 15.0, far - root / 30.0],
                        [far + root / 24.0, near, far - root / 24.0],
                        [far + root / 30.0, near + root / 15.0, far],
                    ],
                )
            }
        };
        let row = |row: [f64; STAGES]| row.map(|number| <T as Real>::from_f64(number));
        let (weights, rates) = (row(weights), rates.map(row));
        // The shares in the places are products of those in the rates. Missing stages have zeros.
        let into_place = |shares: [T; STAGES]| -> [T; STAGES] {
            let mut sums = [T::ZERO; STAGES];
            for (share, row) in shares.iter().zip(&rates) {
                for (sum, part) in sums.iter_mut().zip(row) {
                    *sum += *share * *part;
                }
            }
            sums
        };
        Self {
            times: row(times),
            weights,
            rates,
            places: rates.map(into_place),
            end: into_place(weights),
            count,
        }
    }

    /// The time of each stage, and the shares of all second rates in its place and in its rate.
    fn stages(&self) -> impl Iterator<Item = (T, [T; STAGES], [T; STAGES])> + '_ {
        let shares = self.places.iter().zip(&self.rates);
        let stages = self.times.iter().zip(shares);
        stages.map(|(at, (places, rates))| (*at, *places, *rates)).take(self.count)
    }
}

/// Follows the motion for a step of time. `to` moves a position to motor values and gives the inertia there at these rates.
///
/// Beside dead points accelerations change so fast that the iteration of the whole step does not settle. Then the step is made in parts.
///
/// # Errors
/// If an argument is not finite, something stops the move, no mass resists a motor, or the step of time is too long.
pub fn simulate<T, const I: usize, const M: usize, const L: usize, const K: usize>(
    start: &Position<T, I, L, K>,
    moment: &Moment<T, I, M>,
    method: GaussLegendre,
    to: impl Fn(
        &mut Position<T, I, L, K>,
        Motors<T, I>,
        [T; M],
    ) -> Result<Inertia<T, M>, Blocked<[T; I]>>,
) -> Result<Simulated<T, I, M, L, K>, Blocked<[T; I]>>
where
    T: Scalar,
{
    let inputs = moment.inputs;
    let refuse = |stop| start.refuse(stop, inputs);
    if !Real::is_finite(moment.time) {
        return Err(refuse(Stop::new("time", Cause::NotFinite)));
    }
    super::finite(moment.torques, inputs).map_err(refuse)?;
    let tableau = Tableau::<T>::of(method);
    let mut position = *start;
    let inertia = to(&mut position, start.motors, moment.rates)?;
    let accelerations = inertia.accelerations(moment.torques, inputs).map_err(refuse)?;
    let mut now = Simulated { position, rates: moment.rates, accelerations };
    let (mut done, mut part, mut halvings) = (T::ZERO, T::ONE, 0);
    while done < T::ONE {
        let rest = Moment { rates: now.rates, time: moment.time * part, ..*moment };
        match step(&now, &rest, &tableau, &to) {
            Ok(there) => {
                now = there;
                done += part;
            }
            Err(_) if halvings < HALVINGS => {
                part *= T::HALF;
                halvings += 1;
            }
            Err(blocked) => {
                let rest = moment.time * (T::ONE - done);
                return Err(reason(&now, rest, &to).unwrap_or(blocked));
            }
        }
    }
    now.position.motors = now.position.motors.reduced(moment.turning);
    Ok(now)
}

/// Finds the stop of a motion that goes on at these rates for so long: a loop that does not close, or the end of a range.
#[cold]
fn reason<T, const I: usize, const M: usize, const L: usize, const K: usize>(
    now: &Simulated<T, I, M, L, K>,
    time: T,
    to: &impl Fn(
        &mut Position<T, I, L, K>,
        Motors<T, I>,
        [T; M],
    ) -> Result<Inertia<T, M>, Blocked<[T; I]>>,
) -> Option<Blocked<[T; I]>>
where
    T: Scalar,
{
    let motors = displace(now.position.motors, now.rates.map(|rate| rate * time));
    let stop = to(&mut { now.position }, motors, now.rates).err()?;
    let is_stopped = matches!(
        stop.cause,
        Cause::Open | Cause::DeadPoint | Cause::ChangePoint | Cause::OutOfRange
    );
    is_stopped.then_some(stop)
}

/// A step of time, or a part of it, at once.
fn step<T, const I: usize, const M: usize, const L: usize, const K: usize>(
    start: &Simulated<T, I, M, L, K>,
    moment: &Moment<T, I, M>,
    tableau: &Tableau<T>,
    to: &impl Fn(
        &mut Position<T, I, L, K>,
        Motors<T, I>,
        [T; M],
    ) -> Result<Inertia<T, M>, Blocked<[T; I]>>,
) -> Result<Simulated<T, I, M, L, K>, Blocked<[T; I]>>
where
    T: Scalar,
{
    let Moment { rates, torques, time, inputs, .. } = *moment;
    let mut position = start.position;
    let motors = position.motors;
    let refuse = |stop| start.position.refuse(stop, inputs);
    let mut stages = [start.accelerations; STAGES];
    let mut positions = [position; STAGES];
    let near = <T as Real>::from_f64(1024.0 * T::EPSILON);
    let hidden = <T as Real>::from_f64(16.0 * T::EPSILON);
    let small = Real::sqrt(<T as Real>::from_f64(T::EPSILON));
    let (mut before, mut least) = (T::ONE, T::ONE);
    let (mut settled, mut stalled) = (false, 0);
    for _ in 0..ROUNDS {
        let mut next = stages;
        let found = next.iter_mut().zip(&mut positions);
        for ((at, places, shares), (next, position)) in tableau.stages().zip(found) {
            let places = places.map(|share| time * time * share);
            let displacement = displacement(rates, time * at, &stages, places, tableau.count);
            let shares = shares.map(|share| time * share);
            let speed = sum(rates, &stages, shares, tableau.count);
            let inertia = to(position, displace(motors, displacement), speed).map_err(too_long)?;
            let accelerations = inertia.accelerations(torques, inputs);
            *next = accelerations.map_err(refuse).map_err(too_long)?;
        }
        let pairs = stages.iter().zip(&next).take(tableau.count);
        let change = Change::between(pairs, moment);
        stages = next;
        // To rounding, or as near as possible: where forces cancel each other, until nothing is displaced.
        let is_near = change.of_rates <= near || change.of_places <= hidden;
        let is_exact = change.of_rates <= <T as Real>::from_f64(T::EPSILON);
        stalled = if change.of_rates < least { 0 } else { stalled + 1 };
        least = if change.of_rates < least { change.of_rates } else { least };
        let is_stalled = stalled >= STALLED && change.of_rates <= small;
        settled = is_exact || (change.of_rates >= before && is_near) || is_stalled;
        if settled || stalled >= HOPELESS {
            break;
        }
        before = change.of_rates;
    }
    if !settled {
        return Err(refuse(Stop::new("", Cause::StepTooLong)));
    }
    let end = tableau.end.map(|share| time * time * share);
    let displacement = displacement(rates, time, &stages, end, tableau.count);
    let weights = tableau.weights.map(|share| time * share);
    let speed = sum(rates, &stages, weights, tableau.count);
    let inertia = to(&mut position, displace(motors, displacement), speed)?;
    let accelerations = inertia.accelerations(torques, inputs).map_err(refuse)?;
    super::finite(speed, inputs).map_err(|_| refuse(Stop::new("", Cause::Overflow)))?;
    Ok(Simulated { position, rates: speed, accelerations })
}

/// An iteration that diverges means that the step is too long.
fn too_long<M>(blocked: Blocked<M>) -> Blocked<M> {
    match blocked.cause {
        Cause::Overflow | Cause::TooFar => {
            Blocked { place: "", cause: Cause::StepTooLong, ..blocked }
        }
        _ => blocked,
    }
}

/// The displacement by rates and second rates.
fn displacement<T: Scalar, const M: usize>(
    rates: [T; M],
    time: T,
    stages: &[[T; M]; STAGES],
    shares: [T; STAGES],
    count: usize,
) -> [T; M] {
    sum(rates.map(|rate| rate * time), stages, shares, count)
}

/// A vector and shares of the second rates at the stages.
fn sum<T: Scalar, const M: usize>(
    first: [T; M],
    stages: &[[T; M]; STAGES],
    shares: [T; STAGES],
    count: usize,
) -> [T; M] {
    let mut sum = first;
    for (share, stage) in shares.into_iter().zip(stages).take(count) {
        for (sum, part) in sum.iter_mut().zip(stage) {
            *sum += share * *part;
        }
    }
    sum
}

fn displace<T: Scalar, const I: usize, const M: usize>(
    motors: Motors<T, I>,
    displacement: [T; M],
) -> Motors<T, I> {
    let mut motors = motors;
    for (value, displacement) in motors.values.iter_mut().zip(displacement) {
        *value += displacement;
    }
    motors
}

/// The change of the second rates at the stages.
struct Change<T> {
    /// The change relative to the rates.
    of_rates: T,
    /// The change relative to the scales of the motors.
    of_places: T,
}

impl<T: Scalar> Change<T> {
    /// The change between each stage before and after.
    fn between<'s, const I: usize, const M: usize>(
        stages: impl Iterator<Item = (&'s [T; M], &'s [T; M])>,
        moment: &Moment<T, I, M>,
    ) -> Self {
        let Moment { time, scales, .. } = *moment;
        let (mut of_rates, mut of_places) = (T::ZERO, T::ZERO);
        for (old, new) in stages {
            let motors = old.iter().zip(new).zip(moment.rates).zip(scales);
            for (((old, new), rate), scale) in motors {
                let brought = Real::abs(time * (*new - *old));
                if brought > T::ZERO {
                    let whole = Real::abs(rate) + Real::abs(time * *new);
                    of_rates = Real::max(of_rates, brought / whole);
                    of_places = Real::max(of_places, Real::abs(time) * brought / *scale);
                }
            }
        }
        Self { of_rates, of_places }
    }
}
