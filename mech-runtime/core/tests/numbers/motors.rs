//! Parts of whole turns, against the same in 128 bits and in `f64`.

use mech_core::motors::{reduced, turned};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// The part of a turn that is left, between zero and one.
#[allow(clippy::cast_precision_loss, reason = "each is rounded once")]
fn part(turns: i32, numerator: i64, denominator: i64) -> f64 {
    let product = i128::from(turns) * i128::from(numerator);
    product.rem_euclid(i128::from(denominator)) as f64 / denominator as f64
}

/// Denominators of all sizes.
fn denominator() -> impl Strategy<Value = i64> {
    (0..63_u32, any::<i64>()).prop_map(|(size, bits)| ((bits & i64::MAX) >> size).max(1))
}

proptest! {
    #[test]
    #[allow(clippy::cast_possible_truncation, reason = "rounding is what is asked for")]
    fn what_is_left_is_exact(turns in any::<i32>(), numerator in prop_oneof![any::<i64>(), 1..1000_i64], denominator in prop_oneof![denominator(), 1..1000_i64]) {
        let part = part(turns, numerator, denominator);
        // The part is rounded alike, so it is the same to the bit.
        prop_assert_eq!(turned::<f64>(turns, numerator, denominator), TAU * part);
        prop_assert_eq!(turned::<f64>(turns, numerator / denominator * denominator, denominator), 0.0);
        let angle: f32 = turned(turns, numerator, denominator);
        if denominator <= 1 << 24 {
            prop_assert_eq!(angle, std::f32::consts::TAU * part as f32);
        } else {
            // Five roundings: of both numbers, of their ratio, of a turn, and of the product.
            let most = TAU * part * f64::from(f32::EPSILON) * 2.5;
            prop_assert!((f64::from(angle) - TAU * part).abs() <= most);
        }
    }
}

#[test]
fn nothing_panics() {
    let numbers = [i64::MIN, i64::MIN + 1, -1, 0, 1, 65_535, 65_536, i64::MAX - 1, i64::MAX];
    for turns in [i32::MIN, -1, 0, 1, i32::MAX] {
        for numerator in numbers {
            for denominator in numbers {
                let angle: f64 = turned(turns, numerator, denominator);
                let is_part = denominator > 0;
                assert!((0.0..=TAU).contains(&angle) && (is_part || angle == 0.0));
                if is_part {
                    assert_eq!(angle, TAU * part(turns, numerator, denominator));
                }
            }
        }
    }
}

/// A turn as a fraction: so exact that products with 2⁶⁰ are still exact to 2⁻⁶⁰.
fn turns_of(x: f64) -> (i128, i128) {
    // One through a turn in units of 2⁻¹²⁰, and the number in units of 2⁻⁶⁰ less whole ones.
    const PER_RADIAN: [u64; 2] = [0x28BE_60DB_9391_054A, 0x7F09_D5F4_7D4D_3770];
    let size = x.abs();
    let bits = size.to_bits();
    let whole = u128::from(bits & ((1 << 52) - 1) | 1 << 52);
    let exponent = i32::try_from(bits >> 52).expect("eleven bits") - 1075;
    // The product in units of 2^(exponent − 128), in two halves.
    let (high, low) = (whole * u128::from(PER_RADIAN[0]), whole * u128::from(PER_RADIAN[1]));
    let sum = high + (low >> 64);
    // `sum` is in units of 2^(exponent − 64).
    let shift = u32::try_from(64 - exponent).expect("not too large");
    let (turns, remainder) = if shift >= 127 {
        (0, sum.checked_shr(shift - 126).unwrap_or(0))
    } else {
        let remainder = sum & ((1 << shift) - 1);
        let remainder = if shift <= 126 { remainder << (126 - shift) } else { remainder };
        (sum >> shift, remainder)
    };
    let half = 1_u128 << 125;
    let (turns, remainder) = if remainder >= half {
        (turns + 1, remainder.cast_signed() - (1_i128 << 126))
    } else {
        (turns, remainder.cast_signed())
    };
    let sign = if x < 0.0 { -1 } else { 1 };
    (sign * turns.cast_signed(), sign * remainder)
}

/// Converts a remainder from units of 2⁻¹²⁶ turns to radians.
#[allow(clippy::cast_precision_loss, reason = "rounded once")]
fn radians(remainder: i128) -> f64 {
    remainder as f64 / 2_f64.powi(126) * TAU
}

fn assert_reduced(x: f64) {
    let (turns, remainder) = turns_of(x);
    let (found, whole) = reduced(x, 0);
    assert!(
        i128::from(whole) == turns || found.abs() > core::f64::consts::PI - 1e-5,
        "{x:e}: {whole}, not {turns}"
    );
    if i128::from(whole) == turns {
        let off = (found - radians(remainder)).abs();
        assert!(off <= 1.2e-15, "{x:e}: {found}, off by {off:e}");
    }
}

#[allow(clippy::cast_possible_truncation, reason = "rounding is what is asked for")]
fn assert_reduced_single(x: f32) {
    let (turns, remainder) = turns_of(f64::from(x));
    let (found, whole) = reduced(x, 0);
    assert!(
        i128::from(whole) == turns || found.abs() > core::f32::consts::PI - 1e-4,
        "{x:e}: {whole}, not {turns}"
    );
    if i128::from(whole) == turns {
        let off = (f64::from(found) - radians(remainder)).abs();
        assert!(off <= 5e-7, "{x:e}: {found}, off by {off:e}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, ..ProptestConfig::default() })]

    #[test]
    fn whole_turns_leave_an_exact_remainder(size in -3.0..10.1, negative in any::<bool>()) {
        let x = 10_f64.powf(size) * if negative { -1.0 } else { 1.0 };
        assert_reduced(x);
        #[allow(clippy::cast_possible_truncation, reason = "any number will do")]
        assert_reduced_single(x as f32);
    }

    #[test]
    fn near_half_turns_too(turns in -2_000_000_000..2_000_000_000_i32, off in -1e-3..1e-3) {
        let x = (f64::from(turns) + 0.5) * TAU + off;
        assert_reduced(x);
        #[allow(clippy::cast_possible_truncation, reason = "any number will do")]
        assert_reduced_single(x as f32);
    }

    #[test]
    fn turns_given_besides_are_added(turns in any::<i32>(), x in -1e9..1e9) {
        let ((remainder, whole), (same, sum)) = (reduced(x, 0), reduced(x, turns));
        let expected = turns.checked_add(whole).map_or((x, turns), |sum| (remainder, sum));
        prop_assert_eq!((same, sum), expected);
    }
}

#[test]
fn what_cannot_be_counted_stays_as_it_is() {
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.4e10, -1e300, f64::MAX] {
        let (remainder, turns) = reduced(x, 7);
        assert!(remainder.to_bits() == x.to_bits() && turns == 7);
        #[allow(clippy::cast_possible_truncation, reason = "any number will do")]
        let single = x as f32;
        let (remainder, turns) = reduced(single, 7);
        assert!(remainder.to_bits() == single.to_bits() && turns == 7);
    }
    for x in [0.0, -0.0, 1.0, -3.0, f64::MIN_POSITIVE] {
        assert_eq!(reduced(x, 3), (x, 3));
    }
}
