//! Past change points without a position between. They are those of loops that are solved by iteration, which fails there. Or they are those of
//! several loops, so near each other that rounding hides which comes first.

use super::event::Event;
use super::pace::lesser;
use super::reach::{Reach, position_at, reach};
use super::sine::{NEAREST, distance, has_passed, is_near, is_stepped_over, is_zero, pass};
use super::{AtZero, Journey};
use crate::Real;

/// The distances beyond a zero at which an iteration begins, in fourth roots of the precision: the second is for where the first fails.
/// There curvature and rounding are both small beside the distance from the other branch.
const OFFSETS: [f64; 2] = [8.0, 32.0];
/// The same distances for loops in closed form, whose positions are exact to rounding.
const TOGETHER: [f64; 3] = [0.25, NEAREST, 2.0];
/// Where the last zero is very near, offsets are this part of the distance from it. So a line that begins three offsets before the next
/// zero begins behind the last one.
const SINCE: f64 = 0.25;

/// The first step away from a zero changes the sine by this part of it at most, as an iteration does not reach farther there. Each next
/// step is so much longer, or shorter if it fails.
const FIRST: f64 = 0.25;
const LONGER: f64 = 1.25;
const SHORTER: f64 = 0.25;
const MOST_STEPS: u32 = 256;
/// A sine that falls by this part in such a step is on its way to zero.
const FALLS: f64 = 0.0625;
/// If its square falls by less than this part of what rounding hides, that tells nothing.
const NOISE: f64 = 0.125;

/// An iterated loop that comes to a possible change point.
pub(super) struct Meeting<P, T> {
    pub(super) index: usize,
    /// A position before the change point, and the part of the move that is done there.
    pub(super) before: (P, T),
    /// A position beyond the change point, if one was found on the straight way.
    pub(super) beyond: Option<Beyond<P, T>>,
}

/// A sine may differ from what a straight line foretells by this part of that.
const OFF: f64 = 0.25;

/// Halfway to a zero, a sine that goes straight through it has halved. One that has become smaller by more than this factor touches zero
/// and turns back.
const TOUCHES: f64 = 2.5;
/// A touch is looked for from where the square of the sine is so many times what rounding hides. The square may change by the second
/// number at most from there to the zero.
const TOUCH: f64 = 1024.0;
const LONGEST: f64 = 0.25;

/// A position beyond.
pub(super) struct Beyond<P, T> {
    pub(super) to: P,
    /// The part of the move that is done there.
    pub(super) end: T,
    /// Whether a loop is on its other side that may not go over.
    pub(super) stops: bool,
}

/// Finds the meeting of an iterated loop with a possible change point: its iteration failed, or its sine was found to be zero.
pub(super) fn meeting<T: Real, J: Journey<T>>(
    journey: &J,
    (from, done): (&J::Position, T),
    reached: &Reach<J::Position, J::Stop, T>,
    event: &Event<T>,
) -> Option<Meeting<J::Position, T>> {
    let (part, index) = match *event {
        Event::None if reached.stop.is_some() => {
            let mut all = 0..journey.watches();
            (reached.end, all.find(|index| is_near(journey, &reached.to, *index))?)
        }
        Event::Near(part, index) => (part, index),
        _ => return None,
    };
    if is_near(journey, from, index)
        && let Some(away) = away(journey, (from, done), index)
    {
        return Some(Meeting { index, before: (from.clone(), done), beyond: Some(away) });
    }
    // Not so near that rounding tells more than the position.
    let start = part - distance(journey, index, OFFSETS[0]) * T::HALF;
    let before = if start <= done {
        (from.clone(), done)
    } else {
        let stand = reach(journey, from, done, start);
        (stand.to, stand.end)
    };
    let beyond = beyond_change_point(journey, (from, done), (&before.0, before.1), index);
    // Beyond a dead point there is nothing.
    (beyond.is_some() || reached.stop.is_none()).then_some(Meeting { index, before, beyond })
}

/// The position a little farther, from one before a zero of a sine: that which everything goes straight on to.
fn beyond_change_point<T: Real, J: Journey<T>>(
    journey: &J,
    from: (&J::Position, T),
    (position, part): (&J::Position, T),
    index: usize,
) -> Option<Beyond<J::Position, T>> {
    OFFSETS.into_iter().find_map(|times| {
        let offset = lesser(distance(journey, index, times), T::ONE - part);
        let last = back(journey, (position, part), (offset, index))?;
        let before = back(journey, (&last, part - offset), (offset * T::from_f64(2.0), index))?;
        let line = Line {
            before: (&before, part - offset * T::from_f64(3.0)),
            last: (&last, part - offset),
        };
        line.beyond(journey, from, part + offset, index)
    })
}

