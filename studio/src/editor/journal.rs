//! What was typed, and what was answered.

use crate::console::Console;
use crate::dialogue::{Session, Turn};
use crate::failure::Failure;
use std::cell::RefCell;
use std::io::{self, Write};
use std::rc::Rc;

/// What was typed, and what was answered.
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
        self.text += &format!("> {line}\n");
        for text in answers.into_iter().filter(|text| !text.is_empty()) {
            self.text += &format!("{text}\n");
        }
    }
}

/// What a console has said.
#[derive(Clone, Default)]
pub(crate) struct Heard(Rc<RefCell<Vec<u8>>>);

impl Heard {
    /// All of it.
    pub(crate) fn text(&self) -> String {
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
