//! Crates of one line a case, checked by the compiler.

use std::fs;
use std::path::Path;

/// So many lines are compiled at once.
const BATCH: usize = 100;

/// One case: a module on a line of its own.
pub(crate) struct Line {
    /// What it tries.
    what: String,
    code: String,
    /// The errors that it should have.
    errors: Vec<String>,
}

impl Line {
    /// A case that should compile.
    pub(crate) fn new(what: String, code: String) -> Self {
        let errors = Vec::new();
        Self { what, code, errors }
    }

    /// A case that should have some of these errors and no others.
    pub(crate) fn refused(what: String, code: String, errors: Vec<String>) -> Self {
        Self { what, code, errors }
    }
}

/// Compiles all of them, and compares what the compiler says with what it should say.
pub(crate) fn compile(name: &str, lines: &[Line]) {
    let mut wrong = Vec::new();
    for (number, batch) in lines.chunks(BATCH).enumerate() {
        wrong.extend(check(&format!("{name}_{number}"), batch));
    }
    let count = wrong.len();
    wrong.truncate(40);
    assert!(count == 0, "{count} lines are wrong:\n{}", wrong.join("\n"));
}

/// What is wrong with the lines of a crate.
fn check(name: &str, lines: &[Line]) -> Vec<String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("names");
    let mut rustc = mech_test_support::rustc(&folder);
    let source = folder.join(format!("{name}.rs"));
    let mut text = "#![allow(warnings)] ".to_owned();
    for (number, line) in lines.iter().enumerate() {
        let code = line.code.replace('\n', " ");
        text += &format!("mod case_{number} {{ {code} }}\n");
    }
    fs::write(&source, text).expect("a file");
    let output = rustc
        .args(["--crate-type", "lib", "--emit", "metadata"])
        .args(["--error-format", "short"])
        .arg(&source)
        .output()
        .expect("the compiler runs");
    let said = String::from_utf8_lossy(&output.stderr);
    let mut wrong = Vec::new();
    let mut reported = vec![false; lines.len()];
    for error in said.lines().filter(|line| line.contains(": error")) {
        let place = error.split(".rs:").nth(1).and_then(|place| place.split(':').next());
        let number = place.and_then(|number| number.parse::<usize>().ok());
        let Some(line) = number.and_then(|number| lines.get(number.checked_sub(1)?)) else {
            wrong.push(error.to_owned());
            continue;
        };
        let is_expected = line.errors.iter().any(|expected| {
            let first = expected.lines().next().unwrap_or_default();
            error.ends_with(&format!(": error: {first}"))
        });
        if is_expected {
            reported[number.unwrap_or_default() - 1] = true;
        } else {
            wrong.push(format!("{}: {error}", line.what));
        }
    }
    for (line, reported) in lines.iter().zip(reported) {
        if !line.errors.is_empty() && !reported {
            wrong.push(format!("{}: nothing is said", line.what));
        }
    }
    let should_compile = lines.iter().all(|line| line.errors.is_empty());
    if output.status.success() != should_compile && wrong.is_empty() {
        wrong.push(said.into_owned());
    }
    wrong
}
