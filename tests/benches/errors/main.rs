//! How long it takes until an error is reported, as a user has it: built by cargo's own profile for debugging, which does not optimise
//! macros. `cargo bench -p mech-tests --bench errors`

mod cases;

use cases::cases;
use mech_test_support::House;
use std::path::{Path, PathBuf};

/// A program that expands the text of each file it is given, and prints how many milliseconds that took.
const PROGRAM: &str = r#"
fn main() {
    for path in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&path).expect("a text");
        let body: proc_macro2::TokenStream = text.parse().expect("tokens");
        let start = std::time::Instant::now();
        let expanded = mech_compiler::expand(quote::quote!(::mech_runtime; #body));
        let time = start.elapsed().as_secs_f64() * 1e3;
        assert!(expanded.to_string().contains("compile_error"), "{path} is in order");
        println!("{time}");
    }
}
"#;

fn main() {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("errors");
    let cases = cases();
    let mut texts = Vec::new();
    let others = "proc-macro2 = { version = \"1\", default-features = false }\nquote = { version = \"1\", default-features = false }\n";
    let ours = [("mech-compiler", "mech-macros/compiler")];
    let house = House::new(&root, &["errors"], &ours, others);
    for (number, case) in cases.iter().enumerate() {
        let name = format!("{number}.txt");
        house.write(&name, &case.text);
        texts.push(root.join(name));
    }
    let mut slow = Vec::new();
    println!("{:>24} {:>6} {:>10} {:>10}", "error", "links", "ms", "at most");
    for (case, time) in cases.iter().zip(measured(&house, &texts)) {
        println!("{:>24} {:>6} {time:>10.0} {:>10.0}", case.name, case.links, case.most);
        if time > case.most {
            slow.push((case.name, case.links));
        }
    }
    assert!(slow.is_empty(), "reported too late: {slow:?}");
}

/// The milliseconds until each error is reported.
fn measured(house: &House, texts: &[PathBuf]) -> Vec<f64> {
    house.put("errors", PROGRAM);
    house.cargo("errors", "dev", "");
    let printed = house.run("errors", "dev", texts);
    let numbers = printed.lines().map(|line| line.parse().expect("a number"));
    numbers.collect()
}
