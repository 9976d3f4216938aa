//! A session: a file, its text as it is now, and the steps that led there.

use super::line::{help, request};
#[cfg(target_arch = "wasm32")]
use super::page::obey_within;
use super::request::Request;
use crate::check::verdict_line;
#[cfg(not(target_arch = "wasm32"))]
use crate::command::obey_within;
use crate::console::Console;
use crate::document::{Declaration, Document, Reading};
use crate::edit::{Applied, Workspace};
use crate::failure::Failure;
use crate::mend::mendings;
#[cfg(not(target_arch = "wasm32"))]
use crate::output::OutputKind;
use crate::output::Writer;
#[cfg(feature = "editor")]
use std::cell::RefCell;
#[cfg(feature = "editor")]
use std::io::{self, Write};
use std::path::Path;
#[cfg(feature = "editor")]
use std::rc::Rc;

/// Whether the dialogue goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Turn {
    GoOn,
    /// The user has ended it.
    End,
}

pub(crate) struct Session {
    pub(crate) workspace: Workspace,
    /// Writes the files, at once or at the end.
    writer: Writer,
}

impl Session {
    /// An empty text, without a file.
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) fn new(writer: Writer) -> Self {
        Self { workspace: Workspace::default(), writer }
    }

    /// A session that goes on with this text. It writes files at once.
    #[cfg(feature = "editor")]
    pub(crate) fn of(workspace: Workspace) -> Self {
        Self { workspace, writer: Writer::default() }
    }

    pub(crate) fn obey(&mut self, line: &str, console: &mut Console) -> Result<Turn, Failure> {
        let Some(request) = request(line)? else {
            return Ok(Turn::GoOn);
        };
        match request {
            Request::Edit(command) => {
                let applied = self.workspace.apply(&command)?;
                console.answer(answer(&applied) + "\n")?;
            }
            Request::Ask(words) => self.ask(&words, console)?,
            Request::Repairs => self.repairs(console)?,
            Request::Undo => {
                let title = self.workspace.undo();
                let title = title.ok_or_else(|| Failure::usage("there is nothing to undo"))?;
                console.answer(format!("undone: {title}\n"))?;
            }
            Request::Redo => {
                let title = self.workspace.redo();
                let title = title.ok_or_else(|| Failure::usage("there is nothing to redo"))?;
                console.answer(format!("done again: {title}\n"))?;
            }
            Request::Steps => {
                let steps = self.workspace.history().made().iter();
                console
                    .answer(steps.map(|step| format!("{}\n", step.title)).collect::<String>())?;
            }
            Request::Text => console.deliver(self.workspace.text())?,
            Request::Numbers(owner) => console.answer(self.numbers(owner.as_deref())?)?,
            Request::Open { file, mechanism } => {
                self.open(Path::new(file.trim_matches('"')), mechanism.as_deref())?;
            }
            Request::Save(file) => self.save(file.as_deref(), console)?,
            Request::Help(topic) => console.answer(help(topic.as_deref())?)?,
            Request::Quit => return Ok(Turn::End),
        }
        Ok(Turn::GoOn)
    }

    fn declaration<'d>(&self, document: &'d Document) -> Result<&'d Declaration, Failure> {
        let declaration = document.declarations().get(self.workspace.index());
        declaration.ok_or_else(|| {
            Failure::usage("there is no mechanism yet; begin with `mechanism NAME`, or `open FILE`")
        })
    }

    pub(crate) fn open(&mut self, path: &Path, mechanism: Option<&str>) -> Result<(), Failure> {
        if self.workspace.has_work() {
            return Err(Failure::usage("the text has changes; `save` or `undo` them first"));
        }
        self.workspace = Workspace::open(path, mechanism)?;
        Ok(())
    }

    /// Writes the text: over the file from which it was read, or to one that is not there yet.
    fn save(&mut self, file: Option<&str>, console: &mut Console) -> Result<(), Failure> {
        let path = file.map(|file| Path::new(file.trim_matches('"')));
        // A text that could not be written does not count as written.
        let before = self.workspace.clone();
        let output = self.workspace.save_to(path)?;
        if let Err(failure) = self.writer.write(output) {
            self.workspace = before;
            return Err(failure);
        }
        if self.writer.is_deferred() {
            return Ok(());
        }
        let path = self.workspace.path().display();
        console.answer(format!("saved `{path}`\n"))
    }

    /// Writes what was deferred, and tells so.
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) fn finish(self, console: &mut Console) -> Result<(), Failure> {
        for (kind, path) in self.writer.finish()? {
            let done = match kind {
                OutputKind::Mechanism => "saved",
                _ => "wrote",
            };
            console.answer(format!("{done} `{}`\n", path.display()))?;
        }
        Ok(())
    }

    fn ask(&mut self, words: &[String], console: &mut Console) -> Result<(), Failure> {
        let document = self.workspace.document();
        self.declaration(&document)?;
        let index = self.workspace.index();
        obey_within(words, document, index, &mut self.writer, console)
    }

    fn repairs(&self, console: &mut Console) -> Result<(), Failure> {
        let document = self.workspace.document();
        let declaration = self.declaration(&document)?;
        let reading = document.prove(declaration)?;
        let found = mendings(&document, declaration, &reading)?;
        if found.is_empty() {
            return console.answer(match reading.result {
                Ok(_) => "nothing is wrong\n",
                Err(_) => "no repair is known\n",
            });
        }
        let lines = (1..).zip(&found).map(|(number, mending)| {
            let words = &mending.words;
            format!("{number}: {words}\n")
        });
        console.answer(lines.collect::<String>())
    }

    /// The numbers of something: `crank.pin x = THROW`.
    fn numbers(&self, owner: Option<&str>) -> Result<String, Failure> {
        let listing = self.workspace.listing();
        let is_asked = |found: &str| {
            owner.is_none_or(|owner| {
                let inner = found.strip_prefix(owner);
                inner.is_some_and(|inner| inner.is_empty() || inner.starts_with('.'))
            })
        };
        let numbers = listing.numbers.iter().filter(|one| !one.is_pair);
        let lines = numbers.map(|one| {
            let value = &self.workspace.text()[one.place.clone()];
            let path = one.path();
            (is_asked(&path), format!("{path} {} = {value}\n", one.role))
        });
        let asked = lines.filter(|(is_asked, _)| *is_asked);
        let lines: String = asked.map(|(_, line)| line).collect();
        match owner {
            Some(owner) if lines.is_empty() => {
                Err(Failure::usage(format!("`{owner}` has no numbers here")))
            }
            _ => Ok(lines),
        }
    }
}

/// What is said to a line that has changed the mechanism.
pub(crate) fn answer(applied: &Applied) -> String {
    format!("{}\n  {}", applied.summary(), state(&applied.reading))
}

/// Says in a line whether a mechanism moves.
pub(crate) fn state(reading: &Reading) -> String {
    match &reading.result {
        Ok(compiled) => verdict_line(&reading.model, compiled),
        Err(faults) => {
            let first = faults.messages.first();
            let line = first.and_then(|message| message.text.lines().next());
            format!("not yet: {}", line.unwrap_or_default())
        }
    }
}

/// Does what a line says: what is said to it, and how it ended.
#[cfg(feature = "editor")]
pub(crate) fn hear(line: &str, session: &mut Session) -> (String, Result<Turn, Failure>) {
    let heard = Heard::default();
    let done = session.obey(line, &mut Console::to(heard.clone(), heard.clone()));
    let said = String::from_utf8_lossy(&heard.0.borrow()).trim_end().to_owned();
    (said, done)
}

/// The text that a console has received.
#[cfg(feature = "editor")]
#[derive(Clone, Default)]
struct Heard(Rc<RefCell<Vec<u8>>>);

#[cfg(feature = "editor")]
impl Write for Heard {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
