//! Mistakes that people make: drawn, told, and mended by one click.
//!
//! The cases are those of the public fixtures of PMKS+, as facts: where the pins are, what is on the ground, what is driven.

use super::user::User;
use eframe::egui::Key;

type Place = [f64; 2];

/// A mechanism as it is drawn: bars from place to place, pins to the ground, and a driven pin.
struct Case<'c> {
    bars: &'c [[Place; 2]],
    /// A point that is added to a bar which is picked at the first place.
    points: &'c [[Place; 2]],
    /// Bars that are drawn after these points.
    more: &'c [[Place; 2]],
    grounds: &'c [Place],
    motor: &'c [Place],
    /// What the first or second repair says.
    repair: &'c str,
}

const CASE: Case<'static> = Case {
    bars: &[],
    points: &[],
    more: &[],
    grounds: &[],
    motor: &[],
    repair: "",
};

impl Case<'_> {
    fn draw(&self) -> User {
        let mut user = User::new();
        let bars = |user: &mut User, bars: &[[Place; 2]]| {
            user.key(Key::B);
            for [from, to] in bars {
                user.drag(*from, *to);
            }
        };
        bars(&mut user, self.bars);
        for [link, place] in self.points {
            user.key(Key::O);
            user.click(*link);
            user.click(*place);
        }
        bars(&mut user, self.more);
        user.key(Key::G);
        for place in self.grounds {
            user.click(*place);
        }
        user.key(Key::M);
        for place in self.motor {
            user.click(*place);
        }
        user
    }

    /// It does not move; one of the first two repairs says what a teacher would; a click on it, and it moves.
    #[track_caller]
    fn is_mended_by_a_click(&self) {
        is_mended(&mut self.draw(), self.repair);
    }
}

#[track_caller]
fn is_mended(user: &mut User, repair: &str) {
    let said = user.said();
    assert!(user.editor().player().is_none(), "it moves: {said}");
    assert!(!user.editor().messages().is_empty(), "{said}");
    user.click_on_beginning("Diagnoses");
    let offered = user.editor().mendings().iter();
    let offered: Vec<String> = offered.map(|mending| mending.words.clone()).collect();
    let index = offered
        .iter()
        .take(2)
        .position(|words| words.contains(repair));
    let index = index.unwrap_or_else(|| panic!("{offered:#?}\n{said}"));
    user.click_on_beginning(&format!("Repair {}: ", index + 1));
    assert!(
        user.editor().player().is_some(),
        "it does not move:\n{}",
        user.said()
    );
    let motors = |user: &User| {
        user.editor()
            .player()
            .map(|player| player.motors().to_vec())
    };
    let start = motors(user);
    user.key(Key::Space);
    user.wait(20);
    assert_ne!(start, motors(user), "it does not play:\n{}", user.said());
}

#[test]
fn a_pivot_that_was_not_grounded() {
    Case {
        bars: &[
            [[0.0, 0.0], [1.0, 2.0]],
            [[1.0, 2.0], [4.0, 3.0]],
            [[4.0, 3.0], [4.0, 0.0]],
        ],
        grounds: &[[0.0, 0.0]],
        motor: &[[0.0, 0.0]],
        repair: "pin `bar3` to the ground",
        ..CASE
    }
    .is_mended_by_a_click();
}

/// The last pin to the ground would let nothing move: it is refused at once, and nothing changes.
#[track_caller]
fn the_last_pin_is_refused(case: &Case<'_>) {
    let before = Case {
        grounds: &case.grounds[..case.grounds.len() - 1],
        ..*case
    };
    let mut user = before.draw();
    let text = user.text().to_owned();
    user.key(Key::G);
    user.click(case.grounds[case.grounds.len() - 1]);
    let notice = user.editor().notice().cloned().expect("it is told");
    assert!(
        notice.is_refusal && notice.text.contains("a rule of assembly forbids it"),
        "{notice:?}"
    );
    assert_eq!(user.text(), text);
}

