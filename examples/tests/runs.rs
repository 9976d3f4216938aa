//! Each of the six examples runs to its end and says what its page promises. `cargo test` builds them before this test.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// What an example prints, and the folder it ran in.
fn run(example: &str) -> (String, PathBuf) {
    let test = env::current_exe().expect("a test is a file");
    let built = test.parent().and_then(Path::parent);
    let built = built.expect("tests are built into `deps`").join("examples");
    let program = built.join(example).with_extension(env::consts::EXE_EXTENSION);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(example);
    fs::create_dir_all(&folder).expect("a folder to run in");
    let output = Command::new(&program).current_dir(&folder).output();
    let output = output.unwrap_or_else(|error| {
        let built = "`cargo test -p mech-examples` without `--test` builds it";
        panic!("{}: {error}; {built}", program.display())
    });
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{example}: {said}");
    let text = String::from_utf8(output.stdout).expect("it prints text");
    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    (text, folder)
}

/// The row of a printed table that begins with these words, split into words.
fn row(example: &str, start: &str) -> Vec<String> {
    let (text, _) = run(example);
    let mut lines = text.lines().map(str::trim);
    let line = lines.find(|line| line.starts_with(start));
    let line = line.unwrap_or_else(|| panic!("no row `{start}` in:\n{text}"));
    line.split_whitespace().map(str::to_owned).collect()
}

#[test]
fn the_rocker_is_back_after_a_turn() {
    assert_eq!(row("four_bar", "360°")[1], "0.00°");
}

#[test]
fn the_piston_travels_by_twice_the_crank() {
    assert_eq!(row("slider_crank", "180°")[1], "90.00");
}

#[test]
fn the_carrier_turns_as_willis_says() {
    assert_eq!(row("gears", "the ring is held")[4..6], ["3.200", "0.000"]);
    assert_eq!(row("gears", "the ring is held")[6], "1.000");
    assert_eq!(row("gears", "the carrier stands still")[6], "0.000");
}

#[test]
fn the_valve_opens_by_its_lift() {
    assert_eq!(row("cam", "135°")[1], "9.000");
    assert_eq!(row("cam", "270°")[1], "0.000");
}

#[test]
fn near_the_dead_point_the_press_needs_little_torque() {
    let [far, near] = ["-90°", "-2°"].map(|angle| row("forces", angle)[2].parse::<f64>());
    let (far, near) = (far.expect("a number"), near.expect("a number"));
    assert!(0.0 < near && near < far / 10.0, "{near} {far}");
}

#[test]
fn the_pictures_are_files() {
    let (_, folder) = run("picture");
    let start = |name: &str| fs::read(folder.join("target").join(name)).expect("it was written");
    assert!(start("picture.png").starts_with(b"\x89PNG"));
    assert!(start("picture.svg").starts_with(b"<svg"));
}
