use super::{Unlexed, slip};
use crate::document::{Document, Source, reading};
use crate::text::written;
use mech_compiler::syntax;
use proc_macro2::TokenStream;
use std::fmt::Write;
use std::ops::Range;
use std::path::Path;
use std::{env, fs};

fn found(text: &str) -> Unlexed {
    let faults = |text: &str| {
        let tokens: TokenStream = text.parse().ok()?;
        Some(syntax::parse(tokens).errors.len())
    };
    let error = text.parse::<TokenStream>().expect_err("a slip");
    let at = error.span().byte_range().start;
    slip(&Source::new("a.mech", text), &(0..text.len()), at, &faults)
}

/// The original of the texts below.
const TEXT: &str = "struct A;
link arm { point tip = (2, 0) -> (-1, 0); }
link rod { polygon [(0, 0), (1, 0), (1, 1)]; }
joint a = revolute(ground, arm) at (0, 0);
joint b = revolute(arm.tip, rod) at (2, 0);
motor a in -30 deg ..= 60 deg;
";

#[test]
fn slips_and_their_words() {
    for (right, wrong, place, words) in [
        (
            "tip = (2, 0)",
            "tip = (2, 0",
            "->",
            "expected `)` before `->`: the `(` in line 2, column 24, is still open",
        ),
        (
            "60 deg;",
            "60° ;",
            "°",
            "`°` is no sign of the keyboard; write `deg`",
        ),
        (
            "(0, 0);",
            "(0, 0;",
            ";",
            "expected `)` before `;`: the `(` in line 4, column 36, is still open",
        ),
        (
            "arm) at",
            "arm at",
            "at",
            "expected `)` before `at`: the `(` in line 4, column 19, is still open",
        ),
        (
            "(1, 1)];",
            "(1, 1);",
            ";",
            "expected `]` before `;`: the `[` in line 3, column 20, is still open",
        ),
        (
            "0); }",
            "0);",
            ";",
            "expected `}` after `;`: the `{` in line 2, column 10, is still open",
        ),
        ("arm {", "arm {{", "{", "nothing closes this `{`; remove it"),
        (
            "arm {",
            "arm",
            "point",
            "expected `{` before `point`: the `}` after it closes nothing",
        ),
        (
            "(0, 0);",
            "(0, 0));",
            ")",
            "this `)` closes nothing; remove it",
        ),
        (
            "(0, 0);",
            "(0, 0];",
            "]",
            "`]` does not close the `(` in line 4, column 36, which is open here; write `)`",
        ),
        (
            "(0, 0);",
            "[0, 0);",
            "[",
            "`[` is not the bracket that the `)` in line 4, column 41, closes; write `(`",
        ),
        (
            "(-1",
            "(−1",
            "−",
            "`−` is not the minus of the keyboard; write `-`",
        ),
        ("->", "→", "→", "`→` is no sign of the keyboard; write `->`"),
        (
            "(0, 0);",
            "(0, 0); \"",
            "\"",
            "this `\"` opens a text that nothing closes; remove it",
        ),
        (
            "(0, 0);",
            "(0, 0); /* why",
            "/*",
            "this `/*` opens a comment that nothing closes; write `*/` at the end of this line",
        ),
        (
            "(0, 0);",
            "(0, /* 0);",
            "/*",
            "this `/*` opens a comment that nothing closes; remove it",
        ),
        (
            "(0, 0);",
            "(0, 0); '",
            "'",
            "this `'` opens a letter that nothing closes; remove it",
        ),
        (
            "(0, 0);",
            "(0, 0);\u{200b}",
            "\u{200b}",
            "a sign without width stands here, U+200B; remove it",
        ),
        ("(0, 0);", "(0, 0x);", "0x", "`0x` is no number"),
        (
            "(0, 0);",
            "(0, 0); \\",
            "\\",
            "`\\\\` has no meaning here; remove it",
        ),
    ] {
        // In the last statement that has it: `(0, 0);` stands in a joint.
        let at = TEXT.rfind(right).expect("it is there");
        let text = format!("{}{wrong}{}", &TEXT[..at], &TEXT[at + right.len()..]);
        let slip = found(&text);
        assert_eq!(
            (&text[slip.place.clone()], &*slip.text),
            (place, words),
            "{wrong}"
        );
        let Some(change) = slip.change else {
            assert_eq!(wrong, "(0, 0x);");
            continue;
        };
        let after = written(&text, &[change]);
        assert!(after.parse::<TokenStream>().is_ok(), "{after}");
        let letters = |text: &str| text.replace(char::is_whitespace, "");
        let kept = wrong.contains("why");
        assert!(kept || letters(&after) == letters(TEXT), "{wrong}: {after}");
    }
}

