//! What is taken out of a mechanism.

use super::declare::{matter, unwritten};
use super::{Change, Kind, Refusal, Scene};
use crate::text::Statement;
use mech_compiler::model::{LinkId, Model};
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
            rewriter.remove_link(link).ok_or_else(unknown)?;
        }
        Kind::Joint => {
            let mut joints = model.joint_ids();
            match joints.find(|&joint| model.joint(joint).name == name) {
                Some(joint) => rewriter.remove_joint(joint).ok_or_else(unknown)?,
                None => rewriter
                    .remove_statement("joint", name)
                    .ok_or_else(unknown)?,
            }
        }
        Kind::Motor => {
            let mut motors = model.motor_ids();
            let is_it = |&motor: &_| model.joint(model.motor(motor).joint).name == name;
            match motors.find(is_it) {
                Some(motor) => rewriter.remove_motor(motor).ok_or_else(unknown)?,
                None => rewriter
                    .remove_statement("motor", name)
                    .ok_or_else(unknown)?,
            }
        }
        Kind::Axis => {
            refuse_used(scene, name)?;
            let (link, axis) = name.rsplit_once('.').ok_or_else(unknown)?;
            let owner = owner(&rewriter.statements, link).ok_or_else(unknown)?;
            let items = owner.clauses();
            let is_it =
                |one: &&Statement<'_>| one.declares("point", axis) || one.declares("line", axis);
            let item = items.iter().find(is_it).ok_or_else(unknown)?;
            match emptied(scene.text(), &owner) {
                Some(braces) if items.len() == 1 && link != "ground" => {
                    rewriter.draft.replace(braces, ";");
                }
                _ => rewriter.draft.remove(&item.range()),
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
            rewriter.draft.remove(&statement.range());
        }
        Kind::Start => {
            let is_it = |one: &Statement<'_>| one.path(0).0 == name;
            if !has_clause(&rewriter.statements, "start", is_it) {
                return Err(unknown());
            }
            rewriter.remove_clauses("start", is_it);
        }
        Kind::Trace => {
            let is_it = |one: &Statement<'_>| one.is("trace") && one.path(1).0 == name;
            if !has_clause(&rewriter.statements, "effects", is_it) {
                return Err(unknown());
            }
            rewriter.remove_clauses("effects", is_it);
        }
        Kind::Mass => {
            let mass = matter(&rewriter, name).ok_or_else(unknown)?;
            rewriter.draft.remove(&mass.range());
        }
    }
    let change = Change::of(rewriter);
    if change.edits.is_empty() {
        return Err(unwritten());
    }
    Ok(change)
}

/// Whether only one thing acts, so that nobody may ask for forces without it.
fn is_last_force(model: &Model) -> bool {
    let actions = &model.actions;
    let count = actions.springs.len() + actions.dampers.len() + actions.loads.len();
    let has_mass = model.links.iter().any(|link| link.mass.is_some());
    count == 1 && !has_mass && !model.effects.dynamics
}

/// Where the braces of a link stand, with the space before them, if nothing but statements is within.
fn emptied(text: &str, owner: &Statement<'_>) -> Option<Range<usize>> {
    let (open, close) = (owner.find("{")?, owner.rfind("}")?);
    let before = owner.place(open.checked_sub(1)?)?;
    let braces = owner.place(open)?.start..owner.place(close)?.end;
    let has_comment = text[braces.clone()].contains("//") || text[braces.clone()].contains("/*");
    (!has_comment).then_some(before.end..braces.end)
}

/// The statement that declares what is fixed to a link, or to the ground.
pub(super) fn owner<'t>(statements: &[Statement<'t>], link: &str) -> Option<Statement<'t>> {
    let is_it = |one: &&Statement<'_>| {
        if link == "ground" {
            one.is("ground")
        } else {
            one.declares("link", link) || one.declares("port", link)
        }
    };
    statements.iter().find(is_it).cloned()
}

/// The statement of a use.
pub(super) fn used<'t>(statements: &[Statement<'t>], name: &str) -> Option<Statement<'t>> {
    let is_it = |one: &&Statement<'_>| one.is("use") && one.word(1) == name;
    statements.iter().find(is_it).cloned()
}

fn has_clause(
    statements: &[Statement<'_>],
    word: &str,
    is_it: impl Fn(&Statement<'_>) -> bool,
) -> bool {
    let all = statements.iter().filter(|one| one.is(word));
    all.flat_map(Statement::clauses)
        .any(|clause| is_it(&clause))
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
            Err(Refusal::of(format!(
                "`{path}` is used in line {line}; take that out first"
            )))
        }
        None => Ok(()),
    }
}
