//! Commands as changes of the text.

use mech_studio::{
    ActionKind, Applied, Assembly, Command, Document, JointForm, Kind, Refusal, Rule, Source, apply,
};

/// A four-bar linkage with points of its own, with comments and an order of its own.
const NAMED: &str = "struct Named; // of Grashof
const THROW = 1.0; // of the crank
const ROD = 3.5;
ground { point o = (0, 0); point p = (4, 0); }
link crank { point o = (0, 0); point b = (THROW, 0); }
link coupler {
    point b = (0, 0);
    // Where the rocker is.
    point c = (ROD, 0);
    point tip = (2 * THROW, 1);   // traced
}
link rocker { point p = (0, 0); point c = (3, 0); circle (0, 0) radius 0.2 color teal; }

joint a = revolute(ground.o, crank.o);
joint b = revolute(crank.b, coupler.b);
joint c = revolute(coupler.c, rocker.c);
joint d = revolute(ground.p, rocker.p);
motor a;
start { a = 10 deg; coupler near 50 deg; }
effects { trace coupler.tip 64; }
";

fn document(text: &str) -> Document {
    Document::of(Source::new("a.mech", text))
}

#[track_caller]
fn done_to(text: &str, command: &Command) -> Applied {
    match apply(&document(text), 0, command) {
        Ok(applied) => applied,
        Err(refusal) => panic!("{command:?}: {refusal}"),
    }
}

#[track_caller]
fn refused(text: &str, command: &Command) -> Refusal {
    let applied = apply(&document(text), 0, command);
    applied
        .map(|applied| applied.document.source().text().to_owned())
        .expect_err("a refusal")
}

/// The command replaces exactly this in the text.
#[track_caller]
fn replaces(command: &Command, old: &str, new: &str) -> Applied {
    assert_eq!(NAMED.matches(old).count(), 1, "{old}");
    let applied = done_to(NAMED, command);
    assert_eq!(applied.document.source().text(), NAMED.replace(old, new));
    applied
}

fn shift(path: &str, to: [f64; 2], pose: Option<&[(&str, f64)]>) -> Command {
    let pose = pose.map(|pose| {
        pose.iter()
            .map(|(motor, value)| ((*motor).to_owned(), *value))
            .collect()
    });
    Command::Move {
        path: path.to_owned(),
        to,
        pose,
    }
}

fn revolute(name: &str, ends: [&str; 2]) -> Command {
    Command::Join(Assembly {
        name: name.to_owned(),
        kind: JointForm::Revolute,
        ends: ends.map(ToOwned::to_owned),
        at: None,
        along: None,
    })
}

fn remove(kind: Kind, name: &str) -> Command {
    Command::Remove {
        kind,
        name: name.to_owned(),
    }
}

#[test]
fn a_literal_is_written_over() {
    let applied = replaces(
        &shift("rocker.c", [2.75, 0.0], None),
        "c = (3, 0)",
        "c = (2.75, 0)",
    );
    assert!(applied.notes.is_empty());
    replaces(
        &shift("ground.p", [4.5, -0.25], None),
        "(4, 0)",
        "(4.5, -0.25)",
    );
}

#[test]
fn a_constant_is_solved_for_and_named() {
    let applied = replaces(
        &shift("coupler.c", [3.75, 0.0], None),
        "ROD = 3.5",
        "ROD = 3.75",
    );
    assert_eq!(applied.notes, ["ROD = 3.75"]);
    assert!(applied.reading.result.is_ok());
}

#[test]
fn several_numbers_that_could_be_solved_for_are_named() {
    let refusal = refused(NAMED, &shift("coupler.tip", [2.4, 1.0], None));
    assert_eq!(
        refusal.to_string(),
        "x of `coupler.tip` is `2 * THROW`, in which each of `2`, `THROW` could give 2.4; set one of them"
    );
}

#[test]
fn a_number_that_no_literal_gives_is_locked() {
    let text = NAMED.replace("2 * THROW", "PI");
    let refusal = refused(&text, &shift("coupler.tip", [2.4, 1.0], None));
    assert!(
        refusal
            .to_string()
            .contains("in which no number of this text stands"),
        "{refusal}"
    );
    // `0` can: 2.4 * THROW. `THROW` cannot.
    let text = NAMED.replace("2 * THROW", "0 * THROW");
    let applied = done_to(&text, &shift("coupler.tip", [2.4, 1.0], None));
    assert_eq!(
        applied.document.source().text(),
        text.replace("0 * THROW", "2.4 * THROW")
    );
    assert_eq!(applied.notes, ["2.4 in place of 0 in `0 * THROW`"]);
}

