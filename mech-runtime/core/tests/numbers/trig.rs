//! Sine and cosine of radians, against Taylor's series in twice the precision.

use crate::reference::{Dice, Taylor, error, error_in_ulp};
use mech_core::trig::{
    LIMIT_F32, LIMIT_F64, sin_cos_f32, sin_cos_f64, sin_cos_within_f32, sin_cos_within_f64,
};
use std::f64::consts::FRAC_PI_4;

const CASES: usize = 1_000_000;

/// The greatest errors seen, and where.
#[derive(Default)]
struct Worst(f64, f64);

impl Worst {
    fn see(&mut self, at: f64, error: f64) {
        if error > self.0 || error.is_nan() {
            *self = Self(error, at);
        }
    }
}

fn see_f64(taylor: &Taylor, worst: &mut Worst, x: f64) {
    let (got, truth) = (sin_cos_f64(x), taylor.sin_cos_of_radians(x));
    worst.see(x, error_in_ulp(got.0, truth.0));
    worst.see(x, error_in_ulp(got.1, truth.1));
    if x.abs() <= LIMIT_F64 {
        let within = sin_cos_within_f64(x);
        assert_eq!(got.0.to_bits(), within.0.to_bits());
        assert_eq!(got.1.to_bits(), within.1.to_bits());
    }
}

fn see_f32(taylor: &Taylor, worst: &mut Worst, x: f32) {
    let (got, truth) = (sin_cos_f32(x), taylor.sin_cos_of_radians(f64::from(x)));
    worst.see(f64::from(x), error(f64::from(got.0), truth.0));
    worst.see(f64::from(x), error(f64::from(got.1), truth.1));
    if x.abs() <= LIMIT_F32 {
        let within = sin_cos_within_f32(x);
        assert_eq!(got.0.to_bits(), within.0.to_bits());
        assert_eq!(got.1.to_bits(), within.1.to_bits());
    }
}

/// A random number of a random size, from 2^-30 to the limit.
fn any_size(dice: &mut Dice, limit: f64) -> f64 {
    let size = (dice.float() - 1.0) * 24.0;
    dice.float() * limit * size.exp2()
}

#[test]
fn the_reference_is_right() {
    let taylor = Taylor::new();
    // From a library of arbitrary precision: both parts of the sine and of the cosine.
    let known = [
        (
            0.5,
            [
                0x3FDE_AEE8_744B_05F0,
                0xBC57_89B4_3C9B_027D,
                0x3FEC_1528_065B_7D50,
                0xBC88_9211_1312_E828,
            ],
        ),
        (
            262_144.0,
            [
                0xBFB5_8809_C5CE_39B6,
                0x3C5A_5C08_71E1_2599,
                0xBFEF_E2F9_378C_3909,
                0x3C80_3E83_8E7A_278F,
            ],
        ),
        (
            100_001.25,
            [
                0xBFED_FCC4_F798_8D1D,
                0x3C66_C8B2_67DC_2F2B,
                0xBFD6_56C4_7D3E_BC26,
                0xBC44_53C0_781F_03C1,
            ],
        ),
    ];
    for (x, parts) in known {
        let (sine, cosine) = taylor.sin_cos_of_radians(x);
        let [a, b, c, d] = parts.map(f64::from_bits);
        assert_eq!((sine.0, cosine.0), (a, c));
        assert!((sine.1 - b).abs() < 1e-30 && (cosine.1 - d).abs() < 1e-30);
    }
}

#[test]
fn f64_is_within_one_ulp() {
    let (taylor, mut dice, mut worst) = (Taylor::new(), Dice(1), Worst::default());
    for _ in 0..CASES / 2 {
        see_f64(&taylor, &mut worst, dice.float() * LIMIT_F64);
        let x = any_size(&mut dice, LIMIT_F64);
        see_f64(&taylor, &mut worst, x);
    }
    println!("f64, random: {} ulp at {}", worst.0, worst.1);
    assert!(worst.0 <= 1.0);
}

