//! What is opened: files of the language, and what other programs wrote.

use super::Editor;
use crate::document::Source;
use crate::edit::Workspace;
use crate::failure::Failure;
use crate::import::{self, FileKind};
use std::path::Path;

impl Editor {
    /// Opens a file, if the text may be left.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn open_file(&mut self, path: &Path) {
        self.open_named(&path.to_string_lossy());
    }

    /// Opens a file, or what a link of PMKS+ holds, if the text may be left.
    pub(super) fn open_named(&mut self, name: &str) {
        if !self.may_leave() {
            return;
        }
        let name = name.trim();
        if !is_foreign(name) {
            match Workspace::open(Path::new(name), None) {
                Ok(workspace) => self.open(workspace),
                Err(failure) => self.refuse(failure),
            }
            return;
        }
        match imported(name) {
            Ok((workspace, losses)) => {
                let file = workspace.path().display().to_string();
                self.open(workspace);
                self.tell_losses(&file, &losses);
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

/// Whether something is of another program: a link, or a file of Linkage.
fn is_foreign(name: &str) -> bool {
    let ending = Path::new(name).extension();
    import::is_link(name) || ending.is_some_and(|ending| ending == "linkage2")
}

/// The text of what another program wrote, in no file yet, and what is lost.
fn imported(name: &str) -> Result<(Workspace, Vec<String>), Failure> {
    let path = Path::new(name);
    let (source, title, wish) = if import::is_link(name) {
        (
            Source::new("link", name),
            "a link of PMKS+".to_owned(),
            "Imported".to_owned(),
        )
    } else {
        let part = |part: Option<&std::ffi::OsStr>| {
            part.map(|part| part.to_string_lossy().into_owned())
                .unwrap_or_default()
        };
        (
            Source::read(path)?,
            part(path.file_name()),
            part(path.file_stem()),
        )
    };
    let found = import::read(&source).map_err(|message| Failure::file(message.text))?;
    let text = found.text(&title, &import::type_name(&wish)?, FileKind::Mechanism)?;
    let losses = found.omissions.iter().map(ToString::to_string).collect();
    // A file stays beside that of the other program.
    let file = if import::is_link(name) {
        "imported.mech".into()
    } else {
        path.with_extension("mech")
    };
    Ok((Workspace::unsaved(file, text), losses))
}
