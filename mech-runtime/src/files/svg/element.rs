//! Outlines as elements of SVG, in pixels.

use super::number::pixels;
use super::sheet::escape;
use core::f64::consts::{PI, TAU};
use core::fmt::Write;
use std::{string::String, vec::Vec};

/// The size of letters: the runtime's own are six pixels apart and seven high, as those of most fonts are that have all one width.
pub(super) const FONT: f64 = 10.0;

/// The greatest distance of a line of straight parts from its arc.
const SAGITTA: f64 = 0.001;

/// A colour that elements are written in. (Writing to a `String` cannot fail.)
pub(super) struct Paint(pub(super) String);

impl Paint {
    pub(super) fn disc(&self, text: &mut String, [x, y]: [f64; 2], radius: f64) {
        let [x, y, radius] = [x, y, radius].map(pixels);
        let Self(color) = self;
        let _ = writeln!(
            text,
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{color}\"/>"
        );
    }

    /// A circle that is drawn as a line of a width.
    pub(super) fn ring(&self, text: &mut String, [x, y]: [f64; 2], radius: f64, width: f64) {
        let [x, y, radius, width] = [x, y, radius, width].map(pixels);
        let Self(color) = self;
        let _ = writeln!(
            text,
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\"/>"
        );
    }

    pub(super) fn polygon(&self, text: &mut String, corners: &[[f64; 2]], rule: &str) {
        let Self(color) = self;
        text.push_str("<polygon points=\"");
        write_points(text, corners);
        let _ = writeln!(text, "\" fill-rule=\"{rule}\" fill=\"{color}\"/>");
    }

    pub(super) fn line(&self, text: &mut String, points: &[[f64; 2]], width: f64) {
        let first = points.first().copied().unwrap_or_default();
        if points.iter().all(|&point| point == first) {
            return self.disc(text, first, width / 2.0);
        }
        text.push_str("<polyline points=\"");
        write_points(text, points);
        self.end_line(text, width);
    }

    /// An arc through an angle in radians to the left.
    pub(super) fn arc(
        &self,
        text: &mut String,
        center: [f64; 2],
        start: [f64; 2],
        angle: f64,
        width: f64,
    ) {
        let [right, down] = [start[0] - center[0], start[1] - center[1]];
        let radius = right.hypot(down);
        if radius == 0.0 || angle == 0.0 {
            return self.disc(text, start, width / 2.0);
        }
        // A line that is wider than twice the radius of its arc is not filled by all renderers.
        let is_thick = width >= 2.0 * radius;
        if angle.abs() >= TAU {
            if is_thick {
                self.disc(text, center, radius + width / 2.0);
            } else {
                self.ring(text, center, radius, width);
            }
            return;
        }
        let at = |angle: f64| {
            // y points down, so a turn to the left is negative.
            let (sin, cos) = (-angle).sin_cos();
            [
                center[0] + cos * right - sin * down,
                center[1] + sin * right + cos * down,
            ]
        };
        if is_thick {
            let step = (8.0 * SAGITTA / radius).sqrt().clamp(0.01, 0.5);
            let parts = (angle.abs() / step).ceil();
            let mut points = Vec::new();
            let mut part = 0.0;
            while part <= parts {
                points.push(at(angle * part / parts));
                part += 1.0;
            }
            return self.line(text, &points, width);
        }
        let end = at(angle);
        let [x, y, to_x, to_y, radius] = [start[0], start[1], end[0], end[1], radius].map(pixels);
        let is_large = u8::from(angle.abs() > PI);
        let is_right = u8::from(angle < 0.0);
        let _ = write!(
            text,
            "<path d=\"M{x} {y}A{radius} {radius} 0 {is_large} {is_right} {to_x} {to_y}"
        );
        self.end_line(text, width);
    }

    pub(super) fn text(&self, text: &mut String, [x, y]: [f64; 2], words: &str) {
        let [x, y] = [x, y].map(pixels);
        let Self(color) = self;
        let words = escape(words);
        let _ = writeln!(
            text,
            "<text x=\"{x}\" y=\"{y}\" font-family=\"monospace\" font-size=\"{FONT}\" xml:space=\"preserve\" fill=\"{color}\">{words}</text>"
        );
    }

    /// The attributes of a line after its last point.
    fn end_line(&self, text: &mut String, width: f64) {
        let (Self(color), width) = (self, pixels(width));
        let _ = writeln!(
            text,
            "\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"/>"
        );
    }
}

fn write_points(text: &mut String, points: &[[f64; 2]]) {
    for (index, &[x, y]) in points.iter().enumerate() {
        let gap = if index == 0 { "" } else { " " };
        let _ = write!(text, "{gap}{},{}", pixels(x), pixels(y));
    }
}
