//! Tests of typing, letter by letter. The analysis in pieces is `scripts/pieces.txt`.

use super::folder::TEXT;
use super::user::User;
use eframe::egui::Key;

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
