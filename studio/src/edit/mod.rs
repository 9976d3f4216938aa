//! Changes of a mechanism: each command becomes replacements in the text, which are tried before they are accepted.
//!
//! A text is accepted if it can be read: a mechanism that is being built is incoherent most of the time, and its diagnoses are told. A text
//! with mistakes of its own (of grammar, names or numbers) is refused, unless it had them before. An assembly that breaks a rule of
//! assembly is refused, and the rule is named.

mod assemble;
mod command;
mod copy;
mod declare;
mod drag;
mod place;
mod pose;
mod refusal;
mod remove;
mod rename;
mod scene;
mod shape;
mod solve;
mod workspace;

pub use command::{ActionKind, Assembly, Command, Expression, JointForm, Kind, Pair};
pub use drag::{Drag, Dragged, Follower};
pub use refusal::{Refusal, Rule};
pub use workspace::{History, Step, Workspace};

use crate::document::{Document, Reading, Source};
use crate::failure::Failure;
use crate::mend::mendings;
use crate::text::{Replacement, written};
use mech_compiler::syntax::Rewriter;
pub use scene::Known;
use scene::{Scene, declaration_of};
use similar::{DiffTag, TextDiff};

/// A command that was accepted.
#[derive(Clone, Debug)]
pub struct Applied {
    /// A short description of the command.
    pub title: String,
    /// The replacements, in the order of the places.
    pub edits: Vec<Replacement>,
    /// Further notes: on a constant that was solved for, for example.
    pub notes: Vec<String>,
    /// The file after it.
    pub document: Document,
    /// The mechanism after it.
    pub reading: Reading,
}

impl Applied {
    pub(crate) fn summary(&self) -> String {
        let (title, notes) = (&self.title, self.notes.join("; "));
        if notes.is_empty() { title.clone() } else { format!("{title}: {notes}") }
    }
}

/// The change that a command makes to a text, before it is tried.
#[derive(Default)]
struct Change {
    edits: Vec<Replacement>,
    notes: Vec<String>,
    /// Where something comes to stand that is moved, in the frame in which it is declared.
    place: Option<[f64; 2]>,
}

impl Change {
    fn of(scene: &Scene, rewriter: &Rewriter<'_>) -> Result<Self, Refusal> {
        let edits = scene.tree()?.replacements(scene.text(), &rewriter.edits);
        Ok(Self::from(edits))
    }
}

impl From<Replacement> for Change {
    fn from(edit: Replacement) -> Self {
        vec![edit].into()
    }
}

impl From<Vec<Replacement>> for Change {
    fn from(mut edits: Vec<Replacement>) -> Self {
        edits.sort_by_key(|edit| edit.range.start);
        Self { edits, ..Self::default() }
    }
}

/// Applies a command to the mechanism with this number in a file.
///
/// # Errors
/// If the command is refused: nothing is changed then.
pub fn apply(document: &Document, index: usize, command: &Command) -> Result<Applied, Refusal> {
    if let Command::Mechanism { name } = command {
        return begin(document, name);
    }
    if let Command::Repair { number } = command {
        return repair(document, index, *number);
    }
    let scene = Scene::open(document, index)?;
    let change = change(&scene, command)?;
    let place = change.place;
    let mut applied = accept(&scene, command.title(), change)?;
    judge(&scene, command, &applied)?;
    if let (Command::Move { path, .. }, Some(place)) = (command, place) {
        place::judge(&applied.reading.model, path, place)?;
    }
    if let Command::Join(assembly) = command {
        let stand = assemble::stand(assembly, &applied.reading);
        applied.notes.extend(stand);
    }
    Ok(applied)
}

/// Applies commands one after the other, as one step. In between the text only has to be readable; at the end it is judged.
///
/// # Errors
/// If one of the commands is refused: nothing is changed then.
pub fn apply_all(
    document: &Document,
    index: usize,
    title: &str,
    commands: &[Command],
) -> Result<Applied, Refusal> {
    let (last, before) =
        commands.split_last().ok_or_else(|| Refusal::internal("a step without a command"))?;
    if before.is_empty() {
        return apply(document, index, last);
    }
    let mut current = document.clone();
    let mut notes = Vec::new();
    for command in before {
        if matches!(command, Command::Mechanism { .. } | Command::Repair { .. }) {
            current = apply(&current, index, command)?.document;
            continue;
        }
        let scene = Scene::open(&current, index)?;
        let change = change(&scene, command)?;
        if scene.is_readable && scene.model_after(&change.edits)?.is_none() {
            // The full answer says why.
            return Err(apply(&current, index, command)
                .err()
                .unwrap_or_else(|| Refusal::of("the text could not be read any more")));
        }
        notes.extend(change.notes);
        current = scene.document_after(&change.edits);
    }
    let mut applied = apply(&current, index, last)?;
    judge_joints(document, index, before, &applied)?;
    notes.append(&mut applied.notes);
    Ok(Applied {
        title: title.to_owned(),
        edits: differences(document.source().text(), applied.document.source().text()),
        notes,
        ..applied
    })
}

/// Refuses joints that break a rule of assembly which the text kept before all commands.
fn judge_joints(
    document: &Document,
    index: usize,
    commands: &[Command],
    applied: &Applied,
) -> Result<(), Refusal> {
    let mut joints = commands.iter().filter_map(|command| match command {
        Command::Join(assembly) => Some(assembly),
        _ => None,
    });
    if document.declarations().get(index).is_none() {
        return Ok(());
    }
    let scene = Scene::open(document, index)?;
    joints.try_for_each(|assembly| assemble::judge(&scene, assembly, &applied.reading))
}

