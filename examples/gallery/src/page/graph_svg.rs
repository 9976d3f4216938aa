//! Graphs as SVG, in a page that gives them their colours.

use super::escape;
use super::graph_layout::{Layout, Point, Sketch};
use mech_compiler::graphs::{Edge, EdgeKind, Graph, Vertex, VertexKind};
use std::fmt::{Result, Write};

/// The style of the classes below.
pub(crate) const STYLE: &str = "\
.graph { display: block; max-width: 100%; height: auto; }
.graph text {
  font: 13px/1 ui-sans-serif, system-ui, sans-serif; text-anchor: middle; fill: var(--text);
}
.graph .soft { fill: var(--soft); font-size: 11px; }
.graph rect { fill: var(--back); stroke: var(--soft); }
.graph .ground rect { stroke: none; fill: var(--line); }
.graph .ground path, .graph .edge path { fill: none; stroke: var(--soft); stroke-width: 1.5; }
.graph .edge text { paint-order: stroke; stroke: var(--card); stroke-width: 7px; stroke-linejoin: round; }
.graph .edge polygon { fill: var(--soft); }
.graph .arm path { stroke-dasharray: 5 4; }
.graph .motor path { stroke: var(--accent); stroke-width: 3; }
.graph .motor text { fill: var(--accent); font-weight: 600; }
.graph .motor rect { stroke: var(--accent); fill: var(--card); }
";

/// The size of letters, that of small letters, and the height of a line.
const LETTER: f64 = 13.0;
const SMALL: f64 = 11.0;
const LINE: f64 = 17.0;
/// Space beside the text of a vertex, above and below.
const ASIDE: f64 = 12.0;
const ABOVE: f64 = 6.5;

/// A picture of more vertices cannot be read, and takes long to arrange.
const MOST_VERTICES: usize = 16;

/// The picture of a graph; none of one that is too large to be read.
pub(crate) fn svg(graph: &Graph) -> Option<String> {
    if !is_readable(graph) {
        return None;
    }
    let layout = Layout::new(&sketch(graph));
    let mut text = String::new();
    // Writing into a string does not fail.
    let _ = write(&mut text, graph, &layout);
    Some(text)
}

/// Whether a graph is small enough for a picture.
pub(crate) fn is_readable(graph: &Graph) -> bool {
    graph.vertices.len() <= MOST_VERTICES
}

/// A graph without its names.
pub(crate) fn sketch(graph: &Graph) -> Sketch {
    let edges = graph.edges.iter();
    Sketch {
        boxes: graph.vertices.iter().map(vertex_size).collect(),
        rows: graph.vertices.iter().map(|vertex| vertex.level).collect(),
        edges: edges.map(|edge| (edge.from, edge.to, label_size(edge))).collect(),
        // The ground is below, but what comes first is above.
        upwards: !graph.directed,
        has_arrows: graph.directed,
    }
}

fn vertex_size(vertex: &Vertex) -> Point {
    let width = width(&vertex.name, LETTER).max(width(&vertex.detail, SMALL));
    let lines = if vertex.detail.is_empty() { 1.0 } else { 2.0 };
    [width + 2.0 * ASIDE, lines * LINE + 2.0 * ABOVE]
}

fn label_size(edge: &Edge) -> Point {
    let space = if note(edge).is_empty() { 0.0 } else { 4.0 };
    let width = width(&edge.name, LETTER) + space + width(note(edge), SMALL);
    [width + 4.0, LINE]
}

/// The note beside the name of a joint: its kind, unless it is a revolute, as most are.
fn note(edge: &Edge) -> &str {
    if edge.detail == "revolute" { "" } else { &edge.detail }
}

/// The approximate width of a text, in a wide typeface.
fn width(text: &str, size: f64) -> f64 {
    let em = |letter: char| match letter {
        'i' | 'j' | 'l' | 'f' | 't' | 'r' | ' ' | '.' | ',' | ':' => 0.4,
        'm' | 'w' | 'M' | 'W' => 1.0,
        letter if letter.is_ascii_uppercase() => 0.78,
        letter if letter.is_ascii() => 0.64,
        _ => 1.0,
    };
    text.chars().map(em).sum::<f64>() * size
}

fn write(text: &mut String, graph: &Graph, layout: &Layout) -> Result {
    let ([x, y], [width, height]) = layout.view;
    writeln!(
        text,
        r#"<svg class="graph" role="img" aria-label="{}" width="{width:.0}" height="{height:.0}" viewBox="{x:.1} {y:.1} {width:.1} {height:.1}">"#,
        escape(&graph.name)
    )?;
    for (edge, &curve) in graph.edges.iter().zip(&layout.curves) {
        write_edge(text, graph, edge, curve)?;
    }
    for (edge, &at) in graph.edges.iter().zip(&layout.labels) {
        write_label(text, edge, at)?;
    }
    for (vertex, &at) in graph.vertices.iter().zip(&layout.centers) {
        write_vertex(text, vertex, at)?;
    }
    writeln!(text, "</svg>")
}

