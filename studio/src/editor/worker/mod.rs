//! The analysis beside the window: gestures are tried, and texts read, without a stutter.
//!
//! A task is done in pieces, so that what the user waits for comes first: what the compiler makes of a text, then the mechanism that is
//! played, then the repairs. With threads the pieces are done beside the window, in a browser one after each picture.

mod agenda;
mod hold;
#[cfg(feature = "transfer")]
mod remote;
#[cfg(not(target_arch = "wasm32"))]
mod thread;
#[cfg(feature = "transfer")]
mod transfer;
mod work;

use agenda::Agenda;
pub(super) use hold::{Held, Hold, Led, Previewed};
#[cfg(feature = "transfer")]
pub(super) use remote::Remote;
#[cfg(feature = "transfer")]
pub use remote::{Port, Server};
pub(super) use work::Work;

use super::Gesture;
use super::curves::Curves;
use super::order::{Made, Order};
use super::snapshot::{Played, Snapshot};
use crate::construction::{Centrodes, Rolling};
use crate::document::Document;
use crate::edit::{Applied, Refusal, Workspace};
use crate::failure::Failure;
use crate::job::Measure;
use crate::mend::Mending;
use crate::play::Derived;
use crate::report::Behaviour;
use mech_compiler::Compiled;
use std::collections::{BTreeSet, VecDeque};
use std::sync::Arc;
#[cfg(not(target_arch = "wasm32"))]
use thread::Threads;

/// A text, and the number of a mechanism in it.
#[derive(Clone)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Text {
    pub(super) document: Document,
    pub(super) index: usize,
}

impl Text {
    pub(super) fn of(workspace: &Workspace) -> Self {
        Self { document: workspace.document(), index: workspace.index() }
    }
}

// What is skipped is sent otherwise. It stands at the end, as what is sent is known by its place.
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Task {
    /// A gesture with a number is tried on a text.
    Try(u64, Text, Gesture),
    Read(Text),
    /// The text that a repair would make, by the number of the repair, is read to be seen.
    Ghost(usize, Text),
    /// A text is read that will be another at once: while something is dragged, by the number of the drag. Bodies may be wanted, and what
    /// arrows need.
    Preview(u64, Text, bool, BTreeSet<Derived>),
    /// The item that is held in the drag with this number is led to a place, as the drag counts.
    Lead(u64, [f64; 2]),
    /// A file is written.
    Export(Box<Order>),
    /// A line of the dialogue is answered that leaves the text as it is.
    Ask(Text, String),
    /// Something is taken hold of in a text.
    #[cfg_attr(feature = "transfer", serde(skip))]
    Hold(Box<Hold>, Held),
    /// Something is done with a snapshot.
    #[cfg_attr(feature = "transfer", serde(skip))]
    Of(Arc<Snapshot>, Use),
}

/// What is done with a snapshot.
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Use {
    Measure(Box<Measure>),
    /// It is compiled once more, to compute something besides positions. The task has a number.
    Derive(u64, Derived),
    /// The centrodes of links are found. The task has a number.
    Roll(u64, Box<Rolling>),
    /// Its mechanism is made, to be played.
    Move,
    /// Its repairs are looked for.
    Mend,
    /// What its mechanism does is measured for the report, and what is expected of it is proved.
    Report,
}

#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Finding {
    /// The text that a repair would make, by the number of the repair.
    Ghost(usize, Snapshot),
    /// Why something, by the number of its drag, cannot be held.
    NotHeld(u64, Refusal),
    /// Where something that is held was led.
    Led(Box<Led>),
    Previewed(Box<Previewed>),
    /// A mechanism that was compiled once more, by the number of the task; none if that is not possible.
    Derived(u64, Derived, Option<Box<Compiled>>),
    /// The centrodes of links, by the number of the task.
    Rolled(u64, Vec<Centrodes>),
    /// What is to be written to a path, or why it could not be made.
    Made(String, Result<Made, Failure>),
    /// A line of the dialogue, what is said to it, and how it ended.
    Answered(String, String, Result<(), Failure>),
    /// The work that was not done, and why: an invariant of our own is broken, or the user has stopped it.
    Undone(Undone, Failure),
    /// Work begins that takes its time, perhaps.
    Begun(Work),
    Ended(Work),
    /// The result of the gesture with this number, and the snapshot after it; or why it is refused.
    #[cfg_attr(feature = "transfer", serde(skip))]
    Tried(u64, Box<Result<(Applied, Arc<Snapshot>), Refusal>>),
    #[cfg_attr(feature = "transfer", serde(skip))]
    Read(Arc<Snapshot>),
    /// The mechanism of a snapshot, to be played.
    #[cfg_attr(feature = "transfer", serde(skip))]
    Moves(Arc<Snapshot>, Box<Result<Played, Failure>>),
    #[cfg_attr(feature = "transfer", serde(skip))]
    Mended(Arc<Snapshot>, Result<Vec<Mending>, Failure>),
    /// What the mechanism of a snapshot does.
    #[cfg_attr(feature = "transfer", serde(skip))]
    Reported(Arc<Snapshot>, Result<Behaviour, Failure>),
    #[cfg_attr(feature = "transfer", serde(skip))]
    Measured(Box<Curves>),
    /// A note on the written file, or why nothing was written.
    #[cfg_attr(feature = "transfer", serde(skip))]
    Exported(Result<String, Failure>),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Undone {
    Try,
    /// The item held in the drag with this number was not led.
    Drag(u64),
    /// The text of the drag with this number was not read.
    Preview(u64),
    /// The findings that follow from the present text were not made.
    Follow,
    Measure,
    /// Something that nobody waits for.
    Else,
    All,
}

