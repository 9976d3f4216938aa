//! Fingers, on a screen as small as a telephone's.

use super::user::User;
use eframe::egui::{pos2, vec2};

#[test]
fn a_four_bar_is_drawn_and_played_by_taps_alone() {
    let mut user = User::with_telephone();
    let canvas = user.place_of("drawing");
    assert!(canvas.width() > 370.0 && canvas.height() > 200.0, "{canvas:?}");
    user.tap_on("Bar");
    for [from, to] in
        [[[-2.0, 0.0], [-2.0, 1.0]], [[-2.0, 1.0], [1.0, 3.0]], [[1.0, 3.0], [2.0, 0.0]]]
    {
        let [from, to] = [from, to].map(|place| user.pixel(place));
        user.tap(from);
        user.tap(to);
    }
    user.tap_on("Ground");
    for place in [[-2.0, 0.0], [2.0, 0.0]] {
        let at = user.pixel(place);
        user.tap(at);
    }
    // The motor is farther to the right: the tools are moved until it is seen.
    let row = user.place_of("drawing").x_range();
    while !row.contains(user.place_of("Motor").right()) {
        let from = user.place_of("Motor").center();
        let from = pos2(row.center(), from.y);
        user.swipe(from, from - vec2(60.0, 0.0));
        user.wait(120);
    }
    user.tap_on("Motor");
    let at = user.pixel([-2.0, 0.0]);
    user.tap(at);
    assert!(user.text().contains("motor c;"), "{}", user.said());
    user.tap_on("Play");
    user.wait(30);
    let player = user.editor().player().expect("it moves");
    assert!(player.plays() && player.motors()[0] > 0.1, "{}", user.said());
}

#[test]
fn everything_that_is_tapped_is_as_high_as_a_finger() {
    let user = User::with_telephone();
    for label in ["File", "Undo", "Select", "Bar", "Text", "Diagnoses", "Journal"] {
        let place = user.place_of(label);
        assert!(place.height() >= 28.0, "{label} is {} high", place.height());
    }
}

#[test]
fn the_drawing_gets_the_room_of_a_panel_that_is_closed() {
    let mut user = User::with_telephone();
    let before = user.place_of("drawing").height();
    user.tap_on("Text");
    let after = user.place_of("drawing").height();
    assert!(after > before + 100.0, "{before} {after}");
    user.tap_on("Properties");
    assert!(user.place_of("drawing").height() < after);
}
