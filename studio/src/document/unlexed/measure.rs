//! Slips of all kinds in the texts of the project.

use crate::document::{Document, Source, reading};
use crate::text::written;
use std::fs;
use std::ops::Range;
use std::path::Path;

/// The texts of the project whose mechanisms are right as they are written.
fn texts() -> Vec<String> {
    let mut folders = [
        "examples",
        "tests/cases",
        "tests/tests",
        "docs",
        "studio/src/editor/example",
        "studio/tests",
    ]
    .map(|folder| {
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("..")
            .join(folder)
    })
    .to_vec();
    let mut paths = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|end| end == "mech") {
                paths.push(path);
            }
        }
    }
    paths.sort();
    let texts = paths
        .iter()
        .map(|path| fs::read_to_string(path).expect("a text"));
    let is_right = |text: &String| {
        let document = Document::of(Source::new("a.mech", &**text));
        let declaration = document.declarations().first();
        declaration.is_some_and(|one| matches!(document.model(one), Ok(Some(_))))
    };
    texts.filter(is_right).collect()
}

/// Whether each byte of a text is code: no comment, and no part of a quoted text.
fn code(text: &str) -> Vec<bool> {
    let bytes = text.as_bytes();
    let mut code = vec![true; bytes.len()];
    let mut at = 0;
    while at < bytes.len() {
        let rest = &text.as_bytes()[at..];
        let find = |end: &str| {
            let found = rest[1..]
                .windows(end.len())
                .position(|found| found == end.as_bytes());
            found.map_or(rest.len(), |found| 1 + found + end.len())
        };
        let length = match rest {
            [b'/', b'/', ..] => find("\n"),
            [b'/', b'*', ..] => find("*/"),
            [b'"', ..] => find("\""),
            _ => 0,
        };
        code[at..at + length].fill(false);
        at += length.max(1);
    }
    code
}

/// The statement in which a byte stands. Those of a part are statements, too.
fn statement(text: &str, code: &[bool], start: usize, byte: usize) -> Range<usize> {
    let (mut start, mut depth, mut base) = (start, 0, 0);
    for (at, letter) in text
        .bytes()
        .enumerate()
        .skip(start)
        .filter(|(at, _)| code[*at])
    {
        match letter {
            b'{' if depth == base && text[start..at].trim_start().starts_with("part ") => {
                if at >= byte {
                    return start..at + 1;
                }
                (start, base) = (at + 1, base + 1);
                depth += 1;
            }
            b'(' | b'[' | b'{' => depth += 1,
            b')' | b']' | b'}' => depth -= 1,
            _ => {}
        }
        base = base.min(depth);
        if matches!(letter, b'}' | b';') && depth == base {
            if at >= byte {
                return start..at + 1;
            }
            start = at + 1;
        }
    }
    start..text.len()
}

/// The kinds of slips: what is written, and what instead of it.
fn kinds() -> Vec<(String, String)> {
    let brackets = [["(", "[", "{"], [")", "]", "}"]];
    let of_brackets = brackets.iter().flat_map(|kind| {
        kind.iter().flat_map(move |bracket| {
            let others = kind.iter().filter(move |other| *other != bracket);
            let others = others.map(|other| (*other).to_owned());
            let wrong = others.chain([String::new(), bracket.repeat(2)]);
            wrong.map(|wrong| ((*bracket).to_owned(), wrong))
        })
    });
    let others = [
        ("-", "−"),
        (" deg", "°"),
        ("->", "→"),
        (";", "；"),
        (" ", " /* "),
        (" ", " \""),
        (" ", "\u{200b} "),
    ];
    let others = others.map(|(right, wrong)| (right.to_owned(), wrong.to_owned()));
    of_brackets.chain(others).collect()
}

struct Slip {
    text: String,
    original: String,
    /// The statement in which it was made.
    statement: Range<usize>,
}

