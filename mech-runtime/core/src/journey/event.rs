//! Events of watched loops on a piece: the sine of one is zero, or something does not close.

use super::pace::{is_far, is_far_at_ends, lesser};
use super::reach::{Reach, position_at};
use super::sine::{
    NEAREST, distance, has_passed, hidden_square, is_near, is_stepped_over, is_zero,
};
use super::{AtZero, Journey};
use crate::Real;

/// Beside a dead point the loop may be open on a very narrow stretch: a piece is halved so often to find it.
const NARROW: u32 = 20;
/// Each halving gives a digit of a binary fraction: no float has more.
const HALVINGS: u32 = 64;
/// Where another loop has its zero, the square has a kink, and parabolas converge slowly. So each time after so many rounds the longer
/// side is halved instead.
const HALVED_EVERY: u32 = 3;
/// If the square of a sine falls below this part of its values at both ends of a piece, it may be zero there.
const DIP: f64 = 0.0625;

/// The least square found is taken for zero if it is at most so many times what rounding hides, which is only estimated.
const BARELY_SEEN: f64 = 16.0;

/// An event of a watched loop in a piece.
pub(super) enum Event<T> {
    None,
    /// A loop passes its change point.
    Zero(T, usize),
    /// An iterated loop comes so near zero that it may have its change point there.
    Near(T, usize),
    /// Something does not close there.
    Blocked(T),
}

impl<T: Copy> Event<T> {
    /// The part of the move at which it is.
    fn part(&self) -> Option<T> {
        match *self {
            Self::None => None,
            Self::Zero(part, _) | Self::Near(part, _) | Self::Blocked(part) => Some(part),
        }
    }
}

/// The first thing that happens to a watched loop on a piece.
///
/// Behind a change point nothing is as it will be once its loop has gone over. What another loop does before may be hidden by what it seems to
/// do there. So the piece up to it is examined again, until nothing happens before.
pub(super) fn first_event<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    done: T,
    reach: &Reach<J::Position, J::Stop, T>,
) -> Event<T> {
    let mut first = soonest(journey, from, done, reach, |_| true);
    for _ in 1..journey.watches() {
        let (Event::Zero(part, passed) | Event::Near(part, passed)) = first else {
            break;
        };
        // Not quite: where pins meet nothing tells how other loops stand. What comes to zero so near is passed together.
        let end = part - distance(journey, passed, NEAREST);
        let Some(to) = (end > done).then(|| position_at(journey, from, done, end)).flatten() else {
            break;
        };
        let before = Reach::there(to, end);
        match soonest(journey, from, done, &before, |index| index != passed) {
            Event::None => break,
            sooner => first = sooner,
        }
    }
    first
}

/// The first of the events that are found on a piece for those loops that are looked at where it ends.
fn soonest<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    done: T,
    reach: &Reach<J::Position, J::Stop, T>,
    looks_at: impl Fn(usize) -> bool,
) -> Event<T> {
    let mut first = Event::None;
    for index in 0..journey.watches() {
        let is_far = is_far_at_ends(journey, (from, &reach.to), reach.end - done, index);
        if is_far || !looks_at(index) {
            continue;
        }
        // A loop that has just passed its zero does not come to it once more. But it may have been a dead point.
        let event = match (has_passed(journey, from, index), is_zero(journey, from, index)) {
            (true, true) => blocked_at_ends(journey, from, done, reach.end, index),
            (true, false) => Event::None,
            (false, _) => least_sine(journey, from, done, reach, index),
        };
        let sooner = match (event.part(), first.part()) {
            (None, _) => false,
            (_, None) => true,
            (Some(a), Some(b)) => a < b,
        };
        if sooner {
            first = event;
        }
    }
    first
}

