//! What is painted over and under the bodies: the grid, the schematic, paths, handles, and what a tool is about.

use super::Shown;
use crate::editor::colors::distinct;
use crate::editor::drawing::{Drawing, Handle, HandleKind};
use crate::editor::settings::Visible;
use crate::editor::snap::{Snapped, grid};
use crate::editor::{Arrow, ArrowKind, Editor, Item};
use eframe::egui;
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Stroke, Vec2};
use mech_compiler::model::{JointKind, LinkId, ShapeKind};
use std::collections::HashSet;

const PIN: f32 = 6.0;

/// Paints what is seen besides the bodies.
pub(super) struct Paint<'p> {
    pub(super) editor: &'p Editor,
    pub(super) shown: &'p Shown,
    pub(super) snapped: Option<&'p Snapped>,
}

impl Paint<'_> {
    /// What is under the handles.
    pub(super) fn behind(&self, ui: &egui::Ui) {
        let painter = ui.painter().with_clip_rect(self.shown.rect);
        let settings = &self.editor.settings;
        if settings.shows(Visible::Grid) {
            self.grid(&painter, ui.visuals());
        }
        if settings.shows(Visible::Paths) {
            self.paths(&painter);
        }
        if let Some(drawing) = self.editor.seen_drawing() {
            if !self.editor.shows_bodies() {
                self.schematic(&painter, drawing, 1.0);
            }
            self.actions(&painter, drawing, ui.visuals());
            self.ranges(&painter, drawing);
        }
        if let Some(ghost) = &self.editor.ghost {
            self.schematic(&painter, &ghost.drawing, 0.45);
        }
        if !self.editor.is_readable() && self.editor.drawing.is_some() {
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
            let is_marked = self.is_marked(handle.item);
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
        for path in self.editor.seen_paths() {
            let points: Vec<Pos2> = path.iter().map(|place| self.shown.pixel(*place)).collect();
            painter.line(points, Stroke::new(1.5, Color32::from_rgb(180, 40, 120)));
        }
    }

    /// Links as bars and plates, with the shapes that they declare.
    fn schematic(&self, painter: &Painter, drawing: &Drawing, strength: f32) {
        self.shapes(
            painter,
            drawing,
            LinkId::GROUND,
            Color32::GRAY.gamma_multiply(0.3 * strength),
        );
        for (index, link) in drawing.model.declared_links().enumerate() {
            let color = distinct(index).gamma_multiply(strength);
            self.shapes(painter, drawing, link, color.gamma_multiply(0.4));
            if let Some((center, radius)) = drawing.wheel(link) {
                painter.circle(
                    self.shown.pixel(center),
                    self.length(radius),
                    color.gamma_multiply(0.15),
                    Stroke::new(3.0, color),
                );
            }
            let places = outline(drawing.places_on(link));
            let points: Vec<Pos2> = places
                .iter()
                .map(|place| self.shown.pixel(*place))
                .collect();
            match points[..] {
                [] => {}
                [only] => drop(painter.circle_filled(only, 9.0, color.gamma_multiply(0.5))),
                [from, to] => drop(
                    painter.line_segment([from, to], Stroke::new(8.0, color.gamma_multiply(0.75))),
                ),
                _ => {
                    let stroke = Stroke::new(6.0, color.gamma_multiply(0.75));
                    painter.add(egui::Shape::convex_polygon(
                        points,
                        color.gamma_multiply(0.3),
                        stroke,
                    ));
                }
            }
        }
    }

    /// The shapes that a link declares.
    fn shapes(&self, painter: &Painter, drawing: &Drawing, link: LinkId, color: Color32) {
        let pose = drawing.pose(link);
        let pixel = |place: &[f64; 2]| self.shown.pixel(super::super::drawing::apply(pose, *place));
        for shape in &drawing.model.link(link).shapes {
            match &shape.kind {
                ShapeKind::Circle { center, radius } => {
                    painter.circle_filled(pixel(center), self.length(*radius), color);
                }
                ShapeKind::Ring {
                    center,
                    radius,
                    hole,
                } => {
                    let [middle, width] = [f64::midpoint(*radius, *hole), radius - hole];
                    painter.circle_stroke(
                        pixel(center),
                        self.length(middle),
                        Stroke::new(self.length(width), color),
                    );
                }
                ShapeKind::Bar { pins, width } => {
                    let points = pins.iter().map(pixel).collect();
                    painter.line(points, Stroke::new(self.length(*width), color));
                }
                ShapeKind::Polygon(corners) => {
                    let points = corners.iter().map(pixel).collect();
                    painter.add(egui::Shape::closed_line(points, Stroke::new(2.0, color)));
                }
                ShapeKind::Figure(_) => {}
            }
        }
    }

    #[expect(clippy::cast_possible_truncation, reason = "a length in pixels")]
    fn length(&self, length: f64) -> f32 {
        (length * self.shown.scale()) as f32
    }

    /// Springs, dampers and loads.
    fn actions(&self, painter: &Painter, drawing: &Drawing, visuals: &egui::Visuals) {
        for (name, ends) in drawing.actions() {
            let is_selected = self
                .editor
                .selection
                .contains(&Item::Action(name.to_owned()));
            let color = if is_selected {
                visuals.selection.stroke.color
            } else {
                Color32::from_rgb(110, 70, 160)
            };
            let ends = ends.map(|end| self.shown.pixel(end));
            painter.add(egui::Shape::line(zigzag(ends), Stroke::new(1.5, color)));
        }
    }

    /// A green arc about each motor that turns, over the range in which it can.
    fn ranges(&self, painter: &Painter, drawing: &Drawing) {
        for range in self.editor.ranges.iter().filter(|range| range.turns) {
            let center = drawing
                .joint(&range.name)
                .and_then(|joint| drawing.axis_of_joint(joint));
            let Some(center) = center.map(|axis| self.shown.pixel(drawing.place(axis))) else {
                continue;
            };
            let [low, high] = range.ends;
            let point = |part: u32| {
                let angle = low + (high - low) * f64::from(part) / 64.0;
                #[expect(clippy::cast_possible_truncation, reason = "a direction")]
                let [cos, sin] = [angle.cos(), angle.sin()].map(|part| part as f32);
                center + 20.0 * Vec2::new(cos, -sin)
            };
            let green = Color32::from_rgb(30, 150, 60);
            let width = if range.basis == super::super::range::Basis::Walked {
                2.0
            } else {
                3.5
            };
            painter.add(egui::Shape::line(
                (0..=64).map(point).collect(),
                Stroke::new(width, green),
            ));
        }
    }

    /// Whether a handle that is there can be seen.
    fn is_on_canvas(&self, place: [f64; 2]) -> bool {
        let around = self.shown.rect.expand(60.0);
        around.contains(self.shown.pixel(place))
    }

    /// Whether something is selected or under the mouse.
    fn is_marked(&self, item: &Item) -> bool {
        self.editor.selection.contains(item) || self.editor.hovered.as_ref() == Some(item)
    }

    fn handle(&self, painter: &Painter, handle: Handle, visuals: &egui::Visuals) {
        let center = self.shown.pixel(handle.place);
        let drawing = self.editor.seen_drawing();
        let is_selected = self.editor.selection.contains(handle.item);
        let color = if self.is_marked(handle.item) {
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
        if self.editor.is_locked(handle.item) {
            padlock(painter, center + Vec2::new(-11.0, -9.0), color);
        }
        let Some(drawing) = drawing else {
            return;
        };
        if let Item::Joint(name) = handle.item {
            self.signs(painter, drawing, name, center, visuals);
        }
    }

    /// What a joint is besides a pin: on the ground, driven, in the way.
    fn signs(
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
                painter.line_segment(
                    [center + Vec2::new(0.0, PIN), foot + Vec2::new(side, 0.0)],
                    ink,
                );
            }
            painter.line_segment(
                [foot - Vec2::new(13.0, 0.0), foot + Vec2::new(13.0, 0.0)],
                ink,
            );
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
    fn rail(&self, drawing: &Drawing, joint: mech_compiler::model::JointId) -> Option<[Pos2; 2]> {
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

    /// Velocities, accelerations and forces.
    fn arrows(&self, painter: &Painter) {
        for Arrow {
            kind,
            place,
            vector,
            scale,
        } in self.editor.arrows()
        {
            let tip = [place[0] + scale * vector[0], place[1] + scale * vector[1]];
            let [from, to] = [place, tip].map(|end| self.shown.pixel(end));
            let color = match kind {
                ArrowKind::Velocity => Color32::from_rgb(0, 114, 178),
                ArrowKind::Acceleration => Color32::from_rgb(200, 40, 30),
                ArrowKind::Force => Color32::from_rgb(0, 140, 90),
            };
            // What is shorter than a pin is not seen beside it.
            if from.distance(to) > 2.0 {
                arrow(painter, [from, to], Stroke::new(2.0, color));
            }
        }
    }

    fn selected_links(&self, painter: &Painter, visuals: &egui::Visuals) {
        let Some(drawing) = self.editor.seen_drawing() else {
            return;
        };
        let chosen = self.editor.selection.iter().chain(&self.editor.hovered);
        for item in chosen {
            let Item::Link(name) = item else {
                continue;
            };
            let Some(link) = drawing.link(name) else {
                continue;
            };
            let places = outline(drawing.places_on(link));
            let mut points: Vec<Pos2> = places
                .iter()
                .map(|place| self.shown.pixel(*place))
                .collect();
            if points.len() > 2 {
                points.push(points[0]);
            }
            painter.line(points, Stroke::new(2.5, visuals.selection.stroke.color));
        }
    }

    /// What was picked, where the pointer means, and with what that is aligned.
    fn tool(&self, painter: &Painter, visuals: &egui::Visuals) {
        let accent = visuals.selection.stroke.color;
        let picked = self
            .editor
            .picks
            .iter()
            .map(|pick| self.shown.pixel(pick.place));
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
        if places.len() > 1 && self.editor.tool != super::Tool::Select {
            painter.line(places, Stroke::new(3.0, accent.gamma_multiply(0.6)));
        }
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

/// The places where names stand: where there is one, there is no room for another.
#[derive(Default)]
struct NameSpaces(HashSet<[i32; 2]>);

impl NameSpaces {
    /// The room that a name takes, in pixels.
    const ROOM: Vec2 = Vec2::new(24.0, 14.0);

    /// Takes the place of a name beside a handle, if it is free.
    fn take(&mut self, center: Pos2) -> bool {
        let cell = center.to_vec2() / Self::ROOM;
        #[expect(clippy::cast_possible_truncation, reason = "pixels of a window")]
        self.0
            .insert([cell.x.floor() as i32, cell.y.floor() as i32])
    }
}

/// The corners of the convex outline of places, in their order.
fn outline(mut places: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    places.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    places.dedup();
    if places.len() < 3 {
        return places;
    }
    let half = |places: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut side: Vec<[f64; 2]> = Vec::new();
        for place in places {
            while let [.., a, b] = side[..] {
                let turn = (b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0]);
                if turn > 0.0 {
                    break;
                }
                side.pop();
            }
            side.push(place);
        }
        side.pop();
        side
    };
    let mut corners = half(&mut places.iter().copied());
    corners.extend(half(&mut places.iter().rev().copied()));
    corners
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

/// A zigzag from one place to another.
fn zigzag([from, to]: [Pos2; 2]) -> Vec<Pos2> {
    let along = to - from;
    let across = 6.0 * along.normalized().rot90();
    let mut points = vec![from];
    for number in 0_u8..9 {
        let part = (f32::from(number) + 1.0) / 10.0;
        let side = if number % 2 == 0 { across } else { -across };
        points.push(from + part * along + side);
    }
    points.push(to);
    points
}

#[cfg(test)]
mod tests {
    use super::outline;

    #[test]
    fn an_outline_has_no_place_that_is_within() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        let mut all = square.to_vec();
        all.push([1.0, 1.0]);
        assert_eq!(outline(all), square);
        assert_eq!(
            outline(vec![[1.0, 0.0], [0.0, 0.0]]),
            [[0.0, 0.0], [1.0, 0.0]]
        );
    }
}

/// A small padlock, of something that the pointer cannot move.
fn padlock(painter: &Painter, center: Pos2, color: Color32) {
    let body = egui::Rect::from_center_size(center, Vec2::new(8.0, 6.0));
    painter.circle_stroke(center - Vec2::new(0.0, 3.5), 2.5, Stroke::new(1.2, color));
    painter.rect_filled(body, 1.0, color);
}
