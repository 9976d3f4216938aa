//! Noise, and bytes that are no text. What else cannot be read is in `tests/cases/commands/import.txt`.

use super::sample;
use crate::run::{Folder, mech_in};
use std::fs;
use std::time::{Duration, Instant};

/// A document with these elements has this fault at this place, and nothing is answered.
#[track_caller]
fn faulty(text: &str, fault: &str, place: &str) {
    let folder = Folder::new().with("a.linkage2", text);
    let complaint = folder.mech("import a.linkage2").refused(3);
    let place = format!("--> a.linkage2:{place}\n");
    assert!(complaint.contains(fault) && complaint.contains(&place), "{complaint}");
}

#[test]
fn noise_takes_no_time() {
    let start = Instant::now();
    let deep = format!("<linkage2>{}", "<a>".repeat(200_000));
    faulty(&deep, "more than 100000 elements", "1:1");
    let many: String =
        (0..2001).map(|id| format!("<connector id=\"{id}\" x=\"0\" y=\"0\"/>")).collect();
    let many = format!("<linkage2>\n{many}</linkage2>");
    faulty(&many, "more than 2000 connectors and links", "2:66891");
    let wide: String = (0..100_000).map(|number| format!(" a{number}=''")).collect();
    faulty(&format!("<linkage2><b{wide}/></linkage2>"), "more than 200 attributes", "1:11");
    let folder = Folder::new().with("a.linkage2", "<a b=".repeat(20 << 20));
    let complaint = folder.mech("import a.linkage2").refused(3);
    assert!(complaint.contains("more than 16777216 bytes"), "{complaint}");
    assert!(start.elapsed() < Duration::from_secs(20));
}

#[test]
fn names_of_files_cannot_leave_their_comment() {
    let folder = Folder::new();
    let name = "a\nstruct B; .linkage2";
    fs::write(folder.path(name), sample("four_bar")).expect("a file");
    let answer = mech_in(&folder.path("."), &["import", name]);
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    assert!(answer.out.starts_with("/// From a struct B; .linkage2.\n"));
}

#[test]
fn bytes_of_other_formats_are_told_as_what_they_are() {
    // As these programs write them: the first three letters are Latin-1.
    let solvespace = b"\xB1\xB2\xB3SolveSpaceREVa\n\nGroup.h.v=00000001\n";
    for (name, bytes, what) in [
        ("a.slvs", &solvespace[..], "a drawing of SolveSpace"),
        ("a.dxf", b"  0\r\nSECTION\r\n  2\r\nHEADER", "a DXF file"),
        ("a.ggb", b"PK\x03\x04\x14\0\xff", "a ZIP archive"),
        ("a.png", b"\x89PNG\r\n\x1a\n", "a picture (PNG)"),
    ] {
        let folder = Folder::new().with(name, bytes);
        let complaint = folder.mech(&format!("import {name}")).refused(3);
        let known = "reads documents of Linkage (`.linkage2`) and links of PMKS+";
        assert!(complaint.contains(what) && complaint.contains(known), "{complaint}");
        assert!(!complaint.contains("no document of Linkage"), "{complaint}");
    }
}
