//! Still pictures as SVG.

use super::Sheet;
use super::element::Figure;
use super::number::{DECIMALS, digits};
use super::place::Place;
use super::sheet::hex;
use crate::{Canvas, Outline, Pose, Real, Scalar};
use std::{string::String, vec::Vec};

/// A picture as SVG, which can be shown at any size. It is painted like a [`Frame`](crate::Frame).
///
/// The shapes of each link are in the link's frame, in pixels, and a transform places them. Numbers are exact to a thousandth of a pixel.
/// Shapes that are not finite, or farther away than 10³⁰ pixels, are not drawn.
///
/// ```
/// use mech_runtime::files::{Sheet, Svg};
/// use mech_runtime::{Canvas, Outline, Palette, Pose};
///
/// let mut svg = Svg::new(Sheet::new(64, 48));
/// svg.fill(Outline::Circle { center: [0.0, 5.0], radius: 2.5 }, Pose::identity(), Palette::BLUE);
/// let text = svg.finish(); // for `std::fs::write("circle.svg", text)`
/// assert!(text.contains(r#"<circle cx="0" cy="-5" r="2.5""#));
/// ```
#[derive(Clone, Debug)]
pub struct Svg {
    pub(super) sheet: Sheet,
    pub(super) parts: Vec<Part>,
}

/// A figure and its place.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub(super) figure: Figure,
    pub(super) place: Place,
}

impl Svg {
    /// An empty picture.
    #[must_use]
    pub const fn new(sheet: Sheet) -> Self {
        let parts = Vec::new();
        Self { sheet, parts }
    }

    /// The text of the file.
    #[must_use]
    pub fn finish(self) -> String {
        let mut body = String::new();
        write_groups(&mut body, &self.parts.iter().collect::<Vec<_>>());
        self.sheet.document("", &body)
    }

    fn draw<T: Scalar>(&mut self, figure: Option<Figure>, pose: Pose<T>) {
        let place = Place::of(pose, &self.sheet);
        let parts = figure.zip(place);
        self.parts.extend(parts.map(|(figure, place)| Part { figure, place }));
    }
}

impl<T: Scalar> Canvas<T> for Svg {
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8) {
        let color = hex(&self.sheet.palette, color);
        self.draw(Figure::of(outline, self.sheet.view.scale(), &color), pose);
    }

    fn text(&mut self, [x, y]: [T; 2], text: &str, color: u8) {
        let figure = Figure::text(text, &hex(&self.sheet.palette, color));
        let pose = Pose::identity();
        self.draw(Some(figure), Pose { x, y, ..pose });
    }

    fn trace(&mut self, points: &[[T; 2]], width: T, color: u8) {
        let color = hex(&self.sheet.palette, color);
        let figure = Figure::of_trace(points, width, self.sheet.view.scale(), &color);
        let last = self.parts.last_mut().map(|last| &mut last.figure);
        match (last, &figure) {
            (Some(last), Some(next))
                if last.element == next.element && last.trace.last() == next.trace.first() =>
            {
                last.trace.extend(next.trace.iter().skip(1));
                last.reach = last.reach.max(next.reach);
            }
            _ => self.draw(figure, Pose::<T>::identity()),
        }
    }

    fn scale(&self) -> T {
        Real::from_f64(self.sheet.view.scale())
    }
}

/// Writes figures, those that have the same place as a group.
pub(super) fn write_groups(text: &mut String, parts: &[&Part]) {
    for group in parts.chunk_by(|one, next| one.place == next.place) {
        let reach = group.iter().map(|part| part.figure.reach);
        let Some(Part { place, .. }) = group.first() else {
            continue;
        };
        begin_group(text, "", *place, reach.fold(0.0, f64::max));
        for part in group {
            part.figure.write(text);
        }
        text.push_str("</g>\n");
    }
}

/// Begins the group of figures at a place that reach so far from its origin.
pub(super) fn begin_group(text: &mut String, attributes: &str, place: Place, reach: f64) {
    let angle = place.is_turned().then(|| (DECIMALS + digits(reach), ""));
    text.push_str("<g");
    text.push_str(attributes);
    text.push_str(" transform=\"");
    place.write(text, (DECIMALS, ""), angle);
    text.push_str("\">\n");
}
