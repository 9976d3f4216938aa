//! The mechanism without its bodies: bars, plates, springs, and the ranges of motors.

use super::Paint;
use super::handle::PIN;
use crate::editor::Item;
use crate::editor::canvas::witness::arc;
use crate::editor::colors::distinct;
use crate::editor::drawing::Drawing;
use crate::motion::Basis;
use eframe::egui::{self, Color32, Painter, Pos2, Stroke};
use mech_compiler::model::{LinkId, ShapeKind};

impl Paint<'_> {
    /// Links as bars and plates, with the shapes that they declare.
    pub(super) fn schematic(&self, painter: &Painter, drawing: &Drawing, strength: f32) {
        self.shapes(painter, drawing, LinkId::GROUND, Color32::GRAY.gamma_multiply(0.3 * strength));
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
            let points: Vec<Pos2> = places.iter().map(|place| self.shown.pixel(*place)).collect();
            match points[..] {
                [] => {}
                [only] => drop(painter.circle_filled(only, 9.0, color.gamma_multiply(0.5))),
                [from, to] => drop(
                    painter.line_segment([from, to], Stroke::new(8.0, color.gamma_multiply(0.75))),
                ),
                _ => {
                    // Sides alone: joined ones would have needles where pins lie nearly in a line.
                    let stroke = Stroke::new(6.0, color.gamma_multiply(0.75));
                    let next = points.iter().cycle().skip(1);
                    for (from, to) in points.iter().zip(next) {
                        painter.line_segment([*from, *to], stroke);
                    }
                    let inside = color.gamma_multiply(0.3);
                    painter.add(egui::Shape::convex_polygon(points, inside, Stroke::NONE));
                }
            }
        }
    }

    pub(super) fn shapes(
        &self,
        painter: &Painter,
        drawing: &Drawing,
        link: LinkId,
        color: Color32,
    ) {
        let pose = drawing.pose(link);
        let pixel = |place: &[f64; 2]| self.shown.pixel(pose.apply(*place));
        for shape in &drawing.model.link(link).shapes {
            match &shape.kind {
                ShapeKind::Circle { center, radius } => {
                    painter.circle_filled(pixel(center), self.length(*radius), color);
                }
                ShapeKind::Ring { center, radius, hole } => {
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
    pub(super) fn length(&self, length: f64) -> f32 {
        (length * self.shown.scale()) as f32
    }

    pub(super) fn actions(&self, painter: &Painter, drawing: &Drawing, visuals: &egui::Visuals) {
        for (name, ends) in drawing.actions() {
            let item = Item::Action(name.to_owned());
            let is_selected = self.editor.selection.items.contains(&item);
            let color = if is_selected {
                visuals.selection.stroke.color
            } else {
                Color32::from_rgb(110, 70, 160)
            };
            let ends = ends.map(|end| self.shown.pixel(end));
            painter.add(egui::Shape::line(zigzag(ends), Stroke::new(1.5, color)));
        }
    }

    /// A dashed line between the ends of each joint that does not close as drawn.
    pub(super) fn gaps(&self, painter: &Painter, drawing: &Drawing, visuals: &egui::Visuals) {
        let stroke = Stroke::new(1.5, visuals.warn_fg_color);
        let ends = drawing.ends_of_joints();
        let ends = ends.map(|ends| ends.map(|end| self.shown.pixel(end)));
        for [from, to] in ends.filter(|[from, to]| from.distance(*to) > PIN) {
            painter.extend(egui::Shape::dashed_line(&[from, to], stroke, 6.0, 4.0));
            for end in [from, to] {
                painter.circle_stroke(end, PIN, stroke);
            }
        }
    }

    /// A green arc about each motor that turns, over the range in which it can.
    pub(super) fn ranges(&self, painter: &Painter, drawing: &Drawing) {
        let ranges = self.editor.sight.playing.ranges.iter();
        for range in ranges.filter(|range| range.turns) {
            let Some(center) = drawing.place_of_joint(&range.name) else {
                continue;
            };
            let center = self.shown.pixel(center);
            let green = Color32::from_rgb(30, 150, 60);
            let width = if range.basis == Basis::Declared { 3.5 } else { 2.0 };
            painter.add(egui::Shape::line(arc(center, range.ends), Stroke::new(width, green)));
        }
    }
}

/// The corners of the convex outline of places, in their order.
pub(super) fn outline(mut places: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
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
        assert_eq!(outline(vec![[1.0, 0.0], [0.0, 0.0]]), [[0.0, 0.0], [1.0, 0.0]]);
    }
}
