//! How long a crate takes to be built again after a change in it, with mechanisms of several sizes beside an empty one, as
//! a user has it: in a workspace of its own, with cargo's own profiles. `cargo bench -p mech-tests --bench compile_time`

use mech_test_support::{chain_text, median};
use std::fmt::Write as _;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Instant, SystemTime};

const ROUNDS: usize = 5;

/// The profiles, and what they are for.
const PROFILES: [(&str, &str); 3] = [
    ("dev", "debug"),
    ("whole", "debug, not incremental"),
    ("release", "release"),
];

/// How many loops each crate has, and its name.
const CRATES: [(usize, &str); 5] = [
    (0, "empty"),
    (1, "four-bar"),
    (10, "loops-10"),
    (100, "loops-100"),
    (200, "loops-200"),
];

fn main() {
    let house = House::build();
    for (profile, title) in PROFILES {
        println!("{title:>24} {:>10} {:>14}", "ms", "beside empty");
        let mut empty = 0.0;
        for (loops, name) in CRATES {
            house.cargo(name, profile);
            house.run(name, profile);
            let time = median((0..ROUNDS).map(|_| house.rebuild(name, profile)));
            if loops == 0 {
                empty = time;
            }
            println!("{name:>24} {time:>10.0} {:>+14.0}", time - empty);
        }
    }
}

/// A workspace with these crates.
struct House(PathBuf);

impl House {
    fn build() -> Self {
        let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("compile-time");
        let ours = Path::new(env!("CARGO_MANIFEST_DIR"))
            .parent()
            .expect("the workspace");
        let mut members = String::new();
        for (loops, name) in CRATES {
            let _ = write!(members, "\"{name}\", ");
            let folder = root.join(name);
            fs::create_dir_all(folder.join("src")).expect("a folder");
            write(&folder.join("Cargo.toml"), &manifest(name, ours));
            write(&folder.join("src/main.rs"), &program(loops));
        }
        let workspace = format!(
            "[workspace]\nresolver = \"3\"\nmembers = [{members}]\n[profile.whole]\ninherits = \"dev\"\nincremental = false\n"
        );
        write(&root.join("Cargo.toml"), &workspace);
        // The same versions of everything, all of which are here already: nothing is asked of the network.
        fs::copy(ours.join("Cargo.lock"), root.join("Cargo.lock")).expect("the lock file");
        Self(root)
    }

    fn cargo(&self, name: &str, profile: &str) {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let status = Command::new(cargo)
            .args([
                "build",
                "--offline",
                "--quiet",
                "-p",
                name,
                "--profile",
                profile,
            ])
            .current_dir(&self.0)
            .env("CARGO_TARGET_DIR", self.0.join("target"))
            .status()
            .expect("cargo runs");
        assert!(status.success(), "{name} is built");
    }

    /// Milliseconds from a change in the crate to the new program.
    fn rebuild(&self, name: &str, profile: &str) -> f64 {
        let main = self.0.join(name).join("src/main.rs");
        let file = File::options()
            .append(true)
            .open(main)
            .expect("the program");
        file.set_modified(SystemTime::now()).expect("a new date");
        let start = Instant::now();
        self.cargo(name, profile);
        start.elapsed().as_secs_f64() * 1e3
    }

    /// It moves, on an ordinary stack.
    fn run(&self, name: &str, profile: &str) {
        let folder = if profile == "dev" { "debug" } else { profile };
        let program = self.0.join("target").join(folder).join(name);
        let program = program.with_extension(std::env::consts::EXE_EXTENSION);
        let status = Command::new(program).status().expect("it runs");
        assert!(status.success(), "{name} moves");
    }
}

fn write(path: &Path, text: &str) {
    fs::write(path, text).expect("a file");
}

fn manifest(name: &str, ours: &Path) -> String {
    let runtime = ours.join("mech-runtime");
    format!(
        "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[dependencies]\nmech-runtime = {{ path = '{}' }}\n",
        runtime.display()
    )
}

/// A program with a chain of so many loops, which turns by one degree.
fn program(loops: usize) -> String {
    if loops == 0 {
        return "fn main() {}\n".to_owned();
    }
    let (text, last) = (chain_text(loops), 3 * loops);
    format!(
        "mech_runtime::mechanism! {{\n{text}}}\n\nfn main() {{\n    let mut chain = Chain::new();\n    \
         chain.move_to([1_f64.to_radians()]).expect(\"it moves\");\n    assert!(chain.j3() != 0.0 && chain.j{last}().abs() < 0.1);\n}}\n"
    )
}
