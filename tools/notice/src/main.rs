//! The notice that goes with a program: the crates that are in it, and their licences, each text once.
//!
//! `cargo notice PACKAGE [TARGET]`, as in `cargo notice mech-studio >NOTICE.txt`.

mod package;
mod text;

use package::Package;
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::process::ExitCode;
use text::Text;

/// What is in every program.
const STANDARD_LIBRARY: &str = "\
The standard library of Rust is in it, too: MIT OR Apache-2.0, by the Rust Project's developers and others,
https://github.com/rust-lang/rust/blob/master/COPYRIGHT
";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let made = match words[..] {
        [package] => notice(package, None),
        [package, target] => notice(package, Some(target)),
        _ => Err("say `cargo notice PACKAGE [TARGET]`".to_owned()),
    };
    let written = made.and_then(|notice| {
        let written = io::stdout().write_all(notice.as_bytes());
        written.map_err(|error| error.to_string())
    });
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// The notice for a package of the workspace, on this machine or for another target.
fn notice(package: &str, target: Option<&str>) -> Result<String, String> {
    let packages = Package::all_in(package, target)?;
    let mut notice = format!(
        "{package} contains these crates. Each stands with its licence, its place, and those who wrote it. The texts follow; \
         a crate without a text has the usual ones of its licence.\n\n"
    );
    for package in &packages {
        notice += &format!("{package}: {}\n", package.terms());
    }
    notice += "\n";
    notice += STANDARD_LIBRARY;
    // The texts in the order of the crates, and whose they are.
    let mut order: Vec<Text> = Vec::new();
    let mut owners: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for package in &packages {
        for text in package.texts()? {
            let mine = owners.entry(text.key()).or_default();
            if mine.is_empty() {
                order.push(text);
            }
            let name = package.to_string();
            if !mine.contains(&name) {
                mine.push(name);
            }
        }
    }
    for text in order {
        let names = owners.remove(&text.key()).unwrap_or_default();
        let line = "-".repeat(80);
        notice += &format!("\n{line}\n{}\n{line}\n\n{text}\n", names.join(", "));
    }
    Ok(notice)
}
