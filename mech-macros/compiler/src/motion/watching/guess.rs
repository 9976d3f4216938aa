//! Bounds that are too wide cut down to guesses: through several loops they multiply, and become far wider than any motion.

use super::most::{MOST_OF_SINE, MOST_SHARP, tame};
use super::pace::Paces;
use crate::plan::{Rational, Tie, Unknown, float_of};
use crate::program::{Bound, Growth, Op};

/// The greatest factor that the small sine of a single free loop adds to a bound.
const MOST_SHARP_OF_ONE: f64 = 1024.0;
/// A guess of the rate of a squared sine with a param, over the param's scale.
const WITH_PARAM: f64 = 4.0;

impl Paces<'_> {
    /// Guesses the rate of the square of a tied loop's sine: at least that at which motors turn its unknowns through the ties.
    pub(super) fn of_tied(&self, ties: &[Tie]) -> Bound {
        let mut bound = self.unbounded();
        let size = self.domain.model.size().max(f64::MIN_POSITIVE);
        let unit = |unknown: &Unknown| match unknown {
            Unknown::Direction(_) => 1.0,
            Unknown::Slide(_) => size,
        };
        let number = |part: &Rational| float_of(part).abs();
        let mut most = MOST_OF_SINE;
        for tie in ties {
            let parts = tie.parts.iter();
            let parts = parts.map(|(of, part)| number(part) * unit(of) / unit(&tie.of));
            let sources = tie.sources.iter().map(|(_, part)| number(part));
            most = parts.chain(sources).fold(most, f64::max);
        }
        tame(&mut bound, most, &self.fastest);
        bound
    }

    /// Guesses the rates with the params: they are known in the neighbourhood of a param's value only.
    pub(super) fn with_params(&self, bound: &mut Bound, number: usize) {
        let model = self.domain.model;
        if !self.domain.varying.contains(&number) {
            return;
        }
        let own = bound.rates.iter_mut().skip(model.motors.len());
        for (rate, param) in own.zip(model.params.ids()) {
            if let Some(scale) = model.param_scale(param) {
                *rate = WITH_PARAM / scale;
            }
        }
        bound.guessed = true;
    }

    /// Replaces the growth by free loops by a factor, from how small their sines are at least. Loops with a smaller sine than `watched`
    /// keep their growth: they are watched.
    pub(super) fn sharpen(&self, bound: &mut Bound, watched: f64) {
        let (mut times, mut most) = (1.0, MOST_SHARP);
        bound.growth.retain(|growth| {
            let Growth::NearZero(number) = *growth else {
                return true;
            };
            match &self.domain.known[number].free {
                Some(free) if free.least_sine >= watched => {
                    // A zero may have a sign.
                    let own = f64::min(1.0 / free.least_sine.abs(), MOST_SHARP_OF_ONE);
                    times *= own;
                    most = f64::max(most, own);
                    false
                }
                _ => true,
            }
        });
        bound.guessed |= times > most;
        for rate in &mut bound.rates {
            *rate *= f64::min(times, most);
        }
    }

    /// For each input the fastest that turns with it, in radians, or in sizes of the mechanism.
    pub(super) fn fastest(&self) -> Vec<f64> {
        let mut fastest: Vec<f64> =
            (0..self.inputs()).map(|input| 1.0 / self.unit(input)).collect();
        let program = self.domain.cutter.program;
        for node in &program.ssa.nodes {
            if let Op::Sin(angle) | Op::Cos(angle) = node.op {
                for (input, part) in self.domain.cutter.parts(angle).into_iter().flatten() {
                    fastest[input] = fastest[input].max(part.abs());
                }
            }
        }
        fastest
    }
}