#[test]
fn one_number_in_both_coordinates_gives_only_what_it_can() {
    let text = NAMED.replace("(2 * THROW, 1)", "(ROD, ROD)");
    let applied = done_to(&text, &shift("coupler.tip", [3.25, 3.25], None));
    assert_eq!(
        applied.document.source().text(),
        text.replace("ROD = 3.5", "ROD = 3.25")
    );
    refused(&text, &shift("coupler.tip", [3.25, 3.0], None));
}

#[test]
fn numbers_that_are_not_finite_are_refused() {
    for bad in [f64::NAN, f64::INFINITY] {
        refused(NAMED, &shift("rocker.c", [bad, 0.0], None));
        refused(NAMED, &shift("rocker.c", [0.0, 1.0], Some(&[("a", bad)])));
    }
}

#[test]
fn an_edit_at_a_pose_is_carried_back_to_the_declaration() {
    // The ground does not move.
    replaces(
        &shift("ground.p", [4.25, 0.0], Some(&[("a", 90.0)])),
        "(4, 0)",
        "(4.25, 0)",
    );
    // The crank has turned by a right angle.
    let text = NAMED.replace("(THROW, 0)", "(1.0, 0.0)");
    let applied = done_to(&text, &shift("crank.b", [0.0, 1.25], Some(&[("a", 90.0)])));
    let after = applied.document.source().text();
    let (_, place) = after
        .split_once("link crank { point o = (0, 0); point b = (")
        .expect("the crank");
    let (place, _) = place.split_once(')').expect("a place");
    let numbers: Vec<f64> = place
        .split(", ")
        .map(|part| part.parse().expect("a number"))
        .collect();
    assert!(
        (numbers[0] - 1.25).abs() < 1e-12 && numbers[1].abs() < 1e-12,
        "{place}"
    );
    assert!(after.contains("start { a = 10 deg; coupler near 50 deg; }"));
}

#[test]
fn an_edit_after_which_the_pose_cannot_be_reached_is_refused() {
    let refusal = refused(NAMED, &shift("ground.p", [7.4, 0.0], Some(&[("a", 180.0)])));
    assert!(
        refusal.to_string().contains("cannot come to these values"),
        "{refusal}"
    );
}

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
fn assembly_obeys_its_rules() {
    let joined =
        |text: &str, name: &str, ends: [&str; 2]| refused(text, &revolute(name, ends)).rule();
    assert_eq!(
        joined(NAMED, "e", ["crank.o", "crank.b"]),
        Some(Rule::TwoLinks)
    );
    assert_eq!(
        joined(NAMED, "e", ["rocker.c", "coupler.c"]),
        Some(Rule::Once)
    );
    // A bar that cannot reach from one to the other.
    let text = NAMED
        .replace("joint d = revolute(ground.p, rocker.p);\n", "")
        .replace("(4, 0)", "(40, 0)");
    assert_eq!(
        joined(&text, "d", ["ground.p", "rocker.p"]),
        Some(Rule::Coincidence)
    );
    // A brace leaves no freedom.
    let text = format!(
        "{NAMED}link brace {{ point a = (0, 0); point b = (2, 0); }}\njoint e = revolute(ground.o, brace.a);\n"
    );
    let rule = joined(&text, "f", ["crank.b", "brace.b"]);
    assert!(
        matches!(rule, Some(Rule::Freedom | Rule::HeldOnce)),
        "{rule:?}"
    );
    let refusal = refused(&text, &revolute("f", ["crank.b", "brace.b"]));
    assert!(
        refusal
            .to_string()
            .starts_with("a rule of assembly forbids it: "),
        "{refusal}"
    );
    // What is no rule of assembly is a text that cannot be read.
    let refusal = refused(NAMED, &revolute("e", ["crank.nothing", "rocker.c"]));
    assert_eq!(refusal.rule(), None);
    assert!(
        refusal
            .to_string()
            .starts_with("the text could not be read any more: "),
        "{refusal}"
    );
}

