//! Staircases on intervals, against their heights and slopes at points.

use crate::certify::Interval;
use crate::certify::stairs::{heights, slopes};
use mech_core::{MotionLaw, Staircase};
use proptest::prelude::*;

proptest! {
    #[test]
    fn every_height_and_slope_is_in_its_interval(
        number in 0..8_usize,
        repeats: bool,
        low in -3.0..3.0_f64,
        width in prop_oneof![Just(0.0), 1e-6..1.5_f64],
        share in 0.05..1.0_f64,
        part in 0.0..1.0_f64,
    ) {
        let stairs = Staircase { law: MotionLaw::ALL[number], repeats, order: 0 };
        let share = if repeats { share } else { 1.0 };
        let places = Interval::new(low, low + width);
        let place = low + part * width;
        let high = heights(stairs, places, share);
        prop_assert!(high.contains(stairs.at(place, share)), "{high:?}");
        // As wide as the climb, but for rounding.
        let climb = stairs.at(low + width, share) - stairs.at(low, share);
        prop_assert!(high.width() <= climb + 1e-12, "{high:?}");
        let steep = slopes(stairs, places, share);
        prop_assert!(steep.contains(stairs.slope().at(place, share) / share), "{steep:?}");
        // A derivative is in the interval of derivatives, too.
        let second = Staircase { order: 2, ..stairs };
        let bent = heights(second, places, share);
        prop_assert!(bent.contains(second.at(place, share)), "{bent:?}");
    }

    /// Intervals of slopes shrink with their places.
    #[test]
    fn slopes_are_sharp(number in 1..8_usize, low in -3.0..3.0_f64, share in 0.05..1.0_f64) {
        let stairs = Staircase::endless(MotionLaw::ALL[number], 0);
        let steep = slopes(stairs, Interval::new(low, low + 1e-6), share);
        prop_assert!(steep.width() < 1e-3 / (share * share), "{steep:?}");
    }
}
