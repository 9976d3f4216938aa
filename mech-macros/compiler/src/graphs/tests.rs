//! The graphs of small mechanisms. `tests/cases/commands/report.txt` has some letter by letter.

use super::{EdgeKind, Graph, VertexKind, common_joints, kinematic, loops};
use crate::model::Model;
use crate::syntax::parse;
use crate::{Compiled, compile};

/// Two four-bars in a row, and an arm with its own motor.
const SIX_BAR: &str = "
    struct SixBar;
    link crank; link coupler; link lever; link rod; link rocker; link hand;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0, 1);
    joint c = revolute(coupler, lever) at (3, 2);
    joint d = revolute(lever, ground) at (3, 0);
    joint e = revolute(lever, rod) at (4, 2);
    joint f = revolute(rod, rocker) at (7, 3);
    joint g = revolute(rocker, ground) at (7, 0);
    joint wrist = revolute(rocker, hand) at (8, 3);
    motor a;
    motor wrist;";

fn compiled(text: &str) -> (Model, Compiled) {
    let parsed = parse(text.parse().expect("tokens"));
    assert!(parsed.errors.is_empty());
    let compiled = compile(&parsed.model).expect("it moves");
    (parsed.model, compiled)
}

fn edge_names(graph: &Graph) -> Vec<(usize, usize, &str)> {
    let edges = graph.edges.iter();
    edges.map(|edge| (edge.from, edge.to, edge.name.as_str())).collect()
}

#[test]
fn loops_in_a_row() {
    let (model, compiled) = compiled(SIX_BAR);
    let graph = loops(&model, &compiled.plan);
    // The motor of the arm leads to no loop.
    let kinds: Vec<_> = graph.vertices.iter().map(|vertex| vertex.kind).collect();
    assert_eq!(kinds, [VertexKind::Motor, VertexKind::Loop, VertexKind::Loop]);
    let levels: Vec<_> = graph.vertices.iter().map(|vertex| vertex.level).collect();
    assert_eq!(levels, [0, 1, 2]);
    assert_eq!(edge_names(&graph), [(0, 1, ""), (1, 2, "")]);

    let graph = common_joints(&model, &compiled.plan);
    assert_eq!(edge_names(&graph), [(0, 1, "d")]);
}

#[test]
fn arms_and_distances() {
    let (model, compiled) = compiled(SIX_BAR);
    let graph = kinematic(&model, &compiled.structure);
    let levels: Vec<_> = graph.vertices.iter().map(|vertex| vertex.level).collect();
    assert_eq!(levels, [0, 1, 2, 1, 2, 1, 2]);
    let wrist = graph.edges.last().expect("an edge");
    assert_eq!((wrist.kind, wrist.motor), (EdgeKind::Arm, true));
    assert!(
        graph
            .to_dot()
            .contains(r#"n5 -- n6 [label="wrist\nrevolute\nmotor", style="dashed,bold"];"#)
    );
}

#[test]
fn odd_names_are_escaped() {
    let (mut model, compiled) = compiled(SIX_BAR);
    model.name = "a \"piston\"\\".to_owned();
    model.links[1].name = "two\nlines\u{7}\r".to_owned();
    model.joints[0].name = "\\N \"d\"; é".to_owned();
    let text = kinematic(&model, &compiled.structure).to_dot();
    assert!(text.starts_with(r#"graph "a \"piston\"\\: links and joints" {"#));
    assert!(text.contains(r#"  n1 [label="two\nlines  "];"#));
    assert!(text.contains(r#"[label="\\N \"d\"; é\nrevolute\nmotor", style=bold]"#));
}
