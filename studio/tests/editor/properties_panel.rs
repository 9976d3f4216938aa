//! The numbers of what is selected, typed.

use super::user::User;
use eframe::egui::Key;

const FOUR_BAR: &str = "struct FourBar;
const LENGTH = 3; // of the ground
link crank { circle (0, 0) radius 0.3 color teal; }
link coupler; link rocker;
joint a = revolute(ground, crank) at (-1, 0);
joint b = revolute(crank, coupler) at (-1, 1);
joint c = revolute(coupler, rocker) at (1, 3);
joint d = revolute(rocker, ground) at (LENGTH, 0);
motor a;
";

fn user_with(selected: &str) -> User {
    let mut user = User::with_text(FOUR_BAR);
    user.click_on("Properties");
    let place = user.scene_place_of(selected).expect("it is seen");
    user.click(place);
    user
}

/// Types into a field, and leaves it.
fn fill(user: &mut User, label: &str, text: &str) {
    user.focus(label);
    user.shortcut(Key::A, false);
    user.type_text(text);
    user.key(Key::Enter);
}

#[test]
fn a_number_is_an_expression_with_units() {
    let mut user = user_with("joint b");
    fill(&mut user, "x of b", "LENGTH / 3 - 2");
    assert!(
        user.text().contains("at (LENGTH / 3 - 2, 1);"),
        "{}",
        user.said()
    );
    let before = user.text().to_owned();
    fill(&mut user, "y of b", "LENGHT");
    assert_eq!(user.text(), before);
    let notice = user.editor().notice().expect("it is told");
    assert!(
        notice.is_refusal && notice.text.contains("LENGHT"),
        "{notice:?}"
    );
}

#[test]
fn a_motor_gets_a_range_that_is_proved() {
    let mut user = user_with("joint a");
    fill(&mut user, "range of a", "0 deg ..= 90 deg");
    assert!(
        user.text().contains("motor a in 0 deg ..= 90 deg;"),
        "{}",
        user.said()
    );
    fill(&mut user, "high of a", "120 deg");
    assert!(
        user.text().contains("motor a in 0 deg ..= 120 deg;"),
        "{}",
        user.said()
    );
}

#[test]
fn shapes_are_added_layered_and_taken_out() {
    let mut user = User::with_text(FOUR_BAR);
    user.click_on("Properties");
    user.click([-1.0, 0.5]);
    fill(&mut user, "new shape of crank", "circle (0, 1) radius 0.2");
    assert!(
        user.text().contains("circle (0, 1) radius 0.2;"),
        "{}",
        user.said()
    );
    user.click_on("Nearer (crank 2)");
    assert!(
        user.text().contains("circle (0, 1) radius 0.2 on plane 1;"),
        "{}",
        user.said()
    );
    fill(&mut user, "mass of crank", "2.5");
    assert!(user.text().contains("mass 2.5"), "{}", user.said());
    for _ in 0..3 {
        user.shortcut(Key::Z, false);
    }
    assert_eq!(user.text(), FOUR_BAR);
}
