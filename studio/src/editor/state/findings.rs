//! What is given to the worker, and what is made of its findings.

use super::Editor;
use crate::edit::{Applied, Refusal};
use crate::editor::settings::View;
use crate::editor::snapshot::Snapshot;
use crate::editor::worker::{Finding, Task};
use crate::editor::{Gesture, Item};
use std::sync::Arc;

impl Editor {
    /// Makes a gesture, as soon as those before it are made.
    pub fn perform(&mut self, gesture: impl Into<Gesture>) {
        self.waiting.push_back(gesture.into());
        self.go_on();
    }

    /// Tries the next gesture.
    fn go_on(&mut self) {
        if self.is_trying {
            return;
        }
        if let Some(gesture) = self.waiting.pop_front() {
            self.is_trying = true;
            let task = Task::Try {
                document: self.workspace().document(),
                index: self.workspace().index(),
                gesture,
            };
            self.give(task);
        }
    }

    pub(in crate::editor) fn give(&mut self, task: Task) {
        if let Err(failure) = self.worker.give(task) {
            self.refuse(failure);
        }
        self.look();
    }

    /// Reads the text anew, after it was changed other than by a gesture.
    pub(in crate::editor) fn read(&mut self) {
        self.typed = None;
        let task = Task::Read {
            document: self.workspace().document(),
            index: self.workspace().index(),
        };
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
        loop {
            match self.worker.next() {
                Ok(Some(finding)) => self.take(finding),
                Ok(None) => return,
                Err(failure) => {
                    self.refuse(failure);
                    return;
                }
            }
        }
    }

    fn take(&mut self, finding: Finding) {
        match finding {
            Finding::Tried(tried) => {
                self.is_trying = false;
                match *tried {
                    Ok((applied, snapshot)) => self.accept(&applied, snapshot),
                    Err(refusal) => self.reject(&refusal),
                }
                self.go_on();
            }
            Finding::Read(snapshot) => {
                if self.is_present(&snapshot) {
                    self.show(snapshot);
                }
            }
            Finding::Previewed(snapshot, played) => self.take_preview(&snapshot, *played),
            Finding::Moves(snapshot, made) => {
                if Arc::ptr_eq(&snapshot, &self.snapshot) {
                    match *made {
                        Ok((mechanism, ranges, paths)) => {
                            self.played = Some(snapshot);
                            self.play(mechanism, ranges, paths);
                        }
                        Err(failure) => self.refuse(failure),
                    }
                }
            }
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

    fn accept(&mut self, applied: &Applied, snapshot: Arc<Snapshot>) {
        let text = applied.document.source().text();
        self.session.workspace.push(applied.title.as_str(), text);
        self.typed = None;
        let notes = applied.notes.join("; ");
        self.tell(if notes.is_empty() {
            applied.title.clone()
        } else {
            format!("{}: {notes}", applied.title)
        });
        self.show(snapshot);
    }

    fn reject(&mut self, refusal: &Refusal) {
        self.waiting.clear();
        self.refuse(refusal);
    }

    /// Whether a snapshot is of the present text.
    pub(in crate::editor) fn is_present(&self, snapshot: &Snapshot) -> bool {
        snapshot.document.source().text() == self.workspace().text()
    }

    /// Shows what the compiler makes of the present text. Of one that cannot be read, the last drawing stays.
    fn show(&mut self, snapshot: Arc<Snapshot>) {
        self.mendings.clear();
        self.ghost = None;
        self.is_mending = true;
        if snapshot.is_readable() {
            let was_empty = self.drawing.is_none();
            self.drawing = snapshot.drawing(self.drawing.as_ref(), self.seen_at().is_some());
            self.drawn = Some(snapshot.clone());
            if snapshot.compiled().is_none() {
                self.player = None;
                self.ranges.clear();
                self.paths.clear();
            }
            self.forget_what_is_gone();
            if was_empty && self.settings.view == View::Ours {
                self.settings.view = View::Started;
                self.fit();
            }
        } else if self.workspace().text().trim().is_empty() {
            self.drawn = None;
            self.drawing = None;
            self.player = None;
            self.selection.clear();
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
        let drawing = self.drawing.as_ref();
        let has = |item: &Item| drawing.is_some_and(|drawing| drawing.has(item));
        self.selection.retain(has);
    }
}
