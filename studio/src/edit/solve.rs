//! Numbers that are solved for, so that another comes out as it should.

use super::{Change, Refusal, Scene};
use crate::document::NumberText;
use crate::text::{Replacement, written_like};
use mech_compiler::model::Model;
use mech_compiler::syntax::Noun;
use std::ops::Range;

/// A number of the text, and what it should be.
pub(super) struct Goal<'g> {
    /// The name of the quantity, for messages.
    pub(super) what: &'g str,
    /// Where it stands.
    pub(super) number: &'g NumberText,
    pub(super) value: f64,
    pub(super) read: &'g dyn Fn(&Model) -> Option<f64>,
}

/// A literal that the number depends on.
struct Candidate {
    range: Range<usize>,
    /// The constant whose value it is part of.
    constant: Option<String>,
}

/// Whether two numbers are the same but for rounding.
pub(super) fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * (1.0 + a.abs().max(b.abs()))
}

/// Writes a number so that it has its value: over the number itself if that is a literal; else over the one literal or constant that can
/// give the value.
pub(super) fn reach(scene: &Scene, goal: &Goal<'_>, change: &mut Change) -> Result<(), Refusal> {
    // Only what was solved for may have changed other numbers than its own.
    let known = if change.notes.is_empty() {
        (goal.read)(&scene.model)
    } else {
        let before = scene.model_after(&change.edits)?;
        before.and_then(|model| (goal.read)(&model))
    };
    if known.is_some_and(|known| known == goal.value) {
        return Ok(());
    }
    let text = &scene.text()[goal.number.place.clone()];
    if is_literal(text) {
        change
            .edits
            .push(Replacement::new(goal.number.place.clone(), written_like(goal.value, text)));
        change.edits.sort_by_key(|edit| edit.range.start);
        return Ok(());
    }
    let mut found = Vec::new();
    let candidates = candidates(scene, goal.number);
    for candidate in &candidates {
        if let Some(edit) = solve(scene, goal, candidate, &change.edits)? {
            found.push((candidate, edit));
        }
    }
    match &found[..] {
        [(candidate, edit)] => {
            let old = &scene.text()[candidate.range.clone()];
            change.notes.push(match &candidate.constant {
                Some(name) if is_whole(scene, name) => format!("{name} = {}", edit.text),
                Some(name) => format!("{} in place of {old} in {name}", edit.text),
                None => format!("{} in place of {old} in `{text}`", edit.text),
            });
            change.edits.push(edit.clone());
            change.edits.sort_by_key(|edit| edit.range.start);
            Ok(())
        }
        [] if candidates.is_empty() => Err(Refusal::of(format!(
            "{} is `{text}`, in which no number of this text stands",
            goal.what
        ))),
        [] => Err(Refusal::of(format!(
            "{} is `{text}`, in which no single number can give {}",
            goal.what, goal.value
        ))),
        several => {
            let shown = |(candidate, _): &(&Candidate, Replacement)| match &candidate.constant {
                Some(name) => format!("`{name}`"),
                None => format!("`{}`", &scene.text()[candidate.range.clone()]),
            };
            let names: Vec<String> = several.iter().map(shown).collect();
            Err(Refusal::of(format!(
                "{} is `{text}`, in which each of {} could give {}; set one of them",
                goal.what,
                names.join(", "),
                goal.value
            )))
        }
    }
}

/// Whether the value of a constant is one literal.
fn is_whole(scene: &Scene, name: &str) -> bool {
    let value = scene.listing.number(name, "value");
    value.is_some_and(|value| is_literal(&scene.text()[value.place.clone()]))
}

/// Whether a number is written as one literal, perhaps with a sign.
pub(super) fn is_literal(text: &str) -> bool {
    let digits = text.strip_prefix('-').unwrap_or(text).trim_start();
    let is_number = digits.starts_with(|letter: char| letter.is_ascii_digit());
    is_number && digits.replace('_', "").parse::<f64>().is_ok()
}

/// The literals that a number depends on, those of constants among them.
fn candidates(scene: &Scene, number: &NumberText) -> Vec<Candidate> {
    let mut found = Vec::new();
    let mut seen: Vec<&str> = Vec::new();
    let mut waiting: Vec<(&NumberText, Option<&str>)> = vec![(number, None)];
    while let Some((number, constant)) = waiting.pop() {
        found.extend(number.literals.iter().map(|range| Candidate {
            range: range.clone(),
            constant: constant.map(ToOwned::to_owned),
        }));
        let within = |range: &Range<usize>| {
            number.place.start <= range.start && range.end <= number.place.end
        };
        for name in &scene.listing.names {
            let is_used = name.noun == Noun::Number && !name.is_declared && within(&name.place);
            if !is_used || seen.contains(&name.path.as_str()) {
                continue;
            }
            seen.push(&name.path);
            if let Some(value) = scene.listing.number(&name.path, "value") {
                waiting.push((value, Some(&name.path)));
            }
        }
    }
    found
}

/// Finds the literal with which the goal is reached, if there is one.
fn solve(
    scene: &Scene,
    goal: &Goal<'_>,
    candidate: &Candidate,
    others: &[Replacement],
) -> Result<Option<Replacement>, Refusal> {
    /// Enough for what is linear; what is not is followed for a while.
    const STEPS: usize = 12;
    let overlaps = |edit: &Replacement| {
        edit.range.start < candidate.range.end && candidate.range.start < edit.range.end
    };
    let old = &scene.text()[candidate.range.clone()];
    let Ok(start) = old.replace('_', "").parse::<f64>() else {
        return Ok(None);
    };
    if others.iter().any(overlaps) {
        return Ok(None);
    }
    let edit_to = |value: f64| Replacement::new(candidate.range.clone(), written_like(value, old));
    let read = |value: f64| -> Result<Option<f64>, Refusal> {
        let mut edits = others.to_vec();
        edits.push(edit_to(value));
        edits.sort_by_key(|edit| edit.range.start);
        let model = scene.model_after(&edits)?;
        Ok(model.and_then(|model| (goal.read)(&model)))
    };
    let mut last = start;
    let Some(mut seen) = read(last)? else {
        return Ok(None);
    };
    let mut next = start + 0.125 * (1.0 + start.abs());
    for _ in 0..STEPS {
        let Some(found) = read(next)? else {
            return Ok(None);
        };
        if is_near(found, goal.value) {
            return Ok(Some(edit_to(rounded(next, &read, goal.value)?)));
        }
        let slope = (found - seen) / (next - last);
        if !slope.is_finite() || slope == 0.0 {
            return Ok(None);
        }
        (last, seen) = (next, found);
        next += (goal.value - found) / slope;
        if !next.is_finite() || next.abs() > 1e9 * (1.0 + goal.value.abs()) {
            return Ok(None);
        }
    }
    Ok(None)
}

/// A solution with fewer digits, if that is one too.
fn rounded(
    value: f64,
    read: &impl Fn(f64) -> Result<Option<f64>, Refusal>,
    goal: f64,
) -> Result<f64, Refusal> {
    for digits in [6, 12] {
        let short: f64 = format!("{value:.digits$}").parse().unwrap_or(value);
        if read(short)?.is_some_and(|found| is_near(found, goal)) {
            return Ok(short);
        }
    }
    Ok(value)
}
