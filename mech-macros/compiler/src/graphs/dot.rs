//! A graph as text for Graphviz.

use super::{Edge, EdgeKind, Graph, Vertex, VertexKind};
use std::fmt::Write;

/// The graph in the language DOT.
pub(super) fn dot(graph: &Graph) -> String {
    let mut text = String::new();
    // Writing into a string does not fail.
    let _ = write(&mut text, graph);
    text
}

fn write(text: &mut String, graph: &Graph) -> std::fmt::Result {
    let (kind, arrow) = if graph.directed { ("digraph", "->") } else { ("graph", "--") };
    writeln!(text, "{kind} {} {{", quote(&[&graph.name]))?;
    writeln!(text, "  node [shape=box, style=rounded];")?;
    for (index, vertex) in graph.vertices.iter().enumerate() {
        let label = quote(&[&vertex.name, &vertex.detail]);
        writeln!(text, "  n{index} [label={label}{}];", vertex_style(vertex))?;
    }
    for edge in &graph.edges {
        let (label, style) = (edge_label(edge), edge_style(edge));
        let Edge { from, to, .. } = edge;
        writeln!(text, "  n{from} {arrow} n{to} [label={label}{style}];")?;
    }
    write_levels(text, graph)?;
    writeln!(text, "}}")
}

/// Writes the loops of each level into one row. Links may stand wherever there is room.
fn write_levels(text: &mut String, graph: &Graph) -> std::fmt::Result {
    let is_loop = |vertex: &&Vertex| vertex.kind == VertexKind::Loop;
    let levels = graph.vertices.iter().filter(is_loop).map(|vertex| vertex.level);
    for level in 0..=levels.max().unwrap_or(0) {
        let in_row = |(_, vertex): &(usize, &Vertex)| is_loop(vertex) && vertex.level == level;
        let row = graph.vertices.iter().enumerate().filter(in_row);
        let row: Vec<String> = row.map(|(index, _)| format!("n{index};")).collect();
        if !row.is_empty() {
            writeln!(text, "  {{ rank=same; {} }}", row.join(" "))?;
        }
    }
    Ok(())
}

fn vertex_style(vertex: &Vertex) -> &'static str {
    match vertex.kind {
        VertexKind::Ground => ", style=filled",
        VertexKind::Motor => ", shape=plaintext",
        VertexKind::Link | VertexKind::Loop => "",
    }
}

fn edge_style(edge: &Edge) -> &'static str {
    match (edge.kind, edge.motor) {
        (EdgeKind::Arm, true) => ", style=\"dashed,bold\"",
        (EdgeKind::Arm, false) => ", style=dashed",
        (_, true) => ", style=bold",
        (_, false) => "",
    }
}

fn edge_label(edge: &Edge) -> String {
    let motor = if edge.motor { "motor" } else { "" };
    quote(&[&edge.name, &edge.detail, motor])
}

/// Lines as a quoted string, without empty ones.
fn quote(lines: &[&str]) -> String {
    let lines = lines.iter().filter(|line| !line.is_empty());
    let lines: Vec<String> = lines.map(|line| escape(line)).collect();
    format!("\"{}\"", lines.join("\\n"))
}

/// A line with its quotes and control characters replaced.
fn escape(line: &str) -> String {
    let mut escaped = String::with_capacity(line.len());
    for character in line.chars() {
        match character {
            '"' | '\\' => escaped.extend(['\\', character]),
            '\n' => escaped += "\\n",
            // Neither a text editor nor Graphviz wants any other control character.
            control if control.is_control() => escaped.push(' '),
            other => escaped.push(other),
        }
    }
    escaped
}
