//! What is given to the worker, and what is made of its findings.

use super::Editor;
use super::pending::Waiting;
use crate::edit::{Applied, Command, Refusal};
use crate::editor::drag::Drag;
use crate::editor::snap::CLOSE;
use crate::editor::snapshot::Snapshot;
use crate::editor::tool::{NamedPick, Pick, Tool};
use crate::editor::worker::{Finding, Task, Undone};
use crate::editor::{Gesture, Item};
use crate::failure::Failure;
use std::sync::Arc;

impl Editor {
    /// Makes a gesture, as soon as those before it are made.
    pub fn perform(&mut self, gesture: impl Into<Gesture>) {
        self.wait(Waiting::Gesture(gesture.into()));
    }

    /// Lets a gesture wait for those before it.
    pub(in crate::editor) fn wait(&mut self, waiting: Waiting) {
        self.pending.push(waiting);
        self.go_on();
    }

    /// Tries the next gesture.
    fn go_on(&mut self) {
        while let Some(waiting) = self.pending.pop() {
            let gesture = match waiting {
                Waiting::Gesture(gesture) => gesture,
                Waiting::Copies(links) => match self.gesture_of_copies(&links) {
                    Some(gesture) => gesture,
                    None => continue,
                },
                Waiting::Paste(copied) => {
                    self.paste_now(&copied);
                    continue;
                }
                Waiting::Picks(tool, picks) => match self.gesture_of(tool, &picks) {
                    Ok(gesture) => gesture,
                    Err(why) => {
                        self.refuse(why);
                        continue;
                    }
                },
            };
            self.try_out(gesture);
        }
    }

    fn try_out(&mut self, gesture: Gesture) {
        let (text, index) = (self.session.workspace.text(), self.workspace().index());
        let number = self.pending.begin(gesture.clone(), text, index);
        let task = Task::Try {
            number,
            document: self.workspace().document(),
            index,
            gesture,
        };
        self.give(task);
    }

    /// The gesture of a tool, with what is by now where it was picked.
    fn gesture_of(&self, tool: Tool, picks: &[NamedPick]) -> Result<Gesture, String> {
        let picks = self.picked(picks, CLOSE / self.scene.scale());
        tool.gesture(self.scene.drawing(), &picks)
    }

    /// What is by now where something was picked.
    fn picked(&self, picks: &[NamedPick], reach: f64) -> Vec<Pick> {
        let picks = picks.iter();
        picks
            .map(|pick| pick.within(self.scene.drawing(), reach))
            .collect()
    }

    /// What was picked, by its names.
    pub(super) fn named(&self, picks: &[Pick]) -> Vec<NamedPick> {
        let picks = picks.iter();
        picks
            .map(|pick| NamedPick::of(pick, self.scene.drawing()))
            .collect()
    }

    pub(in crate::editor) fn give(&mut self, task: Task) {
        if let Err(failure) = self.worker.give(task) {
            self.take_undone(Undone::All, &failure);
        }
        self.look();
    }

    /// Reads the text anew, after it was changed other than by a gesture.
    pub(in crate::editor) fn read(&mut self) {
        let document = self.workspace().document();
        // Of fewer mechanisms than there were, the last one is meant.
        let last = document.declarations().len().saturating_sub(1);
        let index = self.workspace().index().min(last);
        self.session.workspace.choose(index);
        let task = Task::Read { document, index };
        self.give(task);
    }

    /// Does a piece of the analysis, where there is no thread for it. Returns whether there is more to do.
    pub(in crate::editor) fn analyse_on(&mut self) -> bool {
        let is_more = self.worker.go_on();
        self.look();
        is_more
    }

    /// Takes over what was found out since.
    pub fn look(&mut self) {
        while let Some(finding) = self.worker.next() {
            self.take(finding);
        }
    }

    fn take(&mut self, finding: Finding) {
        match finding {
            Finding::Tried(number, tried) => {
                self.take_tried(number, *tried);
                self.go_on();
            }
            Finding::Read(snapshot) => {
                if self.is_present(&snapshot) {
                    self.show(snapshot);
                } else if self.is_mending && self.is_present(&self.snapshot) {
                    // What follows from the present text was put aside for it.
                    self.read();
                }
            }
            Finding::NotHeld(number, refusal) => {
                if self
                    .scene
                    .drag
                    .give_up_if(|drag| drag.number() == Some(number))
                {
                    self.refuse(refusal);
                }
            }
            Finding::Led(led) => self.take_led(*led),
            Finding::Previewed(previewed) => self.take_preview(*previewed),
            Finding::Moves(snapshot, made) => {
                if Arc::ptr_eq(&snapshot, &self.snapshot) {
                    match *made {
                        Ok(played) => self.scene.play(snapshot, played),
                        Err(failure) => self.refuse(failure),
                    }
                }
            }
            Finding::Broken(undone, failure) => self.take_undone(undone, &failure),
            Finding::Exported(done) => self.take_export(done),
            Finding::Measured(curves) => self.take_curves(*curves),
            Finding::Mended(snapshot, found) => {
                if Arc::ptr_eq(&snapshot, &self.snapshot) {
                    self.is_mending = false;
                    match found {
                        Ok(found) => self.mendings = found,
                        Err(failure) => self.refuse(failure),
                    }
                }
            }
        }
    }

