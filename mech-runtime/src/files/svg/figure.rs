//! Outlines in the picture.

use super::element::{FONT, Paint};
use super::number::is_drawable;
use super::place::Place;
use super::sheet::hex;
use super::track::share;
use crate::{Outline, Palette, Scalar};
use core::{iter, mem};
use std::sync::Arc;
use std::{string::String, vec, vec::Vec};

/// The distance below which two points count as the same, in pixels.
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
    /// A radius about the only point.
    Circle(f64),
    /// A radius and that of the hole, about the only point.
    Ring(f64, f64),
    /// Through the points, by the even-odd rule.
    Polygon,
    /// Through the points, by the non-zero rule.
    Winding,
    /// A width, through the points.
    Line(f64),
    /// A counter-clockwise angle and a width, about the first point and from the second.
    Arc(f64, f64),
    /// Upright, its lower left corner in the only point.
    Text(String),
}

impl Figure {
    /// The figure of an outline at `scale` pixels per scene unit. `None` if it cannot be drawn.
    pub(super) fn of<T: Scalar>(outline: Outline<'_, T>, scale: f64, color: u8) -> Option<Self> {
        let length = |length: T| length.to_f64() * scale;
        let is_length = |length: f64| is_drawable(length) && length > 0.0;
        let point = |[x, y]: [T; 2]| [length(x), -length(y)];
        let all = |points: &[[T; 2]]| points.iter().copied().map(point).collect::<Vec<_>>();
        let (form, points) = match outline {
            Outline::Circle { center, radius } => {
                (Form::Circle(length(radius)), vec![point(center)])
            }
            Outline::Ring {
                center,
                radius,
                hole,
            } => (
                Form::Ring(length(radius), length(hole)),
                vec![point(center)],
            ),
            Outline::Polygon(corners) => (Form::Polygon, all(corners)),
            Outline::Winding(corners) => (Form::Winding, all(corners)),
            Outline::Line { points, width } => (Form::Line(length(width)), all(points)),
            Outline::Arc {
                center,
                start,
                angle,
                width,
            } => (
                Form::Arc(angle.to_f64(), length(width)),
                vec![point(center), point(start)],
            ),
        };
        let is_seen = match form {
            Form::Circle(size) | Form::Line(size) => is_length(size),
            Form::Ring(radius, hole) => is_length(radius) && hole < radius,
            Form::Arc(angle, width) => angle.is_finite() && is_length(width),
            Form::Polygon | Form::Winding => points.len() > 2,
            Form::Text(_) => true,
        };
        Self::drawable(form, points, color).filter(|_| is_seen)
    }

    /// A text whose lower left corner is at a place in the scene.
    pub(super) fn text<T: Scalar>(
        place: [T; 2],
        text: &str,
        scale: f64,
        color: u8,
    ) -> Option<Self> {
        let [x, y] = place.map(|part| part.to_f64() * scale);
        Self::drawable(Form::Text(text.into()), vec![[x, -y]], color)
    }

    fn drawable(form: Form, points: Vec<[f64; 2]>, color: u8) -> Option<Self> {
        let is_drawable = points.as_flattened().iter().all(|&part| is_drawable(part));
        (is_drawable && !points.is_empty()).then_some(Self {
            form,
            points,
            color,
        })
    }

    /// Appends another figure, if both are lines and the other begins at the end of this one.
    pub(super) fn join(&mut self, next: &Self) -> bool {
        let (Form::Line(width), Form::Line(next_width)) = (&self.form, &next.form) else {
            return false;
        };
        let is_continued = width == next_width
            && self.color == next.color
            && self.points.last() == next.points.first();
        if is_continued {
            self.points.extend(next.points.iter().skip(1));
        }
        is_continued
    }

    /// Whether it stays upright when its link turns.
    pub(super) const fn is_upright(&self) -> bool {
        matches!(self.form, Form::Text(_))
    }

    /// Its points, if it is a line.
    pub(super) fn line(&self) -> Option<&[[f64; 2]]> {
        matches!(self.form, Form::Line(_)).then_some(&self.points)
    }

    /// The same figure through other points.
    pub(super) fn through(&self, points: Vec<[f64; 2]>) -> Self {
        Self {
            form: self.form.clone(),
            points,
            color: self.color,
        }
    }

    /// The distance by which it exceeds its points.
    fn margin(&self) -> f64 {
        match self.form {
            Form::Circle(radius) | Form::Ring(radius, _) => radius,
            Form::Polygon | Form::Winding => 0.0,
            Form::Line(width) => width / 2.0,
            Form::Arc(_, width) => self.radius() + width / 2.0,
            Form::Text(ref text) => share(text.chars().count(), 1) * FONT,
        }
    }

