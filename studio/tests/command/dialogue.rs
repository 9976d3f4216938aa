//! Whole sessions of the dialogue. What it answers and refuses is in `tests/cases/commands/dialogue.txt`.

use crate::run::{FOUR_BAR, Folder, begin, mech_said, repository};
use std::fs;
use std::io::Write;

#[test]
fn the_session_to_figure_1_of_the_paper_is_replayed() {
    let script = fs::read_to_string(repository("studio/sessions/figure_1.txt")).expect("a script");
    let folder = Folder::new().with("figure_1.txt", script);
    let done = folder.mech("run figure_1.txt").done();
    assert!(
        done.contains("GearedPiston moves: 4 moving links, 6 joints, 1 motor, 1 loop\n"),
        "{done}"
    );
    assert_eq!(folder.names(), ["figure_1.mech", "figure_1.png", "figure_1.txt"]);
    // The same mechanism as that of the gallery: the piston is at the same places.
    let gallery = repository("examples/gallery/src/mechanisms/geared_piston.rs");
    let gallery = gallery.to_str().expect("UTF-8");
    let table = |file: &str| folder.mech(&format!("table {file} piston.pin --steps 12")).done();
    assert_eq!(table("figure_1.mech"), table(gallery));
    let joints = |file: &str| {
        let report = folder.mech(&format!("report {file}")).done();
        let trunk = report.lines().find(|line| line.trim_start().starts_with("trunk"));
        trunk.expect("a trunk").to_owned()
    };
    assert_eq!(joints("figure_1.mech"), joints(gallery));
}

#[test]
fn a_file_that_somebody_else_changed_is_not_written_over() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    // The dialogue holds the file while it is changed: its second line is only read after that.
    let mut child = begin(&folder.path(""), &[""; 0]);
    let mut input = child.stdin.take().expect("an input");
    let mut output = child.stdout.take().expect("an output");
    input.write_all(b"open a.mech\nsteps\nremove joint d\n").expect("it listens");
    input.flush().expect("it listens");
    let mut first = [0; 1];
    // It answers when it has read the file.
    std::io::Read::read_exact(&mut output, &mut first).expect("an answer");
    fs::write(folder.path("a.mech"), "struct Other;").expect("a file");
    input.write_all(b"save\n").expect("it listens");
    drop(input);
    let mut others = String::new();
    std::io::Read::read_to_string(&mut output, &mut others).expect("UTF-8");
    let mut complaint = String::new();
    let mut errors = child.stderr.take().expect("an output");
    std::io::Read::read_to_string(&mut errors, &mut complaint).expect("UTF-8");
    assert_eq!(child.wait().expect("it ends").code(), Some(3));
    assert_eq!(
        complaint,
        "error: `a.mech` was changed by another program after it was read; nothing is written\n"
    );
    assert_eq!(folder.text("a.mech"), "struct Other;");
}

/// The dialogue of README can be had, line by line: what it says is refused is, and nothing else.
#[test]
fn the_dialogue_of_the_readme_can_be_had() {
    let readme = fs::read_to_string(repository("README.md")).expect("a page");
    let lines = readme.lines().filter_map(|line| line.strip_prefix("mech> "));
    let lines: Vec<&str> = lines.collect();
    let refused = lines.iter().filter(|line| line.contains("# refused")).count();
    assert!(lines.len() > 6 && refused == 1, "{lines:?}");
    let folder = Folder::new().with("four_bar.mech", FOUR_BAR);
    let answer = mech_said(&folder.path(""), &[""; 0], &(lines.join("\n") + "\n"));
    assert_eq!(answer.err.matches("error:").count(), refused, "{}", answer.err);
    assert!(answer.err.contains("rule of assembly"), "{}", answer.err);
    assert!(folder.text("four_bar.mech").contains("link rod"));
}
