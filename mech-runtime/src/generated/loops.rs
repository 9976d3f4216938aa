//! Whether loops close, and the systems of coupled ones.

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
    // What is not a number does not pass.
    let passes = |margin: T| margin >= T::zero();
    match margins.into_iter().position(|margin| !passes(margin)) {
        None => Ok(()),
        Some(first) => Err(Stop::new(
            places.get(first).copied().unwrap_or_default(),
            Cause::Open,
        )),
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
    // So written that what is not a number does not pass.
    let is_closed = gap.into_iter().all(|gap| Real::abs(gap) <= accept);
    if is_closed && det >= floor {
        Ok(())
    } else {
        Err(Stop::new(
            place,
            if is_closed {
                Cause::DeadPoint
            } else {
                Cause::Open
            },
        ))
    }
}

/// The solution of `rows · x = right` by elimination with partial pivoting, and the determinant. What is singular gives a
/// determinant of zero or numbers that are not finite.
#[must_use]
pub fn solve<T: Scalar, const N: usize>(mut rows: [[T; N]; N], mut right: [T; N]) -> ([T; N], T) {
    let mut det = T::one();
    for pivot in 0..N {
        let mut best = pivot;
        for row in pivot + 1..N {
            if Real::abs(rows[row][pivot]) > Real::abs(rows[best][pivot]) {
                best = row;
            }
        }
        if best != pivot {
            rows.swap(best, pivot);
            right.swap(best, pivot);
            det = -det;
        }
        det *= rows[pivot][pivot];
        for row in pivot + 1..N {
            let factor = rows[row][pivot] / rows[pivot][pivot];
            let above = rows[pivot];
            for (entry, over) in rows[row].iter_mut().zip(above).skip(pivot + 1) {
                *entry -= factor * over;
            }
            right[row] -= factor * right[pivot];
        }
    }
    for row in (0..N).rev() {
        let mut sum = right[row];
        for column in row + 1..N {
            sum -= rows[row][column] * right[column];
        }
        right[row] = sum / rows[row][row];
    }
    (right, det)
}