/// The position beyond a zero of a loop in closed form beside which others come to theirs: that which everything goes straight on to.
pub(super) fn beyond_cluster<T: Real, J: Journey<T>>(
    journey: &J,
    (from, done): (&J::Position, T),
    (part, index): (T, usize),
) -> Option<Beyond<J::Position, T>> {
    // Where the one before was passed very near, a line that begins behind that one.
    let since = (part - done) * T::from_f64(SINCE);
    let offsets = TOGETHER.map(|times| distance(journey, index, times));
    let nearer = Some(since).filter(|since| *since > T::ZERO && *since < offsets[1]);
    offsets.into_iter().chain(nearer).find_map(|offset| {
        let [begun, last_part] = [3.0, 1.0].map(|offsets| part - offset * T::from_f64(offsets));
        let before = position_at(journey, from, done, begun)?;
        let last = position_at(journey, &before, begun, last_part)?;
        let line = Line { before: (&before, begun), last: (&last, last_part) };
        let end = lesser(part + offset, T::ONE);
        // A line that began before a zero that was passed may not come to this one.
        line.crosses(journey, index, end)
            .then(|| line.beyond(journey, (from, done), end, index))
            .flatten()
    })
}

/// Whether the sine of a loop in closed form only touches a zero, and how far from it that was seen. Halfway to such a zero a sine is a fourth
/// of what it was, not a half.
fn touch<T: Real, J: Journey<T>>(
    journey: &J,
    (from, done): (&J::Position, T),
    (part, index): (T, usize),
) -> Option<Touch<J::Position, T>> {
    if journey.watch(index).at_zero != AtZero::ChangeBranch || is_stepped_over(journey, index) {
        return None;
    }
    let far_enough = T::from_f64(TOUCH) * journey.rounding_square(from, index);
    let longest = T::from_f64(LONGEST) / journey.watch(index).change;
    let mut offset = distance(journey, index, 1.0);
    // Behind the start others have change points that they have passed: nothing is there as it was.
    let any_passed = (0..journey.watches()).any(|one| has_passed(journey, from, one));
    let before = loop {
        if any_passed && part - offset < done {
            return None;
        }
        let before = position_at(journey, from, done, part - offset)?;
        let sine = journey.sine(&before, index);
        if sine * sine >= far_enough {
            break before;
        }
        offset = offset * T::from_f64(2.0);
        if offset > longest {
            return None;
        }
    };
    let halfway = position_at(journey, &before, part - offset, part - offset * T::HALF)?;
    let [far, near] = [&before, &halfway].map(|at| journey.sine(at, index).abs());
    (far > T::from_f64(TOUCHES) * near).then_some(Touch { halfway, offset })
}

/// A sine that touches its zero.
struct Touch<P, T> {
    /// The position halfway between the zero and where it was seen.
    halfway: P,
    /// The distance before the zero at which it was seen.
    offset: T,
}

/// Whether a loop stands at a zero that its sine only touched.
pub(super) fn touches<T: Real, J: Journey<T>>(
    journey: &J,
    (from, done): (&J::Position, T),
    index: usize,
) -> bool {
    touch(journey, (from, done), (done, index)).is_some()
}

/// The position beyond a zero that a sine only touches: its loop stays on its side.
pub(super) fn beyond_touch<T: Real, J: Journey<T>>(
    journey: &J,
    (from, done): (&J::Position, T),
    (part, index): (T, usize),
) -> Option<Beyond<J::Position, T>> {
    let Touch { halfway, offset } = touch(journey, (from, done), (part, index))?;
    let end = lesser(part + offset, T::ONE);
    let to = position_at(journey, &halfway, part - offset * T::HALF, end)?;
    let is_clear = (0..journey.watches()).all(|one| !is_zero(journey, &to, one));
    is_clear.then_some(Beyond { to, end, stops: false })
}

