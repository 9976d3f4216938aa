//! Pictures that are not what the text says, and gestures after which nothing goes on.

use super::drawing::draw_four_bar;
use super::user::User;
use eframe::egui::Key;
use mech_studio::editor::Item;

const FOUR_BAR: &str = "struct FourBar;
link crank; link coupler; link rocker;
joint a = revolute(ground, crank) at (-2, 0);
joint b = revolute(crank, coupler) at (-2, 1);
joint c = revolute(coupler, rocker) at (1, 3);
joint d = revolute(rocker, ground) at (2, 0);
motor a;
";

const PLACES: [(&str, [f64; 2]); 4] = [
    ("joint a", [-2.0, 0.0]),
    ("joint b", [-2.0, 1.0]),
    ("joint c", [1.0, 3.0]),
    ("joint d", [2.0, 0.0]),
];

/// Each joint is seen where the text says.
#[track_caller]
fn is_seen(user: &User, places: &[(&str, [f64; 2])]) {
    for (label, [x, y]) in places {
        let found = user.scene_place_of(label).unwrap_or([f64::NAN; 2]);
        let is_there = (found[0] - x).hypot(found[1] - y) < 1e-9;
        assert!(is_there, "{label} is at {found:?}: {}", user.said());
    }
}

/// The places in the scene at which the ends of bars are drawn.
#[track_caller]
fn is_drawn(user: &User, link: &str, ends: [[f64; 2]; 2]) {
    let found = user.ends_of(link);
    let is_there = |end: &[f64; 2]| {
        let away = |one: &[f64; 2]| (one[0] - end[0]).hypot(one[1] - end[1]);
        found.iter().any(|one| away(one) < 1e-6)
    };
    assert!(ends.iter().all(is_there), "{found:?} {}", user.said());
}

#[test]
fn a_pose_goes_with_its_motor() {
    let mut user = User::with_text(FOUR_BAR);
    user.scrub(2.0);
    user.type_all(&FOUR_BAR.replace("motor a;\n", ""));
    assert!(user.editor().player().is_none());
    is_seen(&user, &PLACES);
    is_drawn(&user, "rocker", [[1.0, 3.0], [2.0, 0.0]]);
    user.move_handle([2.0, 0.0], [3.0, 0.0]);
    is_drawn(&user, "rocker", [[1.0, 3.0], [3.0, 0.0]]);
    is_drawn(&user, "coupler", [[1.0, 3.0], [-2.0, 1.0]]);
}

#[test]
fn a_pose_goes_with_whatever_lets_it_move() {
    // Links with points of their own stand where they stood at the start, too.
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
    let start = user.ends_of("two");
    user.scrub(2.5);
    assert_ne!(user.ends_of("two"), start);
    user.click_on("Motor");
    user.click([0.0, 0.0]);
    assert!(!user.text().contains("motor a"), "{}", user.said());
    is_drawn(&user, "two", [start[0], start[1]]);
}

#[test]
fn a_motion_by_hand_is_taken_back_before_the_motor_is() {
    let mut user = User::new();
    draw_four_bar(&mut user);
    user.key(Key::V);
    let text = user.text().to_owned();
    user.drag([-2.0, 0.6], [-1.4, 0.6]);
    let motors = |user: &User| user.editor().player().expect("it moves").motors().to_vec();
    assert!(motors(&user)[0].abs() > 0.1, "{}", user.said());
    user.scrub(1.0);
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), text, "{}", user.said());
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), text, "{}", user.said());
    assert!(motors(&user)[0].abs() < 1e-9, "{}", user.said());
    is_drawn(&user, "bar3", [[1.0, 3.0], [2.0, 0.0]]);
    // Nothing was moved since: the step before is undone.
    user.shortcut(Key::Z, false);
    assert!(!user.text().contains("motor"), "{}", user.said());
}

