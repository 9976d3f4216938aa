//! Slips in marks, brackets and numbers.

use super::Make;
use super::dice::Dice;
use super::text::{Slip, Text};
use mech_compiler::syntax::lexer::Kind;

#[rustfmt::skip]
pub(super) const KINDS: &[(&str, Make)] = &[
    ("`;` missing", |text, dice| swap(text, dice, ";", &[""])),
    ("`;` doubled", |text, dice| swap(text, dice, ";", &[";;"])),
    ("`,` missing", |text, dice| swap(text, dice, ",", &[""])),
    ("`,` doubled", |text, dice| swap(text, dice, ",", &[",,"])),
    ("`;` and `,` exchanged", |text, dice| {
        let other = if dice.once_in(2) { [";", ","] } else { [",", ";"] };
        swap(text, dice, other[0], &other[1..])
    }),
    ("bracket lost", |text, dice| bracket(text, dice, |_, _| String::new())),
    ("bracket doubled", |text, dice| bracket(text, dice, |old, _| [old, old].concat())),
    ("bracket of another kind", |text, dice| {
        bracket(text, dice, |old, dice| {
            let all = if "([{".contains(old) { ["(", "[", "{"] } else { [")", "]", "}"] };
            let others = all.into_iter().filter(|one| *one != old);
            (*dice.pick(&others.collect::<Vec<_>>())).to_owned()
        })
    }),
    ("sign from a word processor", |text, dice| {
        let signs: [[&str; 2]; 4] = [["-", "−"], ["-", "–"], ["->", "→"], ["*", "×"]];
        let [old, new] = *dice.pick(&signs);
        let is_arrow = |one| text.is(one, "->");
        text.exchange(dice, (&[old], &[new]), |one| old == "->" || !is_arrow(one))
    }),
    ("`°` for `deg`", |text, dice| swap(text, dice, "deg", &["°"])),
    ("`=` exchanged", |text, dice| text.exchange(dice, (&["="], &[":", "", "==", ":="]), |one| !text.is(one - 1, "."))),
    ("`:` exchanged", |text, dice| {
        let is_path = |one: usize| text.is(one, "::") || text.is(one - 1, "::");
        text.exchange(dice, (&[":"], &["=", ";", "", "::"]), |one| !is_path(one) && !text.is_number(one - 1))
    }),
    ("`->` exchanged", |text, dice| swap(text, dice, "->", &["=>", "-", ">", ",", "→", "to"])),
    ("`..=` exchanged", |text, dice| swap(text, dice, "..=", &["..", "...", "to", "-", ",", "=.."])),
    ("`.` of a path exchanged", |text, dice| {
        let is_path = |one| text.is_name(one - 1) && text.is_name(one + 1);
        text.exchange(dice, (&["."], &[",", ":", "::", "->", " ", "_"]), is_path)
    }),
    ("decimal comma", |text, dice| {
        let is_number = |one| text.is_number(one - 1) && !text.is(one, "..");
        text.exchange(dice, (&["."], &[","]), is_number)
    }),
    ("`#` for a comment", |text, dice| {
        let all = text.statements();
        let end = text.bytes(dice.pick(&all).clone()).end;
        Some(text.with(end..end, " # to be measured\n"))
    }),
    ("`deg` left out", |text, dice| swap(text, dice, "deg", &[""])),
    ("`deg` on a length", |text, dice| unit(text, dice, &[" deg"])),
    ("unit of a length", |text, dice| unit(text, dice, &[" cm", " mm", "cm", "mm", " m"])),
    ("unit of an angle", |text, dice| swap(text, dice, "deg", &["rad", "degrees", "degree", "grad"])),
    ("ratio with another mark", |text, dice| text.exchange(dice, (&[":"], &["/", ",", "to"]), |one| text.is_number(one - 1))),
    ("ratio of one number", |text, dice| {
        let is_ratio = |one: usize| text.is_number(one - 1) && text.is_number(one + 1);
        let index = text.find(dice, |one| text.is(one, ":") && is_ratio(one))?;
        let start = text.lexemes[index].start;
        Some(text.with(start..text.end_of_number(index + 1), ""))
    }),
    ("coordinates with names", |text, dice| {
        let index = text.find(dice, |one| is_place(text, one))?;
        let numbers = &text.text[text.bytes(index + 1..text.partner(index)?)];
        let numbers = format!("x = {}", numbers.replacen(", ", ", y = ", 1));
        Some(text.instead(index + 1..text.partner(index)?, &numbers))
    }),
    ("point of three numbers", |text, dice| {
        let index = text.find(dice, |one| is_place(text, one))?;
        let end = text.lexemes[text.partner(index)?].start;
        Some(text.with(end..end, ", 0"))
    }),
    ("place without brackets", |text, dice| {
        let index = text.find(dice, |one| is_place(text, one))?;
        let inside = index + 1..text.partner(index)?;
        let numbers = &text.text[text.bytes(inside.clone())];
        Some(text.instead(index..inside.end + 1, numbers))
    }),
    ("comment without an end", |text, dice| {
        let index = text.find(dice, |one| text.is_head(one))?;
        let start = text.lexemes[index].start;
        Some(text.with(start..start, "/* to be measured "))
    }),
    ("point of one number", |text, dice| {
        let index = text.find(dice, |one| is_place(text, one))?;
        let comma = (index..text.partner(index)?).find(|&one| text.is(one, ","))?;
        Some(text.instead(comma..text.partner(index)?, ""))
    }),
];

fn swap(text: &Text<'_>, dice: &mut Dice, old: &str, news: &[&str]) -> Option<Slip> {
    text.exchange(dice, (&[old], news), |_| true)
}

/// Writes a bracket otherwise. A message may stand anywhere between it and its partner.
fn bracket(text: &Text<'_>, dice: &mut Dice, other: fn(&str, &mut Dice) -> String) -> Option<Slip> {
    let is_bracket = |one: usize| matches!(text.lexemes[one].kind, Kind::Open | Kind::Close);
    let index = text.find(dice, is_bracket)?;
    let other = other(text.word(index), dice);
    let mut slip = text.instead(index..index + 1, &other);
    let partner = &text.lexemes[text.partner(index)?];
    let end = (partner.end + other.len()).max(slip.place.end + 1) - 1;
    slip.place = slip.place.start.min(partner.start)..end;
    Some(slip)
}

/// Whether a pair of numbers begins there, in a link or after `at`.
fn is_place(text: &Text<'_>, index: usize) -> bool {
    let is_before = |one: usize| text.is(one, "at") || text.is(one, "=");
    let has_comma = |end| (index..end).filter(|&one| text.is(one, ",")).count() == 1;
    index > 0
        && text.is(index, "(")
        && is_before(index - 1)
        && text.partner(index).is_some_and(has_comma)
}

/// Writes a unit behind a coordinate.
fn unit(text: &Text<'_>, dice: &mut Dice, units: &[&str]) -> Option<Slip> {
    let is_length = |one: usize| one > 0 && is_place(text, one - 1) && text.is_number(one);
    let end = text.end_of_number(text.find(dice, is_length)?);
    Some(text.with(end..end, dice.pick::<&str>(units)))
}
