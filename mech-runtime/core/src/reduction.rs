//! The remainder of an angle of any size modulo right angles, after Payne and Hanek.
//!
//! A float is a whole number m times a power of two, and so is a bit of 2/pi. Products of m with high bits of 2/pi are whole turns. Products
//! with low bits are too small to matter. Between them is a window of a few words, whose product in whole numbers is exact.

use crate::kernel::ReducedAngle;
use crate::phase::{HEAD_F32, TAIL_F32};
use crate::power::{power_f32, power_f64};

/// 2/pi in words of 32 bits, after two words of zeros: bit `i` from the left is worth 2^(63 - i).
const RIGHT_ANGLES: [u32; 39] = [
    0x0000_0000,
    0x0000_0000,
    0xA2F9_836E,
    0x4E44_1529,
    0xFC27_57D1,
    0xF534_DDC0,
    0xDB62_9599,
    0x3C43_9041,
    0xFE51_63AB,
    0xDEBB_C561,
    0xB724_6E3A,
    0x424D_D2E0,
    0x0649_2EEA,
    0x09D1_921C,
    0xFE1D_EB1C,
    0xB129_A73E,
    0xE882_35F5,
    0x2EBB_4484,
    0xE99C_7026,
    0xB45F_7E41,
    0x3991_D639,
    0x8353_39F4,
    0x9C84_5F8B,
    0xBDF9_283B,
    0x1FF8_97FF,
    0xDE05_980F,
    0xEF2F_118B,
    0x5A0A_6D1F,
    0x6D36_7ECF,
    0x27CB_09B7,
    0x4F46_3F66,
    0x9E5F_EA2D,
    0x7527_BAC7,
    0xEBE5_F17B,
    0x3D07_39F7,
    0x8A52_92EA,
    0x6BFB_5FB1,
    0x1F8D_5D08,
    0x5603_3046,
];

/// The words that an `f32` can need: a program without `f64` keeps no others.
const RIGHT_ANGLES_F32: [u32; 7] = {
    let [_, a, b, c, d, e, f, g, ..] = RIGHT_ANGLES;
    [a, b, c, d, e, f, g]
};

/// Reduces an angle in radians of at least 2^-7, with an error of 2^-40 turn. Infinity and NaN give NaN.
#[cold]
#[expect(clippy::cast_precision_loss, reason = "both parts are small")]
pub(crate) fn reduce_large_f32(x: f32) -> ReducedAngle<f32, u32> {
    const HIDDEN: u32 = 1 << 23;
    if !x.is_finite() {
        return ReducedAngle { high: f32::NAN, low: 0.0, quadrant: 0 };
    }
    let bits = x.to_bits();
    let whole = bits & (HIDDEN - 1) | HIDDEN;
    // |x| is whole * 2^(biased - 150), and bit `i` is worth 2^(31 - i): bit `at` times 2^(biased - 150) is two right angles.
    let at = (bits >> 23 & 0xFF).saturating_sub(120);
    let window = shift(words_from(&RIGHT_ANGLES_F32, at), at);
    // The first half, in units of 2^-30 right angles: finer than the kernel can distinguish.
    let size = window.wrapping_mul(u64::from(whole)) >> 32;
    let turn = size as u32;
    let turn = if x < 0.0 { turn.wrapping_neg() } else { turn };
    let quadrant = turn.wrapping_add(1 << 29) >> 30;
    let remainder = turn.wrapping_sub(quadrant << 30).cast_signed();
    let upper = (remainder + (1 << 12)) >> 13;
    let lower = remainder - (upper << 13);
    // The first product is exact, and so is the error of the sum.
    let (upper, lower) = (upper as f32, lower as f32);
    let main = upper * (HEAD_F32 * power_f32(-19));
    let minor =
        upper * (TAIL_F32 * power_f32(-19)) + lower * (core::f32::consts::TAU * power_f32(-32));
    let high = main + minor;
    ReducedAngle { high, low: (main - high) + minor, quadrant }
}

/// Reduces an angle in radians of at least 2^-10, with a relative error of 2^-61. Infinity and NaN give NaN.
#[cold]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "halves of what has twice the bits; the head has 53"
)]
pub(crate) fn reduce_large_f64(x: f64) -> ReducedAngle<f64, u64> {
    const HIDDEN: u64 = 1 << 52;
    // pi/2 in units of 2^-63.
    const RIGHT_ANGLE: u64 = 0xC90F_DAA2_2168_C235;
    if !x.is_finite() {
        return ReducedAngle { high: f64::NAN, low: 0.0, quadrant: 0 };
    }
    let bits = x.to_bits();
    let whole = bits & (HIDDEN - 1) | HIDDEN;
    // |x| is whole * 2^(biased - 1075), and bit `i` is worth 2^(63 - i): bit `at` times 2^(biased - 1075) is two right angles.
    let at = (bits >> 52 & 0x7FF).saturating_sub(1013) as u32;
    let [a, b, c, d, e, f, g] = words_from(&RIGHT_ANGLES, at);
    let [first, second, third] = [[a, b, c], [c, d, e], [e, f, g]]
        .map(|words| u128::from(shift(words, at)) * u128::from(whole));
    // In units of 2^-126 right angles. No float is nearer than 2^-62 to their multiples, so 64 bits of the remainder are known.
    let product = (first << 64).wrapping_add(second).wrapping_add(third >> 64);
    let quadrant = product.wrapping_add(1 << 125) >> 126;
    let remainder = product.wrapping_sub(quadrant << 126).cast_signed();
    let size = remainder.unsigned_abs();
    let shift = size.leading_zeros();
    let top = (size.wrapping_shl(shift) >> 64) as u64;

    // Between 2^62 and 2^64, as `top` has its first bit, in units of 2^-(61 + shift).
    let radians = ((u128::from(top) * u128::from(RIGHT_ANGLE)) >> 64) as u64;
    let head = radians.wrapping_add(1 << 10) & !0x7FF;
    let tail = radians.wrapping_sub(head).cast_signed() as i32;
    let unit = power_f64(-61 - shift.cast_signed());
    let unit = if (remainder < 0) == (x < 0.0) { unit } else { -unit };
    let quadrant = quadrant as u64;
    ReducedAngle {
        high: head as f64 * unit,
        low: f64::from(tail) * unit,
        quadrant: if x < 0.0 { quadrant.wrapping_neg() } else { quadrant },
    }
}

/// The words from the one with this bit on, or zeros if there are too few.
fn words_from<const N: usize>(words: &[u32], bit: u32) -> [u32; N] {
    let words = words.get((bit >> 5) as usize..);
    let words = words.and_then(<[u32]>::first_chunk);
    words.copied().unwrap_or([0; N])
}

/// The first 64 of the 96 bits of three words after `by` bits, modulo 32.
fn shift(words: [u32; 3], by: u32) -> u64 {
    let [first, second, third] = words.map(u64::from);
    let by = by & 31;
    (first << 32 | second) << by | third << by >> 32
}
