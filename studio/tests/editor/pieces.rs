//! The analysis in pieces, as in a browser: what is done while a gesture is still being tried.

use super::drawing::draw_four_bar;
use super::user::User;
use eframe::egui::Key;
use mech_studio::editor::{Editor, Item, Tool};
use mech_studio::{Command, Workspace};

const TEXT: &str =
    "struct Crank;\nlink crank;\njoint a = revolute(ground, crank) at (0, 0);\nmotor a;\n";

fn link(name: &str) -> Command {
    Command::Link {
        name: name.to_owned(),
    }
}

fn user() -> User {
    let mut user = User::in_browser();
    user.at_once(|editor| editor.type_text(TEXT));
    user.settle();
    assert!(user.editor().player().is_some(), "{}", user.said());
    user
}

#[test]
fn it_finds_what_is_found_at_once() {
    let mut user = User::in_browser();
    draw_four_bar(&mut user);
    user.settle();
    let mut at_once = User::new();
    draw_four_bar(&mut at_once);
    assert_eq!(user.text(), at_once.text());
    assert!(user.editor().player().is_some(), "{}", user.said());

    for user in [&mut user, &mut at_once] {
        user.click([-2.0, 1.0]);
        user.key(Key::Delete);
    }
    user.settle();
    let repairs = |user: &User| {
        let mendings = user.editor().mendings().iter();
        mendings
            .map(|mending| mending.words.clone())
            .collect::<Vec<_>>()
    };
    assert_eq!(repairs(&user), repairs(&at_once));
    assert!(!repairs(&user).is_empty(), "{}", user.said());
    user.mend(1);
    user.settle();
    assert!(user.editor().messages().is_empty(), "{}", user.said());
}

#[test]
fn a_gesture_is_tried_again_on_what_was_typed_meanwhile() {
    let mut user = user();
    let typed = format!("// Typed meanwhile.\n{TEXT}");
    user.at_once(|editor| {
        editor.perform(link("second"));
        editor.type_text(&typed);
    });
    user.settle();
    assert!(
        user.text().starts_with("// Typed meanwhile."),
        "{}",
        user.said()
    );
    assert!(user.text().contains("link second;"), "{}", user.said());
}

#[test]
fn a_gesture_does_not_follow_into_another_file() {
    let mut user = user();
    let other = TEXT.replace("Crank", "Other");
    user.at_once(|editor| {
        editor.perform(link("second"));
        editor.open(Workspace::unsaved("other.mech", other.as_str()));
    });
    user.settle();
    assert_eq!(user.text(), other);
    assert!(user.editor().player().is_some(), "{}", user.said());
}

#[test]
fn undo_gives_up_what_was_not_made_yet() {
    let mut user = user();
    user.at_once(|editor| {
        editor.perform(link("second"));
        editor.undo();
    });
    user.settle();
    assert_eq!(user.text(), TEXT);
    assert!(user.editor().player().is_some(), "{}", user.said());
    user.at_once(Editor::redo);
    user.settle();
    assert_eq!(user.text(), TEXT);
}

#[test]
fn gestures_wait_for_each_other() {
    let mut user = user();
    user.at_once(|editor| {
        for name in ["second", "third", "fourth"] {
            editor.perform(link(name));
        }
    });
    assert!(user.editor().is_busy());
    user.settle();
    for name in ["second", "third", "fourth"] {
        assert!(
            user.text().contains(&format!("link {name};")),
            "{}",
            user.said()
        );
    }
    assert_eq!(user.editor().workspace().history().made().len(), 4);
}

/// A crank with a point at its end, whose place is dragged.
const TIP: &str = "struct Crank;\nlink crank { point tip = (2, 0); }\njoint a = revolute(ground, crank) at (0, 0);\nmotor a;\n";

fn with_tip() -> User {
    let mut user = User::in_browser();
    user.at_once(|editor| editor.type_text(TIP));
    user.settle();
    user
}

#[test]
fn a_drag_ends_as_it_does_at_once() {
    let mut user = with_tip();
    user.move_handle([2.0, 0.0], [2.0, 1.0]);
    user.settle();
    let mut at_once = User::with_text(TIP);
    at_once.move_handle([2.0, 0.0], [2.0, 1.0]);
    assert_eq!(user.text(), at_once.text(), "{}", user.said());
    assert_ne!(user.text(), TIP);
}

/// Drags the point, all within a frame.
fn drag_tip(editor: &mut Editor) {
    editor.begin_drag(&Item::Axis("crank.tip".to_owned()), false);
    editor.drag_to([3.0, 0.5]);
    editor.drag_to([3.0, 1.0]);
    editor.end_drag();
}

#[test]
fn what_is_let_go_before_its_place_is_known_goes_there() {
    let mut user = with_tip();
    user.at_once(drag_tip);
    assert_eq!(user.text(), TIP);
    user.settle();
    assert!(user.text().contains("tip = (3, 1)"), "{}", user.said());
    assert_eq!(user.editor().workspace().history().made().len(), 2);
}

