//! A piece that is short enough for one change point of a loop at most: past it, or as far as it closes.

use super::across::{beyond_cluster, beyond_touch, meeting, touches};
use super::departure::{depart, is_at_dead_point, is_beside_zero};
use super::event::{Event, first_event};
use super::pace::lesser;
use super::reach::{Reach, reach};
use super::sine::{
    NEAR, WELL_AWAY, distance, exceeds, has_passed, is_stepped_over, is_well_away, is_zero, pass,
    stands_at_change_point,
};
use super::{AtZero, Journey, Standing};
use crate::Real;

/// So often is the distance doubled by which a target is moved farther: from a part of the precision to the whole move.
const DOUBLINGS: usize = 32;

/// Goes a piece that is short enough for one change point of a loop at most. It ends a little farther where a loop would stand at its
/// change point, unless the move ends there.
pub(super) fn travel_piece<T: Real, J: Journey<T>>(
    journey: &J,
    mut from: J::Position,
    mut done: T,
    mut target: T,
) -> Reach<J::Position, J::Stop, T> {
    let mut aim = target;
    // By how much farther the target is put each time, so that it is beyond what rounding hides after a few.
    let mut times = 1.0;
    orient(journey, &mut from);
    if let Some(away) = depart(journey, &from, done) {
        (from, done) = away;
        if done >= target {
            return Reach::there(from, done);
        }
    }
    // Each round passes a change point, finds a dead point before its aim, or puts its target farther.
    for _ in 0..=8 * journey.watches() + DOUBLINGS {
        let mut reach = reach(journey, &from, done, aim);
        // Where one is on its other side, others may not leave theirs any more.
        for _ in 0..journey.watches() {
            match leave(journey, (&mut from, done), &reach) {
                Leaving::Stopped(index) => {
                    return Reach::stopped(from, done, journey.stopped_at(index));
                }
                Leaving::Other => reach = super::reach::reach(journey, &from, done, aim),
                Leaving::Same => break,
            }
        }
        let event = first_event(journey, &from, done, &reach);
        let mut meeting = meeting(journey, (&from, done), &reach, &event);
        let beyond = match (&mut meeting, &event) {
            (Some(meeting), _) => meeting.beyond.take(),
            (None, &Event::Zero(part, index)) => {
                beyond_cluster(journey, (&from, done), (part, index))
                    .or_else(|| beyond_touch(journey, (&from, done), (part, index)))
            }
            _ => None,
        };
        if let Some(beyond) = beyond.filter(|beyond| !beyond.stops) {
            (from, done, aim) = (beyond.to, beyond.end, target);
            if done >= target {
                return Reach::there(from, done);
            }
            continue;
        }
        if let Some(meeting) = meeting {
            return Reach::stopped(
                meeting.before.0,
                meeting.before.1,
                journey.stopped_at(meeting.index),
            );
        }
        match event {
            Event::None if reach.stop.is_none() && reach.end < target => {
                // A longer step was blocked, but this one was not: the move goes on from here.
                (from, done, aim) = (reach.to, reach.end, target);
            }
            Event::None if let Some(other) = other_side(journey, &reach, aim) => {
                // On the side it came from something else does not close: it is the other side that goes on.
                (from, done, aim) = (other, reach.end, target);
            }
            Event::None
                if let Some(farther) = target_beyond(journey, &from, &reach, (target, times)) =>
            {
                (aim, target) = (farther, farther);
                times *= 2.0;
            }
            Event::None | Event::Near(..) => {
                settle(journey, &from, done, &mut reach);
                if reach.end >= T::ONE {
                    note_arrived(journey, &from, &mut reach.to);
                    pass_hidden(journey, (&from, done), &mut reach);
                }
                return reach;
            }
            Event::Blocked(part) => aim = part,
            Event::Zero(part, index) => {
                if let Ok(at_zero) = journey.at(&from, part) {
                    from = at_zero;
                    done = part;
                }
                if journey.watch(index).at_zero == AtZero::Stop {
                    return Reach::stopped(from, done, journey.stopped_at(index));
                }
            }
        }
    }
    if aim < target {
        // Beside a dead point rounding lets it close here and there: beyond lies what does not.
        return reach(journey, &from, done, aim);
    }
    match journey.at(&from, target) {
        Ok(to) => Reach::there(to, target),
        Err(stop) => Reach::stopped(from, done, stop),
    }
}

