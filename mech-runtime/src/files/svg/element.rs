//! Outlines as elements of SVG, in pixels in the frame of their link, y down.

use super::number::{is_drawable, pixels};
use super::sheet::escape;
use crate::{Outline, Pose, Real, Scalar};
use core::f64::consts::{PI, TAU};
use std::{format, string::String, vec::Vec};

/// The greatest distance of a line of straight parts from its arc.
const SAGITTA: f64 = 0.001;

/// A figure that is painted at a place. Two figures with equal elements are the same one.
#[derive(Clone, Debug)]
pub(super) struct Figure {
    /// The element; of a trace, what follows its points.
    pub(super) element: String,
    /// The points of a trace. They differ from moment to moment.
    pub(super) trace: Vec<[f64; 2]>,
    /// The distance of its farthest point from the origin of its link.
    pub(super) reach: f64,
}

impl Figure {
    /// An outline at `scale` pixels per scene unit. `None` if it cannot be drawn.
    pub(super) fn of<T: Scalar>(outline: Outline<'_, T>, scale: f64, color: &str) -> Option<Self> {
        let length = |length: T| length.to_f64() * scale;
        let point = |[x, y]: [T; 2]| [length(x), -length(y)];
        let all = |points: &[[T; 2]]| points.iter().copied().map(point).collect::<Vec<_>>();
        let points = outline.points().copied().unwrap_or_default();
        let mut numbers = outline.numbers().chain(points.iter().flatten().copied());
        let reach = reach(&outline) * scale;
        if !numbers.all(|number| is_drawable(length(number))) || !is_drawable(reach) {
            return None;
        }
        let is_seen = |size: T| length(size) > 0.0;
        let element = match outline {
            Outline::Circle { center, radius } if is_seen(radius) => {
                disc(point(center), length(radius), color)
            }
            Outline::Ring { center, radius, hole } if is_seen(radius) && hole < radius => {
                let [outer, inner] = [length(radius), length(hole).max(0.0)];
                ring(point(center), f64::midpoint(outer, inner), outer - inner, color)
            }
            Outline::Polygon(corners) if corners.len() > 2 => {
                polygon(&all(corners), "evenodd", color)
            }
            Outline::Winding(corners) if corners.len() > 2 => {
                polygon(&all(corners), "nonzero", color)
            }
            Outline::Line { points, width } if is_seen(width) && !points.is_empty() => {
                line(&all(points), length(width), color)
            }
            Outline::Arc { center, start, angle, width } if is_seen(width) => {
                arc([point(center), point(start)], angle.to_f64(), length(width), color)
            }
            _ => return None,
        };
        let trace = Vec::new();
        Some(Self { element, trace, reach })
    }

    /// An upright text whose lower left corner is in the origin.
    pub(super) fn text(words: &str, color: &str) -> Self {
        let words = escape(words);
        Self {
            element: format!("<text xml:space=\"preserve\" fill=\"{color}\">{words}</text>\n"),
            trace: Vec::new(),
            reach: 0.0,
        }
    }

    /// A trace through points in the scene. `None` if it cannot be drawn.
    pub(super) fn of_trace<T: Scalar>(
        points: &[[T; 2]],
        width: T,
        scale: f64,
        color: &str,
    ) -> Option<Self> {
        let figure = Self::of(Outline::Line { points, width }, scale, color)?;
        let pixels = |part: T| part.to_f64() * scale;
        let trace = points.iter().map(|&[x, y]| [pixels(x), -pixels(y)]);
        Some(Self { element: stroke(pixels(width), color), trace: trace.collect(), ..figure })
    }

    /// Writes it as an element.
    pub(super) fn write(&self, text: &mut String) {
        if !self.trace.is_empty() {
            text.push_str("<polyline points=\"");
            text.push_str(&list(&self.trace));
        }
        text.push_str(&self.element);
    }

    /// The same, where a trace ends where it began.
    pub(super) fn closed(mut self) -> Self {
        self.trace.extend(self.trace.first().copied());
        self
    }
}

/// The distance from the origin of its link to the farthest point of an outline, in scene units, or a little more.
pub(super) fn reach<T: Real, P: AsRef<[[T; 2]]>>(outline: &mech_core::Outline<T, P>) -> f64 {
    let (low, high) = outline.bounds(Pose::identity());
    let [x, y] = [0, 1].map(|axis| high[axis].to_f64().abs().max(low[axis].to_f64().abs()));
    x.hypot(y)
}

fn disc([x, y]: [f64; 2], radius: f64, color: &str) -> String {
    let [x, y, radius] = [x, y, radius].map(pixels);
    format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{color}\"/>\n")
}

/// A circle that is drawn as a line of a width.
fn ring([x, y]: [f64; 2], radius: f64, width: f64, color: &str) -> String {
    let [x, y, radius] = [x, y, radius].map(pixels);
    let stroke = stroke(width, color);
    format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}{stroke}")
}

fn polygon(corners: &[[f64; 2]], rule: &str, color: &str) -> String {
    let corners = list(corners);
    format!("<polygon points=\"{corners}\" fill-rule=\"{rule}\" fill=\"{color}\"/>\n")
}

fn line(points: &[[f64; 2]], width: f64, color: &str) -> String {
    let first = points.first().copied().unwrap_or_default();
    if points.iter().all(|&point| point == first) {
        return disc(first, width / 2.0, color);
    }
    format!("<polyline points=\"{}{}", list(points), stroke(width, color))
}

/// An arc from its start through an angle in radians to the left.
fn arc([center, start]: [[f64; 2]; 2], angle: f64, width: f64, color: &str) -> String {
    let [right, down] = [start[0] - center[0], start[1] - center[1]];
    let radius = right.hypot(down);
    if radius == 0.0 || angle == 0.0 {
        return disc(start, width / 2.0, color);
    }
    // A line that is wider than twice the radius of its arc is not filled by all renderers.
    let is_thick = width >= 2.0 * radius;
    if angle.abs() >= TAU {
        return if is_thick {
            disc(center, radius + width / 2.0, color)
        } else {
            ring(center, radius, width, color)
        };
    }
    let at = |angle: f64| {
        // y points down, so a turn to the left is negative.
        let (sin, cos) = (-angle).sin_cos();
        [center[0] + cos * right - sin * down, center[1] + sin * right + cos * down]
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
        return line(&points, width, color);
    }
    let [[x, y], [to_x, to_y]] = [start, at(angle)].map(|point| point.map(pixels));
    let (radius, stroke) = (pixels(radius), stroke(width, color));
    let is_large = u8::from(angle.abs() > PI);
    let is_right = u8::from(angle < 0.0);
    format!("<path d=\"M{x} {y}A{radius} {radius} 0 {is_large} {is_right} {to_x} {to_y}{stroke}")
}

/// The end of an element that is a line, from the end of its geometry on.
fn stroke(width: f64, color: &str) -> String {
    let width = pixels(width);
    format!("\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\"/>\n")
}

fn list(points: &[[f64; 2]]) -> String {
    let points = points.iter().map(|&point| point.map(pixels));
    let points = points.map(|[x, y]| format!("{x},{y}"));
    points.collect::<Vec<_>>().join(" ")
}
