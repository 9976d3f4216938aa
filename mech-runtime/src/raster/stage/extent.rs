//! The hash and the rectangle of an item.

use super::item::{Item, mix};
use crate::raster::spans::Clip;
use crate::raster::view::Projection;
use crate::raster::{fixed, font};
use crate::{Outline, Pose, Real, Scalar};

/// The corners of an item, in pixels.
pub(super) struct Extent<T> {
    low: [T; 2],
    high: [T; 2],
    mark: u64,
    is_finite: bool,
    is_empty: bool,
    /// The distance by which it exceeds the box of its corners.
    reach: T,
}

impl<T: Scalar> Extent<T> {
    fn new(color: u8) -> Self {
        Self {
            low: [T::ZERO; 2],
            high: [T::ZERO; 2],
            mark: mix(0x5851_F42D_4C95_7F2D, color.into()),
            is_finite: true,
            is_empty: true,
            reach: T::ZERO,
        }
    }

    /// The extent of an outline in the frame of a link at `pose`.
    pub(super) fn of_outline(
        projection: Projection<T>,
        outline: Outline<'_, T>,
        pose: Pose<T>,
        color: u8,
    ) -> Self {
        let place = projection.of(pose);
        let mut extent = Self::new(color);
        extent.reach = match outline {
            Outline::Circle { center, radius } => {
                extent.add(place.point(center));
                extent.mix(1, [projection.length(radius)])
            }
            Outline::Ring { center, radius, hole } => {
                extent.add(place.point(center));
                extent.mix(2, [hole, radius].map(|length| projection.length(length)))
            }
            Outline::Polygon(corners) | Outline::Winding(corners) => {
                for &corner in corners {
                    extent.add(place.point(corner));
                }
                let kind = 3 + u64::from(matches!(outline, Outline::Winding(_)));
                extent.mix(kind, [T::ZERO])
            }
            Outline::Line { points, width } => {
                for &point in points {
                    extent.add(place.point(point));
                }
                extent.mix(5, [<T as Real>::HALF * projection.length(width)])
            }
            Outline::Arc { center, start, angle, width } => {
                let [center, [u, v]] = [center, start].map(|point| place.point(point));
                extent.add(center);
                let [x, y] = [u - center[0], v - center[1]];
                let half = <T as Real>::HALF * projection.length(width);
                let reach = Real::sqrt(x * x + y * y) + half;
                extent.mix(6, [u, v, angle, width, reach])
            }
        };
        extent
    }

    /// The extent of a text whose lower left corner is at a place in pixels.
    pub(super) fn of_text(place: [T; 2], text: &str, color: u8) -> Self {
        let mut extent = Self::new(color);
        extent.add(place);
        for character in text.chars() {
            extent.mark = mix(extent.mark, character.into());
        }
        let letters = i32::try_from(text.chars().count()).unwrap_or(i32::MAX);
        let wide = letters.saturating_add(2).saturating_mul(font::ADVANCE);
        extent.reach = extent.mix(7, [<T as Real>::from_i32(wide)]);
        extent
    }

    #[inline]
    fn add(&mut self, [x, y]: [T; 2]) {
        self.is_finite &= Real::is_finite(x) && Real::is_finite(y);
        if self.is_empty {
            (self.low, self.high, self.is_empty) = ([x, y], [x, y], false);
        }
        self.low = [self.low[0].min(x), self.low[1].min(y)];
        self.high = [Real::max(self.high[0], x), Real::max(self.high[1], y)];
        self.mark = mix(self.mark, bits(x) ^ bits(y).rotate_left(29));
    }

    /// Mixes in its kind and its other numbers. Returns the last number: the reach.
    fn mix<const K: usize>(&mut self, kind: u64, numbers: [T; K]) -> T {
        self.mark = mix(self.mark, kind);
        for number in numbers {
            self.mark = mix(self.mark, bits(number));
        }
        numbers.last().copied().unwrap_or(T::ZERO)
    }

    /// The item in a picture of this size.
    pub(super) fn item(&self, [width, height]: [usize; 2]) -> Item {
        let reach = self.reach;
        let clip = if self.is_finite && !self.is_empty && Real::is_finite(reach) {
            let ([left, top], [right, bottom]) = (self.low, self.high);
            let columns = fixed::rows_touching([left - reach, right + reach], width);
            let rows = fixed::rows_touching([top - reach, bottom + reach], height);
            Clip { left: columns.start, top: rows.start, right: columns.end, bottom: rows.end }
        } else {
            Clip::none()
        };
        let mark = self.mark;
        Item { mark, clip }
    }
}

/// The bits of a number as `f64`. Both zeros are the same.
#[inline]
fn bits<T: Scalar>(number: T) -> u64 {
    Real::to_f64(number + T::ZERO).to_bits()
}
