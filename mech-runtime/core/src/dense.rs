//! Dense linear systems, by elimination with partial pivoting.

use crate::Real;

/// Solves `rows · x = right`, stores the solution in `right` and returns the determinant. The size of the system is the length of `right`;
/// each row has at least as many numbers. A singular system gives a determinant of zero or numbers that are not finite.
#[inline]
pub fn solve<T: Real, R: AsRef<[T]> + AsMut<[T]>>(rows: &mut [R], right: &mut [T]) -> T {
    let count = right.len();
    let mut det = T::ONE;
    for pivot in 0..count {
        let mut best = pivot;
        for row in pivot + 1..count {
            if rows[row].as_ref()[pivot].abs() > rows[best].as_ref()[pivot].abs() {
                best = row;
            }
        }
        if best != pivot {
            rows.swap(best, pivot);
            right.swap(best, pivot);
            det = -det;
        }
        det = det * rows[pivot].as_ref()[pivot];
        for row in pivot + 1..count {
            let (above, below) = rows.split_at_mut(row);
            let (above, below) = (above[pivot].as_ref(), below[0].as_mut());
            let factor = below[pivot] / above[pivot];
            for (entry, over) in below.iter_mut().zip(above).skip(pivot + 1) {
                *entry = *entry - factor * *over;
            }
            right[row] = right[row] - factor * right[pivot];
        }
    }
    for row in (0..count).rev() {
        let entries = rows[row].as_ref();
        let mut sum = right[row];
        for column in row + 1..count {
            sum = sum - entries[column] * right[column];
        }
        right[row] = sum / entries[row];
    }
    det
}
