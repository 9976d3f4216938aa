//! Positions along the way of one motor, and how far out links may be seen between them.

use super::seen::{Outermost, Reach, SIDES, outwards};
use crate::program::Position;
use std::rc::Rc;

/// A new position keeps this part of the gap between two known ones as its distance from both.
const NEAREST: f64 = 0.1;

/// A position on the way.
pub(super) struct Sample {
    /// The value of the motor.
    pub(super) at: f64,
    pub(super) position: Rc<Position<f64>>,
    /// For each link how far out it is seen.
    pub(super) links: Vec<Outermost>,
}

impl Sample {
    /// A position on the way of a motor, and what is seen there.
    pub(super) fn new(
        motor: usize,
        (position, links): (Rc<Position<f64>>, Vec<Outermost>),
    ) -> Self {
        Self { at: position.motors[motor], position, links }
    }
}

/// The outermost place that is guessed between two positions, and the motor's value there.
#[derive(Clone, Copy)]
pub(super) struct Guess {
    pub(super) out: f64,
    pub(super) at: f64,
}

/// A guess of nothing.
pub(super) const NOTHING: Guess = Guess { out: f64::NEG_INFINITY, at: 0.0 };

/// Positions in the order of the motor's values.
pub(super) struct Line {
    pub(super) motor: usize,
    pub(super) samples: Vec<Sample>,
    /// For each pair of neighbours and each side the farthest guess.
    pub(super) guesses: Vec<[Guess; 4]>,
}

impl Line {
    /// Guesses between all neighbours; `most` is how far out each link can be, and `known` how far anything is known to be.
    pub(super) fn guess_all(&mut self, points: &[Vec<Reach>], most: &[[f64; 4]], known: [f64; 4]) {
        let pairs = 0..self.samples.len().saturating_sub(1);
        self.guesses = pairs.map(|pair| self.guess(pair, points, most, known)).collect();
    }

    /// Puts a position between two neighbours, and guesses anew around it.
    pub(super) fn insert(
        &mut self,
        (pair, sample): (usize, Sample),
        points: &[Vec<Reach>],
        most: &[[f64; 4]],
        known: [f64; 4],
    ) {
        self.samples.insert(pair + 1, sample);
        self.guesses.insert(pair, [NOTHING; 4]);
        for near in pair.saturating_sub(2)..(pair + 4).min(self.guesses.len()) {
            self.guesses[near] = self.guess(near, points, most, known);
        }
    }

    /// Guesses the outermost place between a position and the next, on each side.
    fn guess(
        &self,
        pair: usize,
        points: &[Vec<Reach>],
        most: &[[f64; 4]],
        known: [f64; 4],
    ) -> [Guess; 4] {
        let first = pair.saturating_sub(1).min(self.samples.len().saturating_sub(4));
        let around = &self.samples[first..self.samples.len().min(first + 4)];
        let here = pair - first;
        let [a, b] = [&around[here], &around[here + 1]];
        let mut guesses = [NOTHING; 4];
        for (link, points) in points.iter().enumerate() {
            for side in SIDES {
                let limit = most[link][side];
                let ends = [a, b].map(|sample| sample.links[link].sides[side]);
                let farthest = ends[0].max(ends[1]);
                let outs = around.iter().map(|sample| sample.links[link].sides[side]);
                let (low, high) = outs.fold((farthest, farthest), |(low, high), out| {
                    (f64::min(low, out), f64::max(high, out))
                });
                // No bow is higher than twice what changes around it.
                if limit.min(farthest + 2.0 * (high - low)) <= known[side].max(guesses[side].out) {
                    continue;
                }
                for number in [a, b].map(|sample| sample.links[link].points[side] as usize) {
                    let out = |sample: &Sample| {
                        let pose = sample.position.poses[link];
                        (sample.at, outwards(points[number], pose)[side])
                    };
                    let places: Vec<(f64, f64)> = around.iter().map(out).collect();
                    let guess = bow(&places, here);
                    let out = guess.out.min(limit);
                    if out > guesses[side].out {
                        guesses[side] = Guess { out, ..guess };
                    }
                }
            }
        }
        guesses
    }
}

/// The highest that a smooth function may be between two neighbours of up to four places.
///
/// Parabolas through three of them tell how it is bent on either side. It is taken to be bent as the more pointed of these, and more so by
/// as much as they differ.
fn bow(places: &[(f64, f64)], here: usize) -> Guess {
    let ((s, f), (t, g)) = (places[here], places[here + 1]);
    let length = t - s;
    let farther = if f > g { Guess { out: f, at: s } } else { Guess { out: g, at: t } };
    let slope = |(s, f): (f64, f64), (t, g): (f64, f64)| (g - f) / (t - s);
    let bends: Vec<f64> = places
        .windows(3)
        .map(|three| {
            (slope(three[1], three[2]) - slope(three[0], three[1])) / (three[2].0 - three[0].0)
        })
        .collect();
    let bend = match bends[..] {
        [] => -2.0 * (g - f).abs() / (length * length),
        [one] => one - one.abs(),
        [one, other] => {
            // At an end of the way the bend goes on to change as it did.
            let [one, other] = match here {
                0 => [2.0 * one - other, one],
                1 => [one, other],
                _ => [other, 2.0 * other - one],
            };
            one.min(other) - (one - other).abs()
        }
        _ => 0.0,
    };
    let rise = (g - f) / length;
    let top = 0.5 * length - 0.5 * rise / bend;
    if !(bend < 0.0 && top > 0.0 && top < length) {
        return farther;
    }
    let out = f + rise * top + bend * top * (top - length);
    let top = top.clamp(NEAREST * length, (1.0 - NEAREST) * length);
    Guess { out, at: s + top }
}
