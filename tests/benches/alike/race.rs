//! A program that times a walker beside its legs one by one, in turn.

use std::fmt::Write as _;

/// The program for mechanisms of so many legs in such numbers.
pub(super) fn program(mechanism: impl Fn(usize, &str) -> String) -> String {
    let (mut text, mut calls) = (TIMED.to_owned(), String::new());
    for kind in ["f64", "f32"] {
        for legs in [1, 4, 12] {
            let mechanism = mechanism(legs, kind);
            let _ = writeln!(
                text,
                "mod {kind}_{legs} {{ mech_runtime::mechanism! {{ {mechanism} }} }}"
            );
            if legs > 1 {
                let _ = writeln!(calls, "race!({kind}, {legs}, {kind}_1, {kind}_{legs});");
            }
        }
    }
    let _ = writeln!(text, "fn main() {{ {calls} }}");
    text
}

const TIMED: &str = r#"
#![allow(dead_code, clippy::all)]
use std::hint::black_box;
use std::time::Instant;

const POSITIONS: usize = 2000;

/// Nanoseconds a position.
fn time(mut position: impl FnMut(f64)) -> f64 {
    let start = Instant::now();
    for step in 0..POSITIONS {
        position(black_box(step as f64 * 0.01));
    }
    start.elapsed().as_secs_f64() * 1e9 / POSITIONS as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

macro_rules! race {
    ($kind:ident, $legs:literal, $one:ident, $all:ident) => {{
        let mut one_by_one = [(); $legs].map(|_| $one::Walker::new());
        let mut walker = $all::Walker::new();
        let (mut alone, mut together, mut ratios) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..61 {
            let first = time(|angle| {
                for leg in black_box(&mut one_by_one) {
                    assert!(leg.move_to([angle as $kind]).is_ok());
                }
            });
            let second = time(|angle| assert!(black_box(&mut walker).move_to([angle as $kind]).is_ok()));
            alone.push(first);
            together.push(second);
            ratios.push(second / first);
        }
        println!(
            "{}, {} legs: one by one {:.0} ns, together {:.0} ns, ratio {:.3}",
            stringify!($kind), $legs, median(alone), median(together), median(ratios)
        );
    }};
}
"#;
