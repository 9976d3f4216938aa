//! Points that are dragged: only their numbers change.

use super::user::User;
use eframe::egui::Key;
use mech_studio::editor::{Handle, Item};

const JANSEN: &str = include_str!("../../../examples/gallery/src/mechanisms/jansen.rs");

/// The lines that differ between two texts.
fn changed<'t>(before: &'t str, after: &'t str) -> Vec<[&'t str; 2]> {
    let pairs = before.lines().zip(after.lines());
    let changed = pairs
        .filter(|(a, b)| a != b)
        .map(|(a, b)| [a.trim(), b.trim()]);
    assert_eq!(before.lines().count(), after.lines().count());
    changed.collect()
}

#[test]
fn a_pin_of_jansens_leg_is_dragged_and_only_its_numbers_change() {
    let mut user = User::with_file("jansen.rs", JANSEN);
    let before = user.text().to_owned();
    user.drag_with_alt([-77.75, -2.54], [-75.0, -3.0]);
    let said = user.said();
    assert_eq!(
        changed(&before, user.text()),
        [[
            "joint h = revolute(upper_plate, tie) at (-77.75, -2.54);",
            "joint h = revolute(upper_plate, tie) at (-75.0, -3.0);"
        ]],
        "{said}"
    );
    assert!(user.editor().player().is_some());
    user.click_on("Undo");
    assert_eq!(user.text(), before);
    user.click_on("Redo");
    assert_ne!(user.text(), before);
}

#[test]
fn joints_on_the_same_pin_go_together() {
    let mut user = User::with_file("jansen.rs", JANSEN);
    let before = user.text().to_owned();
    user.move_handle([9.61, 11.52], [15.0, 10.0]);
    assert_eq!(
        changed(&before, user.text()),
        [
            [
                "joint b = revolute(crank, upper_rod) at (9.61, 11.52);",
                "joint b = revolute(crank, upper_rod) at (15.0, 10.0);"
            ],
            [
                "joint e = revolute(crank, lower_rod) at (9.61, 11.52);",
                "joint e = revolute(crank, lower_rod) at (15.0, 10.0);"
            ],
        ],
        "{}",
        user.said()
    );
}

#[test]
fn what_is_seen_after_a_drag_is_what_the_compiled_mechanism_gives() {
    let mut user = User::with_file("jansen.rs", JANSEN);
    user.move_handle([-77.75, -2.54], [-76.0, -4.0]);
    let drawing = user.editor().drawing().expect("it is drawn");
    let handles: Vec<Handle<'_>> = drawing.handles().collect();
    let again = User::with_file("jansen.rs", user.text());
    let expected = again.editor().drawing().expect("it is drawn").handles();
    assert_eq!(handles, expected.collect::<Vec<_>>());
    assert!(
        handles
            .iter()
            .any(|handle| *handle.item == Item::Joint("h".to_owned()))
    );
}

#[test]
fn a_drag_that_breaks_it_is_told_and_mended_by_undo() {
    let mut user = User::with_file("jansen.rs", JANSEN);
    let before = user.text().to_owned();
    // The foot of the rocker, so far away that the leg cannot close all round; it moves as far as it can.
    user.move_handle([-20.1, -42.79], [-20.0, -60.0]);
    assert_ne!(user.text(), before, "{}", user.said());
    user.click_on("Undo");
    assert_eq!(user.text(), before);
    assert!(user.editor().player().is_some());
}

#[test]
fn what_is_selected_together_is_dragged_together() {
    let text = "struct FourBar;
link crank; link coupler; link rocker;
joint a = revolute(ground, crank) at (-2, 0);
joint b = revolute(crank, coupler) at (-2, 1);
joint c = revolute(coupler, rocker) at (1, 3);
joint d = revolute(rocker, ground) at (2, 0);
motor a;
";
    let mut user = User::with_text(text);
    user.click([-2.0, 1.0]);
    user.click_with_shift([1.0, 3.0]);
    user.drag([1.0, 3.0], [1.4, 3.4]);
    let expected = text
        .replace("at (-2, 1)", "at (-1.6, 1.4)")
        .replace("at (1, 3)", "at (1.4, 3.4)");
    assert_eq!(user.text(), expected, "{}", user.said());
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), text);
    // All of it.
    user.shortcut(Key::A, false);
    user.click_with_shift([-2.0, 0.0]);
    user.drag([-2.0, 0.0], [-1.0, 0.4]);
    let expected = "at (-1, 0.4)|at (-1, 1.4)|at (2, 3.4)|at (3, 0.4)";
    for place in expected.split('|') {
        assert!(user.text().contains(place), "{}", user.said());
    }
}