#[test]
fn a_part_jumps_into_coincidence() {
    let text = "struct A;\nground { point o = (1, 2); }\nlink bar { point a = (0, 0); }\nlink tool { point t = (0, 0); }\njoint j = revolute(ground.o, bar.a);\nmotor j;\n";
    let applied = done_to(
        text,
        &Command::Join(Assembly {
            name: "w".to_owned(),
            kind: JointForm::Weld,
            ends: ["bar.a", "tool.t"].map(ToOwned::to_owned),
            at: None,
            along: None,
        }),
    );
    assert_eq!(applied.notes, ["tool stands at (1, 2), turned 0 deg"]);
}

#[test]
fn fragments_cannot_smuggle_statements() {
    for value in [
        "1; link x",
        "1 }",
        "1 // x",
        "1\nlink x",
        "",
        "(1",
        "1 /* x",
        "\"",
        "1 turned 2",
    ] {
        let set = Command::Set {
            owner: "rocker.c".to_owned(),
            role: "x".to_owned(),
            value: value.to_owned(),
        };
        refused(NAMED, &set);
        refused(
            NAMED,
            &Command::Constant {
                name: "NEW".to_owned(),
                value: value.to_owned(),
                is_param: false,
            },
        );
    }
    for name in ["a b", "a;", "", "1", "a.b.c d"] {
        refused(
            NAMED,
            &Command::Link {
                name: name.to_owned(),
            },
        );
    }
}

#[test]
fn numbers_are_set_by_their_roles() {
    let set = |owner: &str, role: &str, value: &str| Command::Set {
        owner: owner.to_owned(),
        role: role.to_owned(),
        value: value.to_owned(),
    };
    replaces(
        &set("rocker", "shape 1 radius", "THROW / 4"),
        "radius 0.2",
        "radius THROW / 4",
    );
    replaces(
        &set("rocker", "shape 1 color", "red dark"),
        "color teal",
        "color red dark",
    );
    replaces(&set("a", "start", "12 deg"), "10 deg", "12 deg");
    replaces(&set("coupler", "near", "45 deg"), "50 deg", "45 deg");
    replaces(&set("coupler.tip", "trace length", "128"), "64", "128");
    replaces(&set("THROW", "value", "1.1"), "THROW = 1.0", "THROW = 1.1");
    let refusal = refused(NAMED, &set("rocker", "shape 1 width", "1"));
    assert_eq!(
        refusal.to_string(),
        "`rocker` has no number `shape 1 width`; it has `shape 1 at`, `shape 1 x`, `shape 1 y`, `shape 1 radius`, `shape 1 color`"
    );
    refused(NAMED, &set("rocker", "shape 1 radius", "-1"));
    refused(NAMED, &set("nobody", "x", "1"));
}

