//! Commands as changes of the text. Most are lines of the dialogue, in `tests/cases/edits`.

mod drags;
mod texts;

use mech_studio::{Applied, Assembly, Command, Document, JointForm, Refusal, Source, apply};

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
    applied.map(|applied| applied.document.source().text().to_owned()).expect_err("a refusal")
}

fn shift(path: &str, to: [f64; 2], pose: Option<&[(&str, f64)]>) -> Command {
    let pose =
        pose.map(|pose| pose.iter().map(|(motor, value)| ((*motor).to_owned(), *value)).collect());
    Command::Move { path: path.to_owned(), to, pose }
}

#[test]
fn only_the_mechanism_that_is_meant_is_changed() {
    let text = crate::run::rust();
    let document = Document::of(Source::new("a.rs", &*text));
    let command = Command::Move { path: "a".to_owned(), to: [0.125, 0.0], pose: None };
    let applied = apply(&document, 1, &command).expect("it moves");
    let (before, after) = text.rsplit_once("at (0, 0)").expect("two of them");
    assert_eq!(applied.document.source().text(), format!("{before}at (0.125, 0){after}"));
    let rename = Command::Rename { path: "crank".to_owned(), name: "lever".to_owned() };
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
    let link = Command::Link { name: "spare".to_owned() };
    let applied = done_to(&text, &link);
    let after = applied.document.source().text();
    assert!(after.contains("wobble x;") && after.contains("link spare;"), "{after}");
    let joint = Command::Join(Assembly {
        name: "e".to_owned(),
        kind: JointForm::Revolute,
        ends: ["crank.nothing", "rocker.c"].map(ToOwned::to_owned),
        at: None,
        along: None,
    });
    refused(&text, &joint);
}

#[test]
fn fragments_cannot_smuggle_statements() {
    for value in ["1; link x", "1 }", "1 // x", "1\nlink x", "", "(1", "1 /* x", "\"", "1 turned 2"]
    {
        let set = Command::Set {
            owner: "rocker.c".to_owned(),
            role: "x".to_owned(),
            value: value.to_owned(),
        };
        refused(NAMED, &set);
        let constant =
            Command::Constant { name: "NEW".to_owned(), value: value.to_owned(), is_param: false };
        refused(NAMED, &constant);
    }
    for name in ["a b", "a;", "", "1", "a.b.c d"] {
        let name = name.to_owned();
        refused(NAMED, &Command::Link { name });
    }
    let rename = Command::Rename { path: "rocker".to_owned(), name: "1a".to_owned() };
    refused(NAMED, &rename);
    let setting = Command::Setting { statement: "link x".to_owned() };
    refused(NAMED, &setting);
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
    // The crank has turned by a right angle.
    let text = NAMED.replace("(THROW, 0)", "(1.0, 0.0)");
    let applied = done_to(&text, &shift("crank.b", [0.0, 1.25], Some(&[("a", 90.0)])));
    let after = applied.document.source().text();
    let (_, place) =
        after.split_once("link crank { point o = (0, 0); point b = (").expect("the crank");
    let (place, _) = place.split_once(')').expect("a place");
    let numbers: Vec<f64> = place.split(", ").map(|part| part.parse().expect("a number")).collect();
    assert!((numbers[0] - 1.25).abs() < 1e-12 && numbers[1].abs() < 1e-12, "{place}");
    assert!(after.contains("start { a = 10 deg; coupler near 50 deg; }"));
}
