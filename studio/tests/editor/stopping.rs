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

/// A short text of many legs, whose analysis takes its time: a frame that shows it takes none.
fn legs(count: usize) -> String {
    format!(
        "struct Legs;
        part Leg(phase = 0 deg) {{
            port frame {{ point hip = (4, 0.5); }}
            port crank {{ point pin = (1, 0) turned phase; }}
            link coupler {{ point pin = (0, 0); point knee = (3.2, 0); }}
            link rocker {{ point hip = (0, 0); point knee = (0, 2.5); }}
            joint pin = revolute(crank.pin, coupler.pin);
            joint knee = revolute(coupler.knee, rocker.knee);
            joint hip = revolute(frame.hip, rocker.hip);
            start {{ rocker near 0 deg; }}
        }}
        ground {{ point shaft = (0, 0); }}
        link axle {{ point shaft = (0, 0); }}
        joint main = revolute(ground.shaft, axle.shaft);
        motor main;
        use l[{count}]: Leg(phase = k * 0.36 deg) {{ frame = ground, crank = axle }};
"
    )
}

/// Ends such work while it is done: it cannot have been done at once.
fn stop(user: &mut User, work: &str) {
    user.wait_until("the work is not told", |user| user.sees("Stop"));
    let told = user.editor().work().expect("it is being done");
    assert!(told.contains(work), "{told}");
    user.click_on("Stop");
    assert_eq!(user.editor().work(), None);
}

#[test]
fn an_analysis_is_ended_and_taken_up_again() {
    let mut user = User::with_threads();
    user.at_once(|editor| editor.type_text(TEXT));
    user.settle();
    assert!(user.editor().player().is_some());
    let long = legs(990);
    user.at_once(|editor| editor.type_text(&long));
    stop(&mut user, "Analysing");
    // What was known is still there, and the text is as it was typed.
    assert!(user.editor().player().is_some());
    assert_eq!(user.text(), long);
    user.click_on("Analyse");
    stop(&mut user, "Analysing");
    // Other texts are analysed as before.
    user.at_once(|editor| editor.type_text(TEXT));
    user.settle();
    assert!(!user.sees("Analyse") && user.editor().player().is_some());
}

#[test]
fn a_line_is_ended_that_takes_its_time() {
    let mut user = User::with_threads();
    let long = legs(990);
    user.at_once(|editor| editor.type_text(&long));
    stop(&mut user, "Analysing");
    let lines = [("point axle.tip at (1, 0)", "Trying"), ("check", "Answering: check")];
    for (line, work) in lines {
        user.at_once(|editor| editor.say(line));
        stop(&mut user, work);
        assert_eq!(user.text(), long, "{line}");
        assert!(user.editor().player().is_none());
    }
    // Lines take their turns as before.
    user.at_once(|editor| editor.type_text(TEXT));
    user.at_once(|editor| {
        editor.say("link one_more");
        editor.say("undo");
        editor.say("link another");
    });
    user.settle();
    assert!(user.text().contains("another") && !user.text().contains("one_more"));
}

#[test]
fn arrows_come_when_what_they_need_is_known() {
    let mut user = User::with_threads();
    // Their painting would take most of the time.
    user.show("Bodies");
    user.at_once(|editor| editor.type_text(&chain(120)));
    user.wait_until("it does not play", |user| user.editor().player().is_some());
    assert!(user.editor().arrows().is_empty());
    for _ in 0..2 {
        user.show("Velocities");
        user.wait_until("there are no arrows", |user| !user.editor().arrows().is_empty());
        user.show("Velocities");
        user.wait_until("arrows stay", |user| user.editor().arrows().is_empty());
    }
}
