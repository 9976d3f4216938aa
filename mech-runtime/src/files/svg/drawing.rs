//! Still pictures as SVG.

use super::Sheet;
use super::figure::Figure;
use super::place::Place;
use crate::{Canvas, Outline, Palette, Pose, Real, Scalar};
use core::fmt::Write;
use std::{string::String, vec, vec::Vec};

/// A picture as SVG, which can be shown at any size. It is painted like a [`Frame`](crate::Frame).
///
/// The shapes of each link are in the link's frame, in pixels, and a matrix places them. Numbers are exact to a thousandth of a pixel.
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
    sheet: Sheet,
    body: String,
    /// The figures at the place of the last one, and that place.
    run: Option<(Place, Vec<Figure>)>,
}

impl Svg {
    /// An empty picture.
    #[must_use]
    pub const fn new(sheet: Sheet) -> Self {
        Self {
            sheet,
            body: String::new(),
            run: None,
        }
    }

    /// The text of the file.
    #[must_use]
    pub fn finish(mut self) -> String {
        self.end_run();
        self.sheet.document("", &self.body)
    }

    fn end_run(&mut self) {
        if let Some((place, figures)) = self.run.take() {
            write_group(&mut self.body, "", place, &figures, &self.sheet.palette);
        }
    }
}

impl Svg {
    fn draw<T: Scalar>(&mut self, figure: Option<Figure>, pose: Pose<T>) {
        let place = Place::of(pose, &self.sheet);
        let (Some(place), Some(figure)) = (place, figure) else {
            return;
        };
        match &mut self.run {
            Some((last, figures)) if *last == place => {
                if !figures.last_mut().is_some_and(|last| last.join(&figure)) {
                    figures.push(figure);
                }
            }
            _ => {
                self.end_run();
                self.run = Some((place, vec![figure]));
            }
        }
    }
}

impl<T: Scalar> Canvas<T> for Svg {
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8) {
        let figure = Figure::of(outline, self.sheet.view.scale(), color);
        self.draw(figure, pose);
    }

    fn text(&mut self, place: [T; 2], text: &str, color: u8) {
        let figure = Figure::text(place, text, self.sheet.view.scale(), color);
        self.draw(figure, Pose::<T>::identity());
    }

    fn scale(&self) -> T {
        Real::from_f64(self.sheet.view.scale())
    }
}

/// Writes figures that have the same place.
pub(super) fn write_group(
    text: &mut String,
    attributes: &str,
    place: Place,
    figures: &[Figure],
    palette: &Palette,
) {
    let extent = figures.iter().map(Figure::extent).fold(0.0, f64::max);
    let transform = place.transform(extent);
    // Writing to a `String` cannot fail.
    let _ = writeln!(text, "<g{attributes} transform=\"{transform}\">");
    for figure in figures {
        figure.write(text, palette);
    }
    text.push_str("</g>\n");
}
