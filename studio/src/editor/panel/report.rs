//! The compiler's report on the mechanism.

use crate::editor::analysis::Analysis;
use eframe::egui::{
    self, Align2, Color32, CornerRadius, FontId, Pos2, Rect, Role, Sense, Stroke, Vec2, WidgetInfo,
};
use mech_compiler::graphs::{self, Edge, EdgeKind, Graph, Vertex, VertexKind};

/// The report: what the mechanism does; how each loop is solved, what is proved, what it costs; with the graphs of links and of loops.
pub(in crate::editor) fn report(analysis: &Analysis, ui: &mut egui::Ui) {
    let snapshot = &analysis.snapshot;
    let (Some(compiled), Some(reading)) = (snapshot.compiled(), &snapshot.reading) else {
        ui.weak("The mechanism does not move yet; see Diagnoses.");
        return;
    };
    egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        let part = |ui: &mut egui::Ui, title: &str, show: &mut dyn FnMut(&mut egui::Ui)| {
            egui::CollapsingHeader::new(title).default_open(true).show(ui, |ui| show(ui));
        };
        part(ui, "What it does", &mut |ui| match &analysis.behaviour {
            Some(behaviour) => behaviour.lines.lines().for_each(|line| motion_line(line, ui)),
            None => {
                ui.weak("It is measured.");
            }
        });
        part(ui, "Links and joints, which turn where nothing else is said", &mut |ui| {
            graph(&graphs::kinematic(&reading.model, &compiled.structure), ui);
        });
        let loops = graphs::loops(&reading.model, &compiled.plan);
        if !loops.edges.is_empty() {
            part(ui, "Loops, after what determines them", &mut |ui| {
                graph(&loops, ui);
            });
        }
        let shared = graphs::common_joints(&reading.model, &compiled.plan);
        if !shared.edges.is_empty() {
            part(ui, "Loops with joints in common", &mut |ui| {
                graph(&shared, ui);
            });
        }
        part(ui, "Methods, errors and operations", &mut |ui| {
            egui::ScrollArea::horizontal().id_salt("report").show(ui, |ui| {
                let text = egui::RichText::new(&compiled.report).monospace();
                ui.add(egui::Label::new(text).extend());
            });
        });
    });
}

/// A line of what it does. What a motor drives stands under the motor.
fn motion_line(line: &str, ui: &mut egui::Ui) {
    let words: Vec<&str> = line.split_whitespace().collect();
    let text = words.join(" ");
    if line.starts_with("    ") {
        ui.indent(line, |ui| ui.label(text));
    } else {
        ui.label(text);
    }
}

/// The room of a row and of a vertex, in points of the window.
const ROW: f32 = 92.0;
const VERTEX: Vec2 = Vec2::new(76.0, 30.0);
const GAP: f32 = 12.0;
const PARTS: u8 = 24;
const FONT: FontId = FontId::proportional(12.0);

/// Draws a graph: a row for each level, and an arc for each edge.
pub(super) fn graph(graph: &Graph, ui: &mut egui::Ui) {
    let rows = rows(graph);
    let widest = rows.iter().map(Vec::len).max().unwrap_or(0);
    #[expect(clippy::cast_precision_loss, reason = "a few vertices")]
    let [columns, count] = [widest, rows.len()].map(|count| count as f32);
    let width = (columns * (VERTEX.x + GAP)).max(ui.available_width().min(320.0));
    let has_arcs = graph
        .edges
        .iter()
        .any(|edge| graph.vertices[edge.from].level == graph.vertices[edge.to].level);
    let room = if has_arcs { 44.0 } else { 24.0 };
    let size = Vec2::new(width, (count - 1.0).max(0.0) * ROW + VERTEX.y + room);
    egui::ScrollArea::horizontal().id_salt(&graph.name).show(ui, |ui| {
        let (response, painter) = ui.allocate_painter(size, Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &graph.name));
        let places = places(graph, &rows, response.rect);
        let mut lines = Vec::new();
        for (number, edge) in graph.edges.iter().enumerate() {
            let before =
                graph.edges[..number].iter().filter(|other| joins_same(edge, other)).count();
            let (from, to) = (places[edge.from], places[edge.to]);
            let points = arc([from, to], before);
            line(&painter, edge, &points, graph.directed, ui.visuals());
            lines.push((edge, points));
        }
        let boxes = places.iter().map(|place| Rect::from_center_size(*place, VERTEX));
        let mut taken: Vec<Rect> = boxes.collect();
        for (edge, points) in &lines {
            label(&painter, edge, points, &mut taken, ui.visuals());
        }
        for (vertex, place) in graph.vertices.iter().zip(&places) {
            self::vertex(&painter, vertex, *place, ui.visuals());
        }
    });
}

/// The numbers of the vertices of each level.
fn rows(graph: &Graph) -> Vec<Vec<usize>> {
    let mut levels: Vec<usize> = graph.vertices.iter().map(|vertex| vertex.level).collect();
    levels.sort_unstable();
    levels.dedup();
    let row = |level: &usize| {
        let all = graph.vertices.iter().enumerate();
        all.filter(|(_, vertex)| vertex.level == *level).map(|(number, _)| number).collect()
    };
    levels.iter().map(row).collect()
}

