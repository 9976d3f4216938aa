//! Dead points that a move begins at or leads to. Beside one, rounding lets a loop close here and there, and hides the sign of its sine.

use super::pace::{is_calm, is_far_at_ends};
use super::sine::{has_passed, hidden_square};
use super::{Journey, Standing};
use crate::Real;

/// The first distance that is tried changes the square of a sine by so many roundings at most. Each next distance is doubled, so often.
const FIRST: f64 = 16.0;
const DOUBLINGS: u32 = 48;
/// Beside a dead point the square of the sine grows straight with the distance, within this part. The dead point may be off by the second
/// number, as a part of the distance. Beside a change point the square grows with the square of the distance, on both sides.
const OFF: f64 = 0.125;
const BESIDE: f64 = 0.25;
/// A loop has left its dead point where the square is so many times what rounding hides. No dead point is looked for where it is greater
/// by the second factor, or than so many roots of the precision.
const SEEN: f64 = 16.0;
const MOST: f64 = 256.0;
const MOST_ROOTS: f64 = 64.0;

/// Where everything is a little farther, and the part of the move that is done there. None unless a loop stands at a dead point or beside it,
/// and the move leads away from it.
pub(super) fn depart<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    done: T,
) -> Option<(J::Position, T)> {
    let beside = |index: &usize| is_beside_zero(journey, from, *index);
    let mut all = (0..journey.watches()).filter(beside);
    let leave = |index| leave_straight(journey, (from, done), (index, T::ONE), true);
    let (mut to, end) = all.find_map(leave)?;
    for index in (0..journey.watches()).filter(beside) {
        journey.set_standing(&mut to, index, Standing::Away);
    }
    Some((to, end))
}

/// Whether a loop whose sine is zero has come to a dead point.
pub(super) fn is_at_dead_point<T: Real, J: Journey<T>>(
    journey: &J,
    from: (&J::Position, T),
    index: usize,
) -> bool {
    // Behind the start others have change points that they have passed: nothing is there as it was.
    let any_passed = (0..journey.watches()).any(|one| has_passed(journey, from.0, one));
    let back = T::ZERO - T::ONE;
    !any_passed && leave_straight(journey, from, (index, back), false).is_some()
}

/// The nearest position in this sense of the move to which a loop leaves its dead point. With it stands its part of the move. All loops may
/// have to leave theirs there, or not to move.
fn leave_straight<T: Real, J: Journey<T>>(
    journey: &J,
    (from, done): (&J::Position, T),
    (index, sense): (usize, T),
    leaves_all: bool,
) -> Option<(J::Position, T)> {
    let mut distance = T::from_f64(FIRST * T::EPSILON) / journey.watch(index).change;
    // The last positions that were reached, each twice as far as the one before.
    let mut seen: [Option<J::Position>; 4] = [const { None }; 4];
    for _ in 0..DOUBLINGS {
        let end = done + sense * distance;
        // A position that is not reached from the last one may be reached from `from`.
        let to = journey.at(seen[3].as_ref().unwrap_or(from), end).ok();
        seen.rotate_left(1);
        seen[3] = to;
        match &seen {
            [.., Some(to)] if end > T::ONE || is_well_away(journey, to, index) => break,
            [Some(first), Some(second), Some(third), Some(to)] => {
                let positions = [first, second, third, to];
                // At a dead point nothing closes in the other sense.
                if grows_straight(journey, positions, index)
                    && (!leaves_all || all_leave(journey, (from, done), positions, end))
                    && journey.at(from, done - sense * distance).is_err()
                {
                    return Some((to.clone(), end));
                }
            }
            _ => {}
        }
        distance = distance + distance;
    }
    None
}

/// Whether each loop leaves a dead point straight in four positions, or is far from any zero of its sine.
fn all_leave<T: Real, J: Journey<T>>(
    journey: &J,
    (from, done): (&J::Position, T),
    positions: [&J::Position; 4],
    end: T,
) -> bool {
    let [_, _, third, last] = positions;
    let stays = |one| {
        is_far_at_ends(journey, (from, last), end - done, one)
            || is_calm(journey, from, third, one) && is_calm(journey, third, last, one)
    };
    (0..journey.watches()).all(|one| grows_straight(journey, positions, one) || stays(one))
}

/// Whether a loop is so near a zero of its sine that it may be nothing but rounding.
pub(super) fn is_beside_zero<T: Real, J: Journey<T>>(
    journey: &J,
    at: &J::Position,
    index: usize,
) -> bool {
    let hidden = T::from_f64(SEEN) * hidden_square(journey, at, index);
    square(journey, at, index) <= hidden.max(T::from_f64(T::EPSILON).sqrt())
}

/// Whether a loop is so far away from a zero of its sine that rounding cannot have hidden how its square grew.
fn is_well_away<T: Real, J: Journey<T>>(journey: &J, at: &J::Position, index: usize) -> bool {
    let hidden = T::from_f64(MOST) * hidden_square(journey, at, index);
    square(journey, at, index) > hidden.max(T::from_f64(MOST_ROOTS * T::EPSILON.sqrt()))
}

/// Whether the square of a sine grows in proportion to the distance in four positions, each twice as far as the one before.
fn grows_straight<T: Real, J: Journey<T>>(
    journey: &J,
    positions: [&J::Position; 4],
    index: usize,
) -> bool {
    let squares = positions.map(|at| square(journey, at, index));
    let hidden = T::from_f64(SEEN) * hidden_square(journey, positions[3], index);
    let is_straight = |at: usize| {
        let [first, second, third] = [squares[at], squares[at + 1], squares[at + 2]];
        let [near, far] = [second - first, third - second];
        (far - (near + near)).abs() <= T::from_f64(OFF) * third
            && (far - second).abs() <= T::from_f64(BESIDE) * third
    };
    squares[3] > hidden && is_straight(0) && is_straight(1)
}

fn square<T: Real, J: Journey<T>>(journey: &J, at: &J::Position, index: usize) -> T {
    let sine = journey.sine(at, index);
    sine * sine
}
