//! The sine and cosine of an angle in radians.
//!
//! Up to a limit of many thousand turns ([`LIMIT_F64`], [`LIMIT_F32`]) there is no branch, table or fused operation. So a loop over angles
//! vectorises on any processor. A larger angle is first reduced exactly, in whole numbers. The `within` functions do not test the limit. The
//! caller can test it once for a whole array:
//!
//! ```
//! use mech_core::trig::{LIMIT_F64, sin_cos_within_f64};
//!
//! let angles = [0.0, 0.5, 1.0, 1.5];
//! assert!(angles.iter().all(|angle: &f64| angle.abs() <= LIMIT_F64));
//! let (mut sines, mut cosines) = ([0.0; 4], [0.0; 4]);
//! for i in 0..4 {
//!     (sines[i], cosines[i]) = sin_cos_within_f64(angles[i]);
//! }
//! assert_eq!(sines[1], 0.479425538604203);
//! ```

use crate::kernel::ReducedAngle;
use crate::reduction::{reduce_large_f32, reduce_large_f64};

/// The greatest angle that [`sin_cos_within_f64`] takes: 2^18 right angles, 65536 turns.
pub const LIMIT_F64: f64 = 262_144.0 * core::f64::consts::FRAC_PI_2;

/// The greatest angle that [`sin_cos_within_f32`] takes: 2^13 right angles, 2048 turns.
pub const LIMIT_F32: f32 = 8192.0 * core::f32::consts::FRAC_PI_2;

/// The sine and cosine of an angle in radians, each within one ulp. Infinity and NaN give NaN.
///
/// ```
/// use mech_core::trig::sin_cos_f64;
///
/// assert_eq!(sin_cos_f64(0.0), (0.0, 1.0));
/// assert!(sin_cos_f64(f64::INFINITY).0.is_nan());
/// ```
#[inline]
#[must_use]
pub fn sin_cos_f64(x: f64) -> (f64, f64) {
    let remainder = if x.abs() <= LIMIT_F64 { reduce_within_f64(x) } else { reduce_large_f64(x) };
    remainder.sin_cos()
}

/// The sine and cosine of an angle in radians, each within 1e-7, in arithmetic of `f32` and whole numbers only. Infinity and NaN give NaN.
///
/// ```
/// use mech_core::trig::sin_cos_f32;
///
/// let (sine, cosine) = sin_cos_f32(1.0);
/// assert!((sine - 0.841_471).abs() < 1e-7 && (cosine - 0.540_302_3).abs() < 1e-7);
/// ```
#[inline]
#[must_use]
pub fn sin_cos_f32(x: f32) -> (f32, f32) {
    let remainder = if x.abs() <= LIMIT_F32 { reduce_within_f32(x) } else { reduce_large_f32(x) };
    remainder.sin_cos()
}

/// The same bits as [`sin_cos_f64`] for |x| <= [`LIMIT_F64`]. Beyond the limit the numbers are arbitrary, without a panic.
#[inline]
#[must_use]
pub fn sin_cos_within_f64(x: f64) -> (f64, f64) {
    reduce_within_f64(x).sin_cos()
}

/// Reduces an angle that is within the limit.
#[inline]
fn reduce_within_f64(x: f64) -> ReducedAngle<f64, u64> {
    // A float between 2^52 and 2^53 has no bits after the point, so adding this rounds to nearest and leaves the whole
    // number in the last bits of the sum, negative ones in two's complement.
    const MAGIC: f64 = 6_755_399_441_055_744.0;
    // A right angle in three parts. The first two have 35 bits, so that their products with 18 bits are exact.
    const HEAD: f64 = f64::from_bits(0x3FF9_21FB_5444_0000);
    const MIDDLE: f64 = f64::from_bits(0x3D86_8C23_4C4C_0000);
    const TAIL: f64 = f64::from_bits(0x3B29_8A2E_0370_7345);

    let sum = x * core::f64::consts::FRAC_2_PI + MAGIC;
    let count = sum - MAGIC;

    // Exact: both are multiples of the smaller one's last place, and the difference is less than one.
    let first = x - count * HEAD;
    let middle = count * MIDDLE;
    let second = first - middle;
    // Exact too, even if `first` is the smaller one: it is a multiple of the last place of `middle`.
    let lost = (first - second) - middle;
    // This is at most 2^-54, so it need not be added to the high part.
    let low = lost - count * TAIL;
    ReducedAngle { high: second, low, quadrant: sum.to_bits() }
}

/// The same bits as [`sin_cos_f32`] for |x| <= [`LIMIT_F32`]. Beyond the limit the numbers are arbitrary, without a panic.
#[inline]
#[must_use]
pub fn sin_cos_within_f32(x: f32) -> (f32, f32) {
    reduce_within_f32(x).sin_cos()
}

/// Reduces an angle that is within the limit.
#[inline]
fn reduce_within_f32(x: f32) -> ReducedAngle<f32, u32> {
    // As above, between 2^23 and 2^24.
    const MAGIC: f32 = 12_582_912.0;
    // A right angle in three parts. The first two have 8 and 11 bits, so that their products with 13 bits are exact.
    const HEAD: f32 = f32::from_bits(0x3FC9_0000);
    const MIDDLE: f32 = f32::from_bits(0x39FD_A000);
    const TAIL: f32 = f32::from_bits(0x33A2_2169);

    let sum = x * core::f32::consts::FRAC_2_PI + MAGIC;
    let count = sum - MAGIC;

    // Both differences are exact, because the parts end well above the last place of what is left.
    let second = (x - count * HEAD) - count * MIDDLE;
    let remainder = count * TAIL;
    let high = second - remainder;
    let low = (second - high) - remainder;
    ReducedAngle { high, low, quadrant: sum.to_bits() }
}
