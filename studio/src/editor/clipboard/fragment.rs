//! Statements that are copied, and pasted under names that are free: into the same text or another.

use crate::document::{Document, Listing, Source};
use crate::editor::index;
use crate::editor::names::Names;
use crate::failure::Failure;
use crate::mend::Rewriter;
use crate::text::{Lexer, Replacement, Statement, shortest, statements, written};
use mech_compiler::model::{AxisId, AxisKind, LinkId, Model};
use std::collections::{BTreeMap, BTreeSet};

/// What is copied: links, what is between them, and the numbers that they use.
const WORDS: [&str; 5] = ["const", "param", "link", "joint", "motor"];

/// Whether a text has such statements alone.
pub(super) fn can_be_pasted(text: &str) -> bool {
    let all = statements(text, &(0..text.len()));
    all.iter().any(|one| one.is("link")) && all.iter().all(|one| is_copied(one))
}

fn is_copied(statement: &Statement<'_>) -> bool {
    WORDS.iter().any(|word| statement.is(word))
}

/// The statements of some links, with the joints and motors between them. Joints with the ground come along if there are several links. Where
/// links were joined to others they get free ends. What was drawn in the scene stands beside itself.
pub(super) fn copied(
    document: &Document,
    index: usize,
    links: &BTreeSet<String>,
    beside: [f64; 2],
) -> Result<Option<String>, Failure> {
    let Some(declaration) = document.declarations().get(index) else {
        return Ok(None);
    };
    let (Some(model), Some(listing)) =
        (document.model(declaration)?, document.listing(declaration)?)
    else {
        return Ok(None);
    };
    let Some(body) = &declaration.body else {
        return Ok(None);
    };
    let text = document.source().text();
    let source = Copy {
        text,
        model: &model,
        listing: &listing,
        links,
        beside,
    };
    let all = statements(text, body);
    let mut found: Vec<String> = Vec::new();
    let mut mentioned: Vec<&Statement<'_>> = Vec::new();
    for statement in &all {
        let copy = match statement.word(0) {
            "link" if links.contains(statement.word(1)) => source.link(statement),
            "joint" if source.has_joint(statement) => source.shifted(statement, true),
            "motor" if source.has_motor(statement, &all) => source.shifted(statement, false),
            _ => continue,
        };
        found.push(copy);
        mentioned.push(statement);
    }
    if !mentioned.iter().any(|one| one.is("link")) {
        return Ok(None);
    }
    // Numbers stand before what uses them, which may be another number.
    for statement in all.iter().rev() {
        let is_number = statement.is("const") || statement.is("param");
        if is_number && mentioned.iter().any(|one| one.mentions(statement.word(1))) {
            found.insert(0, text[statement.range()].to_owned());
            mentioned.push(statement);
        }
    }
    Ok(Some(found.join("\n")))
}

/// What is copied from a text.
struct Copy<'c> {
    text: &'c str,
    model: &'c Model,
    listing: &'c Listing,
    links: &'c BTreeSet<String>,
    beside: [f64; 2],
}

impl Copy<'_> {
    fn is_copied(&self, link: LinkId) -> bool {
        self.links.contains(&self.model.link(link).name)
    }

    /// Whether a joint is copied: if both links are, or one and the ground.
    fn has_joint(&self, statement: &Statement<'_>) -> bool {
        let mut joints = self.model.declared_joints();
        let name = statement.word(1);
        let Some(joint) = joints.find(|joint| self.model.joint(*joint).name == name) else {
            return false;
        };
        // Another text has other points on its ground.
        let has_point =
            statement.mentions("ground") && self.text[statement.range()].contains("ground.");
        let (a, b) = self.model.ends(joint);
        let comes = |link: LinkId| {
            self.is_copied(link) || link == LinkId::GROUND && self.links.len() > 1 && !has_point
        };
        comes(a) && comes(b)
    }

    fn has_motor(&self, statement: &Statement<'_>, all: &[Statement<'_>]) -> bool {
        let name = statement.word(1);
        let mut joints = all.iter().filter(|one| one.declares("joint", name));
        joints.any(|joint| self.has_joint(joint))
    }

    /// A statement, with its places in the scene beside where they were.
    fn shifted(&self, statement: &Statement<'_>, is_in_scene: bool) -> String {
        let whole = statement.range();
        let tolerance = 1e-9 * self.model.size();
        let mut edits = Vec::new();
        for number in self.listing.numbers.iter().filter(|_| is_in_scene) {
            let is_within = whole.start <= number.place.start && number.place.end <= whole.end;
            let way = match number.role.rsplit(' ').next() {
                Some("x") => self.beside[0],
                Some("y") => self.beside[1],
                _ => continue,
            };
            if !is_within || number.is_pair {
                continue;
            }
            let known = &self.text[number.place.clone()];
            let text = match known.trim().parse::<f64>() {
                Ok(value) => shortest(value + way, tolerance),
                Err(_) => format!("{known} + ({})", shortest(way, tolerance)),
            };
            let range = number.place.start - whole.start..number.place.end - whole.start;
            edits.push(Replacement { range, text });
        }
        edits.sort_by_key(|edit| edit.range.start);
        written(&self.text[whole], &edits)
    }

    /// A link with free ends where it was joined to what is not copied.
    fn link(&self, statement: &Statement<'_>) -> String {
        let name = statement.word(1);
        let mut links = self.model.declared_links();
        let link = links.find(|link| self.model.link(*link).name == name);
        let Some(link) = link.filter(|link| self.model.link(*link).drawn) else {
            return self.shifted(statement, false);
        };
        let copy = self.shifted(statement, true);
        let ends = self.ends(link, name);
        if ends.is_empty() {
            return copy;
        }
        match (copy.strip_suffix(';'), copy.rfind('}')) {
            (Some(before), _) => format!("{} {{ {ends}}}", before.trim_end()),
            (None, Some(end)) => format!("{} {ends}}}", copy[..end].trim_end()),
            (None, None) => copy,
        }
    }

    fn ends(&self, link: LinkId, name: &str) -> String {
        let tolerance = 1e-9 * self.model.size();
        let mut kept: BTreeSet<AxisId> = BTreeSet::new();
        let mut left: Vec<AxisId> = Vec::new();
        for joint in self.model.joint_ids() {
            let (a, b) = self.model.ends(joint);
            let comes =
                |end: LinkId| self.is_copied(end) || end == LinkId::GROUND && self.links.len() > 1;
            let axes = self.model.joint(joint).kind.axes().into_iter().flatten();
            for axis in axes.filter(|axis| self.model.axis(*axis).link == link) {
                if comes(a) && comes(b) {
                    kept.insert(axis);
                } else if index::path(self.model, axis).is_none() {
                    left.push(axis);
                }
            }
        }
        let mut places: Vec<[f64; 2]> = kept.iter().map(|axis| self.model.axis(*axis).at).collect();
        let mut numbers = (1_u32..).filter(|number| {
            let path = format!("{name}.end{number}");
            let mut axes = (0..self.model.axes.len()).map(AxisId::new);
            !axes.any(|axis| index::path(self.model, axis).is_some_and(|known| known == path))
        });
        let mut ends = String::new();
        for axis in left.into_iter().map(|axis| self.model.axis(axis)) {
            if axis.kind != AxisKind::Point || places.contains(&axis.at) {
                continue;
            }
            places.push(axis.at);
            let [x, y] = [0, 1].map(|part| shortest(axis.at[part] + self.beside[part], tolerance));
            let number = numbers.next().unwrap_or_default();
            ends += &format!("point end{number} = ({x}, {y}); ");
        }
        ends
    }
}

