//! Phases: exact sums, and their radians, sines and cosines against Taylor's series in twice the precision.

use crate::reference::{Dice, Pair, Taylor, error, error_in_ulp};
use mech_core::Phase;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const CASES: usize = 1_000_000;
const UNIT: f64 = 1.0 / 18_446_744_073_709_551_616.0;

/// The true direction: the quarters are taken off in whole numbers.
fn direction(taylor: &Taylor, phase: Phase) -> (Pair, Pair) {
    let mut remainder = i128::from(phase.fraction());
    let mut quadrant = 0;
    while remainder > 1 << 61 {
        remainder -= 1 << 62;
        quadrant += 1;
    }
    let turns = Pair::whole(i64::try_from(remainder).unwrap(), UNIT);
    taylor.sin_cos(turns * Pair::tau(), quadrant)
}

/// Phases everywhere, and near the axes and the diagonals at all distances.
fn phases() -> impl Iterator<Item = Phase> {
    let mut dice = Dice(4);
    (0..CASES).map(move |case| {
        let (turns, bits) = (dice.bits().cast_signed(), dice.bits());
        let near = bits >> (dice.bits() % 64);
        let eighth = dice.bits() << 61;
        Phase::new(
            turns,
            match case % 4 {
                0 | 1 => bits,
                2 => eighth.wrapping_add(near),
                _ => eighth.wrapping_sub(near),
            },
        )
    })
}

fn edges() -> impl Iterator<Item = Phase> {
    (0..8_u64).flat_map(|eighth| {
        (0..64).flat_map(move |shift| {
            [0, 1, 2, 3, u64::MAX, u64::MAX - 1].map(|few: u64| {
                let near = few.wrapping_shl(shift);
                Phase::new(-1, (eighth << 61).wrapping_add(near))
            })
        })
    })
}

#[test]
fn directions_are_within_their_bounds() {
    let taylor = Taylor::new();
    let (mut worst, mut worst_f32) = (0.0_f64, 0.0_f64);
    for phase in phases().chain(edges()) {
        let truth = direction(&taylor, phase);
        let (sine, cosine) = phase.sin_cos_f64();
        for (got, truth) in [(sine, truth.0), (cosine, truth.1)] {
            let error = error_in_ulp(got, truth);
            assert!(error <= 1.0, "{phase:?}: {got} is {error} ulp off");
            worst = worst.max(error);
        }
        let (sine, cosine) = phase.sin_cos_f32();
        for (got, truth) in [(sine, truth.0), (cosine, truth.1)] {
            let error = error(f64::from(got), truth);
            assert!(error <= 1e-7, "{phase:?}: {got} is {error} off");
            worst_f32 = worst_f32.max(error);
        }
    }
    println!("phase: f64 {worst} ulp, f32 {worst_f32}");
}

#[test]
fn what_is_left_of_the_turns_is_within_one_ulp() {
    let (mut worst, mut worst_f32) = (0.0_f64, 0.0_f64);
    for phase in phases().chain(edges()) {
        let remainder = phase.fraction().cast_signed();
        let truth = Pair::whole(remainder, UNIT) * Pair::tau();
        let (turns, left) = phase.split_f64();
        assert_eq!(Phase::new(turns, 0) + Phase::new(remainder >> 63, phase.fraction()), phase);
        assert!(left.abs() <= PI);
        let off = error_in_ulp(left, truth);
        assert!(off <= 1.0, "{phase:?}: {left} is {off} ulp off");
        worst = worst.max(off);

        let (turns_f32, left) = phase.split_f32();
        assert_eq!(turns, turns_f32);
        assert!(left.abs() <= std::f32::consts::PI);
        if remainder != 0 {
            // An ulp of the lesser binade, if it is near a power of two.
            let size = truth.0.abs();
            let ulp = f64::from_bits(size.to_bits() & (0x7FF << 52)) * f64::from(f32::EPSILON);
            let off = error(f64::from(left), truth) / ulp;
            assert!(off <= 1.0, "{phase:?}: {left} is {off} ulp off");
            worst_f32 = worst_f32.max(off);
        } else {
            assert_eq!(left, 0.0);
        }
    }
    println!("split: f64 {worst} ulp, f32 {worst_f32} ulp");
}

