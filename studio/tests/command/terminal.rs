//! What a stranger has named or written commands no terminal.

use crate::run::{Answer, FOUR_BAR, Folder, mech_in, repository};
use std::fs;

/// Names and texts that would command a terminal, or turn the direction of what is read.
const COMMANDS: [&str; 8] = [
    "\x1b]0;pwn\x07",
    "\x1b[2J",
    "\u{9b}31m",
    "\u{9d}0;pwn\u{9c}",
    "a\rb",
    "\u{8}\u{7f}",
    "\u{202e}hcem.a",
    "\u{2066}\u{200f}\u{61c}",
];

fn is_masked(text: &str) -> bool {
    !text.chars().any(|letter| {
        letter.is_control() && !matches!(letter, '\n' | '\t')
            || matches!(letter, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{200e}' | '\u{200f}' | '\u{61c}')
    })
}

#[track_caller]
fn shows_nothing(answer: &Answer, what: &str) {
    assert!(is_masked(&answer.err), "{what:?}: {:?}", answer.err);
    assert!(is_masked(&answer.out), "{what:?}: {:?}", answer.out);
}

#[test]
fn names_and_words_are_masked() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let here = folder.path("");
    for text in COMMANDS {
        for words in [
            &["check", text][..],
            &["check", "a.mech", "--mechanism", text],
            &["check", "a.mech", text],
            &["table", "a.mech", text],
            &["draw", "a.mech", "-o", text],
            &["table", "a.mech", "-o", &format!("nofolder/{text}")],
            &["import", text],
            &["run", text],
        ] {
            let answer = mech_in(&here, words);
            assert_ne!(answer.code, Some(0), "{words:?}");
            shows_nothing(&answer, text);
        }
        for line in [
            format!("open \"{text}\""),
            format!("save \"{text}.mech\""),
            format!("draw \"{text}.svg\""),
            format!("move {text} to (1, 2)"),
            text.to_owned(),
        ] {
            fs::write(folder.path("script.txt"), format!("open a.mech\n{line}")).expect("a script");
            shows_nothing(&folder.mech("run script.txt"), &line);
        }
    }
}

/// Each is masked by one character, so that marks stand below what they are about.
#[test]
fn lines_that_are_quoted_are_masked_and_marked_at_their_place() {
    for text in COMMANDS {
        let width = text.chars().count();
        let line = |text: &str| {
            format!("struct A; /* {text} */ link a; joint b = revolute(ground, c) at (0, 0);")
        };
        let folder = Folder::new().with("a.mech", line(text));
        let folder = folder.with("b.mech", line(&"x".repeat(width)));
        let answer = folder.mech("check a.mech");
        shows_nothing(&answer, text);
        let marks = |text: &str| {
            let lines = text.lines().filter(|line| line.contains('^'));
            lines.map(ToOwned::to_owned).collect::<Vec<_>>()
        };
        let expected = marks(&folder.mech("check b.mech").err);
        assert!(!expected.is_empty());
        assert_eq!(marks(&answer.err), expected, "{text:?}");
    }
}

/// Where no terminal shows it, a text is what the file has, byte for byte.
#[test]
fn a_text_that_is_piped_stays_as_it_is() {
    for text in COMMANDS {
        let text = format!("struct A; // {text}\n");
        let folder = Folder::new().with("a.mech", &text).with("script.txt", "open a.mech\ntext\n");
        assert_eq!(folder.mech("run script.txt").done(), text);
    }
}

/// Rust refuses comments in which the direction of what is read changes.
#[test]
fn the_name_of_an_imported_file_turns_no_comment() {
    let sample = repository("studio/tests/samples");
    let samples = fs::read_dir(sample).expect("samples");
    let sample = samples.map(|entry| entry.expect("an entry").path());
    let sample = sample.filter(|path| path.extension().is_some_and(|end| end == "linkage2"));
    let sample = fs::read(sample.min().expect("a sample")).expect("a file");
    for text in COMMANDS {
        let name = format!("a{text}.linkage2");
        let folder = Folder::new().with(&name, &sample);
        let answer = mech_in(&folder.path(""), &["import", &name, "-o", "a.rs", "-m", "A"]);
        shows_nothing(&answer, text);
        assert!(is_masked(&folder.text("a.rs")), "{text:?}");
    }
}
