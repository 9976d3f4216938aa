//! What cannot be read, and where that is said.

use super::encoder::{Encoder, GROUNDED, INPUT, checked};
use super::{moving::reading, sample};
use crate::run::{Answer, Folder, mech_in};
use std::fs;
use std::io::Write;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// A document with these elements has this fault at this place, and nothing is answered.
#[track_caller]
fn faulty(text: &str, fault: &str, place: &str) {
    let folder = Folder::new().with("a.linkage2", text);
    let complaint = folder.mech("import a.linkage2").refused(3);
    let place = format!("--> a.linkage2:{place}\n");
    assert!(
        complaint.contains(fault) && complaint.contains(&place),
        "{complaint}"
    );
}

/// A crank, with something more.
fn crank(more: &str) -> String {
    format!(
        "<linkage2>
<connector id=\"0\" x=\"0\" y=\"0\" anchor=\"true\" input=\"true\"/>
<connector id=\"1\" x=\"9\" y=\"0\"/>
<Link id=\"0\"><connector id=\"0\"/><connector id=\"1\"/></Link>
{more}
</linkage2>"
    )
}

#[test]
fn texts_that_are_no_documents() {
    faulty("no document", "no document of Linkage", "1:1");
    faulty("<linkage2>\n<connector", "no document of Linkage", "2:10");
    faulty("", "no document of Linkage", "1:1");
    faulty("<linkage/>", "the root is <linkage>", "1:1");
    faulty("<linkage2/>", "has no link", "1:1");
    faulty(
        "<!DOCTYPE a [<!ENTITY b \"c\">]>\n<linkage2>&b;</linkage2>",
        "a document type has no place in it",
        "1:1",
    );
}

#[test]
fn elements_that_are_wrong() {
    for (element, fault, column) in [
        ("<connector x=\"0\" y=\"0\"/>", "has no `id`", 1),
        ("<connector id=\"7\" y=\"0\"/>", "has no `x`", 1),
        (
            "<connector id=\"-7\" x=\"0\" y=\"0\"/>",
            "`-7`, which is no whole",
            16,
        ),
        (
            "<connector id=\"1\" x=\"0\" y=\"0\"/>",
            "an earlier <connector> with the id 1",
            16,
        ),
        ("<Link id=\"0\"/>", "an earlier <Link> with the id 0", 11),
        (
            "<connector id=\"7\" x=\"1mm\" y=\"0\"/>",
            "`1mm`, which is no number",
            22,
        ),
        (
            "<connector id=\"7\" x=\"0\" y=\"nan\"/>",
            "`nan`, which is no finite number",
            28,
        ),
        (
            "<connector id=\"7\" x=\"1e999\" y=\"0\"/>",
            "which is no finite number",
            22,
        ),
        (
            "<connector id=\"7\" x=\"-1e16\" y=\"0\"/>",
            "`-1e16`, which is too large",
            22,
        ),
        (
            "<connector id=\"7\" x=\"0\" y=\"0\" anchor=\"yes\"/>",
            "`yes`, which is neither",
            39,
        ),
        (
            "<Link id=\"3\"><connector id=\"44\"/></Link>",
            "there is no connector 44",
            29,
        ),
        (
            "<Link id=\"3\"><connector/></Link>",
            "this <connector> has no `id`",
            14,
        ),
        (
            "<Link id=\"3\" fastenlink=\"9\"/>",
            "there is no link 9",
            26,
        ),
        (
            "<Link id=\"3\" actuator=\"true\"><connector id=\"0\"/></Link>",
            "this one has 1",
            1,
        ),
        (
            "<connector id=\"7\" x=\"0\" y=\"0\" slider=\"true\"><slidelimit id=\"0\"/></connector>",
            "1 <slidelimit> are given",
            1,
        ),
        (
            "<ratios><ratio type=\"gears\"><link id=\"0\" size=\"0\"/></ratio></ratios>",
            "above zero",
            48,
        ),
        (
            "<ratios><ratio type=\"gears\"><link id=\"0\" size=\"2\"/></ratio></ratios>",
            "of two links",
            9,
        ),
        (
            "<ratios><ratio type=\"rope\"/></ratios>",
            "`gears` or `chain`",
            22,
        ),
        (
            "<program units=\"Furlongs\"/>",
            "`Furlongs`, which is not known; known are `Millimeters`",
            17,
        ),
    ] {
        faulty(&crank(element), fault, &format!("5:{column}"));
    }
}

