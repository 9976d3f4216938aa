//! What the user does with the text: by tools, by typing, by lines of the dialogue, by steps back and forth.

use super::Editor;
use super::pending::{Pending, Waiting};
use crate::dialogue::{Request, Turn, request};
use crate::edit::{Command, Kind, Saving, Workspace};
use crate::editor::dragging::Dragging;
use crate::editor::opening::Ending;
use crate::editor::settings::{Settings, View};
use crate::editor::tool::{Pick, Tool};
use crate::editor::worker::Worker;
use crate::editor::{Gesture, Item};
use crate::failure::Failure;
use crate::play::Control;
use std::path::Path;

impl Editor {
    /// Chooses a tool.
    pub fn choose(&mut self, tool: Tool) {
        self.obey(Control::Release);
        self.tool = tool;
        self.picks.clear();
        // What was let go already stays where it was let go.
        self.dragging.take_if(|dragging| !dragging.is_released);
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
        match self.tool.gesture(self.drawing.as_ref(), &picks) {
            Ok(gesture) => self.perform(gesture),
            Err(why) => self.refuse(why),
        }
    }

    /// Goes back by a step, or gives up a gesture that was not made yet.
    pub fn undo(&mut self) {
        let is_let_go = |dragging: &mut Dragging| dragging.is_released && dragging.is_awaited();
        if self.dragging.take_if(is_let_go).is_some() {
            self.tell("given up: the drag");
            return;
        }
        if let Some(title) = self.pending.give_up_last() {
            self.let_go();
            self.tell(format!("given up: {title}"));
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
        match &commands[..] {
            [] => self.refuse("nothing is selected"),
            [only] => self.perform(only.clone()),
            several => {
                let title = format!("remove {} things", several.len());
                self.perform(Gesture::new(title, commands));
            }
        }
    }

    /// Goes on with another mechanism of the file, by its number.
    pub(in crate::editor) fn choose_mechanism(&mut self, index: usize) {
        self.session.workspace.choose(index);
        self.pending.clear();
        self.mendings.clear();
        self.ghost = None;
        self.player = None;
        self.drawing = None;
        self.selection.clear();
        self.let_go();
        self.settings.view = View::Ours;
        self.read();
    }

    /// Does what a line of the dialogue says.
    pub fn say(&mut self, line: &str) {
        match request(line) {
            Ok(Some(Request::Ask(words))) if words.first().is_some_and(|word| word == "play") => {
                self.journal.note(line, []);
                self.obey(Control::PlayOrPause);
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
        let (settings, size) = (self.settings.clone(), self.camera.size());
        let pending = Pending::after(&self.pending);
        *self = Self::with(workspace, worker, pending);
        self.settings = Settings {
            view: self.settings.view,
            ..settings
        };
        self.camera.resize(size);
        self.fit();
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
