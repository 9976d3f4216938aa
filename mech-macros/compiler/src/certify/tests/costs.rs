//! What proofs take.

use super::super::{Effort, Interval, certify_counted};
use super::models::{TURN, chain, exhibit, four_bar, program, slider_crank, tokens};
use crate::program::Program;
use std::time::Instant;

/// `cargo test -p mech-compiler --release certify -- --ignored --nocapture`
#[test]
#[ignore = "prints what proofs cost"]
fn costs() {
    let bar = |lengths| four_bar(lengths, 0.0, 0.5, 1.5);
    let tilted = |lengths| four_bar(lengths, 0.7, 1.7, 1.7);
    let cases = vec![
        ("four-bar 4/1/3.5/3", bar([4.0, 1.0, 3.5, 3.0]), TURN[0]),
        ("four-bar 4/1/2/1.5", bar([4.0, 1.0, 2.0, 1.5]), TURN[0]),
        ("parallelogram", bar([2.0, 1.0, 2.0, 1.0]), TURN[0]),
        (
            "parallelogram, tilted",
            tilted([2.0, 1.0, 2.0, 1.0]),
            TURN[0],
        ),
        (
            "nearly folded 1e-3",
            tilted([2.0, 1.0, 2.0, 1.001]),
            TURN[0],
        ),
        (
            "nearly folded 1e-6",
            tilted([2.0, 1.0, 2.0, 1.000_001]),
            TURN[0],
        ),
        (
            "nearly folded 1e-9",
            tilted([2.0, 1.0, 2.0, 1.000_000_001]),
            TURN[0],
        ),
        (
            "just not folding 1e-12",
            tilted([2.0, 1.0, 2.0, 1.0 - 1e-12]),
            TURN[0],
        ),
        (
            "just not folding 1e-13",
            tilted([2.0, 1.0, 2.0, 1.0 - 1e-13]),
            TURN[0],
        ),
        (
            "just not folding 3e-14",
            tilted([2.0, 1.0, 2.0, 1.0 - 3e-14]),
            TURN[0],
        ),
        (
            "to its dead point",
            bar([4.0, 1.0, 2.0, 1.5]),
            (0.0, 0.935_085_041_393_594_5),
        ),
        (
            "beyond its dead point",
            bar([4.0, 1.0, 2.0, 1.5]),
            (0.0, 0.935_085_041_393_7),
        ),
        ("slider-crank 1/3", slider_crank(1.0, 3.0), TURN[0]),
        ("slider-crank 1/0.5", slider_crank(1.0, 0.5), TURN[0]),
        ("chain of 2", chain(2), TURN[0]),
        ("chain of 5", chain(5), TURN[0]),
        ("chain of 20", chain(20), TURN[0]),
        ("Watt's linkage", exhibit("watt"), TURN[0]),
        ("Jansen's leg", exhibit("jansen"), TURN[0]),
        ("Andrews' squeezer", exhibit("andrews"), TURN[0]),
    ];
    for (name, program, range) in cases {
        show(name, &program, &[range]);
    }
    let five_bar = |right: f64| {
        program(tokens(&format!(
            "struct FiveBar;
            ground {{ point a = (0, 0); point e = (2, 0); }}
            link left {{ point a = (0, 0); point b = (1, 0); }}
            link left_rod {{ point b = (0, 0); point c = (3, 0); }}
            link right_rod {{ point d = (0, 0); point c = ({right:?}, 0); }}
            link right {{ point e = (0, 0); point d = (1, 0); }}
            joint a = revolute(ground.a, left.a);
            joint b = revolute(left.b, left_rod.b);
            joint c = revolute(left_rod.c, right_rod.c);
            joint d = revolute(right.d, right_rod.d);
            joint e = revolute(ground.e, right.e);
            motor a; motor e;
            start {{ a = 90 deg; e = 70 deg; right_rod near 90 deg; }}"
        )))
    };
    let turns = [(-3.0, 3.0), (-3.0, 3.0)];
    show("two motors, blocked", &five_bar(2.0), &turns);
    show(
        "two motors, near end",
        &five_bar(2.9),
        &[(0.0, 3.0), (0.0, 3.0)],
    );
    show(
        "two motors, free",
        &five_bar(3.0),
        &[(0.1, 3.0), (0.1, 3.0)],
    );
}

/// Proves it, and prints a line.
fn show(name: &str, program: &Program, ranges: &[(f64, f64)]) {
    let ranges: Vec<Interval> = ranges
        .iter()
        .map(|&(low, high)| Interval::new(low, high))
        .collect();
    let before = Instant::now();
    let (verdict, Effort { boxes, evaluations }) = certify_counted(program, &ranges, &[]);
    let time = before.elapsed().as_secs_f64() * 1e3;
    println!("{name:22} {boxes:6} boxes {evaluations:8} numbers {time:7.2} ms  {verdict:?}");
}
