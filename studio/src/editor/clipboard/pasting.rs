//! Statements that are pasted under names that are free, beside what is there: into the same text or another.

use super::Lexed;
use crate::document::{Document, Listing, NumberText, Source};
use crate::editor::names::Names;
use crate::text::{Replacement, shortest, written};
use mech_compiler::model::{LinkId, Model};
use mech_compiler::syntax::{Rewriter, StatementText};
use std::collections::{BTreeMap, BTreeSet};

/// The first words of statements that can be pasted: links, what is between them, and the numbers that they use.
const WORDS: [&str; 9] =
    ["const", "param", "ground", "link", "joint", "motor", "spring", "damper", "load"];

/// Stands before what was copied, so that it is a mechanism of its own.
const HEAD: &str = "struct Copied;\n";

/// The largest number of steps beside the copied place that are tried.
const STEPS: u32 = 1000;

/// Whether a text has statements alone that can be pasted, and a link among them.
pub(super) fn can_be_pasted(text: &str) -> bool {
    let Some(lexed) = Lexed::read(text) else {
        return false;
    };
    let all = lexed.statements();
    all.iter().any(|one| one.is("link"))
        && all.iter().all(|one| match one.word(0) {
            "start" => true,
            "effects" => one.clauses().iter().all(|clause| clause.is("force")),
            word => WORDS.contains(&word),
        })
}

