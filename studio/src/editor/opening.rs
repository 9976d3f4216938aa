//! The opening of files of the language, and of files of other programs.

use super::desk::{LONGEST_FILE, is_picture};
use super::question::Destination;
use crate::document::{LONGEST, Source};
use crate::edit::Workspace;
use crate::failure::Failure;
use crate::import::{self, FileKind, Written};
use std::path::{Path, PathBuf};

#[derive(Default)]
pub(super) struct Opened {
    pub(super) workspace: Workspace,
    /// The omissions of the import, for the journal.
    pub(super) losses: String,
    pub(super) told: Option<String>,
}

/// Opens the text that the user wants to go on with.
pub(super) fn opened(to: Destination) -> Result<Opened, Failure> {
    match to {
        Destination::Empty | Destination::Away => Ok(Opened::default()),
        Destination::File(name) => read(name.trim()),
        #[cfg(target_arch = "wasm32")]
        Destination::Text(path, text) => taken(Source::new(path, text)),
        Destination::Example(example) => Ok(Opened {
            workspace: Workspace::proposed(example.file, example.text()?),
            losses: String::new(),
            told: Some(format!("{}: {}", example.name, example.help)),
        }),
    }
}

/// A file, or what a link of PMKS+ holds.
fn read(name: &str) -> Result<Opened, Failure> {
    let path = Path::new(name);
    if import::is_link(name) {
        let source = Source::new("link", name);
        imported(&source, "a link of PMKS+", "Imported", "imported.mech".into())
    } else if is_of_linkage(path) {
        taken(Source::read_foreign_plain(path)?)
    } else {
        Ok(own(Source::read_plain(path)?))
    }
}

/// A file of the language.
fn own(source: Source) -> Opened {
    Opened { workspace: Workspace::of(source), ..Opened::default() }
}

/// A text with the name of its file. What another program wrote is imported, and stays beside it.
fn taken(source: Source) -> Result<Opened, Failure> {
    let path = source.path();
    if !is_of_linkage(path) {
        return Ok(own(source));
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
    let losses: Vec<String> = omissions.iter().map(ToString::to_string).collect();
    let told = match &losses[..] {
        [] => "everything was carried over".to_owned(),
        [only] => format!("not carried over: {only}"),
        [first, others @ ..] => {
            let count = others.len();
            format!("not carried over: {first}; and {count} more, see Journal")
        }
    };
    let lines = losses.iter();
    Ok(Opened {
        told: Some(format!("imported as `{}`; {told}", file.display())),
        losses: lines.map(|loss| format!("not carried over: {loss}\n")).collect(),
        workspace: Workspace::proposed(file, text),
    })
}

/// The length of the longest file of this name that is taken, in bytes.
pub(super) fn longest(path: &Path) -> u64 {
    if is_picture(path) { LONGEST_FILE } else { LONGEST }
}
