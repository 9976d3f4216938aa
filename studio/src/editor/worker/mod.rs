//! The analysis beside the window: gestures are tried, and texts read, without a stutter.
//!
//! A task is done in pieces, so that what the user waits for comes first: what the compiler makes of a text, then the mechanism that is
//! played, then the repairs. With threads the pieces are done beside the window, in a browser one after each picture.

mod agenda;
mod hold;
mod preview;

use agenda::Agenda;
pub(super) use hold::{Held, Hold, Led};
pub(super) use preview::Previewed;

use super::Gesture;
use super::curves::{Curves, Wanted};
use super::order::Order;
use super::snapshot::{Played, Snapshot};
use crate::document::Document;
use crate::edit::{Applied, Refusal};
use crate::failure::Failure;
use crate::mend::Mending;
use mech_compiler::catch;
use std::collections::VecDeque;
use std::sync::Arc;
#[cfg(not(target_arch = "wasm32"))]
use std::sync::mpsc::{Receiver, Sender, channel};
#[cfg(not(target_arch = "wasm32"))]
use std::thread;

pub(super) enum Task {
    /// A gesture is tried on a text.
    Try {
        number: u64,
        document: Document,
        index: usize,
        gesture: Gesture,
    },
    /// A text is read.
    Read { document: Document, index: usize },
    /// A text is read that will be another at once: while something is dragged, by the number of the drag. Bodies may be wanted.
    Preview {
        number: u64,
        document: Document,
        index: usize,
        has_bodies: bool,
    },
    /// Something is taken hold of in a text.
    Hold(Box<Hold>, Held),
    /// The held item is led to a place, as the drag counts.
    Lead { number: u64, to: [f64; 2] },
    /// A mechanism is measured.
    Measure {
        snapshot: Arc<Snapshot>,
        wanted: Wanted,
    },
    /// A file is written.
    Export(Box<Order>),
    /// The mechanism of a snapshot is made, to be played.
    Move(Arc<Snapshot>),
    /// The repairs of a snapshot are looked for.
    Mend(Arc<Snapshot>),
}

pub(super) enum Finding {
    /// The result of the gesture with this number, and the snapshot after it; or why it is refused.
    Tried(u64, Box<Result<(Applied, Arc<Snapshot>), Refusal>>),
    /// The snapshot of a text.
    Read(Arc<Snapshot>),
    /// Why something, by the number of its drag, cannot be held.
    NotHeld(u64, Refusal),
    /// Where something that is held was led.
    Led(Box<Led>),
    /// The preview of a text while something is dragged.
    Previewed(Box<Previewed>),
    /// The mechanism of a snapshot, to be played.
    Moves(Arc<Snapshot>, Box<Result<Played, Failure>>),
    /// The repairs of a snapshot.
    Mended(Arc<Snapshot>, Result<Vec<Mending>, Failure>),
    Measured(Box<Curves>),
    /// A note on the written file, or why nothing was written.
    Exported(Result<String, Failure>),
    /// A broken invariant of our own, and the work that was not done because of it.
    Broken(Undone, Failure),
}

/// The work that was not done because an invariant of our own is broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Undone {
    /// A gesture was not tried.
    Try,
    /// The item held in the drag with this number was not led.
    Drag(u64),
    /// The text of the drag with this number was not read.
    Preview(u64),
    /// The findings that follow from the present text were not made.
    Follow,
    /// Something that nobody waits for.
    Else,
    /// Nothing is done any more.
    All,
}

impl Task {
    /// Returns the work that stays undone if this task fails.
    const fn undone(&self) -> Undone {
        match self {
            Self::Try { .. } => Undone::Try,
            Self::Hold(hold, _) => Undone::Drag(hold.number),
            Self::Lead { number, .. } => Undone::Drag(*number),
            Self::Preview { number, .. } => Undone::Preview(*number),
            Self::Read { .. } | Self::Move(_) | Self::Mend(_) => Undone::Follow,
            Self::Measure { .. } | Self::Export(_) => Undone::Else,
        }
    }
}

/// Does tasks: beside the window, in pieces, or at once.
pub(super) enum Worker {
    /// At once: for tests, which want to know what comes when.
    Immediate {
        agenda: Agenda,
        found: VecDeque<Finding>,
    },
    /// In pieces, of which one is done after each picture: where there are no threads.
    InPieces {
        agenda: Agenda,
        found: VecDeque<Finding>,
        /// Whether a picture was shown since the last piece.
        is_shown: bool,
    },
    /// In a thread of its own.
    #[cfg(not(target_arch = "wasm32"))]
    Thread {
        tasks: Sender<Task>,
        /// The tasks that hold and lead, for a thread of their own: they do not wait for the analysis of earlier texts.
        drags: Sender<Task>,
        findings: Receiver<Finding>,
        /// For what is done beside the thread.
        outbox: Outbox,
    },
}

