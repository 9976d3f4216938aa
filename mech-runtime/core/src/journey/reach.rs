//! As far as a move goes in one step, or in as many as an iteration takes.

use super::pace::is_passable;
use super::sine::is_stepped_over;
use super::{Journey, MOST_TRIES};
use crate::Real;

/// Where a piece ends: at its target, or before it for a reason.
pub(super) struct Reach<P, S, T> {
    pub(super) to: P,
    pub(super) end: T,
    pub(super) stop: Option<S>,
}

impl<P, S, T> Reach<P, S, T> {
    /// One that ends at its target.
    pub(super) fn there(to: P, end: T) -> Self {
        Self { to, end, stop: None }
    }

    /// One that ends before it.
    pub(super) fn stopped(to: P, end: T, stop: S) -> Self {
        Self { to, end, stop: Some(stop) }
    }
}

/// Goes as far as it can in one step; by iteration, in as many as it takes.
pub(super) fn reach<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    done: T,
    aim: T,
) -> Reach<J::Position, J::Stop, T> {
    let mut stop = match journey.at(from, aim) {
        Ok(to) => {
            return Reach::there(to, aim);
        }
        Err(stop) => stop,
    };
    let (mut to, mut end, mut blocked) = (from.clone(), done, aim);
    let mut before = (from.clone(), done);
    for _ in 0..MOST_TRIES {
        let middle = end + (blocked - end) * T::HALF;
        if !(middle > end && middle < blocked) {
            break;
        }
        match journey.at(&to, middle) {
            // It left the branch that it is on, where its sine comes to zero.
            Ok(position) if bounces(journey, &before, (&to, end), (&position, middle)) => {
                blocked = middle;
            }
            Ok(position) => {
                // An iteration that failed to come far from a place may come there from a nearer one.
                if journey.subdivides() {
                    let far = end + (middle - end) * T::from_f64(4.0);
                    blocked = if far < aim { far } else { aim };
                }
                before = (to, end);
                (to, end) = (position, middle);
                // A fixed number of rounds is a promise about time: only a move that goes in pieces anyhow takes one more.
                let again = journey.subdivides() || done > T::ZERO;
                if blocked >= aim
                    && again
                    && let Ok(position) = journey.at(&to, aim)
                    && !bounces(journey, &before, (&to, end), (&position, aim))
                    && (journey.subdivides() || is_passable(journey, &to, &position, aim - end))
                {
                    return Reach::there(position, aim);
                }
            }
            Err(reason) => (stop, blocked) = (reason, middle),
        }
    }
    Reach::stopped(to, end, stop)
}

/// The position at a part of the move; none if it cannot be reached. An iteration that fails in one step may succeed in many.
pub(super) fn position_at<T: Real, J: Journey<T>>(
    journey: &J,
    from: &J::Position,
    done: T,
    part: T,
) -> Option<J::Position> {
    match journey.at(from, part) {
        Ok(position) => Some(position),
        Err(_) if journey.subdivides() => {
            let reach = reach(journey, from, done, part);
            reach.stop.is_none().then_some(reach.to)
        }
        Err(_) => None,
    }
}

/// Whether a sine would have another sign if it had gone straight on from two positions to a third. The loop is one that is passed over its
/// change points.
fn bounces<T: Real, J: Journey<T>>(
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
