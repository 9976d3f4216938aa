//! What the user does with the text: by tools, by typing, by lines of the dialogue, by steps back and forth.

use super::Editor;
use super::pending::{Pending, Waiting};
use crate::dialogue::{Request, Turn, request};
use crate::edit::{Command, Kind, Saving, Workspace};
use crate::editor::drag::Drag;
use crate::editor::drawing::distance;
use crate::editor::question::Ending;
use crate::editor::tool::{Pick, Tool};
use crate::editor::worker::Worker;
use crate::editor::{Gesture, Item};
use crate::failure::Failure;
use crate::play::Control;
use crate::text::shortest;
use mech_compiler::model::{AxisId, JointId, Link, LinkId};
use std::collections::BTreeSet;
use std::path::Path;

impl Editor {
    /// Chooses a tool.
    pub fn choose(&mut self, tool: Tool) {
        self.scene.obey(Control::Release);
        self.tool = tool;
        self.picks.clear();
        // What was let go already stays where it was let go.
        self.scene.drag.give_up_if(|drag| drag.held().is_some());
        self.notice = None;
    }

    /// Picks a place with the tool that is chosen. When all are picked, the gesture is made.
    pub(in crate::editor) fn pick(&mut self, pick: Pick) {
        self.picks.push(pick);
        if self.picks.len() < self.tool.picks().len() {
            return;
        }
        let picks = std::mem::take(&mut self.picks);
        if !self.pending.is_empty() {
            let picks = self.named(&picks);
            self.wait(Waiting::Picks(self.tool, picks));
            return;
        }
        match self.tool.gesture(self.scene.drawing(), &picks) {
            Ok(gesture) => self.perform(gesture),
            Err(why) => self.refuse(why),
        }
    }

    /// Goes back by a step, or gives up a gesture that was not made yet, or takes back what was moved by hand since the last step.
    pub fn undo(&mut self) {
        if self
            .scene
            .drag
            .give_up_if(|drag| matches!(drag, Drag::Released(_)))
        {
            self.tell("given up: the drag");
            return;
        }
        if let Some(title) = self.pending.give_up_last() {
            self.let_go();
            self.tell(format!("given up: {title}"));
            return;
        }
        if self.scene.take_back_motion() {
            self.tell("taken back: the motion by hand");
            return;
        }
        let title = self.session.workspace.undo().map(ToOwned::to_owned);
        self.stepped("undone", title);
    }

    /// Makes the step again that was undone.
    pub fn redo(&mut self) {
        if !self.pending.is_empty() {
            return;
        }
        let title = self.session.workspace.redo().map(ToOwned::to_owned);
        self.stepped("done again", title);
    }

    fn stepped(&mut self, word: &str, title: Option<String>) {
        if let Some(title) = title {
            self.let_go();
            self.read();
            self.tell(format!("{word}: {title}"));
        }
    }

    /// Takes over a text that was typed, as one step. Typing on is the same step.
    pub fn type_text(&mut self, text: &str) {
        self.session.workspace.retype("text", text);
        self.let_go();
        self.read();
    }

    /// Makes a repair, by its number from 1.
    pub fn mend(&mut self, number: usize) {
        if !self.pending.is_empty() || !self.is_present(&self.snapshot) {
            self.refuse("the text has changed since this repair was offered");
            return;
        }
        self.perform(Command::Repair { number });
    }

    /// Takes out what is selected.
    pub fn remove_selected(&mut self) {
        let commands = self.selection.iter().map(|item| Command::Remove {
            kind: match item {
                Item::Link(_) => Kind::Link,
                Item::Joint(_) => Kind::Joint,
                Item::Axis(_) => Kind::Axis,
                Item::Action(_) => Kind::Action,
            },
            name: item.name().to_owned(),
        });
        let commands: Vec<Command> = commands.collect();
        let title = match &commands[..] {
            [] => return self.refuse("nothing is selected"),
            [only] => only.title(),
            several => format!("remove {} things", several.len()),
        };
        let all = self.ends_that_stay().into_iter().chain(commands);
        self.perform(Gesture::new(title, all.collect()));
    }

