//! The length of a piece: from the sines where it begins and their rates.

use super::sine::is_zero;
use super::{Growth, Journey, Standing, Turn};
use crate::Real;

/// Where a sine may come to zero, a piece is so short that its square changes by no more than this. So there is one zero at most.
const PIECE: f64 = 0.02;
/// A likely piece lets the square of a sine fall by this part of what it is at the start.
const LIKELY: f64 = 0.4;
/// The length of a short piece, a little less so that rounding does not make it too long.
const LIKELY_SHORT: f64 = 0.99 * PIECE;
/// Rounding never hides more of the square of a sine than this.
const SEEN: f64 = 0.015_625;
/// In one piece an angle that is followed over whole turns changes by no more than this: more than half a turn would be lost.
pub(super) const TURN: f64 = 2.5;
/// The same where only a guess says how fast the angle turns.
const TURN_GUESSED: f64 = 0.5;
/// Near their zeros earlier loops make later ones faster without end. Pieces are not made shorter than this factor asks for.
const MOST_GROWTH: f64 = 16.0;

/// In the first piece of a move, a guess is trusted for this much change of a square at most. For a motor of coupled loops that is a
/// degree.
const FIRST: f64 = 0.07;
/// The next piece is longer by this factor at most: the first if all rates are bounds, the second if some are guesses. A fall of the
/// square to zero then shows on the piece before.
const LONGER: f64 = 2.0;
const LONGER_GUESSED: f64 = 1.5;
/// If a guess is right, the square of a sine in the middle of a piece is the mean of both ends, within this part of their sum.
const OFF_MEAN: f64 = 0.03125;
/// If a guess of an angle's rate is right, both halves of a piece turn alike, within this.
const OFF_HALF: f64 = 0.25;
/// Where the middle of a piece is looked at as well, the square may be lower in between by this part of what a guess says.
const OF_GUESS: f64 = 1.0 / 64.0;
/// A loop stays away from zero if the sum of the squares of its sine at both ends exceeds so many times the change that a bound allows.
const OF_BOUND: f64 = 2.0;
/// Where pieces are short, rates that rest on a guess are taken to be so many times as great.
const LEAST_GUESSED: f64 = 4.0;

/// Whether nothing can stop a step between two positions that are this part of the move apart. Then no watched loop comes to zero, and no angle
/// loses a turn.
#[inline]
pub fn is_clear<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &J::Position,
    part: T,
) -> bool {
    journey.is_one_piece()
        && guesses(journey).all(|change| change * part <= T::from_f64(FIRST))
        && is_passable(journey, from, to, part)
}

/// Whether the middle of a piece is where its ends foretell it. Only a guess, which is not believed, tells by how far the sines and angles in it
/// change.
pub(super) fn is_foretold<T: Real, J: Journey<T>>(
    journey: &J,
    (from, begun): (&J::Position, T),
    (to, end): (&J::Position, T),
) -> bool {
    let watches = || (0..journey.watches()).filter(|index| journey.watch(*index).guessed);
    let follows = || (0..journey.follows()).filter(|index| journey.turn(*index).guessed);
    if watches().next().is_none() && follows().next().is_none() {
        return true;
    }
    let Ok(middle) = journey.at(from, begun + (end - begun) * T::HALF) else {
        return false;
    };
    let is_even = |index| {
        let [a, m, b] = [from, &middle, to].map(|at| journey.sine(at, index));
        let (ends, between) = (a * a + b * b, m * m);
        let off = (between + between - ends).abs();
        a * m > T::ZERO && off <= T::from_f64(OFF_MEAN + OFF_MEAN) * ends
    };
    let turns_evenly = |index| {
        let [a, m, b] = [from, &middle, to].map(|at| journey.angle(at, index));
        ((m - a) - (b - m)).abs() <= T::from_f64(OFF_HALF)
    };
    watches().all(is_even) && follows().all(turns_evenly)
}

/// For each sine whose rate is a guess, the change of its square in the whole move.
fn guesses<T: Real, J: Journey<T>>(journey: &J) -> impl Iterator<Item = T> {
    let watches = (0..journey.watches()).map(|index| journey.watch(index));
    watches.filter(|watch| watch.guessed).map(|watch| watch.change)
}

/// The longest first piece of a move: nothing was seen yet that could correct a guess.
pub(super) fn first<T: Real, J: Journey<T>>(journey: &J, longest: T) -> T {
    guesses(journey).fold(longest, |length, change| lesser(length, T::from_f64(FIRST) / change))
}

/// Returns the greatest ratio of the length of the next piece to that of this one.
pub(super) fn most_stretch<T: Real, J: Journey<T>>(journey: &J) -> T {
    let is_guessed = guesses(journey).next().is_some();
    T::from_f64(if is_guessed { LONGER_GUESSED } else { LONGER })
}

#[inline]
pub(super) fn is_passable<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &J::Position,
    part: T,
) -> bool {
    (0..journey.watches()).all(|index| is_far(journey, from, to, part, index))
        && (0..journey.follows()).all(|index| {
            let turn = journey.turn(index);
            let speed =
                growing(turn.guessed, || speed(journey, from, to, journey.turn_growth(index)));
            turn.change * part * speed <= most_turn(turn)
        })
}

/// By what factor something may be faster in a piece than its rates say. Where the rates are guesses there is none: the middle of the
/// piece tells more.
#[inline]
fn growing<T: Real>(guessed: bool, speed: impl FnOnce() -> T) -> T {
    if guessed { T::ONE } else { speed() }
}

