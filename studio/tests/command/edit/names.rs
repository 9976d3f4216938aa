//! Renaming, and what is taken out or copied.

use super::{NAMED, done_to, refused, remove};
use mech_studio::{Command, Kind};

#[test]
fn every_use_of_a_name_is_renamed() {
    let applied = done_to(
        NAMED,
        &Command::Rename {
            path: "rocker".to_owned(),
            name: "lever".to_owned(),
        },
    );
    assert_eq!(
        applied.document.source().text(),
        NAMED
            .replace("link rocker", "link lever")
            .replace("rocker.", "lever.")
    );
    let applied = done_to(
        NAMED,
        &Command::Rename {
            path: "coupler.tip".to_owned(),
            name: "end".to_owned(),
        },
    );
    assert_eq!(
        applied.document.source().text(),
        NAMED.replace("tip", "end")
    );
    assert_eq!(applied.notes, ["2 places"]);
    let applied = done_to(
        NAMED,
        &Command::Rename {
            path: "THROW".to_owned(),
            name: "RADIUS".to_owned(),
        },
    );
    assert_eq!(
        applied.document.source().text(),
        NAMED.replace("THROW", "RADIUS")
    );
    // `a` is a joint, a motor, and starts somewhere.
    let applied = done_to(
        NAMED,
        &Command::Rename {
            path: "a".to_owned(),
            name: "shaft".to_owned(),
        },
    );
    let after = applied.document.source().text();
    for line in ["joint shaft = ", "motor shaft;", "start { shaft = 10 deg;"] {
        assert!(after.contains(line), "{after}");
    }
    for (path, name) in [
        ("rocker", "crank"),
        ("rocker", "1a"),
        ("rocker", "struct"),
        ("nobody", "x"),
    ] {
        refused(
            NAMED,
            &Command::Rename {
                path: path.to_owned(),
                name: name.to_owned(),
            },
        );
    }
}

#[test]
fn names_within_parts_are_renamed_through_their_paths() {
    let text = "struct P;
part Arm(size = 1) {
    port base { point pivot = (0, 0); }
    link bar { point pivot = (0, 0); point tip = (size, 0); }
    joint turn = revolute(base.pivot, bar.pivot);
}
use arm: Arm(size = 2) { base = ground };
use other[2]: Arm { base = ground at (5 + k, 0) };
motor arm.turn;
motor other[0].turn; motor other[1].turn;
show arm.bar;
effects { trace arm.bar.tip 16; }
";
    let rename = |path: &str, name: &str| {
        let command = Command::Rename {
            path: path.to_owned(),
            name: name.to_owned(),
        };
        done_to(text, &command).document.source().text().to_owned()
    };
    assert_eq!(rename("Arm.bar", "rod"), text.replace("bar", "rod"));
    assert_eq!(rename("arm.bar.tip", "end"), text.replace("tip", "end"));
    assert_eq!(
        rename("Arm.turn", "swing"),
        text.replace("turn ", "swing ").replace(".turn", ".swing")
    );
    assert_eq!(rename("Arm.size", "length"), text.replace("size", "length"));
    assert_eq!(rename("Arm.base", "frame"), text.replace("base", "frame"));
    assert_eq!(rename("Arm", "Leg"), text.replace("Arm", "Leg"));
    assert_eq!(rename("other", "others"), text.replace("other", "others"));
}

#[test]
fn what_is_taken_out_takes_with_it_what_cannot_be_without_it() {
    let after = |kind, name| {
        done_to(NAMED, &remove(kind, name))
            .document
            .source()
            .text()
            .to_owned()
    };
    assert_eq!(
        after(Kind::Motor, "a"),
        NAMED.replace("motor a;\n", "").replace(" a = 10 deg;", "")
    );
    assert_eq!(
        after(Kind::Joint, "d"),
        NAMED.replace("joint d = revolute(ground.p, rocker.p);\n", "")
    );
    assert_eq!(
        after(Kind::Start, "coupler"),
        NAMED.replace(" coupler near 50 deg;", "")
    );
    assert_eq!(
        after(Kind::Trace, "coupler.tip"),
        NAMED.replace("effects { trace coupler.tip 64; }\n", "")
    );
    let without = after(Kind::Link, "rocker");
    for gone in ["link rocker", "rocker.", "joint c", "joint d"] {
        assert!(!without.contains(gone), "{without}");
    }
    // What is used stays.
    for (kind, name) in [
        (Kind::Axis, "coupler.tip"),
        (Kind::Constant, "ROD"),
        (Kind::Link, "ground"),
        (Kind::Joint, "z"),
    ] {
        refused(NAMED, &remove(kind, name));
    }
    // A comment goes with what it is about.
    let text = NAMED
        .replace("    point tip", "\n    point tip")
        .replace("joint c = revolute(coupler.c, rocker.c);\n", "");
    let applied = done_to(&text, &remove(Kind::Axis, "coupler.c"));
    let after = applied.document.source().text();
    assert!(!after.contains("Where the rocker is"), "{after}");
}

#[test]
fn a_link_is_mirrored_back_to_its_text() {
    let text = NAMED.replace("link rocker {", "link horn { point a = (1, THROW); line l = (0, -2) -> 30 deg; polygon [(0, 0), (1, ROD / 2), (1, 0)]; }\nlink rocker {");
    let mirror = Command::Mirror {
        name: "horn".to_owned(),
    };
    let once = done_to(&text, &mirror).document.source().text().to_owned();
    let expected = "link horn { point a = (1, -THROW); line l = (0, 2) -> -30 deg; polygon [(0, 0), (1, -(ROD / 2)), (1, 0)]; }";
    assert!(once.contains(expected), "{once}");
    assert_eq!(done_to(&once, &mirror).document.source().text(), text);
}

#[test]
fn a_link_is_duplicated_below_itself() {
    let applied = done_to(
        NAMED,
        &Command::Duplicate {
            name: "crank".to_owned(),
            copy: "spare".to_owned(),
        },
    );
    let line = "link crank { point o = (0, 0); point b = (THROW, 0); }\n";
    let copy = line.replace("crank", "spare");
    assert_eq!(
        applied.document.source().text(),
        NAMED.replace(line, &format!("{line}{copy}"))
    );
}
