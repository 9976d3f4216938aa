//! Inverse kinematics with more motors than needed: a point is led, and motors move as little as they can.

use super::inverse::{Mover, TOO_FAR, between};
use super::{Position, Stop, advance, less};
use crate::blocked::Input;
use crate::{Blocked, Cause, Real, Scalar};
use mech_core::pieces::in_pieces;

/// So many rounds are made on a piece of the way.
const MOST_ROUNDS: usize = 40;

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
        impl Fn(&Position<T, M, L, K>, super::Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
    >,
    surplus: Surplus<T, N, G>,
    place: [T; G],
    given: impl Fn(&Position<T, M, L, K>) -> [T; G],
    influence: impl Fn(&Position<T, M, L, K>, [T; RATES]) -> Result<[T; G], Stop>,
) -> Result<(), Blocked<[T; G]>> {
    let Mover { position, limits, step } = mechanism;
    let start = *position;
    let here = given(&start);
    let blocked =
        |stop: Stop, reached| Blocked::new(stop.place, stop.cause, reached).of(surplus.given);
    let mut named = place.iter().zip(surplus.given);
    if let Some((_, input)) = named.find(|(number, _)| !Real::is_finite(**number)) {
        return Err(blocked(Stop::new(input.name(), Cause::NotFinite), here));
    }
    let apart = surplus.apart(place, here);
    let mut end = here;
    for (value, apart) in end.iter_mut().zip(apart) {
        *value += apart;
    }
    let way = |part| between(here, end, part);
    let mut at = start;
    let moved = in_pieces(TOO_FAR, |part| {
        let piece = surplus.reach_at_once(
            &at,
            way(part),
            limits.range.as_ref(),
            &given,
            &influence,
            |from, motors| {
                let mut to = *from;
                let moved = advance(&mut to, motors, limits, &step, &step);
                moved.map_err(|blocked| Stop::new(blocked.place, blocked.cause))?;
                Ok(to)
            },
        );
        Ok::<_, Blocked<[T; G]>>(match piece {
            Ok(there) => {
                at = there;
                None
            }
            Err(stop) => Some(stop),
        })
    })?;
    moved.map_err(|(stop, done)| blocked(stop, way(done)))?;
    *position = at;
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
    let columns = surplus.columns(|unit| Ok(led(&rates(unit)?)))?;
    let found = surplus.least(&columns, [T::ZERO; N], [None; N], given)?;
    Ok(surplus.with([T::ZERO; M], found))
}

impl<T: Scalar, const N: usize, const G: usize> Surplus<T, N, G> {
    /// By how much a place is apart from another: angles the shorter way.
    fn apart(&self, place: [T; G], from: [T; G]) -> [T; G] {
        let mut apart = less(place, from);
        for (value, input) in apart.iter_mut().zip(self.given) {
            if let Input::Turning(_) = input
                && let Some((_, displacement)) = value.whole_turns()
            {
                *value = displacement;
            }
        }
        apart
    }

    /// The same inputs, with these values of the motors that follow.
    fn with<const M: usize>(&self, mut all: [T; M], values: [T; N]) -> [T; M] {
        for (motor, value) in self.motors.into_iter().zip(values) {
            if let Some(place) = all.get_mut(motor) {
                *place = value;
            }
        }
        all
    }

    /// The influence of each motor on what is given.
    fn columns<const M: usize>(
        &self,
        influence: impl Fn([T; M]) -> Result<[T; G], Stop>,
    ) -> Result<[[T; G]; N], Stop> {
        let mut columns = [[T::ZERO; G]; N];
        for (column, motor) in columns.iter_mut().zip(self.motors) {
            let mut unit = [T::ZERO; M];
            if let Some(rate) = unit.get_mut(motor) {
                *rate = T::ONE;
            }
            *column = influence(unit)?;
        }
        Ok(columns)
    }

