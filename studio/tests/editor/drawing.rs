//! Mechanisms that are drawn from nothing, without typing.

use super::user::User;
use eframe::egui::Key;

/// Draws the four-bar of the README.
pub(crate) fn draw_four_bar(user: &mut User) {
    user.key(Key::B);
    user.drag([-2.0, 0.0], [-2.0, 1.0]);
    user.drag([-2.0, 1.0], [1.0, 3.0]);
    user.drag([1.0, 3.0], [2.0, 0.0]);
    user.key(Key::G);
    user.click([-2.0, 0.0]);
    user.click([2.0, 0.0]);
    user.key(Key::M);
    user.click([-2.0, 0.0]);
}

#[test]
fn a_four_bar_is_drawn_and_moves() {
    let mut user = User::new();
    draw_four_bar(&mut user);
    let expected = "\
struct Mechanism;
link bar1;
link bar2;
link bar3;
joint a = revolute(bar1, bar2) at (-2, 1);
joint b = revolute(bar2, bar3) at (1, 3);
joint c = revolute(ground, bar1) at (-2, 0);
joint d = revolute(ground, bar3) at (2, 0);
motor c;
";
    assert_eq!(user.text(), expected, "{:?}", user.editor().notice());
    assert!(
        user.editor().player().is_some(),
        "{:?}",
        user.editor().messages()
    );
    user.key(Key::Space);
    user.wait(30);
    let motors = user.editor().player().expect("it moves").motors().to_vec();
    let player = user.editor().player().expect("it moves");
    assert!(
        motors[0] > 0.1,
        "{motors:?} {} {:?}",
        player.status(),
        user.editor().notice()
    );
    assert_eq!(user.gestures(), 10);
}

#[test]
fn links_are_copied_and_pasted() {
    let mut user = User::new();
    draw_four_bar(&mut user);
    user.key(Key::Escape);
    user.click([-2.0, 0.4]);
    assert_eq!(user.editor().selection().len(), 1, "{}", user.said());
    user.copy_and_paste();
    // It has a place of its own, beside the other.
    let copy = "link bar4 { point end1 = (-1.8, 0.8); point end2 = (-1.8, -0.2); }";
    assert!(user.text().contains(copy), "{}", user.said());
    user.shortcut(Key::Z, false);
    assert!(!user.text().contains("bar4"), "{}", user.said());
}
