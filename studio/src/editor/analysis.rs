//! The questions to the compiler, and its findings.

use super::Gesture;
use super::drawing::Drawing;
use super::pending::Pending;
use super::snapshot::Snapshot;
#[cfg(feature = "transfer")]
use super::worker::Remote;
use super::worker::{Task, Text, Undone, Work, Worker};
use crate::document::{Document, Source};
use crate::edit::Workspace;
use crate::failure::Failure;
use crate::mend::Mending;
use crate::report::{Behaviour, Judged};
use std::ops::Range;
use std::sync::Arc;

/// A ghost: the mechanism as a repair would make it.
struct Ghost {
    /// The number of the repair, from 1.
    number: usize,
    /// None until its text is read.
    drawing: Option<Drawing>,
}

pub(super) struct Analysis {
    pub(super) worker: Worker,
    pub(super) pending: Pending,
    /// The snapshot of the present text; of an earlier text while the compiler works.
    pub(super) snapshot: Arc<Snapshot>,
    pub(super) repairs: Repairs,
    /// What the mechanism does; none until it is measured.
    pub(super) behaviour: Option<Behaviour>,
    ghost: Option<Ghost>,
    /// The work that is done beside the window.
    pub(super) works: Vec<Work>,
    /// Whether the user has ended the analysis of the present text.
    is_stopped: bool,
}

pub(super) enum Repairs {
    Sought,
    Found(Vec<Mending>),
}

impl Analysis {
    /// One of a text of which nothing is known yet.
    pub(super) fn new(workspace: &Workspace, worker: Worker, pending: Pending) -> Self {
        let empty = Document::of(Source::new(workspace.path(), ""));
        Self {
            worker,
            pending,
            snapshot: Arc::new(Snapshot::of(empty, workspace.index())),
            repairs: Repairs::Found(Vec::new()),
            behaviour: None,
            ghost: None,
            works: Vec::new(),
            is_stopped: false,
        }
    }

    /// Whether the snapshot is of this text, and no gesture is tried or waits.
    pub(super) fn is_present(&self, workspace: &Workspace) -> bool {
        self.snapshot.is_of(workspace) && self.pending.is_empty()
    }

    pub(super) const fn is_mending(&self) -> bool {
        matches!(self.repairs, Repairs::Sought)
    }

    pub(super) fn mendings(&self) -> &[Mending] {
        match &self.repairs {
            Repairs::Sought => &[],
            Repairs::Found(mendings) => mendings,
        }
    }

    /// What is expected of the mechanism and was not proved, with its place in the text.
    pub(super) fn unmet(&self) -> impl Iterator<Item = (&Judged, Range<usize>)> {
        let reading = self.snapshot.reading.as_deref();
        let declared = reading.into_iter().flat_map(|reading| {
            let all = reading.model.requirements.iter();
            all.map(|requirement| reading.place(requirement.origin))
        });
        let judged = self.behaviour.iter();
        let judged = judged.flat_map(|behaviour| &behaviour.requirements);
        judged.zip(declared).filter(|(one, _)| !one.is_met)
    }

    pub(super) fn give(&mut self, task: Task) -> Result<(), Failure> {
        self.is_stopped &= !matches!(task, Task::Read(_) | Task::Try(..));
        self.worker.give(task)
    }

    /// Notes that a gesture is tried on a text. Gives what there is to do.
    pub(super) fn begin(
        &mut self,
        gesture: Gesture,
        line: Option<String>,
        workspace: &Workspace,
    ) -> Task {
        let number = self.pending.begin(gesture.clone(), line, workspace);
        Task::Try(number, Text::of(workspace), gesture)
    }

    /// Takes over what the compiler makes of the present text.
    pub(super) fn take(&mut self, snapshot: Arc<Snapshot>) {
        self.repairs = match snapshot.reading {
            Some(_) => Repairs::Sought,
            None => Repairs::Found(Vec::new()),
        };
        self.behaviour = None;
        self.ghost = None;
        self.is_stopped = false;
        self.snapshot = snapshot;
    }

    /// Takes over the repairs of a text, if it is the present one.
    pub(super) fn take_mended(
        &mut self,
        snapshot: &Arc<Snapshot>,
        found: Result<Vec<Mending>, Failure>,
    ) -> Result<(), Failure> {
        if Arc::ptr_eq(snapshot, &self.snapshot) {
            self.stop_mending();
            self.repairs = Repairs::Found(found?);
        }
        Ok(())
    }

    /// Waits no more for what was not done.
    pub(super) fn take_undone(&mut self, undone: Undone) {
        if let Undone::Try | Undone::All = undone {
            self.pending.clear();
        }
        if let Undone::Follow | Undone::All = undone {
            self.stop_mending();
        }
    }

    fn stop_mending(&mut self) {
        if self.is_mending() {
            self.repairs = Repairs::Found(Vec::new());
        }
    }

    /// Waits for nothing, and offers nothing: another mechanism is to be read.
    pub(super) fn make_way(&mut self) {
        self.pending.clear();
        if let Repairs::Found(mendings) = &mut self.repairs {
            mendings.clear();
        }
        self.ghost = None;
    }

    /// Shows what a repair would make of the mechanism, by its number from 1; or nothing any more. Gives what there is to do for it.
    pub(super) fn preview_mending(&mut self, number: Option<usize>) -> Option<Task> {
        if self.ghost.as_ref().map(|ghost| ghost.number) == number {
            return None;
        }
        self.ghost = number.map(|number| Ghost { number, drawing: None });
        let number = number?;
        let mending = self.mendings().get(number.checked_sub(1)?)?;
        let path = self.snapshot.document.source().path();
        let document = Document::of(Source::new(path, &*mending.text));
        let index = self.snapshot.index;
        Some(Task::Ghost(number, Text { document, index }))
    }

    /// Takes over what a repair would make of the mechanism, if it is still to be seen.
    pub(super) fn take_ghost(
        &mut self,
        number: usize,
        snapshot: &Snapshot,
        seen: Option<&Drawing>,
    ) {
        if let Some(ghost) = self.ghost.as_mut().filter(|ghost| ghost.number == number) {
            ghost.drawing = snapshot.drawing(seen, false);
        }
    }

    /// The mechanism as a repair would make it.
    pub(super) fn ghost(&self) -> Option<&Drawing> {
        self.ghost.as_ref()?.drawing.as_ref()
    }

    /// Takes what a worker tells that shares no memory with the window.
    #[cfg(feature = "transfer")]
    pub(super) fn remote(&mut self) -> Option<&mut Remote> {
        match &mut self.worker {
            Worker::Remote(remote) => Some(remote),
            _ => None,
        }
    }

    /// Ends all work beside the window. Returns whether that can be ended.
    pub(super) fn stop(&mut self) -> bool {
        let is_stopped = self.worker.stop();
        if is_stopped {
            self.works.clear();
            self.is_stopped = true;
        }
        is_stopped
    }

    /// Whether the user has ended the analysis of the present text.
    pub(super) const fn is_stopped(&self) -> bool {
        self.is_stopped
    }

    pub(super) fn begin_work(&mut self, work: Work) {
        self.works.push(work);
    }

    pub(super) fn end_work(&mut self, work: &Work) {
        if let Some(index) = self.works.iter().position(|one| one == work) {
            self.works.remove(index);
        }
    }
}
