//! What is copied with links, and where it lands.

use super::user::User;
use eframe::egui::Key;
use mech_studio::editor::Item;

const FOUR_BAR: [&str; 3] = ["crank", "coupler", "rocker"];

/// A four-bar as in a drawing, with all that may lie between its links.
const DRAWN: &str = "struct Press;
const HIGH = 1;
ground { point hook = (-2, 3); point far = (3, HIGH); line floor = (0, -1) -> (1, 0); }
link crank { point knob = (-1.5, 0.5); }
link coupler { point eye = (0, 3); }
link rocker { point ear = (2, 1); }
link block { point nose = (0, 0); line axis = (0, 0) -> (1, 0); }
joint a = revolute(ground, crank) at (-2, 0);
joint b = revolute(crank, coupler) at (-2, 1);
joint c = revolute(coupler, rocker) at (1, 3);
joint d = revolute(rocker, ground) at (2, 0);
joint e = prismatic(ground.floor, block.axis);
motor a;
motor e;
spring pull = linear(coupler.eye, ground.hook) stiffness 40 rest 0.5;
spring coil = torsional(c) stiffness HIGH + 1;
spring other = linear(block.nose, crank.knob) stiffness 3;
damper drag = linear(crank.knob, rocker.ear) damping 0.1;
damper rub = linear(rocker.ear, ground.far) damping 0.2;
load push = force(coupler.eye);
load twist = torque(rocker);
load weight = force(block.nose);
effects { velocity; force; }
";

fn select(user: &mut User, links: &[&str]) {
    for (number, link) in links.iter().enumerate() {
        let item = Item::Link((*link).to_owned());
        user.at_once(|editor| editor.select(Some(item), number > 0));
    }
}

/// How far something is from there: to the right, and below. It is not far, but seen.
#[track_caller]
fn step(user: &User, copy: &str, [x, y]: [f64; 2]) -> f64 {
    let found = user.scene_place_of(copy).unwrap_or([f64::NAN; 2]);
    let step = found[0] - x;
    assert!(
        (found[1] - y + step).abs() < 1e-9,
        "{copy} is at {found:?}: {}",
        user.said()
    );
    let pixels = user.pixel(found).x - user.pixel([x, y]).x;
    assert!(pixels > 8.0 && pixels < 200.0, "{copy} is {pixels} away");
    step
}

/// Copies are right of where these were, and below, all by one step.
#[track_caller]
fn are_beside(user: &User, copies: &[(&str, [f64; 2])]) {
    let steps: Vec<f64> = copies
        .iter()
        .map(|(copy, place)| step(user, copy, *place))
        .collect();
    let is_one = steps.iter().all(|one| (one - steps[0]).abs() < 1e-9);
    assert!(is_one, "{steps:?}: {}", user.said());
}

#[test]
fn what_acts_between_links_is_copied_with_them() {
    let mut user = User::with_text(DRAWN);
    assert!(user.editor().player().is_some(), "{}", user.said());
    select(&mut user, &FOUR_BAR);
    user.copy_and_paste();
    let text = user.text().to_owned();
    for copy in [
        "spring pull1 = linear(coupler1.eye, ground.hook1) stiffness 40 rest 0.5;",
        "= torsional(h) stiffness HIGH + 1;",
        "= linear(crank1.knob, rocker1.ear) damping 0.1;",
        "= linear(rocker1.ear, ground.far1) damping 0.2;",
        "load push1 = force(coupler1.eye);",
        "load twist1 = torque(rocker1);",
    ] {
        assert!(text.contains(copy), "{copy}: {}", user.said());
    }
    // What concerns others is not.
    for (word, count) in [
        ("spring ", 5),
        ("damper ", 4),
        ("load ", 5),
        ("line ", 2),
        ("motor ", 3),
        ("effects", 1),
    ] {
        assert_eq!(text.matches(word).count(), count, "{word}: {}", user.said());
    }
    assert!(user.editor().player().is_some(), "{}", user.said());
    // Its ends lie where they were declared, beside the others.
    are_beside(
        &user,
        &[
            ("point coupler1.eye", [0.0, 3.0]),
            ("point ground.hook1", [-2.0, 3.0]),
            ("point crank1.knob", [-1.5, 0.5]),
            ("point rocker1.ear", [2.0, 1.0]),
            ("point ground.far1", [3.0, 1.0]),
        ],
    );
    // It is one step.
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), DRAWN);
}

