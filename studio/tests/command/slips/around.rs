//! Slips of brackets and signs alone, in files of their own and in Rust: where they are told, and whether the first repair takes them back.

use super::corpus;
use super::dice::Dice;
use super::text::Text;
use mech_studio::{Document, Source, mendings};
use std::ops::Range;

/// The longest text, in bytes: repairs of longer ones take seconds.
const LONGEST: usize = 1500;

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

/// Whether a byte stands in no comment.
fn is_code(text: &Text<'_>, at: usize) -> bool {
    let next = text.lexemes.partition_point(|one| one.end <= at);
    let start = text.lexemes.get(next);
    let start = start.map_or(text.text.len(), |one| one.start);
    let end = next.checked_sub(1).map_or(0, |one| text.lexemes[one].end);
    start <= at || text.text[end..start].trim().is_empty()
}

/// The statement in which a byte stands, with the space before it. Those of a part are statements, too.
fn statement(text: &Text<'_>, inside: &Range<usize>, at: usize) -> Range<usize> {
    let all = text.statements().into_iter();
    let all = all.filter(|one| !text.is(one.start, "part"));
    let all: Vec<Range<usize>> = all.map(|one| text.bytes(one)).collect();
    let is_within = |one: &Range<usize>| inside.start <= one.start && one.end <= inside.end;
    let ends = all.iter().filter(|one| is_within(one)).filter(|one| {
        let is_around = |other: &&Range<usize>| other.start < one.start && one.end <= other.end;
        !all.iter().filter(|other| is_within(other)).any(|other| is_around(&other))
    });
    let mut ends: Vec<usize> = ends.map(|one| one.end).collect();
    ends.sort_unstable();
    let next = ends.partition_point(|end| *end <= at);
    let before = next.checked_sub(1).map_or(inside.start, |one| ends[one]);
    before..ends.get(next).copied().unwrap_or(inside.end)
}

/// Makes a slip at some place of a text. Tells whether its first message stands within its statement, and whether its first repair gives the
/// text back; none if there is no slip: the comment or the quote that it opens ends where another does.
fn judge(
    original: &str,
    around: Around,
    kind: &(String, String),
    dice: &mut Dice,
) -> Option<[bool; 2]> {
    let whole = Text::of(original);
    let inside = around[0].len()..original.len() - around[1].len();
    let places = original.match_indices(&kind.0).map(|(at, _)| at);
    let places: Vec<usize> =
        places.filter(|at| inside.contains(at) && is_code(&whole, *at)).collect();
    let at = *places.get(dice.below(places.len().max(1)))?;
    let statement = statement(&whole, &inside, at);
    let statement = statement.start..statement.end + kind.1.len() - kind.0.len();
    let mut text = original.to_owned();
    text.replace_range(at..at + kind.0.len(), &kind.1);
    let path = if around[0].is_empty() { "a.mech" } else { "a.rs" };
    let document = Document::of(Source::new(path, &*text));
    let declaration = &document.declarations()[0];
    let reading = document.analyse(declaration).expect("the compiler works");
    if !reading.model.name.is_empty() {
        let is_hidden = text.contains("*/") || text.matches('"').count() > 1;
        return (!is_hidden).then_some([false; 2]);
    }
    let faults = reading.result.as_ref().expect_err("a fault");
    let place = &faults.messages[0].place;
    let is_placed = statement.start <= place.start && place.end <= statement.end;
    let found = mendings(&document, declaration, &reading).expect("the compiler works");
    let letters = |text: &str| text.replace(char::is_whitespace, "");
    let is_back = found.first().is_some_and(|one| letters(&one.text) == letters(original));
    if !(is_placed && is_back) {
        println!("{}\n{}\n", faults.messages[0].text, &text[statement]);
    }
    Some([is_placed, is_back])
}

#[test]
fn brackets_and_signs_are_told_where_they_are_wrong() {
    const OF_A_KIND: usize = 14;
    let mut texts = corpus::read();
    texts.retain(|one| one.text.len() < LONGEST);
    let mut dice = Dice::new(1);
    let mut sums = [0; 3];
    println!("slip, instead of what: made, placed, given back");
    for kind in kinds() {
        let mut counts = [0; 3];
        for around in AROUND {
            let mut slips = std::iter::repeat_with(|| {
                let text = placed(&dice.pick(&texts).text, around);
                judge(&text, around, &kind, &mut dice)
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
