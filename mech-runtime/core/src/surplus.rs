//! Leading a point by more motors than it needs: they go as little as they can.

use crate::pieces::{between, in_pieces};
use crate::{Real, dense};
use core::convert::Infallible;

/// So many rounds are made on a piece of the way.
const MOST_ROUNDS: usize = 40;

/// A mechanism in which more motors than needed follow a point. `G` numbers are given: its place, or that and the angle of its link.
pub trait SurplusMotors<T: Real, const G: usize> {
    /// Everything that is carried from one move to the next.
    type Position: Clone;
    /// Why it cannot be somewhere.
    type Stop;
    /// A number for each motor that follows.
    type Values: Clone + AsRef<[T]> + AsMut<[T]>;
    /// For each motor that follows, the end of its range if it is held there.
    type Held: Clone + AsRef<[Option<T>]> + AsMut<[Option<T>]>;
    /// The influence of each motor that follows on what is given.
    type Influence: AsRef<[[T; G]]>;

    /// What is given, where it is at a position.
    fn given(&self, at: &Self::Position) -> [T; G];
    /// The influence coefficients of the motors at a position.
    ///
    /// # Errors
    /// Why rates are not determined there.
    fn influence(&mut self, at: &Self::Position) -> Result<Self::Influence, Self::Stop>;
    /// The values of the motors that follow, over whole turns.
    fn values(&self, at: &Self::Position) -> Self::Values;
    /// No motor held.
    fn free(&self) -> Self::Held;
    /// The position where the motors that follow have other values.
    ///
    /// # Errors
    /// Why the mechanism cannot go there.
    fn go(
        &mut self,
        from: &Self::Position,
        values: &Self::Values,
    ) -> Result<Self::Position, Self::Stop>;
    /// For each motor that follows, the square of how far it goes as easily as another turns by a radian.
    fn weights(&self) -> &[T];
    /// The declared range of a motor, if it has one.
    fn range(&self, number: usize) -> Option<[T; 2]>;
    /// Whether one of what is given is an angle.
    fn is_angle(&self, number: usize) -> bool;
    /// The size of the links, in scene units: rounding is a part of it.
    fn size(&self) -> T;
    /// The stop that says that the motors cannot move what is given every way.
    fn undetermined(&self) -> Self::Stop;
    /// The stop that says that the motors do not bring it to its place.
    fn unreached(&self) -> Self::Stop;
}

/// Leads what is given to a place on the straight way. In each piece of it the motors go as little as they can, by the sum of the squares of
/// how far they go; one that comes to the end of its range stays there.
///
/// # Errors
/// What stops it, and how far it would have come.
pub fn lead<T: Real, const G: usize, M: SurplusMotors<T, G>>(
    motors: &mut M,
    start: &M::Position,
    place: [T; G],
) -> Result<M::Position, (M::Stop, [T; G])> {
    let here = motors.given(start);
    let mut end = here;
    for (value, apart) in end.iter_mut().zip(apart(motors, place, here)) {
        *value = *value + apart;
    }
    let way = |part| between(here, end, part);
    let mut at = start.clone();
    let moved = in_pieces(motors.unreached(), |part| {
        Ok::<_, Infallible>(match lead_at_once(motors, &at, way(part)) {
            Ok(there) => {
                at = there;
                None
            }
            Err(stop) => Some(stop),
        })
    });
    match moved {
        Ok(Ok(())) => Ok(at),
        Ok(Err((stop, done))) => Err((stop, way(done))),
        Err(never) => match never {},
    }
}

/// By how much a place is apart from another: angles the shorter way.
fn apart<T: Real, const G: usize, M: SurplusMotors<T, G>>(
    motors: &M,
    place: [T; G],
    from: [T; G],
) -> [T; G] {
    let mut apart = place;
    for (number, (value, from)) in apart.iter_mut().zip(from).enumerate() {
        *value = *value - from;
        if motors.is_angle(number)
            && let Some((_, displacement)) = value.whole_turns()
        {
            *value = displacement;
        }
    }
    apart
}

