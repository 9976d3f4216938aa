//! Runs in a crate of its own, beside the chains: times everything in turn, and prints points.

use crate::dense::Dense;
use mech_compiler::evaluate::Machine;
use mech_compiler::program::Position;
use mech_runtime::Mechanism;
use mech_test_support::{chain, median};
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 31;
/// How often everything is repeated, to show the spread.
const REPEATS: usize = 5;
/// Larger ones take seconds a position.
const LARGEST_DENSE: usize = 300;

/// Moves there and back by some degrees, so many positions; gives nanoseconds a position.
type Mover = Box<dyn FnMut(usize) -> f64>;

fn timed(mut move_to: impl FnMut(f64)) -> impl FnMut(usize) -> f64 {
    move |positions| {
        let start = Instant::now();
        for step in 0..positions {
            // 0 to 5 degrees and back, a degree a step.
            let degree = (step % 10).min(10 - step % 10);
            move_to(black_box((degree as f64).to_radians()));
        }
        start.elapsed().as_secs_f64() * 1e9 / positions as f64
    }
}

pub(crate) fn emitted<M: Mechanism<Scalar = f64, Motors = [f64; 1]> + 'static>() -> Mover {
    // Large ones would not fit on the stack of a closure that is moved about.
    let mut mechanism = Box::new(M::new());
    let start = mechanism.motors()[0];
    Box::new(timed(move |angle| {
        assert!(black_box(&mut mechanism).move_to([start + angle]).is_ok());
    }))
}

fn interpreted(loops: usize) -> Mover {
    let compiled = Box::leak(Box::new(mech_compiler::compile(&chain(loops)).expect("it moves")));
    let mut machine = Machine::<f64>::new(&compiled.program);
    let start = machine.position().motors[0];
    Box::new(timed(move |angle| {
        assert!(black_box(&mut machine).move_to(&[start + angle]).is_ok());
    }))
}

fn dense(loops: usize) -> Mover {
    let mut dense = Dense::chain(loops);
    Box::new(timed(move |angle| {
        assert!(black_box(&mut dense).move_to(angle));
    }))
}

/// The same positions from the dense iteration and from the interpreter.
fn agree(loops: usize) {
    let compiled = mech_compiler::compile(&chain(loops)).expect("it moves");
    let (mut machine, mut dense) = (Machine::<f64>::new(&compiled.program), Dense::chain(loops));
    let Position { motors, poses, .. } = machine.position().clone();
    for degree in 0..6 {
        let angle = f64::from(degree).to_radians();
        machine.move_to(&[motors[0] + angle]).expect("it moves");
        assert!(dense.move_to(angle), "it moves");
        // By how much each link has turned since the start: frames differ.
        let turned = machine.position().poses.iter().zip(&poses).skip(1).map(|(pose, start)| {
            [pose[0] * start[0] + pose[1] * start[1], pose[1] * start[0] - pose[0] * start[1]]
        });
        for (ours, theirs) in turned.zip(dense.turned()) {
            let off = (ours[0] - theirs[0]).abs().max((ours[1] - theirs[1]).abs());
            assert!(off < 1e-9, "both compute the same: {off}");
        }
    }
}

/// Prints the time of each in turn, interleaved.
pub(crate) fn run(emitted: Vec<(usize, Mover)>) {
    if emitted.is_empty() {
        return;
    }
    let mut movers: Vec<(String, usize, Mover)> = Vec::new();
    let chains: Vec<usize> = emitted.iter().map(|(loops, _)| *loops).collect();
    for (loops, mover) in emitted {
        movers.push(("emitted".to_owned(), loops, mover));
        movers.push(("interpreted".to_owned(), loops, interpreted(loops)));
    }
    for loops in [1, 3, 10, 30, 100, LARGEST_DENSE] {
        if loops <= 100 {
            agree(loops);
        }
        movers.push(("dense".to_owned(), loops, dense(loops)));
    }
    // About as long for each, whatever its size: half a millisecond, and a step there and back at least.
    let positions: Vec<usize> = movers
        .iter_mut()
        .map(|(_, _, mover)| {
            let first = mover(10);
            ((5e5 / first / 10.0) as usize).clamp(1, 5000) * 10
        })
        .collect();
    let mut repeats = vec![Vec::new(); movers.len()];
    for _ in 0..REPEATS {
        let mut rounds = vec![Vec::new(); movers.len()];
        for round in 0..ROUNDS {
            for (index, (name, loops, mover)) in movers.iter_mut().enumerate() {
                // What takes seconds is not taken as often.
                if name == "dense" && *loops > 30 && round >= 1 {
                    continue;
                }
                rounds[index].push(mover(positions[index]));
            }
        }
        for (all, rounds) in repeats.iter_mut().zip(rounds) {
            all.push(median(rounds.into_iter()));
        }
    }
    let times: Vec<f64> = repeats.iter().map(|all| median(all.iter().copied())).collect();
    let time = |name: &str, loops: usize| {
        let found = movers.iter().position(|mover| mover.0 == name && mover.1 == loops);
        found.map_or(f64::NAN, |index| times[index])
    };
    println!(
        "{:>12} {:>6} {:>14} {:>10} {:>22}",
        "", "loops", "ns a position", "ns a loop", "range"
    );
    for (((name, loops, _), time), all) in movers.iter().zip(&times).zip(&repeats) {
        let count = *loops as f64;
        let (least, most) = (
            all.iter().copied().fold(f64::INFINITY, f64::min),
            all.iter().copied().fold(0.0, f64::max),
        );
        println!(
            "{name:>12} {loops:>6} {time:>14.1} {:>10.2} {:>10.2} to {:>8.2}",
            time / count,
            least / count,
            most / count
        );
    }
    let each: Vec<f64> =
        chains.iter().map(|&loops| time("emitted", loops) / loops as f64).collect();
    let spread = |each: &[f64]| {
        each.iter().copied().fold(0.0, f64::max)
            / each.iter().copied().fold(f64::INFINITY, f64::min)
    };
    for (what, spread) in [("of all", spread(&each)), ("from 10 loops", spread(&each[1..]))] {
        let missed = if spread <= 1.2 { "" } else { ": MISSED" };
        println!(
            "ns a loop, emitted, the greatest to the least {what}: {spread:.3} (at most 1.20{missed})"
        );
    }
    for &loops in &chains {
        let (code, interpreter, dense) =
            (time("emitted", loops), time("interpreted", loops), time("dense", loops));
        println!("{loops} loops: interpreted {:.1} × emitted", interpreter / code);
        if dense.is_finite() {
            println!("{loops} loops: dense {:.1} × emitted", dense / code);
        }
    }
    for ((name, loops, _), time) in movers.iter().zip(&times) {
        println!("point {name} {loops} {time}");
    }
}
