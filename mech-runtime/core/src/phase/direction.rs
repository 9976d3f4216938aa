//! Conversion of phases to floats: radians, sines and cosines.
//!
//! A turn in radians is split into a head and a tail. The head has so few bits that its products with half of the phase's bits are exact.
//! The constants include the powers of two.

use super::Phase;
use crate::kernel::ReducedAngle;
use crate::power::{power_f32, power_f64};

/// The first 21 bits of 2 pi.
const HEAD_F64: f64 = f64::from_bits(0x4019_21FB_0000_0000);
/// The other bits, rounded.
const TAIL_F64: f64 = f64::from_bits(0x3EB5_110B_4611_A626);
/// The first 8 bits of 2 pi. They are exact to 12 bits.
pub(crate) const HEAD_F32: f32 = f32::from_bits(0x40C9_0000);
/// The other bits, rounded.
pub(crate) const TAIL_F32: f32 = f32::from_bits(0x3AFD_AA22);

impl Phase {
    /// The angle in radians, whole turns included, within one ulp.
    ///
    /// ```
    /// use core::f64::consts::{FRAC_PI_2, TAU};
    /// use mech_core::Phase;
    ///
    /// assert_eq!(Phase::of_turn(-1, 4).unwrap().radians(), -FRAC_PI_2);
    /// assert_eq!(Phase::new(1 << 40, 0).radians(), TAU * (1u64 << 40) as f64);
    /// ```
    #[must_use]
    pub fn radians(self) -> f64 {
        let units = self.units();
        let size = units.unsigned_abs();
        let shift = size.leading_zeros();
        // Zero has 128 of them. The relative error of cutting is less than 2^-63.
        let top = (size.checked_shl(shift).unwrap_or(0) >> 64) as u64;
        let radians = radians_f64(top, -shift.cast_signed());
        if units < 0 { -radians } else { radians }
    }

    /// The nearest whole number of turns, and the remainder in radians, within one ulp and in [-pi, pi]. Half a turn is rounded up. The ends
    /// of the interval are rounded too.
    ///
    /// ```
    /// use core::f64::consts::{FRAC_PI_2, PI};
    /// use mech_core::Phase;
    ///
    /// assert_eq!(Phase::of_turn(11, 4).unwrap().split_f64(), (3, -FRAC_PI_2));
    /// assert_eq!(Phase::of_turn(5, 2).unwrap().split_f64(), (3, -PI));
    /// ```
    #[must_use]
    pub fn split_f64(self) -> (i64, f64) {
        let (turns, remainder) = self.split();
        let size = remainder.unsigned_abs();
        let shift = size.leading_zeros();
        let top = size.checked_shl(shift).unwrap_or(0);
        let radians = radians_f64(top, -64 - shift.cast_signed());
        (turns, if remainder < 0 { -radians } else { radians })
    }

    /// The same as [`split_f64`](Self::split_f64), with the remainder in `f32`, in `f32` arithmetic only.
    #[must_use]
    pub fn split_f32(self) -> (i64, f32) {
        let (turns, remainder) = self.split();
        let size = remainder.unsigned_abs();
        let shift = size.leading_zeros();
        let top = (size.checked_shl(shift).unwrap_or(0) >> 32) as u32;
        let radians = radians_f32(top, -32 - shift.cast_signed());
        (turns, if remainder < 0 { -radians } else { radians })
    }

