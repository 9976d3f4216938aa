//! The part of the scene that is seen.

use crate::{Pose, Scalar};

/// The part of the scene that a picture shows: the point at its centre, and the number of pixels per scene unit.
///
/// The scene's y axis points up. A view is usable whatever numbers it is made from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    center: [f64; 2],
    scale: f64,
}

impl View {
    /// A view of a point of the scene, with `scale` pixels per scene unit.
    ///
    /// A centre that is not finite becomes the scene's origin. A scale that is not finite and positive becomes 1.
    #[must_use]
    pub const fn new(center: [f64; 2], scale: f64) -> Self {
        let [x, y] = center;
        let center = if x.is_finite() && y.is_finite() { center } else { [0.0, 0.0] };
        let scale = if scale.is_finite() && scale > 0.0 { scale } else { 1.0 };
        Self { center, scale }
    }

    /// The view that fits an upright box into a picture of this width and height in pixels. The corners `low` and `high` of the box are in
    /// scene units. `margin` pixels stay free on every side.
    ///
    /// A box that is a point counts as one unit wide.
    #[must_use]
    pub fn fit(low: [f64; 2], high: [f64; 2], width: usize, height: usize, margin: f64) -> Self {
        let [x_middle, x_half] = middle_and_half(low[0], high[0]);
        let [y_middle, y_half] = middle_and_half(low[1], high[1]);
        let margin = if margin.is_finite() { margin } else { 0.0 };
        let room = |pixels: usize| {
            #[expect(clippy::cast_precision_loss, reason = "no picture is 2⁵² pixels wide")]
            let pixels = pixels as f64;
            (pixels - 2.0 * margin).max(1.0)
        };
        // A division by 0 is infinite: that side does not limit the scale.
        let scale = (room(width) / x_half).min(room(height) / y_half) / 2.0;
        let scale = if scale == f64::INFINITY { room(width).min(room(height)) } else { scale };
        Self::new([x_middle, y_middle], scale)
    }

    /// The point of the scene at the centre of the picture, in scene units.
    #[must_use]
    pub const fn center(self) -> [f64; 2] {
        self.center
    }

    /// The number of pixels per scene unit.
    #[must_use]
    pub const fn scale(self) -> f64 {
        self.scale
    }

    /// The projection for a picture of this width and height.
    pub(super) fn projection<T: Scalar>(self, size: [usize; 2]) -> Projection<T> {
        #[expect(clippy::cast_precision_loss, reason = "no picture is 2²⁴ pixels wide")]
        let middle = size.map(|pixels| T::from_f32(pixels as f32 / 2.0));
        Projection {
            center: self.center.map(<T as mech_core::Real>::from_f64),
            scale: <T as mech_core::Real>::from_f64(self.scale),
            middle,
        }
    }
}

/// The origin at the centre, one pixel per scene unit.
impl Default for View {
    fn default() -> Self {
        Self::new([0.0, 0.0], 1.0)
    }
}

/// Halved before they are added, so that the largest numbers do not overflow.
fn middle_and_half(low: f64, high: f64) -> [f64; 2] {
    [high / 2.0 + low / 2.0, (high / 2.0 - low / 2.0).abs()]
}

/// A view of a picture of known size, in the numbers of a mechanism. It is converted once for each shape.
#[derive(Clone, Copy)]
pub(super) struct Projection<T> {
    center: [T; 2],
    scale: T,
    middle: [T; 2],
}

impl<T: Scalar> Projection<T> {
    /// Converts a place in the scene to pixels from the picture's upper left corner.
    pub(super) fn point(self, [x, y]: [T; 2]) -> [T; 2] {
        [
            self.middle[0] + (x - self.center[0]) * self.scale,
            self.middle[1] - (y - self.center[1]) * self.scale,
        ]
    }

    /// Converts scene units to pixels.
    pub(super) fn length(self, length: T) -> T {
        length * self.scale
    }

    /// The place of a link at this pose.
    pub(super) fn of(self, pose: Pose<T>) -> Place<T> {
        Place {
            origin: self.point([pose.x, pose.y]),
            cos: pose.cos * self.scale,
            sin: pose.sin * self.scale,
        }
    }
}

/// The place of a link in the picture.
#[derive(Clone, Copy)]
pub(super) struct Place<T> {
    origin: [T; 2],
    /// Times the scale.
    cos: T,
    sin: T,
}

impl<T: Scalar> Place<T> {
    /// Converts a point of the link to pixels.
    #[inline]
    pub(super) fn point(self, [x, y]: [T; 2]) -> [T; 2] {
        [
            self.origin[0] + (self.cos * x - self.sin * y),
            self.origin[1] - (self.sin * x + self.cos * y),
        ]
    }
}
