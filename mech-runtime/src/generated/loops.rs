//! Tests that loops close, and the linear systems of coupled loops.

use super::Stop;
use crate::{Cause, Real, Scalar};

/// Tests the margins of loops in closed form: none may be negative.
///
/// # Errors
/// The first loop whose margin is negative or not a number.
#[inline]
pub fn closes<T: Scalar, const LOOPS: usize>(
    margins: [T; LOOPS],
    places: [&'static str; LOOPS],
) -> Result<(), Stop> {
    none_negative(margins, places, Cause::Open)
}

/// Tests that the rates of all loops are determined.
///
/// # Errors
/// The first loop whose margin is negative or not a number.
#[inline]
pub fn determined<T: Scalar, const LOOPS: usize>(
    margins: [T; LOOPS],
    places: [&'static str; LOOPS],
) -> Result<(), Stop> {
    none_negative(margins, places, Cause::Singular)
}

#[inline]
fn none_negative<T: Scalar, const LOOPS: usize>(
    margins: [T; LOOPS],
    places: [&'static str; LOOPS],
    cause: Cause,
) -> Result<(), Stop> {
    // NaN does not pass.
    let passes = |margin: T| margin >= T::ZERO;
    let mut loops = margins.into_iter().zip(places);
    match loops.find(|(margin, _)| !passes(*margin)) {
        None => Ok(()),
        Some((_, place)) => Err(Stop::new(place, cause)),
    }
}

/// Tests the result of a loop: its gap, and its determinant with the sign it has at the start.
///
/// # Errors
/// If the gap is greater than `accept` or the determinant less than `floor`, or either is not a number.
#[inline]
pub fn closed<T: Scalar, const N: usize>(
    gap: [T; N],
    accept: T,
    det: T,
    floor: T,
    place: &'static str,
) -> Result<(), Stop> {
    // Written so that NaN does not pass.
    let is_closed = gap.into_iter().all(|gap| Real::abs(gap) <= accept);
    if is_closed && det >= floor {
        Ok(())
    } else {
        Err(Stop::new(place, if is_closed { Cause::DeadPoint } else { Cause::Open }))
    }
}

/// The solution of `rows · x = right` by elimination with partial pivoting, and the determinant. A singular system gives a determinant of
/// zero or numbers that are not finite.
#[must_use]
pub fn solve<T: Scalar, const N: usize>(mut rows: [[T; N]; N], mut right: [T; N]) -> ([T; N], T) {
    let det = mech_core::dense::solve(&mut rows, &mut right);
    (right, det)
}