    /// Goes a piece of the way at once, by Newton's method on the conditions for the least motion from where it begins; then on the place
    /// alone.
    fn reach_at_once<const M: usize, const L: usize, const K: usize, const RATES: usize>(
        &self,
        from: &Position<T, M, L, K>,
        target: [T; G],
        range: Option<&[[T; 2]; M]>,
        given: &impl Fn(&Position<T, M, L, K>) -> [T; G],
        influence: &impl Fn(&Position<T, M, L, K>, [T; RATES]) -> Result<[T; G], Stop>,
        go: impl Fn(&Position<T, M, L, K>, super::Motors<T, M>) -> Result<Position<T, M, L, K>, Stop>,
    ) -> Result<Position<T, M, L, K>, Stop> {
        let chosen =
            |all: [T; M]| self.motors.map(|motor| all.get(motor).copied().unwrap_or(T::ZERO));
        let origin = chosen(from.motors.total());
        let (mut at, mut held, mut settles) = (*from, [None; N], false);
        for _ in 0..MOST_ROUNDS {
            let missing = self.apart(target, given(&at));
            if settles && self.is_small(missing, target) {
                return Ok(at);
            }
            let columns = self.columns(|unit| influence(&at, unit))?;
            let present = chosen(at.motors.total());
            let base = if settles { present } else { origin };
            let values = loop {
                let due = due(&columns, less(present, base), held, missing, present);
                let moved = self.least(&columns, base, held, due)?;
                let Some((number, end)) = self.leaves(moved, held, range) else {
                    break moved;
                };
                if let Some(place) = held.get_mut(number) {
                    *place = Some(end);
                }
            };
            let mut motors = at.motors;
            for (motor, value) in self.motors.into_iter().zip(values) {
                motors.set(motor, value, 0);
            }
            at = go(&at, motors)?;
            let moved = less(values, present).into_iter().zip(self.weights);
            let change = moved.fold(T::ZERO, |sum, (moved, weight)| sum + moved * moved / weight);
            settles |= change <= T::from_f64(T::EPSILON);
        }
        Err(Stop::new(self.name, Cause::Open))
    }

    /// The values of the motors, as near as possible to their base, at which those that are not held do this.
    fn least(
        &self,
        columns: &[[T; G]; N],
        base: [T; N],
        held: [Option<T>; N],
        wanted: [T; G],
    ) -> Result<[T; N], Stop> {
        let mut rows = [[T::ZERO; G]; G];
        let free = columns.iter().zip(self.weights).zip(held);
        for ((column, weight), _) in free.filter(|(_, held)| held.is_none()) {
            for (row, left) in rows.iter_mut().zip(column) {
                for (entry, right) in row.iter_mut().zip(column) {
                    *entry += weight * *left * *right;
                }
            }
        }
        let mut most = T::from_f64(64.0 * T::EPSILON);
        for (number, row) in rows.iter().enumerate() {
            most *= row.get(number).copied().unwrap_or(T::ZERO);
        }
        let mut multipliers = wanted;
        let det = mech_core::dense::solve(&mut rows, &mut multipliers);
        // Also true of what is no number.
        let is_determined = det > most;
        if !is_determined || multipliers.iter().any(|number| !Real::is_finite(*number)) {
            return Err(Stop::new(self.name, Cause::Singular));
        }
        let mut values = base;
        let motors = values.iter_mut().zip(columns).zip(self.weights).zip(held);
        for (((value, column), weight), held) in motors {
            let part = column.iter().zip(multipliers);
            let part = part.fold(T::ZERO, |sum, (entry, number)| sum + *entry * number);
            *value = held.unwrap_or(*value + weight * part);
        }
        Ok(values)
    }

    /// The first motor that leaves its range and is not held, by its number, and the end that it leaves.
    fn leaves<const M: usize>(
        &self,
        values: [T; N],
        held: [Option<T>; N],
        range: Option<&[[T; 2]; M]>,
    ) -> Option<(usize, T)> {
        let range = range?;
        let motors = self.motors.into_iter().zip(values).zip(held).enumerate();
        let mut motors = motors.filter(|(_, (_, held))| held.is_none());
        motors.find_map(|(number, ((motor, value), _))| {
            let [low, high] = *range.get(motor)?;
            let end = value.max(low).min(high);
            (end != value).then_some((number, end))
        })
    }

    /// Whether what is missing is only rounding.
    fn is_small(&self, missing: [T; G], target: [T; G]) -> bool {
        let rounding = T::from_f64(16.0 * T::EPSILON);
        let mut parts = missing.iter().zip(target).zip(self.given);
        parts.all(|((missing, target), input)| {
            let size = match input {
                Input::Turning(_) => T::TURN,
                _ => self.size.max(target.abs()),
            };
            missing.abs() <= rounding * size
        })
    }
}

/// What motors that are free have to do from their base, by their present influence.
fn due<T: Scalar, const N: usize, const G: usize>(
    columns: &[[T; G]; N],
    gone: [T; N],
    held: [Option<T>; N],
    missing: [T; G],
    present: [T; N],
) -> [T; G] {
    let motors = columns.iter().zip(gone).zip(held.into_iter().zip(present));
    motors.fold(missing, |mut sum, ((column, gone), (held, present))| {
        let part = held.map_or(gone, |end| present - end);
        for (sum, entry) in sum.iter_mut().zip(column) {
            *sum += *entry * part;
        }
        sum
    })
}
