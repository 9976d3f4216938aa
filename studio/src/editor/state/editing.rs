//! The user's changes of the text: by tools, by typing, by lines of the dialogue, by steps back and forth.

use super::Editor;
use crate::dialogue::{Request, hear, request};
use crate::edit::{Command, Workspace};
use crate::editor::desk::is_picture;
use crate::editor::drag::Drag;
use crate::editor::drawing::{Drawing, distance};
use crate::editor::gesture::Gesture;
use crate::editor::item::Item;
use crate::editor::opening::{Opened, longest, opened};
use crate::editor::pending::{Pending, Waiting};
use crate::editor::question::{Destination, Dialog, Ending};
use crate::editor::tool::{NamedPick, Pick, Picking, Tool};
use crate::editor::worker::{Task, Text, Worker};
use crate::play::Control;
use crate::text::{masked, shortest};
use mech_compiler::model::{AxisId, JointId, Link, LinkId};
use std::collections::BTreeSet;
use std::path::Path;

impl Editor {
    /// Selects something, or adds it to what is selected, or takes it out of that.
    pub fn select(&mut self, item: Option<Item>, adds: bool) {
        match item {
            Some(item) if adds => self.selection.toggle(item),
            Some(item) => self.selection.items = self.desk.group_of(item, self.sight.drawing()),
            None if adds => {}
            None => self.selection.items.clear(),
        }
    }

    /// Chooses a tool.
    pub fn choose(&mut self, tool: Tool) {
        self.sight.obey(Control::Release);
        let picks = Vec::new();
        self.picking = Picking { tool, picks };
        // An item that was let go stays where it was let go.
        self.sight.drag.give_up_if(|drag| drag.held().is_some());
        self.talk.notice = None;
    }

    /// Picks a place with the tool that is chosen. When all are picked, the gesture is made.
    pub(in crate::editor) fn pick(&mut self, pick: Pick) {
        let (Some(picks), tool) = (self.picking.pick(pick), self.picking.tool) else {
            return;
        };
        let drawing = self.sight.drawing();
        if !self.analysis.pending.is_empty() {
            let picks = NamedPick::all(&picks, drawing);
            self.wait(Waiting::Picks(tool, picks));
            return;
        }
        match tool.gesture(drawing, &picks) {
            Ok(gesture) => self.perform(gesture),
            Err(why) => self.talk.refuse(why),
        }
    }

    /// Goes back by a step, or gives up a gesture that was not made yet, or takes back what was moved by hand since the last step.
    pub fn undo(&mut self) {
        let is_released = |drag: &Drag| matches!(drag, Drag::Released(_));
        if self.sight.drag.give_up_if(is_released) {
            self.talk.tell("given up: the drag");
        } else if let Some(title) = self.analysis.pending.give_up_last() {
            self.let_go();
            self.talk.tell(format!("given up: {title}"));
        } else if self.sight.take_back_motion() {
            self.talk.tell("taken back: the motion by hand");
        } else if let Some(title) = self.session.workspace.undo() {
            let told = format!("undone: {title}");
            self.take_over(told);
        }
    }

    /// Makes the step again that was undone.
    pub fn redo(&mut self) {
        if self.analysis.pending.is_empty()
            && let Some(title) = self.session.workspace.redo()
        {
            let told = format!("done again: {title}");
            self.take_over(told);
        }
    }

    /// Takes over a text that was typed, as one step. Typing on is the same step.
    pub fn type_text(&mut self, text: &str) {
        self.session.workspace.retype("text", text);
        self.let_go();
        self.read();
    }

    /// Takes over a text that became another one at once, and tells why it did.
    pub(in crate::editor) fn take_over(&mut self, told: impl Into<String>) {
        self.let_go();
        self.read();
        self.talk.tell(told);
    }

    /// Takes out what is selected.
    pub fn remove_selected(&mut self) {
        match removal(&self.selection.items, self.sight.drawing()) {
            Some(gesture) => self.perform(gesture),
            None => self.talk.refuse("nothing is selected"),
        }
    }