/// Looks for the place where the square of a sine is least, by parabolas through three points: it is smooth, its root is not.
fn least_sine<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    done: T,
    reach: &Reach<J::Position, J::Stop, T>,
    index: usize,
) -> Event<T> {
    let watch = journey.watch(index);
    let square = |position: &J::Position| {
        let sine = journey.sine(position, index);
        sine * sine
    };
    let (mut a, mut b) = ((done, square(from)), (reach.end, square(&reach.to)));
    // At an end it is not passed: it was left before, or is arrived at. But at a dead point what is beyond may close again.
    if is_zero(journey, from, index) || is_zero(journey, &reach.to, index) {
        return blocked_at_ends(journey, from, done, reach.end, index);
    }
    if (journey.sine(from, index) > T::ZERO) != (journey.sine(&reach.to, index) > T::ZERO) {
        return change_of_sign(journey, from, (done, reach.end), index);
    }
    let lesser_end = lesser(a.1, b.1);
    // The ends of what is left beside an end, once it is narrowed.
    let mut ends: Option<(J::Position, J::Position)> = None;
    let mut narrowed = 0;
    let mut at = straight(a, b);
    let mut least: Option<(T, T)> = None;
    // The square that rounding hides there.
    let mut hidden = T::ZERO;
    for round in 1..=HALVINGS {
        if !(at > a.0 && at < b.0) {
            break;
        }
        let Some(position) = position_at(journey, from, done, at) else {
            return Event::Blocked(at);
        };
        if is_near(journey, &position, index) {
            return Event::Near(at, index);
        }
        if is_zero(journey, &position, index) {
            // Beside an end rounding alone may hide a sign, so near to zero.
            return match watch.at_zero {
                AtZero::ChangeBranch | AtZero::Stop if narrowed == 0 => Event::Zero(at, index),
                _ => Event::None,
            };
        }
        let value = square(&position);
        let found = (at, value);
        if least.is_none_or(|known| value < known.1) {
            hidden = hidden_square(journey, &position, index);
        }
        least = match least {
            // Falling towards an end: what is least lies beside it, unless nothing can.
            None if value >= a.1 || value >= b.1 => {
                let (left, right) = ends.get_or_insert_with(|| (from.clone(), reach.to.clone()));
                if a.1 <= b.1 {
                    (b, *right) = (found, position);
                } else {
                    (a, *left) = (found, position);
                }
                narrowed += 1;
                if narrowed > NARROW || is_far(journey, left, right, b.0 - a.0, index) {
                    return Event::None;
                }
                at = straight(a, b);
                continue;
            }
            None => Some(found),
            Some(known) if value < known.1 => {
                if at < known.0 {
                    b = known;
                } else {
                    a = known;
                }
                Some(found)
            }
            Some(known) => {
                if at < known.0 {
                    a = found;
                } else {
                    b = found;
                }
                Some(known)
            }
        };
        let Some(middle) = least else {
            return Event::None;
        };
        at = if round % HALVED_EVERY == 0 {
            middle_of_longer(a.0, middle.0, b.0)
        } else {
            vertex(a, middle, b)
        };
    }
    // As small as rounding lets it be.
    match least {
        Some((at, value))
            if is_stepped_over(journey, index) && value < lesser_end * T::from_f64(DIP) =>
        {
            Event::Near(at, index)
        }
        Some((at, value))
            if !is_stepped_over(journey, index)
                && watch.at_zero != AtZero::Stay
                && narrowed == 0
                && value < lesser_end * T::from_f64(DIP)
                && value <= hidden * T::from_f64(BARELY_SEEN) =>
        {
            Event::Zero(at, index)
        }
        _ => Event::None,
    }
}

/// Where the root of a square is zero between two places, if it goes straight through it.
fn straight<T: Real>(a: (T, T), b: (T, T)) -> T {
    let (left, right) = (a.1.sqrt(), b.1.sqrt());
    a.0 + (b.0 - a.0) * (left / (left + right))
}

/// Looks for an open stretch beside the ends of a piece, however narrow. Where loops are iterated, a failed iteration tells nothing, so
/// it must be this loop, in closed form. It must also be farther away than the error of iterations.
fn blocked_at_ends<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    done: T,
    end: T,
    index: usize,
) -> Event<T> {
    let watch = journey.watch(index);
    let is_blocked = |part| {
        let stop = journey.at(from, part).err();
        let is_it = |stop| !watch.iterated && journey.is_open(&stop, index);
        stop.is_some_and(|stop| !journey.subdivides() || is_it(stop))
    };
    let mut offset = end - done;
    for _ in 0..NARROW {
        offset = offset * T::HALF;
        if journey.subdivides() && offset * watch.change < T::from_f64(T::EPSILON).sqrt() {
            break;
        }
        for part in [done + offset, end - offset] {
            if part > done && part < end && is_blocked(part) {
                return Event::Blocked(part);
            }
        }
    }
    Event::None
}

/// Looks for the place where a sine changes its sign. Only two lines that cut each other do so by themselves. At the zero they lie on each
/// other, or they do not cut each other at all.
fn change_of_sign<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    (mut low, mut high): (T, T),
    index: usize,
) -> Event<T> {
    let positive = journey.sine(from, index) > T::ZERO;
    for _ in 0..HALVINGS {
        let middle = low + (high - low) * T::HALF;
        if !(middle > low && middle < high) {
            break;
        }
        match journey.at(from, middle) {
            Err(_) => return Event::Blocked(middle),
            Ok(position) if is_zero(journey, &position, index) => {
                return match journey.watch(index).at_zero {
                    AtZero::Stay => Event::None,
                    AtZero::ChangeBranch | AtZero::Stop => Event::Zero(middle, index),
                };
            }
            Ok(position) if (journey.sine(&position, index) > T::ZERO) == positive => low = middle,
            Ok(_) => high = middle,
        }
    }
    Event::Blocked(high)
}

/// The middle of the longer side.
fn middle_of_longer<T: Real>(a: T, m: T, b: T) -> T {
    let side = if m - a > b - m { a } else { b };
    m + (side - m) * T::HALF
}

/// Where the parabola through three points is least; beside the middle one where that is the place itself.
fn vertex<T: Real>(a: (T, T), m: (T, T), b: (T, T)) -> T {
    let (left, right) = (m.0 - a.0, b.0 - m.0);
    let (falls, rises) = ((a.1 - m.1) / left, (b.1 - m.1) / right);
    // The slopes at the middles of the two sides, and where between them zero lies.
    let shift = (falls * right - rises * left) / (falls + rises) * T::HALF;
    let at = m.0 + shift;
    let nearest = (b.0 - a.0) * T::from_f64(1e-4);
    // A step shorter than this tells nothing new on its side: the other side is looked at.
    if shift.abs() < nearest {
        let side = if left > right { T::ZERO - nearest } else { nearest };
        return m.0 + side;
    }
    at
}