#[test]
fn what_is_pinned_jumps_at_once() {
    let mut user = User::new();
    user.key(Key::B);
    user.drag([-3.0, 0.0], [-1.0, 1.0]);
    user.drag([1.0, 2.0], [2.0, 0.0]);
    // A bar that hangs on the second goes with it.
    user.drag([2.0, 0.0], [3.0, 1.0]);
    user.key(Key::P);
    user.click([-1.0, 1.0]);
    user.click([1.0, 2.0]);
    assert!(user.editor().player().is_none());
    is_drawn(&user, "bar1", [[-3.0, 0.0], [-1.0, 1.0]]);
    is_drawn(&user, "bar2", [[-1.0, 1.0], [0.0, -1.0]]);
    is_drawn(&user, "bar3", [[0.0, -1.0], [1.0, 0.0]]);
    // Without the pin it is where the text has it.
    user.shortcut(Key::Z, false);
    is_drawn(&user, "bar2", [[1.0, 2.0], [2.0, 0.0]]);
    is_drawn(&user, "bar3", [[2.0, 0.0], [3.0, 1.0]]);
    // The first on the ground stays where it is, whichever is picked first.
    let mut user = User::new();
    user.key(Key::B);
    user.drag([-3.0, 0.0], [-1.0, 1.0]);
    user.drag([1.0, 2.0], [2.0, 0.0]);
    user.key(Key::G);
    user.click([2.0, 0.0]);
    user.key(Key::P);
    user.click([1.0, 2.0]);
    user.click([-1.0, 1.0]);
    is_drawn(&user, "bar2", [[1.0, 2.0], [2.0, 0.0]]);
    is_drawn(&user, "bar1", [[1.0, 2.0], [-1.0, 1.0]]);
}

#[test]
fn ends_of_a_pin_that_are_apart_are_both_seen() {
    let [coupler, rocker] = [[0.0, 2.4], [1.03, 2.04]];
    let mut user = User::new();
    user.key(Key::B);
    user.drag([-3.0, 0.0], [-1.0, 1.0]);
    user.drag([-1.0, 1.0], coupler);
    user.drag(rocker, [2.0, 0.0]);
    user.key(Key::G);
    user.click([-3.0, 0.0]);
    user.click([2.0, 0.0]);
    assert!(!user.sees_dashes(coupler, rocker), "{}", user.said());
    user.key(Key::P);
    user.click(coupler);
    user.click(rocker);
    user.key(Key::Escape);
    // No bar can jump: the ground holds both. They stay where the text has them.
    is_drawn(&user, "bar2", [[-1.0, 1.0], coupler]);
    is_drawn(&user, "bar3", [rocker, [2.0, 0.0]]);
    assert!(user.sees_dashes(coupler, rocker), "{}", user.said());
    assert!(user.sees_ring(coupler) && user.sees_ring(rocker));
    // The pin goes to its other end, not to the grid near that.
    user.drag(coupler, [1.0, 2.0]);
    is_drawn(&user, "bar2", [[-1.0, 1.0], rocker]);
    assert!(!user.sees_dashes(coupler, rocker), "{}", user.said());
    user.key(Key::M);
    user.click([-3.0, 0.0]);
    assert!(user.editor().player().is_some(), "{}", user.said());
    is_drawn(&user, "bar2", [[-1.0, 1.0], rocker]);
    is_drawn(&user, "bar3", [rocker, [2.0, 0.0]]);
}

#[test]
fn a_bar_wins_over_the_grid() {
    let [from, to] = [[-3.0, 0.0], [3.2, 1.4]];
    for tool in [Key::R, Key::G] {
        for x in [-2.1, -0.9, 0.3, 1.9] {
            let mut user = User::new();
            user.key(Key::B);
            user.drag(from, to);
            user.key(tool);
            let y = (x + 3.0) * 1.4 / 6.2;
            user.click_near([x, y + 0.03]);
            let found: Vec<[f64; 2]> = user
                .editor()
                .drawing()
                .expect("it is drawn")
                .handles()
                .map(|handle| handle.place)
                .filter(|place| *place != from && *place != to)
                .collect();
            assert_eq!(found.len(), 1, "{}", user.said());
            let [px, py] = found[0];
            assert!(
                (py - (px + 3.0) * 1.4 / 6.2).abs() < 1e-8 && (px - x).abs() < 0.2,
                "{found:?} {}",
                user.said()
            );
        }
    }
}

