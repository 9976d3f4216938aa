//! The talk: notices, questions, and the lines that were typed.

use super::question::{Dialog, Ending};
use crate::console::Console;
use crate::dialogue::{Session, Turn};
use crate::failure::Failure;
use crate::text::masked;
use std::cell::RefCell;
use std::io::{self, Write};
use std::rc::Rc;

/// A notice at the foot of the window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// The text of the notice.
    pub text: String,
    /// Whether something was refused.
    pub is_refusal: bool,
}

/// The talk: notices, questions, and the lines that were typed.
#[derive(Default)]
pub(super) struct Talk {
    pub(super) notice: Option<Notice>,
    pub(super) journal: Journal,
    /// A line that is to be completed and said.
    pub(super) proposed: Option<String>,
    /// The question in a window of its own.
    pub(super) dialog: Option<Dialog>,
    /// Whether the window stays.
    pub(super) ending: Ending,
}

impl Talk {
    /// Tells something.
    pub(super) fn tell(&mut self, text: impl Into<String>) {
        self.notice = Some(Notice {
            text: masked(&text.into()).into_owned(),
            is_refusal: false,
        });
    }

    /// Tells why something was refused.
    #[expect(clippy::needless_pass_by_value, reason = "nobody needs it any more")]
    pub(super) fn refuse(&mut self, why: impl ToString) {
        self.notice = Some(Notice {
            text: masked(&why.to_string()).into_owned(),
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

/// The lines that were typed, and the answers.
#[derive(Debug, Default)]
pub(crate) struct Journal {
    /// Lines that were typed, from the first to the last.
    pub(crate) lines: Vec<String>,
    /// Everything, as it would stand in a terminal.
    pub(crate) text: String,
}

impl Journal {
    /// Does what a line says; the answer, and how it ended.
    pub(crate) fn obey(
        &mut self,
        line: &str,
        session: &mut Session,
    ) -> (Result<Turn, Failure>, String) {
        let said = Heard::default();
        let done = session.obey(line, &mut Console::to(said.clone(), said.clone()));
        let said = said.text().trim_end().to_owned();
        let error = done.as_ref().err().map(ToString::to_string);
        self.note(line, [Some(said.clone()), error].into_iter().flatten());
        (done, said)
    }

    /// Notes a line, and what was answered.
    pub(crate) fn note(&mut self, line: &str, answers: impl IntoIterator<Item = String>) {
        self.lines.push(line.to_owned());
        self.text += &format!("> {}\n", masked(line));
        for text in answers.into_iter().filter(|text| !text.is_empty()) {
            self.text += &format!("{}\n", masked(&text));
        }
    }
}

/// The text that a console has received.
#[derive(Clone, Default)]
struct Heard(Rc<RefCell<Vec<u8>>>);

impl Heard {
    /// All of it.
    fn text(&self) -> String {
        String::from_utf8_lossy(&self.0.borrow()).into_owned()
    }
}

impl Write for Heard {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