fn places(graph: &Graph, rows: &[Vec<usize>], rect: Rect) -> Vec<Pos2> {
    let mut places = vec![rect.center(); graph.vertices.len()];
    for (row, vertices) in rows.iter().enumerate() {
        for (column, vertex) in vertices.iter().enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "a few vertices")]
            let [row, column, count] = [row, column, vertices.len()].map(|number| number as f32);
            let x = rect.left() + rect.width() * (column + 0.5) / count;
            places[*vertex] = Pos2::new(x, rect.top() + 12.0 + VERTEX.y / 2.0 + row * ROW);
        }
    }
    places
}

fn joins_same(a: &Edge, b: &Edge) -> bool {
    [a.from.min(a.to), a.from.max(a.to)] == [b.from.min(b.to), b.from.max(b.to)]
}

/// An edge as an arc: each of several between the same vertices bends farther.
fn arc([from, to]: [Pos2; 2], before: usize) -> Vec<Pos2> {
    #[expect(clippy::cast_precision_loss, reason = "a few edges")]
    let before = before as f32;
    // Those in a row go below it.
    let is_level = (from.y - to.y).abs() < 1.0;
    let bend =
        if is_level { Vec2::new(0.0, 46.0 + 22.0 * before) } else { Vec2::new(26.0 * before, 0.0) };
    let middle = from + 0.5 * (to - from) + bend;
    let point = |part: u8| {
        let part = f32::from(part) / f32::from(PARTS);
        let (a, b) = (from + part * (middle - from), middle + part * (to - middle));
        a + part * (b - a)
    };
    (0..=PARTS).map(point).collect()
}

fn line(
    painter: &egui::Painter,
    edge: &Edge,
    points: &[Pos2],
    is_directed: bool,
    visuals: &egui::Visuals,
) {
    let stroke = Stroke::new(if edge.motor { 2.5 } else { 1.5 }, color(edge, visuals));
    if let Some(&to) = points.last().filter(|_| is_directed) {
        let target = Rect::from_center_size(to, VERTEX + Vec2::new(0.0, 8.0));
        if let Some(&end) = points.iter().rev().find(|point| !target.contains(**point)) {
            let along = (to - end).normalized();
            let side = 5.0 * along.rot90();
            let head = vec![end, end - 9.0 * along + side, end - 9.0 * along - side];
            painter.add(egui::Shape::convex_polygon(head, stroke.color, Stroke::NONE));
        }
    }
    if edge.kind == EdgeKind::Arm {
        painter.extend(egui::Shape::dashed_line(points, stroke, 5.0, 3.0));
    } else {
        painter.line(points.to_vec(), stroke);
    }
}

fn color(edge: &Edge, visuals: &egui::Visuals) -> Color32 {
    if edge.motor {
        Color32::from_rgb(200, 40, 30)
    } else {
        visuals.text_color().gamma_multiply(0.7)
    }
}

/// The name of an edge on its own ground, where nothing else is written; else in its middle.
fn label(
    painter: &egui::Painter,
    edge: &Edge,
    points: &[Pos2],
    taken: &mut Vec<Rect>,
    visuals: &egui::Visuals,
) {
    // Most joints turn; that is said once, above the graph.
    let detail = Some(edge.detail.as_str()).filter(|detail| *detail != "revolute");
    let words = [edge.name.as_str(), detail.unwrap_or_default()];
    let words: Vec<&str> = words.into_iter().filter(|word| !word.is_empty()).collect();
    if words.is_empty() {
        return;
    }
    let color = color(edge, visuals);
    let galley = painter.layout_no_wrap(words.join("\n"), FONT, color);
    let area = |place: usize| {
        let center = points.get(place).copied().unwrap_or_default();
        Align2::CENTER_CENTER.anchor_size(center, galley.size())
    };
    let middle = usize::from(PARTS / 2);
    let mut areas = (0..8).flat_map(|away| [middle - away, middle + away]).map(area);
    let free = areas.find(|area| !taken.iter().any(|other| other.intersects(*area)));
    let rect = free.unwrap_or_else(|| area(middle));
    painter.rect_filled(rect.expand(1.0), 2.0, visuals.panel_fill);
    taken.push(rect);
    painter.galley(rect.min, galley.clone(), color);
}

fn vertex(painter: &egui::Painter, vertex: &Vertex, place: Pos2, visuals: &egui::Visuals) {
    let ink = visuals.strong_text_color();
    let text = if vertex.detail.is_empty() {
        vertex.name.clone()
    } else {
        format!("{}\n{}", vertex.name, vertex.detail)
    };
    let galley = painter.layout(text, FONT, ink, VERTEX.x + 24.0);
    let size = (galley.size() + Vec2::new(14.0, 8.0)).max(Vec2::new(44.0, VERTEX.y));
    let rect = Rect::from_center_size(place, size);
    let fill = match vertex.kind {
        VertexKind::Ground => visuals.widgets.inactive.bg_fill,
        VertexKind::Link | VertexKind::Loop | VertexKind::Motor => visuals.extreme_bg_color,
    };
    let stroke = match vertex.kind {
        VertexKind::Motor => Stroke::new(2.0, Color32::from_rgb(200, 40, 30)),
        VertexKind::Ground | VertexKind::Link | VertexKind::Loop => Stroke::new(1.0, ink),
    };
    painter.rect(rect, CornerRadius::same(6), fill, stroke, egui::StrokeKind::Middle);
    painter.galley(rect.center() - galley.size() / 2.0, galley, ink);
}
