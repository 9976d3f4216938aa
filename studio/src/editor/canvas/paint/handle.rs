//! Handles, with the signs of joints.

use super::Paint;
use crate::editor::Item;
use crate::editor::drawing::{Drawing, Handle};
use crate::editor::index::HandleKind;
use eframe::egui::{self, Color32, Painter, Pos2, Stroke, Vec2};
use mech_compiler::model::{JointId, JointKind, LinkId};
use std::collections::HashSet;

pub(super) const PIN: f32 = 6.0;

impl Paint<'_> {
    /// Whether a handle that is there can be seen.
    pub(super) fn is_on_canvas(&self, place: [f64; 2]) -> bool {
        let around = self.shown.rect.expand(60.0);
        around.contains(self.shown.pixel(place))
    }

    pub(super) fn handle(&self, painter: &Painter, handle: Handle, visuals: &egui::Visuals) {
        let center = self.shown.pixel(handle.place);
        let drawing = self.editor.sight.seen_drawing();
        let is_selected = self.editor.selection.items.contains(handle.item);
        let color = if self.editor.selection.marks(handle.item) {
            visuals.selection.stroke.color
        } else {
            visuals.strong_text_color()
        };
        let fill = visuals.extreme_bg_color;
        let stroke = Stroke::new(if is_selected { 3.0 } else { 1.5 }, color);
        match handle.kind {
            HandleKind::Pin => ring(painter, center, PIN, fill, stroke),
            HandleKind::Slide | HandleKind::Weld => {
                let rect = egui::Rect::from_center_size(center, Vec2::splat(2.0 * PIN));
                painter.rect(rect, 1.0, fill, stroke, egui::StrokeKind::Middle);
            }
            HandleKind::Point => ring(painter, center, 4.0, color, stroke),
            HandleKind::Line => ring(painter, center, 3.0, fill, stroke),
        }
        if self.editor.desk.is_locked(handle.item) {
            padlock(painter, center + Vec2::new(-11.0, -9.0), color);
        }
        let Some(drawing) = drawing else {
            return;
        };
        if let Item::Joint(name) = handle.item {
            self.signs(painter, drawing, name, center, visuals);
        }
    }

    /// Paints the signs of a joint: its rail, the ground, its motor.
    pub(super) fn signs(
        &self,
        painter: &Painter,
        drawing: &Drawing,
        name: &str,
        center: Pos2,
        visuals: &egui::Visuals,
    ) {
        let Some(joint) = drawing.joint(name) else {
            return;
        };
        let (a, b) = drawing.model.ends(joint);
        let ink = Stroke::new(1.5, visuals.text_color());
        if let Some([from, to]) = self.rail(drawing, joint) {
            painter.extend(egui::Shape::dashed_line(&[from, to], ink, 6.0, 4.0));
        } else if a == LinkId::GROUND || b == LinkId::GROUND {
            let foot = center + Vec2::new(0.0, 16.0);
            for side in [-9.0, 9.0] {
                painter
                    .line_segment([center + Vec2::new(0.0, PIN), foot + Vec2::new(side, 0.0)], ink);
            }
            painter.line_segment([foot - Vec2::new(13.0, 0.0), foot + Vec2::new(13.0, 0.0)], ink);
            for dash in [-9.0, -3.0, 3.0, 9.0] {
                let from = foot + Vec2::new(dash, 0.0);
                painter.line_segment([from, from + Vec2::new(-4.0, 5.0)], ink);
            }
        }
        if drawing.model.motor_of(joint).is_some() {
            let red = Stroke::new(2.5, Color32::from_rgb(200, 40, 30));
            painter.circle_stroke(center, PIN + 5.0, red);
            let tip = center + Vec2::new(PIN + 5.0, 0.0);
            painter.line_segment([tip, tip + Vec2::new(-4.0, -4.0)], red);
            painter.line_segment([tip, tip + Vec2::new(4.0, -4.0)], red);
        }
    }

    /// The rail of a joint that slides, in the window.
    pub(super) fn rail(&self, drawing: &Drawing, joint: JointId) -> Option<[Pos2; 2]> {
        let JointKind::Prismatic(guide, _) = drawing.model.joint(joint).kind else {
            return None;
        };
        let [x, y] = drawing.direction(guide);
        let center = drawing.axis_of_joint(joint).unwrap_or(guide);
        let center = self.shown.pixel(drawing.place(center));
        #[expect(clippy::cast_possible_truncation, reason = "a direction")]
        let along = 46.0 * Vec2::new(x as f32, -y as f32);
        Some([center - along, center + along])
    }
}

/// A disc with a border. Two discs are painted sooner than one with a border.
fn ring(painter: &Painter, center: Pos2, radius: f32, fill: Color32, border: Stroke) {
    let half = 0.5 * border.width;
    painter.circle_filled(center, radius + half, border.color);
    if fill != border.color {
        painter.circle_filled(center, radius - half, fill);
    }
}

/// A small padlock, of something that the pointer cannot move.
fn padlock(painter: &Painter, center: Pos2, color: Color32) {
    let body = egui::Rect::from_center_size(center, Vec2::new(8.0, 6.0));
    painter.circle_stroke(center - Vec2::new(0.0, 3.5), 2.5, Stroke::new(1.2, color));
    painter.rect_filled(body, 1.0, color);
}

/// The places where names stand: where there is one, there is no room for another.
#[derive(Default)]
pub(super) struct NameSpaces(HashSet<[i32; 2]>);

impl NameSpaces {
    /// The room that a name takes, in pixels.
    const ROOM: Vec2 = Vec2::new(24.0, 14.0);

    /// Takes the place of a name beside a handle, if it is free.
    pub(super) fn take(&mut self, center: Pos2) -> bool {
        let cell = center.to_vec2() / Self::ROOM;
        #[expect(clippy::cast_possible_truncation, reason = "pixels of a window")]
        self.0.insert([cell.x.floor() as i32, cell.y.floor() as i32])
    }
}
