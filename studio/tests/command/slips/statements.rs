//! Slips that concern whole statements, and what a joint joins.

use super::Make;
use super::dice::Dice;
use super::text::{Slip, Text};
use std::ops::Range;

pub(super) const KINDS: &[(&str, Make)] = &[
    ("`link a, b;`", |text, dice| {
        let is_bare = |one: &Range<usize>| one.len() == 3;
        let first = text.statement(dice, &["link"], |one| {
            is_bare(one) && text.is(one.end, "link") && text.is(one.end + 2, ";")
        })?;
        Some(text.instead(first.end - 1..first.end + 1, ","))
    }),
    ("joint forgotten", |text, dice| {
        forget(text, dice, &["joint"])
    }),
    ("link forgotten", |text, dice| forget(text, dice, &["link"])),
    ("point forgotten", |text, dice| {
        forget(text, dice, &["point", "line"])
    }),
    ("const forgotten", |text, dice| {
        forget(text, dice, &["const", "param"])
    }),
    ("motor forgotten", |text, dice| {
        forget(text, dice, &["motor"])
    }),
    ("ground forgotten", |text, dice| {
        forget(text, dice, &["ground"])
    }),
    ("motor twice", |text, dice| double(text, dice, &["motor"])),
    ("name twice", |text, dice| {
        double(
            text,
            dice,
            &["link", "joint", "point", "line", "const", "param"],
        )
    }),
    ("joint pasted under another name", |text, dice| {
        let joint = text.statement(dice, &["joint"], |_| true)?;
        let line = &text.text[text.bytes(joint.clone())];
        let name = text.word(joint.start + 1);
        let copy = line.replacen(name, &format!("{name}2"), 1);
        let end = text.bytes(joint).end;
        Some(text.with(end..end, &format!("\n{copy}")))
    }),
    ("joint with itself", |text, dice| {
        let [first, second] = ends(text, dice)?;
        let other = &text.text[text.bytes(first)];
        Some(text.instead(second, other))
    }),
    ("third link in a joint", |text, dice| {
        let [_, second] = ends(text, dice)?;
        let link = text.find(dice, |one| one > 0 && text.is(one - 1, "link"))?;
        let end = text.bytes(second).end;
        Some(text.with(end..end, &format!(", {}", text.word(link))))
    }),
    ("another link in a joint", |text, dice| {
        let ends = ends(text, dice)?;
        let end = dice.pick(&ends).clone();
        let is_other = |one: usize| {
            one > 0 && text.is(one - 1, "link") && text.word(one) != text.word(end.start)
        };
        let link = text.find(dice, is_other)?;
        Some(text.instead(end.start..end.start + 1, text.word(link)))
    }),
    ("another kind of joint", |text, dice| {
        text.exchange(
            dice,
            (&["revolute"], &["prismatic", "gear", "slot"]),
            |_| true,
        )
    }),
];

/// Leaves one of the statements with these first words out.
fn forget(text: &Text<'_>, dice: &mut Dice, heads: &[&str]) -> Option<Slip> {
    let left_out = text.statement(dice, heads, |_| true)?;
    let names = text.names(left_out.clone());
    Some(text.instead(left_out, "").told_by(names))
}

/// Writes one of the statements with these first words twice.
fn double(text: &Text<'_>, dice: &mut Dice, heads: &[&str]) -> Option<Slip> {
    let doubled = text.statement(dice, heads, |_| true)?;
    let names = text.names(doubled.clone());
    let place = text.bytes(doubled);
    let copy = format!("\n{}", &text.text[place.clone()]);
    Some(text.with(place.end..place.end, &copy).told_by(names))
}

/// The two ends of a joint, as words.
fn ends(text: &Text<'_>, dice: &mut Dice) -> Option<[Range<usize>; 2]> {
    let joint = text.statement(dice, &["joint"], |one| {
        ["revolute", "prismatic", "weld", "slot"].contains(&text.word(one.start + 3))
    })?;
    let open = joint.start + 4;
    let comma = (open..joint.end).find(|&one| text.is(one, ","))?;
    let close = text.partner(open)?;
    (text.is(open, "(") && comma < close).then(|| [open + 1..comma, comma + 1..close])
}
