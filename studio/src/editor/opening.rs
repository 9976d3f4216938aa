//! Files that are opened: texts with mechanisms, and what other programs wrote.

use super::Editor;
use crate::document::Source;
use crate::edit::Workspace;
use crate::failure::Failure;
use crate::import::{self, FileKind};
use std::ffi::OsStr;
use std::path::Path;

impl Editor {
    /// Edits a file, unless changes would be lost. Of what another program wrote, it edits a text that is not saved yet.
    pub(super) fn open_file(&mut self, path: &Path) {
        if !self.may_leave() {
            return;
        }
        if path.extension() != Some(OsStr::new("linkage2")) {
            match Workspace::open(path, None) {
                Ok(workspace) => self.open(workspace),
                Err(failure) => self.refuse(failure),
            }
            return;
        }
        match imported(path) {
            Ok((workspace, omissions)) => {
                self.open(workspace);
                self.tell(match omissions {
                    0 => "imported".to_owned(),
                    _ => format!("imported; {omissions} things could not be carried over"),
                });
            }
            Err(failure) => self.refuse(failure),
        }
    }
}

/// A document of Linkage as a text, and how much of it could not be carried over.
fn imported(path: &Path) -> Result<(Workspace, usize), Failure> {
    let source = Source::read(path)?;
    let read = import::read(&source);
    let imported = read.map_err(|message| {
        let (path, why) = (path.display(), message.text);
        Failure::file(format!("cannot read `{path}`: {why}"))
    })?;
    let part = |part: Option<&OsStr>| {
        let part = part.unwrap_or_default();
        part.to_string_lossy().into_owned()
    };
    let name = import::type_name(&part(path.file_stem()))?;
    let text = imported.text(&part(path.file_name()), &name, FileKind::Mechanism)?;
    let workspace = Workspace::unsaved(path.with_extension("mech"), text);
    Ok((workspace, imported.omissions.len()))
}
