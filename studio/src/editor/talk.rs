//! The talk: notices, questions, and the lines that were typed.

use super::question::{Dialog, Ending};
use crate::failure::Failure;
use crate::text::masked;

/// A notice at the foot of the window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// The text of the notice.
    pub text: String,
    /// Whether something was refused.
    pub is_refusal: bool,
}

#[derive(Default)]
pub(super) struct Talk {
    pub(super) notice: Option<Notice>,
    pub(super) journal: Journal,
    /// A line that is to be completed and said.
    pub(super) proposed: Option<String>,
    /// The question in a window of its own.
    pub(super) dialog: Option<Dialog>,
    pub(super) ending: Ending,
}

impl Talk {
    pub(super) fn tell(&mut self, text: impl Into<String>) {
        self.notice = Some(Notice { text: masked(&text.into()).into_owned(), is_refusal: false });
    }

    #[expect(clippy::needless_pass_by_value, reason = "nobody needs it any more")]
    pub(super) fn refuse(&mut self, why: impl ToString) {
        self.notice =
            Some(Notice { text: masked(&why.to_string()).into_owned(), is_refusal: true });
    }

    /// Tells what was done, or why it was refused.
    pub(super) fn tell_done(&mut self, done: Result<impl Into<String>, impl ToString>) {
        match done {
            Ok(text) => self.tell(text),
            Err(why) => self.refuse(why),
        }
    }

    /// Notes what was said to a line, and how it ended. Tells it.
    pub(super) fn answer(&mut self, line: &str, said: String, done: Result<(), impl ToString>) {
        let done = done.map_err(|why| why.to_string());
        let why = done.as_ref().err().map_or("", String::as_str);
        self.journal.note(line, &[&said, why]);
        self.tell_done(done.map(|()| said));
    }

    /// Tells why something could not be done.
    pub(super) fn refuse_failed(&mut self, done: Result<(), Failure>) {
        if let Err(failure) = done {
            self.refuse(failure);
        }
    }
}

/// The lines that were typed, and the answers.
#[derive(Debug, Default)]
pub(crate) struct Journal {
    /// Lines that were typed, from the first to the last.
    pub(crate) lines: Vec<String>,
    /// Everything, as it would stand in a terminal.
    pub(crate) text: String,
}

impl Journal {
    pub(crate) fn note(&mut self, line: &str, answers: &[&str]) {
        self.text += &format!("> {}\n", masked(line));
        for text in answers.iter().filter(|text| !text.is_empty()) {
            self.text += &format!("{}\n", masked(text));
        }
    }
}
