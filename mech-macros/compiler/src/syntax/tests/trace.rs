//! Traces: what is understood of them, and what is told about those that cannot be.

use super::{assert_messages, good, unseen};
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
fn a_trace_is_of_a_named_point_that_moves() {
    for (effects, message) in [
        (
            "trace «crnk».pin 9;",
            "unknown link `crnk`; did you mean `crank`?",
        ),
        (
            "trace crank.«pim» 9;",
            "`crank` has no point `pim`; did you mean `pin`?",
        ),
        (
            "trace bare.«pin» 9;",
            "`bare` has no point `pin`; declare it in `bare`",
        ),
        (
            "trace crank.«edge» 9;",
            "`crank.edge` is a line; a trace is of a point, such as `crank.shaft`",
        ),
        (
            "trace ground.«rail» 9;",
            "`ground.rail` is a line; a trace is of a point of a moving link",
        ),
        (
            "trace «ground.o» 9;",
            "`ground.o` does not move: it has no path; trace a point of a moving link",
        ),
        (
            "trace «crank» 9;",
            "`crank` is a link; a trace is of a point, such as `crank.shaft`",
        ),
        (
            "trace «bare» 9;",
            "`bare` is a link; a trace is of a point; declare one in `bare`",
        ),
        (
            "trace «ground» 9;",
            "`ground` is a link; a trace is of a point of a moving link",
        ),
        (
            "trace «a» 9;",
            "`a` is a joint; a trace is of a point: `link.point`",
        ),
        (
            "trace «crnak» 9;",
            "unknown link or joint `crnak`; did you mean `crank`?",
        ),
        (
            "trace crank.pin 9; trace «crank.pin» 8;",
            "`crank.pin` is traced already; remove one of the two",
        ),
    ] {
        assert_messages(&with(effects), &[message]);
    }
}

#[test]
fn the_length_of_a_trace_is_a_number_of_places() {
    for wrong in ["0", "-1", "2.5", "16385", "1e300"] {
        let message =
            format!("the length of a trace is a whole number from 1 to 16384, not {wrong}");
        assert_messages(&with(&format!("trace crank.pin «{wrong}»;")), &[&message]);
    }
    assert_messages(
        &with("trace crank.pin «M»;"),
        &[&unseen("M", "there are `N`, `PI`")],
    );
    assert_messages(
        &with("trace crank.pin«;»"),
        &[
            "expected how many places are kept, found `;`; write a number after the point, such as 256",
        ],
    );
    assert_messages(
        &with("trace crank.pin 9 color «256»;"),
        &["the number of a color is a whole number from 0 to 255, not 256"],
    );
    assert_messages(
        &with("trace crank.pin 9 on plane «0.5»;"),
        &["a plane is a whole number from -2147483648 to 2147483647, not 0.5"],
    );
    assert_messages(
        &with("trace crank.pin 9 color 1 «on» plane 2;"),
        &["`on plane` stands before `color`; swap the two"],
    );
    assert_messages(
        &with("trace «;» velocity;"),
        &["expected the name of a link, found `;`"],
    );
}

#[test]
fn every_error_of_a_trace_is_told_at_once_and_others_after_it() {
    assert_messages(
        &with("trace crank.«pim» «0» color «-1»; «speed»;"),
        &[
            "`crank` has no point `pim`; did you mean `pin`?",
            "the length of a trace is a whole number from 1 to 16384, not 0",
            "the number of a color is a whole number from 0 to 255, not -1",
            "unknown effect `speed`; there are `velocity`, `acceleration`, `force`, `dynamics`, `trace`, `overlay`, `sensitivity`",
        ],
    );
}

#[test]
fn the_method_of_a_trace_has_a_name_of_its_own() {
    assert_messages(
        "ground { point o = (0, 0); }
        link crank { point shaft = (0, 0); point shaft_trace = (1, 0); }
        joint a = revolute(ground.o, crank.shaft);
        motor a;
        effects { trace «crank.shaft» 4; }",
        &[
            "the trace of `crank.shaft` and point `crank.shaft_trace` would both be the method `crank_shaft_trace`; rename one \
            of them",
        ],
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
