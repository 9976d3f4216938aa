//! The most that is guessed of a bound that is too wide.

use crate::program::Bound;

/// A bound through many loops is wide: away from all dead points nothing is guessed to turn more than so many times as fast as what
/// drives it, and no sine to change so fast.
pub(super) const MOST: f64 = 16.0;
pub(super) const MOST_OF_SINE: f64 = 4.0;
/// Gears make faster what they are driven by, whatever that is.
pub(super) const MOST_OF_ANGLE: f64 = 1024.0;
/// What motors move directly is bounded well.
pub(super) const MOST_DIRECT: f64 = 256.0;
/// By how much small sines of free loops make a bound greater, at most, if it is not one of them alone.
pub(super) const MOST_SHARP: f64 = 64.0;

/// Makes a bound that is too wide a guess: so many times as fast as what drives it.
pub(super) fn tame(bound: &mut Bound, times: f64, driven: &[f64]) {
    for (rate, driven) in bound.rates.iter_mut().zip(driven) {
        let most = times * driven;
        if rate.is_nan() || *rate > most {
            *rate = most;
            bound.guessed = true;
        }
    }
}
