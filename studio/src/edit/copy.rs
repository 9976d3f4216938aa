//! Links and uses that are mirrored, or declared once more.

use super::declare::{check_name, replaced, unwritten};
use super::remove::used;
use super::solve::is_literal;
use super::{Change, Refusal, Scene};
use crate::text::is_of_word;

/// Mirrors what is fixed to a link about the x axis of its frame; or a use of a part.
pub(super) fn mirror(scene: &Scene, name: &str) -> Result<Change, Refusal> {
    let mut rewriter = scene.rewriter()?;
    if let Some(used) = used(&rewriter.statements, name) {
        if let Some(word) = used.find("mirrored") {
            let known = used.token(word - 1)..used.token(word + 1);
            rewriter.edits.replace(known, used.word(word - 1));
        } else {
            let open = used.token(used.find("{").ok_or_else(unwritten)?);
            rewriter.edits.insert_before(open, "mirrored ");
        }
        return Change::of(scene, &rewriter);
    }
    let model = &scene.model;
    let mut links = model.declared_links();
    let link = links.find(|&link| model.link(link).name == name);
    let is_declared = rewriter.declared("link", name).is_some();
    let link = link.filter(|_| is_declared).ok_or_else(|| unknown(name))?;
    if model.link(link).drawn {
        return Err(Refusal::of(format!(
            "joints were drawn on `{name}`, which is where they are; only a link with points of its own is mirrored"
        )));
    }
    let mut edits = Vec::new();
    let prefix = format!("{name}.");
    for number in &scene.listing.numbers {
        let is_fixed = number.owner == name || number.owner.starts_with(&prefix);
        let is_of_link = is_fixed && number.part.is_none() && !number.is_pair;
        if is_of_link && changes_sign(&number.role) {
            let text = &scene.text()[number.place.clone()];
            let by = negative(text);
            edits.extend((by != text).then(|| replaced(number, by)));
        }
    }
    if edits.is_empty() {
        return Err(Refusal::of(format!("`{name}` is its own mirror image")));
    }
    Ok(edits.into())
}

/// Whether mirroring changes the sign of a number with this role.
fn changes_sign(role: &str) -> bool {
    let word = role.rsplit(' ').next().unwrap_or(role);
    matches!(word, "y" | "dy" | "direction" | "turned")
}

/// A number with the other sign.
fn negative(text: &str) -> String {
    let degrees = text.strip_suffix("deg").map_or(text, str::trim_end);
    if is_literal(degrees) {
        let digits = degrees.trim_start_matches('-');
        let is_zero = digits.trim().parse::<f64>().is_ok_and(|value| value == 0.0);
        return match text.strip_prefix('-') {
            _ if is_zero => text.to_owned(),
            Some(positive) => positive.trim_start().to_owned(),
            None => format!("-{text}"),
        };
    }
    let is_word = |text: &str| text.chars().all(is_of_word);
    if is_word(text) {
        return format!("-{text}");
    }
    // A second mirroring gives the first text again.
    match text.strip_prefix("-(").and_then(|inner| inner.strip_suffix(')')) {
        Some(inner) if !inner.contains(['(', ')']) => inner.to_owned(),
        _ => match text.strip_prefix('-') {
            Some(word) if is_word(word) => word.to_owned(),
            _ => format!("-({text})"),
        },
    }
}

/// Declares a link or a use once more, under another name.
pub(super) fn duplicate(scene: &Scene, name: &str, copy: &str) -> Result<Change, Refusal> {
    check_name(copy)?;
    let mut rewriter = scene.rewriter()?;
    let known = rewriter.declared("link", name);
    let known = known.or_else(|| used(&rewriter.statements, name));
    let known = known.ok_or_else(|| unknown(name))?;
    let (text, tree) = (scene.text(), scene.tree()?);
    let whole = tree.bytes(&known.range());
    let word = tree.bytes(&(known.token(1)..known.token(2)));
    let statement = [&text[whole.start..word.start], copy, &text[word.end..whole.end]].concat();
    rewriter.edits.add(known.range(), statement);
    Change::of(scene, &rewriter)
}

fn unknown(name: &str) -> Refusal {
    Refusal::of(format!("there is no link or use `{name}` in this text"))
}
