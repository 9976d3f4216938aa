//! Staircases, on intervals.

use super::Interval;
use mech_core::{MotionLaw, Staircase};

/// What rounding may take from a height or a slope, in parts of the greatest.
const ROUNDING: f64 = 1e-14;

/// Times that differ less are taken for one, where a law changes its formula.
const EDGE: f64 = 1e-11;

/// The heights of a staircase at these places, of which each step takes this share.
pub(super) fn heights(stairs: Staircase, places: Interval, share: f64) -> Interval {
    if stairs.order > 0 {
        return derivatives(stairs, places, share);
    }
    // It never goes down.
    let at = |place: f64| {
        let height = stairs.at(place, share);
        let rounding = ROUNDING * (1.0 + height.abs());
        [height - rounding, height + rounding]
    };
    Interval::new(at(places.low())[0], at(places.high())[1])
}

/// The slopes of a staircase at these places.
pub(super) fn slopes(stairs: Staircase, places: Interval, share: f64) -> Interval {
    if stairs.order > 0 {
        // A derivative may jump.
        return Interval::ENTIRE;
    }
    derivatives(stairs.slope(), places, share) / Interval::point(share)
}

/// The slopes of a staircase at these places, if it has no corner and no jump there that they do not tell of.
pub(super) fn smooth_slopes(stairs: Staircase, places: Interval, share: f64) -> Option<Interval> {
    if stairs.order == 0 {
        return Some(slopes(stairs, places, share));
    }
    let step = if stairs.repeats { places.low().floor() } else { 0.0 };
    let slack = EDGE * (1.0 + step.abs());
    let time = |place: f64| (place - step) / share;
    let (from, to) = (time(places.low()) - slack, time(places.high()) + slack);
    let next_step = if stairs.repeats { 1.0 / share } else { f64::INFINITY };
    let mut edges = vec![0.0];
    edges.extend(cuts(stairs.law));
    edges.push(next_step);
    let is_within = |pair: &[f64]| pair[0] < from && to < pair[1];
    let before = !stairs.repeats && to < 0.0;
    let is_smooth = before || edges.windows(2).any(is_within);
    is_smooth.then(|| derivatives(stairs.slope(), places, share) / Interval::point(share))
}

/// The times after which a law changes its formula, its end among them.
fn cuts(law: MotionLaw) -> Vec<f64> {
    let changes: Vec<f64> = law.changes().collect();
    let mirrored = changes.iter().rev().map(|change| 1.0 - change);
    changes.iter().copied().chain(mirrored).chain([1.0]).collect()
}

/// The derivatives of a staircase at these places, times a power of the share: on both sides where they jump.
fn derivatives(stairs: Staircase, places: Interval, share: f64) -> Interval {
    let (low, high) = (places.low(), places.high());
    let bound = stairs.law.bound(stairs.order);
    let steps = if stairs.repeats { [low.floor(), high.floor()] } else { [0.0, 0.0] };
    if !places.is_bounded() || steps[1] - steps[0] > 1.0 {
        return Interval::new(-bound, bound);
    }
    let of_step = |step: f64| {
        let slack = EDGE * (1.0 + step.abs());
        let from = (low - step) / share - slack;
        let to = (high - step) / share + slack;
        of_times(stairs, [from, to])
    };
    of_step(steps[0]).hull(of_step(steps[1]))
}

/// The derivatives of one step at these times.
fn of_times(stairs: Staircase, [from, to]: [f64; 2]) -> Interval {
    let law = stairs.law;
    let (bound, next) = (law.bound(stairs.order), law.bound(stairs.order + 1));
    // Where the slope jumps, no number is the derivative of it.
    if stairs.order > 1 && law == MotionLaw::Linear && (from <= 0.0 || to >= 1.0) {
        return Interval::ENTIRE;
    }
    // Before and after it there is no slope.
    let mut found = (from < 0.0 || to >= 1.0).then_some(Interval::ZERO);
    let mut begin = 0.0;
    for end in cuts(law) {
        let (low, high) = (from.max(begin), to.min(end));
        if low <= high && begin < end {
            // Within the piece, where both sides are the same.
            let middle = (0.5 * (low + high)).clamp(begin + EDGE, end - EDGE);
            let value = law.at(stairs.order, middle);
            let away = next * (0.5 * (high - low) + EDGE) + ROUNDING * bound;
            let here = Interval::new(value - away, value + away);
            found = Some(found.map_or(here, |found| found.hull(here)));
        }
        begin = end;
    }
    let found = found.unwrap_or(Interval::ZERO);
    found.meet(Interval::new(-bound, bound))
}
