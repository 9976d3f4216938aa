//! Sine and cosine between the diagonals, |angle| <= pi/4, and their rotation back to the quadrant of the angle.
//!
//! The angle has two parts: a float and its rounding error. The coefficients are minimax fits (Remez, one coefficient rounded at a
//! time). The error of the sine is relative to the sine, that of the cosine to one.

/// An angle as a number of right angles and a remainder `high + low` in radians.
pub(crate) struct ReducedAngle<T, Bits> {
    /// |high| <= pi/4, or a little more by rounding.
    pub(crate) high: T,
    /// Half an ulp of one at most.
    pub(crate) low: T,
    /// The number of right angles, modulo four, in the last two bits.
    pub(crate) quadrant: Bits,
}

impl ReducedAngle<f64, u64> {
    #[inline]
    pub(crate) fn sin_cos(self) -> (f64, f64) {
        rotate_f64(between_diagonals_f64(self.high, self.low), self.quadrant)
    }
}

impl ReducedAngle<f32, u32> {
    #[inline]
    pub(crate) fn sin_cos(self) -> (f32, f32) {
        rotate_f32(between_diagonals_f32(self.high, self.low), self.quadrant)
    }
}

/// Sine and cosine of `high + low` for |high| <= pi/4 and |low| <= 2^-53.
#[inline]
fn between_diagonals_f64(high: f64, low: f64) -> (f64, f64) {
    // Relative error 2^-57.9.
    const SIN: [f64; 6] = [
        -0.166_666_666_666_666_3,
        0.008_333_333_333_321_84,
        -0.000_198_412_698_293_585_22,
        2.755_731_353_851_109_6e-6,
        -2.505_073_438_863_279e-8,
        1.589_543_324_610_087e-10,
    ];
    // Absolute error 2^-64.
    const COS: [f64; 6] = [
        0.041_666_666_666_666_6,
        -0.001_388_888_888_887_447_4,
        2.480_158_728_967_152_3e-5,
        -2.755_731_440_102_23e-7,
        2.087_572_927_953_844_3e-9,
        -1.135_993_412_781_210_9e-11,
    ];
    let square = high * high;
    let fourth = square * square;

    // Two shorter chains instead of Horner's one: the sums do not wait for each other.
    let tail =
        SIN[1] + square * (SIN[2] + square * SIN[3]) + square * fourth * (SIN[4] + square * SIN[5]);
    let cube = square * high;
    let sine = high - ((square * (0.5 * low - cube * tail) - low) - cube * SIN[0]);

    let tail = square * (COS[0] + square * (COS[1] + square * COS[2]))
        + fourth * fourth * (COS[3] + square * (COS[4] + square * COS[5]));
    // 1 - square/2 is rounded, and the error is known exactly.
    let half = 0.5 * square;
    let first = 1.0 - half;
    let cosine = first + (((1.0 - first) - half) + (square * tail - high * low));
    (sine, cosine)
}

/// Sine and cosine of `high + low` for |high| <= pi/4 and |low| of half an ulp of it.
#[inline]
fn between_diagonals_f32(high: f32, low: f32) -> (f32, f32) {
    // Relative error 2^-27.9.
    const SIN: [f32; 3] = [-0.166_666_55, 0.008_332_189, -0.000_195_182_9];
    // Absolute error 2^-33.
    const COS: [f32; 3] = [0.041_666_645, -0.001_388_730_1, 2.443_066_8e-5];
    let square = high * high;

    let tail = SIN[1] + square * SIN[2];
    let cube = square * high;
    let sine = high - ((square * (0.5 * low - cube * tail) - low) - cube * SIN[0]);

    let tail = square * (COS[0] + square * (COS[1] + square * COS[2]));
    let half = 0.5 * square;
    let first = 1.0 - half;
    let cosine = first + (((1.0 - first) - half) + (square * tail - high * low));
    (sine, cosine)
}

/// Rotates a direction by `quadrant` right angles, modulo four, without a branch.
#[inline]
fn rotate_f64((sine, cosine): (f64, f64), quadrant: u64) -> (f64, f64) {
    let (sine, cosine) = (sine.to_bits(), cosine.to_bits());
    let swap = (sine ^ cosine) & (quadrant & 1).wrapping_neg();
    let sine_sign = (quadrant & 2) << 62;
    let cosine_sign = (quadrant.wrapping_add(1) & 2) << 62;
    (f64::from_bits(sine ^ swap ^ sine_sign), f64::from_bits(cosine ^ swap ^ cosine_sign))
}

/// Rotates a direction by `quadrant` right angles, modulo four, without a branch.
#[inline]
fn rotate_f32((sine, cosine): (f32, f32), quadrant: u32) -> (f32, f32) {
    let (sine, cosine) = (sine.to_bits(), cosine.to_bits());
    let swap = (sine ^ cosine) & (quadrant & 1).wrapping_neg();
    let sine_sign = (quadrant & 2) << 30;
    let cosine_sign = (quadrant.wrapping_add(1) & 2) << 30;
    (f32::from_bits(sine ^ swap ^ sine_sign), f32::from_bits(cosine ^ swap ^ cosine_sign))
}
