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

#[test]
fn a_part_of_the_library_is_used_by_completing_a_line() {
    let mut user = User::with_text(
        "struct Boom;\nground { point foot = (0, 0); }\nlink boom { point eye = (1, 0); }\n",
    );
    user.click_on("Edit");
    user.click_on("Use a part");
    user.click_on("Cylinder");
    user.wait(3);
    user.key(Key::Enter);
    // One link is still to be named.
    let notice = user.editor().notice().expect("it is told");
    assert!(
        notice.is_refusal && notice.text.contains("LINK"),
        "{notice:?}"
    );
    user.key(Key::ArrowUp);
    user.shortcut(Key::A, false);
    user.type_text("use ram: Cylinder { base = ground, load = boom }");
    user.key(Key::Enter);
    assert!(
        user.text()
            .contains("use ram: Cylinder { base = ground, load = boom }"),
        "{}",
        user.said()
    );
}

#[test]
fn another_mechanism_of_the_file_is_chosen() {
    let one = |name: &str, at: &str| {
        format!(
            "mechanism! {{\n    struct {name};\n    link crank;\n    joint {at} = revolute(ground, crank) at (0, 0);\n    motor {at};\n}}\n"
        )
    };
    let text = one("First", "a") + &one("Second", "b");
    let mut user = User::with_file("two.rs", &text);
    assert_eq!(user.handles(), ["joint a"]);
    user.click_on("mechanism");
    user.click_on("Second");
    assert_eq!(user.handles(), ["joint b"], "{}", user.said());
    user.move_handle([0.0, 0.0], [1.0, 0.0]);
    assert!(
        user.text()
            .contains("joint a = revolute(ground, crank) at (0, 0);")
    );
    assert!(
        user.text()
            .contains("joint b = revolute(ground, crank) at (1, 0);"),
        "{}",
        user.said()
    );
}