#[test]
fn the_whole_angle_is_within_one_ulp() {
    let mut worst = 0.0_f64;
    for phase in phases() {
        // Of all sizes, and the turns and the fraction exact together.
        let phase = Phase::new(phase.turns() >> (phase.fraction() % 64), phase.fraction());
        let truth = (Pair::whole(phase.turns(), 1.0)
            + Pair::whole((phase.fraction() >> 1).cast_signed(), 2.0 * UNIT)
            + Pair::whole((phase.fraction() & 1).cast_signed(), UNIT))
            * Pair::tau();
        let off = error_in_ulp(phase.radians(), truth);
        assert!(off <= 1.0, "{phase:?}: {} is {off} ulp off", phase.radians());
        worst = worst.max(off);
    }
    println!("radians: {worst} ulp");
    assert_eq!(Phase::ZERO.radians(), 0.0);
    assert_eq!(Phase::new(i64::MIN, 0).radians(), -TAU * 2_f64.powi(63));
    assert_eq!(Phase::new(-1, u64::MAX).radians(), -TAU * UNIT);
}

#[test]
fn whole_quarters_are_exact_and_have_no_negative_zero() {
    let quarter = Phase::of_turn(1, 4).unwrap();
    let directions = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)];
    for count in -40..40_i64 {
        let (sine, cosine) = directions[usize::try_from(count.rem_euclid(4)).unwrap()];
        let got = (quarter * count).sin_cos_f64();
        assert_eq!((got.0.to_bits(), got.1.to_bits()), (f64::to_bits(sine), f64::to_bits(cosine)));
        #[allow(clippy::cast_possible_truncation, reason = "whole numbers")]
        let (sine, cosine) = (sine as f32, cosine as f32);
        let got = (quarter * count).sin_cos_f32();
        assert_eq!((got.0.to_bits(), got.1.to_bits()), (sine.to_bits(), cosine.to_bits()));
    }
}

#[test]
fn ten_million_turns_by_degrees() {
    const TURNS: i64 = 10_000_000;
    let degree = Phase::of_turn(1, 360).unwrap();
    let phase = degree * (360 * TURNS);
    let (turns, remainder) = phase.split_f64();
    assert_eq!(turns, TURNS);
    println!("after 1e7 turns by degrees: {remainder:e} rad");
    assert!(remainder.abs() < 1e-9);

    let step = degree * 7;
    let mut at = degree * (360 * TURNS) - step * 1000;
    for count in -1000..1000 {
        let angle = f64::from(7 * count) * (PI / 180.0);
        let (sine, cosine) = at.sin_cos_f64();
        assert!((sine - angle.sin()).abs() < 1e-9 && (cosine - angle.cos()).abs() < 1e-9);
        let (sine, cosine) = at.sin_cos_f32();
        assert!((f64::from(sine) - angle.sin()).abs() < 1e-5);
        assert!((f64::from(cosine) - angle.cos()).abs() < 1e-5);
        at += step;
    }
}

#[test]
fn ten_million_additions_are_exact() {
    let degree = Phase::of_turn(1, 360).unwrap();
    let back = Phase::from_degrees(-0.123).unwrap();
    let (mut forth, mut both) = (Phase::ZERO, Phase::new(-5, 77));
    for _ in 0..10_000_000 {
        forth += degree;
        both += degree;
        both -= back;
    }
    assert_eq!(forth, degree * 10_000_000);
    assert_eq!(both, Phase::new(-5, 77) + (degree - back) * 10_000_000);
}

