//! Bad input: a clear error, an exit code, and nothing overwritten.

use crate::run::{FOUR_BAR, Folder, begin, mech_said};
use mech_studio::Source;
use std::fs;
use std::process::{Command, Stdio};

#[test]
fn a_file_that_is_not_utf_8() {
    let folder = Folder::new().with("a.rs", b"mechanism! { \xff }");
    let refusal = folder.mech("check a.rs").refused(3);
    assert_eq!(refusal, "error: cannot read `a.rs`: byte 13 is not UTF-8\n");
}

#[test]
fn noise_is_not_read_to_its_end() {
    let folder = Folder::new();
    let noise = "mechanism! { {([\"".repeat(100 << 16);
    assert!(noise.len() > 100_000_000);
    let folder = folder.with("a.rs", noise);
    let refusal = folder.mech("check a.rs").refused(3);
    assert!(refusal.contains("more than 1048576 bytes"), "{refusal}");
    // A text that is just short enough is read, and refused in words.
    let folder = folder.with("b.rs", "mechanism! { {([".repeat(1 << 16));
    let refusal = folder.mech("check b.rs").refused(1);
    assert!(refusal.contains("this mechanism has no end"), "{refusal:.300}");
}

#[test]
fn a_full_disk() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let full = fs::OpenOptions::new().write(true).open("/dev/full");
    let Ok(full) = full else {
        return; // Not on this system.
    };
    let mut command = Command::new(env!("CARGO_BIN_EXE_mech"));
    command.args(["report", "a.mech"]).current_dir(folder.path("."));
    let output = command.stdout(full).stderr(Stdio::piped()).output().expect("it runs");
    assert_eq!(output.status.code(), Some(3));
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(said.starts_with("error: cannot write the answer: "), "{said}");
    for command in ["draw a.mech -o /dev/full", "table a.mech -o /dev/full"] {
        // The ending of the first says nothing, so it is not even tried.
        let answer = folder.mech(command);
        assert!(matches!(answer.code, Some(2 | 3)), "{answer:?}");
    }
    let link = folder.path("full.svg");
    std::os::unix::fs::symlink("/dev/full", link).expect("a link");
    for command in ["draw", "film", "plot"] {
        let refusal = folder.mech(&format!("{command} a.mech -o full.svg")).refused(3);
        assert!(refusal.starts_with("error: cannot write `full.svg`: "), "{refusal}");
    }
}

#[test]
fn a_line_without_an_end_is_not_read_to_its_end() {
    let folder = Folder::new();
    let line = "x".repeat((1 << 20) + 3);
    let answer = mech_said(&folder.path(""), &[""; 0], &line);
    let refusal = answer.refused(3);
    assert!(refusal.contains("more than 1048576 bytes"), "{refusal}");
    // One that is just short enough is read.
    let answer = mech_said(&folder.path(""), &[""; 0], &line[3..]);
    let refusal = answer.refused(2);
    assert!(refusal.contains("unknown command"), "{refusal:.80}");
}

#[test]
fn what_has_no_end_is_read_as_far_as_a_text_may_go() {
    let folder = Folder::new().with("script.txt", "open /dev/zero");
    let device = std::path::Path::new("/dev/zero");
    if !device.exists() {
        return; // Not on this system.
    }
    for (command, most) in
        [("check /dev/zero", 1 << 20), ("run /dev/zero", 1 << 20), ("import /dev/zero", 16 << 20)]
    {
        let refusal = folder.mech(command).refused(3);
        let limit = format!("more than {most} bytes");
        assert!(refusal.contains(&limit), "{refusal}");
    }
    let refusal = folder.mech("run script.txt").refused(3);
    assert!(refusal.contains("it is no plain file"), "{refusal}");
}

#[test]
fn a_file_that_somebody_else_removes() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let source = Source::read(&folder.path("a.mech")).expect("a text");
    fs::remove_file(folder.path("a.mech")).expect("it is there");
    // Tests of changes by somebody else are in `dialogue.rs`.
    source.replace("ours").expect_err("it is gone");
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn somebody_who_reads_no_further() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let words = ["table", "a.mech", "--steps", "100000"];
    let mut child = begin(&folder.path(""), &words);
    drop(child.stdout.take());
    assert_eq!(child.wait().expect("it ends").code(), Some(0));
}
