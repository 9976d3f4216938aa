//! Lines and figures whose sizes are in pixels.

use crate::{Canvas, Outline, Pose, Real, Scalar};

/// The widths of lines, in pixels.
pub(super) const BOLD: f32 = 2.0;
pub(super) const MEDIUM: f32 = 1.5;
pub(super) const THIN: f32 = 1.0;

/// A pen that draws symbols. It is given canvases as `dyn Canvas`: symbols are compiled once, not again for each kind of canvas.
#[derive(Clone, Copy)]
pub(super) struct Pen<T> {
    /// The size of a pixel in scene units, times the size of all symbols.
    pixel: T,
    ink: u8,
    pub(super) paper: u8,
}

/// A place on something that moves, and a direction there: symbols are painted with its pose, so that they are known to move with it.
#[derive(Clone, Copy)]
pub(super) struct Spot<T> {
    /// The pose of what moves.
    pub(super) pose: Pose<T>,
    /// The place and the direction in its frame.
    pub(super) own: Pose<T>,
}

/// A pose at a place, in a direction of length one.
pub(super) fn looking<T>([x, y]: [T; 2], [cos, sin]: [T; 2]) -> Pose<T> {
    Pose { cos, sin, x, y }
}

impl<T: Scalar> Spot<T> {
    /// The spot of something at a pose in the scene.
    pub(super) fn at(pose: Pose<T>) -> Self {
        let own = Pose::identity();
        Self { pose, own }
    }

    /// A place in the scene, upright.
    pub(super) fn upright(at: [T; 2]) -> Self {
        Self::at(looking(at, [T::ONE, T::ZERO]))
    }

    /// The first of two places, looking at the other, and their distance in scene units; none if that is no number, or zero.
    pub(super) fn between([from, to]: [[T; 2]; 2]) -> Option<(Self, T)> {
        let [x, y] = [to[0] - from[0], to[1] - from[1]];
        let length = Real::sqrt(x * x + y * y);
        let along = [x / length, y / length];
        let spot = Self::at(looking(from, along));
        (Real::is_finite(length) && length > T::ZERO).then_some((spot, length))
    }
}

impl<T: Scalar> Pen<T> {
    pub(super) fn new(canvas: &dyn Canvas<T>, size: f32, ink: u8, paper: u8) -> Self {
        Self { pixel: T::from_f32(size) / canvas.scale(), ink, paper }
    }

    /// Converts pixels to scene units.
    pub(super) fn pixels(&self, pixels: f32) -> T {
        self.pixel * T::from_f32(pixels)
    }

    /// Converts scene units to pixels.
    pub(super) fn in_pixels(&self, length: T) -> f32 {
        (length / self.pixel).to_f32()
    }

    /// A line through places that are given in scene units from a spot.
    pub(super) fn line<const N: usize>(
        &self,
        canvas: &mut dyn Canvas<T>,
        spot: Spot<T>,
        places: [[T; 2]; N],
        width: f32,
    ) {
        let points = &places.map(|place| spot.own.apply(place));
        let width = self.pixels(width);
        canvas.fill(Outline::Line { points, width }, spot.pose, self.ink);
    }

    /// A line, in pixels from a spot.
    pub(super) fn stroke<const N: usize>(
        &self,
        canvas: &mut dyn Canvas<T>,
        spot: Spot<T>,
        places: [[f32; 2]; N],
        width: f32,
    ) {
        let places = places.map(|place| place.map(|part| self.pixels(part)));
        self.line(canvas, spot, places, width);
    }

    /// A line of the usual width, in pixels from a spot.
    pub(super) fn path<const N: usize>(
        &self,
        canvas: &mut dyn Canvas<T>,
        spot: Spot<T>,
        places: [[f32; 2]; N],
    ) {
        self.stroke(canvas, spot, places, MEDIUM);
    }

    /// A filled polygon, in pixels from a spot.
    pub(super) fn fill<const N: usize>(
        &self,
        canvas: &mut dyn Canvas<T>,
        spot: Spot<T>,
        corners: [[f32; 2]; N],
        color: u8,
    ) {
        let corners = corners.map(|place| spot.own.apply(place.map(|part| self.pixels(part))));
        canvas.fill(Outline::Polygon(&corners), spot.pose, color);
    }

    /// A polygon of paper with an edge, in pixels from a spot.
    pub(super) fn figure<const N: usize>(
        &self,
        canvas: &mut dyn Canvas<T>,
        spot: Spot<T>,
        corners: [[f32; 2]; N],
    ) {
        self.fill(canvas, spot, corners, self.paper);
        self.path(canvas, spot, corners);
        if let (Some(&first), Some(&last)) = (corners.first(), corners.last()) {
            self.path(canvas, spot, [last, first]);
        }
    }

    /// A full dot of a radius in pixels.
    pub(super) fn dot(&self, canvas: &mut dyn Canvas<T>, spot: Spot<T>, radius: f32) {
        self.disc(canvas, spot, radius, self.ink);
    }

    /// A small circle of paper with an edge, of a radius in pixels.
    pub(super) fn eye(&self, canvas: &mut dyn Canvas<T>, spot: Spot<T>, radius: f32) {
        self.disc(canvas, spot, radius, self.ink);
        self.disc(canvas, spot, radius - MEDIUM, self.paper);
    }

    fn disc(&self, canvas: &mut dyn Canvas<T>, spot: Spot<T>, radius: f32, color: u8) {
        let circle =
            Outline::Circle { center: [spot.own.x, spot.own.y], radius: self.pixels(radius) };
        canvas.fill(circle, spot.pose, color);
    }

    /// A row of so many short strokes beneath a line along a spot, from `from` pixels ahead of it, `step` apart.
    pub(super) fn hatch(
        &self,
        canvas: &mut dyn Canvas<T>,
        spot: Spot<T>,
        (from, step, count): (f32, f32, u8),
        side: f32,
    ) {
        const LENGTH: f32 = 5.0;
        for number in 0..count {
            let ahead = from + step * f32::from(number);
            let ends = [[ahead, 0.0], [ahead - LENGTH, side * LENGTH]];
            self.stroke(canvas, spot, ends, THIN);
        }
    }

    /// An arc about a place that is given in scene units from a spot, as is its start, through so many radians to the left.
    pub(super) fn arc(
        &self,
        canvas: &mut dyn Canvas<T>,
        spot: Spot<T>,
        [center, start]: [[T; 2]; 2],
        angle: T,
        width: f32,
    ) {
        let arc = Outline::Arc {
            center: spot.own.apply(center),
            start: spot.own.apply(start),
            angle,
            width: self.pixels(width),
        };
        canvas.fill(arc, spot.pose, self.ink);
    }

    /// The entry of the palette for lines.
    pub(super) fn ink(&self) -> u8 {
        self.ink
    }
}