#[test]
fn rational_parts_of_a_turn() {
    assert_eq!(Phase::of_turn(0, 7), Some(Phase::ZERO));
    assert_eq!(Phase::of_turn(1, 0), None);
    assert_eq!(Phase::of_turn(0, 0), None);
    assert_eq!(Phase::of_turn(1, 3), Some(Phase::new(0, u64::MAX / 3)));
    assert_eq!(Phase::of_turn(2, 3), Some(Phase::new(0, u64::MAX / 3 * 2 + 1)));
    assert_eq!(Phase::of_turn(i64::MAX, 1), Some(Phase::new(i64::MAX, 0)));
    assert_eq!(Phase::of_turn(i64::MIN, 1), Some(Phase::new(i64::MIN, 0)));
    assert_eq!(Phase::of_turn(1, u64::MAX), Some(Phase::new(0, 1)));
    assert_eq!(Phase::of_turn(i64::MIN, u64::MAX), Some(Phase::new(-1, (1 << 63) - 1)));
}

#[test]
fn floats_that_are_no_phases() {
    for read in [Phase::from_turns, Phase::from_degrees, Phase::from_radians] {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, -1e30] {
            assert_eq!(read(x), None);
        }
        for x in [0.0, -0.0, 5e-324, -1e-300] {
            assert_eq!(read(x), Some(Phase::ZERO));
        }
    }
    let limit = 2_f64.powi(63);
    assert_eq!(Phase::from_turns(limit), None);
    assert_eq!(Phase::from_turns(-limit), Some(Phase::new(i64::MIN, 0)));
    assert_eq!(Phase::from_turns(limit.next_down()), Some(Phase::new(i64::MAX - 1023, 0)));
    assert_eq!(Phase::from_turns(0.5 * UNIT), Some(Phase::new(0, 1)));
    assert_eq!(Phase::from_turns(0.49 * UNIT), Some(Phase::ZERO));
    assert_eq!(Phase::from_turns(-0.5 * UNIT), Some(Phase::new(-1, u64::MAX)));
    assert_eq!(Phase::from_degrees(360.0 * limit), None);
    assert_eq!(Phase::from_degrees(-360.0 * limit), Some(Phase::new(i64::MIN, 0)));
    assert_eq!(Phase::from_radians(TAU * limit * 1.000_001), None);
    assert!(Phase::from_radians(TAU * limit * 0.999_999).is_some());
}

#[test]
fn wrapping_never_panics() {
    let (most, least) = (Phase::new(i64::MAX, u64::MAX), Phase::new(i64::MIN, 0));
    let one = Phase::new(0, 1);
    assert_eq!(most + one, least);
    assert_eq!(least - one, most);
    assert_eq!(-least, least);
    assert_eq!(most * 2, Phase::new(-1, u64::MAX - 1));
    assert_eq!(least * i64::MIN, Phase::ZERO);
    assert_eq!(most.split_f64(), (i64::MIN, -TAU * UNIT));
    assert_eq!(Phase::new(i64::MAX, 1 << 63).split_f64(), (i64::MIN, -PI));
    for phase in [most, least, one, Phase::ZERO] {
        let _ = (phase.sin_cos_f32(), phase.split_f32(), phase.radians());
    }
}

fn any_phase() -> impl Strategy<Value = Phase> {
    (any::<i64>(), any::<u64>()).prop_map(|(turns, fraction)| Phase::new(turns, fraction))
}

