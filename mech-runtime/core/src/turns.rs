//! Whole turns of an angle in radians, and the remainder, exact to its rounding.

/// The greatest number of turns that is counted.
const MOST_TURNS: f64 = 2_147_483_647.0;

/// The nearest whole number of turns, and the remainder in radians. `None` beyond 2³¹ turns.
pub(crate) fn whole_turns_f64(x: f64) -> Option<(i32, f64)> {
    // A turn in three parts. The first two have 22 bits, so that their products with 31 bits are exact.
    const HEAD: f64 = f64::from_bits(0x4019_21FB_0000_0000);
    const MIDDLE: f64 = f64::from_bits(0x3EB5_110B_0000_0000);
    const TAIL: f64 = f64::from_bits(0x3D51_8469_898C_C517);
    let count = libm::round(x * (1.0 / core::f64::consts::TAU));
    // Also false for NaN.
    let is_counted = count.abs() <= MOST_TURNS;
    if !is_counted {
        return None;
    }
    // Both differences are exact: the remainder has fewer bits than `x` and the product together.
    let remainder = (x - count * HEAD) - count * MIDDLE;
    #[expect(clippy::cast_possible_truncation, reason = "a whole number within the range")]
    let turns = count as i32;
    Some((turns, remainder - count * TAIL))
}

/// The same in whole numbers and `f32`, for processors without `f64`.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "each is within the range, and the fraction is rounded once"
)]
pub(crate) fn whole_turns_f32(x: f32) -> Option<(i32, f32)> {
    /// One divided by a turn, in units of 2⁻⁶⁴.
    const PER_RADIAN: u128 = 0x28BE_60DB_9391_054A;
    /// A smaller angle has no whole turns, and may have bits beyond 2⁻²².
    const LEAST: f32 = 3.0;
    /// An angle in units of 2⁻²² times `PER_RADIAN` is in units of 2⁻⁸⁶ turns.
    const UNIT: u32 = 86;
    /// The fraction of a turn has so many bits.
    const FRACTION: u32 = 31;
    let size = x.abs();
    if size < LEAST {
        return Some((0, x));
    }
    // Also false for NaN.
    let is_counted = size < 1.3e10;
    if !is_counted {
        return None;
    }
    let whole = (size * 4_194_304.0) as u64;
    let product = u128::from(whole) * PER_RADIAN;
    let nearest = (product + (1 << (UNIT - 1))) >> UNIT;
    let remainder = (product >> (UNIT - FRACTION)) as i64 - ((nearest as i64) << FRACTION);
    let remainder = remainder as f32 * (core::f32::consts::TAU / 2_147_483_648.0);
    let turns = nearest as i32;
    Some(if x < 0.0 { (-turns, -remainder) } else { (turns, remainder) })
}
