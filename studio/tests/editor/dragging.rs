//! Points that are dragged: only their numbers change.

use super::user::User;
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
