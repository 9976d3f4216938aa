//! Places of links in the picture.

use super::Sheet;
use super::number::{Number, is_drawable};
use crate::{Pose, Real, Scalar};
use core::f64::consts::{PI, TAU};
use core::fmt::Write;
use std::string::String;

/// The place of a link's frame: its origin in pixels from the upper left corner, y down, and its angle in radians to the right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    x: f64,
    y: f64,
    angle: f64,
}

impl Place {
    /// The place of a link on a sheet. `None` if it cannot be drawn there.
    pub(super) fn of<T: Scalar>(pose: Pose<T>, sheet: &Sheet) -> Option<Self> {
        let [cos, sin, x, y] = [pose.cos, pose.sin, pose.x, pose.y].map(Real::to_f64);
        let ([center_x, center_y], scale) = (sheet.view.center(), sheet.view.scale());
        let [middle_x, middle_y] = sheet.middle();
        let [x, y] = [middle_x + (x - center_x) * scale, middle_y - (y - center_y) * scale];
        let angle = (-sin).atan2(cos);
        let is_seen = [x, y, cos, sin].into_iter().all(is_drawable);
        is_seen.then_some(Self { x, y, angle })
    }

    /// The same at a later moment: whole turns are counted.
    pub(super) fn after(self, last: Self) -> Self {
        let turn = (self.angle - last.angle + PI).rem_euclid(TAU) - PI;
        let angle = last.angle + turn;
        Self { angle, ..self }
    }

    /// A place on the straight way to another.
    pub(super) fn between(self, other: Self, share: f64) -> Self {
        let between = |one: f64, other: f64| one + (other - one) * share;
        Self {
            x: between(self.x, other.x),
            y: between(self.y, other.y),
            angle: between(self.angle, other.angle),
        }
    }

    /// Bounds the movement of a figure from one place to another; it reaches `reach` pixels from its origin.
    pub(super) fn distance(self, other: Self, reach: f64) -> f64 {
        let shift = (other.x - self.x).hypot(other.y - self.y);
        shift + reach * (other.angle - self.angle).abs()
    }

    pub(super) fn is_turned(self) -> bool {
        self.angle != 0.0
    }

    /// Writes it as a transform, with these decimals and units of lengths and of the angle, which can be left out.
    pub(super) fn write(
        self,
        text: &mut String,
        (decimals, unit): (usize, &str),
        angle: Option<(usize, &str)>,
    ) {
        let [x, y] = [self.x, self.y].map(|pixels| Number(pixels, decimals));
        // Writing to a `String` cannot fail.
        let _ = write!(text, "translate({x}{unit},{y}{unit})");
        if let Some((decimals, unit)) = angle {
            let degrees = Number(self.angle.to_degrees(), decimals);
            let _ = write!(text, " rotate({degrees}{unit})");
        }
    }
}
