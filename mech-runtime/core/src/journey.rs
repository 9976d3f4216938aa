//! A move from where a mechanism is to where its motors are told to go, past the change points and dead points between.
//!
//! Where a loop in closed form is near none of them, one step is enough, however long it is. Else the way is gone in pieces.
//! What is watched is the sine of each such loop's transmission angle: its square is smooth in the motors and zero at a
//! dead point, beyond which the loop does not close, and at a change point, beyond which it goes on. There velocity is
//! continuous if the dyad goes over to its other side.

use crate::Real;

/// A loop that is watched. All numbers are for the way from the start to the target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watch<T> {
    /// By how much the square of the sine may change on the whole way, at most, as long as it does not grow.
    pub change: T,
    /// Whether that is no bound but a guess, to be set right by what is seen on the way.
    pub guessed: bool,
    /// What happens where the sine is zero and the loop closes on both sides.
    pub at_zero: AtZero,
}

/// What makes something change faster than its rates say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Growth<T> {
    /// So many times as fast as one is greater than the sine of an earlier watched loop.
    Near(usize),
    /// So many times as fast as this motor or param is farther from zero than this, if it is.
    Far(usize, T),
}

/// What a loop does at a change point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtZero {
    /// It has none: it touches a dead point at most.
    Stay,
    /// It goes over to its other side.
    GoOver,
    /// It is blocked.
    Stop,
}

/// A mechanism on its way from a start to a target.
pub trait Journey<T: Real> {
    /// Everything that is carried from one move to the next.
    type Position: Clone;
    /// Why it cannot be somewhere.
    type Stop;

    /// The position when this part of the way is done, from a position on the way.
    ///
    /// # Errors
    /// Why it cannot be there.
    fn at(&self, last: &Self::Position, part: T) -> Result<Self::Position, Self::Stop>;
    /// How many loops are watched.
    fn watches(&self) -> usize;
    /// A loop that is watched.
    fn watch(&self, index: usize) -> Watch<T>;
    /// What makes the square of its sine change faster.
    fn growth(&self, index: usize) -> impl Iterator<Item = Growth<T>>;
    /// How many angles are followed over whole turns.
    fn follows(&self) -> usize;
    /// By how much such an angle may change on the whole way, at most, as long as that does not grow.
    fn turn(&self, index: usize) -> T;
    /// What makes such an angle change faster.
    fn turn_growth(&self, index: usize) -> impl Iterator<Item = Growth<T>>;
    /// The value of a motor or param.
    fn input(&self, position: &Self::Position, input: usize) -> T;
    /// The sine of a watched loop, its sign the side on which its dyad lies.
    fn sine(&self, position: &Self::Position, index: usize) -> T;
    /// The square of a sine of this loop below which rounding hides its sign.
    fn tiny_square(&self, position: &Self::Position, index: usize) -> T;
    /// Puts the dyad of a watched loop on its other side.
    fn turn_over(&self, position: &mut Self::Position, index: usize);
    /// Whether the motors that a watched loop follows go on in the sense in which they came.
    fn goes_on(&self, position: &Self::Position, index: usize) -> bool;
    /// Notes the sense in which the motors go.
    fn note_sense(&self, position: &mut Self::Position);
    /// Why it does not go so far at once.
    fn too_far(&self) -> Self::Stop;
    /// Why it stops at a change point that it may not pass.
    fn stopped_at(&self, index: usize) -> Self::Stop;
    /// In how many pieces the way has to be gone at least, where nothing tells how far coupled loops may leap.
    fn pieces(&self) -> T {
        T::ONE
    }
    /// Whether the way may be gone in one piece.
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
    /// The part of the way that was done.
    pub part: T,
    /// Why it went no farther.
    pub stop: S,
}

