//! The most that is guessed of a bound that is too wide.

use crate::program::Bound;

/// A bound through many loops is far too wide. Away from dead points nothing is guessed to turn faster than so many times what drives it,
/// and no sine to change faster.
pub(super) const MOST: f64 = 16.0;
pub(super) const MOST_OF_SINE: f64 = 4.0;
/// The same for angles behind gears, which may be much faster than what drives them.
pub(super) const MOST_OF_ANGLE: f64 = 1024.0;
/// The same for values that motors move directly: their bounds are good.
pub(super) const MOST_DIRECT: f64 = 256.0;
/// The greatest factor that the small sines of several free loops together add to a bound.
pub(super) const MOST_SHARP: f64 = 64.0;

/// Limits rates to so many times what drives them. A bound that was wider becomes a guess.
pub(super) fn tame(bound: &mut Bound, times: f64, driven: &[f64]) {
    for (rate, driven) in bound.rates.iter_mut().zip(driven) {
        let most = times * driven;
        if rate.is_nan() || *rate > most {
            *rate = most;
            bound.guessed = true;
        }
    }
}
