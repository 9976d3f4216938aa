//! Lines and figures whose sizes are in pixels.

use crate::raster::line;
use crate::{Canvas, Outline, Pose, Real, Scalar};

/// The widths of lines, in pixels.
pub(super) const BOLD: f32 = 2.0;
pub(super) const MEDIUM: f32 = 1.5;
pub(super) const THIN: f32 = 1.0;

/// A pen that draws symbols.
#[derive(Clone, Copy)]
pub(super) struct Pen<T> {
    /// The size of a pixel in scene units, times the size of all symbols.
    pixel: T,
    size: T,
    ink: u8,
    pub(super) paper: u8,
}

/// A place in the scene and a direction there.
#[derive(Clone, Copy)]
pub(super) struct Spot<T> {
    pub(super) at: [T; 2],
    /// A direction of length one.
    pub(super) along: [T; 2],
}

impl<T: Scalar> Spot<T> {
    /// A place, upright.
    pub(super) fn upright(at: [T; 2]) -> Self {
        let along = [T::ONE, T::ZERO];
        Self { at, along }
    }

    /// The first of two places, looking at the other, and their distance in scene units; none if that is no number, or zero.
    pub(super) fn between([from, to]: [[T; 2]; 2]) -> Option<(Self, T)> {
        let [x, y] = [to[0] - from[0], to[1] - from[1]];
        let length = Real::sqrt(x * x + y * y);
        let along = [x / length, y / length];
        (Real::is_finite(length) && length > T::ZERO).then_some((Self { at: from, along }, length))
    }

    /// The place at a distance ahead and to the left.
    pub(super) fn offset(&self, ahead: T, left: T) -> [T; 2] {
        let [u, v] = self.along;
        [
            self.at[0] + ahead * u - left * v,
            self.at[1] + ahead * v + left * u,
        ]
    }
}

impl<T: Scalar> Pen<T> {
    pub(super) fn new(canvas: &impl Canvas<T>, size: f32, ink: u8, paper: u8) -> Self {
        let size = T::from_f32(size);
        Self {
            pixel: size / canvas.scale(),
            size,
            ink,
            paper,
        }
    }

    /// Converts pixels to scene units.
    pub(super) fn pixels(&self, pixels: f32) -> T {
        self.pixel * T::from_f32(pixels)
    }

    /// Converts scene units to pixels.
    pub(super) fn in_pixels(&self, length: T) -> f32 {
        (length / self.pixel).to_f32()
    }

    /// A line between two places in the scene.
    pub(super) fn line(&self, canvas: &mut impl Canvas<T>, ends: [[T; 2]; 2], width: f32) {
        line(canvas, ends, self.size * T::from_f32(width), self.ink);
    }

    /// A line, in pixels from a spot.
    pub(super) fn stroke(
        &self,
        canvas: &mut impl Canvas<T>,
        spot: Spot<T>,
        ends: [[f32; 2]; 2],
        width: f32,
    ) {
        let ends = ends.map(|[x, y]| spot.offset(self.pixels(x), self.pixels(y)));
        self.line(canvas, ends, width);
    }

    /// A filled polygon, in pixels from a spot.
    pub(super) fn fill<const N: usize>(
        &self,
        canvas: &mut impl Canvas<T>,
        spot: Spot<T>,
        corners: [[f32; 2]; N],
        color: u8,
    ) {
        let corners = corners.map(|[x, y]| spot.offset(self.pixels(x), self.pixels(y)));
        canvas.fill(Outline::Polygon(&corners), Pose::identity(), color);
    }

    /// A polygon of paper with an edge, in pixels from a spot.
    pub(super) fn figure<const N: usize>(
        &self,
        canvas: &mut impl Canvas<T>,
        spot: Spot<T>,
        corners: [[f32; 2]; N],
    ) {
        self.fill(canvas, spot, corners, self.paper);
        self.path(
            canvas,
            spot,
            corners.last().copied().into_iter().chain(corners),
        );
    }

    /// A line from place to place, in pixels from a spot.
    pub(super) fn path(
        &self,
        canvas: &mut impl Canvas<T>,
        spot: Spot<T>,
        places: impl IntoIterator<Item = [f32; 2]>,
    ) {
        let mut last = None;
        for place in places {
            if let Some(last) = last.replace(place) {
                self.stroke(canvas, spot, [last, place], MEDIUM);
            }
        }
    }

    /// A full dot of a radius in pixels.
    pub(super) fn dot(&self, canvas: &mut impl Canvas<T>, center: [T; 2], radius: f32) {
        self.disc(canvas, center, radius, self.ink);
    }

    /// A small circle of paper with an edge, of a radius in pixels.
    pub(super) fn eye(&self, canvas: &mut impl Canvas<T>, center: [T; 2], radius: f32) {
        self.disc(canvas, center, radius, self.ink);
        self.disc(canvas, center, radius - MEDIUM, self.paper);
    }

    fn disc(&self, canvas: &mut impl Canvas<T>, center: [T; 2], radius: f32, color: u8) {
        let radius = self.pixels(radius);
        canvas.fill(Outline::Circle { center, radius }, Pose::identity(), color);
    }

    /// A row of short strokes beneath a line along a spot: from `from` to `to` pixels ahead of it, `step` apart.
    pub(super) fn hatch(
        &self,
        canvas: &mut impl Canvas<T>,
        spot: Spot<T>,
        (from, to, step): (f32, f32, f32),
        side: f32,
    ) {
        const LENGTH: f32 = 5.0;
        let mut ahead = from;
        while ahead <= to {
            let ends = [[ahead, 0.0], [ahead - LENGTH, side * LENGTH]];
            self.stroke(canvas, spot, ends, THIN);
            ahead += step;
        }
    }

    /// An arc about a centre, through so many radians to the left.
    pub(super) fn arc(
        &self,
        canvas: &mut impl Canvas<T>,
        center: [T; 2],
        start: [T; 2],
        angle: T,
        width: f32,
    ) {
        let arc = Outline::Arc {
            center,
            start,
            angle,
            width: self.pixels(width),
        };
        canvas.fill(arc, Pose::identity(), self.ink);
    }

    /// The entry of the palette for lines.
    pub(super) fn ink(&self) -> u8 {
        self.ink
    }
}
