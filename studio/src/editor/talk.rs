//! What is told and asked, and what was typed into the line.

use super::journal::Journal;
use super::question::{Dialog, Ending};
use crate::failure::Failure;

/// What is told at the foot of the window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// What is told.
    pub text: String,
    /// Whether something was refused.
    pub is_refusal: bool,
}

/// What is told and asked, and what was typed into the line.
#[derive(Default)]
pub(super) struct Talk {
    pub(super) notice: Option<Notice>,
    pub(super) journal: Journal,
    /// A line that is to be completed and said.
    pub(super) proposed: Option<String>,
    /// What is asked in a window of its own.
    pub(super) dialog: Option<Dialog>,
    /// Whether the window stays.
    pub(super) ending: Ending,
}

impl Talk {
    /// Tells something.
    pub(super) fn tell(&mut self, text: impl Into<String>) {
        self.notice = Some(Notice {
            text: text.into(),
            is_refusal: false,
        });
    }

    /// Tells why something was refused.
    #[expect(clippy::needless_pass_by_value, reason = "nobody needs it any more")]
    pub(super) fn refuse(&mut self, why: impl ToString) {
        self.notice = Some(Notice {
            text: why.to_string(),
            is_refusal: true,
        });
    }

    /// Tells what was done, or why it was refused.
    pub(super) fn tell_done(&mut self, done: Result<impl Into<String>, impl ToString>) {
        match done {
            Ok(text) => self.tell(text),
            Err(why) => self.refuse(why),
        }
    }

    /// Tells why something could not be done.
    pub(super) fn refuse_failed(&mut self, done: Result<(), Failure>) {
        if let Err(failure) = done {
            self.refuse(failure);
        }
    }
}
