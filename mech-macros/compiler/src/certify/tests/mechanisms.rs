//! Mechanisms of which it is known how far they move.

use super::super::{Blocked, Effort, Interval, Verdict, certify, certify_counted};
use crate::program::Program;
use crate::syntax::parse;
use crate::{Compiled, compile};
use proc_macro2::{TokenStream, TokenTree};
use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use std::time::Instant;

const TURN: [(f64, f64); 1] = [(0.0, TAU)];

fn program(text: TokenStream) -> Program {
    let parsed = parse(text);
    assert!(parsed.errors.is_empty(), "{:#?}", parsed.errors);
    match compile(&parsed.model) {
        Ok(Compiled { program, .. }) => program,
        Err(diagnoses) => panic!("{diagnoses:#?}"),
    }
}

fn tokens(text: &str) -> TokenStream {
    text.parse().expect("the text is made of tokens")
}

/// The mechanism declared in an exhibit of the gallery.
fn exhibit(name: &str) -> Program {
    let path = format!("{}/../../examples/src/gallery/{name}.rs", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("the gallery is in its place");
    let trees: Vec<TokenTree> = tokens(&text).into_iter().collect();
    let body = trees.windows(3).find_map(|trees| match trees {
        [TokenTree::Ident(name), TokenTree::Punct(_), TokenTree::Group(body)] if name == "mechanism" => {
            Some(body.stream())
        }
        _ => None,
    });
    program(body.expect("an exhibit has a mechanism"))
}

/// Ground, crank, coupler and rocker by their lengths, the ground's line turned by an angle.
fn four_bar([ground, crank, coupler, rocker]: [f64; 4], tilt: f64, start: f64, near: f64) -> Program {
    let (sin, cos) = tilt.sin_cos();
    let (x, y) = (ground * cos, ground * sin);
    program(tokens(&format!(
        "struct FourBar;
        ground {{ point a = (0, 0); point d = ({x:?}, {y:?}); }}
        link crank {{ point a = (0, 0); point b = ({crank:?}, 0); }}
        link coupler {{ point b = (0, 0); point c = ({coupler:?}, 0); }}
        link rocker {{ point d = (0, 0); point c = ({rocker:?}, 0); }}
        joint a = revolute(ground.a, crank.a);
        joint b = revolute(crank.b, coupler.b);
        joint c = revolute(coupler.c, rocker.c);
        joint d = revolute(ground.d, rocker.d);
        motor a;
        start {{ a = {start:?}; rocker near {near:?}; }}"
    )))
}

fn slider_crank(crank: f64, rod: f64) -> Program {
    program(tokens(&format!(
        "struct SliderCrank;
        ground {{ point a = (0, 0); line bore = (0, 0) -> (1, 0); }}
        link crank {{ point a = (0, 0); point b = ({crank:?}, 0); }}
        link rod {{ point b = (0, 0); point c = ({rod:?}, 0); }}
        link piston {{ point c = (0, 0); line axis = (0, 0) -> (1, 0); }}
        joint a = revolute(ground.a, crank.a);
        joint b = revolute(crank.b, rod.b);
        joint c = revolute(rod.c, piston.c);
        joint h = prismatic(ground.bore, piston.axis);
        motor a;
        start {{ a = 0; rod near 0; }}"
    )))
}

/// Four-bars in a row, each driven by the rocker of the one before it: as in the tests of the whole house.
fn chain(loops: usize) -> Program {
    let mut text = "struct Chain; link crank;".to_owned();
    let mut joints = "joint m = revolute(ground, crank) at (0, 0); motor m;".to_owned();
    let (mut input, mut pin) = ("crank".to_owned(), [0.3, 1.0]);
    let mut along = 0.0;
    for number in 0..loops {
        along += 3.0;
        let (top, [x, y]) = (along + 0.3, pin);
        write!(text, "link coupler_{number}; link rocker_{number};").expect("a string takes any text");
        write!(
            joints,
            "joint a_{number} = revolute({input}, coupler_{number}) at ({x:?}, {y:?});
            joint b_{number} = revolute(coupler_{number}, rocker_{number}) at ({top:?}, 1.6);
            joint c_{number} = revolute(ground, rocker_{number}) at ({along:?}, 0);"
        )
        .expect("a string takes any text");
        (input, pin) = (format!("rocker_{number}"), [along + 0.2, 1.0]);
    }
    program(tokens(&(text + &joints)))
}

fn ranges(ranges: &[(f64, f64)]) -> Vec<Interval> {
    ranges.iter().map(|&(low, high)| Interval::new(low, high)).collect()
}

fn verdict(program: &Program, over: &[(f64, f64)]) -> Verdict {
    certify(program, &ranges(over))
}

#[track_caller]
fn blocked(program: &Program, over: &[(f64, f64)]) -> Blocked {
    match verdict(program, over) {
        Verdict::Blocked(blocked) => blocked,
        verdict => panic!("{verdict:?}"),
    }
}

#[track_caller]
fn strict(program: &Program, over: &[(f64, f64)]) {
    let verdict = verdict(program, over);
    assert!(verdict.is_strict(), "{verdict:?}");
}

#[track_caller]
fn touching(program: &Program, over: &[(f64, f64)]) {
    let verdict = verdict(program, over);
    assert!(
        matches!(&verdict, Verdict::Proved { touching } if touching.len() == 1),
        "{verdict:?}"
    );
}

const DEAD_POINT: f64 = 0.935_085_041_393_594_5;

#[test]
fn a_crank_rocker_turns() {
    strict(&four_bar([4.0, 1.0, 3.5, 3.0], 0.0, 1.0, 1.5), &TURN);
    strict(&four_bar([4.0, 1.0, 3.5, 3.0], 0.7, 1.0, 2.2), &[(-PI, PI)]);
}

#[test]
fn a_rocker_stops_at_its_dead_point() {
    let program = four_bar([4.0, 1.0, 2.0, 1.5], 0.0, 0.5, 2.0);
    let up = blocked(&program, &[(0.0, 2.0)]);
    assert!((up.limit - DEAD_POINT).abs() < 1e-12, "{up:?}");
    assert_eq!((up.interval.low(), up.interval.high()), (up.limit, 2.0));
    assert!(up.interval.contains(up.at[0]));
    let down = blocked(&program, &[(-2.0, 0.9)]);
    assert!((down.limit + DEAD_POINT).abs() < 1e-12, "{down:?}");
    assert_eq!((down.interval.low(), down.interval.high()), (-2.0, down.limit));
    let around = blocked(&program, &TURN);
    assert!((around.limit - DEAD_POINT).abs() < 1e-12, "{around:?}");
    assert!((around.interval.high() - (TAU - DEAD_POINT)).abs() < 1e-11, "{around:?}");
    strict(&program, &[(-0.935, 0.935)]);
    strict(&program, &[(-DEAD_POINT + 1e-9, DEAD_POINT - 1e-9)]);
}

#[test]
fn a_parallelogram_passes_its_change_points() {
    touching(&four_bar([2.0, 1.0, 2.0, 1.0], 0.0, 1.0, 1.0), &TURN);
    touching(&four_bar([2.0, 1.0, 2.0, 1.0], 0.0, 1.0, 1.0), &[(-10.0, 13.0)]);
    touching(&four_bar([2.0, 1.0, 2.0, 1.0], 0.7, 1.7, 1.7), &TURN);
    strict(&four_bar([2.0, 1.0, 2.0, 1.0], 0.7, 1.7, 1.7), &[(0.8, 3.7)]);
}

#[test]
fn a_piston_with_a_long_rod_moves_and_one_with_a_short_rod_does_not() {
    strict(&slider_crank(1.0, 3.0), &TURN);
    let short = blocked(&slider_crank(1.0, 0.5), &TURN);
    assert!((short.limit - PI / 6.0).abs() < 1e-12, "{short:?}");
    assert!((short.interval.high() - 5.0 * PI / 6.0).abs() < 1e-11, "{short:?}");
    touching(&slider_crank(1.0, 1.0), &[(0.0, 3.0)]);
}

#[test]
fn nearly_folded_four_bars_turn() {
    for gap in [1e-3, 1e-6, 1e-9] {
        for tilt in [0.0, 0.7] {
            let near = 1.0 + tilt;
            strict(&four_bar([2.0, 1.0, 2.0, 1.0 + gap], tilt, 1.0 + tilt, near), &TURN);
        }
    }
}

#[test]
fn four_bars_that_just_do_not_fold_over_are_blocked() {
    for gap in [1e-3, 1e-6] {
        let program = four_bar([2.0 + gap, 1.0, 2.0, 1.0], 0.0, 1.0, 1.0);
        let blocked = blocked(&program, &TURN);
        assert!((blocked.limit - PI).abs() < 3.0 * gap.sqrt(), "{blocked:?}");
    }
}

#[test]
fn chains_of_loops_are_proved() {
    for loops in 1..=5 {
        let crank = program_of_chain_range();
        strict(&chain(loops), &[crank]);
    }
}

fn program_of_chain_range() -> (f64, f64) {
    (-0.3, 0.3)
}

#[test]
fn the_gallery_turns() {
    for name in ["four_bar", "jansen", "watt", "andrews"] {
        strict(&exhibit(name), &TURN);
    }
}

#[test]
fn two_motors_are_proved_together() {
    let text = "struct FiveBar;
        link left; link left_rod; link right_rod; link right;
        joint a = revolute(ground, left) at (0, 0);
        joint b = revolute(left, left_rod) at (0, 1);
        joint c = revolute(left_rod, right_rod) at (2, 3);
        joint d = revolute(right_rod, right) at (4, 1);
        joint e = revolute(right, ground) at (4, 0);
        motor a; motor e;";
    let program = program(tokens(text));
    strict(&program, &[(-0.9, 0.9), (-0.9, 0.9)]);
    let corner = blocked(&program, &[(-1.1, 1.1), (-1.1, 1.1)]);
    assert!(corner.limit.abs() > 0.9, "{corner:?}");
    let far = blocked(&program, &[(-0.1, 2.5), (-2.5, 0.1)]);
    assert!(far.limit > 0.0, "{far:?}");
}

#[test]
fn loops_without_a_closed_form_are_named() {
    let mut program = four_bar([4.0, 1.0, 3.5, 3.0], 0.0, 1.0, 1.5);
    strict(&program, &TURN);
    program.start.motors.clear();
    strict(&program, &[]);
}

#[test]
fn a_range_without_end_is_not_decided() {
    let program = four_bar([4.0, 1.0, 3.5, 3.0], 0.0, 1.0, 1.5);
    let verdict = verdict(&program, &[(0.0, f64::INFINITY)]);
    assert!(matches!(verdict, Verdict::Undecided { .. }), "{verdict:?}");
}

/// `cargo test -p mech-compiler --release certify -- --ignored --nocapture`
#[test]
#[ignore = "prints what proofs cost"]
fn costs() {
    let bar = |lengths| four_bar(lengths, 0.0, 0.5, 1.5);
    let tilted = |lengths| four_bar(lengths, 0.7, 1.7, 1.7);
    let cases = [
        ("four-bar 4/1/3.5/3", bar([4.0, 1.0, 3.5, 3.0]), TURN[0]),
        ("four-bar 4/1/2/1.5", bar([4.0, 1.0, 2.0, 1.5]), TURN[0]),
        ("parallelogram", bar([2.0, 1.0, 2.0, 1.0]), TURN[0]),
        ("parallelogram, tilted", tilted([2.0, 1.0, 2.0, 1.0]), TURN[0]),
        ("nearly folded 1e-3", tilted([2.0, 1.0, 2.0, 1.001]), TURN[0]),
        ("nearly folded 1e-6", tilted([2.0, 1.0, 2.0, 1.000_001]), TURN[0]),
        ("nearly folded 1e-9", tilted([2.0, 1.0, 2.0, 1.000_000_001]), TURN[0]),
        ("slider-crank 1/3", slider_crank(1.0, 3.0), TURN[0]),
        ("slider-crank 1/0.5", slider_crank(1.0, 0.5), TURN[0]),
        ("chain of 3", chain(3), (-0.3, 0.3)),
        ("chain of 5", chain(5), (-0.3, 0.3)),
        ("chain of 5", chain(5), TURN[0]),
        ("Watt's linkage", exhibit("watt"), TURN[0]),
        ("Jansen's leg", exhibit("jansen"), TURN[0]),
        ("Andrews' squeezer", exhibit("andrews"), TURN[0]),
    ];
    for (name, program, range) in cases {
        let before = Instant::now();
        let (verdict, Effort { boxes, evaluations }) = certify_counted(&program, &ranges(&[range]));
        let time = before.elapsed().as_secs_f64() * 1e3;
        println!("{name:24} {boxes:6} boxes {evaluations:8} values {time:7.2} ms  {verdict:?}");
    }
}
