//! How long a mechanism takes to be analysed, planned, written and expanded, by its number of loops.

use mech_compiler::{compile, evaluate, plan, program, structure};
use mech_test_support::chain;
use std::time::Instant;

fn main() {
    println!(
        "{:>6} {:>12} {:>12} {:>12} {:>12} {:>12}",
        "loops", "structure", "plan", "program", "settle", "together"
    );
    for loops in [1, 10, 30, 100, 300, 1000] {
        let model = chain(loops);
        let rounds = if loops > 100 { 1 } else { 5 };
        let mut best = [f64::INFINITY; 5];
        for _ in 0..rounds {
            let mut times = [0.0; 5];
            let start = Instant::now();
            let structure = structure::analyse(&model).expect("coherent");
            times[0] = lap(start);
            let start = Instant::now();
            let plan = plan::plan(&model, &structure).expect("sequential");
            times[1] = lap(start);
            let start = Instant::now();
            let mut program = program::build(&model, &plan);
            times[2] = lap(start);
            let start = Instant::now();
            evaluate::settle(&mut program).expect("it closes");
            times[3] = lap(start);
            let start = Instant::now();
            let compiled = compile(&model).expect("coherent");
            times[4] = lap(start);
            assert_eq!(compiled.plan.loops().count(), loops);
            for (best, time) in best.iter_mut().zip(times) {
                *best = best.min(time);
            }
        }
        let times: Vec<String> = best.iter().map(|time| format!("{time:9.2} ms")).collect();
        println!("{loops:>6} {}", times.join(" "));
    }
    println!("wanted: 100 loops below 50 ms, 1000 loops below 5 s");
}

/// Milliseconds since.
fn lap(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}
