//! Powers of two, by their bits.

/// 2^`exponent`, for a float that is neither infinite nor subnormal.
pub(crate) const fn power_f64(exponent: i32) -> f64 {
    f64::from_bits((1023 + exponent as i64).cast_unsigned() << 52)
}

/// 2^`exponent`, for a float that is neither infinite nor subnormal.
pub(crate) const fn power_f32(exponent: i32) -> f32 {
    f32::from_bits((127 + exponent).cast_unsigned() << 23)
}