/// A text with statements that were copied, and the links that are new in it. What is in the scene stands so many steps beside where it was
/// that it is not on what is there.
pub(in crate::editor) fn pasted(
    document: &Document,
    index: usize,
    copied: &str,
    step: [f64; 2],
) -> Result<(String, Vec<String>), String> {
    let source = document.source();
    let path = source.path();
    let text = match source.text() {
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
    let model = before.model(&declaration);
    if model.map_err(|failure| failure.to_string())?.is_none() {
        return Err("the text has mistakes; mend them before something is pasted".to_owned());
    }
    let listing = before.listing(&declaration).ok().flatten();
    let taken = listing.iter().flat_map(places);
    let taken = taken.map(|place| place.map(|number| text[number.place.clone()].to_owned()));
    let copied = &beside(copied, &taken.collect(), step).unwrap_or_else(|| copied.to_owned());
    let tree = before.tree(&declaration);
    let tree = tree.map_err(|failure| failure.to_string())?;
    let tree = tree.ok_or_else(lost)?;
    let mut rewriter = tree.rewriter();
    let known = rewriter.statements.iter();
    let known: BTreeSet<&str> = known.map(|one| &text[tree.bytes(&one.range())]).collect();
    let copied = Lexed::read(copied).ok_or("what was copied is no text of a mechanism")?;
    let all = copied.statements();
    let fresh = all.iter().filter(|one| {
        let is_number = one.is("const") || one.is("param");
        !(is_number && known.contains(copied.text_of(one)))
    });
    let fresh: Vec<&StatementText<'_>> = fresh.collect();
    let renamed = renamed(&fresh, Names::within(&text));
    let links = fresh.iter().filter(|one| one.is("link"));
    let links = links.filter_map(|one| renamed.get(one.word(1)).cloned());
    let links: Vec<String> = links.collect();
    for statement in fresh {
        add(&mut rewriter, &with_names(&copied, statement, &renamed)).ok_or_else(lost)?;
    }
    let text = written(&text, &tree.replacements(&text, &rewriter.edits));
    let (after, declaration) = at(&text).ok_or_else(lost)?;
    match after.model(&declaration) {
        Ok(Some(_)) => Ok((text, links)),
        Ok(None) => {
            let reading = after.analyse(&declaration).map_err(|failure| failure.to_string())?;
            let faults = reading.result.err();
            let first = faults.and_then(|faults| faults.messages.into_iter().next());
            let why = first.map(|message| message.text).unwrap_or_default();
            Err(format!("it cannot be pasted here: {why}"))
        }
        Err(failure) => Err(failure.to_string()),
    }
}

/// Adds a statement, or the clauses of one that stands once.
fn add(rewriter: &mut Rewriter<'_>, statement: &str) -> Option<()> {
    let lexed = Lexed::read(statement)?;
    let all = lexed.statements();
    let one = all.first()?;
    let clauses = || {
        let clauses = one.clauses();
        let clauses = clauses.iter().map(|clause| lexed.text_of(clause));
        clauses.collect::<Vec<_>>().join(" ")
    };
    let siblings: &[&str] = match one.word(0) {
        "ground" => return rewriter.add_item("ground", &clauses()),
        "start" => return rewriter.add_to_start(&clauses()),
        "effects" => return rewriter.ask_for_forces(),
        "const" | "param" => &["const", "param"],
        "link" => &["link", "ground", "param", "const", "look", "use"],
        "joint" => &["joint", "link", "ground"],
        "motor" => &["motor", "joint", "link", "ground"],
        word => &[word, "start", "motor", "joint", "link", "ground"],
    };
    rewriter.add_beside(statement, siblings)
}

fn places(listing: &Listing) -> impl Iterator<Item = [&NumberText; 2]> {
    let part = |number: &NumberText, name| number.role.rsplit(' ').next() == Some(name);
    let pairs = listing.numbers.array_windows();
    pairs.filter(move |[x, y]| part(x, "x") && part(y, "y")).map(|[x, y]| [x, y])
}

/// Moves the copied statements aside, by so many steps that none of their places is taken. None if they cannot be read alone.
fn beside(copied: &str, taken: &BTreeSet<[String; 2]>, step: [f64; 2]) -> Option<String> {
    let source = Source::new("copied.mech", [HEAD, copied].concat());
    let document = Document::of(source);
    let declaration = document.declarations().first()?;
    let model = document.model(declaration).ok()??;
    let listing = document.listing(declaration).ok()??;
    let text = document.source().text();
    let held = held(&model);
    let is_moved = |number: &NumberText| {
        let owner = number.owner.split('.').next().unwrap_or_default();
        !held.contains(owner)
    };
    let tolerance = 1e-9 * model.size();
    let moved = |number: &NumberText, way: f64| {
        let known = &text[number.place.clone()];
        let text = match known.trim().parse::<f64>() {
            Ok(value) => shortest(value + way, tolerance),
            Err(_) => format!("{known} + ({})", shortest(way, tolerance)),
        };
        let range = number.place.clone();
        Replacement { range, text }
    };
    let placed: Vec<[&NumberText; 2]> = places(&listing).filter(|[x, _]| is_moved(x)).collect();
    let at = |steps: u32| {
        let [right, up] = step.map(|way| way * f64::from(steps));
        let placed = placed.iter();
        placed.map(move |[x, y]| [moved(x, right), moved(y, up)])
    };
    let is_free =
        |&steps: &u32| !at(steps).any(|place| taken.contains(&place.map(|number| number.text)));
    let steps = (1..STEPS).find(is_free).unwrap_or(STEPS);
    let mut edits: Vec<Replacement> = at(steps).flatten().collect();
    edits.sort_by_key(|edit| edit.range.start);
    Some(written(text, &edits).split_off(HEAD.len()))
}

/// The links in frames of their own that joints hold to what is in the scene: they go with it.
fn held(model: &Model) -> BTreeSet<&str> {
    let mut held = BTreeSet::new();
    loop {
        let is_known = |link: LinkId| {
            let is_in_scene = link == LinkId::GROUND || model.link(link).drawn;
            is_in_scene || held.contains(model.link(link).name.as_str())
        };
        let next = model.joint_ids().find_map(|joint| {
            let (a, b) = model.ends(joint);
            match (is_known(a), is_known(b)) {
                (true, false) => Some(b),
                (false, true) => Some(a),
                _ => None,
            }
        });
        let Some(link) = next else {
            return held;
        };
        held.insert(model.link(link).name.as_str());
    }
}

/// The new names of what is declared. What is fixed to the ground has a path: others keep their names on their links.
fn renamed(fresh: &[&StatementText<'_>], mut names: Names) -> BTreeMap<String, String> {
    let mut renamed = BTreeMap::new();
    for statement in fresh {
        match statement.word(0) {
            "ground" => {
                for item in statement.clauses() {
                    let path = format!("ground.{}", item.word(1));
                    renamed.insert(path, names.like(item.word(1), false));
                }
            }
            "motor" | "start" | "effects" => {}
            word => {
                let name = statement.word(1);
                renamed.insert(name.to_owned(), names.like(name, word == "joint"));
            }
        }
    }
    renamed
}

fn with_names(
    copied: &Lexed<'_>,
    statement: &StatementText<'_>,
    renamed: &BTreeMap<String, String>,
) -> String {
    let start = copied.bytes(&statement.range()).start;
    let owner = if statement.is("ground") { "ground" } else { statement.word(1) };
    let mut edits = Vec::new();
    let [mut link, mut before] = ["", ""];
    for index in 0..statement.len() {
        let word = statement.word(index);
        let name = match before {
            "." => renamed.get(&format!("{link}.{word}")),
            "point" | "line" => renamed.get(&format!("{owner}.{word}")),
            "color" => None,
            _ => renamed.get(word),
        };
        if let Some(name) = name {
            let token = statement.token(index);
            let range = copied.bytes(&(token..token + 1));
            edits.push(Replacement::new(range.start - start..range.end - start, name.clone()));
        }
        [link, before] = [before, word];
    }
    written(copied.text_of(statement), &edits)
}