/// In a piece in which a sine may come to zero its square changes by no more than this: zero is there then, or near.
const PIECE: f64 = 0.02;
/// A piece that is likely to be passed takes this part of the squares of its sines at its start.
const LIKELY: f64 = 0.4;
/// A little less than a short piece, whatever rounding does.
const LIKELY_SHORT: f64 = 0.99 * PIECE;
/// In one piece an angle that is followed over whole turns changes by no more than this: more than half a turn would be lost.
const TURN: f64 = 2.5;
/// Near their zeros earlier loops make later ones faster without end: pieces are no smaller than for so many times as fast.
const MOST_GROWTH: f64 = 16.0;
/// Where loops are solved by iteration, a way that was stopped is gone on with from there, so many times at most, as long as at
/// least this part of it is gained: what failed from afar may work from near.
const MOST_STARTS: u32 = 16;
const GAIN: f64 = 1e-9;
/// More pieces than this are not gone at once: they are a mistake, or would take longer than anybody waits.
const MOST_PIECES: u32 = 65_536;
/// So often at most is a piece tried that does not end where it should.
const MOST_TRIES: u32 = 512;
/// Beside a dead point a place is looked for where nothing closes, which may be narrower than a piece by so many halvings.
const NARROW: u32 = 20;
/// Each halving gives a digit of a binary fraction: no float has more.
const HALVINGS: u32 = 64;

/// Whether nothing can be in the way between two positions that are this part of the way apart: no watched loop comes to zero, and
/// no angle loses a turn.
#[inline]
pub fn is_clear<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &J::Position,
    part: T,
) -> bool {
    journey.is_one_piece() && is_passable(journey, from, to, part)
}

#[inline]
fn is_passable<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &J::Position,
    part: T,
) -> bool {
    let most = T::from_f64(TURN);
    (0..journey.watches()).all(|index| is_far(journey, from, to, part, index))
        && (0..journey.follows()).all(|index| {
            let speed = speed(journey, from, to, journey.turn_growth(index));
            journey.turn(index) * part * speed <= most
        })
}

/// Whether a watched loop stays away from zero, if those before it do: of the squares of its sine at both ends it has at least a
/// quarter of their sum between them.
#[inline]
fn is_far<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &J::Position,
    part: T,
    index: usize,
) -> bool {
    let speed = speed(journey, from, to, journey.growth(index));
    let (squares, watch) = (squares(journey, from, to, index), journey.watch(index));
    squares > T::from_f64(2.0) * watch.change * part * speed
        && (!watch.guessed || is_calm(journey, from, to, (index, squares)))
}

/// Whether a sine changes little.
fn is_calm<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &J::Position,
    (index, squares): (usize, T),
) -> bool {
    let (a, b) = (journey.sine(from, index), journey.sine(to, index));
    (a * a - b * b).abs() <= T::from_f64(0.25) * squares
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

/// How many times as fast something changes between two positions as its rates say.
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
fn likely<T: Real, J: Journey<T>>(journey: &J, from: &J::Position, longest: T) -> T {
    let mut length = longest;
    for index in 0..journey.watches() {
        let speed = speed(journey, from, from, journey.growth(index));
        let change = journey.watch(index).change;
        let passable = T::from_f64(LIKELY) * squares(journey, from, from, index) / (change * speed);
        let short = T::from_f64(LIKELY_SHORT) / (change * slow(speed));
        length = lesser(length, passable.max(short));
    }
    for index in 0..journey.follows() {
        let speed = speed(journey, from, from, journey.turn_growth(index));
        let short = T::from_f64(TURN) / (journey.turn(index) * slow(speed));
        length = lesser(length, short);
    }
    length
}

/// So many times as fast at most something is taken to be where pieces are short.
fn slow<T: Real>(speed: T) -> T {
    lesser(T::from_f64(MOST_GROWTH), speed)
}

/// The lesser of two numbers: the first, if they are not ordered.
fn lesser<T: Real>(a: T, b: T) -> T {
    if b < a { b } else { a }
}

/// Whether a piece from here is so short that a loop which may come to zero in it does so once at most.
fn is_short<T: Real, J: Journey<T>>(journey: &J, from: &J::Position, part: T) -> bool {
    let faster = |change: T, growth: T| change * part * slow(growth);
    (0..journey.watches()).all(|index| {
        let speed = speed(journey, from, from, journey.growth(index));
        faster(journey.watch(index).change, speed) <= T::from_f64(PIECE)
    }) && (0..journey.follows()).all(|index| {
        let speed = speed(journey, from, from, journey.turn_growth(index));
        faster(journey.turn(index), speed) <= T::from_f64(TURN)
    })
}

/// The part that can be gone of a way to a target that cannot be reached, and one a rounding beyond it that cannot be, where nothing
/// is watched and a position depends on the motors alone: the same journey, but none of the positions on the way needs to be kept.
/// `stops` tells whether it cannot be at a part of the way.
pub fn halved<T: Real>(stops: impl Fn(T) -> bool) -> (T, T) {
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
        && (0..journey.follows()).all(|index| journey.turn(index) / turn <= most))
}