/// Where findings go: to the window, which is woken.
#[cfg(not(target_arch = "wasm32"))]
#[derive(Clone)]
pub(super) struct Outbox {
    found: Sender<Finding>,
    wake: Arc<dyn Fn() + Send + Sync>,
}

#[cfg(not(target_arch = "wasm32"))]
impl Outbox {
    /// Sends it. Returns whether anybody listens: nobody does any more when the window is closed.
    fn send(&self, finding: Finding) -> bool {
        let is_heard = self.found.send(finding).is_ok();
        if is_heard {
            (self.wake)();
        }
        is_heard
    }
}

/// The stack of the thread, in bytes: the compiler goes as deep as the text that it reads.
#[cfg(not(target_arch = "wasm32"))]
const STACK: usize = 16 << 20;

impl Worker {
    /// One that does everything at once.
    pub(super) fn immediate() -> Self {
        Self::Immediate {
            agenda: Agenda::default(),
            found: VecDeque::new(),
        }
    }

    /// One that does a piece after each picture.
    pub(super) fn in_pieces() -> Self {
        Self::InPieces {
            agenda: Agenda::default(),
            found: VecDeque::new(),
            is_shown: false,
        }
    }

    /// One with a thread of its own, which calls `wake` when it has found something out.
    ///
    /// # Errors
    /// If the system has no thread for it.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn beside(wake: impl Fn() + Send + Sync + 'static) -> std::io::Result<Self> {
        let (found, findings) = channel();
        let wake = Arc::new(wake);
        let outbox = Outbox { found, wake };
        let serve = |name: &str| {
            let (tasks, to_do) = channel();
            let outbox = outbox.clone();
            let thread = thread::Builder::new().name(name.to_owned());
            thread
                .stack_size(STACK)
                .spawn(move || serve(&to_do, &outbox))?;
            std::io::Result::Ok(tasks)
        };
        Ok(Self::Thread {
            tasks: serve("analysis")?,
            drags: serve("drag")?,
            findings,
            outbox,
        })
    }

    /// Gives it something to do.
    pub(super) fn give(&mut self, task: Task) -> Result<(), Failure> {
        match self {
            Self::Immediate { agenda, found } => {
                agenda.add(task);
                while !agenda.is_done() {
                    found.extend(agenda.go_on());
                }
                Ok(())
            }
            Self::InPieces { agenda, .. } => {
                agenda.add(task);
                Ok(())
            }
            #[cfg(not(target_arch = "wasm32"))]
            Self::Thread {
                tasks,
                drags,
                outbox,
                ..
            } => match task {
                Task::Hold(..) | Task::Lead { .. } => drags.send(task).map_err(|_| ended()),
                // A film takes its time, and nothing else waits for it.
                Task::Export(order) => {
                    let beside = outbox.clone();
                    let export = move || {
                        let done = catch(|| Finding::Exported(order.fulfil()));
                        beside.send(done.unwrap_or_else(|what| broken(Undone::Else, what)));
                    };
                    let thread = thread::Builder::new().name("export".to_owned());
                    if let Err(error) = thread.stack_size(STACK).spawn(export) {
                        let failure = Failure::file(format!("nothing is written: {error}"));
                        outbox.send(Finding::Exported(Err(failure)));
                    }
                    Ok(())
                }
                task => tasks.send(task).map_err(|_| ended()),
            },
        }
    }

    /// Does the next piece between pictures, if it works so, once a picture has shown what the last one found. Returns whether there is more.
    pub(super) fn go_on(&mut self) -> bool {
        let Self::InPieces {
            agenda,
            found,
            is_shown,
        } = self
        else {
            return false;
        };
        if *is_shown {
            found.extend(agenda.go_on());
        }
        *is_shown = !*is_shown;
        !agenda.is_done()
    }

    /// The next of what was found out.
    pub(super) fn next(&mut self) -> Option<Finding> {
        match self {
            Self::Immediate { found, .. } | Self::InPieces { found, .. } => found.pop_front(),
            #[cfg(not(target_arch = "wasm32"))]
            // The window itself can tell, so that the channel never ends.
            Self::Thread { findings, .. } => findings.try_recv().ok(),
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
fn ended() -> Failure {
    Failure::internal("the analysis beside the window has ended")
}

/// Reports a broken invariant of our own.
fn broken(undone: Undone, what: String) -> Finding {
    Finding::Broken(undone, Failure::internal(what))
}

/// Does what comes, until nobody listens any more.
#[cfg(not(target_arch = "wasm32"))]
fn serve(to_do: &Receiver<Task>, outbox: &Outbox) {
    let mut agenda = Agenda::default();
    loop {
        if agenda.is_done() {
            match to_do.recv() {
                Ok(task) => agenda.add(task),
                Err(_) => return,
            }
        }
        while let Ok(task) = to_do.try_recv() {
            agenda.add(task);
        }
        if let Some(finding) = agenda.go_on()
            && !outbox.send(finding)
        {
            return;
        }
    }
}
