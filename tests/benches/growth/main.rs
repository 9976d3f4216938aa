//! How the time of a position grows with the number of loops: chains of 1 to 1,000 loops, by the generated code, by the
//! interpreter, and as one dense Newton iteration over all loops. `cargo bench -p mech-tests --bench growth`
//!
//! The chains are written by `chain_text` into a crate of their own, as `compile_time` does, which this builds and runs.
//! The picture goes to `docs/growth.svg`.
#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "small numbers"
)]

// What runs in the crate that is written here is read here, too: so it is checked with everything else.
#[allow(dead_code, reason = "it runs there")]
mod bed;
#[allow(dead_code, reason = "it runs there")]
mod dense;
mod plot;

use mech_test_support::{House, chain_text, repository};
use plot::Line;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::time::Instant;

/// The chains that are compiled.
const CHAINS: [usize; 4] = [1, 10, 100, 1000];

/// The crate in which they run.
const BED: &str = "growth-bed";

fn main() {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("growth");
    let ours = [
        ("mech-runtime", "mech-runtime"),
        ("mech-compiler", "mech-macros/compiler"),
        ("mech-test-support", "tests/support"),
    ];
    let others =
        "nalgebra = { version = \"0.35.0\", default-features = false, features = [\"alloc\"] }\n";
    let house = House::new(&root, &[BED], &ours, others);
    house.write(&format!("{BED}/src/bed.rs"), include_str!("bed.rs"));
    house.write(&format!("{BED}/src/dense.rs"), include_str!("dense.rs"));
    // First without the chains, so that what is compiled with them can be timed.
    house.put(BED, &program(&[]));
    house.cargo(BED, "release", "");
    house.put(BED, &program(&CHAINS));
    let start = Instant::now();
    house.cargo(BED, "release", "");
    println!("{CHAINS:?} loops compiled in {:.1} s, release", start.elapsed().as_secs_f64());
    let text = house.run(BED, "release", &[]);
    print!("{text}");

    let lines = lines(&text);
    for line in &lines {
        println!("{:<24} grows as loops^{:.2}", line.name, line.exponent());
    }
    let picture = repository().join("docs/growth.svg");
    fs::write(picture, plot::svg(&lines)).expect("a file");
}

/// What the bed printed: `point` lines of a name, a number of loops and nanoseconds a position.
fn lines(text: &str) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for words in text.lines().filter_map(|line| line.strip_prefix("point ")) {
        let [name, loops, time] = words.split(' ').collect::<Vec<_>>()[..] else {
            panic!("not a point: {words}")
        };
        let point = (loops.parse().expect("a number"), time.parse().expect("a number"));
        match lines.iter_mut().find(|line| line.name == name) {
            Some(line) => line.points.push(point),
            None => lines.push(Line { name: name.to_owned(), points: vec![point] }),
        }
    }
    lines
}

fn program(chains: &[usize]) -> String {
    let mut text = "#![allow(dead_code)]\nmod bed;\nmod dense;\n".to_owned();
    let mut calls = String::new();
    for &loops in chains {
        let chain = chain_text(loops);
        let _ =
            writeln!(text, "mod chain_{loops} {{ mech_runtime::mechanism! {{ pub {chain} }} }}");
        let _ = writeln!(calls, "        ({loops}, bed::emitted::<chain_{loops}::Chain>()),");
    }
    let _ = writeln!(text, "fn main() {{\n    bed::run(vec![\n{calls}    ]);\n}}");
    text
}
