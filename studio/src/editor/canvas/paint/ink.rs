//! What is constructed, in the window.

use super::Paint;
use crate::editor::canvas::Shown;
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Shape, Stroke, epaint::PathShape};
use mech_runtime::{Canvas, Outline, Palette, Pose};

/// The number of straight parts of an arc.
const PARTS: u32 = 24;

/// A painter as a canvas.
struct Ink<'i> {
    painter: &'i Painter,
    shown: &'i Shown,
    palette: &'i Palette,
}

impl Paint<'_> {
    /// What is constructed at the present pose.
    pub(super) fn board(&self, painter: &Painter) {
        let Some(board) = self.editor.board() else {
            return;
        };
        let palette =
            if self.editor.settings.is_dark { &Palette::NIGHT } else { &Palette::TEXTBOOK };
        let shown = self.shown;
        board.paint(0, &mut Ink { painter, shown, palette });
    }
}

impl Ink<'_> {
    fn color(&self, entry: u8) -> Color32 {
        let [red, green, blue] = self.palette.rgb(entry);
        Color32::from_rgb(red, green, blue)
    }

    #[expect(clippy::cast_possible_truncation, reason = "pixels of a window")]
    fn length(&self, length: f64) -> f32 {
        (length * self.shown.scale()) as f32
    }
}

impl Canvas<f64> for Ink<'_> {
    fn fill(&mut self, outline: Outline<'_, f64>, pose: Pose<f64>, color: u8) {
        let color = self.color(color);
        let pixel = |place: [f64; 2]| self.shown.pixel(pose.apply(place));
        let all = |places: &[[f64; 2]]| places.iter().copied().map(pixel).collect::<Vec<Pos2>>();
        let stroke = |width| Stroke::new(self.length(width), color);
        self.painter.add(match outline {
            Outline::Circle { center, radius } => {
                Shape::circle_filled(pixel(center), self.length(radius), color)
            }
            Outline::Ring { center, radius, hole } => {
                let middle = self.length(f64::midpoint(radius, hole));
                Shape::circle_stroke(pixel(center), middle, stroke(radius - hole))
            }
            Outline::Polygon(places) | Outline::Winding(places) => {
                PathShape::convex_polygon(all(places), color, Stroke::NONE).into()
            }
            Outline::Line { points, width } => Shape::line(all(points), stroke(width)),
            Outline::Arc { center, start, angle, width } => {
                let [x, y] = [start[0] - center[0], start[1] - center[1]];
                let places = (0..=PARTS).map(|part| {
                    let (sin, cos) = (angle * f64::from(part) / f64::from(PARTS)).sin_cos();
                    pixel([center[0] + cos * x - sin * y, center[1] + sin * x + cos * y])
                });
                Shape::line(places.collect(), stroke(width))
            }
        });
    }

    fn text(&mut self, place: [f64; 2], text: &str, color: u8) {
        let (at, font) = (self.shown.pixel(place), FontId::monospace(10.0));
        let color = self.color(color);
        self.painter.text(at, Align2::LEFT_BOTTOM, text, font, color);
    }

    fn scale(&self) -> f64 {
        self.shown.scale()
    }
}
