//! Places of links in the picture.

use super::Sheet;
use super::number::{Number, decimals_of_factor, is_drawable, pixels};
use crate::{Pose, Real, Scalar};
use std::{format, string::String};

/// The place of a link's frame in pixels from the upper left corner, y down: a direction and the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub(super) cos: f64,
    pub(super) sin: f64,
    pub(super) x: f64,
    pub(super) y: f64,
}

impl Place {
    /// The place of the whole picture.
    pub(super) const PICTURE: Self = Self {
        cos: 1.0,
        sin: 0.0,
        x: 0.0,
        y: 0.0,
    };

    /// The place of a link on a sheet. `None` if it cannot be drawn there.
    pub(super) fn of<T: Scalar>(pose: Pose<T>, sheet: &Sheet) -> Option<Self> {
        let [cos, sin, x, y] = [pose.cos, pose.sin, pose.x, pose.y].map(Real::to_f64);
        let [center, scale] = [sheet.view.center(), [sheet.view.scale(); 2]];
        let [middle_x, middle_y] = sheet.middle();
        let place = Self {
            cos,
            sin: -sin,
            x: middle_x + (x - center[0]) * scale[0],
            y: middle_y - (y - center[1]) * scale[1],
        };
        place.is_drawable().then_some(place)
    }

    /// The place with the origin at one point and the axis through another.
    pub(super) fn through([x, y]: [f64; 2], [to_x, to_y]: [f64; 2]) -> Self {
        let [along, across] = [to_x - x, to_y - y];
        let length = along.hypot(across);
        let [cos, sin] = if length > 0.0 {
            [along / length, across / length]
        } else {
            [1.0, 0.0]
        };
        Self { cos, sin, x, y }
    }

    fn is_drawable(self) -> bool {
        let mut parts = [self.cos, self.sin, self.x, self.y].into_iter();
        parts.all(is_drawable)
    }

    /// Converts a point of the link to the picture.
    pub(super) fn apply(self, point: [f64; 2]) -> [f64; 2] {
        self.pose().apply(point)
    }

    /// Converts a point of the picture to the link.
    pub(super) fn relative(self, point: [f64; 2]) -> [f64; 2] {
        self.pose().relative(point)
    }

    const fn pose(self) -> Pose<f64> {
        let Self { cos, sin, x, y } = self;
        Pose { cos, sin, x, y }
    }

    /// The value of `transform` for figures that reach `extent` pixels from the origin.
    pub(super) fn transform(self, extent: f64) -> String {
        let [x, y] = [pixels(self.x), pixels(self.y)];
        if (self.cos, self.sin) == (1.0, 0.0) {
            return format!("translate({x} {y})");
        }
        let decimals = decimals_of_factor(extent);
        let [cos, sin, minus_sin] =
            [self.cos, self.sin, -self.sin].map(|factor| Number(factor, decimals));
        format!("matrix({cos} {sin} {minus_sin} {cos} {x} {y})")
    }
}
