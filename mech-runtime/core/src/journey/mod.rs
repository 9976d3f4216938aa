//! A move from where a mechanism is to where its motors are told to go, past the change points and dead points between.
//!
//! Where a loop in closed form is near none of them, one step is enough, however long it is. Else the move is divided into pieces. What is
//! watched is the sine of each such loop's transmission angle. Its square is smooth in the motors. It is zero at a dead point, beyond which the
//! loop does not close, and at a change point, beyond which it goes on. There velocity is continuous if the dyad goes over to its other side.

mod across;
mod departure;
mod event;
mod pace;
mod piece;
mod reach;
mod sine;

use crate::Real;
pub use pace::is_clear;
use pace::{TURN, first, is_foretold, is_passable, is_short, lesser, likely, most_stretch};
use piece::{forget_standing, note_arrived, travel_piece};

/// A loop that is watched. All numbers are for the whole move, from the start to the target.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Watch<T> {
    /// By how much the square of the sine may change in the whole move, at most, as long as it does not grow.
    pub change: T,
    /// Whether that is no bound but a guess, to be corrected by what the pieces show.
    pub guessed: bool,
    /// The behaviour where the sine is zero and the loop closes on both sides.
    pub at_zero: AtZero,
    /// Whether it is solved by iteration, which fails where the sine is zero.
    pub iterated: bool,
}

/// An angle that is followed over whole turns. The number is for the whole move, from the start to the target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn<T> {
    /// The most it may change in the whole move, as long as none of the causes of its growth acts.
    pub change: T,
    /// Whether that is no bound but a guess.
    pub guessed: bool,
}

/// A cause that makes something change faster than its rates say.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Growth<T> {
    /// So many times as fast as one is greater than the sine of an earlier watched loop.
    Near(usize),
    /// So many times as fast as this motor or param is farther from zero than the number, where it is farther.
    Far(usize, T),
}

/// The behaviour of a loop at a change point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum AtZero {
    /// It has none: it touches a dead point at most.
    Stay,
    /// It goes over to its other side.
    ChangeBranch,
    /// It is blocked.
    Stop,
}

/// Where a watched loop is beside a change point, seen in the sense in which the motors came. Rounding may hide it, so it is remembered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// Not beside one that it came to.
    Away,
    /// It came to one, and has not passed it.
    Arrived,
    /// It has passed one.
    Passed,
}

impl Standing {
    /// Reads a standing from its number in the state.
    #[must_use]
    pub fn of<T: Real>(number: T) -> Self {
        if number > T::ZERO {
            Self::Away
        } else if number < T::ZERO {
            Self::Passed
        } else {
            Self::Arrived
        }
    }

    /// The number of the state that says it: 1, 0 or -1.
    #[must_use]
    pub fn number<T: Real>(self) -> T {
        match self {
            Self::Away => T::ONE,
            Self::Arrived => T::ZERO,
            Self::Passed => T::ZERO - T::ONE,
        }
    }
}

/// A mechanism that moves from a start to a target.
pub trait Journey<T: Real> {
    /// Everything that is carried from one move to the next.
    type Position: Clone;
    /// Why it cannot be somewhere.
    type Stop;

    /// The position when this part of the move is done, starting from an earlier one.
    ///
    /// # Errors
    /// Why it cannot be there.
    fn at(&self, last: &Self::Position, part: T) -> Result<Self::Position, Self::Stop>;
    /// Returns the number of watched loops.
    fn watches(&self) -> usize;
    /// A loop that is watched.
    fn watch(&self, index: usize) -> Watch<T>;
    /// Returns the causes that make the square of its sine change faster.
    fn growth(&self, index: usize) -> impl Iterator<Item = Growth<T>>;
    /// Returns the number of angles that are followed over whole turns.
    fn follows(&self) -> usize;
    /// Such an angle.
    fn turn(&self, index: usize) -> Turn<T>;
    /// Its value, in radians, whole turns included.
    fn angle(&self, position: &Self::Position, index: usize) -> T;
    /// Returns the causes that make such an angle change faster.
    fn turn_growth(&self, index: usize) -> impl Iterator<Item = Growth<T>>;
    /// The value of a motor or param.
    fn input(&self, position: &Self::Position, input: usize) -> T;
    /// The sine of a watched loop, its sign the side on which its dyad lies.
    fn sine(&self, position: &Self::Position, index: usize) -> T;
    /// The square of a sine of this loop below which rounding hides its sign.
    fn rounding_square(&self, position: &Self::Position, index: usize) -> T;
    /// Puts the dyad of a watched loop on its other side.
    fn turn_over(&self, position: &mut Self::Position, index: usize);
    /// Where a watched loop is, as far as its change points are concerned.
    fn standing(&self, position: &Self::Position, index: usize) -> Standing;
    /// Notes where it is.
    fn set_standing(&self, position: &mut Self::Position, index: usize, standing: Standing);
    /// Where everything would be as far beyond a position as another is before it, if it went straight on: an iteration begins there.
    fn beyond(&self, before: &Self::Position, at: &Self::Position) -> Self::Position;
    /// Positive if the motors that a watched loop follows go on in the sense in which they came, negative if they go back.
    fn sense(&self, position: &Self::Position, index: usize) -> T;
    /// Notes the sense in which the motors go.
    fn note_motion_signs(&self, position: &mut Self::Position);
    /// The stop that says that a move is too long for one piece.
    fn too_far(&self) -> Self::Stop;
    /// Whether a stop says of this watched loop that it does not close.
    fn is_open(&self, stop: &Self::Stop, index: usize) -> bool;
    /// Why it stops at a change point that it may not pass.
    fn stopped_at(&self, index: usize) -> Self::Stop;
    /// The least number of pieces of the move, where nothing tells how far coupled loops may leap.
    fn pieces(&self) -> T {
        T::ONE
    }
    /// Whether the move may be one piece.
    fn is_one_piece(&self) -> bool {
        self.pieces() <= T::ONE
    }
    /// Whether a step that fails may work in smaller ones: where loops are solved by iteration.
    fn subdivides(&self) -> bool;
}

