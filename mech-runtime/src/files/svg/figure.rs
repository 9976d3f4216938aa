//! An outline as an element of SVG.

use super::number::pixels;
use super::place::Place;
use crate::{Outline, Palette, Scalar};
use core::fmt::Write;
use core::iter;
use std::{string::String, vec, vec::Vec};

/// How far points may be apart that count as the same, in pixels.
const SAME: f64 = 5e-4;

/// An outline in pixels in the frame of its link, y down.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Figure {
    form: Form,
    points: Vec<[f64; 2]>,
    color: u8,
}

#[derive(Clone, Debug, PartialEq)]
enum Form {
    /// Of a radius about the only point.
    Circle(f64),
    /// Through the points, by the even-odd rule.
    Polygon,
}

impl Figure {
    /// An outline with so many pixels to a scene unit; `None` if there is nothing of it to be drawn, or something is not finite.
    pub(super) fn of<T: Scalar>(outline: Outline<T>, scale: f64, color: u8) -> Option<Self> {
        let point = |[x, y]: [T; 2]| [x.to_f64() * scale, -(y.to_f64() * scale)];
        let (form, points) = match outline {
            Outline::Circle { center, radius } => {
                let radius = radius.to_f64() * scale;
                if !(radius.is_finite() && radius > 0.0) {
                    return None;
                }
                (Form::Circle(radius), vec![point(center)])
            }
            Outline::Polygon(corners) => return Self::polygon(corners, scale, color),
        };
        Self::finite(form, points, color)
    }

    /// A polygon, likewise.
    pub(super) fn polygon<T: Scalar>(corners: &[[T; 2]], scale: f64, color: u8) -> Option<Self> {
        let point = |&[x, y]: &[T; 2]| [x.to_f64() * scale, -(y.to_f64() * scale)];
        Self::finite(Form::Polygon, corners.iter().map(point).collect(), color)
    }

    fn finite(form: Form, points: Vec<[f64; 2]>, color: u8) -> Option<Self> {
        let is_finite = points.as_flattened().iter().all(|part| part.is_finite());
        (is_finite && !points.is_empty()).then_some(Self {
            form,
            points,
            color,
        })
    }

    /// What is beyond its points.
    fn margin(&self) -> f64 {
        match self.form {
            Form::Circle(radius) => radius,
            Form::Polygon => 0.0,
        }
    }

    /// How far from the origin it reaches.
    pub(super) fn extent(&self) -> f64 {
        let distances = self.points.iter().map(|[x, y]| x.hypot(*y));
        distances.fold(0.0, f64::max) + self.margin()
    }

    /// Whether the other is the same but for the places of its points.
    pub(super) fn is_akin(&self, other: &Self) -> bool {
        let is_same_form = match (&self.form, &other.form) {
            (Form::Circle(one), Form::Circle(other)) => (one - other).abs() < SAME,
            (one, other) => one == other,
        };
        is_same_form && self.color == other.color && self.points.len() == other.points.len()
    }

    /// Whether nobody could tell the two apart.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        let are_same = |(one, other): (&[f64; 2], &[f64; 2])| {
            iter::zip(one, other).all(|(one, other)| (one - other).abs() < SAME)
        };
        self.is_akin(other) && iter::zip(&self.points, &other.points).all(are_same)
    }

    /// Which of its points is farthest from the first.
    pub(super) fn farthest(&self) -> usize {
        let first = self.points.first().copied().unwrap_or_default();
        let distances = self
            .points
            .iter()
            .map(|[x, y]| (x - first[0]).hypot(y - first[1]));
        let farthest = distances
            .enumerate()
            .max_by(|(_, a), (_, b)| a.total_cmp(b));
        farthest.map_or(0, |(index, _)| index)
    }

    /// A frame that is fixed to it: the origin in its first point, the axis towards another one.
    pub(super) fn own_place(&self, towards: usize) -> Place {
        let first = self.points.first().copied().unwrap_or_default();
        let to = self.points.get(towards).copied().unwrap_or(first);
        Place::through(first, to)
    }

    /// The same with all its points carried elsewhere.
    pub(super) fn carried(&self, to: impl Fn([f64; 2]) -> [f64; 2]) -> Self {
        Self {
            points: self.points.iter().copied().map(to).collect(),
            ..self.clone()
        }
    }

    /// Writes it as an element.
    pub(super) fn write(&self, text: &mut String, palette: &Palette) {
        let [red, green, blue] = palette.rgb(self.color);
        let fill = format_args!("fill=\"#{red:02x}{green:02x}{blue:02x}\"");
        // Writing to a `String` cannot fail.
        let _ = match (&self.form, self.points.as_slice()) {
            (Form::Circle(radius), &[[x, y], ..]) => {
                let [x, y, radius] = [x, y, *radius].map(pixels);
                writeln!(
                    text,
                    "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" {fill}/>"
                )
            }
            (_, corners) => {
                text.push_str("<polygon points=\"");
                write_points(text, corners);
                // Where a polygon does not cut itself there is but one rule.
                writeln!(text, "\" fill-rule=\"evenodd\" {fill}/>")
            }
        };
    }
}

fn write_points(text: &mut String, points: &[[f64; 2]]) {
    for (index, &[x, y]) in points.iter().enumerate() {
        let gap = if index == 0 { "" } else { " " };
        let _ = write!(text, "{gap}{},{}", pixels(x), pixels(y));
    }
}