/// A target a little farther. Asked for where a loop would stand at its change point, or so near that rounding hides it from the next
/// piece. None if the move ends here.
fn target_beyond<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    reach: &Reach<J::Position, J::Stop, T>,
    (target, times): (T, f64),
) -> Option<T> {
    let to = &reach.to;
    let stands = |index: &usize| {
        let comes_near =
            || !has_passed(journey, to, *index) && comes_near(journey, from, to, *index);
        journey.watch(*index).at_zero == AtZero::ChangeBranch
            && (is_zero(journey, to, *index) || comes_near())
    };
    let goes_on = reach.stop.is_none() && target < T::ONE;
    let index = (0..journey.watches()).find(|index| goes_on && stands(index))?;
    Some(lesser(target + distance(journey, index, times), T::ONE))
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

/// Notes the sense in which the motors go. If they go back, loops that stand at change points have passed these, seen in the other sense.
fn orient<T: Real, J: Journey<T>>(journey: &J, from: &mut J::Position) {
    forget_standing(journey, from);
    for index in 0..journey.watches() {
        if journey.sense(from, index) < T::ZERO {
            let standing = match journey.standing(from, index) {
                Standing::Away if !is_zero(journey, from, index) => continue,
                Standing::Away | Standing::Arrived => Standing::Passed,
                Standing::Passed => Standing::Arrived,
            };
            journey.set_standing(from, index, standing);
        }
    }
    journey.note_motion_signs(from);
}

/// Forgets of loops that are well away from change points that they came to them. Beside them rounding makes sines vanish here and there.
pub(super) fn forget_standing<T: Real, J: Journey<T>>(journey: &J, position: &mut J::Position) {
    for index in 0..journey.watches() {
        let stands = journey.standing(position, index) != Standing::Away;
        if stands && is_well_away(journey, position, index) {
            journey.set_standing(position, index, Standing::Away);
        }
    }
}

/// Notes which loops have come to change points where a move ends.
pub(super) fn note_arrived<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &mut J::Position,
) {
    for index in 0..journey.watches() {
        if journey.standing(to, index) == Standing::Away && comes_near(journey, from, to, index) {
            journey.set_standing(to, index, Standing::Arrived);
        }
    }
}

/// Whether a loop that can change its branch comes so near a change point that rounding may hide on which side it is.
fn comes_near<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &J::Position,
    index: usize,
) -> bool {
    journey.watch(index).at_zero == AtZero::ChangeBranch
        && !is_stepped_over(journey, index)
        && journey.sine(to, index).abs() <= journey.sine(from, index).abs()
        && !exceeds(journey, to, index, NEAR)
}

/// Whether the sine of a loop that came to its change point clearly grows again. What rounding may hide is a bound, and most of it hardly
/// changes in a small move: growth shows earlier that the loop goes away. A loop that is put on its other side too early is still
/// within what rounding hides.
fn goes_away<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    to: &J::Position,
    index: usize,
) -> bool {
    let [before, after] = [from, to].map(|position| journey.sine(position, index).abs());
    let clear = after * T::from_f64(WELL_AWAY);
    after > before * T::from_f64(NEAR) && clear * clear > journey.rounding_square(to, index)
}

