//! Roots against those of the standard library, which are right by IEEE 754.

use mech_core::root::sqrt_f32;

/// Every so many floats, of both signs and those that are no numbers too.
fn scan(stride: usize) {
    for bits in (0..=u32::MAX).step_by(stride) {
        let x = f32::from_bits(bits);
        let (got, truth) = (sqrt_f32(x), x.sqrt());
        let is_same = got.to_bits() == truth.to_bits() || got.is_nan() && truth.is_nan();
        assert!(is_same, "{x:e}: {got:e}, not {truth:e}");
    }
}

#[test]
fn roots_are_rounded_to_nearest() {
    scan(997);
    // All mantissas, of an odd and of an even power of two.
    for bits in 1_f32.to_bits()..4_f32.to_bits() {
        let x = f32::from_bits(bits);
        assert_eq!(sqrt_f32(x), x.sqrt());
    }
}

#[test]
fn roots_of_what_is_special() {
    let subnormal = f32::from_bits(1);
    for x in [0.0, -0.0, f32::INFINITY, f32::MAX, f32::MIN_POSITIVE, subnormal] {
        assert_eq!(sqrt_f32(x).to_bits(), x.sqrt().to_bits());
    }
    for x in [-subnormal, -1.0, f32::NEG_INFINITY, f32::NAN, -f32::NAN] {
        assert!(sqrt_f32(x).is_nan());
    }
}

#[test]
#[ignore = "a minute in release: every f32 there is"]
fn every_root_is_rounded_to_nearest() {
    scan(1);
}