fn change(scene: &Scene, command: &Command) -> Result<Change, Refusal> {
    match command {
        Command::Move { path, to, pose } => place::shift(scene, path, *to, pose.as_deref()),
        Command::Set { owner, role, value } => declare::set(scene, owner, role, value),
        Command::Rename { path, name } => rename::rename(scene, path, name),
        Command::Remove { kind, name } => remove::remove(scene, *kind, name),
        Command::RemoveShape { link, shape } => shape::remove(scene, link, *shape),
        Command::Layer { link, shape, plane } => shape::layer(scene, link, *shape, plane),
        Command::Recolor { link, shape, color } => shape::recolor(scene, link, *shape, color),
        Command::Reshape { link, shape, outline } => shape::reshape(scene, link, *shape, outline),
        Command::Mirror { name } => copy::mirror(scene, name),
        Command::Duplicate { name, copy } => copy::duplicate(scene, name, copy),
        Command::Join(assembly) => assemble::join(scene, assembly),
        other => declare::declare(scene, other),
    }
}

/// The first statement of a text that has none.
fn begin(document: &Document, name: &str) -> Result<Applied, Refusal> {
    let source = document.source();
    if !document.declarations().is_empty() || !source.text().trim().is_empty() {
        return Err(Refusal::of("the text has a mechanism already"));
    }
    declare::check_name(name)?;
    let end = source.text().len();
    let edits = vec![Replacement::new(end..end, format!("struct {name};\n"))];
    let after = Document::of(Source::new(source.path(), written(source.text(), &edits)));
    let declaration = after.declarations().first();
    let declaration = declaration
        .ok_or_else(|| Refusal::of("a mechanism is begun in a file whose name ends in `.mech`"))?;
    let reading = after.analyse(declaration)?;
    refuse_unread(&reading)?;
    Ok(Applied {
        title: format!("mechanism {name}"),
        edits,
        notes: Vec::new(),
        reading,
        document: after,
    })
}

fn accept(scene: &Scene, title: String, change: Change) -> Result<Applied, Refusal> {
    let document = scene.document_after(&change.edits);
    let (before, after) = (scene.document.declarations(), document.declarations());
    let declaration = after.get(scene.index).filter(|_| before.len() == after.len());
    let declaration = declaration
        .ok_or_else(|| Refusal::of("the brackets of the text would not match any more"))?;
    let reading = document.analyse(declaration)?;
    Ok(Applied { title, edits: change.edits, notes: change.notes, reading, document })
}

/// Refuses a change after which the text cannot be read, or which breaks a rule.
fn judge(scene: &Scene, command: &Command, applied: &Applied) -> Result<(), Refusal> {
    if scene.is_readable {
        refuse_unread(&applied.reading)?;
    } else {
        // Mistakes that were there may stay; others are as bad as ever.
        let (before, after) = (messages(scene.reading()?), messages(&applied.reading));
        let is_new = |one: &&String| !before.contains(one);
        if let Some(message) = after.iter().find(is_new) {
            return Err(Refusal::unread(vec![message.clone()]));
        }
    }
    if let Command::Join(assembly) = command {
        assemble::judge(scene, assembly, &applied.reading)?;
    }
    if let Command::Move { path, pose, .. } = command {
        pose::judge(&applied.reading, path, pose.as_deref())?;
    }
    Ok(())
}

/// The texts of all that is wrong.
fn messages(reading: &Reading) -> Vec<String> {
    let faults = reading.result.as_ref().err();
    let messages = faults.into_iter().flat_map(|faults| &faults.messages);
    messages.map(|message| message.text.clone()).collect()
}

/// Refuses a text with mistakes of its own: no analysis was made of it.
fn refuse_unread(reading: &Reading) -> Result<(), Refusal> {
    match &reading.result {
        Err(faults) if faults.diagnoses.is_empty() => Err(Refusal::unread(messages(reading))),
        _ => Ok(()),
    }
}

/// Makes a repair by its number, as `mech fix` does.
fn repair(document: &Document, index: usize, number: usize) -> Result<Applied, Refusal> {
    let declaration = declaration_of(document, index)?;
    let reading = document.prove(declaration)?;
    let found = mendings(document, declaration, &reading)?;
    let mending = number.checked_sub(1).and_then(|number| found.get(number));
    let mending = mending.ok_or_else(|| match found.len() {
        0 => Refusal::of("no repair is known"),
        count => Refusal::of(format!("there is no repair {number}; the last is {count}")),
    })?;
    let text = &*mending.text;
    let source = document.source();
    let after = Document::of(Source::new(source.path(), text));
    let declaration = after.declarations().get(index);
    let declaration =
        declaration.ok_or_else(|| Refusal::internal("a repair has removed its mechanism"))?;
    let reading = after.analyse(declaration)?;
    Ok(Applied {
        title: format!("repair {number}: {}", mending.words),
        edits: differences(source.text(), text),
        notes: Vec::new(),
        document: after,
        reading,
    })
}

/// Finds the replacements between two texts, line by line.
pub(crate) fn differences(before: &str, after: &str) -> Vec<Replacement> {
    let difference = TextDiff::from_lines(before, after);
    let starts = |lines: &[&str]| {
        let mut at = 0;
        let mut starts = vec![0];
        starts.extend(lines.iter().map(|line| {
            at += line.len();
            at
        }));
        starts
    };
    let (old, new) = (starts(difference.old_slices()), starts(difference.new_slices()));
    let changed = difference.ops().iter().filter(|op| op.tag() != DiffTag::Equal);
    changed
        .map(|op| {
            let (from, by) = (op.old_range(), op.new_range());
            Replacement::new(old[from.start]..old[from.end], &after[new[by.start]..new[by.end]])
        })
        .collect()
}

impl From<Failure> for Refusal {
    fn from(failure: Failure) -> Self {
        Self::failed(&failure)
    }
}