/// A text with statements that were copied, and the links that are new in it.
pub(super) fn pasted(
    document: &Document,
    index: usize,
    copied: &str,
) -> Result<(String, Vec<String>), String> {
    let source = document.source();
    let path = source.path();
    let mut text = match source.text() {
        blank if blank.trim().is_empty() => "struct Mechanism;\n".to_owned(),
        text => text.to_owned(),
    };
    let lost = || "there is no mechanism into which something could be pasted".to_owned();
    let at = |text: &str| {
        let document = Document::of(Source::new(path, text));
        let declaration = document.declarations().get(index).cloned();
        declaration.map(|declaration| (document, declaration))
    };
    let (before, declaration) = at(&text).ok_or_else(lost)?;
    let model = before
        .model(&declaration)
        .map_err(|failure| failure.to_string())?;
    let model = model.ok_or("the text has mistakes; mend them before something is pasted")?;
    let body = declaration.body.ok_or_else(lost)?;
    let known: BTreeSet<&str> = statements(&text, &body)
        .iter()
        .map(|one| &text[one.range()])
        .collect();
    let all = statements(copied, &(0..copied.len()));
    let fresh = all.iter().filter(|one| {
        let is_number = one.is("const") || one.is("param");
        !(is_number && known.contains(&copied[one.range()]))
    });
    let fresh: Vec<&Statement<'_>> = fresh.collect();
    let mut names = Names::within(&text);
    let renamed: BTreeMap<&str, String> = fresh
        .iter()
        .filter(|one| !one.is("motor"))
        .map(|one| (one.word(1), names.like(one.word(1), one.is("joint"))))
        .collect();
    let links = fresh.iter().filter(|one| one.is("link"));
    let links = links.filter_map(|one| renamed.get(one.word(1)).cloned());
    let links: Vec<String> = links.collect();
    for statement in fresh {
        let copy = with_names(&copied[statement.range()], &renamed);
        let siblings: &[&str] = match statement.word(0) {
            "const" | "param" => &["const", "param"],
            "link" => &["link", "ground", "param", "const", "look", "use"],
            "joint" => &["joint", "link", "ground"],
            _ => &["motor", "joint", "link", "ground"],
        };
        let (_, declaration) = at(&text).ok_or_else(lost)?;
        let body = declaration.body.ok_or_else(lost)?;
        let mut rewriter = Rewriter::new(&text, &body, &model);
        rewriter.add_beside(&copy, siblings).ok_or_else(lost)?;
        let edits = rewriter.draft.edits();
        text = written(&text, &edits);
    }
    let (after, declaration) = at(&text).ok_or_else(lost)?;
    match after.model(&declaration) {
        Ok(Some(_)) => Ok((text, links)),
        Ok(None) => {
            let reading = after
                .analyse(&declaration)
                .map_err(|failure| failure.to_string())?;
            let faults = reading.result.err();
            let first = faults.and_then(|faults| faults.messages.into_iter().next());
            let why = first.map(|message| message.text).unwrap_or_default();
            Err(format!("it cannot be pasted here: {why}"))
        }
        Err(failure) => Err(failure.to_string()),
    }
}

/// A statement with other names. Points and lines keep theirs, which are those of their links.
fn with_names(text: &str, renamed: &BTreeMap<&str, String>) -> String {
    let mut edits = Vec::new();
    let mut before = "";
    for lexeme in Lexer::new(text, 0) {
        let word = &text[lexeme.start..lexeme.end];
        let is_own = ["point", "line", ".", "color"].contains(&before);
        if let Some(name) = renamed.get(word).filter(|_| !is_own) {
            edits.push(Replacement {
                range: lexeme.start..lexeme.end,
                text: name.clone(),
            });
        }
        before = word;
    }
    written(text, &edits)
}
