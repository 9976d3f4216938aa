//! The keyboard alone.

use super::user::User;
use eframe::egui::Key;

#[test]
fn a_pin_is_moved_by_the_arrows() {
    let text =
        "struct Mechanism;\nlink crank;\njoint a = revolute(ground, crank) at (0, 0);\nmotor a;\n";
    let mut user = User::with_text(text);
    user.focus("joint a");
    user.key(Key::ArrowRight);
    assert!(user.text().contains("at (0."), "{}", user.said());
}

#[test]
fn a_crank_is_drawn_by_keys_alone() {
    let mut user = User::new();
    user.key(Key::B);
    user.focus("drawing");
    // The cross begins in the middle.
    user.key(Key::Enter);
    for _ in 0..5 {
        user.key(Key::ArrowRight);
    }
    user.key(Key::Enter);
    user.key(Key::G);
    user.focus("drawing");
    for _ in 0..5 {
        user.key(Key::ArrowLeft);
    }
    user.key(Key::Enter);
    user.key(Key::M);
    user.focus("drawing");
    user.key(Key::Enter);
    let expected = "\
struct Mechanism;
link bar1 { point end2 = (1, 0); }
joint a = revolute(ground, bar1) at (0, 0);
motor a;
";
    assert_eq!(user.text(), expected, "{}", user.said());
    user.key(Key::Space);
    user.wait(10);
    assert!(user.editor().player().expect("it moves").motors()[0] > 0.0);
}

#[test]
fn a_line_is_typed_completed_and_recalled() {
    let mut user = User::with_text(
        "struct Mechanism;\nlink crank;\njoint pivot = revolute(ground, crank) at (0, 0);\n",
    );
    user.focus("Line");
    user.type_text("motor pi");
    user.key(Key::Tab);
    user.key(Key::Enter);
    assert!(user.text().ends_with("motor pivot;\n"), "{}", user.said());
    user.type_text("undo");
    user.key(Key::Enter);
    assert!(!user.text().contains("motor"));
    user.key(Key::ArrowUp);
    user.key(Key::ArrowUp);
    user.key(Key::Enter);
    assert!(user.text().contains("motor pivot"), "{}", user.said());
}
