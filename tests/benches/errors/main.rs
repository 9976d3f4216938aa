//! How long it takes until an error is reported, as a user has it: built by cargo's own profile for debugging, which does not optimise
//! macros. `cargo bench -p mech-tests --bench errors`

mod cases;

use cases::cases;
use std::fs;
use std::path::Path;
use std::process::Command;

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
    fs::create_dir_all(root.join("src")).expect("a folder");
    for (number, case) in cases.iter().enumerate() {
        let path = root.join(format!("{number}.txt"));
        fs::write(&path, &case.text).expect("a file");
        texts.push(path);
    }
    let mut slow = Vec::new();
    println!(
        "{:>24} {:>6} {:>10} {:>10}",
        "error", "links", "ms", "at most"
    );
    for (case, time) in cases.iter().zip(measured(&root, &texts)) {
        println!(
            "{:>24} {:>6} {time:>10.0} {:>10.0}",
            case.name, case.links, case.most
        );
        if time > case.most {
            slow.push((case.name, case.links));
        }
    }
    assert!(slow.is_empty(), "reported too late: {slow:?}");
}

/// The milliseconds until each error is reported.
fn measured(root: &Path, texts: &[std::path::PathBuf]) -> Vec<f64> {
    let ours = Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .expect("the workspace");
    let compiler = ours.join("mech-macros/compiler");
    let manifest = format!(
        "[package]\nname = \"errors\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n\
         mech-compiler = {{ path = '{}' }}\nproc-macro2 = {{ version = \"1\", default-features = false }}\n\
         quote = {{ version = \"1\", default-features = false }}\n",
        compiler.display()
    );
    fs::write(root.join("Cargo.toml"), manifest).expect("a file");
    fs::write(root.join("src/main.rs"), PROGRAM).expect("a file");
    // The same versions of everything, all of which are here already: nothing is asked of the network.
    fs::copy(ours.join("Cargo.lock"), root.join("Cargo.lock")).expect("the lock file");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["run", "--offline", "--quiet", "--"])
        .args(texts)
        .current_dir(root)
        .env("CARGO_TARGET_DIR", root.join("target"))
        .output()
        .expect("cargo runs");
    let output_text = String::from_utf8_lossy(&output.stdout);
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    output_text
        .lines()
        .map(|line| line.parse().expect("a number"))
        .collect()
}
