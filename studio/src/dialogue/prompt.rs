//! The dialogue with somebody at a terminal, or with lines from elsewhere.

use super::completion::complete;
use super::session::{Session, Turn};
use crate::console::Console;
use crate::document::Listing;
use crate::failure::{Failure, FailureKind};
use crate::input::read_line;
use crate::output::{Fence, Writer};
use rustyline::completion::Completer;
use rustyline::error::ReadlineError;
use rustyline::highlight::Highlighter;
use rustyline::hint::Hinter;
use rustyline::history::MemHistory;
use rustyline::validate::Validator;
use rustyline::{Config, Context, Editor, Helper};
use std::io::{self, IsTerminal};
use std::path::PathBuf;

/// The first lines for the user.
const GREETING: &str = "`help` lists what can be said, `quit` ends.\n";

/// Talks until the user ends it.
pub(crate) fn converse(allow_write: &[PathBuf], console: &mut Console) -> Result<(), Failure> {
    if io::stdin().is_terminal() { at_terminal(console) } else { from_lines(allow_write, console) }
}

/// The longest line that is read, in bytes.
const LONGEST: u64 = 1 << 20;

/// Lines that nobody types, so that they are a script: they write in the present folder only. Each is tried; if one is refused, the exit
/// code says so.
fn from_lines(allow_write: &[PathBuf], console: &mut Console) -> Result<(), Failure> {
    let fence = Fence::around(None, allow_write)?;
    let mut session = Session::new(Writer::within(fence));
    let mut worst = None;
    let mut input = io::stdin().lock();
    let unread = |error| Failure::file(format!("cannot read a line: {error}"));
    while let Some(line) = read_line(&mut input, LONGEST).map_err(unread)? {
        match session.obey(&line, console) {
            Ok(Turn::GoOn) => {}
            Ok(Turn::End) => break,
            Err(failure) => {
                complain(&failure, console)?;
                worst = Some(failure.kind());
            }
        }
    }
    worst.map_or(Ok(()), |kind| Err(Failure::reported(kind)))
}

fn at_terminal(console: &mut Console) -> Result<(), Failure> {
    let config = Config::builder().auto_add_history(true).build();
    let unread = |error: ReadlineError| Failure::file(format!("cannot read a line: {error}"));
    let mut editor = Editor::<Guide, MemHistory>::with_history(config, MemHistory::new());
    let editor = editor
        .as_mut()
        .map_err(|error| Failure::file(format!("cannot use the terminal: {error}")))?;
    console.answer(GREETING)?;
    let mut session = Session::new(Writer::default());
    let mut is_warned = false;
    loop {
        editor.set_helper(Some(Guide(session.workspace.listing())));
        let line = match editor.readline("mech> ") {
            Ok(line) => line,
            // The line is dropped.
            Err(ReadlineError::Interrupted) => continue,
            Err(ReadlineError::Eof) => "quit".to_owned(),
            Err(error) => return Err(unread(error)),
        };
        match session.obey(&line, console) {
            Ok(Turn::GoOn) => is_warned = false,
            Ok(Turn::End) if session.workspace.has_work() && !is_warned => {
                is_warned = true;
                console.complain("the text is not saved: `save FILE` first, or `quit` once more\n");
            }
            Ok(Turn::End) => return Ok(()),
            Err(failure) => complain(&failure, console)?,
        }
    }
}

/// Tells why a line is refused, and goes on, unless nobody reads or this program is broken.
fn complain(failure: &Failure, console: &mut Console) -> Result<(), Failure> {
    if matches!(failure.kind(), FailureKind::Unread | FailureKind::Internal) {
        return Err(failure.clone());
    }
    if !failure.is_reported() {
        console.complain(&format!("error: {failure}\n"));
    }
    Ok(())
}

/// Completes words by the table and by the names of the mechanism.
struct Guide(Listing);

impl Completer for Guide {
    type Candidate = String;

    fn complete(
        &self,
        line: &str,
        at: usize,
        _: &Context<'_>,
    ) -> rustyline::Result<(usize, Vec<String>)> {
        Ok(complete(&line[..at], &self.0))
    }
}

impl Hinter for Guide {
    type Hint = String;
}

impl Highlighter for Guide {}
impl Validator for Guide {}
impl Helper for Guide {}
