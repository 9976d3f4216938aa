//! Whether Newton's iteration stays with the solution that it started from.
//!
//! After Kantorovich: where each step is much smaller than the one before, the solution is near and the only one there. Else
//! the iteration wanders, and may end in another assembly of the mechanism.

use crate::Real;

/// The square of a step is at most this part of that of the step before.
const PART: f64 = 1.0 / 16.0;
/// Steps whose square is less are small enough: between solutions so near each other the determinant's sign tells.
const SMALL: f64 = 1e-6;

/// The square of a step before the first: which is half a radian at most, or half the size of its loop.
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