#[test]
fn the_tool_force_asks_for_forces() {
    let mut user = User::new();
    draw_four_bar(&mut user);
    user.click_on("Force");
    user.click([1.0, 3.0]);
    assert!(
        user.text().contains("load load1 = force("),
        "{}",
        user.said()
    );
    assert!(
        user.text().contains("effects { force; }"),
        "{}",
        user.said()
    );
    assert!(user.editor().player().is_some(), "{}", user.said());
    // With the last one, what asks for it goes.
    user.at_once(|editor| {
        editor.select(Some(Item::Action("load1".to_owned())), false);
        editor.remove_selected();
    });
    assert!(!user.text().contains("force"), "{}", user.said());
    user.shortcut(Key::Z, false);
    // A second one, and one beside an effect that is there.
    user.click([-2.0, 1.0]);
    assert_eq!(user.text().matches("force;").count(), 1, "{}", user.said());
    for effects in ["trace coupler.p 64;", "dynamics;"] {
        let text = FOUR_BAR.replace(
            "link coupler;",
            "link coupler { point p = (0, 3); mass 1 at (0, 2); }",
        );
        let mut user = User::with_text(&format!("{text}effects {{ {effects} }}\n"));
        user.click_on("Force");
        user.click([1.0, 3.0]);
        assert!(user.text().contains("load load1"), "{}", user.said());
        user.editor()
            .player()
            .unwrap_or_else(|| panic!("{}", user.said()));
    }
}

#[test]
fn bars_stay_when_their_pin_is_deleted() {
    let mut user = User::with_text(FOUR_BAR);
    user.click([1.0, 3.0]);
    user.key(Key::Delete);
    assert!(!user.text().contains("joint c"), "{}", user.said());
    is_drawn(&user, "coupler", [[-2.0, 1.0], [1.0, 3.0]]);
    is_drawn(&user, "rocker", [[1.0, 3.0], [2.0, 0.0]]);
    // The free ends are pinned again.
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), FOUR_BAR);
    // So do the neighbours of a bar.
    user.key(Key::Escape);
    user.click([-0.5, 2.0]);
    user.key(Key::Delete);
    assert!(!user.text().contains("coupler"), "{}", user.said());
    is_drawn(&user, "crank", [[-2.0, 0.0], [-2.0, 1.0]]);
    is_drawn(&user, "rocker", [[1.0, 3.0], [2.0, 0.0]]);
    // Of three links on a pin, those that keep a joint there need no end.
    let text = FOUR_BAR.replace(
        "motor a;",
        "link more { point tip = (-3, 3); }\njoint e = revolute(crank, more) at (-2, 1);\nmotor a;",
    );
    let mut user = User::with_text(&text);
    user.at_once(|editor| editor.select(Some(Item::Joint("e".to_owned())), false));
    user.at_once(mech_studio::editor::Editor::remove_selected);
    assert!(!user.text().contains("link crank {"), "{}", user.said());
    is_drawn(&user, "more", [[-3.0, 3.0], [-2.0, 1.0]]);
}

