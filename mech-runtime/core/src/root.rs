//! The square root of an `f32` without a standard library: in whole numbers, without a table or a division.

/// The square root, rounded to nearest: the same bits as any other correctly rounded root. A number below zero and NaN give NaN.
///
/// ```
/// use mech_core::root::sqrt_f32;
///
/// assert_eq!(sqrt_f32(2.0), 1.414_213_5);
/// assert!(sqrt_f32(-1.0).is_nan());
/// ```
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "the root has 24 bits")]
pub fn sqrt_f32(x: f32) -> f32 {
    const HIDDEN: u32 = 1 << 23;
    const INFINITE: u32 = f32::INFINITY.to_bits();
    let bits = x.to_bits();
    if x == 0.0 || bits == INFINITE {
        return x;
    }
    if bits > INFINITE {
        return f32::NAN;
    }
    // x = mantissa * 2^(biased - 150), and the mantissa has 24 bits also if x is subnormal.
    let missing = bits.leading_zeros().saturating_sub(8);
    let mantissa = (bits << missing) & (HIDDEN - 1) | HIDDEN;
    let biased = (bits >> 23).max(1).cast_signed() - missing.cast_signed();

    // Without an even power of two, the number is the mantissa or twice that, and its root is between one and two.
    let is_double = biased & 1 == 0;
    let number = mantissa << (7 + u32::from(is_double));
    let inverse = inverse_root(mantissa, is_double, number);
    // Never too great, and too small by less than one of its last places.
    let near = u64::from(upper(number, inverse) >> 7);
    let square = u64::from(number) << 16;
    // The square of half a place more than a root is this product and a quarter: no root is in the middle of two floats.
    let next = |root: u64| root + u64::from(square > root * (root + 1));
    let root = next(next(near)) as u32;

    let exponent = ((biased + 127) >> 1).cast_unsigned();
    f32::from_bits((exponent << 23).wrapping_add(root.wrapping_sub(HIDDEN)))
}

/// One by the root of `number`, which is in units of 2^-30 and is the mantissa or twice that. The result is in units of 2^-32, never too great,
/// and too small by no more than a few units of 2^-30.
fn inverse_root(mantissa: u32, is_double: bool, number: u32) -> u32 {
    // The root of a half.
    const HALF: u32 = 0xB504_F334;
    // Three in units of 2^-30, less a bound of the rounding, so that it is never too great.
    const THREE: u32 = (3 << 30) - 4;
    // A chord: 1.264 - 0.287 * mantissa.
    let chord = 0x439B_F2DC_u32.wrapping_sub(147 * mantissa);
    let mut inverse = if is_double { upper(chord, HALF) } else { chord };
    // Newton's steps reduce the error from 2.4% to 8.4e-4, to 1.1e-6, and to rounding.
    for _ in 0..3 {
        let square = upper(upper(number, inverse), inverse);
        inverse = upper(inverse, THREE - square) << 1;
    }
    inverse
}

/// The upper half of a product.
#[inline]
fn upper(a: u32, b: u32) -> u32 {
    ((u64::from(a) * u64::from(b)) >> 32) as u32
}
