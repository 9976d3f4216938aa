//! Slips that concern whole statements, and what a joint joins.

use super::Make;
use super::dice::Dice;
use super::text::{Slip, Text};
use super::words::is_argument;
use std::ops::Range;

#[rustfmt::skip]
pub(super) const KINDS: &[(&str, Make)] = &[
    ("`link a, b;`", |text, dice| {
        let is_bare = |one: &Range<usize>| one.len() == 3;
        let first = text.statement(dice, &["link"], |one| {
            is_bare(one) && text.is(one.end, "link") && text.is(one.end + 2, ";")
        })?;
        Some(text.instead(first.end - 1..first.end + 1, ","))
    }),
    ("joint forgotten", |text, dice| forget(text, dice, &["joint"])),
    ("link forgotten", |text, dice| forget(text, dice, &["link"])),
    ("point forgotten", |text, dice| forget(text, dice, &["point", "line"])),
    ("const forgotten", |text, dice| forget(text, dice, &["const", "param"])),
    ("motor forgotten", |text, dice| forget(text, dice, &["motor"])),
    ("ground forgotten", |text, dice| forget(text, dice, &["ground"])),
    ("`allow` forgotten", |text, dice| forget(text, dice, &["allow"])),
    ("`struct` forgotten", |text, dice| {
        let header = text.statement(dice, &["struct", "pub"], |_| true)?;
        let names = vec!["struct".to_owned()];
        Some(text.instead(header, "").told_by(names))
    }),
    ("`near` forgotten", |text, dice| {
        let near = text.find(dice, |one| one > 0 && text.is(one, "near") && text.is_head(one - 1))?;
        let end = (near..text.lexemes.len()).find(|&one| text.is(one, ";"))?;
        let names = text.names(near - 1..end);
        Some(text.instead(near - 1..end + 1, "").told_by(names))
    }),
    ("point behind its link", |text, dice| {
        let point = text.statement(dice, &["point", "line"], |one| text.is(one.end, "}"))?;
        let line = &text.text[text.bytes(point.clone())];
        Some(text.instead(point.start..point.end + 1, &format!("}} {line}")))
    }),
    ("effect outside of `effects`", |text, dice| {
        let effects = text.statement(dice, &["effects"], |_| true)?;
        let inside = effects.start + 2..effects.end - 1;
        let inside = &text.text[text.bytes(inside)];
        Some(text.instead(effects, inside))
    }),
    ("port forgotten", |text, dice| {
        let index = text.find(dice, |one| is_argument(text, one, "{"))?;
        let end = end_of_argument(text, index)?;
        let end = end + usize::from(text.is(end, ","));
        let names = vec![text.word(index).to_owned()];
        Some(text.instead(index..end, "").told_by(names))
    }),
    ("number of a part without value", |text, dice| {
        let index = text.find(dice, |one| is_argument(text, one, "("))?;
        Some(text.instead(index + 1..end_of_argument(text, index)?, ""))
    }),
    ("motor on a link", |text, dice| {
        let motor = text.statement(dice, &["motor"], |one| text.is_used(one.start + 1))?;
        let link = text.find(dice, |one| one > 0 && text.is(one - 1, "link"))?;
        Some(text.instead(motor.start + 1..motor.start + 2, text.word(link)))
    }),
    ("motor twice", |text, dice| double(text, dice, &["motor"])),
    ("name twice", |text, dice| double(text, dice, &["link", "joint", "point", "line", "const", "param"])),
    ("joint pasted under another name", |text, dice| {
        let joint = text.statement(dice, &["joint"], |_| true)?;
        let start = &text.text[text.bytes(joint.start..joint.start + 2)];
        let others = &text.text[text.bytes(joint.start + 2..joint.end)];
        let end = text.bytes(joint).end;
        Some(text.with(end..end, &format!("\n{start}2 {others}")))
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
    ("length ten times", |text, dice| {
        let number = text.find(dice, |one| is_length(text, one))?;
        let place = text.lexemes[number].start..text.end_of_number(number);
        let value: f64 = text.text[place.clone()].parse().ok()?;
        let factor = *dice.pick(&[10.0, 0.1]);
        let exact = format!("{:.9}", value * factor);
        let new = exact.trim_end_matches('0').trim_end_matches('.');
        Some(text.with(place, new))
    }),
    ("sign of a length", |text, dice| {
        let number = text.find(dice, |one| is_length(text, one))?;
        let start = text.lexemes[number].start;
        Some(if text.is(number - 1, "-") {
            text.with(text.lexemes[number - 1].start..start, "")
        } else {
            text.with(start..start, "-")
        })
    }),
    ("place copied from the line above", |text, dice| {
        let at = |joint: &Range<usize>| {
            let open = joint.clone().find(|&one| text.is(one, "at"))? + 1;
            Some(open..text.partner(open)? + 1)
        };
        let statements = text.statements();
        let mut joints = statements.iter().filter(|one| text.is(one.start, "joint"));
        let first = text.statement(dice, &["joint"], |one| at(one).is_some())?;
        let second = joints.find(|one| one.start >= first.end && at(one).is_some())?;
        Some(text.instead(at(second)?, &text.text[text.bytes(at(&first)?)]))
    }),
    ("direction of no length", |text, dice| {
        let along = text.find(dice, |one| text.is(one, "along") && text.is(one + 1, "("))?;
        Some(text.instead(along + 1..text.partner(along + 1)? + 1, "(0, 0)"))
    }),
    ("another kind of joint", |text, dice| text.exchange(dice, (&["revolute"], &["prismatic", "gear", "slot"]), |_| true)),
];

/// Whether a number is a coordinate of a point, a line or a joint.
fn is_length(text: &Text<'_>, index: usize) -> bool {
    let statements = text.statements();
    let mut places =
        statements.iter().filter(|one| ["point", "line", "joint"].contains(&text.word(one.start)));
    let follows = |one: usize| text.is(one, "(") || text.is(one, ",");
    let before = index.checked_sub(if index > 0 && text.is(index - 1, "-") { 2 } else { 1 });
    text.is_number(index)
        && before.is_some_and(follows)
        && !text.text[text.lexemes[index].start..text.end_of_number(index)]
            .trim_matches(['0', '.'])
            .is_empty()
        && places.any(|one| one.contains(&index))
}

/// Leaves one of the statements with these first words out; one whose name is used.
fn forget(text: &Text<'_>, dice: &mut Dice, heads: &[&str]) -> Option<Slip> {
    let name = |one: &Range<usize>| text.word(one.start + 1);
    let is_used = |one: &Range<usize>| {
        let mut others = (0..text.lexemes.len()).filter(|&other| !one.contains(&other));
        let is_joint = text.is(one.start, "joint");
        is_joint
            || !text.is_declared(one.start + 1)
            || others.any(|other| text.is(other, name(one)))
    };
    let left_out = text.statement(dice, heads, is_used)?;
    let mut names = text.names(left_out.clone());
    // A mechanism without any motor has no place for one.
    let head = text.word(left_out.start);
    names.extend(["motor", "allow"].contains(&head).then(|| head.to_owned()));
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

/// The mark after a port or number of a part, and what it gets.
fn end_of_argument(text: &Text<'_>, index: usize) -> Option<usize> {
    let open = text.bracket(index)?;
    let close = text.partner(open)?;
    let is_end = |one: &usize| text.is(*one, ",") && text.bracket(*one) == Some(open);
    Some((index..close).find(is_end).unwrap_or(close))
}
