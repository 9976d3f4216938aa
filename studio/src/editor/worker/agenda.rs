//! The tasks to do, in pieces.

use super::{Finding, Led, Previewed, Task, Text, Use, Work, broken};
use crate::dialogue::{Session, hear};
use crate::edit::{Drag, Workspace, apply_all};
use crate::editor::curves::Curves;
use crate::editor::snapshot::Snapshot;
use crate::report::Behaviour;
use mech_compiler::catch;
use std::collections::VecDeque;
use std::sync::Arc;

#[derive(Default)]
pub(in crate::editor) struct Agenda {
    /// The tasks that hold and lead. They come first: the user watches the drag.
    drags: VecDeque<Task>,
    held: Option<(u64, Drag)>,
    /// Whether something was led last.
    was_led: bool,
    given: VecDeque<Task>,
    /// The tasks that follow from the last text, done when no given task waits.
    follows: VecDeque<Task>,
    present: Option<Task>,
}

impl Agenda {
    /// Notes something to do. Of texts that are to be read, of places to which something is led, and of mechanisms that need something
    /// besides positions, the last one alone is wanted.
    pub(super) fn add(&mut self, task: Task) {
        if let Task::Hold(..) | Task::Lead(..) = task {
            let is_lead = |task: &Task| matches!(task, Task::Lead(..));
            self.drags.retain(|other| !is_lead(other));
            self.drags.push_back(task);
            return;
        }
        let is_read = |task: &Task| matches!(task, Task::Read(_));
        let is_preview = |task: &Task| matches!(task, Task::Preview(..));
        if is_read(&task) {
            self.given.retain(|other| !is_read(other));
        } else if is_preview(&task) {
            self.given.retain(|other| !is_preview(other));
        } else if let Task::Of(_, Use::Derive(_, wanted)) = &task {
            let is_it =
                |other: &Task| matches!(other, Task::Of(_, Use::Derive(_, what)) if what == wanted);
            self.given.retain(|other| !is_it(other));
        }
        self.given.push_back(task);
    }

    pub(super) fn is_done(&self) -> bool {
        self.drags.is_empty() && self.given.is_empty() && self.follows.is_empty()
    }

    /// Forgets all tasks, and what is held.
    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }

    /// Takes up the next piece, and tells what it is.
    pub(super) fn begin(&mut self) -> Option<Work> {
        // Where there is one thread for all, a drag leaves room for others.
        let others = |agenda: &mut Self| {
            let given = agenda.given.pop_front();
            given.or_else(|| agenda.follows.pop_front())
        };
        let task = if std::mem::take(&mut self.was_led) {
            others(self).or_else(|| self.drags.pop_front())
        } else {
            self.drags.pop_front().or_else(|| others(self))
        }?;
        self.was_led = matches!(task, Task::Lead(..));
        let work = Work::of(&task);
        self.present = Some(task);
        Some(work)
    }

    /// Does the piece that was taken up, or the next one, and tells what was found out.
    pub(super) fn go_on(&mut self) -> Option<Finding> {
        if self.present.is_none() {
            self.begin();
        }
        let task = self.present.take()?;
        let undone = task.undone();
        catch(|| self.fulfil(task)).unwrap_or_else(|what| Some(broken(undone, what)))
    }

    fn fulfil(&mut self, task: Task) -> Option<Finding> {
        Some(match task {
            Task::Try(number, Text { document, index }, gesture) => {
                let tried = apply_all(&document, index, &gesture.title, &gesture.commands);
                let tried = tried.map(|applied| {
                    let (document, reading) = (applied.document.clone(), applied.reading.clone());
                    let snapshot = Arc::new(Snapshot::analysed(document, index, reading));
                    self.go_on_with(&snapshot);
                    (applied, snapshot)
                });
                Finding::Tried(number, Box::new(tried))
            }
            Task::Read(text) => {
                let snapshot = Arc::new(Snapshot::of(text.document, text.index));
                self.go_on_with(&snapshot);
                Finding::Read(snapshot)
            }
            Task::Ghost(number, text) => {
                Finding::Ghost(number, Snapshot::of(text.document, text.index))
            }
            Task::Preview(number, text, has_bodies, needs) => {
                let previewed = Previewed::of(number, text, has_bodies, &needs);
                Finding::Previewed(Box::new(previewed))
            }
            Task::Hold(hold, text) => {
                let number = hold.number;
                match hold.begin(&text) {
                    Ok(drag) => {
                        self.held = Some((number, drag));
                        return None;
                    }
                    Err(refusal) => Finding::NotHeld(number, refusal),
                }
            }
            Task::Lead(number, to) => {
                let (_, drag) = self.held.as_ref().filter(|(held, _)| *held == number)?;
                Finding::Led(Box::new(Led::of(number, drag, to)))
            }
            Task::Export(order) => {
                let made = order.make();
                Finding::Made(order.path, made)
            }
            Task::Ask(Text { document, index }, line) => {
                let mut workspace = Workspace::of(document.source().clone());
                workspace.choose(index);
                let (said, turn) = hear(&line, &mut Session::of(workspace));
                Finding::Answered(line, said, turn.map(drop))
            }
            Task::Of(snapshot, Use::Measure(wanted)) => {
                Finding::Measured(Box::new(Curves::of(snapshot, *wanted)))
            }
            Task::Of(snapshot, Use::Derive(number, what)) => {
                let (model, compiled) = snapshot.moving()?;
                Finding::Derived(number, what, what.compile(model, compiled))
            }
            Task::Of(snapshot, Use::Roll(number, rolling)) => {
                let (model, compiled) = snapshot.moving()?;
                Finding::Rolled(number, rolling.centrodes(model, compiled))
            }
            Task::Of(snapshot, Use::Move) => {
                let made = snapshot.played()?;
                Finding::Moves(snapshot, Box::new(made))
            }
            Task::Of(snapshot, Use::Mend) => {
                let mendings = snapshot.mendings();
                Finding::Mended(snapshot, mendings)
            }
            Task::Of(snapshot, Use::Report) => {
                let (model, compiled) = snapshot.moving()?;
                let found = Behaviour::of(model, compiled);
                Finding::Reported(snapshot, found)
            }
        })
    }

    /// Takes up the tasks that follow from a new text, in place of those of an earlier one.
    fn go_on_with(&mut self, snapshot: &Arc<Snapshot>) {
        let follows = [Use::Move, Use::Mend, Use::Report];
        self.follows = follows.map(|what| Task::Of(snapshot.clone(), what)).into();
    }
}
