//! Sine and cosine of radians beyond the limit, up to the greatest float.

use crate::reference::{Dice, Pair, Taylor, error, error_in_ulp};
use crate::remainder::Remainders;
use mech_core::trig::{LIMIT_F32, LIMIT_F64, sin_cos_f32, sin_cos_f64};

const CASES: usize = 300_000;

/// Whole numbers and exponents of two: of all floats, those nearest to multiples of a right angle.
const NEAREST: [(u64, i32); 14] = [
    (6_381_956_970_095_103, 797),
    (7_763_785_107_565_477, -29),
    (5_916_243_447_979_695, 79),
    (8_444_920_710_073_313, 939),
    (5_850_965_514_341_686, 525),
    (8_160_885_118_204_141, 808),
    (8_360_820_580_228_475, 628),
    (8_583_082_635_084_172, 145),
    (7_958_046_405_119_485, 243),
    (6_808_218_460_873_451, 562),
    (7_636_753_411_044_619, 201),
    (6_366_906_923_947_931, 194),
    (6_617_649_673_795_284, 15),
    (6_311_013_172_270_677, 38),
];

struct Truth {
    remainders: Remainders,
    taylor: Taylor,
}

impl Truth {
    fn new() -> Self {
        Self { remainders: Remainders::new(), taylor: Taylor::new() }
    }

    fn of(&self, x: f64) -> (Pair, Pair) {
        let (remainder, quadrant) = self.remainders.of(x);
        self.taylor.sin_cos(remainder, quadrant)
    }

    /// The greater error of the two, in ulp.
    fn off_f64(&self, x: f64) -> f64 {
        let ((sine, cosine), truth) = (sin_cos_f64(x), self.of(x));
        error_in_ulp(sine, truth.0).max(error_in_ulp(cosine, truth.1))
    }

    /// The greater error of the two.
    fn off_f32(&self, x: f32) -> f64 {
        let ((sine, cosine), truth) = (sin_cos_f32(x), self.of(f64::from(x)));
        error(f64::from(sine), truth.0).max(error(f64::from(cosine), truth.1))
    }
}

/// The exponents of the floats beyond a limit, as they stand in the bits.
fn exponents_f64() -> impl Iterator<Item = u64> {
    LIMIT_F64.to_bits() >> 52..0x7FF
}

fn exponents_f32() -> impl Iterator<Item = u32> {
    LIMIT_F32.to_bits() >> 23..0xFF
}

#[test]
fn the_reference_is_right() {
    let truth = Truth::new();
    // From a library of arbitrary precision: both parts of the sine and of the cosine.
    let known = [
        (
            6_381_956_970_095_103.0 * 2.0_f64.powi(797),
            [
                0x3FF0_0000_0000_0000,
                0xB842_B089_EA1E_692B,
                0xBC21_4AE7_2E6B_A22F,
                0x3897_3EEF_1477_D90E,
            ],
        ),
        (
            1e22,
            [
                0xBFEB_453A_B76B_F397,
                0xBC5F_4537_9077_2648,
                0x3FE0_BE2C_EF01_C8F4,
                0xBC8B_2D1B_C801_8C4F,
            ],
        ),
        (
            f64::MAX,
            [
                0x3F74_52FC_98B3_4E97,
                0xBC12_7BB1_93D9_60DF,
                0xBFEF_FFE6_2ECF_AB75,
                0xBC7E_038D_9340_70F1,
            ],
        ),
    ];
    for (x, parts) in known {
        let (sine, cosine) = truth.of(x);
        let [a, b, c, d] = parts.map(f64::from_bits);
        assert_eq!((sine.0, cosine.0), (a, c));
        assert!((sine.1 - b).abs() < 1e-30 * sine.0.abs() && (cosine.1 - d).abs() < 1e-30);
    }
    // Below the limit there is another one.
    let mut dice = Dice(5);
    for _ in 0..10_000 {
        let x = dice.float() * LIMIT_F64;
        if x.abs() >= 0.001 {
            let (one, other) = (truth.of(x), truth.taylor.sin_cos_of_radians(x));
            assert!((one.0 + -other.0).0.abs() < 1e-29);
            assert!((one.1 + -other.1).0.abs() < 1e-29);
        }
    }
}