#[test]
fn what_acts_is_pasted_into_another_text() {
    let mut user = User::with_text(DRAWN);
    select(&mut user, &FOUR_BAR);
    let copied = user.copy();
    for effects in ["", "effects { velocity; }\n", "effects { force; }\n"] {
        let other = format!(
            "struct Other;\nlink crank {{ mass 1 at (9, 9); }}\njoint a = revolute(ground, crank) at (8, 8);\nmotor a;\n{effects}"
        );
        let mut user = User::with_text(&other);
        user.paste(&copied);
        assert!(user.text().contains("ground.hook)"), "{}", user.said());
        assert_eq!(
            user.text().matches(" force; ").count(),
            1,
            "{}",
            user.said()
        );
        assert!(user.editor().player().is_some(), "{}", user.said());
        step(&user, "point ground.hook", [-2.0, 3.0]);
        user.shortcut(Key::Z, false);
        assert_eq!(user.text(), other);
    }
    // A link alone has the loads on it.
    let mut user = User::with_text(DRAWN);
    select(&mut user, &["rocker"]);
    user.copy_and_paste();
    assert!(user.text().contains("torque(rocker1)"), "{}", user.said());
    for (word, count) in [("spring ", 3), ("damper ", 2), ("load ", 4)] {
        assert_eq!(user.text().matches(word).count(), count, "{}", user.said());
    }
}

#[test]
fn links_in_frames_of_their_own_are_copied_with_their_ground() {
    // A parallelogram: the crank stands upright at the start, and so the rocker.
    let text = "struct FourBar;
ground { point o = (1, 2); point q = (4, 2); point unused = (7, 7); }
link crank { point o = (0, 0); point p = (1, 0); }
link coupler { point p = (0, 0); point r = (3, 0); point tip = (1.5, 1); }
link rocker { point q = (0, 0); point r = (1, 0); }
joint a = revolute(ground.o, crank.o);
joint b = revolute(crank.p, coupler.p);
joint c = revolute(coupler.r, rocker.r);
joint d = revolute(ground.q, rocker.q);
motor a;
start { a = 90 deg; coupler near 0 deg; }
";
    let mut user = User::with_text(text);
    assert!(user.editor().player().is_some(), "{}", user.said());
    user.shortcut(Key::A, false);
    user.copy_and_paste();
    assert!(user.editor().player().is_some(), "{}", user.said());
    let motors = user.editor().player().map(|player| player.motors().len());
    assert_eq!(motors, Some(2), "{}", user.said());
    assert_eq!(user.text().matches("unused").count(), 1, "{}", user.said());
    // The fixed pins, the pin above the first, and a point of the coupler: 1.5 to the right and 1 above.
    are_beside(
        &user,
        &[
            ("joint e", [1.0, 2.0]),
            ("joint h", [4.0, 2.0]),
            ("joint f", [1.0, 3.0]),
            ("point coupler1.tip", [2.5, 4.0]),
        ],
    );
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), text);
    // One alone hangs on nothing.
    select(&mut user, &["coupler"]);
    user.copy_and_paste();
    assert!(user.text().contains("coupler1 near"), "{}", user.said());
    step(&user, "point coupler1.tip", [1.5, 1.0]);
}

#[test]
fn each_paste_lands_beside_the_last() {
    let mut user = User::with_text(DRAWN);
    select(&mut user, &FOUR_BAR);
    let copied = user.copy();
    let paste = |user: &mut User, times: u32| {
        user.paste(&copied);
        let hook = format!("point ground.hook{times}");
        let eye = format!("point coupler{times}.eye");
        are_beside(user, &[(&eye, [0.0, 3.0]), (&hook, [-2.0, 3.0])]);
        step(user, &eye, [0.0, 3.0])
    };
    let ways = [1, 2, 3].map(|times| paste(&mut user, times));
    assert!(ways[0] < ways[1] && ways[1] < ways[2], "{ways:?}");
    assert!(user.editor().player().is_some(), "{}", user.said());
    // The place of one that is undone is free.
    user.shortcut(Key::Z, false);
    let again = paste(&mut user, 3);
    assert!((again - ways[2]).abs() < 1e-9, "{ways:?} {again}");
    // A copy of a copy stands beside it; a link alone, too.
    let bar = "struct Bars;\nlink bar { point end1 = (1, 1); point end2 = (2, 1); }\n";
    let mut user = User::with_text(bar);
    select(&mut user, &["bar"]);
    let mut last = 0.0;
    for times in 1..=3 {
        user.copy_and_paste();
        let next = step(&user, &format!("point bar{times}.end2"), [2.0, 1.0]);
        assert!(next > last, "{next}: {}", user.said());
        last = next;
    }
}
