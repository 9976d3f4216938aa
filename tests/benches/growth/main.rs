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

use mech_test_support::chain_text;
use plot::Line;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// The chains that are compiled.
const CHAINS: [usize; 4] = [1, 10, 100, 1000];

fn main() {
    let ours = Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .expect("the workspace");
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("growth");
    fs::create_dir_all(root.join("src")).expect("a folder");
    write(&root.join("Cargo.toml"), &manifest(ours));
    // The same versions of everything, all of which are here already: nothing is asked of the network.
    fs::copy(ours.join("Cargo.lock"), root.join("Cargo.lock")).expect("the lock file");
    for (name, text) in [
        ("bed.rs", include_str!("bed.rs")),
        ("dense.rs", include_str!("dense.rs")),
    ] {
        write(&root.join("src").join(name), text);
    }
    // First without the chains, so that what is compiled with them can be timed.
    write(&root.join("src/main.rs"), &program(&[]));
    build(&root);
    write(&root.join("src/main.rs"), &program(&CHAINS));
    let start = Instant::now();
    build(&root);
    println!(
        "{CHAINS:?} loops compiled in {:.1} s, release",
        start.elapsed().as_secs_f64()
    );
    let bed = root.join("target/release/growth-bed");
    let output = Command::new(bed.with_extension(std::env::consts::EXE_EXTENSION))
        .output()
        .expect("it runs");
    let text = String::from_utf8(output.stdout).expect("text");
    print!("{text}");
    eprint!("{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "the chains move");

    let lines = lines(&text);
    for line in &lines {
        println!("{:<24} grows as loops^{:.2}", line.name, line.exponent());
    }
    write(&ours.join("docs/growth.svg"), &plot::svg(&lines));
}

/// What the bed printed: `point` lines of a name, a number of loops and nanoseconds a position.
fn lines(text: &str) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for words in text.lines().filter_map(|line| line.strip_prefix("point ")) {
        let [name, loops, time] = words.split(' ').collect::<Vec<_>>()[..] else {
            panic!("not a point: {words}")
        };
        let point = (
            loops.parse().expect("a number"),
            time.parse().expect("a number"),
        );
        match lines.iter_mut().find(|line| line.name == name) {
            Some(line) => line.points.push(point),
            None => lines.push(Line {
                name: name.to_owned(),
                points: vec![point],
            }),
        }
    }
    lines
}

fn program(chains: &[usize]) -> String {
    let mut text = "#![allow(dead_code)]\nmod bed;\nmod dense;\n".to_owned();
    let mut calls = String::new();
    for &loops in chains {
        let chain = chain_text(loops);
        let _ = writeln!(
            text,
            "mod chain_{loops} {{ mech_runtime::mechanism! {{ pub {chain} }} }}"
        );
        let _ = writeln!(
            calls,
            "        ({loops}, bed::emitted::<chain_{loops}::Chain>()),"
        );
    }
    let _ = writeln!(text, "fn main() {{\n    bed::run(vec![\n{calls}    ]);\n}}");
    text
}

fn build(root: &Path) {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args(["build", "--offline", "--quiet", "--release"])
        .current_dir(root)
        .env("CARGO_TARGET_DIR", root.join("target"))
        .status()
        .expect("cargo runs");
    assert!(status.success(), "the chains are built");
}

fn write(path: &Path, text: &str) {
    fs::write(path, text).expect("a file");
}

fn manifest(ours: &Path) -> String {
    let path = |folder: &str| ours.join(folder).display().to_string();
    format!(
        "[package]\nname = \"growth-bed\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n\
         mech-runtime = {{ path = '{}' }}\nmech-compiler = {{ path = '{}' }}\nmech-test-support = {{ path = '{}' }}\n\
         nalgebra = {{ version = \"0.35.0\", default-features = false, features = [\"alloc\"] }}\n",
        path("mech-runtime"),
        path("mech-macros/compiler"),
        path("tests/support"),
    )
}
