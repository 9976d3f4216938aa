//! Shapes of links: their planes, colours and outlines.

use super::declare::{check_expression, check_fragment, replaced};
use super::{Change, Refusal, Scene};
use mech_compiler::syntax::{Rewriter, StatementText};

/// The words of statements within a link that are no shapes.
const OTHERS: [&str; 4] = ["point", "line", "mass", "density"];

pub(super) fn remove(scene: &Scene, link: &str, number: usize) -> Result<Change, Refusal> {
    let mut rewriter = scene.rewriter()?;
    let shape = shape(&rewriter, link, number)?;
    rewriter.edits.remove(shape.range());
    Change::of(scene, &rewriter)
}

/// Puts a shape on a plane.
pub(super) fn layer(
    scene: &Scene,
    link: &str,
    number: usize,
    plane: &str,
) -> Result<Change, Refusal> {
    check_expression(plane)?;
    say(scene, (link, number), ("plane", plane), |shape| {
        let end = shape.find("color").unwrap_or(shape.len() - 1);
        let text = if shape.word(end) == ";" {
            format!(" on plane {plane}")
        } else {
            format!("on plane {plane} ")
        };
        (end, text)
    })
}

/// Gives a shape another colour.
pub(super) fn recolor(
    scene: &Scene,
    link: &str,
    number: usize,
    color: &str,
) -> Result<Change, Refusal> {
    check_fragment(color)?;
    say(scene, (link, number), ("color", color), |shape| {
        (shape.len() - 1, format!(" color {color}"))
    })
}

/// Says something of a shape: in place of what was said, or else by a text before the word with this number.
fn say(
    scene: &Scene,
    (link, number): (&str, usize),
    (role, value): (&str, &str),
    addition: impl Fn(&StatementText<'_>) -> (usize, String),
) -> Result<Change, Refusal> {
    let mut rewriter = scene.rewriter()?;
    let shape = shape(&rewriter, link, number)?;
    let role = format!("shape {number} {role}");
    if let Some(known) = scene.listing.number(link, &role) {
        return Ok(replaced(known, value).into());
    }
    let (word, text) = addition(&shape);
    rewriter.edits.insert_before(shape.token(word), text);
    Change::of(scene, &rewriter)
}

/// Gives a shape another outline.
pub(super) fn reshape(
    scene: &Scene,
    link: &str,
    number: usize,
    outline: &str,
) -> Result<Change, Refusal> {
    check_fragment(outline)?;
    let mut rewriter = scene.rewriter()?;
    let shape = shape(&rewriter, link, number)?;
    let clauses = ["on", "color"].iter().filter_map(|word| shape.find(word));
    let end = clauses.min().unwrap_or(shape.len() - 1);
    let known = shape.token(0)..shape.token(end);
    rewriter.edits.replace(known, outline.trim());
    Change::of(scene, &rewriter)
}

/// A shape of a link by its number, from 1.
fn shape<'t>(
    rewriter: &Rewriter<'t>,
    link: &str,
    number: usize,
) -> Result<StatementText<'t>, Refusal> {
    let link_statement = rewriter
        .owner(link)
        .ok_or_else(|| Refusal::of(format!("there is no link `{link}` in this text")))?;
    let items = link_statement.clauses();
    let shapes: Vec<&StatementText<'t>> =
        items.iter().filter(|one| !OTHERS.contains(&one.word(0))).collect();
    let found = number.checked_sub(1).and_then(|index| shapes.get(index));
    found.map(|&one| one.clone()).ok_or_else(|| {
        Refusal::of(match shapes.len() {
            0 => format!("`{link}` has no shapes"),
            count => format!("`{link}` has no shape {number}; the last is {count}"),
        })
    })
}
