//! What generated code calls. Not for use by hand: it changes without notice.

use crate::{Canvas, Pose, Scalar, Shape};

/// Paints shapes that are already in painting order.
pub fn paint<T: Scalar>(shapes: &[Shape<T>], poses: &[Pose<T>], canvas: &mut impl Canvas<T>) {
    for shape in shapes {
        let pose = match shape.link.checked_sub(1) {
            None => Some(Pose::identity()),
            Some(index) => poses.get(index).copied(),
        };
        if let Some(pose) = pose {
            canvas.fill(shape.outline, pose, shape.color);
        }
    }
}