/// Goes a piece of the way at once, by Newton's method on the conditions for the least motion from where it begins; then on the place alone.
fn lead_at_once<T: Real, const G: usize, M: SurplusMotors<T, G>>(
    motors: &mut M,
    from: &M::Position,
    target: [T; G],
) -> Result<M::Position, M::Stop> {
    let origin = motors.values(from);
    let (mut at, mut held, mut settles) = (from.clone(), motors.free(), false);
    for _ in 0..MOST_ROUNDS {
        let missing = apart(motors, target, motors.given(&at));
        if settles && is_small(motors, missing, target) {
            return Ok(at);
        }
        let influence = motors.influence(&at)?;
        let present = motors.values(&at);
        let base = if settles { &present } else { &origin };
        let values = loop {
            let due = due(
                influence.as_ref(),
                [&present, base].map(AsRef::as_ref),
                held.as_ref(),
                missing,
            );
            let moved = least(influence.as_ref(), motors.weights(), base, held.as_ref(), due);
            let moved = moved.ok_or_else(|| motors.undetermined())?;
            let Some((number, end)) = leaves(motors, &moved, &held) else {
                break moved;
            };
            if let Some(place) = held.as_mut().get_mut(number) {
                *place = Some(end);
            }
        };
        at = motors.go(&at, &values)?;
        let moved = values.as_ref().iter().zip(present.as_ref()).zip(motors.weights());
        let change = moved.fold(T::ZERO, |sum, ((value, present), weight)| {
            let moved = *value - *present;
            sum + moved * moved / *weight
        });
        settles |= change <= T::from_f64(T::EPSILON);
    }
    Err(motors.unreached())
}

/// What motors that are free have to do from their base, by their present influence.
fn due<T: Real, const G: usize>(
    influence: &[[T; G]],
    [present, base]: [&[T]; 2],
    held: &[Option<T>],
    missing: [T; G],
) -> [T; G] {
    let motors = influence.iter().zip(present.iter().zip(base)).zip(held);
    motors.fold(missing, |mut sum, ((column, (present, base)), held)| {
        let part = *present - held.unwrap_or(*base);
        for (sum, entry) in sum.iter_mut().zip(column) {
            *sum = *sum + *entry * part;
        }
        sum
    })
}

/// The values of the motors, as near as possible to their base by these weights, at which those that are not held do this. None if they are
/// not determined.
pub fn least<T: Real, V: Clone + AsMut<[T]>, const G: usize>(
    influence: &[[T; G]],
    weights: &[T],
    base: &V,
    held: &[Option<T>],
    wanted: [T; G],
) -> Option<V> {
    let mut rows = [[T::ZERO; G]; G];
    let free = influence.iter().zip(weights).zip(held);
    for ((column, weight), _) in free.filter(|(_, held)| held.is_none()) {
        for (row, left) in rows.iter_mut().zip(column) {
            for (entry, right) in row.iter_mut().zip(column) {
                *entry = *entry + *weight * *left * *right;
            }
        }
    }
    let mut most = T::from_f64(64.0 * T::EPSILON);
    for (number, row) in rows.iter().enumerate() {
        most = most * row.get(number).copied().unwrap_or(T::ZERO);
    }
    let mut multipliers = wanted;
    let det = dense::solve(&mut rows, &mut multipliers);
    // Also true of what is no number.
    let is_determined = det > most;
    if !is_determined || multipliers.iter().any(|number| !number.is_finite()) {
        return None;
    }
    let mut values = base.clone();
    let all = values.as_mut().iter_mut().zip(influence).zip(weights).zip(held);
    for (((value, column), weight), held) in all {
        let part = column.iter().zip(multipliers);
        let part = part.fold(T::ZERO, |sum, (entry, number)| sum + *entry * number);
        *value = held.unwrap_or(*value + *weight * part);
    }
    Some(values)
}

/// The first motor that leaves its range and is not held, by its number, and the end that it leaves.
fn leaves<T: Real, const G: usize, M: SurplusMotors<T, G>>(
    motors: &M,
    values: &M::Values,
    held: &M::Held,
) -> Option<(usize, T)> {
    let all = values.as_ref().iter().zip(held.as_ref()).enumerate();
    let mut free = all.filter(|(_, (_, held))| held.is_none());
    free.find_map(|(number, (value, _))| {
        let [low, high] = motors.range(number)?;
        let end = if *value < low {
            low
        } else if *value > high {
            high
        } else {
            return None;
        };
        Some((number, end))
    })
}

/// Whether what is missing is only rounding.
fn is_small<T: Real, const G: usize, M: SurplusMotors<T, G>>(
    motors: &M,
    missing: [T; G],
    target: [T; G],
) -> bool {
    let rounding = T::from_f64(16.0 * T::EPSILON);
    let mut parts = missing.iter().zip(target).enumerate();
    parts.all(|(number, (missing, target))| {
        let size = if motors.is_angle(number) { T::TURN } else { motors.size().max(target.abs()) };
        missing.abs() <= rounding * size
    })
}