/// Where a loop stands at its change point and leaves it, it goes over to its other side, unless it has passed it already.
fn leave<T: Real, J: Journey<T>>(
    journey: &J,
    (from, done): (&mut J::Position, T),
    reach: &Reach<J::Position, J::Stop, T>,
) -> Leaving {
    let to = &reach.to;
    // A loop that does not close right behind is at a dead point.
    let is_open = |index| {
        let is_open = |stop| journey.is_open(stop, index) && is_beside_zero(journey, to, index);
        reach.stop.as_ref().is_some_and(is_open)
    };
    for index in (0..journey.watches()).filter(|index| !is_open(*index)) {
        let leaves = match journey.standing(from, index) {
            Standing::Passed => false,
            Standing::Arrived if goes_away(journey, from, to, index) => true,
            _ if is_zero(journey, from, index) => !is_zero(journey, to, index),
            Standing::Arrived => is_well_away(journey, to, index),
            Standing::Away => false,
        };
        if leaves && journey.sense(from, index) > T::ZERO {
            match journey.watch(index).at_zero {
                AtZero::Stay => {}
                _ if is_at_dead_point(journey, (from, done), index) => {}
                AtZero::ChangeBranch if touches(journey, (from, done), index) => {
                    journey.set_standing(from, index, Standing::Away);
                }
                AtZero::Stop => return Leaving::Stopped(index),
                AtZero::ChangeBranch => {
                    pass(journey, from, index);
                    return Leaving::Other;
                }
            }
        }
    }
    Leaving::Same
}

/// Where a step was stopped with a loop at its change point: the same place on the loop's other side, if that goes on.
fn other_side<T: Real, J: Journey<T>>(
    journey: &J,
    reach: &Reach<J::Position, J::Stop, T>,
    aim: T,
) -> Option<J::Position> {
    reach.stop.as_ref()?;
    (0..journey.watches()).find_map(|index| {
        if !stands_at_change_point(journey, &reach.to, index) {
            return None;
        }
        let mut other = reach.to.clone();
        pass(journey, &mut other, index);
        let goes_on = journey.at(&other, aim).is_ok();
        goes_on.then_some(other)
    })
}

/// Where pins meet at a change point, the links between them have no direction of their own and keep that of the position before. So lets
/// that position be very near.
fn settle<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    done: T,
    reach: &mut Reach<J::Position, J::Stop, T>,
) {
    let arrives = |index| {
        journey.watch(index).at_zero == AtZero::ChangeBranch
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

/// Passes change points of which rounding hides on which side of them a move ends. They are passed where the straight line on which a sine came
/// to its zero leads beyond it.
fn pass_hidden<T: Real, J: Journey<T>>(
    journey: &J,
    (from, done): (&J::Position, T),
    reach: &mut Reach<J::Position, J::Stop, T>,
) {
    for index in 0..journey.watches() {
        let is_hidden = stands_at_change_point(journey, &reach.to, index)
            && !has_passed(journey, &reach.to, index);
        if !is_hidden || touches(journey, (from, done), index) {
            continue;
        }
        if leads_beyond(journey, from, reach.end, index) != Some(true) {
            continue;
        }
        let mut other = reach.to.clone();
        pass(journey, &mut other, index);
        if let Ok(to) = journey.at(&other, reach.end) {
            reach.to = to;
        }
    }
}

/// Whether the straight line through two sines before a zero changes its sign on the way there. None if rounding may hide the sines, or
/// the line would begin before the move.
fn leads_beyond<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    end: T,
    index: usize,
) -> Option<bool> {
    let offset = distance(journey, index, 4.0);
    let far = end - offset - offset;
    if far < T::ZERO {
        return None;
    }
    let last = journey.at(from, end - offset).ok()?;
    let before = journey.at(&last, far).ok()?;
    let sines = [&before, &last].map(|position| journey.sine(position, index));
    let is_clear = exceeds(journey, &last, index, NEAR) && sines[0] * sines[1] > T::ZERO;
    is_clear.then_some((sines[1] + sines[1] - sines[0]) * sines[1] < T::ZERO)
}
