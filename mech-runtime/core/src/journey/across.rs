//! Past the change point of a loop that is solved by iteration: there the iteration fails, so it is begun beyond it.

use super::event::Event;
use super::pace::lesser;
use super::piece::{Reach, reach};
use super::{AtZero, Journey};
use crate::{Real, motors};

/// How far beyond it is begun, in fourth roots of the precision: both what curves a straight way and what rounding does to it are
/// small then beside the distance from the other branch.
const WAYS: [f64; 2] = [8.0, 32.0];
/// The first step back from it changes the sine by no more than this part of it, each next one is so much longer, or shorter where
/// it fails: beside it no iteration reaches far.
const FIRST: f64 = 0.25;
const LONGER: f64 = 1.25;
const SHORTER: f64 = 0.25;
const MOST_STEPS: u32 = 256;

/// An iterated loop comes to what may be its change point.
pub(super) struct Meeting<P, T> {
    pub(super) index: usize,
    /// A position before it, and which part of the way is done there.
    pub(super) before: (P, T),
    /// A position beyond it, if everything goes straight on there.
    pub(super) beyond: Option<Beyond<P, T>>,
}

/// By so much a sine may be off from where it should go straight on to, as a part of that.
const OFF: f64 = 0.25;

/// A position beyond.
pub(super) struct Beyond<P, T> {
    pub(super) to: P,
    /// The part of the way that is done there.
    pub(super) end: T,
    /// Whether it is on the loop's other side.
    pub(super) turned: bool,
}

/// Whether a loop that is passed over its change points is solved by iteration: it does not stand there.
pub(super) fn is_stepped_over<T: Real, J: Journey<T>>(journey: &J, index: usize) -> bool {
    let watch = journey.watch(index);
    watch.iterated && watch.at_zero != AtZero::Stay
}

/// Whether such a loop is so near a zero of its sine that it may have a change point there.
pub(super) fn is_near<T: Real, J: Journey<T>>(
    journey: &J,
    position: &J::Position,
    index: usize,
) -> bool {
    is_stepped_over(journey, index) && {
        let sine = journey.sine(position, index);
        sine * sine <= journey.tiny_square(position, index)
    }
}

/// Whether the sine of such a loop would have another sign if it had gone straight on from two positions to a third.
pub(super) fn bounces<T: Real, J: Journey<T>>(
    journey: &J,
    (before, begun): &(J::Position, T),
    (at, part): (&J::Position, T),
    (to, end): (&J::Position, T),
) -> bool {
    let gone = part - *begun;
    let bounces = |index| {
        let [a, b, c] = [before, at, to].map(|position| journey.sine(position, index));
        gone > T::ZERO && (b + (b - a) * ((end - part) / gone)) * c < T::ZERO
    };
    (0..journey.watches()).any(|index| is_stepped_over(journey, index) && bounces(index))
}

/// What an iterated loop comes to: where nothing went on, or where its sine was found to be zero between.
pub(super) fn meeting<T: Real, J: Journey<T>>(
    journey: &J,
    (from, done): (&J::Position, T),
    reached: &Reach<J::Position, J::Stop, T>,
    event: &Event<T>,
) -> Option<Meeting<J::Position, T>> {
    let (part, index) = match *event {
        Event::None if reached.stop.is_some() => {
            let mut all = 0..journey.watches();
            (
                reached.end,
                all.find(|index| is_near(journey, &reached.to, *index))?,
            )
        }
        Event::Near(part, index) => (part, index),
        _ => return None,
    };
    // Not so near that rounding tells more than the position.
    let start = part - way(journey, index, WAYS[0]) * T::HALF;
    let before = if start <= done {
        (from.clone(), done)
    } else {
        let stand = reach(journey, from, done, start);
        (stand.to, stand.end)
    };
    let beyond = across(journey, (&before.0, before.1), index);
    // Beyond a dead point there is nothing.
    (beyond.is_some() || reached.stop.is_none()).then_some(Meeting {
        index,
        before,
        beyond,
    })
}

/// So many fourth roots of the precision as a part of the way.
fn way<T: Real, J: Journey<T>>(journey: &J, index: usize, times: f64) -> T {
    T::from_f64(times) * T::from_f64(T::EPSILON).sqrt().sqrt() / journey.watch(index).change
}

/// The position a little farther, from one before a zero of a sine: that which everything goes straight on to.
fn across<T: Real, J: Journey<T>>(
    journey: &J,
    (position, part): (&J::Position, T),
    index: usize,
) -> Option<Beyond<J::Position, T>> {
    WAYS.into_iter().find_map(|times| {
        let way = lesser(way(journey, index, times), T::ONE - part);
        let end = part + way;
        let last = back(journey, (position, part), (way, index))?;
        let before = back(
            journey,
            (&last, part - way),
            (way * T::from_f64(2.0), index),
        )?;
        let mut beyond = journey.beyond(&before, &last);
        let sine = |position| journey.sine(position, index);
        let ahead = motors::mirrored(sine(&before), sine(&last));
        let turned = ahead * sine(&last) < T::ZERO;
        if turned {
            journey.turn_over(&mut beyond, index);
        }
        let to = journey.at(&beyond, end).ok()?;
        // On another branch the sine is another.
        let off = (sine(&to) - ahead).abs();
        (off <= T::from_f64(OFF) * ahead.abs()).then_some(())?;
        Some(Beyond { to, end, turned })
    })
}

/// The position so far back on the way.
fn back<T: Real, J: Journey<T>>(
    journey: &J,
    (position, part): (&J::Position, T),
    (way, index): (T, usize),
) -> Option<J::Position> {
    let (mut at, mut gone) = (position.clone(), T::ZERO);
    let sine = journey.sine(position, index).abs();
    let mut step = T::from_f64(FIRST) * sine / journey.watch(index).change;
    for _ in 0..MOST_STEPS {
        let farther = lesser(gone + step, way);
        if let Ok(next) = journey.at(&at, part - farther) {
            (at, gone) = (next, farther);
            step = step * T::from_f64(LONGER);
        } else {
            step = step * T::from_f64(SHORTER);
        }
        if gone >= way {
            return Some(at);
        }
    }
    None
}