impl Slip {
    /// Makes one, at some place of a text.
    fn of(
        original: String,
        around: Around,
        kind: &(String, String),
        next: &mut impl FnMut(usize) -> usize,
    ) -> Option<Self> {
        let code = code(&original);
        let inside = around[0].len()..original.len() - around[1].len();
        let places = original.match_indices(&kind.0).map(|(at, _)| at);
        let places: Vec<usize> = places
            .filter(|at| code[*at] && inside.contains(at))
            .collect();
        let at = *places.get(next(places.len().max(1)))?;
        let statement = statement(&original[..inside.end], &code, inside.start, at);
        let statement = statement.start..statement.end + kind.1.len() - kind.0.len();
        let mut text = original.clone();
        text.replace_range(at..at + kind.0.len(), &kind.1);
        Some(Self {
            text,
            original,
            statement,
        })
    }

    /// Whether it is told within its statement, and whether its change gives the text back; none if there is no slip: the comment or
    /// the quote that it opens ends where another does.
    fn judge(&self, around: Around) -> Option<[bool; 2]> {
        let path = if around[0].is_empty() {
            "a.mech"
        } else {
            "a.rs"
        };
        let document = Document::of(Source::new(path, &*self.text));
        proc_macro2::extra::invalidate_current_thread_spans();
        let Err(found) = reading::lexed(&document, &document.declarations()[0]) else {
            let is_hidden = self.text.contains("*/") || self.text.matches('"').count() > 1;
            return (!is_hidden).then_some([false; 2]);
        };
        let is_placed =
            self.statement.start <= found.place.start && found.place.end <= self.statement.end;
        let letters = |text: &str| text.replace(char::is_whitespace, "");
        let after = found.change.map(|change| written(&self.text, &[change]));
        let is_back = after.is_some_and(|after| letters(&after) == letters(&self.original));
        if !(is_placed && is_back) {
            println!("{}\n{}\n", found.text, &self.text[self.statement.clone()]);
        }
        Some([is_placed, is_back])
    }
}

/// What stands around a text: nothing in a file of its own, or Rust.
type Around = [&'static str; 2];
const AROUND: [Around; 3] = [
    ["", ""],
    ["mechanism! {\n", "}\n\nfn main() {}\n"],
    ["fn main() {\n    mechanism! {\n", "    }\n}\n"],
];

fn placed(text: &str, [before, after]: Around) -> String {
    let space = "    ".repeat(before.matches('\n').count());
    let lines = text.lines().map(|line| format!("{space}{line}\n"));
    format!("{before}{}{after}", lines.collect::<String>())
}

/// Makes slips in right texts, and judges what is told of them: by where they were made, and by what the text was.
#[test]
fn slips_in_right_texts() {
    const OF_A_KIND: usize = 14;
    let texts = texts();
    let mut seed = 1_u64;
    let mut next = |most: usize| {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(seed >> 33).expect("31 bits") % most
    };
    let mut sums = [0; 3];
    println!("slip, instead of what: made, placed, given back");
    for kind in kinds() {
        let mut counts = [0; 3];
        for around in AROUND {
            let mut slips = std::iter::repeat_with(|| {
                let text = placed(&texts[next(texts.len())], around);
                Slip::of(text, around, &kind, &mut next)?.judge(around)
            });
            for [is_placed, is_back] in slips.by_ref().flatten().take(OF_A_KIND) {
                counts[0] += 1;
                counts[1] += usize::from(is_placed);
                counts[2] += usize::from(is_back);
            }
        }
        println!("`{}` `{}`: {counts:?}", kind.1, kind.0);
        let [made, placed, back] = counts;
        assert!(10 * placed >= 9 * made && 10 * back >= 9 * made, "{kind:?}");
        for (sum, count) in sums.iter_mut().zip(counts) {
            *sum += count;
        }
    }
    println!("all: {sums:?}");
    let [made, placed, back] = sums;
    assert!(100 * placed >= 99 * made && 100 * back >= 98 * made);
}