#[test]
fn what_is_let_go_is_not_dragged_into_another_text() {
    let mut user = with_tip();
    let other = TIP.replace("Crank", "Other");
    user.at_once(|editor| {
        drag_tip(editor);
        editor.open(Workspace::unsaved("other.mech", other.as_str()));
    });
    user.settle();
    assert_eq!(user.text(), other, "{}", user.said());
    user.move_handle([2.0, 0.0], [2.0, 1.0]);
    user.settle();
    assert!(user.text().contains("tip = (2, 1)"), "{}", user.said());
}

#[test]
fn a_place_that_cannot_be_leaves_what_is_dragged_where_it_was() {
    let mut user = with_tip();
    user.at_once(|editor| {
        editor.begin_drag(&Item::Axis("crank.tip".to_owned()), false);
        editor.drag_to([f64::NAN, 0.5]);
        editor.end_drag();
    });
    user.settle();
    assert_eq!(user.text(), TIP, "{}", user.said());
    user.move_handle([2.0, 0.0], [2.0, 1.0]);
    user.settle();
    assert!(user.text().contains("tip = (2, 1)"), "{}", user.said());
}

#[test]
fn undo_and_another_gesture_at_once_leave_nothing_open() {
    let mut user = user();
    user.at_once(|editor| {
        editor.perform(link("second"));
        editor.undo();
        editor.perform(link("third"));
    });
    user.settle();
    assert!(!user.text().contains("second"), "{}", user.said());
    assert!(user.text().contains("link third;"), "{}", user.said());
}

#[test]
fn typing_back_and_forth_while_a_gesture_is_tried_leaves_nothing_open() {
    let mut user = user();
    user.at_once(|editor| {
        editor.perform(link("second"));
        editor.type_text(&format!("{TEXT}x"));
        editor.type_text(TEXT);
        editor.say("help");
    });
    user.settle();
    assert!(user.text().contains("link second;"), "{}", user.said());
    assert!(!user.editor().mendings().is_empty(), "{}", user.said());
}

#[test]
fn a_question_does_not_take_a_drag_away() {
    let mut user = with_tip();
    user.at_once(|editor| {
        drag_tip(editor);
        editor.say("help");
        editor.choose(Tool::Bar);
    });
    user.settle();
    assert!(user.text().contains("tip = (3, 1)"), "{}", user.said());
}

#[test]
fn undo_gives_up_a_drag_that_is_not_at_its_place_yet() {
    let mut user = with_tip();
    user.at_once(|editor| {
        drag_tip(editor);
        editor.undo();
    });
    user.settle();
    assert_eq!(user.text(), TIP, "{}", user.said());
    assert_eq!(user.editor().workspace().history().made().len(), 1);
}

#[test]
fn a_gesture_before_a_drag_does_not_take_it_away() {
    let mut user = with_tip();
    user.at_once(|editor| {
        editor.perform(link("second"));
        drag_tip(editor);
    });
    user.settle();
    assert!(user.text().contains("link second;"), "{}", user.said());
    assert!(user.text().contains("tip = (3, 1)"), "{}", user.said());
}

#[test]
fn what_is_picked_before_an_older_text_is_back_is_meant_there() {
    let mut user = user();
    user.at_once(|editor| {
        for name in ["second", "third"] {
            editor.perform(link(name));
        }
    });
    user.settle();
    user.key(Key::B);
    user.drag([3.0, 1.0], [5.0, 1.0]);
    user.settle();
    user.key(Key::P);
    user.at_once(Editor::undo);
    // The bar is still seen where it was.
    user.click([3.0, 1.0]);
    user.settle();
    user.click([0.0, 0.0]);
    user.settle();
    assert!(!user.text().contains("bar"), "{}", user.said());
}

#[test]
fn links_are_pasted_twice_at_once() {
    let mut user = with_tip();
    user.click([1.0, 0.0]);
    user.copy_and_paste();
    user.copy_and_paste();
    user.settle();
    assert!(user.text().contains("link crank1"), "{}", user.said());
    assert!(user.text().contains("link crank2"), "{}", user.said());
}

#[test]
fn a_file_with_fewer_mechanisms_shows_its_last() {
    let three: String = ["One", "Two", "Three"]
        .iter()
        .map(|name| format!("mechanism! {{\n{}}}\n", TEXT.replace("Crank", name)))
        .collect();
    let mut user = User::with_file("three.rs", &three);
    user.click_on_beginning("mechanism");
    user.click_on("Three");
    assert_eq!(user.editor().workspace().index(), 2);
    let two = three
        .split("mechanism!")
        .take(3)
        .collect::<Vec<_>>()
        .join("mechanism!");
    user.type_all(&two);
    assert_eq!(user.editor().workspace().index(), 1);
    assert!(user.editor().player().is_some(), "{}", user.said());
}

#[test]
fn typing_before_marks_of_other_letters_is_safe() {
    // The marks of the text before would cut through letters: these have two bytes each.
    let text = format!("// {}\n{TEXT}// {}\n", "ü".repeat(40), "ä".repeat(40));
    let mut user = User::with_text(&text);
    user.click([0.0, 0.0]);
    user.click_within("text of the mechanism", [0.2, 0.1]);
    for _ in 0..6 {
        user.key(Key::ArrowUp);
    }
    user.key(Key::Home);
    for deleted in 1..60 {
        user.key(Key::Delete);
        let rest: String = text.chars().skip(deleted).collect();
        assert_eq!(user.text(), rest);
    }
}
