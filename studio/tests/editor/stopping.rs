//! What takes its time beside the window is told, and can be ended.

use super::folder::TEXT;
use super::user::User;
use std::fmt::Write;

/// A text with so many dyads that its analysis takes its time: each is driven by the one before.
fn chain(count: usize) -> String {
    let mut text = "link r0; joint d0 = revolute(ground, r0) at (0, 0); motor d0;\n".to_owned();
    for number in 1..=count {
        let (before, left, at) = (number - 1, 3 * number - 3, 3 * number);
        writeln!(
            text,
            "link k{number}; link r{number};
            joint b{number} = revolute(r{before}, k{number}) at ({left}, 1);
            joint c{number} = revolute(k{number}, r{number}) at ({at}, 2);
            joint d{number} = revolute(r{number}, ground) at ({at}, 0);"
        )
        .expect("a text takes all that is written");
    }
    format!("struct Chain;\n{text}")
}

#[test]
fn an_analysis_is_ended_and_taken_up_again() {
    let mut user = User::with_threads();
    user.at_once(|editor| editor.type_text(TEXT));
    user.settle();
    assert!(user.editor().player().is_some());
    let long = chain(600);
    user.at_once(|editor| editor.type_text(&long));
    user.wait_until("the work is not told", |user| user.sees("Stop"));
    assert!(user.editor().work().is_some());
    user.click_on("Stop");
    assert_eq!(user.editor().work(), None);
    // What was known is still there, and the text is as it was typed.
    assert!(user.editor().player().is_some());
    assert_eq!(user.text(), long);
    user.click_on("Analyse");
    user.wait_until("it is not taken up again", |user| user.sees("Stop"));
    user.click_on("Stop");
    // Other texts are analysed as before.
    user.at_once(|editor| editor.type_text(TEXT));
    user.settle();
    assert!(!user.sees("Analyse") && user.editor().player().is_some());
}