#[test]
fn noise_takes_no_time() {
    let start = Instant::now();
    let deep = format!("<linkage2>{}", "<a>".repeat(200_000));
    faulty(&deep, "more than 100000 elements", "1:1");
    let many: String = (0..2001)
        .map(|id| format!("<connector id=\"{id}\" x=\"0\" y=\"0\"/>"))
        .collect();
    let many = format!("<linkage2>\n{many}</linkage2>");
    faulty(&many, "more than 2000 connectors and links", "2:66891");
    let wide: String = (0..100_000)
        .map(|number| format!(" a{number}=''"))
        .collect();
    faulty(
        &format!("<linkage2><b{wide}/></linkage2>"),
        "more than 200 attributes",
        "1:11",
    );
    let folder = Folder::new().with("a.linkage2", "<a b=".repeat(20 << 20));
    let complaint = folder.mech("import a.linkage2").refused(3);
    assert!(complaint.contains("longer than 16 MiB"), "{complaint}");
    assert!(start.elapsed() < Duration::from_secs(20));
}

fn import(word: &str) -> Answer {
    let folder = Folder::new();
    mech_in(&folder.path("."), &["import", word])
}

/// A link has this fault at this column, and nothing is answered.
#[track_caller]
fn faulty_link(link: &str, fault: &str, column: usize) {
    let complaint = import(link).refused(2);
    let place = format!("--> link:1:{column}\n");
    assert!(
        complaint.contains(fault) && complaint.contains(&place),
        "{complaint}"
    );
}

fn bar() -> Encoder {
    Encoder::default()
        .joint(INPUT | GROUNDED, "A", [0.0, 0.0], 0.0)
        .joint(0, "B", [1.0, 0.0], 0.0)
        .link("AB", &["A", "B"])
}

#[test]
fn links_that_are_wrong() {
    let right = bar().query();
    let last = right.chars().count();
    let wrong = |from: &str, to: &str| {
        assert_eq!(right.matches(from).count(), 1, "{from} in {right}");
        let body = &right[..last - 1];
        checked(&body.replacen(from, to, 1))
    };
    // A link of which a part is missing, and one whose check was changed.
    faulty_link(
        &format!("?{}", right.replacen("A,B,,", "A,,", 1)),
        "checks the length of the link",
        last - 1,
    );
    faulty_link(&right.replacen("B,Fe", "B,F!", 1), "is no digit", 31);
    faulty_link(&wrong("B,Fe,0", "B,,0"), "a number is missing", 31);
    faulty_link(&wrong("B,Fe,0", "B,123456789,0"), "too large", 31);
    faulty_link(&wrong("6A,A,0,0,0", "6A,A,0,0"), "5 fields", 15);
    faulty_link(
        &wrong("0B,B,", "0A,B,"),
        "an earlier joint with the id `A`",
        27,
    );
    faulty_link(&wrong("A,B,,", "A,C,,"), "there is no joint `C`", 64);
    faulty_link(&wrong("A,B,,", "A,B"), "end with two commas", 39);
    faulty_link(&wrong("YRAB", "XRAB"), "begins with `Y` or `N`", 39);
    let settings = format!("?{}", wrong("0P.", "0!."));
    faulty_link(&settings, "this is no link of PMKS+", 2);
    faulty_link(&wrong("A,B,,...N_", "A,B,,"), "ends before", 1);
    let empty = checked("0P.SS.K,0.101....N_");
    faulty_link(&empty, "no link of a mechanism in it", 1);
    faulty_link(
        "https://example.org/?page=3",
        "this is no link of PMKS+",
        22,
    );
    faulty_link("?j=a%2", "`%` has to be followed", 5);
    faulty_link("?j=%ff", "is not UTF-8", 4);
    faulty_link("?j=a,0,0", "`&l=` is missing", 2);
    faulty_link(
        "?j=a,0,0,ab,R,x,Null,t&l=",
        "`x` is neither `t` nor `f`",
        15,
    );
    faulty_link(
        "?j=a,0,inf,ab,R,t,Null,t&l=",
        "`inf` is no finite number",
        8,
    );
    faulty_link("?j=a,0,1e16,ab,R,t,Null,t&l=", "`1e16` is too large", 8);
    faulty_link("?j=a,0,0,ab,R,t,Null,t&l=ab,R", "this one has 2", 26);
}