proptest! {
    #[test]
    fn adding_undoes_subtracting(a in any_phase(), b in any_phase()) {
        prop_assert_eq!(a + b - b, a);
        prop_assert_eq!(a - b + b, a);
        prop_assert_eq!(a + b, b + a);
        prop_assert_eq!(a - b, a + -b);
        prop_assert_eq!(a + -a, Phase::ZERO);
    }

    #[test]
    fn multiplying_is_adding_many_times(a in any_phase(), count in -200_i64..200) {
        let step = if count < 0 { -a } else { a };
        let sum = (0..count.abs()).fold(Phase::ZERO, |sum, _| sum + step);
        prop_assert_eq!(a * count, sum);
    }

    #[test]
    fn multiplying_is_linear(a in any_phase(), m in any::<i32>(), n in any::<i32>()) {
        let (m, n) = (i64::from(m), i64::from(n));
        prop_assert_eq!(a * m + a * n, a * (m + n));
        prop_assert_eq!(a * m * n, a * (m * n));
    }

    #[test]
    fn parts_of_a_turn_are_in_order(a in any::<i64>(), b in any::<i64>(), n in 1..=u64::MAX) {
        let (less, more) = (a.min(b), a.max(b));
        prop_assert!(Phase::of_turn(less, n).unwrap() <= Phase::of_turn(more, n).unwrap());
    }

    #[test]
    fn parts_of_a_turn_are_nearest(a in any::<i64>(), n in 1..=u64::from(u32::MAX)) {
        // |fraction - a / n| <= 1/2 in units, all times n.
        let phase = Phase::of_turn(a, n).unwrap();
        let whole = i128::from(a).div_euclid(i128::from(n));
        let remainder = u128::try_from(i128::from(a).rem_euclid(i128::from(n))).unwrap();
        let carry = i128::from(phase.turns()) - whole;
        prop_assert!(carry == 0 || carry == 1 && phase.fraction() == 0);
        let fraction = u128::from(phase.fraction()) + (u128::try_from(carry).unwrap() << 64);
        prop_assert!((fraction * u128::from(n)).abs_diff(remainder << 64) <= u128::from(n) / 2);
    }

    #[test]
    fn floats_come_back(turns in -1e15..1e15_f64) {
        let phase = Phase::from_turns(turns).unwrap();
        let whole = turns.floor();
        #[allow(clippy::cast_possible_truncation, reason = "a whole number")]
        let whole = (whole as i64, turns - whole);
        prop_assert_eq!(phase.turns(), whole.0);
        #[allow(clippy::cast_precision_loss, reason = "of a float, or above 1/2")]
        let fraction = phase.fraction() as f64 * UNIT;
        prop_assert_eq!(fraction, whole.1);
        prop_assert_eq!(Phase::from_turns(-turns), Some(-phase));
    }

    #[test]
    fn radians_come_back(exponent in -20..63_i32, part in 1.0..2.0_f64) {
        let radians = part * 2_f64.powi(exponent);
        let phase = Phase::from_radians(radians).unwrap();
        prop_assert!((phase.radians() - radians).abs() <= radians * f64::EPSILON + TAU * UNIT);
        prop_assert_eq!(Phase::from_radians(-radians), Some(-phase));
        // The direction is that of the float, not of another one near it.
        let (sine, cosine) = phase.sin_cos_f64();
        let truth = libm::sincos(radians);
        prop_assert!((sine - truth.0).abs() < 3e-16 && (cosine - truth.1).abs() < 3e-16);
    }

    #[test]
    fn degrees_are_parts_of_a_turn(numerator in any::<i32>(), shift in 0..20_u32) {
        let degrees = f64::from(numerator) / f64::from(1_u32 << shift);
        let exact = Phase::of_turn(i64::from(numerator), 360 << shift);
        prop_assert_eq!(Phase::from_degrees(degrees), exact);
    }

    #[test]
    fn order_is_the_angle(a in any_phase(), b in any_phase()) {
        prop_assert_eq!(a < b, a.radians() < b.radians() || a.radians() == b.radians() && a < b);
    }

    #[test]
    fn degrees_and_quarters(degrees in -100_000..100_000_i64) {
        let (turns, remainder) = (Phase::of_turn(1, 360).unwrap() * degrees).split_f64();
        #[allow(clippy::cast_precision_loss, reason = "small")]
        let angle = (degrees - 360 * turns) as f64 * (FRAC_PI_2 / 90.0);
        prop_assert!((remainder - angle).abs() < 1e-14 || (remainder + angle).abs() < 1e-14 && angle.abs() == PI);
    }
}