#[test]
fn f64_is_within_one_ulp_where_it_is_hard() {
    let (taylor, mut worst) = (Taylor::new(), Worst::default());
    // The axes are where the angle cancels, the diagonals where the quadrant changes.
    for eighth in 0..=524_288_u32 {
        let x = f64::from(eighth) * FRAC_PI_4;
        for bits in x.to_bits().saturating_sub(2)..=x.to_bits() + 2 {
            // The cheap ones by the millions: all near the axes, some near the diagonals.
            if eighth % 2 == 0 || eighth < 10_000 {
                see_f64(&taylor, &mut worst, f64::from_bits(bits));
                see_f64(&taylor, &mut worst, -f64::from_bits(bits));
            }
        }
    }
    for x in [1e-300, f64::MIN_POSITIVE, 1e-20, 1e-9, 1e-8, 1e-5, 0.1] {
        see_f64(&taylor, &mut worst, x);
        see_f64(&taylor, &mut worst, -x);
    }
    for bits in LIMIT_F64.to_bits() - 4..LIMIT_F64.to_bits() + 4 {
        see_f64(&taylor, &mut worst, f64::from_bits(bits));
    }
    println!("f64, hard: {} ulp at {}", worst.0, worst.1);
    assert!(worst.0 <= 1.0);
}

#[test]
fn f32_is_within_a_ten_millionth() {
    let (taylor, mut dice, mut worst) = (Taylor::new(), Dice(2), Worst::default());
    #[allow(clippy::cast_possible_truncation, reason = "some number is wanted")]
    for _ in 0..CASES / 2 {
        let limit = f64::from(LIMIT_F32);
        see_f32(&taylor, &mut worst, (dice.float() * limit) as f32);
        let x = any_size(&mut dice, limit);
        see_f32(&taylor, &mut worst, x as f32);
    }
    println!("f32, random: {} at {}", worst.0, worst.1);
    assert!(worst.0 <= 1e-7);
}

#[test]
fn f32_is_within_a_ten_millionth_where_it_is_hard() {
    let (taylor, mut worst) = (Taylor::new(), Worst::default());
    #[allow(clippy::cast_possible_truncation, reason = "some number is wanted")]
    for eighth in 0..=16_384_u32 {
        let x = (f64::from(eighth) * FRAC_PI_4) as f32;
        for bits in x.to_bits().saturating_sub(3)..=x.to_bits() + 3 {
            see_f32(&taylor, &mut worst, f32::from_bits(bits));
            see_f32(&taylor, &mut worst, -f32::from_bits(bits));
        }
    }
    for x in [f32::MIN_POSITIVE, 1e-20, 1e-6, 1e-4, 0.1] {
        see_f32(&taylor, &mut worst, x);
    }
    for bits in LIMIT_F32.to_bits() - 4..LIMIT_F32.to_bits() + 4 {
        see_f32(&taylor, &mut worst, f32::from_bits(bits));
    }
    println!("f32, hard: {} at {}", worst.0, worst.1);
    assert!(worst.0 <= 1e-7);
}

#[test]
fn what_is_tiny_is_its_own_sine() {
    for x in [0.0, 5e-324, 1e-310, 1e-300, f64::MIN_POSITIVE, 1e-9] {
        for x in [x, -x] {
            let (sine, cosine) = sin_cos_f64(x);
            assert_eq!((sine.to_bits(), cosine), (x.to_bits(), 1.0));
        }
    }
    for x in [0.0, 1e-45, 1e-40, 1e-30, f32::MIN_POSITIVE, 1e-5] {
        for x in [x, -x] {
            let (sine, cosine) = sin_cos_f32(x);
            assert_eq!((sine.to_bits(), cosine), (x.to_bits(), 1.0));
        }
    }
}

#[test]
fn nothing_panics() {
    let mut dice = Dice(3);
    for x in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        let (sine, cosine) = sin_cos_f64(x);
        assert!(sine.is_nan() && cosine.is_nan());
        let (sine, cosine) = sin_cos_within_f64(x);
        assert!(sine.is_nan() && cosine.is_nan());
    }
    for x in [f32::INFINITY, f32::NEG_INFINITY, f32::NAN] {
        let (sine, cosine) = sin_cos_f32(x);
        assert!(sine.is_nan() && cosine.is_nan());
        let (sine, cosine) = sin_cos_within_f32(x);
        assert!(sine.is_nan() && cosine.is_nan());
    }
    for _ in 0..100_000 {
        let bits = dice.bits();
        let _ = sin_cos_within_f64(f64::from_bits(bits));
        let _ = sin_cos_f64(f64::from_bits(bits));
        let _ = sin_cos_within_f32(f32::from_bits((bits >> 32) as u32));
        let _ = sin_cos_f32(f32::from_bits((bits >> 32) as u32));
    }
}
