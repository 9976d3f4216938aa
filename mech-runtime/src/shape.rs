//! Shapes of links.

use crate::{Pose, Real, Scalar};

/// A coloured outline in the frame of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape<T: 'static> {
    /// The link: 0 is the ground, `n + 1` the moving link whose pose is `poses()[n]`.
    pub link: usize,
    /// The outline, in the frame of the link.
    pub outline: Outline<'static, T>,
    /// The entry of the palette.
    pub color: u8,
}

/// The outline of a shape, in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outline<'p, T> {
    /// A filled circle.
    Circle {
        /// The centre.
        center: [T; 2],
        /// The radius.
        radius: T,
    },
    /// A circle with a hole.
    Ring {
        /// The centre of both.
        center: [T; 2],
        /// The radius of the circle.
        radius: T,
        /// The radius of the hole.
        hole: T,
    },
    /// A filled polygon, by the even-odd rule: a region surrounded twice is a hole.
    Polygon(&'p [[T; 2]]),
    /// A filled polygon, by the non-zero rule: a region surrounded twice in the same sense is filled.
    Winding(&'p [[T; 2]]),
    /// A thick line from point to point, with round ends and joins.
    Line {
        /// The points. A single one is a dot.
        points: &'p [[T; 2]],
        /// The width.
        width: T,
    },
    /// A thick arc with round ends.
    Arc {
        /// The centre.
        center: [T; 2],
        /// The start of its middle line.
        start: [T; 2],
        /// The angle around the centre, in radians, counter-clockwise. A whole turn is a ring.
        angle: T,
        /// The width.
        width: T,
    },
}

impl<T: Scalar> Shape<T> {
    /// The upright box around the shape when its link is at `pose`: lower left and upper right corner, in scene units.
    #[must_use]
    pub fn bounds(&self, pose: Pose<T>) -> ([T; 2], [T; 2]) {
        self.outline.bounds(pose)
    }
}

impl<T: Scalar> Outline<'_, T> {
    /// The upright box around the outline when its link is at `pose`: lower left and upper right corner, in scene units.
    ///
    /// It is the smallest box, except for an arc: there it is that of the whole circle. Without corners it is the link's origin.
    #[must_use]
    pub fn bounds(&self, pose: Pose<T>) -> ([T; 2], [T; 2]) {
        let round = |center: [T; 2], reach: T| {
            let [x, y] = pose.apply(center);
            ([x - reach, y - reach], [x + reach, y + reach])
        };
        match *self {
            Self::Circle { center, radius } | Self::Ring { center, radius, .. } => {
                round(center, radius)
            }
            Self::Polygon(corners) | Self::Winding(corners) => around(corners, pose),
            Self::Line { points, width } => {
                let reach = <T as Real>::HALF * width;
                let (low, high) = around(points, pose);
                (low.map(|part| part - reach), high.map(|part| part + reach))
            }
            Self::Arc {
                center,
                start,
                width,
                ..
            } => {
                let [x, y] = [start[0] - center[0], start[1] - center[1]];
                round(
                    center,
                    Real::sqrt(x * x + y * y) + <T as Real>::HALF * width,
                )
            }
        }
    }
}

/// The smallest upright box around points of a link.
fn around<T: Scalar>(points: &[[T; 2]], pose: Pose<T>) -> ([T; 2], [T; 2]) {
    let mut points = points.iter().map(|&point| pose.apply(point));
    let first = points.next().unwrap_or([pose.x, pose.y]);
    points.fold((first, first), |(low, high), [x, y]| {
        (
            [low[0].min(x), low[1].min(y)],
            [Real::max(high[0], x), Real::max(high[1], y)],
        )
    })
}