    /// The distance from the first point to the second.
    fn radius(&self) -> f64 {
        match self.points.as_slice() {
            [[x, y], [to_x, to_y], ..] => (to_x - x).hypot(to_y - y),
            _ => 0.0,
        }
    }

    /// The distance from the origin to its farthest point.
    pub(super) fn extent(&self) -> f64 {
        let distances = self.points.iter().map(|[x, y]| x.hypot(*y));
        distances.fold(0.0, f64::max) + self.margin()
    }

    /// Whether the other may be the same figure at another time: with the same form and colour, of any size.
    pub(super) fn is_akin(&self, other: &Self) -> bool {
        let is_line = self.line().is_some();
        mem::discriminant(&self.form) == mem::discriminant(&other.form)
            && self.color == other.color
            && (is_line || self.points.len() == other.points.len())
    }

    /// Whether the two look the same.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        let are_same = |(one, other): (&[f64; 2], &[f64; 2])| {
            iter::zip(one, other).all(|(one, other)| (one - other).abs() < SAME)
        };
        let is_near = |one: f64, other: f64| (one - other).abs() < SAME;
        let is_same_size = match (&self.form, &other.form) {
            (Form::Circle(one), Form::Circle(other)) | (Form::Line(one), Form::Line(other)) => {
                is_near(*one, *other)
            }
            (Form::Ring(one, hole), Form::Ring(other, other_hole)) => {
                is_near(*one, *other) && is_near(*hole, *other_hole)
            }
            (Form::Arc(one, width), Form::Arc(other, other_width)) => {
                is_near(one * self.radius(), other * self.radius()) && is_near(*width, *other_width)
            }
            (one, other) => one == other,
        };
        is_same_size
            && self.color == other.color
            && self.points.len() == other.points.len()
            && iter::zip(&self.points, &other.points).all(are_same)
    }

    pub(super) fn first_point(&self) -> [f64; 2] {
        self.points.first().copied().unwrap_or_default()
    }

    /// The index of the point farthest from the first.
    pub(super) fn farthest(&self) -> usize {
        let first = self.first_point();
        let distances = self
            .points
            .iter()
            .map(|[x, y]| (x - first[0]).hypot(y - first[1]));
        let farthest = distances
            .enumerate()
            .max_by(|(_, a), (_, b)| a.total_cmp(b));
        farthest.map_or(0, |(index, _)| index)
    }

    /// A frame that is fixed to it: the origin at its first point, the axis towards another one.
    pub(super) fn own_place(&self, towards: usize) -> Place {
        let first = self.first_point();
        let to = self.points.get(towards).copied().unwrap_or(first);
        Place::through(first, to)
    }

    /// The same figure with all its points mapped.
    pub(super) fn map(&self, to: impl Fn([f64; 2]) -> [f64; 2]) -> Self {
        self.through(self.points.iter().copied().map(to).collect())
    }

    /// Writes it as an element.
    pub(super) fn write(&self, text: &mut String, palette: &Palette) {
        let paint = Paint(hex(palette, self.color));
        let [x, y] = self.first_point();
        match &self.form {
            Form::Circle(radius) => paint.disc(text, [x, y], *radius),
            Form::Ring(radius, hole) => {
                let hole = hole.max(0.0);
                paint.ring(text, [x, y], f64::midpoint(*radius, hole), radius - hole);
            }
            Form::Polygon => paint.polygon(text, &self.points, "evenodd"),
            Form::Winding => paint.polygon(text, &self.points, "nonzero"),
            Form::Line(width) => paint.line(text, &self.points, *width),
            Form::Arc(angle, width) => {
                let start = self.points.get(1).copied().unwrap_or_default();
                paint.arc(text, [x, y], start, *angle, *width);
            }
            Form::Text(words) => paint.text(text, [x, y], words),
        }
    }
}

/// A figure at one moment, and its place.
#[derive(Clone, Debug)]
pub(super) struct Seen {
    pub(super) figure: Arc<Figure>,
    pub(super) place: Place,
}

impl Seen {
    /// The place in the picture of the figure's first point.
    pub(super) fn first_point(&self) -> (f64, f64) {
        self.place.apply(self.figure.first_point()).into()
    }

    /// The figure in the picture.
    pub(super) fn in_picture(&self) -> Figure {
        self.figure.map(|point| self.place.apply(point))
    }
}