#[test]
fn a_mechanism_that_does_not_move_is_written_all_the_same() {
    let loose = sample("four_bar").replace("input=\"true\"", "");
    let folder = Folder::new().with("loose.linkage2", &loose);
    let answer = folder.mech("import loose.linkage2");
    assert_eq!(answer.code, Some(1));
    assert!(answer.out.contains("struct Loose;"), "{}", answer.out);
    assert!(
        answer.err.contains("there is no motor") && answer.err.contains("--> Loose.mech:3:8"),
        "{}",
        answer.err
    );
    let answer = folder.mech("import loose.linkage2 -o loose.mech");
    assert_eq!(
        (answer.code, &*answer.out),
        (Some(1), "saved `loose.mech`\n")
    );
    assert_eq!(folder.mech("fix loose.mech --pick 1").code, Some(0));
    folder.mech("check loose.mech").done();
}

#[test]
fn files_are_made_and_none_is_overwritten() {
    let folder = Folder::new().with("four bar.linkage2", sample("four_bar"));
    let import = |words: &[&str]| mech_in(&folder.path("."), &[&["import"], words].concat());
    let answer = import(&["four bar.linkage2", "-o", "a.mech"]);
    assert_eq!(
        (answer.code, &*answer.out),
        (
            Some(0),
            "saved `a.mech`\nFourBar moves: 3 moving links, 4 joints, 1 motor, 1 loop\n"
        )
    );
    let answer = import(&["four bar.linkage2", "-o", "b.rs", "--mechanism", "Rocker"]);
    assert_eq!(answer.code, Some(0));
    let text = folder.text("b.rs");
    assert!(
        text.starts_with(
            "use mech_runtime::mechanism;\n\nmechanism! {\n    /// From four bar.linkage2.\n"
        ) && text.contains("    pub struct Rocker;\n")
            && text.ends_with("\n}\n"),
        "{text}"
    );
    folder.mech("check b.rs").done();
    for (words, code, fault) in [
        (
            &["four bar.linkage2", "-o", "a.mech"][..],
            3,
            "`a.mech` is there already",
        ),
        (
            &["four bar.linkage2", "-o", "c.txt"],
            2,
            "neither in `.mech` nor in `.rs`",
        ),
        (&["four bar.linkage2", "-m", "a b"], 2, "cannot be the name"),
        (&["missing.linkage2"], 3, "cannot read `missing.linkage2`"),
        (
            &["a.mech"],
            3,
            "error: `a.mech` is no document of Linkage, which ends in `.linkage2`",
        ),
    ] {
        let complaint = import(words).refused(code);
        assert!(complaint.contains(fault), "{complaint}");
    }
    assert_eq!(folder.names(), ["a.mech", "b.rs", "four bar.linkage2"]);
}

#[test]
fn the_standard_input_is_read() {
    for (text, name) in [
        (sample("four_bar"), "the standard input"),
        (bar().url(), "the standard input"),
    ] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_mech"));
        command.args(["import", "-", "-m", "Piped"]);
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.stderr(Stdio::null()).spawn().expect("it runs");
        let mut input = child.stdin.take().expect("its input");
        input.write_all(text.as_bytes()).expect("it reads");
        drop(input);
        let output = child.wait_with_output().expect("it ends");
        assert_eq!(output.status.code(), Some(0));
        let text = String::from_utf8(output.stdout).expect("UTF-8");
        assert!(text.starts_with(&format!("/// From {name}.\n")), "{text}");
        assert_eq!(reading(&text).model.name, "Piped");
    }
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
