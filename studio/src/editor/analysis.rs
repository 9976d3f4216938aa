//! The questions to the compiler, and its findings.

use super::Gesture;
use super::drawing::Drawing;
use super::pending::Pending;
use super::snapshot::Snapshot;
use super::worker::{Task, Undone, Worker};
use crate::document::{Document, Source};
use crate::edit::Workspace;
use crate::failure::Failure;
use crate::mend::Mending;
use std::sync::Arc;

/// A ghost: the mechanism as a repair would make it.
pub(super) struct Ghost {
    /// The number of the repair, from 1.
    number: usize,
    pub(super) drawing: Drawing,
}

/// The questions to the compiler, and its findings.
pub(super) struct Analysis {
    pub(super) worker: Worker,
    pub(super) pending: Pending,
    /// The snapshot of the present text; of an earlier text while the compiler works.
    pub(super) snapshot: Arc<Snapshot>,
    pub(super) repairs: Repairs,
    pub(super) ghost: Option<Ghost>,
}

/// The repairs of a text.
pub(super) enum Repairs {
    /// They are looked for.
    Sought,
    /// They are offered.
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
            ghost: None,
        }
    }

    /// Whether the snapshot is of this text, and no gesture is tried or waits.
    pub(super) fn is_present(&self, workspace: &Workspace) -> bool {
        self.snapshot.is_of(workspace) && self.pending.is_empty()
    }

    /// Whether repairs are still looked for.
    pub(super) const fn is_mending(&self) -> bool {
        matches!(self.repairs, Repairs::Sought)
    }

    /// The repairs that are offered.
    pub(super) fn mendings(&self) -> &[Mending] {
        match &self.repairs {
            Repairs::Sought => &[],
            Repairs::Found(mendings) => mendings,
        }
    }

    /// Notes that a gesture is tried on a text. Gives what there is to do.
    pub(super) fn begin(&mut self, gesture: Gesture, workspace: &Workspace) -> Task {
        Task::Try {
            number: self.pending.begin(gesture.clone(), workspace),
            document: workspace.document(),
            index: workspace.index(),
            gesture,
        }
    }

    /// Takes over what the compiler makes of the present text.
    pub(super) fn take(&mut self, snapshot: Arc<Snapshot>) {
        self.repairs = match snapshot.reading {
            Some(_) => Repairs::Sought,
            None => Repairs::Found(Vec::new()),
        };
        self.ghost = None;
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

    /// Looks for repairs no more.
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

    /// Shows what a repair would make of the mechanism, by its number from 1; or nothing any more.
    pub(super) fn preview_mending(&mut self, number: Option<usize>, drawing: Option<&Drawing>) {
        if self.ghost.as_ref().map(|ghost| ghost.number) == number {
            return;
        }
        self.ghost = number.and_then(|number| {
            let mending = self.mendings().get(number.checked_sub(1)?)?;
            let path = self.snapshot.document.source().path();
            let document = Document::of(Source::new(path, &*mending.text));
            let drawing = Snapshot::of(document, self.snapshot.index).drawing(drawing, false)?;
            Some(Ghost { number, drawing })
        });
    }
}
