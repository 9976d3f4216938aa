//! The compiler stands in the macro, and as a library in the command and in tests. Cargo builds it for both at once if everything it is made
//! of has the same features on both sides.

use std::collections::BTreeMap;
use std::process::Command;

/// The packages that cargo lists, as `name v1.2.3`.
fn packages(arguments: &[&str]) -> Vec<String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["tree", "--locked", "--offline", "--prefix", "none"])
        .args(arguments)
        .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
        .output()
        .expect("cargo runs");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(
        output.status.success() && !text.trim().is_empty(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let name = |line: &str| {
        let mut words = line.split(' ');
        Some(format!("{} {}", words.next()?, words.next()?))
    };
    text.lines().filter_map(name).collect()
}

#[test]
fn the_compiler_is_built_once() {
    let parts = packages(&["-p", "mech-compiler", "-e", "normal"]);
    assert!(parts.iter().any(|part| part.starts_with("nalgebra ")));
    // For tests, and without what only these need.
    for edges in ["normal,build,dev", "normal,build"] {
        // Those that are built several times, each as often as it is.
        let mut times = BTreeMap::new();
        for package in packages(&["--workspace", "-e", edges, "-d", "--depth", "0"]) {
            *times.entry(package).or_insert(0) += 1;
        }
        let twice: Vec<_> = times
            .into_iter()
            .filter(|(package, times)| *times > 1 && parts.contains(package))
            .collect();
        assert!(
            twice.is_empty(),
            "{edges}: {twice:?} have other features in the macro: see `build-dependencies` in studio/Cargo.toml, and `cargo tree -e features -i NAME`"
        );
    }
}
