//! The tasks for the worker, and the use of its findings.

use super::Editor;
use crate::dialogue::answer;
use crate::edit::{Applied, Refusal};
use crate::editor::arrow::needs;
use crate::editor::clipboard::{gesture_of_copies, pasted};
use crate::editor::drag::Drag;
use crate::editor::gesture::Gesture;
use crate::editor::pending::{Tried, Waiting};
use crate::editor::snap::{CLOSE, grid};
use crate::editor::snapshot::Snapshot;
use crate::editor::tool::NamedPick;
use crate::editor::worker::{Finding, Task, Text, Undone};
use std::sync::Arc;

impl Editor {
    /// Makes a gesture, as soon as those before it are made.
    pub fn perform(&mut self, gesture: impl Into<Gesture>) {
        self.wait(Waiting::Gesture(gesture.into()));
    }

    /// Lets a gesture wait for those before it.
    pub(in crate::editor) fn wait(&mut self, waiting: Waiting) {
        self.analysis.pending.push(waiting);
        self.go_on();
    }

    fn go_on(&mut self) {
        while let Some(waiting) = self.analysis.pending.pop() {
            let (drawing, scale) = (self.sight.drawing(), self.sight.scale());
            let mut said = None;
            let gesture = match waiting {
                Waiting::Gesture(gesture) => gesture,
                Waiting::Line(line) => match self.obey(&line) {
                    Some(gesture) => {
                        said = Some(line);
                        gesture
                    }
                    None => continue,
                },
                Waiting::Copies(links) => match gesture_of_copies(&links, drawing, scale) {
                    Some((gesture, copies)) => {
                        self.selection.select_links(copies);
                        gesture
                    }
                    None => continue,
                },
                Waiting::Paste(copied) => {
                    self.paste(&copied);
                    continue;
                }
                Waiting::Picks(tool, picks) => {
                    let picks = NamedPick::picks(&picks, drawing, CLOSE / scale);
                    match tool.gesture(drawing, &picks) {
                        Ok(gesture) => gesture,
                        Err(why) => {
                            self.talk.refuse(why);
                            continue;
                        }
                    }
                }
            };
            let task = self.analysis.begin(gesture, said, &self.session.workspace);
            self.give(task);
        }
    }

    /// Declares statements that were copied, as one step. The copies are selected.
    fn paste(&mut self, copied: &str) {
        let (document, index) = (self.workspace().document(), self.workspace().index());
        let step = grid(self.sight.scale());
        match pasted(&document, index, copied, [step, -step]) {
            Ok((text, links)) => {
                let title = match links.len() {
                    1 => "paste a link".to_owned(),
                    count => format!("paste {count} links"),
                };
                self.session.workspace.push(title.as_str(), &text);
                self.selection.select_links(links);
                self.take_over(title);
            }
            Err(why) => self.talk.refuse(why),
        }
    }

    /// Has computed what the wanted arrows need.
    pub(in crate::editor) fn prepare_arrows(&mut self) {
        let needs = needs(&self.sight, &self.settings);
        let pending = &mut self.analysis.pending;
        let tasks = self.sight.playing.ask_for(&needs, || pending.number());
        let (playing, settings) = (&self.sight.playing, &self.settings);
        let seen = (&self.analysis.snapshot, settings, &self.selection);
        let roll = self.plotted.roll(playing, seen, || pending.number());
        for task in tasks.into_iter().chain(roll) {
            self.give(task);
        }
    }

    pub(in crate::editor) fn give(&mut self, task: Task) {
        if let Err(failure) = self.analysis.give(task) {
            self.give_up(Undone::All, failure);
        }
        self.look();
    }

    /// Reads the text anew, after it was changed other than by a gesture, or after the analysis was stopped.
    pub(in crate::editor) fn read(&mut self) {
        let document = self.workspace().document();
        // Of fewer mechanisms than there were, the last one is meant.
        let last = document.declarations().len().saturating_sub(1);
        let index = self.workspace().index().min(last);
        self.session.workspace.choose(index);
        self.give(Task::Read(Text { document, index }));
    }

    /// Takes over what was found out since.
    pub fn look(&mut self) {
        while let Some(finding) = self.analysis.worker.next() {
            self.take(finding);
        }
    }

