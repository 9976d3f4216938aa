//! Whether a loop closes for all values of what it is made from, and how far what it finds then goes.

use super::Interval;
use super::claim::Test;
use super::cone::Cone;
use super::tape::{Outcome, Tape};
use crate::program::{BlockId, Value};
use std::collections::VecDeque;

/// A question about a loop: its outputs in a cone.
#[derive(Clone, Debug)]
pub(crate) struct Question {
    /// The loop's block.
    pub(crate) block: BlockId,
    /// The discriminant, and the floor below which rounding may push it.
    pub(crate) discriminant: Value,
    pub(crate) tolerance: Value,
    /// The other values that are wanted where it closes.
    pub(crate) found: Vec<Value>,
}

/// A box narrower than this part of the whole range is not cut only to narrow what is found there. It is cut only if it is open whether
/// the loop closes.
const FINE: f64 = 1.0 / 64.0;
/// A discriminant that is known to this part of itself is known well enough.
const WELL_KNOWN: f64 = 0.5;
/// Narrower parts are not cut.
const NARROW: f64 = 1e-6;
/// A range without ends is looked at in parts: the first ends at this number, each next one so many times as far.
const FIRST_PART: f64 = 1.0;
const FARTHER: f64 = 4.0;
const FARTHEST: f64 = 1e9;

/// Tests whether the loop closes, by more than rounding, on the whole of these ranges of the cone's variables. Shows `look` every box on
/// which it does. The budget is in evaluations, and what was used is taken from it. Nothing is known if it does not last.
pub(crate) fn always_closes(
    cone: &Cone,
    question: &Question,
    ranges: &[Interval],
    budget: &mut usize,
    mut look: impl FnMut(&dyn Fn(Value) -> Interval),
) -> bool {
    let tests =
        vec![(question.block, Test::Discriminant(question.discriminant, question.tolerance))];
    let mut tape = Tape::of(&cone.nodes, cone.variables.len(), tests, &question.found);
    if tape.is_too_large() {
        return false;
    }
    let mut waiting = VecDeque::from([(ranges.to_vec(), false)]);
    while let Some((place, known)) = waiting.pop_front() {
        let Some(left) = budget.checked_sub(tape.cost()) else {
            return false;
        };
        *budget = left;
        tape.run(&place);
        let closes = known || tape.on_box(0) == Outcome::Strict;
        let part = widest(&place, ranges);
        let is_fine = part.1 <= FINE || waiting.len() > 256;
        if closes && (is_fine || is_well_known(tape.value(question.discriminant))) {
            look(&|value| tape.value(value));
            continue;
        }
        if !closes && (tape.at_centre(0) != Outcome::Strict || part.1 < NARROW) {
            return false;
        }
        let Some(halves) = halves(&place, part.0) else {
            return false;
        };
        waiting.extend(halves.map(|half| (half, closes)));
    }
    true
}

fn is_well_known(discriminant: Interval) -> bool {
    discriminant.low() >= WELL_KNOWN * discriminant.high()
}

/// The variable whose range a box covers to the greatest part, and that part: infinite where the box itself has no end.
fn widest(place: &[Interval], ranges: &[Interval]) -> (usize, f64) {
    let part = |(place, range): (&Interval, &Interval)| {
        if !place.is_bounded() {
            f64::INFINITY
        } else if !range.is_bounded() {
            // The part of the box in a range without ends: its width over its distance from zero.
            place.width() / (place.abs().high() + FIRST_PART)
        } else if range.width() > 0.0 {
            place.width() / range.width()
        } else {
            0.0
        }
    };
    let parts = place.iter().zip(ranges).map(part).enumerate();
    parts.fold((0, 0.0), |best, next| if next.1 > best.1 { next } else { best })
}

/// A box cut across one of its variables, if that can be cut.
pub(crate) fn halves(place: &[Interval], variable: usize) -> Option<[Vec<Interval>; 2]> {
    let range = *place.get(variable)?;
    let farther = |end: f64| (end.abs() * FARTHER).max(FIRST_PART);
    let middle = match (range.low().is_finite(), range.high().is_finite()) {
        (true, true) => range.middle(),
        (false, false) => 0.0,
        (true, false) if range.low() < FARTHEST => farther(range.low()),
        (false, true) if range.high() > -FARTHEST => -farther(range.high()),
        _ => return None,
    };
    if !(range.low() < middle && middle < range.high()) {
        return None;
    }
    Some([range.low(), range.high()].map(|end| {
        let mut half = place.to_vec();
        half[variable] = Interval::new(middle, end);
        half
    }))
}