/// Two positions before a zero, and the parts of the move that are done there.
struct Line<'a, P, T> {
    before: (&'a P, T),
    last: (&'a P, T),
}

impl<P: Clone, T: Real> Line<'_, P, T> {
    /// The sine of a loop where everything goes straight on to.
    fn sine<J: Journey<T, Position = P>>(&self, journey: &J, index: usize, end: T) -> T {
        let ((before, begun), (last, part)) = (self.before, self.last);
        let [a, b] = [before, last].map(|position| journey.sine(position, index));
        b + (b - a) * ((end - part) / (part - begun))
    }

    /// Whether the sine of a loop changes its sign on the way there.
    fn crosses<J: Journey<T, Position = P>>(&self, journey: &J, index: usize, end: T) -> bool {
        self.sine(journey, index, end) * journey.sine(self.last.0, index) < T::ZERO
    }

    /// Whether a sine is where everything goes straight on to.
    fn meets<J: Journey<T, Position = P>>(
        &self,
        journey: &J,
        (position, part): (&P, T),
        index: usize,
    ) -> bool {
        // On another branch the sine is another.
        let (sine, ahead) = (journey.sine(position, index), self.sine(journey, index, part));
        (sine - ahead).abs() <= T::from_f64(OFF) * ahead.abs()
    }

    /// Whether a position behind its first is on it: else a zero that was passed lies between.
    fn leads_through<J: Journey<T, Position = P>>(&self, journey: &J, at: (&P, T)) -> bool {
        let passes = |index: &usize| journey.watch(*index).at_zero != AtZero::Stay;
        let mut watched = (0..journey.watches()).filter(passes);
        at.1 <= self.before.1 || watched.all(|index| self.meets(journey, at, index))
    }

    /// The position at this part of the move, if everything goes straight on: loops whose sines change sign are then on their other
    /// sides. The sines must be as foretold, and the line must fit where the piece began.
    fn beyond<J: Journey<T, Position = P>>(
        &self,
        journey: &J,
        from: (&P, T),
        end: T,
        at_zero: usize,
    ) -> Option<Beyond<P, T>> {
        if !self.leads_through(journey, from) {
            return None;
        }
        let last = self.last.0;
        let mut beyond = journey.beyond(self.before.0, last);
        let mut stops = false;
        // A loop that has passed its change point does not pass it once more.
        let turns = |index| {
            journey.watch(index).at_zero != AtZero::Stay
                && !has_passed(journey, last, index)
                && self.crosses(journey, index, end)
        };
        for index in (0..journey.watches()).filter(|index| turns(*index)) {
            pass(journey, &mut beyond, index);
            stops |= journey.watch(index).at_zero == AtZero::Stop;
        }
        let to = journey.at(&beyond, end).ok()?;
        // Where a sine is zero nothing tells on which side its loop is: only the end of the move may be there.
        let is_clear = |index| end >= T::ONE && !turns(index) || !is_zero(journey, &to, index);
        let holds = |index| {
            let passes = journey.watch(index).at_zero != AtZero::Stay;
            let meets = || self.meets(journey, (&to, end), index);
            (!passes || is_clear(index)) && (!(index == at_zero || turns(index)) || meets())
        };
        let all = (0..journey.watches()).all(holds);
        all.then_some(Beyond { to, end, stops })
    }
}

/// A position farther from a zero of a sine than the one beside it. Steps towards it are so short that no loop goes over to another
/// branch.
fn away<T: Real, J: Journey<T>>(
    journey: &J,
    (from, done): (&J::Position, T),
    index: usize,
) -> Option<Beyond<J::Position, T>> {
    let offset = lesser(distance(journey, index, OFFSETS[0]), T::ONE - done);
    let sine = |position: &J::Position| journey.sine(position, index).abs();
    let least = T::from_f64(1.0 - FALLS);
    let noise = T::from_f64(NOISE) * journey.rounding_square(from, index);
    let (mut to, mut gone, mut greatest) = (from.clone(), T::ZERO, sine(from));
    let mut halfway: Option<T> = None;
    let mut step = T::from_f64(FIRST) * sine(from) / journey.watch(index).change;
    for _ in 0..MOST_STEPS {
        // One step ends in the middle.
        let bound = if halfway.is_some() { offset } else { offset * T::HALF };
        let farther = lesser(gone + step, bound);
        if done + farther <= done + gone {
            return None;
        }
        // Beside a dead point no iteration reaches far.
        let Ok(next) = journey.at(&to, done + farther) else {
            step = step * T::from_f64(SHORTER);
            continue;
        };
        let fallen = least * greatest;
        if sine(&next) * sine(&next) + noise < fallen * fallen {
            return None;
        }
        (to, gone, greatest) = (next, farther, greatest.max(sine(&to)));
        match halfway {
            // Straight back from here it was not on the other side of its zero.
            Some(middle) if gone >= offset => {
                let is_away = sine(&to) > sine(from) && middle + middle > sine(&to);
                return is_away.then_some(Beyond { to, end: done + offset, stops: false });
            }
            None if gone >= bound => halfway = Some(sine(&to)),
            _ => {}
        }
        step = step * T::from_f64(LONGER);
    }
    None
}

/// The position that is this part of the move back.
fn back<T: Real, J: Journey<T>>(
    journey: &J,
    (position, part): (&J::Position, T),
    (offset, index): (T, usize),
) -> Option<J::Position> {
    let (mut at, mut gone) = (position.clone(), T::ZERO);
    let sine = journey.sine(position, index).abs();
    let mut step = T::from_f64(FIRST) * sine / journey.watch(index).change;
    for _ in 0..MOST_STEPS {
        let farther = lesser(gone + step, offset);
        if let Ok(next) = journey.at(&at, part - farther) {
            (at, gone) = (next, farther);
            step = step * T::from_f64(LONGER);
        } else {
            step = step * T::from_f64(SHORTER);
        }
        if gone >= offset {
            return Some(at);
        }
    }
    None
}