impl Task {
    /// Returns the work that stays undone if this task fails.
    const fn undone(&self) -> Undone {
        match self {
            Self::Try(..) => Undone::Try,
            Self::Hold(hold, _) => Undone::Drag(hold.number),
            Self::Lead(number, _) => Undone::Drag(*number),
            Self::Preview(number, ..) => Undone::Preview(*number),
            Self::Read(_) | Self::Of(_, Use::Move | Use::Mend | Use::Report) => Undone::Follow,
            Self::Of(_, Use::Measure(_)) => Undone::Measure,
            Self::Ghost(..)
            | Self::Export(_)
            | Self::Ask(..)
            | Self::Of(_, Use::Derive(..) | Use::Roll(..)) => Undone::Else,
        }
    }
}

/// Does tasks: beside the window, in pieces, or at once.
pub(super) enum Worker {
    /// In pieces, of which one is done after each picture: where there are no threads. Or at once: for tests, which want to know what comes when.
    Here {
        agenda: Box<Agenda>,
        found: VecDeque<Finding>,
        /// Whether a picture was shown since the last piece; none if all is done at once.
        is_shown: Option<bool>,
    },
    #[cfg(not(target_arch = "wasm32"))]
    Threads(Threads),
    /// In another program, as that of a page's worker.
    #[cfg(feature = "transfer")]
    Remote(Box<Remote>),
}

impl Worker {
    pub(super) fn immediate() -> Self {
        Self::here(None)
    }

    /// One that does a piece after each picture.
    pub(super) fn in_pieces() -> Self {
        Self::here(Some(false))
    }

    fn here(is_shown: Option<bool>) -> Self {
        Self::Here { agenda: Box::default(), found: VecDeque::new(), is_shown }
    }

    /// One with threads of its own, which call `wake` when they have found something out.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn beside(wake: impl Fn() + Send + Sync + 'static) -> std::io::Result<Self> {
        Threads::new(wake).map(Self::Threads)
    }

    pub(super) fn give(&mut self, task: Task) -> Result<(), Failure> {
        match self {
            Self::Here { agenda, found, is_shown } => {
                agenda.add(task);
                while is_shown.is_none() && !agenda.is_done() {
                    found.extend(agenda.go_on());
                }
                Ok(())
            }
            #[cfg(not(target_arch = "wasm32"))]
            Self::Threads(threads) => threads.give(task),
            #[cfg(feature = "transfer")]
            Self::Remote(remote) => remote.give(task),
        }
    }

    /// Ends all work that was given. Returns whether it can be ended: what is done at once, or in pieces, cannot.
    pub(super) fn stop(&mut self) -> bool {
        match self {
            Self::Here { .. } => false,
            #[cfg(not(target_arch = "wasm32"))]
            Self::Threads(threads) => {
                threads.stop();
                true
            }
            #[cfg(feature = "transfer")]
            Self::Remote(remote) => {
                remote.restart();
                true
            }
        }
    }

    /// Does the next piece between pictures, if it works so, once a picture has shown what the last one found. Returns whether there is more.
    pub(super) fn go_on(&mut self) -> bool {
        let Self::Here { agenda, found, is_shown: Some(is_shown) } = self else {
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
            Self::Here { found, .. } => found.pop_front(),
            #[cfg(not(target_arch = "wasm32"))]
            Self::Threads(threads) => threads.next(),
            #[cfg(feature = "transfer")]
            Self::Remote(remote) => remote.next(),
        }
    }
}

/// Reports a broken invariant of our own.
fn broken(undone: Undone, what: String) -> Finding {
    Finding::Undone(undone, Failure::internal(what))
}
