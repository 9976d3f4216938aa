//! From coordinates to pixels and back: the centre of pixel `n` is at `n + 1/2`.

use crate::Scalar;
use nalgebra::{convert, convert_unchecked};

/// The first of the pixels `0..count` whose centre is at `position` or beyond; `count` if there is none.
pub(super) fn first_from<T: Scalar>(position: T, count: usize) -> usize {
    let index = position - <T as mech_core::Real>::from_f64(0.5);
    if index >= exact(count) {
        count
    } else if index > T::zero() {
        // Every whole number up to 2²⁴ is an `f32`, so narrowing an `f64` never carries it past the next one.
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "lies in 0..=count"
        )]
        let whole = convert_unchecked::<T, f32>(index) as usize;
        let below = exact::<T>(whole) < index;
        (whole + usize::from(below)).min(count)
    } else {
        0
    }
}

/// The centre of a pixel.
pub(super) fn center<T: Scalar>(index: usize) -> T {
    exact::<T>(index) + <T as mech_core::Real>::from_f64(0.5)
}

/// By way of `f32`, so that a machine that has no `f64` needs none.
fn exact<T: Scalar>(index: usize) -> T {
    #[expect(clippy::cast_precision_loss, reason = "no picture is 2²⁴ pixels wide")]
    convert::<f32, T>(index as f32)
}
