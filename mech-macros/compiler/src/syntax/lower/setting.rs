//! Settings of the mechanism and its pictures, each of one word.

use super::report::Report;
use crate::model::{Look, Model, Quality, Target};
use crate::syntax::Place;
use proc_macro2::Ident;

const LOOKS: [(&str, Look); 3] =
    [("machine", Look::Machine), ("diagram", Look::Diagram), ("none", Look::Shapes)];
const QUALITIES: [(&str, Quality); 2] = [("hard", Quality::Hard), ("smooth", Quality::Smooth)];
const MACHINES: [(&str, Target); 2] =
    [("x86_64", Target::X86_64), ("cortex_m4f", Target::CortexM4f)];
const PERMISSIONS: [&str; 2] = ["redundant", "coupled"];

/// Returns the value of a word, one of these; reports any other word.
pub(super) fn choose<T: Copy, const N: usize>(
    word: &Ident,
    what: &str,
    known: &[(&str, T); N],
    report: &mut Report,
) -> Option<T> {
    if let Some((_, value)) = known.iter().find(|(name, _)| word == name) {
        return Some(*value);
    }
    report.unknown(word, what, &known.each_ref().map(|(name, _)| *name));
    None
}

pub(super) fn look(word: &Ident, model: &mut Model, report: &mut Report) {
    model.look = choose(word, "look", &LOOKS, report).or(model.look);
}

pub(super) fn quality(word: &Ident, model: &mut Model, report: &mut Report) {
    model.quality = choose(word, "quality", &QUALITIES, report).unwrap_or(model.quality);
}

pub(super) fn cost(word: &Ident, model: &mut Model, report: &mut Report) {
    model.target = choose(word, "machine", &MACHINES, report).unwrap_or(model.target);
}

pub(super) fn allow(word: &Ident, model: &mut Model, report: &mut Report) {
    let allowed = match word.to_string().as_str() {
        "redundant" => &mut model.allow.redundant,
        "coupled" => &mut model.allow.coupled,
        _ => return report.unknown(word, "permission", &PERMISSIONS),
    };
    if std::mem::replace(allowed, true) {
        let text = format!("`{word}` is allowed already; remove one of the two");
        report.error(Place::at(word.span()), text);
    }
}
