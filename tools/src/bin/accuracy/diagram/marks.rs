//! The marks of methods: shapes, and colours that are distinct also for the colour-blind (Okabe and Ito's).

use super::{Area, Drawn};
use crate::measurement::{STEPS, Step};
use crate::method::{Method, Precision};
use plotters::prelude::*;
use std::f64::consts::TAU;

/// The colour of a method.
pub(super) fn color(method: Method) -> RGBColor {
    match method {
        Method::Exact => RGBColor(0, 114, 178),
        Method::Linear => RGBColor(204, 121, 167),
        Method::Rounds(1) => RGBColor(230, 159, 0),
        Method::Rounds(2) => RGBColor(86, 180, 233),
        Method::Rounds(_) => RGBColor(0, 158, 115),
        Method::Newton => RGBColor(213, 94, 0),
    }
}

/// The size of a mark at a step: half its width.
pub(super) fn radius(step: Step) -> f64 {
    let place = STEPS.iter().position(|other| *other == step);
    [6.5, 9.5, 13.0][place.unwrap_or_default().min(2)]
}

/// The frontier's stroke at a step.
pub(super) fn stroke(step: Step) -> ShapeStyle {
    let place = STEPS.iter().position(|other| *other == step);
    let place = place.unwrap_or_default().min(2);
    let grey = [178, 128, 70][place];
    let width = [3, 4, 5][place];
    RGBColor(grey, grey, grey).stroke_width(width)
}

/// The corners of a method's mark, around zero, within a circle of one.
fn corners(method: Method) -> Vec<(f64, f64)> {
    let star = |points: u16, depth: f64| {
        let corners = (0..2 * points).map(|corner| {
            let angle = TAU * f64::from(corner) / f64::from(2 * points);
            let radius = if corner % 2 == 0 { 1.0 } else { depth };
            (radius * angle.sin(), -radius * angle.cos())
        });
        corners.collect()
    };
    let polygon = |points: u16, turn: f64| {
        let corners = (0..points).map(|corner| {
            let angle = TAU * (f64::from(corner) + turn) / f64::from(points);
            (angle.sin(), -angle.cos())
        });
        corners.collect()
    };
    match method {
        Method::Exact => polygon(32, 0.0),
        Method::Linear => polygon(3, 0.5),
        Method::Rounds(1) => polygon(3, 0.0),
        Method::Rounds(2) => polygon(4, 0.5),
        Method::Rounds(_) => polygon(4, 0.0),
        Method::Newton => star(5, 0.5),
    }
}

/// Draws the mark of a method: full in double precision, hollow in single.
pub(super) fn draw<B: DrawingBackend>(
    area: &Area<'_, B>,
    (method, precision): (Method, Precision),
    radius: f64,
    at: (i32, i32),
) -> Drawn<B> {
    let place = |size: f64| {
        let corners = corners(method).into_iter();
        let placed = corners.map(|(x, y)| (at.0 + nearest(x * size), at.1 + nearest(y * size)));
        placed.collect::<Vec<_>>()
    };
    // A circle is as large as it looks, a triangle looks smaller.
    let size = match method {
        Method::Exact => radius,
        Method::Newton => radius * 1.35,
        _ => radius * 1.2,
    };
    area.draw(&Polygon::new(place(size + 2.5), WHITE))?;
    area.draw(&Polygon::new(place(size), color(method)))?;
    if precision == Precision::Single {
        area.draw(&Polygon::new(place(size * 0.52), WHITE))?;
    }
    Ok(())
}

/// Draws a cross where a method is blocked.
pub(super) fn cross<B: DrawingBackend>(
    area: &Area<'_, B>,
    method: Method,
    radius: f64,
    (x, y): (i32, i32),
) -> Drawn<B> {
    let arm = nearest(radius * 0.8);
    for (dx, dy) in [(arm, arm), (arm, -arm)] {
        let line = vec![(x - dx, y - dy), (x + dx, y + dy)];
        area.draw(&PathElement::new(line, color(method).stroke_width(4)))?;
    }
    Ok(())
}

/// The nearest pixel.
#[expect(clippy::cast_possible_truncation, reason = "a picture is not that large")]
pub(super) fn nearest(value: f64) -> i32 {
    value.round() as i32
}
