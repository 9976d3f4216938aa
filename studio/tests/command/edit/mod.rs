//! Commands as changes of the text.

mod assembly;
mod declarations;
mod drags;
mod names;
mod places;

use mech_studio::{Applied, Assembly, Command, Document, JointForm, Kind, Refusal, Source, apply};

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