#[test]
fn points_of_links_that_stand_elsewhere_go_by_the_same_way() {
    let text = "struct Pair;
link one { point o = (0, 0); point e = (2, 0); }
link two { point o = (0, 0); point e = (1, 0); }
ground { point o = (0, 0); }
joint a = revolute(ground.o, one.o);
joint b = revolute(one.e, two.o);
motor a;
motor b;
start { a = 90 deg; b = 90 deg; }
";
    let mut user = User::with_text(text);
    let before = user
        .scene_place_of("point two.e")
        .unwrap_or_else(|| panic!("{}", user.said()));
    user.click([0.0, 2.0]);
    user.click_with_shift(before);
    user.drag([0.0, 2.0], [0.0, 2.4]);
    let after = user.scene_place_of("point two.e").expect("it is seen");
    // The second link goes with the end of the first, and its own end by as much again.
    assert!(
        (after[1] - before[1] - 0.8).abs() < 1e-6,
        "{before:?} {after:?} {}",
        user.said()
    );
    assert!(
        (after[0] - before[0]).abs() < 1e-6,
        "{before:?} {after:?} {}",
        user.said()
    );
}

const CRANK: &str =
    "struct Crank;\nlink crank;\njoint a = revolute(ground, crank) at (0, 0);\nmotor a;\n";

/// A crank, and two bars that were drawn after it.
fn crank_and_bars() -> User {
    let mut user = User::with_text(CRANK);
    user.key(Key::B);
    user.drag([2.0, 1.0], [3.0, 2.0]);
    user.drag([3.0, 2.0], [5.0, 1.0]);
    user.key(Key::V);
    user
}

#[test]
fn a_drag_ends_where_its_text_does() {
    let mut user = crank_and_bars();
    let before = user.text().to_owned();
    user.hold([5.0, 1.0], [6.0, 3.0]);
    user.shortcut(Key::Z, false);
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), CRANK, "{}", user.said());
    user.let_go([6.0, 3.0]);
    assert_eq!(user.text(), CRANK);
    user.shortcut(Key::Z, true);
    user.shortcut(Key::Z, true);
    assert_eq!(user.text(), before);
}

#[test]
fn what_was_picked_is_forgotten_when_it_is_gone() {
    let mut user = crank_and_bars();
    user.key(Key::P);
    user.click([3.0, 2.0]);
    user.shortcut(Key::Z, false);
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), CRANK);
    user.click([0.0, 0.0]);
    assert_eq!(
        user.text(),
        CRANK,
        "it is the first place again: {}",
        user.said()
    );
}

#[test]
fn a_tool_is_not_used_by_letting_a_link_go() {
    let mut user = User::with_text(
        "struct Crank;\nlink crank { point tip = (2, 0); }\njoint a = revolute(ground, crank) at (0, 0);\nmotor a;\n",
    );
    let before = user.text().to_owned();
    user.hold([1.0, 0.0], [1.0, 1.0]);
    user.key(Key::B);
    user.let_go([1.0, 1.0]);
    user.click([4.0, 4.0]);
    assert_eq!(
        user.text(),
        before,
        "one end alone is picked: {}",
        user.said()
    );
    user.key(Key::V);
    let values = |user: &User| user.editor().player().expect("it moves").motors().to_vec();
    let held = values(&user);
    user.key(Key::Space);
    user.wait(20);
    assert_ne!(values(&user), held, "the link is let go: {}", user.said());
}
