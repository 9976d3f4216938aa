//! The legend of the marks.

use super::marks::{self, nearest};
use super::{Area, Drawn, SOFT, Side, TEXT, write};
use crate::measurement::STEPS;
use crate::method::{Method, Precision};
use plotters::prelude::*;

const LETTER: f64 = 26.0;
const LINE: i32 = 42;

/// Draws the legend.
pub(super) fn draw<B: DrawingBackend>(area: &Area<'_, B>) -> Drawn<B> {
    let (left, right, mut y) = (150, 480, 110);
    write(area, ("How to read it", 34.0, TEXT), (left - 34, 34), Side::Right)?;
    for method in Method::ALL {
        marks::draw(area, (method, Precision::Double), 12.0, (left, y))?;
        let name = format!("method {method}");
        write(area, (&name, LETTER, TEXT), (left + 30, y), Side::Right)?;
        y += LINE;
    }
    y = 110;
    for (precision, name) in [(Precision::Double, "full: f64"), (Precision::Single, "hollow: f32")]
    {
        marks::draw(area, (Method::Exact, precision), 12.0, (right, y))?;
        write(area, (name, LETTER, TEXT), (right + 30, y), Side::Right)?;
        y += LINE;
    }
    for step in STEPS {
        let line = vec![(right - 30, y), (right + 30, y)];
        area.draw(&PathElement::new(line, marks::stroke(step)))?;
        let radius = marks::radius(step);
        area.draw(&Circle::new((right, y), nearest(radius), SOFT.filled()))?;
        let name = format!("{}° of the motor a step", step.degrees());
        write(area, (&name, LETTER, TEXT), (right + 46, y), Side::Right)?;
        y += LINE;
    }
    marks::cross(area, Method::Newton, 12.0, (right, y))?;
    write(area, ("blocked at this step", LETTER, TEXT), (right + 30, y), Side::Right)?;
    y += LINE + 22;
    for line in [
        "Left is cheaper, down is more exact. The grey line of a step is its",
        "frontier: what is right of it or above it costs more or is less exact",
        "than something named on the line.",
    ] {
        write(area, (line, LETTER, SOFT), (left - 34, y), Side::Right)?;
        y += 36;
    }
    Ok(())
}
