//! What it costs that a leg stands twelve times: code, compile time and the time of a position, of a walker beside one leg.
//! `cargo bench -p mech-tests --bench alike`
//!
//! The mechanisms are written into a workspace of their own with cargo's own profiles, as `compile_time` does.

mod race;

use mech_test_support::{House, median};
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;
use std::path::Path;
use std::process::Command;

const ROUNDS: usize = 5;

/// Theo Jansen's leg.
const LEG: &str = include_str!("leg.txt");

fn main() {
    let [one, twelve] = [1, 12].map(|legs| mechanism(legs, "f64"));
    let texts = [&one, &twelve].map(|text| Text::of(text));
    for (what, part) in [
        ("what is solved, without tables, tokens", Text::solving as fn(&Text) -> usize),
        ("all of it, tokens", Text::all),
    ] {
        let [one, twelve] = [&texts[0], &texts[1]].map(part);
        print(what, one, twelve);
    }
    let names = ["empty", "leg", "walker", "race"];
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("alike-bench");
    let house = House::new(&root, &names, &[("mech-runtime", "mech-runtime")], "");
    house.put("empty", "fn main() {}\n");
    house.put("leg", &program(&one));
    house.put("walker", &program(&twelve));
    house.put("race", &race::program(mechanism));
    let names = ["empty", "leg", "walker"];
    for name in names {
        house.cargo(name, "release", "");
    }
    let [empty, leg, walker] = names.map(|name| code(&house.binary(name, "release")));
    print("machine code, bytes beside an empty program", leg - empty, walker - empty);
    let mut times = [const { Vec::new() }; 3];
    for _ in 0..ROUNDS {
        for (times, name) in times.iter_mut().zip(names) {
            times.push(house.rebuild(name, "release"));
        }
    }
    let [empty, leg, walker] = times.map(|times| median(times.into_iter()));
    println!(
        "compile time, release: empty {empty:.0} ms, leg {leg:.0} ms, walker {walker:.0} ms, ratio {:.2}",
        walker / leg
    );
    for flags in ["", "-C target-cpu=x86-64-v3"] {
        println!("a position of a walker beside its legs one by one, flags `{flags}`");
        house.cargo("race", "release", flags);
        print!("{}", house.run("race", "release", &[]));
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

/// Bytes of machine code, as `size` of binutils counts them.
fn code(program: &Path) -> usize {
    let output = Command::new("size").arg(program).output();
    let output = output.expect("binutils are installed").stdout;
    let output = String::from_utf8(output).expect("text");
    let mut words = output.lines().nth(1).expect("a line").split_whitespace();
    words.next().expect("a number").parse().expect("a number")
}
