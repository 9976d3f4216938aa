//! Parts of whole turns, against the same in 128 bits and in `f64`.

use mech_core::motors::turned;
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
    fn what_is_left_is_exact(turns in any::<i32>(), numerator in any::<i64>(), denominator in denominator()) {
        let part = part(turns, numerator, denominator);
        // The part is rounded alike, so it is the same to the bit.
        prop_assert_eq!(turned::<f64>(turns, numerator, denominator), TAU * part);
        let angle: f32 = turned(turns, numerator, denominator);
        if denominator <= 1 << 24 {
            prop_assert_eq!(angle, std::f32::consts::TAU * part as f32);
        } else {
            // Five roundings: of both numbers, of their ratio, of a turn, and of the product.
            let most = TAU * part * f64::from(f32::EPSILON) * 2.5;
            prop_assert!((f64::from(angle) - TAU * part).abs() <= most);
        }
    }

    #[test]
    fn turns_of_a_small_part_come_round(turns in any::<i32>(), teeth in 1..1000_i64, other in 1..1000_i64) {
        let angle: f64 = turned(turns, teeth, other);
        prop_assert_eq!(angle, TAU * part(turns, teeth, other));
        prop_assert_eq!(turned::<f64>(turns, teeth * other, other), 0.0);
    }
}

#[test]
fn nothing_panics() {
    let numbers = [
        i64::MIN,
        i64::MIN + 1,
        -1,
        0,
        1,
        65_535,
        65_536,
        i64::MAX - 1,
        i64::MAX,
    ];
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
