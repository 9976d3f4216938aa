//! Traces: what is understood of them, and what is told about those that cannot be.

use super::good;
use crate::model::Trace;

/// A mechanism with these effects.
fn with(effects: &str) -> String {
    format!(
        "const N = 8;
        ground {{ point o = (0, 0); line rail = (0, 0) -> (1, 0); }}
        link crank {{ point shaft = (0, 0); point pin = (1, 0); line edge = (0, 0) -> (1, 0); }}
        link bare;
        joint a = revolute(ground.o, crank.shaft);
        joint b = revolute(crank, bare) at (1, 0);
        motor a; motor b;
        effects {{ {effects} }}"
    )
}

#[test]
fn a_trace_has_a_length_and_may_have_a_plane_and_a_color() {
    let traces = |effects| {
        let model = good(&format!("struct M; {}", with(effects))).model;
        let read = |trace: &Trace| {
            let axis = model.axis(trace.point);
            let name = axis.name.clone().unwrap_or_default();
            (name, trace.length, trace.plane, trace.color)
        };
        model.traces.iter().map(read).collect::<Vec<_>>()
    };
    assert_eq!(traces("velocity;"), []);
    let (pin, shaft) = ("pin".to_owned(), "shaft".to_owned());
    assert_eq!(
        traces("trace crank.pin 2 * N; velocity; trace crank.shaft 1 on plane -3 color N + 1;"),
        [(pin.clone(), 16, None, 14), (shaft, 1, Some(-3), 9)]
    );
    assert_eq!(
        traces("trace crank.pin 16384 color 0;"),
        [(pin, 16384, None, 0)]
    );
}

#[test]
fn what_is_traced_is_needed_whatever_is_shown() {
    let text = format!("struct M; {} show a;", with("trace crank.pin 4;"));
    let model = good(&text).model;
    let asked: Vec<&str> = model
        .asked_links()
        .into_iter()
        .map(|link| model.link(link).name.as_str())
        .collect();
    assert_eq!(asked, ["crank"], "a motor's coordinate needs none");
}