/// Goes to the target, past whatever is on the way. A way on which even the longest pieces would be too many is not begun.
///
/// # Errors
/// How far it came and why it went no farther.
pub fn go<T: Real, J: Journey<T>>(
    journey: &J,
    start: &J::Position,
) -> Result<J::Position, Halt<J::Position, J::Stop, T>> {
    if is_endless(journey) {
        return Err(too_far(journey, start.clone(), T::ZERO));
    }
    let (mut position, mut done) = (start.clone(), T::ZERO);
    for _ in 1..MOST_STARTS {
        match go_on(journey, position, done) {
            Err(halt) if journey.subdivides() && halt.part > done + T::from_f64(GAIN) => {
                (position, done) = (halt.position, halt.part);
            }
            gone => return gone,
        }
    }
    go_on(journey, position, done)
}

/// Goes on to the target from where a part of the way is done: in pieces that are as long as nothing can be in the way of them, and
/// short where something may be.
fn go_on<T: Real, J: Journey<T>>(
    journey: &J,
    mut position: J::Position,
    mut done: T,
) -> Result<J::Position, Halt<J::Position, J::Stop, T>> {
    let most = T::ONE / journey.pieces();
    let two = T::from_f64(2.0);
    let mut length = most;
    for _ in 0..MOST_PIECES {
        length = likely(journey, &position, length);
        let target = done + length;
        // The last piece may be a little longer rather than leave a splinter.
        let target = if target + length * T::HALF > T::ONE {
            T::ONE
        } else {
            target
        };
        let part = target - done;
        // A way so long that a piece of it is lost in rounding.
        if target <= done {
            break;
        }
        if let Ok(mut to) = journey.at(&position, target)
            && is_passable(journey, &position, &to, part)
        {
            journey.note_sense(&mut to);
            position = to;
        } else if is_short(journey, &position, part) {
            position = piece(journey, position, done, target)?;
        } else {
            length = part * T::HALF;
            continue;
        }
        if target >= T::ONE {
            return Ok(position);
        }
        done = target;
        length = if part * two < most { part * two } else { most };
    }
    Err(too_far(journey, position, done))
}

fn too_far<T: Real, J: Journey<T>>(
    journey: &J,
    position: J::Position,
    part: T,
) -> Halt<J::Position, J::Stop, T> {
    Halt {
        position,
        part,
        stop: journey.too_far(),
    }
}

/// Where a piece ends: at its target, or before it for a reason.
struct Reach<P, S, T> {
    to: P,
    end: T,
    stop: Option<S>,
}

/// Goes a piece that is short enough for one change point of a loop at most.
fn piece<T: Real, J: Journey<T>>(
    journey: &J,
    mut from: J::Position,
    mut done: T,
    target: T,
) -> Result<J::Position, Halt<J::Position, J::Stop, T>> {
    let mut aim = target;
    // Each round passes a change point, or finds a dead point before its aim.
    for _ in 0..=8 * journey.watches() {
        let mut reach = reach(journey, &from, done, aim);
        match leave(journey, &mut from, &reach.to) {
            Leaving::Stopped(index) => {
                return Err(Halt {
                    position: from,
                    part: done,
                    stop: journey.stopped_at(index),
                });
            }
            Leaving::Other => reach = self::reach(journey, &from, done, aim),
            Leaving::Same => {}
        }
        match first_event(journey, &from, done, &reach) {
            Event::None if reach.stop.is_none() && reach.end < target => {
                // What was blocked in a step that long is not in this one: on from here.
                (from, done, aim) = (reach.to, reach.end, target);
            }
            Event::None if let Some(other) = over(journey, &reach, aim) => {
                // On the side it came from something else does not close: it is the other side that goes on.
                (from, done, aim) = (other, reach.end, target);
            }
            Event::None => {
                settle(journey, &from, done, &mut reach);
                note_sense(journey, &from, &mut reach.to);
                return match reach.stop {
                    None => Ok(reach.to),
                    Some(stop) => Err(Halt {
                        position: reach.to,
                        part: reach.end,
                        stop,
                    }),
                };
            }
            Event::Blocked(part) => aim = part,
            Event::Zero(part, index) => {
                if let Ok(mut at_zero) = journey.at(&from, part) {
                    journey.note_sense(&mut at_zero);
                    from = at_zero;
                    done = part;
                }
                if journey.watch(index).at_zero == AtZero::Stop {
                    return Err(Halt {
                        position: from,
                        part: done,
                        stop: journey.stopped_at(index),
                    });
                }
            }
        }
    }
    journey.at(&from, target).map_err(|stop| Halt {
        position: from,
        part: done,
        stop,
    })
}