#[test]
fn a_weld_replaces_the_pin_of_the_same_bars() {
    // The bar that is meant is the other one on the pin, whichever is picked second.
    for second in [[0.4, 0.8], [2.5, 2.5]] {
        let mut user = User::new();
        user.key(Key::B);
        user.drag([0.0, 0.0], [1.0, 2.0]);
        user.drag([1.0, 2.0], [4.0, 3.0]);
        user.click_on("Weld");
        user.click([1.0, 2.0]);
        user.click_near(second);
        assert!(!user.text().contains("revolute"), "{}", user.said());
        assert_eq!(user.text().matches("weld(").count(), 1, "{}", user.said());
        // A second weld, or a pin, holds nothing more.
        let text = user.text().to_owned();
        user.key(Key::P);
        user.click([0.0, 0.0]);
        user.click([4.0, 3.0]);
        assert_eq!(user.text(), text);
        let notice = user.editor().notice().cloned().expect("it is told");
        assert!(notice.text.contains("held more than once"), "{notice:?}");
        // It moves.
        user.key(Key::G);
        user.click([0.0, 0.0]);
        user.key(Key::M);
        user.click([0.0, 0.0]);
        assert!(user.editor().player().is_some(), "{}", user.said());
    }
}

#[test]
fn a_weld_takes_no_pivot_and_no_motor_away() {
    let text = "struct Arm;
link upper; link fore { point tip = (2, 2); }
joint a = revolute(ground, upper) at (0, 0);
joint b = revolute(upper, fore) at (1, 0);
motor a;
motor b;
";
    for [first, second] in [[[-2.0, -2.0], [0.0, 0.0]], [[1.0, 0.0], [2.0, 2.0]]] {
        let mut user = User::with_text(text);
        user.click_on("Weld");
        user.click(first);
        user.click(second);
        assert_eq!(user.text(), text);
        let notice = user.editor().notice().cloned().expect("it is told");
        assert!(notice.text.contains("remove it first"), "{notice:?}");
    }
}

#[test]
fn a_weld_beside_a_pin_is_refused_in_the_line() {
    let text = "struct Bars;
link one { point o = (0, 0); point e = (2, 0); }
link two { point o = (0, 0); point e = (1, 0); }
link three { point o = (0, 0); point e = (1, 0); }
joint a = weld(one.e, two.o);
joint b = revolute(two.e, three.o);
";
    for (line, joint) in [
        ("join w = weld one.o three.e", "`b`"),
        ("join w = revolute one.o two.e", "`a`"),
    ] {
        let mut user = User::with_text(text);
        user.at_once(|editor| editor.say(line));
        let notice = user.editor().notice().cloned().expect("it is told");
        assert!(
            notice.is_refusal && notice.text.contains(joint),
            "{notice:?}"
        );
        assert_eq!(user.text(), text);
    }
}

#[test]
fn all_that_is_selected_goes_with_a_bar_of_it() {
    let mut user = User::with_text(FOUR_BAR);
    user.shortcut(Key::A, false);
    user.drag([-0.8, 1.8], [0.2, 2.2]);
    for place in ["at (-1, 0.4)", "at (-1, 1.4)", "at (2, 3.4)", "at (3, 0.4)"] {
        assert!(user.text().contains(place), "{}", user.said());
    }
    assert!(user.editor().player().is_some());
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), FOUR_BAR);
    // A bar that is selected alone turns the motor.
    user.key(Key::Escape);
    user.click([-2.0, 0.4]);
    user.drag([-2.0, 0.4], [-1.6, 0.4]);
    assert_eq!(user.text(), FOUR_BAR, "{}", user.said());
}

#[test]
fn what_is_pressed_is_what_was_under_the_pointer_then() {
    for places in [
        [[1.0, 3.0], [1.4, 3.4]],
        [[-2.0, 1.0], [-1.6, 1.4]],
        [[2.0, 0.0], [3.0, 0.4]],
    ] {
        let mut user = User::with_text(FOUR_BAR);
        let [[x, y], [to_x, to_y]] = places;
        user.rush(places[0], places[1]);
        let expected = FOUR_BAR.replace(&format!("at ({x}, {y})"), &format!("at ({to_x}, {to_y})"));
        assert_eq!(user.text(), expected, "{}", user.said());
    }
    // From a bar over a pin: the bar is meant.
    let mut user = User::with_text(FOUR_BAR);
    user.rush([-2.0, 0.6], [-2.0, 1.0]);
    assert_eq!(user.text(), FOUR_BAR, "{}", user.said());
}

