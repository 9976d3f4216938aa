//! Outlines of shapes.

use crate::{Pose, Real};

/// A coloured outline in the frame of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Shape<T, P> {
    /// The link: 0 is the ground, `n + 1` the moving link whose pose is `poses()[n]`.
    pub link: usize,
    /// The outline, in the frame of the link.
    pub outline: Outline<T, P>,
    /// The entry of the palette.
    pub color: u8,
}

/// The outline of a shape, in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Outline<T, P> {
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
    Polygon(P),
    /// A filled polygon, by the non-zero rule: a region surrounded twice in the same sense is filled.
    Winding(P),
    /// A thick line from point to point, with round ends and joins.
    Line {
        /// The points. A single one is a dot.
        points: P,
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

impl<T: Real, P: AsRef<[[T; 2]]>> Shape<T, P> {
    /// The upright box around the shape when its link is at `pose`: lower left and upper right corner, in scene units.
    #[must_use]
    pub fn bounds(&self, pose: Pose<T>) -> ([T; 2], [T; 2]) {
        self.outline.bounds(pose)
    }
}

impl<T: Copy, P> Outline<T, P> {
    /// The same with other numbers, and with other points.
    #[must_use]
    pub fn map<'s, U, Q>(
        &'s self,
        number: impl Fn(T) -> U,
        points: impl FnOnce(&'s P) -> Q,
    ) -> Outline<U, Q> {
        match self {
            Self::Circle { center, radius } => {
                Outline::Circle { center: center.map(&number), radius: number(*radius) }
            }
            Self::Ring { center, radius, hole } => Outline::Ring {
                center: center.map(&number),
                radius: number(*radius),
                hole: number(*hole),
            },
            Self::Polygon(corners) => Outline::Polygon(points(corners)),
            Self::Winding(corners) => Outline::Winding(points(corners)),
            Self::Line { points: places, width } => {
                Outline::Line { points: points(places), width: number(*width) }
            }
            Self::Arc { center, start, angle, width } => Outline::Arc {
                center: center.map(&number),
                start: start.map(&number),
                angle: number(*angle),
                width: number(*width),
            },
        }
    }

    /// All its numbers besides those of a list of points, in the order of its parts.
    pub fn numbers(&self) -> impl Iterator<Item = T> + use<T, P> {
        let (places, lengths) = match *self {
            Self::Circle { center, radius } => ([Some(center), None], [Some(radius), None]),
            Self::Ring { center, radius, hole } => {
                ([Some(center), None], [Some(radius), Some(hole)])
            }
            Self::Polygon(_) | Self::Winding(_) => ([None; 2], [None; 2]),
            Self::Line { width, .. } => ([None; 2], [Some(width), None]),
            Self::Arc { center, start, angle, width } => {
                ([center, start].map(Some), [angle, width].map(Some))
            }
        };
        let places = places.into_iter().flatten().flatten();
        places.chain(lengths.into_iter().flatten())
    }

    /// Its list of points, if it has one.
    pub const fn points(&self) -> Option<&P> {
        match self {
            Self::Polygon(points) | Self::Winding(points) | Self::Line { points, .. } => {
                Some(points)
            }
            Self::Circle { .. } | Self::Ring { .. } | Self::Arc { .. } => None,
        }
    }
}

impl<T: Real, P: AsRef<[[T; 2]]>> Outline<T, P> {
    /// The same, with borrowed points.
    #[must_use]
    pub fn borrowed(&self) -> Outline<T, &[[T; 2]]> {
        self.map(|number| number, AsRef::as_ref)
    }

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
            Self::Polygon(ref corners) | Self::Winding(ref corners) => {
                around(corners.as_ref(), pose)
            }
            Self::Line { ref points, width } => {
                let reach = T::HALF * width;
                let (low, high) = around(points.as_ref(), pose);
                (low.map(|part| part - reach), high.map(|part| part + reach))
            }
            Self::Arc { center, start, width, .. } => {
                let [x, y] = [start[0] - center[0], start[1] - center[1]];
                round(center, (x * x + y * y).sqrt() + T::HALF * width)
            }
        }
    }
}

/// The smallest upright box around points of a link.
fn around<T: Real>(points: &[[T; 2]], pose: Pose<T>) -> ([T; 2], [T; 2]) {
    let mut points = points.iter().map(|&point| pose.apply(point));
    let first = points.next().unwrap_or([pose.x, pose.y]);
    points.fold((first, first), |(low, high), [x, y]| {
        ([min(low[0], x), min(low[1], y)], [high[0].max(x), high[1].max(y)])
    })
}

fn min<T: Real>(a: T, b: T) -> T {
    -T::max(-a, -b)
}
