//! The layers over and under the bodies: the grid, the schematic, paths, handles, and the marks of a tool.

mod handle;
mod ink;
mod mechanism;

use super::Shown;
use crate::editor::drawing::Handle;
use crate::editor::selection::Selection;
use crate::editor::settings::Visible;
use crate::editor::snap::{Snapped, grid};
use crate::editor::{Arrow, ArrowKind, Editor, Item};
use eframe::egui::{self, Align2, Color32, FontId, Painter, Pos2, Stroke, Vec2};
use handle::NameSpaces;
use mechanism::outline;

/// Paints what is seen besides the bodies.
pub(super) struct Paint<'p> {
    pub(super) editor: &'p Editor,
    pub(super) shown: &'p Shown,
    pub(super) snapped: Option<&'p Snapped>,
}

impl Paint<'_> {
    /// Paints what lies under the handles: the grid, paths, and the mechanism.
    pub(super) fn behind(&self, ui: &egui::Ui) {
        let painter = ui.painter().with_clip_rect(self.shown.rect);
        let settings = &self.editor.settings;
        if settings.shows(Visible::Grid) {
            self.grid(&painter, ui.visuals());
        }
        if settings.shows(Visible::Paths) {
            self.paths(&painter);
        }
        if let Some(drawing) = self.editor.sight.seen_drawing() {
            if !self.editor.sight.shows_bodies(&self.editor.settings) {
                self.schematic(&painter, drawing, 1.0);
            }
            self.actions(&painter, drawing, ui.visuals());
            self.ranges(&painter, drawing);
            self.gaps(&painter, drawing, ui.visuals());
        }
        if let Some(ghost) = self.editor.analysis.ghost() {
            self.schematic(&painter, ghost, 0.45);
        }
        if !self.editor.is_readable() && self.editor.drawing().is_some() {
            let veil = ui.visuals().panel_fill.gamma_multiply(0.6);
            painter.rect_filled(self.shown.rect, 0.0, veil);
        }
    }

    /// The handles, their names, and what a tool is about.
    pub(super) fn front<'h>(&self, ui: &egui::Ui, handles: impl Iterator<Item = Handle<'h>>) {
        let painter = ui.painter().with_clip_rect(self.shown.rect);
        let mut names = NameSpaces::default();
        for handle in handles.filter(|handle| self.is_on_canvas(handle.place)) {
            self.handle(&painter, handle, ui.visuals());
            let center = self.shown.pixel(handle.place);
            let is_marked = self.editor.selection.marks(handle.item);
            if self.editor.settings.shows(Visible::Names) && (names.take(center) || is_marked) {
                let visuals = ui.visuals();
                let color = if is_marked {
                    visuals.selection.stroke.color
                } else {
                    visuals.strong_text_color()
                };
                let at = center + Vec2::new(9.0, -9.0);
                let font = FontId::proportional(12.0);
                painter.text(at, Align2::LEFT_BOTTOM, handle.item.name(), font, color);
            }
        }
        self.arrows(&painter);
        self.board(&painter);
        self.selected_links(&painter, ui.visuals());
        self.tool(&painter, ui.visuals());
    }

    fn grid(&self, painter: &Painter, visuals: &egui::Visuals) {
        let rect = self.shown.rect;
        let unit = grid(self.shown.scale());
        let [low, high] =
            [rect.left_bottom(), rect.right_top()].map(|corner| self.shown.place(corner));
        let weak = visuals.text_color().gamma_multiply(0.07);
        let strong = visuals.text_color().gamma_multiply(0.18);
        for part in 0..2 {
            let first = (low[part] / unit).ceil();
            let count = ((high[part] - low[part]) / unit).min(400.0);
            // Far from the origin and much enlarged, a next line has no number of its own.
            if first + 1.0 == first {
                continue;
            }
            let mut number = first;
            while number <= first + count {
                let mut place = [0.0; 2];
                place[part] = number * unit;
                let at = self.shown.pixel(place);
                let color = if number % 5.0 == 0.0 { strong } else { weak };
                let stroke = Stroke::new(1.0, color);
                if part == 0 {
                    painter.vline(at.x, rect.y_range(), stroke);
                } else {
                    painter.hline(rect.x_range(), at.y, stroke);
                }
                number += 1.0;
            }
        }
    }

    /// The whole paths of traced points; while something is dragged, as they are then.
    fn paths(&self, painter: &Painter) {
        for path in self.editor.sight.seen_paths() {
            let points: Vec<Pos2> = path.iter().map(|place| self.shown.pixel(*place)).collect();
            painter.line(points, Stroke::new(1.5, Color32::from_rgb(180, 40, 120)));
        }
    }

    fn arrows(&self, painter: &Painter) {
        for Arrow { kind, place, vector, scale } in self.editor.arrows() {
            let tip = [place[0] + scale * vector[0], place[1] + scale * vector[1]];
            let [from, to] = [place, tip].map(|end| self.shown.pixel(end));
            let color = match kind {
                ArrowKind::Velocity => Color32::from_rgb(0, 114, 178),
                ArrowKind::Acceleration => Color32::from_rgb(200, 40, 30),
                ArrowKind::Force => Color32::from_rgb(0, 140, 90),
            };
            // An arrow shorter than a pin would be hidden beside it.
            if from.distance(to) > 2.0 {
                arrow(painter, [from, to], Stroke::new(2.0, color));
            }
        }
    }

    fn selected_links(&self, painter: &Painter, visuals: &egui::Visuals) {
        let Some(drawing) = self.editor.sight.seen_drawing() else {
            return;
        };
        let Selection { items, hovered, .. } = &self.editor.selection;
        for item in items.iter().chain(hovered) {
            let Item::Link(name) = item else {
                continue;
            };
            let Some(link) = drawing.link(name) else {
                continue;
            };
            let places = outline(drawing.places_on(link));
            let mut points: Vec<Pos2> =
                places.iter().map(|place| self.shown.pixel(*place)).collect();
            if points.len() > 2 {
                points.push(points[0]);
            }
            painter.line(points, Stroke::new(2.5, visuals.selection.stroke.color));
        }
    }

    /// Paints the picks, the place that the pointer means, and the lines to the places with which it is aligned.
    fn tool(&self, painter: &Painter, visuals: &egui::Visuals) {
        let accent = visuals.selection.stroke.color;
        let picked = self.editor.picking.picks.iter();
        let picked = picked.map(|pick| self.shown.pixel(pick.place));
        let mut places: Vec<Pos2> = picked.collect();
        if let Some(snapped) = self.snapped {
            let at = self.shown.pixel(snapped.pick.place);
            for guide in &snapped.guides {
                let from = self.shown.pixel(*guide);
                painter.extend(egui::Shape::dashed_line(
                    &[from, at],
                    Stroke::new(1.0, accent),
                    4.0,
                    4.0,
                ));
            }
            painter.circle_stroke(at, 5.0, Stroke::new(1.5, accent));
            let [x, y] = snapped
                .pick
                .place
                .map(|part| crate::text::shortest(part, 0.5 / self.shown.scale()));
            painter.text(
                at + Vec2::new(10.0, 12.0),
                Align2::LEFT_TOP,
                format!("({x}, {y})"),
                FontId::proportional(12.0),
                accent,
            );
            places.push(at);
        }
        if places.len() > 1 && self.editor.picking.tool != super::Tool::Select {
            painter.line(places, Stroke::new(3.0, accent.gamma_multiply(0.6)));
        }
    }
}

/// A line with a filled head, which is never longer than half of it.
fn arrow(painter: &Painter, [from, to]: [Pos2; 2], stroke: Stroke) {
    let along = (to - from).normalized();
    let head = (0.5 * from.distance(to)).min(9.0);
    let (base, side) = (to - head * along, 0.45 * head * along.rot90());
    painter.line_segment([from, base], stroke);
    painter.add(egui::Shape::convex_polygon(
        vec![to, base + side, base - side],
        stroke.color,
        Stroke::NONE,
    ));
}
