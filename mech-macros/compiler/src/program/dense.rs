//! A dense linear system, by elimination with partial pivoting, exactly as the generated code's runtime does it.

use mech_core::Real;

/// The solution of `rows · x = right`, and the determinant. What is singular gives a determinant of zero or numbers that are
/// not finite.
pub(crate) fn solve<T: Real>(mut rows: Vec<Vec<T>>, mut right: Vec<T>) -> (Vec<T>, T) {
    let count = right.len();
    let mut det = T::from_f64(1.0);
    for pivot in 0..count {
        let mut best = pivot;
        for row in pivot + 1..count {
            if rows[row][pivot].abs() > rows[best][pivot].abs() {
                best = row;
            }
        }
        if best != pivot {
            rows.swap(best, pivot);
            right.swap(best, pivot);
            det = -det;
        }
        det = det * rows[pivot][pivot];
        for row in pivot + 1..count {
            let factor = rows[row][pivot] / rows[pivot][pivot];
            let (above, below) = rows.split_at_mut(row);
            for (entry, over) in below[0].iter_mut().zip(&above[pivot]).skip(pivot + 1) {
                *entry = *entry - factor * *over;
            }
            right[row] = right[row] - factor * right[pivot];
        }
    }
    for row in (0..count).rev() {
        let mut sum = right[row];
        for column in row + 1..count {
            sum = sum - rows[row][column] * right[column];
        }
        right[row] = sum / rows[row][row];
    }
    (right, det)
}
