//! The removal of declarations from a mechanism.

use super::declare::{matter, unwritten};
use super::{Change, Kind, Refusal, Scene};
use mech_compiler::model::{LinkId, Model};
use mech_compiler::syntax::StatementText;
use std::ops::Range;

/// Takes something out, with what cannot be without it.
pub(super) fn remove(scene: &Scene, kind: Kind, name: &str) -> Result<Change, Refusal> {
    let unknown = || Refusal::of(format!("there is no {} `{name}` in this text", kind.word()));
    let mut rewriter = scene.rewriter()?;
    let model = &scene.model;
    match kind {
        Kind::Link => {
            let mut links = model.declared_links();
            let link = links.find(|&link| model.link(link).name == name && link != LinkId::GROUND);
            let link = link.ok_or_else(unknown)?;
            rewriter.remove_link(model, link).ok_or_else(unknown)?;
        }
        Kind::Joint => {
            rewriter.remove_joint(name).ok_or_else(unknown)?;
        }
        Kind::Motor => {
            rewriter.remove_motor(name).ok_or_else(unknown)?;
        }
        Kind::Axis => {
            refuse_used(scene, name)?;
            let (link, axis) = name.rsplit_once('.').ok_or_else(unknown)?;
            let owner = rewriter.owner(link).ok_or_else(unknown)?;
            let items = owner.clauses();
            let is_it = |one: &&StatementText<'_>| {
                one.declares("point", axis) || one.declares("line", axis)
            };
            let item = items.iter().find(is_it).ok_or_else(unknown)?;
            match emptied(scene, &owner)? {
                Some(braces) if items.len() == 1 && link != "ground" => {
                    let before = owner.word(braces.start - owner.token(0));
                    rewriter.edits.replace(braces, format!("{before};"));
                }
                _ => rewriter.edits.remove(item.range()),
            }
        }
        Kind::Constant => {
            refuse_used(scene, name)?;
            let done = rewriter.remove_statement("const", name);
            let done = done.or_else(|| rewriter.remove_statement("param", name));
            done.ok_or_else(unknown)?;
        }
        Kind::Action => {
            let mut words = ["spring", "damper", "load"].into_iter();
            let done = words.find_map(|word| rewriter.remove_statement(word, name));
            done.ok_or_else(unknown)?;
            if is_last_force(model) {
                rewriter.remove_clauses("effects", |one| one.is("force"));
            }
        }
        Kind::Use => {
            let statement = used(&rewriter.statements, name).ok_or_else(unknown)?;
            rewriter.edits.remove(statement.range());
        }
        Kind::Start => {
            let is_it = |one: &StatementText<'_>| one.path(0).0 == name;
            if !has_clause(&rewriter.statements, "start", is_it) {
                return Err(unknown());
            }
            rewriter.remove_clauses("start", is_it);
        }
        Kind::Trace => {
            let is_it = |one: &StatementText<'_>| one.is("trace") && one.path(1).0 == name;
            if !has_clause(&rewriter.statements, "effects", is_it) {
                return Err(unknown());
            }
            rewriter.remove_clauses("effects", is_it);
        }
        Kind::Mass => {
            let mass = matter(&rewriter, name).ok_or_else(unknown)?;
            rewriter.edits.remove(mass.range());
        }
    }
    let change = Change::of(scene, &rewriter)?;
    if change.edits.is_empty() {
        return Err(unwritten());
    }
    Ok(change)
}

/// Whether a single spring, damper or load acts. Without it, the text may not ask for forces.
fn is_last_force(model: &Model) -> bool {
    let actions = &model.actions;
    let count = actions.springs.len() + actions.dampers.len() + actions.loads.len();
    let has_mass = model.links.iter().any(|link| link.mass.is_some());
    count == 1 && !has_mass && !model.effects.dynamics
}

/// The braces of a link, with the word before them, if nothing but statements is within.
fn emptied(scene: &Scene, owner: &StatementText<'_>) -> Result<Option<Range<usize>>, Refusal> {
    let (Some(open @ 1..), Some(close)) = (owner.find("{"), owner.rfind("}")) else {
        return Ok(None);
    };
    let braces = owner.token(open)..owner.token(close + 1);
    let text = &scene.text()[scene.tree()?.bytes(&braces)];
    let has_comment = text.contains("//") || text.contains("/*");
    Ok((!has_comment).then_some(braces.start - 1..braces.end))
}

pub(super) fn used<'t>(statements: &[StatementText<'t>], name: &str) -> Option<StatementText<'t>> {
    let is_it = |one: &&StatementText<'_>| one.is("use") && one.word(1) == name;
    statements.iter().find(is_it).cloned()
}

fn has_clause(
    statements: &[StatementText<'_>],
    word: &str,
    is_it: impl Fn(&StatementText<'_>) -> bool,
) -> bool {
    let all = statements.iter().filter(|one| one.is(word));
    all.flat_map(StatementText::clauses).any(|clause| is_it(&clause))
}

/// Refuses to take out what something else needs.
fn refuse_used(scene: &Scene, path: &str) -> Result<(), Refusal> {
    let listing = &scene.listing;
    let mut names = listing.names.iter();
    let user = names.find(|one| {
        !one.is_declared && listing.resolve(&one.path, one.part.as_deref()) == (None, path)
    });
    match user {
        Some(user) => {
            let line = scene.document.source().spot(user.place.start).line;
            Err(Refusal::of(format!("`{path}` is used in line {line}; take that out first")))
        }
        None => Ok(()),
    }
}
