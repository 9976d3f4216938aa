//! What it costs that a leg stands twelve times: code, compile time and the time of a position, of a walker beside one leg.
//! `cargo bench -p mech-tests --bench alike`
//!
//! The mechanisms are written into a workspace of their own with cargo's own profiles, as `compile_time` does.

mod race;

use mech_test_support::median;
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Instant, SystemTime};

const ROUNDS: usize = 5;

/// Theo Jansen's leg.
const LEG: &str = include_str!("leg.txt");

fn main() {
    let [one, twelve] = [1, 12].map(|legs| mechanism(legs, "f64"));
    let texts = [&one, &twelve].map(|text| Text::of(text));
    for (what, part) in [
        (
            "what is solved, without tables, tokens",
            Text::solving as fn(&Text) -> usize,
        ),
        ("all of it, tokens", Text::all),
    ] {
        let [one, twelve] = [&texts[0], &texts[1]].map(part);
        print(what, one, twelve);
    }
    let house = House::build(&[
        ("empty", "fn main() {}\n".to_owned()),
        ("leg", program(&one)),
        ("walker", program(&twelve)),
        ("race", race::program(mechanism)),
    ]);
    for name in ["empty", "leg", "walker"] {
        house.cargo(name, "");
    }
    let [empty, leg, walker] = ["empty", "leg", "walker"].map(|name| house.code(name));
    print(
        "machine code, bytes beside an empty program",
        leg - empty,
        walker - empty,
    );
    let mut times = [const { Vec::new() }; 3];
    for _ in 0..ROUNDS {
        for (times, name) in times.iter_mut().zip(["empty", "leg", "walker"]) {
            times.push(house.rebuild(name));
        }
    }
    let [empty, leg, walker] = times.map(|times| median(times.into_iter()));
    println!(
        "compile time, release: empty {empty:.0} ms, leg {leg:.0} ms, walker {walker:.0} ms, ratio {:.2}",
        walker / leg
    );
    for flags in ["", "-C target-cpu=x86-64-v3"] {
        println!("a position of a walker beside its legs one by one, flags `{flags}`");
        house.cargo("race", flags);
        house.run("race");
    }
}

fn print(what: &str, one: usize, twelve: usize) {
    #[expect(clippy::cast_precision_loss, reason = "small numbers")]
    let ratio = twelve as f64 / one as f64;
    println!("{what}: one leg {one}, twelve {twelve}, ratio {ratio:.2}");
}

/// The text of a mechanism with so many legs.
fn mechanism(legs: usize, kind: &str) -> String {
    let uses = if legs == 1 {
        "use left: Leg { frame = ground, crank = axle };".to_owned()
    } else {
        let half = legs / 2;
        let phase = format!("phase = k * {} deg", 360 / half);
        format!(
            "use left[{half}]: Leg({phase}) {{ frame = ground, crank = axle }};
            use right[{half}]: Leg({phase}) mirrored {{ frame = ground, crank = axle }};"
        )
    };
    format!(
        "pub struct Walker: {kind};
        {LEG}
        ground {{ point shaft = (0, 0); }}
        link axle {{ point shaft = (0, 0); }}
        joint main = revolute(ground.shaft, axle.shaft);
        motor main;
        {uses}"
    )
}

/// A program that turns it by one degree.
fn program(mechanism: &str) -> String {
    format!(
        "mech_runtime::mechanism! {{ {mechanism} }}
        fn main() {{
            let mut walker = Walker::new();
            let angle: f64 = std::env::args().count() as f64;
            std::process::exit(i32::from(walker.move_to([angle.to_radians()]).is_err()));
        }}\n"
    )
}

/// The generated text of a mechanism.
struct Text(TokenStream);