#[test]
fn shapes_are_layered_recoloured_reshaped_and_removed() {
    let link = || "rocker".to_owned();
    let known = "circle (0, 0) radius 0.2 color teal;";
    replaces(
        &Command::Layer {
            link: link(),
            shape: 1,
            plane: "3".to_owned(),
        },
        known,
        "circle (0, 0) radius 0.2 on plane 3 color teal;",
    );
    replaces(
        &Command::Recolor {
            link: link(),
            shape: 1,
            color: "red".to_owned(),
        },
        known,
        "circle (0, 0) radius 0.2 color red;",
    );
    replaces(
        &Command::Reshape {
            link: link(),
            shape: 1,
            outline: "bar [(0, 0), (3, 0)] width 0.2".to_owned(),
        },
        known,
        "bar [(0, 0), (3, 0)] width 0.2 color teal;",
    );
    replaces(
        &Command::RemoveShape {
            link: link(),
            shape: 1,
        },
        &format!(" {known}"),
        "",
    );
    for shape in [0, 2, usize::MAX] {
        refused(
            NAMED,
            &Command::RemoveShape {
                link: link(),
                shape,
            },
        );
    }
    let text = NAMED.replace(known, "circle (0, 0) radius 0.2;");
    let applied = done_to(
        &text,
        &Command::Recolor {
            link: link(),
            shape: 1,
            color: "red".to_owned(),
        },
    );
    assert!(
        applied
            .document
            .source()
            .text()
            .contains("radius 0.2 color red;")
    );
    let applied = done_to(
        &text,
        &Command::Layer {
            link: link(),
            shape: 1,
            plane: "3".to_owned(),
        },
    );
    assert!(
        applied
            .document
            .source()
            .text()
            .contains("radius 0.2 on plane 3;")
    );
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

#[test]
fn motors_masses_and_actions_are_declared_and_changed() {
    let motor = |law: Option<&str>, range: Option<[&str; 2]>, step: Option<&str>| Command::Motor {
        joint: "a".to_owned(),
        law: law.map(ToOwned::to_owned),
        range: range.map(|range| range.map(ToOwned::to_owned)),
        step: step.map(ToOwned::to_owned),
    };
    let ranged = replaces(
        &motor(None, Some(["0 deg", "30 deg"]), None),
        "motor a;",
        "motor a in 0 deg ..= 30 deg;",
    );
    let text = ranged.document.source().text();
    let stepped = done_to(text, &motor(None, None, Some("1 deg")));
    assert!(
        stepped
            .document
            .source()
            .text()
            .contains("motor a in 0 deg ..= 30 deg by 1 deg;")
    );
    refused(NAMED, &motor(None, None, None));
    let mass = |mass: &str| Command::Mass {
        link: "crank".to_owned(),
        mass: mass.to_owned(),
        at: Some(["0.5".to_owned(), "0".to_owned()]),
        inertia: None,
    };
    let heavy = done_to(NAMED, &mass("2"))
        .document
        .source()
        .text()
        .to_owned();
    assert!(
        heavy.contains("point b = (THROW, 0); mass 2 at (0.5, 0); }"),
        "{heavy}"
    );
    let heavier = done_to(&heavy, &mass("3"))
        .document
        .source()
        .text()
        .to_owned();
    assert_eq!(heavier, heavy.replace("mass 2", "mass 3"));
    let spring = Command::Action {
        kind: ActionKind::Spring,
        name: "coil".to_owned(),
        body: "linear(coupler.tip, ground.o) stiffness 100".to_owned(),
    };
    let sprung = done_to(NAMED, &spring).document.source().text().to_owned();
    assert!(
        sprung.contains("spring coil = linear(coupler.tip, ground.o) stiffness 100;"),
        "{sprung}"
    );
    let calm = done_to(&sprung, &remove(Kind::Action, "coil"));
    assert_eq!(calm.document.source().text(), NAMED);
    let gravity = |y: &str| Command::Setting {
        statement: format!("gravity (0, {y})"),
    };
    let falling = done_to(&heavy, &gravity("-9.81"))
        .document
        .source()
        .text()
        .to_owned();
    let moon = done_to(&falling, &gravity("-1.62"))
        .document
        .source()
        .text()
        .to_owned();
    assert_eq!(moon, falling.replace("-9.81", "-1.62"));
    refused(
        NAMED,
        &Command::Setting {
            statement: "link x".to_owned(),
        },
    );
}

#[test]
fn commands_go_through_json_and_back() {
    let commands = [
        shift("a.b", [1.5, -2.0], Some(&[("m", 30.0)])),
        revolute("j", ["a.b", "c.d"]),
        remove(Kind::Axis, "a.b"),
        Command::Repair { number: 3 },
    ];
    for command in commands {
        let json = serde_json::to_string(&command).expect("JSON");
        assert_eq!(
            serde_json::from_str::<Command>(&json).expect("a command"),
            command
        );
    }
}

#[test]
fn only_the_mechanism_that_is_meant_is_changed() {
    let text = crate::run::rust();
    let document = Document::of(Source::new("a.rs", &*text));
    let command = Command::Move {
        path: "a".to_owned(),
        to: [0.125, 0.0],
        pose: None,
    };
    let applied = apply(&document, 1, &command).expect("it moves");
    let (before, after) = text.rsplit_once("at (0, 0)").expect("two of them");
    assert_eq!(
        applied.document.source().text(),
        format!("{before}at (0.125, 0){after}")
    );
    let rename = Command::Rename {
        path: "crank".to_owned(),
        name: "lever".to_owned(),
    };
    let applied = apply(&document, 0, &rename).expect("it has that name");
    let middle = text.rfind("mechanism!").expect("two of them");
    let expected = text[..middle].replace("crank", "lever") + &text[middle..];
    assert_eq!(applied.document.source().text(), expected);
    assert!(applied.notes.iter().any(|note| note.contains("Rust code")));
}

#[test]
fn mistakes_that_were_there_before_do_not_hinder() {
    // An unknown statement, and a joint with nothing.
    let text = NAMED.replace("motor a;", "motor a;\nwobble x;");
    let link = Command::Link {
        name: "spare".to_owned(),
    };
    let applied = done_to(&text, &link);
    let after = applied.document.source().text();
    assert!(
        after.contains("wobble x;") && after.contains("link spare;"),
        "{after}"
    );
    refused(&text, &revolute("e", ["crank.nothing", "rocker.c"]));
}
