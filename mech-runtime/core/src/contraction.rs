//! A test that Newton's iteration stays with the solution at which it started.
//!
//! By Kantorovich's theorem, the iteration converges to the only solution near if a product is less than a half. It is that of the first step
//! and the curvature of the equations. The ratio of the second step to the first bounds that product from below. A ratio of a quarter would
//! stand for the half. This test demands an eighth, and a short first step. Otherwise the iteration may end in another assembly.

use crate::Real;

/// The greatest ratio of the square of a step to that of the step before.
const PART: f64 = 1.0 / 64.0;
/// The square below which a step is always small enough. The determinant's sign distinguishes solutions that are so near each other.
const SMALL: f64 = 1e-6;

/// The square of the step before the first, which limits the first to a quarter of a radian or of the loop's size.
#[inline]
#[must_use]
pub fn before_first<T: Real>() -> T {
    T::from_f64(4.0)
}

/// Returns whether a step is much smaller than the one before, and stores it in its place. Both are squares of lengths.
#[inline]
pub fn contracts<T: Real>(before: &mut T, step: T) -> bool {
    let most = *before * T::from_f64(PART);
    *before = step;
    step <= most || step <= T::from_f64(SMALL)
}