fn is_zero<T: Real, J: Journey<T>>(journey: &J, position: &J::Position, index: usize) -> bool {
    let sine = journey.sine(position, index);
    sine * sine <= journey.tiny_square(position, index)
}

/// On which side a change point is left.
enum Leaving {
    /// On the side it was arrived on, or there was none.
    Same,
    /// On the other side.
    Other,
    /// It may not be left in this sense.
    Stopped(usize),
}

/// Where a loop stands at its change point, the sense in which it goes decides on which side it leaves.
fn leave<T: Real, J: Journey<T>>(journey: &J, from: &mut J::Position, to: &J::Position) -> Leaving {
    let mut leaving = Leaving::Same;
    for index in 0..journey.watches() {
        let leaves = is_zero(journey, from, index) && !is_zero(journey, to, index);
        if leaves && journey.goes_on(from, index) {
            match journey.watch(index).at_zero {
                AtZero::Stay => {}
                AtZero::Stop => return Leaving::Stopped(index),
                AtZero::GoOver => {
                    journey.turn_over(from, index);
                    leaving = Leaving::Other;
                }
            }
        }
    }
    leaving
}

/// Where a step was stopped with a loop at its change point: the same place on the loop's other side, if that goes on.
fn over<T: Real, J: Journey<T>>(
    journey: &J,
    reach: &Reach<J::Position, J::Stop, T>,
    aim: T,
) -> Option<J::Position> {
    reach.stop.as_ref()?;
    (0..journey.watches()).find_map(|index| {
        let stands = journey.watch(index).at_zero == AtZero::GoOver
            && is_near_zero(journey, &reach.to, index);
        if !stands {
            return None;
        }
        let mut other = reach.to.clone();
        journey.turn_over(&mut other, index);
        let goes_on = journey.at(&other, aim).is_ok();
        goes_on.then_some(other)
    })
}

/// Whether a sine is so near zero that the side of its loop shows in nothing that rounding leaves.
fn is_near_zero<T: Real, J: Journey<T>>(journey: &J, position: &J::Position, index: usize) -> bool {
    let sine = journey.sine(position, index);
    sine * sine <= T::from_f64(T::EPSILON).sqrt()
}

/// Where a change point is arrived at in which pins meet, the directions of the links between them are those of the position
/// before: let it be very near.
fn settle<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    done: T,
    reach: &mut Reach<J::Position, J::Stop, T>,
) {
    let arrives = |index| {
        journey.watch(index).at_zero == AtZero::GoOver
            && is_zero(journey, &reach.to, index)
            && !is_zero(journey, from, index)
    };
    if (0..journey.watches()).any(arrives) {
        let before =
            reach.end - (reach.end - done) * T::from_f64(T::EPSILON).sqrt() * T::from_f64(64.0);
        if let Ok(near) = journey.at(from, before)
            && let Ok(to) = journey.at(&near, reach.end)
        {
            reach.to = to;
        }
    }
}

/// The sense in which the motors go is that in which a change point was reached, as long as it is not left.
fn note_sense<T: Real, J: Journey<T>>(journey: &J, from: &J::Position, to: &mut J::Position) {
    let rests = (0..journey.watches())
        .any(|index| is_zero(journey, from, index) && is_zero(journey, to, index));
    if !rests {
        journey.note_sense(to);
    }
}