#[test]
fn all_signs_at_once() {
    let slip = found("struct A;\nmotor a in −30° ..= 60°;");
    assert!(
        slip.text
            .ends_with("note: 2 more signs of this text are not on the keyboard"),
        "{}",
        slip.text
    );
    let change = slip.change.expect("a change");
    assert_eq!(change.text, "-30 deg ..= 60 deg");
}

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
        if letter == b'}' && depth == base || letter == b';' && depth == base {
            if at >= byte {
                return start..at + 1;
            }
            start = at + 1;
        }
    }
    start..text.len()
}

/// The kinds of slips: what is written, and what instead of it.
const KINDS: [(&str, &str); 31] = [
    ("(", ""),
    (")", ""),
    ("[", ""),
    ("]", ""),
    ("{", ""),
    ("}", ""),
    ("(", "(("),
    (")", "))"),
    ("[", "[["),
    ("]", "]]"),
    ("{", "{{"),
    ("}", "}}"),
    ("(", "["),
    (")", "]"),
    ("[", "{"),
    ("]", "}"),
    ("{", "("),
    ("}", ")"),
    ("(", "{"),
    (")", "}"),
    ("[", "("),
    ("]", ")"),
    ("{", "["),
    ("}", "]"),
    ("-", "−"),
    (" deg", "°"),
    ("->", "→"),
    (" ", " /* "),
    (" ", " \""),
    ("(", "（"),
    (";", "；"),
];

/// Makes slips in right texts, and judges what is said of them: by where they were made, and by what the text was.
#[test]
fn slips_in_all_texts() {
    const OF_A_KIND: usize = 40;
    let texts = texts();
    let mut seed = 1_u64;
    let mut next = |most: usize| {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(seed >> 33).expect("31 bits") % most
    };
    let mut table = String::new();
    let mut all = [0; 3];
    for in_rust in [false, true] {
        for (right, wrong) in KINDS {
            let mut counts = [0; 3];
            for _ in 0..50 * OF_A_KIND {
                if counts[0] == OF_A_KIND {
                    break;
                }
                let mut text = texts[next(texts.len())].clone();
                if in_rust {
                    let lines = text.lines().map(|line| format!("    {line}\n"));
                    text = format!(
                        "mechanism! {{\n{}}}\n\nfn main() {{}}\n",
                        lines.collect::<String>()
                    );
                }
                let code = code(&text);
                let places = text
                    .match_indices(right)
                    .map(|(at, _)| at)
                    .filter(|at| code[*at]);
                let inside = if in_rust {
                    12..text.len() - 17
                } else {
                    0..text.len()
                };
                let places: Vec<usize> = places.filter(|at| inside.contains(at)).collect();
                let Some(&at) = places.get(next(places.len().max(1))) else {
                    continue;
                };
                let mut range = statement(&text[..inside.end], &code, inside.start, at);
                let original = text.clone();
                text.replace_range(at..at + right.len(), wrong);
                range.end = range.end + wrong.len() - right.len();
                let document =
                    Document::of(Source::new(if in_rust { "a.rs" } else { "a.mech" }, &*text));
                let declaration = &document.declarations()[0];
                proc_macro2::extra::invalidate_current_thread_spans();
                let Err(slip) = reading::lexed(&document, declaration) else {
                    continue;
                };
                counts[0] += 1;
                let is_placed = range.start <= slip.place.start && slip.place.end <= range.end;
                counts[1] += usize::from(is_placed);
                let after = slip.change.map(|change| written(&text, &[change]));
                let letters = |text: &str| text.replace(char::is_whitespace, "");
                let is_back = after
                    .as_ref()
                    .is_some_and(|after| letters(after) == letters(&original));
                counts[2] += usize::from(is_back);
                if env::var_os("SLIPS").is_some() && !(is_placed && is_back) {
                    let after = after.map(|after| {
                        after[range.start.min(after.len())..]
                            .chars()
                            .take(150)
                            .collect::<String>()
                    });
                    println!(
                        "== {right} {wrong} {is_placed} {is_back}: {}\n{}\n{after:?}\n",
                        slip.text, &text[range]
                    );
                }
            }
            writeln!(table, "{in_rust} {right:>5} {wrong:>5} {counts:?}").expect("a text");
            for (sum, count) in all.iter_mut().zip(counts) {
                *sum += count;
            }
        }
    }
    println!("{table}{all:?}");
}
