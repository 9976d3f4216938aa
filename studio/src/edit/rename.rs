//! New names for what is declared.

use super::declare::check_name;
use super::{Change, Refusal, Scene};
use crate::document::NameText;
use crate::text::Replacement;
use mech_compiler::syntax::Noun;

/// Gives something another name, wherever it is used.
pub(super) fn rename(scene: &Scene, path: &str, name: &str) -> Result<Change, Refusal> {
    // `crank.pin` may become `crank.end` or `end`.
    let name = match path.rsplit_once('.').zip(name.rsplit_once('.')) {
        Some(((owner, _), (new_owner, last))) if owner == new_owner => last,
        _ => name,
    };
    check_name(name)?;
    let listing = &scene.listing;
    let mut declared = listing.declared(path);
    let target = declared
        .next()
        .ok_or_else(|| Refusal::of(format!("`{path}` is not declared in this text")))?;
    if declared.next().is_some() {
        return Err(Refusal::of(format!(
            "`{path}` is declared more than once: which one is meant is not clear"
        )));
    }
    let new_path = match path.rsplit_once('.') {
        Some((owner, _)) => format!("{owner}.{name}"),
        None => name.to_owned(),
    };
    if listing.declared(&new_path).next().is_some() {
        return Err(Refusal::of(format!("`{new_path}` is declared already")));
    }
    let goal = (target.part.as_deref(), target.path.as_str());
    let is_use = |one: &&NameText| {
        let found = listing.resolve(&one.path, one.part.as_deref());
        found == goal && is_kind(one, found.1, target.noun)
    };
    let uses: Vec<_> = listing.names.iter().filter(is_use).collect();
    let edits = uses.iter().map(|used| Replacement::new(used.place.clone(), name));
    let mut change = Change::from(edits.collect::<Vec<_>>());
    change.notes.push(match uses.len() {
        1 => "1 place".to_owned(),
        count => format!("{count} places"),
    });
    let is_rust = scene.declaration.body.as_ref() != Some(&scene.declaration.whole);
    if is_rust {
        change.notes.push("Rust code that uses the name stays as it is".to_owned());
    }
    Ok(change)
}

fn is_kind(one: &NameText, path: &str, noun: Noun) -> bool {
    match (one.noun, noun) {
        (Noun::BodyOrJoint, Noun::Body | Noun::Joint) => true,
        // In a path the last word may be a link of a part, or a joint.
        (Noun::Axis, Noun::Body | Noun::Joint) => !path.contains('.'),
        (found, noun) => found == noun,
    }
}
