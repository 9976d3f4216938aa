//! The analysis beside the window: gestures are tried, and texts read, without a stutter.

use super::Gesture;
use super::curves::{Curves, Wanted};
use super::export::Order;
use super::snapshot::{Played, Snapshot};
use crate::document::Document;
use crate::edit::{Applied, Refusal, apply_all};
use crate::failure::Failure;
use crate::mend::Mending;
use std::sync::Arc;

/// What there is to do.
pub(super) enum Task {
    /// A gesture is tried on a text.
    Try {
        document: Document,
        index: usize,
        gesture: Gesture,
    },
    /// A text is read.
    Read { document: Document, index: usize },
    /// A text is read that will be another at once: while something is dragged.
    Preview { document: Document, index: usize },
    /// A mechanism is measured.
    Measure {
        snapshot: Arc<Snapshot>,
        wanted: Wanted,
    },
    /// A file is written.
    Export(Box<Order>),
}

/// What was found out, in this order.
pub(super) enum Finding {
    /// What a gesture does, and what the compiler makes of that; or why it is refused.
    Tried(Box<Result<(Applied, Arc<Snapshot>), Refusal>>),
    /// What the compiler makes of a text.
    Read(Arc<Snapshot>),
    /// What the compiler makes of a text while something is dragged, and the mechanism, if it moves.
    Previewed(Arc<Snapshot>, Box<Option<Result<Played, Failure>>>),
    /// The mechanism of a snapshot, to be played.
    Moves(Arc<Snapshot>, Box<Result<Played, Failure>>),
    /// The repairs of a snapshot.
    Mended(Arc<Snapshot>, Result<Vec<Mending>, Failure>),
    /// What was measured.
    Measured(Box<Curves>),
    /// What was written, or why nothing was.
    Exported(Result<String, Failure>),
}

/// Does a task, and tells what is found out as soon as it is.
fn work(task: Task, tell: &mut dyn FnMut(Finding)) {
    let snapshot = match task {
        Task::Try {
            document,
            index,
            gesture,
        } => match apply_all(&document, index, &gesture.title, &gesture.commands) {
            Ok(applied) => {
                let (document, reading) = (applied.document.clone(), applied.reading.clone());
                let snapshot = Arc::new(Snapshot::analysed(document, index, reading));
                tell(Finding::Tried(Box::new(Ok((applied, snapshot.clone())))));
                snapshot
            }
            Err(refusal) => {
                tell(Finding::Tried(Box::new(Err(refusal))));
                return;
            }
        },
        Task::Preview { document, index } => {
            let snapshot = Arc::new(Snapshot::of(document, index));
            let played = snapshot.played();
            tell(Finding::Previewed(snapshot, Box::new(played)));
            return;
        }
        Task::Export(order) => {
            tell(Finding::Exported(order.fulfil()));
            return;
        }
        Task::Measure { snapshot, wanted } => {
            tell(Finding::Measured(Box::new(Curves::of(snapshot, wanted))));
            return;
        }
        Task::Read { document, index } => {
            let snapshot = Arc::new(Snapshot::of(document, index));
            tell(Finding::Read(snapshot.clone()));
            snapshot
        }
    };
    if let Some(made) = snapshot.played() {
        tell(Finding::Moves(snapshot.clone(), Box::new(made)));
    }
    let mendings = snapshot.mendings();
    tell(Finding::Mended(snapshot, mendings));
}

pub(super) use implementation::Worker;

/// Threads, where there are some.
#[cfg(not(target_arch = "wasm32"))]
mod implementation {
    use super::{Finding, Task, work};
    use crate::failure::Failure;
    use std::collections::VecDeque;
    use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
    use std::thread;

    /// Does tasks one after the other, beside the window or at once.
    pub(in super::super) enum Worker {
        /// At once: for tests, which want to know what comes when.
        Immediate(VecDeque<Finding>),
        /// In a thread of its own.
        Thread {
            tasks: Sender<Task>,
            findings: Receiver<Finding>,
        },
    }

    impl Worker {
        /// One with a thread of its own, which calls `wake` when it has found something out.
        pub(in super::super) fn beside(wake: impl Fn() + Send + 'static) -> Self {
            let (tasks, to_do) = channel::<Task>();
            let (found, findings) = channel();
            thread::spawn(move || {
                for task in to_do {
                    let mut tell = |finding| {
                        // Nobody listens any more when the window is closed.
                        if found.send(finding).is_ok() {
                            wake();
                        }
                    };
                    work(task, &mut tell);
                }
            });
            Self::Thread { tasks, findings }
        }

        /// One that does everything at once.
        pub(in super::super) const fn immediate() -> Self {
            Self::Immediate(VecDeque::new())
        }

        /// Gives it something to do.
        pub(in super::super) fn give(&mut self, task: Task) -> Result<(), Failure> {
            match self {
                Self::Immediate(found) => {
                    work(task, &mut |finding| found.push_back(finding));
                    Ok(())
                }
                Self::Thread { tasks, .. } => {
                    let given = tasks.send(task);
                    given.map_err(|_| Failure::internal("the analysis beside the window has ended"))
                }
            }
        }

        /// The next of what was found out.
        pub(in super::super) fn next(&mut self) -> Result<Option<Finding>, Failure> {
            match self {
                Self::Immediate(found) => Ok(found.pop_front()),
                Self::Thread { findings, .. } => match findings.try_recv() {
                    Ok(finding) => Ok(Some(finding)),
                    Err(TryRecvError::Empty) => Ok(None),
                    Err(TryRecvError::Disconnected) => Err(Failure::internal(
                        "the analysis beside the window has ended",
                    )),
                },
            }
        }
    }
}

/// A browser's page has one thread: everything is done at once.
#[cfg(target_arch = "wasm32")]
mod implementation {
    use super::{Finding, Task, work};
    use crate::failure::Failure;
    use std::collections::VecDeque;

    /// Does tasks at once.
    pub(in super::super) struct Worker(VecDeque<Finding>);

    impl Worker {
        /// One that does everything at once.
        pub(in super::super) const fn immediate() -> Self {
            Self(VecDeque::new())
        }

        /// Gives it something to do.
        #[expect(clippy::unnecessary_wraps, reason = "as with threads")]
        pub(in super::super) fn give(&mut self, task: Task) -> Result<(), Failure> {
            work(task, &mut |finding| self.0.push_back(finding));
            Ok(())
        }

        /// The next of what was found out.
        #[expect(clippy::unnecessary_wraps, reason = "as with threads")]
        pub(in super::super) fn next(&mut self) -> Result<Option<Finding>, Failure> {
            Ok(self.0.pop_front())
        }
    }
}