impl Text {
    fn of(mechanism: &str) -> Self {
        let tokens: TokenStream = mechanism.parse().expect("tokens");
        Self(mech_compiler::expand(quote!(::mech_runtime; #tokens)))
    }

    fn all(&self) -> usize {
        count(self.0.clone())
    }

    /// The tokens of the module in which positions are found, without its tables.
    fn solving(&self) -> usize {
        module(self.0.clone()).map_or(0, count)
    }
}

/// The body of the module `positions`.
fn module(tokens: TokenStream) -> Option<TokenStream> {
    let mut is_it = false;
    for tree in tokens {
        match tree {
            TokenTree::Ident(word) => is_it = word == "positions",
            TokenTree::Group(group) if is_it => return Some(group.stream()),
            TokenTree::Group(group) => {
                let found = module(group.stream());
                if found.is_some() {
                    return found;
                }
            }
            _ => is_it = false,
        }
    }
    None
}

/// The number of tokens that do not belong to a table.
fn count(tokens: TokenStream) -> usize {
    let (mut count, mut in_table) = (0, false);
    for tree in tokens {
        match tree {
            TokenTree::Ident(word) if word == "static" => in_table = true,
            TokenTree::Punct(mark) if in_table && mark.as_char() == ';' => in_table = false,
            _ if in_table => {}
            TokenTree::Group(group) => count += 2 + self::count(group.stream()),
            _ => count += 1,
        }
    }
    count
}

/// A workspace with these crates.
struct House(PathBuf);

impl House {
    fn build(crates: &[(&str, String)]) -> Self {
        let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("alike-bench");
        let ours = Path::new(env!("CARGO_MANIFEST_DIR"))
            .parent()
            .expect("the workspace");
        for (name, program) in crates {
            let folder = root.join(name);
            fs::create_dir_all(folder.join("src")).expect("a folder");
            let manifest = format!(
                "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[dependencies]\nmech-runtime = {{ path = '{}' }}\n",
                ours.join("mech-runtime").display()
            );
            write(&folder.join("Cargo.toml"), &manifest);
            write(&folder.join("src/main.rs"), program);
        }
        let members: Vec<&str> = crates.iter().map(|(name, _)| *name).collect();
        let workspace = format!("[workspace]\nresolver = \"3\"\nmembers = {members:?}\n");
        write(&root.join("Cargo.toml"), &workspace);
        // The same versions of everything, all of which are here already: nothing is asked of the network.
        fs::copy(ours.join("Cargo.lock"), root.join("Cargo.lock")).expect("the lock file");
        Self(root)
    }

    fn cargo(&self, name: &str, flags: &str) {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let status = Command::new(cargo)
            .args(["build", "--offline", "--quiet", "--release", "-p", name])
            .current_dir(&self.0)
            .env("CARGO_TARGET_DIR", self.0.join("target"))
            .env("RUSTFLAGS", flags)
            .status()
            .expect("cargo runs");
        assert!(status.success(), "{name} is built");
    }

    fn binary(&self, name: &str) -> PathBuf {
        let program = self.0.join("target/release").join(name);
        program.with_extension(std::env::consts::EXE_EXTENSION)
    }

    fn run(&self, name: &str) {
        let status = Command::new(self.binary(name)).status().expect("it runs");
        assert!(status.success(), "{name} runs");
    }

    /// Bytes of machine code, as `size` of binutils counts them.
    fn code(&self, name: &str) -> usize {
        let output = Command::new("size").arg(self.binary(name)).output();
        let output = output.expect("binutils are installed").stdout;
        let output = String::from_utf8(output).expect("text");
        let mut words = output.lines().nth(1).expect("a line").split_whitespace();
        words.next().expect("a number").parse().expect("a number")
    }

    /// Milliseconds from a change in the crate to the new program.
    fn rebuild(&self, name: &str) -> f64 {
        let main = self.0.join(name).join("src/main.rs");
        let file = File::options()
            .append(true)
            .open(main)
            .expect("the program");
        file.set_modified(SystemTime::now()).expect("a new date");
        let start = Instant::now();
        self.cargo(name, "");
        start.elapsed().as_secs_f64() * 1e3
    }
}

fn write(path: &Path, text: &str) {
    fs::write(path, text).expect("a file");
}
