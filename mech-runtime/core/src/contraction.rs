//! Whether Newton's iteration stays with the solution that it started from.
//!
//! After Kantorovich: where the first step times the rate at which the equations bend is less than a half, there is one solution
//! near, and the iteration ends in it. What the second step is of the first tells that product from below: a quarter would be
//! the half; an eighth is asked for, and that the first step is short. Else the iteration may end in another assembly.

use crate::Real;

/// The square of a step is at most this part of that of the step before.
const PART: f64 = 1.0 / 64.0;
/// Steps whose square is less are small enough: between solutions so near each other the determinant's sign tells.
const SMALL: f64 = 1e-6;

/// The square of a step before the first: which is a quarter of a radian at most, or a quarter of the size of its loop.
#[inline]
#[must_use]
pub fn before_first<T: Real>() -> T {
    T::from_f64(4.0)
}

/// Whether a step is much smaller than the one before, which it takes the place of. Both are squares.
#[inline]
pub fn contracts<T: Real>(before: &mut T, step: T) -> bool {
    let most = *before * T::from_f64(PART);
    *before = step;
    step <= most || step <= T::from_f64(SMALL)
}
