//! What is opened: files of the language, and what other programs wrote.

use super::Editor;
use super::example::Example;
use super::question::{Destination, Dialog, Ending};
use crate::document::Source;
use crate::edit::Workspace;
use crate::failure::Failure;
use crate::import::{self, FileKind, Written};
use std::path::{Path, PathBuf};

/// A text to be edited, and what was lost when it was imported, if it was.
type Opened = (Workspace, Option<Vec<String>>);

impl Editor {
    /// Edits another text. If the present one has changes, the user is asked first.
    pub(super) fn leave_for(&mut self, to: Destination) {
        if self.has_work() {
            self.dialog = Some(Dialog::Leave(to));
        } else {
            self.arrive(to);
        }
    }

    /// Edits another text, whatever becomes of the present one.
    pub(super) fn arrive(&mut self, to: Destination) {
        let opened = match to {
            Destination::Empty => Ok((Workspace::default(), None)),
            Destination::File(name) => opened(name.trim()),
            #[cfg(target_arch = "wasm32")]
            Destination::Text(path, text) => taken(Source::new(path, text)),
            Destination::Example(example) => {
                self.open_example(example);
                return;
            }
            Destination::Away => {
                self.ending = Ending::Granted;
                return;
            }
        };
        match opened {
            Ok((workspace, losses)) => {
                let file = workspace.path().display().to_string();
                self.open(workspace);
                if let Some(losses) = losses {
                    self.tell_losses(&file, &losses);
                }
            }
            Err(failure) => self.refuse(failure),
        }
    }

    /// Edits another text, if one is wanted and the present one was saved.
    pub(super) fn arrive_if_done(&mut self, saved: Result<(), Failure>, to: Option<Destination>) {
        match saved {
            Ok(()) => to.into_iter().for_each(|to| self.arrive(to)),
            Err(failure) => self.refuse(failure),
        }
    }

    /// Opens an example.
    fn open_example(&mut self, example: &Example) {
        match example.text() {
            Ok(text) => {
                self.open(Workspace::proposed(example.file, text));
                self.tell(format!("{}: {}", example.name, example.help));
            }
            Err(failure) => self.refuse(failure),
        }
    }

    /// Tells what could not be carried over: how much of it, and all of it in the journal.
    fn tell_losses(&mut self, file: &str, losses: &[String]) {
        for loss in losses {
            self.journal.text += &format!("not carried over: {loss}\n");
        }
        let told = match losses {
            [] => "everything was carried over".to_owned(),
            [only] => format!("not carried over: {only}"),
            [first, others @ ..] => {
                format!(
                    "not carried over: {first}; and {} more, see Journal",
                    others.len()
                )
            }
        };
        self.tell(format!("imported as `{file}`; {told}"));
    }
}

/// A file, or what a link of PMKS+ holds.
fn opened(name: &str) -> Result<Opened, Failure> {
    let path = Path::new(name);
    if import::is_link(name) {
        let source = Source::new("link", name);
        imported(
            &source,
            "a link of PMKS+",
            "Imported",
            "imported.mech".into(),
        )
    } else if is_of_linkage(path) {
        taken(Source::read_foreign(path)?)
    } else {
        Ok((Workspace::of(Source::read(path)?), None))
    }
}

/// A text with the name of its file. What another program wrote is imported, and stays beside it.
fn taken(source: Source) -> Result<Opened, Failure> {
    let path = source.path();
    if !is_of_linkage(path) {
        return Ok((Workspace::of(source), None));
    }
    let part = |part: Option<&std::ffi::OsStr>| {
        let part = part.map(|part| part.to_string_lossy().into_owned());
        part.unwrap_or_default()
    };
    let (title, wish) = (part(path.file_name()), part(path.file_stem()));
    imported(&source, &title, &wish, path.with_extension("mech"))
}

fn is_of_linkage(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending == "linkage2")
}

/// The text of what another program wrote, in no file yet, and what is lost.
fn imported(source: &Source, title: &str, wish: &str, file: PathBuf) -> Result<Opened, Failure> {
    let found = import::read(source).map_err(|message| Failure::file(message.text))?;
    let name = import::type_name(wish)?;
    let Written { text, omissions } = found.written(title, &name, FileKind::Mechanism)?;
    let losses = omissions.iter().map(ToString::to_string).collect();
    Ok((Workspace::proposed(file, text), Some(losses)))
}