/// By how much such an angle may change in a piece.
#[inline]
fn most_turn<T: Real>(turn: Turn<T>) -> T {
    T::from_f64(if turn.guessed { TURN_GUESSED } else { TURN })
}

/// Whether a watched loop stays away from zero, if those before it do. Between the ends the square of its sine is at least a quarter of the sum
/// of those at both ends. The middle of a piece is looked at, too, where that rests on a guess.
#[inline]
pub(super) fn is_far<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &J::Position,
    part: T,
    index: usize,
) -> bool {
    stays_away(journey, (from, to), part, (index, OF_GUESS))
}

/// The same where only the ends of a piece were looked at: a guess is taken for a bound.
pub(super) fn is_far_at_ends<T: Real, J: Journey<T>>(
    journey: &J,
    ends: (&J::Position, &J::Position),
    part: T,
    index: usize,
) -> bool {
    stays_away(journey, ends, part, (index, OF_BOUND))
}

#[inline]
fn stays_away<T: Real, J: Journey<T>>(
    journey: &J,
    (from, to): (&J::Position, &J::Position),
    part: T,
    (index, of_guess): (usize, f64),
) -> bool {
    let (squares, watch) = (squares(journey, from, to, index), journey.watch(index));
    let speed = growing(watch.guessed, || speed(journey, from, to, journey.growth(index)));
    let change = T::from_f64(if watch.guessed { of_guess } else { OF_BOUND }) * watch.change;
    squares > change * part * speed
        && (!watch.guessed || is_calm(journey, from, to, index))
        && (squares > T::from_f64(SEEN) || !stands(journey, [from, to], index))
}

/// Whether a loop is where rounding may hide on which side of a change point it is.
fn stands<T: Real, J: Journey<T>>(journey: &J, ends: [&J::Position; 2], index: usize) -> bool {
    let mut ends = ends.into_iter();
    ends.any(|at| journey.standing(at, index) != Standing::Away || is_zero(journey, at, index))
}

/// Whether a sine changes little, and not its sign.
pub(super) fn is_calm<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &J::Position,
    index: usize,
) -> bool {
    let (a, b) = (journey.sine(from, index), journey.sine(to, index));
    a * b > T::ZERO && (a * a - b * b).abs() <= T::from_f64(0.25) * (a * a + b * b)
}

#[inline]
fn squares<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &J::Position,
    index: usize,
) -> T {
    let (a, b) = (journey.sine(from, index), journey.sine(to, index));
    a * a + b * b
}

/// Returns the factor by which something changes faster between two positions than its rates say.
#[inline]
fn speed<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &J::Position,
    growth: impl Iterator<Item = Growth<T>>,
) -> T {
    let mut speed = T::ONE;
    for growth in growth {
        let times = match growth {
            Growth::Near(index) => T::from_f64(2.0) / squares(journey, from, to, index).sqrt(),
            Growth::Far(input, unit) => {
                let [from, to] = [from, to].map(|at| journey.input(at, input).abs());
                from.max(to) / unit
            }
        };
        speed = speed * times.max(T::ONE);
    }
    speed
}

/// A piece from here, no longer than this, that is likely to be passable; if none is, one that is short.
pub(super) fn likely<T: Real, J: Journey<T>>(journey: &J, from: &J::Position, longest: T) -> T {
    let mut length = longest;
    for index in 0..journey.watches() {
        let watch = journey.watch(index);
        let (speed, change) = (speed(journey, from, from, journey.growth(index)), watch.change);
        let growing = growing(watch.guessed, || speed);
        let passable =
            T::from_f64(LIKELY) * squares(journey, from, from, index) / (change * growing);
        let short = T::from_f64(LIKELY_SHORT) / (change * slow(speed, watch.guessed));
        length = lesser(length, passable.max(short));
    }
    for index in 0..journey.follows() {
        let turn = journey.turn(index);
        let speed =
            growing(turn.guessed, || speed(journey, from, from, journey.turn_growth(index)));
        let short = most_turn(turn) / (turn.change * slow(speed, turn.guessed));
        length = lesser(length, short);
    }
    length
}

/// The factor by which something is taken to be faster where pieces are short: limited for a bound, and at least so large for a guess.
fn slow<T: Real>(speed: T, guessed: bool) -> T {
    if guessed {
        T::from_f64(LEAST_GUESSED) * lesser(T::from_f64(LEAST_GUESSED), speed)
    } else {
        lesser(T::from_f64(MOST_GROWTH), speed)
    }
}

/// The lesser of two numbers: the first, if they are not ordered.
pub(super) fn lesser<T: Real>(a: T, b: T) -> T {
    if b < a { b } else { a }
}

/// Whether a piece from here is so short that a loop which may come to zero in it does so once at most.
pub(super) fn is_short<T: Real, J: Journey<T>>(journey: &J, from: &J::Position, part: T) -> bool {
    (0..journey.watches()).all(|index| {
        let speed = speed(journey, from, from, journey.growth(index));
        let watch = journey.watch(index);
        watch.change * part * slow(speed, watch.guessed) <= T::from_f64(PIECE)
    }) && (0..journey.follows()).all(|index| {
        let speed = speed(journey, from, from, journey.turn_growth(index));
        let turn = journey.turn(index);
        turn.change * part * slow(speed, turn.guessed) <= most_turn(turn)
    })
}
