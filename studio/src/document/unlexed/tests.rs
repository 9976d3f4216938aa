use super::{Unlexed, slip};
use crate::document::Source;
use crate::text::written;
use mech_compiler::syntax;
use proc_macro2::TokenStream;

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
        ("60 deg;", "60° ;", "°", "`°` is no sign of the keyboard; write `deg`"),
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
        ("arm {", "arm", "point", "expected `{` before `point`: the `}` after it closes nothing"),
        ("(0, 0);", "(0, 0));", ")", "this `)` closes nothing; remove it"),
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
        ("(-1", "(−1", "−", "`−` is not the minus of the keyboard; write `-`"),
        ("->", "→", "→", "`→` is no sign of the keyboard; write `->`"),
        ("(0, 0);", "(0, 0); \"", "\"", "this `\"` opens a text that nothing closes; remove it"),
        (
            "(0, 0);",
            "(0, 0); /* why",
            "/*",
            "this `/*` opens a comment that nothing closes; write `*/` at the end of this line",
        ),
        ("(0, 0);", "(0, /* 0);", "/*", "this `/*` opens a comment that nothing closes; remove it"),
        ("(0, 0);", "(0, 0); '", "'", "this `'` opens a letter that nothing closes; remove it"),
        (
            "(0, 0);",
            "(0, 0);\u{200b}",
            "\u{200b}",
            "a sign without width stands here, U+200B; remove it",
        ),
        ("(0, 0);", "(0, 0x);", "0x", "`0x` is no number"),
        ("(0, 0);", "(0, 0); \\", "\\", "`\\\\` has no meaning here; remove it"),
    ] {
        // In the last statement that has it: `(0, 0);` stands in a joint.
        let at = TEXT.rfind(right).expect("it is there");
        let text = format!("{}{wrong}{}", &TEXT[..at], &TEXT[at + right.len()..]);
        let slip = found(&text);
        assert_eq!((&text[slip.place.clone()], &*slip.text), (place, words), "{wrong}");
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
        slip.text.ends_with("note: 2 more signs of this text are not on the keyboard"),
        "{}",
        slip.text
    );
    let change = slip.change.expect("a change");
    assert_eq!(change.text, "-30 deg ..= 60 deg");
}