    /// The sine and cosine, each within one ulp for any number of turns. At whole quarters of a turn they are exact.
    ///
    /// ```
    /// use mech_core::Phase;
    ///
    /// let quarter = Phase::of_turn(1, 4).unwrap();
    /// assert_eq!((quarter * 4_000_000_000_001).sin_cos_f64(), (1.0, 0.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn sin_cos_f64(self) -> (f64, f64) {
        let (sine, cosine) = self.reduce_f64().sin_cos();
        // No negative zeros.
        (sine + 0.0, cosine + 0.0)
    }

    /// The nearest right angle and the remainder.
    #[inline]
    fn reduce_f64(self) -> ReducedAngle<f64, u64> {
        let (quadrant, remainder) = self.quadrant();
        let [high, low] = halves(remainder);
        let (high, low) = (f64::from(high), f64::from(low));

        // The first two are exact, and so is the error of their sum.
        let main = high * (HEAD_F64 * power_f64(-32));
        let minor = low * (HEAD_F64 * power_f64(-64));
        let sum = main + minor;
        let lost = (main - sum) + minor;
        let tail = high * (TAIL_F64 * power_f64(-32)) + low * (TAIL_F64 * power_f64(-64));
        let correction = lost + tail;
        let angle = sum + correction;
        ReducedAngle { high: angle, low: (sum - angle) + correction, quadrant }
    }

    /// The sine and cosine, each within 1e-7 for any number of turns, in `f32` arithmetic only. At whole quarters of a turn they are exact.
    ///
    /// ```
    /// use mech_core::Phase;
    ///
    /// let (sine, cosine) = Phase::of_turn(1_000_001, 6).unwrap().sin_cos_f32();
    /// assert!((sine - -0.866_025_4).abs() < 1e-7 && (cosine - 0.5).abs() < 1e-7);
    /// ```
    #[inline]
    #[must_use]
    pub fn sin_cos_f32(self) -> (f32, f32) {
        let (sine, cosine) = self.reduce_f32().sin_cos();
        // No negative zeros.
        (sine + 0.0, cosine + 0.0)
    }

    /// The nearest right angle and the remainder.
    #[inline]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_precision_loss,
        reason = "the halves fit, and the last bits are far below the rounding of the sum"
    )]
    pub(crate) fn reduce_f32(self) -> ReducedAngle<f32, u32> {
        let (quadrant, remainder) = self.quadrant();
        let [upper, last] = halves(remainder);
        let high = f32::from((upper.wrapping_add(1 << 15) >> 16) as i16);
        let low = f32::from(upper as i16);
        let last = last as f32 * (core::f32::consts::TAU * power_f32(-64));

        // The first two are exact, and so is the error of their sum.
        let main = high * (HEAD_F32 * power_f32(-16));
        let minor = low * (HEAD_F32 * power_f32(-32));
        let sum = main + minor;
        let lost = (main - sum) + minor;
        let tail = high * (TAIL_F32 * power_f32(-16)) + (low * (TAIL_F32 * power_f32(-32)) + last);
        let correction = lost + tail;
        let angle = sum + correction;
        ReducedAngle { high: angle, low: (sum - angle) + correction, quadrant: quadrant as u32 }
    }

    /// The nearest turn, and the units from there.
    #[inline]
    const fn split(self) -> (i64, i64) {
        let up = (self.fraction >> 63).cast_signed();
        (self.turns.wrapping_add(up), self.fraction.cast_signed())
    }

    /// The nearest quarter of a turn, and the units from there: at most an eighth.
    #[inline]
    const fn quadrant(self) -> (u64, u64) {
        let quadrant = self.fraction.wrapping_add(1 << 61) >> 62;
        (quadrant, self.fraction.wrapping_sub(quadrant << 62))
    }
}

/// The halves of a number of at most 2^61. The lower half has a sign too, so nothing cancels in their sum.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "these are the halves")]
const fn halves(remainder: u64) -> [i32; 2] {
    [(remainder.wrapping_add(1 << 31) >> 32) as i32, remainder.cast_signed() as i32]
}

/// `top * 2^exponent` turns in radians, within one ulp; the first bit of `top` is set, or none.
#[expect(clippy::cast_possible_truncation, reason = "these are the halves")]
fn radians_f64(top: u64, exponent: i32) -> f64 {
    let (high, low) = (f64::from((top >> 32) as u32), f64::from(top as u32));
    // Exact, and more than a million times the remainder.
    let main = high * HEAD_F64;
    let remainder = high * TAIL_F64 + low * (core::f64::consts::TAU * power_f64(-32));
    (main + remainder) * power_f64(exponent + 32)
}

/// `top * 2^exponent` turns in radians, within one ulp; the first bit of `top` is set, or none.
#[expect(clippy::cast_possible_truncation, reason = "these are the halves")]
fn radians_f32(top: u32, exponent: i32) -> f32 {
    let (high, low) = (f32::from((top >> 16) as u16), f32::from(top as u16));
    // Exact, and more than a thousand times the remainder.
    let main = high * HEAD_F32;
    let remainder = high * TAIL_F32 + low * (core::f32::consts::TAU * power_f32(-16));
    (main + remainder) * power_f32(exponent + 16)
}
