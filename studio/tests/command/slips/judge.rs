//! How good one answer of the compiler is.

use super::corpus::{Correct, analyse};
use super::text::{Slip, Text};
use mech_compiler::model::Model;
use mech_compiler::structure::Diagnosis;
use mech_compiler::syntax::lexer::{Lexeme, Lexer, is_of_word};
use mech_studio::{Message, Remainder, mendings};
use std::ops::Range;
use std::time::{Duration, Instant};

/// What is true of an answer.
pub(super) struct Answer {
    /// What was said; none if the text was accepted.
    pub(super) said: Option<Said>,
    pub(super) check: Duration,
    pub(super) fix: Duration,
    pub(super) line: String,
}

pub(super) struct Said {
    /// The first message stands in the statement of the slip, or tells what was left out.
    pub(super) is_placed: bool,
    /// It is the only one.
    pub(super) is_single: bool,
    /// One of the first two repairs gives the text back.
    pub(super) is_mended: bool,
    /// So many repairs promise to be enough, and are not.
    pub(super) dishonest: usize,
    /// Where the first message stands, what it says, and what the repairs are.
    pub(super) words: String,
}

/// Judges the answer to a slip; none if it changes nothing.
pub(super) fn judge(correct: &Correct, slip: &Slip) -> Option<Answer> {
    if slip.text == correct.text {
        return None;
    }
    let start = Instant::now();
    let (document, reading) = analyse(&slip.text);
    let check = start.elapsed();
    let line = format!("{}: {}", correct.model.name, line(slip));
    let Err(faults) = &reading.result else {
        let is_same = without_places(&reading.model) == without_places(&correct.model);
        let (said, fix) = (None, Duration::ZERO);
        return (!is_same).then_some(Answer { said, check, fix, line });
    };
    let start = Instant::now();
    let found = mendings(&document, &document.declarations()[0], &reading);
    let fix = start.elapsed();
    let found = found.unwrap_or_else(|failure| panic!("{failure:?}\n{}", slip.text));
    let original = sorted(&correct.text);
    let promised = found.iter().filter(|one| one.remainder == Remainder::Nothing);
    let broken: Vec<&str> =
        promised.filter(|one| !is_enough(&one.text)).map(|one| &*one.words).collect();
    let first = &faults.messages[0];
    let repairs: Vec<&str> = found.iter().map(|one| &*one.words).take(2).collect();
    let words = format!(
        "{} messages, at `{}`: {}\n      repairs: {repairs:?} broken: {broken:?}",
        faults.messages.len(),
        shortened(&slip.text[first.place.clone()]),
        shortened(first.text.lines().next().unwrap_or("")),
    );
    let said = Some(Said {
        is_placed: is_placed(slip, first),
        is_single: faults.messages.len() == 1,
        is_mended: found.iter().take(2).any(|one| sorted(&one.text) == original),
        dishonest: broken.len(),
        words,
    });
    Some(Answer { said, check, fix, line })
}

/// The statements of a text, without spaces and comments, in any order.
fn sorted(text: &str) -> Vec<String> {
    let mut statements = vec![String::new()];
    for lexeme in Lexer::new(text, 0) {
        let word = &text[lexeme.start..lexeme.end];
        let last = statements.last_mut().expect("a statement");
        // Two words stay two, and two marks one.
        if word.starts_with(is_of_word) && last.ends_with(is_of_word) {
            last.push(' ');
        }
        last.push_str(word);
        if ";{}".contains(word) {
            statements.push(String::new());
        }
    }
    statements.sort();
    statements
}

/// Whether nothing is left to do, but to choose an assembly.
fn is_enough(text: &str) -> bool {
    let Err(faults) = analyse(text).1.result else {
        return true;
    };
    matches!(&faults.diagnoses[..], [Diagnosis::SeveralAssemblies { .. }])
}

/// A mechanism in words, but for the places of its words.
fn without_places(model: &Model) -> String {
    let model = format!("{model:?}");
    let parts = model.split("Origin(");
    parts.map(|part| part.trim_start_matches(|one: char| one.is_ascii_digit())).collect()
}

/// The statement around the slip, with its end.
fn statement(slip: &Slip) -> Range<usize> {
    let ends = Text::of(&slip.text).lexemes.into_iter();
    let ends: Vec<_> = ends.filter(|one| ";{}".contains(&slip.text[one.start..one.end])).collect();
    let before = ends.iter().rfind(|one| one.end <= slip.place.start);
    // Whole statements end where they end; a mark alone has statements on both sides.
    let is_after = |one: &&Lexeme| one.end >= slip.place.end && one.start > slip.place.start;
    let after = ends.iter().find(is_after);
    before.map_or(0, |one| one.end)..after.map_or(slip.text.len(), |one| one.end)
}

pub(super) fn is_placed(slip: &Slip, message: &Message) -> bool {
    let (place, statement) = (&message.place, statement(slip));
    let is_near = place.start < statement.end && statement.start < place.end;
    let is_whole =
        slip.text[..place.start].trim().is_empty() && slip.text[place.end..].trim().is_empty();
    let names = |text: &str| {
        let mut words = text.split(|one| !is_of_word(one));
        words.any(|word| slip.names.iter().any(|name| name == word))
    };
    !is_whole && (is_near || names(&message.text) || names(&slip.text[place.clone()]))
}

fn line(slip: &Slip) -> String {
    let start = slip.text[..slip.place.start].rfind('\n').map_or(0, |end| end + 1);
    let end = slip.text[slip.place.end..].find('\n');
    let end = end.map_or(slip.text.len(), |end| slip.place.end + end);
    let line = shortened(&slip.text[start..end]);
    if slip.names.is_empty() { line } else { format!("{line} <- {}", slip.names.join(" ")) }
}

fn shortened(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    let text = words.join(" ");
    match text.char_indices().nth(200) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}
