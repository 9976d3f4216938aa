//! What is said to a line, as text.

use super::{Session, Turn};
use crate::console::Console;
use crate::failure::Failure;
use std::cell::RefCell;
use std::io::{self, Write};
use std::rc::Rc;

/// Does what a line says: what is said to it, and how it ended.
pub(crate) fn hear(line: &str, session: &mut Session) -> (String, Result<Turn, Failure>) {
    let heard = Heard::default();
    let done = session.obey(line, &mut Console::to(heard.clone(), heard.clone()));
    let said = String::from_utf8_lossy(&heard.0.borrow())
        .trim_end()
        .to_owned();
    (said, done)
}

/// The text that a console has received.
#[derive(Clone, Default)]
struct Heard(Rc<RefCell<Vec<u8>>>);

impl Write for Heard {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