#[test]
fn a_four_bar_with_a_brace() {
    the_last_pin_is_refused(&Case {
        bars: &[
            [[0.0, 0.0], [1.0, 2.0]],
            [[1.0, 2.0], [4.0, 3.0]],
            [[4.0, 3.0], [4.0, 0.0]],
            [[1.0, 2.0], [4.0, 0.0]],
        ],
        grounds: &[[0.0, 0.0], [4.0, 0.0]],
        motor: &[[0.0, 0.0]],
        ..CASE
    });
    is_mended_as_text(
        "link ab; link bc; link cd; link bd;
        joint a = revolute(ground, ab) at (0, 0); joint b = revolute(ab, bc) at (1, 2);
        joint b2 = revolute(ab, bd) at (1, 2); joint c = revolute(bc, cd) at (4, 3);
        joint d = revolute(ground, cd) at (4, 0); joint d2 = revolute(cd, bd) at (4, 0); motor a;",
        "remove `link bd`",
    );
}

#[test]
fn a_crank_that_is_grounded_at_both_ends() {
    the_last_pin_is_refused(&Case {
        bars: &[[[0.0, 0.0], [1.0, 1.0]], [[1.0, 1.0], [3.0, 1.6]]],
        grounds: &[[0.0, 0.0], [1.0, 1.0]],
        motor: &[[0.0, 0.0]],
        ..CASE
    });
    // As a text: the teacher's repair first, and then what the link that hangs needs.
    let mut user = User::with_text(
        "struct Mechanism; link ab; link bc { point c = (3, 1.5); }
        joint a = revolute(ground, ab) at (0, 0); joint b = revolute(ground, ab) at (1, 1);
        joint b2 = revolute(ab, bc) at (1, 1); motor a;",
    );
    let words = |user: &User| {
        user.editor()
            .mendings()
            .first()
            .map(|mending| mending.words.clone())
    };
    assert_eq!(
        words(&user).as_deref(),
        Some("remove `joint b`"),
        "{}",
        user.said()
    );
    user.click_on_beginning("Diagnoses");
    user.click_on_beginning("Repair 1: ");
    is_mended(&mut user, "add `motor b2;`");
}

#[test]
fn a_slider_that_is_welded_to_its_rod() {
    is_mended_as_text(
        "link ab; link bc;
        joint a = revolute(ground, ab) at (0, 0); joint b = revolute(ab, bc) at (1, 1);
        joint c = prismatic(ground, bc) at (4, 0) along 0 deg; motor a;",
        "slot",
    );
}

#[test]
fn a_frame_that_is_drawn_as_a_bar() {
    is_mended_as_text(
        "link ab; link bc; link cd; link ad;
        joint a = revolute(ground, ab) at (0, 0); joint a2 = revolute(ground, ad) at (0, 0);
        joint b = revolute(ab, bc) at (0.5, 1); joint c = revolute(bc, cd) at (3, 2);
        joint d = revolute(ground, cd) at (4, 0); joint d2 = revolute(ground, ad) at (4, 0); motor a;",
        "ad",
    );
}

#[test]
fn a_motor_on_a_point_that_is_no_joint() {
    let case = Case {
        bars: &[
            [[0.0, 0.0], [0.6, 1.0]],
            [[0.6, 1.0], [3.0, 2.0]],
            [[3.0, 2.0], [4.0, 0.0]],
        ],
        points: &[[[1.8, 1.5], [2.0, 2.4]]],
        grounds: &[[0.0, 0.0], [4.0, 0.0]],
        repair: "add `motor",
        ..CASE
    };
    let mut user = case.draw();
    user.click([2.0, 2.4]);
    let notice = user.editor().notice().cloned().expect("it is told");
    assert!(notice.is_refusal, "{notice:?}");
    case.is_mended_by_a_click();
}