    /// Points where links are joined by what is selected and nothing else: without it these are free ends.
    fn ends_that_stay(&self) -> Vec<Command> {
        let Some(drawing) = self.scene.drawing() else {
            return Vec::new();
        };
        let model = &drawing.model;
        let is_gone = |link: LinkId| {
            let name = model.link(link).name.clone();
            self.selection.contains(&Item::Link(name))
        };
        let goes = |joint: &JointId| {
            let name = model.joint(*joint).name.clone();
            let (a, b) = model.ends(*joint);
            self.selection.contains(&Item::Joint(name)) || is_gone(a) || is_gone(b)
        };
        let (gone, kept): (Vec<JointId>, Vec<JointId>) = model.joint_ids().partition(goes);
        let axes = |joints: Vec<JointId>| {
            let axes = joints.into_iter();
            axes.filter_map(|joint| model.joint(joint).kind.axes())
                .flatten()
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
            // What a part has is declared there.
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

    /// Goes on with another mechanism of the file, by its number.
    pub(in crate::editor) fn choose_mechanism(&mut self, index: usize) {
        self.session.workspace.choose(index);
        self.pending.clear();
        self.mendings.clear();
        self.ghost = None;
        self.scene.make_way();
        self.selection.clear();
        self.let_go();
        self.read();
    }

    /// Does what a line of the dialogue says.
    pub fn say(&mut self, line: &str) {
        match request(line) {
            Ok(Some(Request::Ask(words))) if words.first().is_some_and(|word| word == "play") => {
                self.journal.note(line, []);
                self.scene.obey(Control::PlayOrPause);
            }
            Ok(Some(Request::Quit)) => {
                self.journal.note(line, []);
                self.ending = Ending::Wanted;
            }
            Ok(Some(Request::Open { .. })) if !self.is_at_rest() => {
                self.refuse("a gesture is still being tried; open the file in a moment");
            }
            Ok(Some(Request::Open { .. })) if self.answer(line) => {
                // Nothing stays of the text before, but what was said.
                let journal = std::mem::take(&mut self.journal);
                self.open(self.workspace().clone());
                self.journal = journal;
            }
            Ok(Some(Request::Open { .. })) => {}
            // What cannot be understood is told there, too.
            Ok(_) | Err(_) => {
                let before = self.workspace().text().to_owned();
                self.answer(line);
                if self.workspace().text() != before {
                    self.let_go();
                    self.read();
                }
            }
        }
    }

    /// Lets the dialogue answer a line. Returns whether it did what that says.
    fn answer(&mut self, line: &str) -> bool {
        let (turn, said) = self.journal.obey(line, &mut self.session);
        match turn {
            Ok(Turn::GoOn | Turn::End) => {
                self.tell(said);
                true
            }
            Err(failure) => {
                self.refuse(failure);
                false
            }
        }
    }

    /// Edits another text.
    pub fn open(&mut self, workspace: Workspace) {
        let worker = std::mem::replace(&mut self.worker, Worker::immediate());
        let (settings, size) = (self.settings.clone(), self.scene.camera.size());
        let pending = Pending::after(&self.pending);
        let copied = std::mem::take(&mut self.copied);
        *self = Self::with(workspace, worker, pending);
        self.settings = settings;
        self.copied = copied;
        self.scene.camera.resize(size);
        self.scene.fit();
    }

    /// Writes the text.
    ///
    /// # Errors
    /// If there is no file yet and none is named, or if it cannot be written.
    pub fn save(&mut self, path: Option<&Path>) -> Result<(), Failure> {
        self.write(path, Ok)
    }

    /// Writes the text over another file, as the user has said.
    ///
    /// # Errors
    /// If that file cannot be read as a text, or not be written.
    pub(in crate::editor) fn save_over(&mut self, path: &Path) -> Result<(), Failure> {
        self.write(Some(path), Saving::over_any)
    }

    fn write(
        &mut self,
        path: Option<&Path>,
        over: impl FnOnce(Saving) -> Result<Saving, Failure>,
    ) -> Result<(), Failure> {
        let before = self.session.workspace.clone();
        let saving = self.session.workspace.save_to(path)?;
        match over(saving).and_then(Saving::write) {
            Ok(path) => {
                self.tell(format!("saved `{}`", path.display()));
                Ok(())
            }
            Err(failure) => {
                self.session.workspace = before;
                Err(failure)
            }
        }
    }
}
