//! The time that several inputs take until all of them are back.

use super::drawing::{Motor, Speed};

/// For how many turns of the fastest input laws are tried, if not all are back sooner.
const TURNS: f64 = 64.0;
/// The number of steps in which a turn of the fastest input is tried.
const STEPS: f64 = 90.0;
/// Speeds are compared in thousandths.
const THOUSANDTHS: f64 = 1000.0;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Times {
    /// After which all of them are back where they started, if that is soon.
    pub(super) back: Option<f64>,
    /// For how long laws are tried, and in what steps.
    pub(super) tried: f64,
    pub(super) step: f64,
}

impl Times {
    /// The times of these motors, if several have laws.
    pub(super) fn of(motors: &[Motor]) -> Option<Self> {
        let rates: Vec<f64> = motors.iter().filter_map(Motor::rounds).collect();
        if rates.len() < 2 {
            return None;
        }
        let fastest = rates.iter().copied().fold(0.0, f64::max);
        let longest = 60.0 * TURNS / fastest;
        let common = rates.iter().try_fold(0.0, |common, rate| {
            let thousandths = rate * THOUSANDTHS;
            let whole = thousandths.round();
            ((thousandths - whole).abs() < 1e-6).then(|| divisor(whole, common))
        });
        let back = common.map(|common| 60.0 * THOUSANDTHS / common);
        let back = back.filter(|back| *back <= longest);
        Some(Self {
            back,
            tried: back.unwrap_or(longest),
            step: 60.0 / fastest / STEPS,
        })
    }
}

impl Motor {
    /// Counts the times a minute at which it is back at its start, if a law can say how it moves.
    pub(super) fn rounds(&self) -> Option<f64> {
        match (self.speed?, self.stroke) {
            (Speed::Turns(turns), _) => Some(turns.abs()),
            (Speed::Cycles(cycles), Some(_)) => Some(cycles),
            (Speed::Cycles(_), None) | (Speed::Way(_), _) => None,
        }
    }
}

/// The greatest common divisor of whole numbers.
fn divisor(a: f64, b: f64) -> f64 {
    if b == 0.0 { a } else { divisor(b, a % b) }
}
#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inputs_are_back_after_their_common_period() {
        let back = |rates: &[f64]| {
            let motor = |turns: &f64| Motor {
                joint: 0,
                stroke: None,
                speed: Some(Speed::Turns(*turns)),
            };
            let motors: Vec<Motor> = rates.iter().map(motor).collect();
            Times::of(&motors).and_then(|times| times.back)
        };
        assert_eq!(back(&[15.0, -15.0, 15.0, 18.0]), Some(20.0));
        assert_eq!(back(&[0.5, 0.75]), Some(240.0));
        assert_eq!(back(&[15.0]), None);
        assert_eq!(back(&[15.0, 15.001]), None);
        assert_eq!(back(&[15.0, std::f64::consts::PI]), None);
    }
}
