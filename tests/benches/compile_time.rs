//! How long a crate takes to be built again after a change in it, with mechanisms of several sizes beside an empty one, as
//! a user has it: in a workspace of its own, with cargo's own profiles. `cargo bench -p mech-tests --bench compile_time`

use mech_test_support::{House, chain_text, median};
use std::path::Path;

const ROUNDS: usize = 5;

/// The profiles, and what they are for.
const PROFILES: [(&str, &str); 3] =
    [("dev", "debug"), ("whole", "debug, not incremental"), ("release", "release")];

/// How many loops each crate has, and its name.
const CRATES: [(usize, &str); 5] =
    [(0, "empty"), (1, "four-bar"), (10, "loops-10"), (100, "loops-100"), (200, "loops-200")];

fn main() {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("compile-time");
    let names = CRATES.map(|(_, name)| name);
    let house = House::new(&root, &names, &[("mech-runtime", "mech-runtime")], "");
    for (loops, name) in CRATES {
        house.put(name, &program(loops));
    }
    for (profile, title) in PROFILES {
        println!("{title:>24} {:>10} {:>14}", "ms", "beside empty");
        let mut empty = 0.0;
        for (loops, name) in CRATES {
            house.cargo(name, profile, "");
            // It moves, on an ordinary stack.
            let _ = house.run(name, profile, &[]);
            let time = median((0..ROUNDS).map(|_| house.rebuild(name, profile)));
            if loops == 0 {
                empty = time;
            }
            println!("{name:>24} {time:>10.0} {:>+14.0}", time - empty);
        }
    }
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
