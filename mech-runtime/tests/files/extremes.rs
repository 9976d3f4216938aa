//! Films that are as long, wide or high as can be.

use super::animations::{apng, check, colors, gif, whole};
use super::seen;
use mech_runtime::Palette;
use proptest::prelude::*;
use std::time::Duration;

/// A time as long as a file can say in one of its units, which is given.
fn delay(unit: Duration) -> impl Strategy<Value = Duration> {
    let most = (unit * 65_535).saturating_sub(Duration::from_nanos(1));
    prop_oneof![
        (0_u64..1000).prop_map(Duration::from_nanos),
        (0_u64..1_000_000_000).prop_map(Duration::from_nanos),
        (0_u32..3).prop_map(move |less| most.saturating_sub(Duration::from_nanos(u64::from(less)))),
        (0.0..1.0).prop_map(move |share| most.mul_f64(share)),
    ]
}

fn in_units(delay: Duration, unit: Duration) -> f64 {
    delay.as_secs_f64() / unit.as_secs_f64()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2))]

    /// Thousands of frames: each begins at its moment.
    #[test]
    fn long(
        kinds in prop::collection::vec(0_u8..3, 900..1500),
        slow in delay(Duration::from_millis(10)),
        quick in delay(Duration::from_millis(1)),
    ) {
        let pixels: Vec<_> = kinds.iter().map(|&kind| [kind, kind / 2]).collect();
        let pictures: Vec<_> = pixels.iter().map(|pixels| whole([2, 1], pixels, &Palette::NIGHT)).collect();
        let expected: Vec<_> = pixels.iter().map(|pixels| colors(pixels, &Palette::NIGHT)).collect();
        let bytes = gif(pictures.iter().copied(), slow).expect("a file");
        check(&seen::gif(&bytes), &expected, in_units(slow, Duration::from_millis(10)));
        let bytes = apng(&pictures, quick).expect("a file");
        check(&seen::apng(&bytes), &expected, in_units(quick, Duration::from_millis(1)));
    }

    /// As wide, or as high, as a GIF can be.
    #[test]
    fn wide_and_high(changes in prop::collection::vec(0_usize..65_535, 1..4), ends in any::<bool>()) {
        let mut pixels = vec![vec![3; 65_535]];
        for change in changes {
            let mut next = pixels.last().expect("the first").clone();
            next[change] ^= 1;
            if ends {
                next[0] ^= 1;
                next[65_534] ^= 1;
            }
            pixels.push(next);
        }
        let expected: Vec<_> = pixels.iter().map(|pixels| colors(pixels, &Palette::NIGHT)).collect();
        for size in [[65_535, 1], [1, 65_535]] {
            let pictures: Vec<_> = pixels.iter().map(|pixels| whole(size, pixels, &Palette::NIGHT)).collect();
            let bytes = gif(pictures.iter().copied(), Duration::ZERO).expect("a file");
            check(&seen::gif(&bytes), &expected, 0.0);
            let bytes = apng(&pictures, Duration::ZERO).expect("a file");
            check(&seen::apng(&bytes), &expected, 0.0);
        }
    }
}