    /// Goes on with another mechanism of the file, by its number.
    pub(in crate::editor) fn choose_mechanism(&mut self, index: usize) {
        self.session.workspace.choose(index);
        self.analysis.make_way();
        self.sight.make_way();
        self.selection.items.clear();
        self.let_go();
        self.read();
    }

    /// Does what a line of the dialogue says.
    pub fn say(&mut self, line: &str) {
        self.talk.journal.lines.push(line.to_owned());
        match request(line) {
            Ok(Some(Request::Ask(words))) if words.first().is_some_and(|word| word == "play") => {
                self.talk.journal.note(line, &[]);
                self.sight.obey(Control::PlayOrPause);
            }
            Ok(Some(Request::Quit)) => {
                self.talk.journal.note(line, &[]);
                self.talk.ending = Ending::Wanted;
            }
            Ok(Some(Request::Open { .. })) if !self.is_at_rest() => {
                let why = "a gesture is still being tried; open the file in a moment";
                self.talk.refuse(why);
            }
            // The session reports lines that it does not understand, too.
            Ok(_) | Err(_) => self.wait(Waiting::Line(line.to_owned())),
        }
    }

    /// Does what a line says whose turn has come. Gives the gesture that it makes, if it makes one: that is to be tried.
    pub(super) fn obey(&mut self, line: &str) -> Option<Gesture> {
        let asked = request(line);
        match asked {
            Ok(Some(Request::Edit(command))) => return Some(command.into()),
            Ok(Some(Request::Ask(_) | Request::Repairs | Request::Numbers(_))) => {
                let text = Text::of(self.workspace());
                self.give(Task::Ask(text, line.to_owned()));
                return None;
            }
            _ => {}
        }
        let before = self.workspace().text().to_owned();
        let (said, turn) = hear(line, &mut self.session);
        let is_done = turn.is_ok();
        self.talk.answer(line, said, turn.map(drop));
        if !matches!(asked, Ok(Some(Request::Open { .. }))) {
            if self.workspace().text() != before {
                self.let_go();
                self.read();
            }
        } else if is_done {
            // Nothing stays of the text before, but what was said.
            let journal = std::mem::take(&mut self.talk.journal);
            self.open(self.workspace().clone());
            self.talk.journal = journal;
        }
        None
    }

    /// Edits another text. If the present one has changes, the user is asked first.
    pub(in crate::editor) fn leave_for(&mut self, to: Destination) {
        if self.has_work() {
            self.talk.dialog = Some(Dialog::Leave(to));
        } else {
            self.arrive(to);
        }
    }

    /// Edits another text, whatever becomes of the present one.
    pub(in crate::editor) fn arrive(&mut self, to: Destination) {
        if to == Destination::Away {
            self.talk.ending = Ending::Granted;
            return;
        }
        match opened(to) {
            Ok(Opened { workspace, losses, told }) => {
                self.open(workspace);
                self.talk.journal.text += &masked(&losses);
                if let Some(told) = told {
                    self.talk.tell(told);
                }
            }
            Err(failure) => self.talk.refuse(failure),
        }
    }

    /// Edits another text.
    pub fn open(&mut self, workspace: Workspace) {
        let worker = std::mem::replace(&mut self.analysis.worker, Worker::immediate());
        let (settings, size) = (self.settings.clone(), self.sight.camera.size());
        let pending = Pending::after(&self.analysis.pending);
        let copied = std::mem::take(&mut self.clipboard.copied);
        *self = Self::with(workspace, worker, pending);
        self.settings = settings;
        self.clipboard.copied = copied;
        self.sight.camera.resize(size);
        self.sight.fit();
    }