/// Goes as far as it can in one step; by iteration, in as many as it takes.
fn reach<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    done: T,
    aim: T,
) -> Reach<J::Position, J::Stop, T> {
    let mut stop = match journey.at(from, aim) {
        Ok(to) => {
            return Reach {
                to,
                end: aim,
                stop: None,
            };
        }
        Err(stop) => stop,
    };
    let (mut to, mut end, mut blocked) = (from.clone(), done, aim);
    for _ in 0..MOST_TRIES {
        let middle = end + (blocked - end) * T::HALF;
        if !(middle > end && middle < blocked) {
            break;
        }
        match journey.at(&to, middle) {
            Ok(position) => {
                // An iteration that failed to come far from a place may come there from a nearer one.
                if journey.subdivides() {
                    let far = end + (middle - end) * T::from_f64(4.0);
                    blocked = if far < aim { far } else { aim };
                }
                (to, end) = (position, middle);
                if blocked >= aim
                    && journey.subdivides()
                    && let Ok(position) = journey.at(&to, aim)
                {
                    return Reach {
                        to: position,
                        end: aim,
                        stop: None,
                    };
                }
            }
            Err(reason) => (stop, blocked) = (reason, middle),
        }
    }
    Reach {
        to,
        end,
        stop: Some(stop),
    }
}

/// What happens to a watched loop on the way.
enum Event<T> {
    None,
    /// A loop passes its change point.
    Zero(T, usize),
    /// Something does not close there.
    Blocked(T),
}

fn first_event<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    done: T,
    reach: &Reach<J::Position, J::Stop, T>,
) -> Event<T> {
    let mut first = Event::None;
    for index in 0..journey.watches() {
        if is_far(journey, from, &reach.to, reach.end - done, index) {
            continue;
        }
        let event = least_sine(journey, from, done, reach, index);
        let sooner = match (&event, &first) {
            (Event::None, _) => false,
            (_, Event::None) => true,
            (Event::Zero(a, _) | Event::Blocked(a), Event::Zero(b, _) | Event::Blocked(b)) => a < b,
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
        // An iteration that fails there tells nothing.
        return if journey.subdivides() {
            Event::None
        } else {
            blocked_at_ends(journey, from, done, reach.end)
        };
    }
    if (journey.sine(from, index) > T::ZERO) != (journey.sine(&reach.to, index) > T::ZERO) {
        return change_of_sign(journey, from, (done, reach.end), index);
    }
    // If the root goes straight through zero, it does so here.
    let (left, right) = (a.1.sqrt(), b.1.sqrt());
    let mut at = a.0 + (b.0 - a.0) * (left / (left + right));
    let mut least: Option<(T, T)> = None;
    for _ in 0..HALVINGS {
        if !(at > a.0 && at < b.0) {
            return Event::None;
        }
        let (value, zero) = match journey.at(from, at) {
            Ok(position) => (square(&position), is_zero(journey, &position, index)),
            Err(_) => return Event::Blocked(at),
        };
        if zero {
            return match watch.at_zero {
                AtZero::Stay => Event::None,
                AtZero::GoOver | AtZero::Stop => Event::Zero(at, index),
            };
        }
        let found = (at, value);
        least = match least {
            // Falling towards an end: the least is there.
            None if value >= a.1 || value >= b.1 => return Event::None,
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
        at = vertex(a, middle, b);
    }
    Event::None
}

/// Looks for a place beside the ends of a piece where something does not close, however narrow it is.
fn blocked_at_ends<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    done: T,
    end: T,
) -> Event<T> {
    let mut way = end - done;
    for _ in 0..NARROW {
        way = way * T::HALF;
        for part in [done + way, end - way] {
            if part > done && part < end && journey.at(from, part).is_err() {
                return Event::Blocked(part);
            }
        }
    }
    Event::None
}

/// Looks for the place where a sine changes its sign. Only two lines that cut each other do so by themselves: at the zero they
/// lie on each other, or they do not cut each other at all.
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
                    AtZero::GoOver | AtZero::Stop => Event::Zero(middle, index),
                };
            }
            Ok(position) if (journey.sine(&position, index) > T::ZERO) == positive => low = middle,
            Ok(_) => high = middle,
        }
    }
    Event::Blocked(high)
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
        let side = if left > right {
            T::ZERO - nearest
        } else {
            nearest
        };
        return m.0 + side;
    }
    at
}
