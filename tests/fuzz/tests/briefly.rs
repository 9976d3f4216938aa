//! A few mangled texts for each target, the same ones on every machine. `.ci/fuzz` tries more.

use std::process::Command;

/// Tries so many texts. What is built for tests is slow, and so are machines that do other things beside: a text may take half a minute.
fn find_nothing(target: &str, count: u32) {
    let program = env!("CARGO_BIN_EXE_fuzz");
    let tried = Command::new(program)
        .env("TMPDIR", env!("CARGO_TARGET_TMPDIR"))
        .args(["--limit", "30", "--count", &count.to_string(), target])
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&tried.stdout);
    let complaint = String::from_utf8_lossy(&tried.stderr);
    print!("{said}");
    assert!(tried.status.success(), "{said}{complaint}");
}

#[test]
fn mechanisms() {
    find_nothing("mechanism", 1500);
}

#[test]
fn documents() {
    find_nothing("document", 600);
}

#[test]
fn scripts() {
    find_nothing("script", 100);
}

#[test]
fn desks() {
    find_nothing("desk", 500);
}

#[test]
fn documents_of_linkage() {
    find_nothing("linkage", 200);
}

#[test]
fn links_of_pmks() {
    find_nothing("pmks", 500);
}