    fn take(&mut self, finding: Finding) {
        match finding {
            Finding::Tried(number, tried) => {
                match (self.analysis.pending.end(number), *tried) {
                    // Nobody waits for it any more. The present text may not have been followed up because of it.
                    (None, _) => self.read(),
                    // On another text it is tried again.
                    (Some(before), _) if !before.is_of(self.workspace()) => {
                        match before.again(self.workspace()) {
                            Ok(waiting) => self.analysis.pending.push_first(waiting),
                            Err(why) => self.talk.refuse(why),
                        }
                    }
                    (Some(before), Ok((applied, snapshot))) => {
                        self.accept(&applied, snapshot, &before);
                    }
                    (Some(before), Err(refusal)) => {
                        if let Some(line) = before.line {
                            self.talk.journal.note(&line, &[&refusal.to_string()]);
                        }
                        self.give_up(Undone::Try, refusal);
                    }
                }
                self.go_on();
            }
            Finding::Read(snapshot) => {
                if snapshot.is_of(self.workspace()) {
                    self.show(snapshot);
                } else if self.analysis.is_mending()
                    && self.analysis.snapshot.is_of(self.workspace())
                {
                    // The tasks that follow from the present text were put aside for it.
                    self.read();
                }
            }
            Finding::NotHeld(number, refusal) => {
                let is_it = |drag: &Drag| drag.number() == Some(number);
                if self.sight.drag.give_up_if(is_it) {
                    self.talk.refuse(refusal);
                }
            }
            Finding::Led(led) => {
                if let Some(told) = self.sight.drag.take(*led) {
                    self.talk.tell_done(told);
                    self.give_preview();
                    if let Some(gesture) = self.sight.drag.come_to_rest() {
                        self.perform(gesture);
                    }
                }
            }
            Finding::Previewed(previewed) => {
                self.sight.take_preview(*previewed);
                self.give_preview();
            }
            Finding::Moves(snapshot, made) => {
                if Arc::ptr_eq(&snapshot, &self.analysis.snapshot) {
                    match *made {
                        Ok(played) => self.sight.play(snapshot, played),
                        Err(failure) => self.talk.refuse(failure),
                    }
                }
            }
            Finding::Ghost(number, snapshot) => {
                let drawing = self.sight.drawing();
                self.analysis.take_ghost(number, &snapshot, drawing);
            }
            Finding::Undone(undone, failure) => self.give_up(undone, failure),
            Finding::Begun(work) => self.analysis.begin_work(work),
            Finding::Ended(work) => self.analysis.end_work(&work),
            Finding::Made(path, made) => {
                let written = made.and_then(|made| made.write(&path));
                self.talk.tell_done(written);
            }
            Finding::Derived(number, what, found) => {
                self.sight.playing.take(number, what, found);
            }
            Finding::Rolled(number, found) => self.plotted.take_centrodes(number, found),
            Finding::Exported(done) => self.talk.tell_done(done),
            Finding::Answered(line, said, done) => self.talk.answer(&line, said, done),
            Finding::Measured(curves) => self.plotted.take(*curves),
            Finding::Mended(snapshot, found) => {
                let done = self.analysis.take_mended(&snapshot, found);
                self.talk.refuse_failed(done);
            }
            Finding::Reported(snapshot, found) => {
                if Arc::ptr_eq(&snapshot, &self.analysis.snapshot) {
                    match found {
                        Ok(behaviour) => self.analysis.behaviour = Some(behaviour),
                        Err(failure) => self.talk.refuse(failure),
                    }
                }
            }
        }
    }

    /// Waits no more for what was not done, and tells why.
    fn give_up(&mut self, undone: Undone, why: impl ToString) {
        self.analysis.take_undone(undone);
        self.sight.drag.take_undone(undone);
        self.plotted.take_undone(undone);
        self.talk.refuse(why);
    }

    /// Ends all work that is done beside the window. The last state that was found out stays.
    pub fn stop(&mut self) {
        if self.analysis.stop() {
            let why = "stopped; what is seen may be of an earlier text";
            self.give_up(Undone::All, why);
        }
    }

    /// Takes over what a gesture does.
    fn accept(&mut self, applied: &Applied, snapshot: Arc<Snapshot>, tried: &Tried) {
        let text = applied.document.source().text();
        self.session.workspace.push(applied.title.as_str(), text);
        match &tried.line {
            Some(line) => self.talk.answer(line, answer(applied), Ok::<_, Refusal>(())),
            None => self.talk.tell(applied.summary()),
        }
        let mut drag = std::mem::take(&mut self.sight.drag);
        self.show(snapshot);
        if drag.left().is_some() {
            // Its own gesture waits for its turn: until then it is seen where it was let go.
            drag.give_up_if(|drag| drag.left() == Some(&tried.gesture));
            self.sight.drag = drag;
            return;
        }
        // A drag that began meanwhile goes on in the new text.
        let is_released = matches!(drag, Drag::Released(_));
        if let Some((items, pointer)) = drag.under_way() {
            self.drag_on(items, pointer);
            if is_released {
                self.end_drag();
            }
        }
    }

    /// Lets go of what was begun in an earlier text.
    pub(super) fn let_go(&mut self) {
        self.sight.drag = Drag::Nothing;
        self.picking.picks.clear();
    }

    /// Shows what the compiler makes of the present text. Of one that cannot be read, the last drawing stays.
    fn show(&mut self, snapshot: Arc<Snapshot>) {
        let picks = NamedPick::all(&self.picking.picks, self.sight.drawing());
        let reach = CLOSE / self.sight.scale();
        let is_empty = self.workspace().text().trim().is_empty();
        self.sight.playing.settle();
        if snapshot.is_readable() {
            self.sight.draw(&snapshot);
        } else if is_empty {
            self.sight.clear();
        }
        if snapshot.is_readable() || is_empty {
            let drawing = self.sight.drawing();
            self.selection.forget_what_is_gone(drawing);
            self.picking.picks = NamedPick::picks(&picks, drawing, reach);
        }
        if let Some(failure) = &snapshot.failure {
            self.talk.refuse(failure);
        }
        self.analysis.take(snapshot);
    }
}
