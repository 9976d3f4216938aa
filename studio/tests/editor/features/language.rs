//! The words of the language. The compiler is asked at each place which it takes: of all that its source has in quotes, and of those that are
//! listed already, so that none leaves the list because its source is written otherwise.

use super::{files_in, text_of};
use mech_compiler::syntax::{Message, parse};
use proc_macro2::TokenStream;
use std::collections::BTreeSet;

const BEFORE: &str = "struct N_; param p_ = 1; gravity (0, -1);
link l_ { mass 1; } link m_ { point a_ = (0, 0); mass 1; }
joint j_ = revolute(ground, l_) at (0, 0); joint k_ = revolute(l_, m_) at (1, 0);
part P_(n_ = 1) { port f_; link w_ { point b_ = (0, 0); mass 1; }
joint o_ = revolute(f_, w_) at (0, 0); }\n";

/// The complaints about any word: that it should have been another, or that the one before should have ended there.
const USUAL: [&str; 7] = [
    "found `",
    "did you mean",
    "keyword of Rust",
    "a ratio has",
    "expected `;`",
    "expected `,`",
    "expected `)`",
];

/// All places, with each word that may stand there, and with each that is told what to write instead.
pub(super) fn words(list: &str) -> Vec<String> {
    let candidates = candidates(list);
    let (mut found, mut told) = (Vec::new(), BTreeSet::new());
    for place in include_str!("places.txt").lines() {
        // `~` stands for a word, `@` for a sign.
        let (before, after) = place.split_once(['~', '@']).expect(place);
        let is_for_word = place.contains('~');
        for word in candidates.iter().filter(|word| is_word(word) == is_for_word) {
            let text = format!("{before}{word}{after}");
            match answer(before, word, after, word) {
                None => found.push(text),
                Some(said) if said.is_empty() || told.contains(word) => {}
                said if said == answer(before, "zyx", after, word) => {}
                Some(_) => {
                    found.push(format!("{text} (told what to write)"));
                    // Elsewhere it is told the same.
                    told.insert(word);
                }
            }
        }
    }
    found
}

fn is_word(text: &str) -> bool {
    let is_part = |letter: char| letter == '_' || letter.is_alphanumeric();
    text.starts_with(char::is_alphabetic) && text.chars().all(is_part)
}

/// All that may be a word or a sign of the language.
fn candidates(list: &str) -> BTreeSet<String> {
    let listed = list.split("\n\n").next().unwrap_or_default();
    let separators = [' ', '\n', '(', ')', '{', '}', '[', ']', ';'];
    let mut texts = vec![listed.replace(separators, "\"")];
    for folder in ["mech-macros/compiler/src", "mech-runtime/core/src"] {
        texts.extend(files_in(folder, ".rs").iter().map(|path| text_of(path)));
    }
    let is_sign = |text: &str| text.chars().all(|letter| "+-*/%^:.=,>".contains(letter));
    let quoted = texts.iter().flat_map(|text| text.split('"'));
    // The names in the places end with `_`.
    let all = quoted.filter(|text| !text.is_empty() && !text.ends_with('_') && *text != "--");
    let all = all.filter(|text| is_word(text) || is_sign(text));
    all.map(str::to_owned).collect()
}

/// Nothing if a word may stand there. Otherwise the words of what is said of it, but one; none of these if that is said of any.
fn answer(before: &str, word: &str, after: &str, but: &str) -> Option<Vec<String>> {
    let begin = BEFORE.len() + before.len();
    let Ok(tokens) = format!("{BEFORE}{before}{word}{after}").parse::<TokenStream>() else {
        return Some(Vec::new());
    };
    let says = |error: &Message, what: &[&str]| what.iter().any(|what| error.text.contains(what));
    let error = parse(tokens).errors.into_iter().find(|error| {
        let (first, last) = (error.place.start.byte_range(), error.place.end.byte_range());
        let is_there = first.start < begin + word.len() && begin < last.end;
        is_there || says(error, &USUAL[4..])
    })?;
    let is_part = |letter: char| letter == '_' || letter.is_alphanumeric();
    let words = error.text.split(|letter| !is_part(letter));
    let others = words.filter(|&one| one != but && one != "zyx" && !says(&error, &USUAL));
    Some(others.map(str::to_owned).collect())
}
