//! Links, points, lines, shapes and traces.

use super::good;
use crate::model::Trace;

#[test]
fn a_direction_may_be_an_angle() {
    let direction = |text: &str| {
        let text = format!("struct M; const TILT = 15; link a {{ line l = (0, 0) -> {text}; }}");
        good(&text).model.axes[0].direction
    };
    for (text, expected) in [
        ("0", [1.0, 0.0]),
        ("90 deg", [0.0, 1.0]),
        ("PI", [-1.0, 0.0]),
        ("-90 deg", [0.0, -1.0]),
        ("(360 + 270) deg", [0.0, -1.0]),
        ("(90 + TILT) deg", [libm::cos(105_f64.to_radians()), libm::sin(105_f64.to_radians())]),
        ("atan2(3, 4)", [0.8, 0.6]),
        ("(cos(0), sin(0))", [1.0, 0.0]),
    ] {
        let found = direction(text);
        let off = (found[0] - expected[0]).abs().max((found[1] - expected[1]).abs());
        assert!(off <= f64::EPSILON, "{text}: {found:?}");
        let is_exact = expected.contains(&0.0);
        assert!(!is_exact || found == expected, "{text}: {found:?}");
    }
    let text = "struct M; link a; joint j = prismatic(ground, a) at (0, 0) along 30 deg;";
    let axis = &good(text).model.axes[0];
    assert!((axis.direction[1] - 0.5).abs() < 1e-15);
}

#[test]
fn an_axis_may_be_turned_about_the_origin_of_its_link() {
    let parsed = super::parsed(
        "struct M; link a {
            point p = (2, 0) turned 90 deg;
            point q = (1, 0) -> (0, 1) turned 180 deg;
            line l = (0, 3) -> 0 deg turned -90 deg;
        }",
    );
    assert!(parsed.errors.is_empty());
    let axes = |index: usize| (parsed.model.axes[index].at, parsed.model.axes[index].direction);
    assert_eq!(axes(0), ([0.0, 2.0], [1.0, 0.0]));
    assert_eq!(axes(1), ([-1.0, 0.0], [0.0, -1.0]));
    assert_eq!(axes(2), ([3.0, 0.0], [0.0, -1.0]));
}

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
    assert_eq!(traces("trace crank.pin 16384 color 0;"), [(pin, 16384, None, 0)]);
}

#[test]
fn what_is_traced_is_needed_whatever_is_shown() {
    let text = format!("struct M; {} show a;", with("trace crank.pin 4;"));
    let model = good(&text).model;
    let asked: Vec<&str> =
        model.asked_links().into_iter().map(|link| model.link(link).name.as_str()).collect();
    assert_eq!(asked, ["crank"], "a motor's coordinate needs none");
}
