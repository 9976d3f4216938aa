//! Shapes, motors, masses, actions, and fragments of statements.

use super::{NAMED, done_to, refused, remove, replaces};
use mech_studio::{ActionKind, Command, Kind};

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