#[test]
fn f64_is_within_one_ulp() {
    let (truth, mut dice, mut worst) = (Truth::new(), Dice(6), 0.0_f64);
    let exponents: Vec<u64> = exponents_f64().collect();
    for case in 0..CASES {
        let mantissa = dice.bits() >> 12;
        let x = f64::from_bits(exponents[case % exponents.len()] << 52 | mantissa);
        let off = truth.off_f64(x);
        assert!(off <= 1.0, "{x:e} is {off} ulp off");
        worst = worst.max(off);
    }
    println!("f64 beyond the limit: {worst} ulp");
}

#[test]
fn f64_is_within_one_ulp_where_it_is_hard() {
    let (truth, mut worst) = (Truth::new(), 0.0_f64);
    let mut see = |x: f64| {
        for x in [x, -x] {
            let off = truth.off_f64(x);
            assert!(off <= 1.0, "{x:e} is {off} ulp off");
            worst = worst.max(off);
        }
    };
    for (whole, exponent) in NEAREST {
        // Half of it is near a diagonal.
        for exponent in exponent - 2..exponent + 4 {
            let bits = whole ^ 1 << 52 | u64::try_from(exponent + 1075).unwrap() << 52;
            (bits - 2..=bits + 2).map(f64::from_bits).for_each(&mut see);
        }
    }
    for exponent in exponents_f64() {
        let power = exponent << 52;
        (power - 2..power + 3).map(f64::from_bits).for_each(&mut see);
    }
    let (least, most) = (LIMIT_F64.to_bits(), f64::MAX.to_bits());
    (least..least + 1000).map(f64::from_bits).for_each(&mut see);
    (most - 1000..=most).map(f64::from_bits).for_each(&mut see);
    println!("f64 beyond the limit, hard: {worst} ulp");
}

#[test]
fn what_is_nearest_to_the_axis_keeps_its_digits() {
    let x = 6_381_956_970_095_103.0 * 2.0_f64.powi(797);
    let (sine, cosine) = sin_cos_f64(x);
    assert_eq!(sine.abs(), 1.0);
    assert!((cosine.abs() / 4.687_165_924_254_624e-19 - 1.0).abs() < 1e-15);
}

#[test]
fn f32_is_within_a_ten_millionth() {
    let (truth, mut dice, mut worst) = (Truth::new(), Dice(7), 0.0_f64);
    let exponents: Vec<u32> = exponents_f32().collect();
    for case in 0..CASES {
        // The last bit becomes the sign.
        let random = u32::try_from(dice.bits() >> 40).unwrap();
        let (sign, mantissa) = (random << 31, random >> 1);
        let x = f32::from_bits(exponents[case % exponents.len()] << 23 | mantissa | sign);
        let off = truth.off_f32(x);
        assert!(off <= 1e-7, "{x:e} is {off} off");
        worst = worst.max(off);
    }
    println!("f32 beyond the limit: {worst}");
}

/// Every so many `f32` beyond the limit, against libm's sine and cosine of twice the precision.
fn scan_f32(stride: usize) {
    let mut worst = 0.0_f64;
    for bits in (LIMIT_F32.to_bits() + 1..f32::INFINITY.to_bits()).step_by(stride) {
        let x = f32::from_bits(bits);
        let ((sine, cosine), truth) = (sin_cos_f32(x), libm::sincos(f64::from(x)));
        let off = (f64::from(sine) - truth.0).abs();
        let off = off.max((f64::from(cosine) - truth.1).abs());
        assert!(off <= 1e-7, "{x:e} is {off} off");
        worst = worst.max(off);
        // The other sign is a mirror, to the bit.
        assert_eq!(sin_cos_f32(-x), (-sine, cosine));
    }
    println!("f32 beyond the limit, one in {stride}: {worst}");
}

#[test]
fn f32_agrees_with_twice_the_precision() {
    scan_f32(997);
}

#[test]
#[ignore = "a minute or two in release: every f32 there is"]
fn every_f32_agrees_with_twice_the_precision() {
    scan_f32(1);
}
