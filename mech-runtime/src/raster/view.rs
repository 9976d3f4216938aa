//! The part of the scene that is seen.

use crate::{Pose, Scalar};

/// Which point of the scene is at the centre of the picture, and how large a scene unit is there.
///
/// The scene's y axis points up. Whatever numbers a view is made from, it is a usable one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    center: [f64; 2],
    scale: f64,
}

impl View {
    /// Looks at a point of the scene, with `scale` pixels to a scene unit.
    ///
    /// A centre that is not finite is taken as the scene's origin, a scale that is not finite and positive as 1.
    #[must_use]
    pub const fn new(center: [f64; 2], scale: f64) -> Self {
        let [x, y] = center;
        let center = if x.is_finite() && y.is_finite() {
            center
        } else {
            [0.0, 0.0]
        };
        let scale = if scale.is_finite() && scale > 0.0 {
            scale
        } else {
            1.0
        };
        Self { center, scale }
    }

    /// Shows the upright box between two opposite corners as large as it goes into a picture of this size, with `margin`
    /// pixels left free on every side.
    ///
    /// A box that is a point is shown as though it were one unit wide.
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
        let scale = if scale == f64::INFINITY {
            room(width).min(room(height))
        } else {
            scale
        };
        Self::new([x_middle, y_middle], scale)
    }

    /// The point of the scene at the centre of the picture.
    #[must_use]
    pub const fn center(self) -> [f64; 2] {
        self.center
    }

    /// Pixels to a scene unit.
    #[must_use]
    pub const fn scale(self) -> f64 {
        self.scale
    }

    /// For a picture of this width and height.
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

/// The origin in the middle, a pixel a unit.
impl Default for View {
    fn default() -> Self {
        Self::new([0.0, 0.0], 1.0)
    }
}

/// Halved before they are added, so that the largest numbers do not overflow.
fn middle_and_half(low: f64, high: f64) -> [f64; 2] {
    [high / 2.0 + low / 2.0, (high / 2.0 - low / 2.0).abs()]
}

/// A view of a picture of known size, in the numbers of a mechanism: converted once a shape.
#[derive(Clone, Copy)]
pub(super) struct Projection<T> {
    center: [T; 2],
    scale: T,
    middle: [T; 2],
}

impl<T: Scalar> Projection<T> {
    /// From the scene to pixels, which count from the picture's upper left corner.
    pub(super) fn point(self, [x, y]: [T; 2]) -> [T; 2] {
        [
            self.middle[0] + (x - self.center[0]) * self.scale,
            self.middle[1] - (y - self.center[1]) * self.scale,
        ]
    }

    /// From scene units to pixels.
    pub(super) fn length(self, length: T) -> T {
        length * self.scale
    }

    /// From the frame of a link to pixels.
    pub(super) fn of(self, pose: Pose<T>) -> Place<T> {
        Place {
            origin: self.point([pose.x, pose.y]),
            cos: pose.cos * self.scale,
            sin: pose.sin * self.scale,
        }
    }
}

/// Where a link is in the picture.
#[derive(Clone, Copy)]
pub(super) struct Place<T> {
    origin: [T; 2],
    /// Times the scale.
    cos: T,
    sin: T,
}

impl<T: Scalar> Place<T> {
    /// From the frame of the link to pixels.
    #[inline]
    pub(super) fn point(self, [x, y]: [T; 2]) -> [T; 2] {
        [
            self.origin[0] + (self.cos * x - self.sin * y),
            self.origin[1] - (self.sin * x + self.cos * y),
        ]
    }
}