    /// Why a file with so many bytes is not taken, if it is not.
    #[must_use]
    pub fn refusal_of(path: &Path, bytes: u64) -> Option<String> {
        let kind = if is_picture(path) { "picture" } else { "text" };
        let most = longest(path);
        let name = path.display();
        (bytes > most)
            .then(|| format!("`{name}` has {bytes} bytes; a {kind} may have {most} at most"))
    }

    /// Tells the user why something is refused.
    pub fn refuse(&mut self, why: &str) {
        self.talk.refuse(why);
    }

    /// Takes a file: a picture goes behind the drawing, a text is edited, if the present one may be left.
    pub fn take_file(&mut self, path: &Path, bytes: Vec<u8>) {
        if let Some(why) = Self::refusal_of(path, bytes.len() as u64) {
            self.talk.refuse(why);
            return;
        }
        if is_picture(path) {
            let shown = self.desk.show(path, &bytes, &self.sight.camera);
            self.talk.tell_done(shown);
            return;
        }
        if let Ok(text) = String::from_utf8(bytes) {
            self.leave_for(Destination::text(path, text));
        } else {
            let path = path.display();
            self.talk.refuse(format!("`{path}` is not a text file"));
        }
    }
}

/// Takes out what is selected; none if nothing is.
fn removal(selected: &BTreeSet<Item>, drawing: Option<&Drawing>) -> Option<Gesture> {
    let commands: Vec<Command> = selected.iter().map(Item::removal).collect();
    let title = match &commands[..] {
        [] => return None,
        [only] => only.title(),
        several => format!("remove {} things", several.len()),
    };
    let ends = drawing.into_iter().flat_map(|drawing| ends_that_stay(selected, drawing));
    Some(Gesture::new(title, ends.chain(commands).collect()))
}

/// Points where links are joined by what is selected and nothing else: without it these are free ends.
fn ends_that_stay(selected: &BTreeSet<Item>, drawing: &Drawing) -> Vec<Command> {
    let model = &drawing.model;
    let is_gone = |link: LinkId| {
        let name = model.link(link).name.clone();
        selected.contains(&Item::Link(name))
    };
    let goes = |joint: &JointId| {
        let name = model.joint(*joint).name.clone();
        let (a, b) = model.ends(*joint);
        selected.contains(&Item::Joint(name)) || is_gone(a) || is_gone(b)
    };
    let (gone, kept): (Vec<JointId>, Vec<JointId>) = model.joint_ids().partition(goes);
    let axes = |joints: Vec<JointId>| {
        let axes = joints.into_iter();
        axes.filter_map(|joint| model.joint(joint).kind.axes()).flatten()
    };
    let kept: BTreeSet<AxisId> = axes(kept).collect();
    let is_there = |axis: &AxisId| kept.contains(axis) || drawing.path(*axis).is_some();
    let tolerance = 1e-9 * model.size();
    let mut found: Vec<(String, [f64; 2])> = Vec::new();
    for axis in axes(gone) {
        let (link, at) = (model.axis(axis).link, model.axis(axis).at);
        let Link { name, die, .. } = model.link(link);
        let mut others = drawing.axes_on(link).filter(is_there);
        let stays = others.any(|other| distance(model.axis(other).at, at) <= tolerance)
            || found
                .iter()
                .any(|(other, place)| other == name && distance(*place, at) <= tolerance);
        // The points of a part are declared in that part.
        let is_own = link != LinkId::GROUND && die.is_none() && !name.contains('.');
        if is_own && !is_gone(link) && !stays {
            found.push((name.clone(), at));
        }
    }
    let mut taken = BTreeSet::new();
    let ends = found.into_iter().map(|(link, at)| {
        let paths = (1_u32..).map(|number| format!("{link}.end{number}"));
        let mut free = paths.filter(|path| drawing.axis(path).is_none());
        let path = free.find(|path| taken.insert(path.clone()));
        Command::Axis {
            path: path.unwrap_or_default(),
            at: at.map(|part| shortest(part, tolerance)),
            along: None,
        }
    });
    ends.collect()
}