    /// Waits no more for what was not done.
    fn take_undone(&mut self, undone: Undone, failure: &Failure) {
        if let Undone::Try | Undone::All = undone {
            self.pending.clear();
            self.drop_left();
        }
        if let Undone::Follow | Undone::All = undone {
            self.is_mending = false;
        }
        self.scene.drag.give_up_if(|drag| match undone {
            Undone::Drag(number) => drag.number() == Some(number),
            Undone::All => true,
            _ => false,
        });
        if let Undone::Preview(number) = undone
            && let Some(preview) = self.scene.drag.preview_mut(number)
        {
            preview.is_awaited = false;
        }
        self.refuse(failure);
    }

    /// Takes over what a gesture does, if the text is still the one on which it was tried. On another text it is tried again.
    fn take_tried(&mut self, number: u64, tried: Result<(Applied, Arc<Snapshot>), Refusal>) {
        let Some(before) = self.pending.end(number) else {
            // Nobody waits for it any more. The present text may not have been followed up because of it.
            self.read();
            return;
        };
        if !before.is_of(self.workspace().text(), self.workspace().index()) {
            let commands = &before.gesture.commands;
            let is_repair = |command: &Command| matches!(command, Command::Repair { .. });
            // Repairs of another text have other numbers.
            if commands.iter().any(is_repair) {
                self.refuse("the text has changed since this repair was offered");
            } else if before.index() != self.workspace().index() {
                self.refuse("another mechanism of the file was chosen meanwhile");
            } else {
                self.pending.push_first(before.gesture);
            }
            return;
        }
        match tried {
            Ok((applied, snapshot)) => {
                self.accept(&applied, snapshot, &before.gesture);
            }
            Err(refusal) => self.reject(&refusal),
        }
    }

    /// Takes over what a gesture does.
    fn accept(&mut self, applied: &Applied, snapshot: Arc<Snapshot>, gesture: &Gesture) {
        let text = applied.document.source().text();
        self.session.workspace.push(applied.title.as_str(), text);
        let notes = applied.notes.join("; ");
        self.tell(if notes.is_empty() {
            applied.title.clone()
        } else {
            format!("{}: {notes}", applied.title)
        });
        let mut drag = std::mem::take(&mut self.scene.drag);
        self.show(snapshot);
        if drag.left().is_some() {
            // Its own gesture waits for its turn: until then it is seen where it was let go.
            drag.give_up_if(|drag| drag.left() == Some(gesture));
            self.scene.drag = drag;
            return;
        }
        // What was begun meanwhile goes on in the new text.
        let is_released = matches!(drag, Drag::Released(_));
        if let Some((items, pointer)) = drag.under_way() {
            self.drag_on(items, pointer);
            if is_released {
                self.end_drag();
            }
        }
    }

    fn reject(&mut self, refusal: &Refusal) {
        self.pending.clear();
        self.drop_left();
        self.refuse(refusal);
    }

    /// Forgets what was dragged and let go, and whose gesture is not made.
    fn drop_left(&mut self) {
        self.scene.drag.give_up_if(|drag| drag.left().is_some());
    }

    /// Lets go of what was begun in an earlier text.
    pub(in crate::editor) fn let_go(&mut self) {
        self.scene.drag = Drag::Nothing;
        self.picks.clear();
    }

    /// Whether a snapshot is of the present text.
    pub(in crate::editor) fn is_present(&self, snapshot: &Snapshot) -> bool {
        snapshot.index == self.workspace().index()
            && snapshot.document.source().text() == self.workspace().text()
    }

    /// Shows what the compiler makes of the present text. Of one that cannot be read, the last drawing stays.
    fn show(&mut self, snapshot: Arc<Snapshot>) {
        let picks = self.named(&self.picks);
        self.mendings.clear();
        self.ghost = None;
        self.is_mending = true;
        self.scene.playing.settle();
        let reach = CLOSE / self.scene.scale();
        if snapshot.is_readable() {
            self.scene.draw(&snapshot);
            self.forget_what_is_gone();
            self.picks = self.picked(&picks, reach);
        } else if self.workspace().text().trim().is_empty() {
            self.scene.clear();
            self.selection.clear();
            self.picks = self.picked(&picks, reach);
        }
        if snapshot.reading.is_none() {
            self.is_mending = false;
        }
        if let Some(failure) = &snapshot.failure {
            self.refuse(failure);
        }
        self.snapshot = snapshot;
    }

    /// Takes what is not there any more out of the selection.
    fn forget_what_is_gone(&mut self) {
        let drawing = self.scene.drawing();
        let has = |item: &Item| drawing.is_some_and(|drawing| drawing.has(item));
        self.selection.retain(has);
    }
}