#[test]
fn all_is_copied_with_its_pins_here_and_elsewhere() {
    let text = FOUR_BAR
        .replace(
            "link crank;",
            "const SIZE = 1;\nlink crank { circle (-2, 0.5) radius 0.1 * SIZE color teal; }",
        )
        .replace("at (-2, 1)", "at (-2, SIZE)");
    let mut user = User::with_text(&text);
    user.shortcut(Key::A, false);
    user.copy_and_paste();
    let after = user.text().to_owned();
    for copy in [
        "link crank1 { circle (-1.8, 0.3) radius 0.1 * SIZE color teal; }",
        "revolute(ground, crank1) at (-1.8, -0.2);",
        "revolute(crank1, coupler1) at (-1.8, SIZE + (-0.2));",
        "revolute(rocker1, ground) at (2.2, -0.2);",
    ] {
        assert!(after.contains(copy), "{copy}: {}", user.said());
    }
    assert_eq!(after.matches("motor ").count(), 2, "{}", user.said());
    assert!(user.editor().player().is_some(), "{}", user.said());
    assert_eq!(user.editor().selection().len(), 3);
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), text);
    // Another text has another constant of that name.
    user.shortcut(Key::A, false);
    let copied = user.copy();
    for other in ["", "struct Other;\nconst SIZE = 2;\nlink crank;\n"] {
        let mut user = User::with_text(other);
        user.paste(&copied);
        assert!(
            user.text().contains("(coupler, rocker) at (1.2, 2.8)"),
            "{}",
            user.said()
        );
        let has_other = user.text().contains("const SIZE1 = 1;");
        assert_eq!(has_other, !other.is_empty(), "{}", user.said());
        assert!(user.editor().is_readable(), "{}", user.said());
    }
    user.at_once(|editor| editor.open(mech_studio::Workspace::unsaved("other.mech", "")));
    user.paste("");
    assert!(user.editor().player().is_some(), "{}", user.said());
    // What is not of the studio is told.
    let before = user.text().to_owned();
    user.paste("hello");
    assert_eq!(user.text(), before);
    let notice = user.editor().notice().cloned().expect("it is told");
    assert!(
        notice.is_refusal && notice.text.contains("nothing was copied"),
        "{notice:?}"
    );
}

#[test]
fn whatever_joins_links_is_copied() {
    let jansen = include_str!("../../../examples/gallery/src/mechanisms/jansen.rs");
    let figure = "struct Figure;
link wheel1; link wheel2; link bar1; link block1; link arm { point tip = (1, 0); }
joint a = revolute(ground, wheel1) at (-3, 0);
joint b = revolute(ground, wheel2) at (0, 0);
joint mesh1 = gear(wheel1, wheel2, 20 : 40);
joint c = revolute(wheel2, bar1) at (1, 0);
joint d = revolute(bar1, block1) at (5, 0);
joint e = prismatic(ground, block1) at (5, 0) along 0 deg;
joint f = weld(arm, bar1) at (3, 0);
motor a;
";
    for (name, text) in [("jansen.rs", jansen), ("figure.mech", figure)] {
        let mut user = User::with_file(name, text);
        let count = |user: &User, word: &str| user.text().matches(word).count();
        let before = ["joint ", "link ", "motor "].map(|word| count(&user, word));
        user.shortcut(Key::A, false);
        user.copy_and_paste();
        let after = ["joint ", "link ", "motor "].map(|word| count(&user, word));
        assert!(user.editor().player().is_some(), "{}", user.said());
        assert!(
            after
                .iter()
                .zip(before)
                .all(|(after, before)| *after > before),
            "{}",
            user.said()
        );
        let links = user.editor().selection().len();
        assert!(links >= 5, "{}", user.said());
    }
}
