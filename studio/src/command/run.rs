//! `mech run`.

use super::CODES;
use crate::console::Console;
use crate::dialogue::{Session, Turn};
use crate::document::Source;
use crate::failure::{Failure, FailureKind};
use crate::output::{Fence, Writer};
use clap::Args;
use std::path::PathBuf;

/// Does what a script says, line by line, in the words of the dialogue.
///
/// The first line that is refused ends it. Nothing is written then: files are written when all lines are done, all or none. A script writes in
/// its own folder and below. It replaces nothing but FILE, and what it has opened or made itself. It writes nothing hidden.
/// `--allow-write PATH` lets it write more.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Run {
    /// The script: a text with one command a line; `#` begins a comment.
    script: PathBuf,
    /// A file that is opened first.
    file: Option<PathBuf>,
    /// The mechanism, where the file has several: the name of its type.
    #[arg(short, long, value_name = "NAME", requires = "file")]
    mechanism: Option<String>,
    /// Lets the script write here, too, and replace what is there: a file, or a folder and what is below it.
    #[arg(long, value_name = "PATH")]
    allow_write: Vec<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  mech run four_bar.txt
  mech run longer_crank.txt four_bar.mech
  mech run scripts/pictures.txt --allow-write pictures

A script:
  mechanism FourBar
  link crank
  join a = revolute ground crank at (0, 0)
  motor a
  save four_bar.mech";

impl Run {
    pub(super) fn run(&self, console: &mut Console) -> Result<(), Failure> {
        let script = Source::read(&self.script)?;
        let mut fence = Fence::around(Some(&self.script), &self.allow_write)?;
        if let Some(file) = &self.file {
            fence = fence.with_named(file);
        }
        let mut session = Session::new(Writer::of_script(fence));
        if let Some(file) = &self.file {
            session.open(file, self.mechanism.as_deref())?;
        }
        for (number, line) in (1..).zip(script.text().lines()) {
            match session.obey(line, console) {
                Ok(Turn::GoOn) => {}
                Ok(Turn::End) => break,
                Err(failure) => return Err(refused(number, line, &failure)),
            }
        }
        session.finish(console)
    }
}

fn refused(number: usize, line: &str, failure: &Failure) -> Failure {
    let text = if failure.is_reported() {
        format!("line {number}: `{}` was refused", line.trim())
    } else {
        format!("line {number}: {failure}")
    };
    if failure.kind() == FailureKind::Unread {
        return Failure::unread();
    }
    Failure::new(failure.kind(), text)
}