fn edge_class(edge: &Edge) -> &'static str {
    match (edge.kind, edge.motor) {
        (EdgeKind::Arm, true) => "edge arm motor",
        (EdgeKind::Arm, false) => "edge arm",
        (_, true) => "edge motor",
        (_, false) => "edge",
    }
}

fn write_edge(text: &mut String, graph: &Graph, edge: &Edge, curve: [Point; 3]) -> Result {
    let [[ax, ay], control, tip] = curve;
    let end = if graph.directed { foot(control, tip) } else { tip };
    write!(
        text,
        r#"<g class="{}"><title>{}</title><path d="M{ax:.1} {ay:.1}Q{:.1} {:.1} {:.1} {:.1}"/>"#,
        edge_class(edge),
        escape(&label(graph, edge)),
        control[0],
        control[1],
        end[0],
        end[1]
    )?;
    if graph.directed {
        write_head(text, end, tip)?;
    }
    writeln!(text, "</g>")
}

/// The tooltip of an edge.
fn label(graph: &Graph, edge: &Edge) -> String {
    let [from, to] = [edge.from, edge.to].map(|end| &graph.vertices[end].name);
    if graph.directed {
        return format!("{to} needs {from}");
    }
    let motor = if edge.motor { ", with a motor" } else { "" };
    format!("{}: {} of {from} and {to}{motor}", edge.name, edge.detail)
}

/// The point where the head of an arrow begins.
fn foot(control: Point, tip: Point) -> Point {
    let [dx, dy] = [tip[0] - control[0], tip[1] - control[1]];
    let length = dx.hypot(dy).max(1e-9);
    [tip[0] - dx / length * 9.0, tip[1] - dy / length * 9.0]
}

fn write_head(text: &mut String, foot: Point, tip: Point) -> Result {
    let aside = [(foot[1] - tip[1]) / 2.2, (tip[0] - foot[0]) / 2.2];
    write!(
        text,
        r#"<polygon points="{:.1},{:.1} {:.1},{:.1} {:.1},{:.1}"/>"#,
        tip[0],
        tip[1],
        foot[0] + aside[0],
        foot[1] + aside[1],
        foot[0] - aside[0],
        foot[1] - aside[1]
    )
}

fn write_label(text: &mut String, edge: &Edge, [x, y]: Point) -> Result {
    if edge.name.is_empty() {
        return Ok(());
    }
    let (class, name, note) = (edge_class(edge), escape(&edge.name), escape(note(edge)));
    let note =
        if note.is_empty() { note } else { format!(r#" <tspan class="soft">{note}</tspan>"#) };
    writeln!(
        text,
        r#"<g class="{class}"><text x="{x:.1}" y="{:.1}">{name}{note}</text></g>"#,
        y + 4.5
    )
}

fn write_vertex(text: &mut String, vertex: &Vertex, [x, y]: Point) -> Result {
    let [width, height] = vertex_size(vertex);
    let (class, round) = match vertex.kind {
        VertexKind::Ground => ("ground", 2.0),
        VertexKind::Link => ("link", height / 2.0),
        VertexKind::Motor => ("motor", height / 2.0),
        VertexKind::Loop => ("loop", 8.0),
    };
    let [left, top] = [x - width / 2.0, y - height / 2.0];
    write!(
        text,
        r#"<g class="{class}"><rect x="{left:.1}" y="{top:.1}" width="{width:.1}" height="{height:.1}" rx="{round:.1}"/>"#,
    )?;
    if vertex.kind == VertexKind::Ground {
        write_hatching(text, [left, top + height], width)?;
    }
    let name = escape(&vertex.name);
    let detail = escape(&vertex.detail);
    let up = if detail.is_empty() { 0.0 } else { LINE / 2.0 };
    write!(text, r#"<text x="{x:.1}" y="{:.1}">{name}</text>"#, y - up + 4.5)?;
    if !detail.is_empty() {
        let y = y + LINE / 2.0 + 3.5;
        write!(text, r#"<text class="soft" x="{x:.1}" y="{y:.1}">{detail}</text>"#)?;
    }
    writeln!(text, "</g>")
}

/// Writes the strokes by which draughtsmen mark the ground.
fn write_hatching(text: &mut String, [left, bottom]: Point, width: f64) -> Result {
    write!(text, r#"<path d="M{left:.1} {bottom:.1}h{width:.1}"#)?;
    let mut x = left + 9.0;
    while x <= left + width {
        write!(text, "M{x:.1} {bottom:.1}l-7 8")?;
        x += 9.0;
    }
    text.write_str(r#""/>"#)
}