/// Where a journey ended before its target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Halt<P, S, T> {
    /// The position it reached.
    pub position: P,
    /// The part of the move that was done.
    pub part: T,
    /// Why it went no farther.
    pub stop: S,
}

/// Iterations that fail from afar may work from near. So a move of iterated loops that stopped goes on from there: so often at most, and
/// only while it gains this part.
const MOST_STARTS: u32 = 16;
const GAIN: f64 = 1e-9;
/// A move of more pieces than this is refused: it is a mistake, or would take longer than anybody waits.
const MOST_PIECES: u32 = 65_536;
/// So often, on average, a piece may be halved.
const HALVED: u32 = 4;
/// So often, at most, parts of a move are tried until one ends where it should.
const MOST_TRIES: u32 = 512;

/// The greatest part that is possible of a move whose target cannot be reached, and the least that is not, a rounding beyond it. Nothing is
/// watched there and a position depends on the motors alone. It is the same journey, but no position has to be stored. `stops` says whether a
/// part of the move is impossible.
pub fn bisect<T: Real>(stops: impl Fn(T) -> bool) -> (T, T) {
    let (mut end, mut blocked) = (T::ZERO, T::ONE);
    for _ in 0..MOST_TRIES {
        let middle = end + (blocked - end) * T::HALF;
        if !(middle > end && middle < blocked) {
            break;
        }
        if stops(middle) {
            blocked = middle;
        } else {
            end = middle;
        }
    }
    (end, blocked)
}

/// Whether even the longest pieces would be too many.
fn is_endless<T: Real, J: Journey<T>>(journey: &J) -> bool {
    let most = T::from_f64(f64::from(MOST_PIECES));
    let turn = T::from_f64(TURN);
    // No sine is greater than one, so no piece in which one may come to zero can be passed in one step.
    !(journey.pieces() <= most
        && (0..journey.watches()).all(|index| journey.watch(index).change <= most)
        && (0..journey.follows()).all(|index| journey.turn(index).change / turn <= most))
}

/// Moves to the target, past the change points before it. A move that even the longest pieces would divide too often is not begun.
///
/// # Errors
/// The position that it reached, and why it went no farther.
pub fn travel<T: Real, J: Journey<T>>(
    journey: &J,
    start: &J::Position,
) -> Result<J::Position, Halt<J::Position, J::Stop, T>> {
    if is_endless(journey) {
        return Err(too_far(journey, start.clone(), T::ZERO));
    }
    let (mut position, mut done) = (start.clone(), T::ZERO);
    for _ in 1..MOST_STARTS {
        match travel_on(journey, position, done) {
            Err(halt) if journey.subdivides() && halt.part > done + T::from_f64(GAIN) => {
                (position, done) = (halt.position, halt.part);
            }
            gone => return gone,
        }
    }
    travel_on(journey, position, done)
}

/// Moves on to the target from where a part of the move is done. Its pieces are long where nothing can stop them, and short where something may.
fn travel_on<T: Real, J: Journey<T>>(
    journey: &J,
    mut position: J::Position,
    mut done: T,
) -> Result<J::Position, Halt<J::Position, J::Stop, T>> {
    let most = T::ONE / journey.pieces();
    let (mut length, stretch) = (first(journey, most), most_stretch(journey));
    for _ in 0..HALVED * MOST_PIECES {
        length = likely(journey, &position, length);
        let target = done + length;
        // The last piece may be a little longer rather than leave a splinter.
        let target = if target + length * T::HALF > T::ONE { T::ONE } else { target };
        let part = target - done;
        // A move so long that a piece of it is lost in rounding.
        if target <= done {
            break;
        }
        if let Ok(mut to) = journey.at(&position, target)
            && is_passable(journey, &position, &to, part)
            && is_foretold(journey, (&position, done), (&to, target))
        {
            forget_standing(journey, &mut to);
            if target >= T::ONE {
                note_arrived(journey, &position, &mut to);
            }
            journey.note_motion_signs(&mut to);
            position = to;
            done = target;
        } else if is_short(journey, &position, part) {
            let gone = travel_piece(journey, position, done, target);
            (position, done) = (gone.to, gone.end);
            if let Some(stop) = gone.stop {
                return Err(Halt { position, part: done, stop });
            }
        } else {
            length = part * T::HALF;
            continue;
        }
        if done >= T::ONE {
            return Ok(position);
        }
        length = lesser(part * stretch, most);
    }
    Err(too_far(journey, position, done))
}

fn too_far<T: Real, J: Journey<T>>(
    journey: &J,
    position: J::Position,
    part: T,
) -> Halt<J::Position, J::Stop, T> {
    Halt { position, part, stop: journey.too_far() }
}
