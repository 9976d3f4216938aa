//! Mangles texts as people, other programs and bad luck do.

use crate::corpus::Corpus;
use crate::pieces::{statements, words};
use fastrand::Rng;

/// Numbers at the ends of what numbers can be.
const NUMBERS: [&str; 20] = [
    "0",
    "-0",
    "0.0",
    "1",
    "-1",
    "0.5",
    "2",
    "3",
    "1e308",
    "-1e308",
    "1e-308",
    "5e-324",
    "1e15",
    "1e-15",
    "1e150",
    "2147483648",
    "18446744073709551616",
    "90 deg",
    "0.30000000000000004",
    "1.0000000000000002",
];

/// What looks like a number, and is none everywhere.
const NO_NUMBERS: [&str; 13] = [
    "1e309", "1e-400", "NaN", "inf", "-inf", "0x10", "1_000", "1f64", "1u8", "1e", "1.", ".5",
    "--1",
];

/// Characters that look like others, turn the direction of writing, take no room, or are several.
const STRANGE: [&str; 16] = [
    "\u{430}",
    "\u{2212}",
    "\u{202e}",
    "\u{2066}",
    "\u{200b}",
    "\u{feff}",
    "\u{301}",
    "\u{1f9d1}\u{200d}\u{1f527}",
    "\u{0}",
    "\u{7f}",
    "\u{2028}",
    "\u{ff1b}",
    "\u{df}",
    "\u{130}",
    "\u{10ffff}",
    "\r",
];

const BRACKETS: [(&str, &str); 5] =
    [("(", ")"), ("[", "]"), ("{", "}"), ("\"", "\""), ("/*", "*/")];

/// Longer texts are cut: what is long takes long, and finds no more.
const LONGEST: usize = 20_000;

/// One of the texts, after a few changes.
pub(crate) fn mangled(corpus: &Corpus, rng: &mut Rng) -> String {
    let mut text = corpus.text(rng).to_owned();
    let mut changes = 1;
    while changes < 12 && rng.u8(..) < 110 {
        changes += 1;
    }
    for _ in 0..changes {
        text = if rng.u8(..) < 80 {
            change_statement(&text, corpus, rng)
        } else if rng.u8(..) < 240 {
            change_word(&text, corpus, rng)
        } else {
            change_character(&text, rng)
        };
    }
    if text.len() > LONGEST {
        text.truncate(text.floor_char_boundary(LONGEST));
    }
    text
}

fn change_statement(text: &str, corpus: &Corpus, rng: &mut Rng) -> String {
    let ends = corpus.language.ends;
    let mut all = statements(text, ends);
    let other = corpus.text(rng);
    let others = statements(other, ends);
    if all.is_empty() || others.is_empty() {
        return other.to_owned();
    }
    let (at, to) = (rng.usize(..all.len()), rng.usize(..all.len()));
    let taken = others[rng.usize(..others.len())];
    match rng.u8(..8) {
        0 => all.insert(to, all[at]),
        1 => drop(all.remove(at)),
        2 => all.swap(at, to),
        3 => all.insert(at, taken),
        4 => all[at] = taken,
        5 => all.truncate(at),
        6 => {
            for _ in 0..rng.usize(1..12) {
                all.insert(at, all[at]);
            }
        }
        // The beginning of one, the end of another.
        _ => {
            all.truncate(at);
            all.extend(&others[rng.usize(..others.len())..]);
        }
    }
    all.concat()
}

fn change_word(text: &str, corpus: &Corpus, rng: &mut Rng) -> String {
    let all = words(text);
    if all.is_empty() {
        return corpus.text(rng).to_owned();
    }
    let is_number = |word: &str| word.starts_with(|first: char| first.is_ascii_digit());
    // Blanks say little, and numbers much.
    let numbers: Vec<usize> = (0..all.len()).filter(|at| is_number(all[*at])).collect();
    let mut at = if numbers.is_empty() || rng.bool() {
        rng.usize(..all.len())
    } else {
        numbers[rng.usize(..numbers.len())]
    };
    if all[at].trim().is_empty() && at + 1 < all.len() {
        at += 1;
    }
    // Mostly, a number takes the place of a number, and a name that of a name: more of the text is understood then.
    let is_name = |word: &str| word.starts_with(|first: char| first.is_alphabetic());
    let alike = |other: &&&str| is_name(all[at]) && is_name(other) && **other != all[at];
    let likes: Vec<&str> = all.iter().filter(alike).copied().collect();
    let is_gentle = rng.u8(..) < 190;
    let gentle = if is_number(all[at]) {
        Some(number(all[at], rng))
    } else if likes.is_empty() {
        None
    } else {
        Some(likes[rng.usize(..likes.len())].to_owned())
    };
    let mut all: Vec<String> = all.into_iter().map(str::to_owned).collect();
    if let Some(gentle) = gentle.filter(|_| is_gentle) {
        all[at] = gentle;
        return all.concat();
    }
    let other = all[rng.usize(..all.len())].clone();
    let known = corpus.language.words;
    let known = known[rng.usize(..known.len())].to_owned();
    match rng.u8(..11) {
        0 => drop(all.remove(at)),
        1 => all.insert(at, other),
        2..=4 => all[at] = other,
        5 => all[at] = known,
        6 => all.insert(at, format!(" {known} ")),
        7 => corpus.word(rng).clone_into(&mut all[at]),
        8 => {
            let (open, close) = BRACKETS[rng.usize(..BRACKETS.len())];
            let depth = if rng.u8(..) < 200 { 1 } else { rng.usize(1..24) };
            all[at] = format!("{}{}{}", open.repeat(depth), all[at], close.repeat(depth));
        }
        9 => {
            let length = rng.usize(1..300);
            all[at] = all[at].repeat(length.div_ceil(all[at].len()));
        }
        _ => all[at] += STRANGE[rng.usize(..STRANGE.len())],
    }
    all.concat()
}

/// Another number: one that is near, or one at the ends of what numbers can be.
fn number(word: &str, rng: &mut Rng) -> String {
    match (word.parse::<f64>(), rng.u8(..12)) {
        (Ok(value), 0) => format!("{}", -value),
        (Ok(value), 1) => format!("{}", 2.0 * value),
        (Ok(value), 2..=5) => format!("{}", value + rng.f64() - 0.5),
        (Ok(value), 6) => format!("{}", value * (1.0 + 1e-9 * rng.f64())),
        (_, 7) => NO_NUMBERS[rng.usize(..NO_NUMBERS.len())].to_owned(),
        _ => NUMBERS[rng.usize(..NUMBERS.len())].to_owned(),
    }
}

fn change_character(text: &str, rng: &mut Rng) -> String {
    let mut all: Vec<char> = text.chars().collect();
    if all.is_empty() {
        return STRANGE[rng.usize(..STRANGE.len())].to_owned();
    }
    let at = rng.usize(..all.len());
    match rng.u8(..5) {
        0 => drop(all.remove(at)),
        1 => all[at] = char::from(rng.u8(..128)),
        2 => all.insert(at, char::from(rng.u8(..128))),
        3 => all[at] = rng.char(..),
        _ => all[at] = char::from_u32(u32::from(all[at]) ^ (1 << rng.u8(..7))).unwrap_or('?'),
    }
    all.into_iter().collect()
}