#[test]
fn a_crank_rocker_that_is_driven_from_the_limit_of_its_rocker() {
    let case = Case {
        bars: &[
            [[0.0, 0.0], [0.875, 0.484]],
            [[0.875, 0.484], [3.5, 1.936]],
            [[3.5, 1.936], [3.0, 0.0]],
        ],
        grounds: &[[0.0, 0.0], [3.0, 0.0]],
        motor: &[[3.0, 0.0]],
        ..CASE
    };
    let user = case.draw();
    assert!(user.editor().player().is_some(), "{}", user.said());
}

/// A text with a mistake is told; one of the first two repairs says what a teacher would; a click on it, and it moves.
#[track_caller]
fn is_mended_as_text(text: &str, repair: &str) {
    let mut user = User::with_text(&format!("struct Mechanism;\n{text}\n"));
    is_mended(&mut user, repair);
}

#[test]
fn a_rocker_dropped_beside_the_pin() {
    Case {
        bars: &[
            [[0.0, 0.0], [0.5, 1.0]],
            [[0.5, 1.0], [3.0, 2.0]],
            [[4.0, 0.0], [3.08, 1.94]],
        ],
        grounds: &[[0.0, 0.0], [4.0, 0.0]],
        motor: &[[0.0, 0.0]],
        repair: "join `bar2` and `bar3`, which are drawn 0.1 apart there",
        ..CASE
    }
    .is_mended_by_a_click();
}

#[test]
fn a_link_that_hangs_from_a_pivot() {
    Case {
        bars: &[
            [[0.0, 0.0], [0.5, 1.0]],
            [[0.5, 1.0], [3.0, 2.0]],
            [[3.0, 2.0], [4.0, 0.0]],
            [[4.0, 0.0], [5.0, 1.2]],
        ],
        grounds: &[[0.0, 0.0], [4.0, 0.0]],
        motor: &[[0.0, 0.0]],
        repair: "remove `link bar4`",
        ..CASE
    }
    .is_mended_by_a_click();
}

#[test]
fn a_four_bar_with_two_motors() {
    Case {
        bars: &[
            [[0.0, 0.0], [0.5, 1.0]],
            [[0.5, 1.0], [3.0, 2.0]],
            [[3.0, 2.0], [4.0, 0.0]],
        ],
        grounds: &[[0.0, 0.0], [4.0, 0.0]],
        motor: &[[0.0, 0.0], [4.0, 0.0]],
        repair: "remove `motor d;`",
        ..CASE
    }
    .is_mended_by_a_click();
}

#[test]
fn a_four_bar_with_a_stray_link() {
    Case {
        bars: &[
            [[0.0, 0.0], [0.5, 1.0]],
            [[0.5, 1.0], [3.0, 2.0]],
            [[3.0, 2.0], [4.0, 0.0]],
            [[4.6, 1.0], [4.9, 2.0]],
        ],
        grounds: &[[0.0, 0.0], [4.0, 0.0]],
        motor: &[[0.0, 0.0]],
        repair: "remove `link bar4`",
        ..CASE
    }
    .is_mended_by_a_click();
}

#[test]
fn a_four_bar_with_a_link_that_hangs_and_no_motor() {
    Case {
        bars: &[
            [[0.0, 0.0], [0.5, 1.0]],
            [[0.5, 1.0], [3.0, 2.0]],
            [[3.0, 2.0], [4.0, 0.0]],
            [[3.0, 2.0], [2.0, 3.0]],
        ],
        grounds: &[[0.0, 0.0], [4.0, 0.0]],
        motor: &[],
        repair: "remove `link bar4` and add `motor",
        ..CASE
    }
    .is_mended_by_a_click();
}

#[test]
fn a_crank_plate_with_two_links_that_hang() {
    Case {
        bars: &[[[-1.0, 0.5], [0.0, 0.0]]],
        points: &[[[-0.5, 0.25], [1.5, 0.8]]],
        more: &[[[-2.0, 1.5], [-1.0, 0.5]], [[1.5, 0.8], [3.0, 0.4]]],
        grounds: &[[0.0, 0.0]],
        motor: &[[0.0, 0.0]],
        repair: "add `motor a;` and `motor b;`",
    }
    .is_mended_by_a_click();
}
