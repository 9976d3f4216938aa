//! What is being done beside the window, in words.

use super::{Task, Use};
use std::fmt::{self, Display, Formatter};

#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(in crate::editor) enum Work {
    /// A gesture with this title is tried.
    Trying(String),
    Analysing,
    Dragging,
    Measuring,
    /// A file of this name is written.
    Writing(String),
    /// This line of the dialogue is answered.
    Answering(String),
    Deriving,
    /// The mechanism is prepared to be played.
    Preparing,
    Mending,
}

impl Work {
    pub(super) fn of(task: &Task) -> Self {
        match task {
            Task::Try(_, _, gesture) => Self::Trying(gesture.title.clone()),
            Task::Read(_) | Task::Ghost(..) => Self::Analysing,
            Task::Preview(..) | Task::Hold(..) | Task::Lead(..) => Self::Dragging,
            Task::Export(order) => Self::Writing(order.path.clone()),
            Task::Ask(_, line) => Self::Answering(line.clone()),
            Task::Of(_, Use::Measure(_) | Use::Report | Use::Roll(..)) => Self::Measuring,
            Task::Of(_, Use::Derive(..)) => Self::Deriving,
            Task::Of(_, Use::Move) => Self::Preparing,
            Task::Of(_, Use::Mend) => Self::Mending,
        }
    }
}

impl Display for Work {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Trying(title) => write!(f, "Trying: {title}"),
            Self::Analysing => f.write_str("Analysing the mechanism"),
            Self::Dragging => f.write_str("Following the pointer"),
            Self::Measuring => f.write_str("Measuring"),
            Self::Writing(path) => write!(f, "Writing {path}"),
            Self::Answering(line) => write!(f, "Answering: {line}"),
            Self::Deriving => f.write_str("Preparing the arrows"),
            Self::Preparing => f.write_str("Preparing to play"),
            Self::Mending => f.write_str("Looking for repairs"),
        }
    }
}
