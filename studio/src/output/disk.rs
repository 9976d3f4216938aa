//! Files on a disk.

use crate::failure::Failure;
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Writes a file. One that is there already is replaced when everything is written, so that an error leaves it as it was.
///
/// # Errors
/// If the file cannot be written.
pub(crate) fn replace(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    write(path, bytes).map_err(|error| {
        let (path, why) = (path.display(), words(&error));
        Failure::file(format!("cannot write `{path}`: {why}"))
    })
}

/// Removes a file, if it is there.
///
/// # Errors
/// If it cannot be removed.
#[cfg(feature = "editor")]
pub(crate) fn remove(path: &Path) -> Result<(), Failure> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => {
            let path = path.display();
            Err(Failure::file(format!("cannot remove `{path}`: {error}")))
        }
        _ => Ok(()),
    }
}

/// The hidden file beside another: `.NAME` with an ending.
#[cfg(feature = "editor")]
pub(crate) fn hidden_beside(path: &Path, ending: &str) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(ending);
    path.with_file_name(name)
}

/// Why something cannot be written, as far as there are plain words for it.
pub(crate) fn words(error: &io::Error) -> String {
    let words = match error.kind() {
        ErrorKind::StorageFull => "the disk is full",
        ErrorKind::QuotaExceeded => "your share of the disk is full",
        ErrorKind::PermissionDenied => "you have no permission to write there",
        ErrorKind::ReadOnlyFilesystem => "the disk can only be read",
        ErrorKind::NotFound => "there is no such folder",
        ErrorKind::NotADirectory => "a part of the path is a file, not a folder",
        ErrorKind::IsADirectory => "it is a folder",
        _ => return error.to_string(),
    };
    words.to_owned()
}

fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    // The target of a symbolic link is replaced, not the link.
    let path = &fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let known = fs::metadata(path).ok();
    // A device or a pipe cannot be replaced.
    if known.as_ref().is_some_and(|known| !known.is_file()) {
        let mut file = OpenOptions::new().write(true).open(path)?;
        return file.write_all(bytes).and_then(|()| file.flush());
    }
    // A file that may not be written is not replaced either.
    if known.is_some() {
        OpenOptions::new().write(true).open(path)?;
    }
    let draft = Draft::beside(path)?;
    let mut file = File::create_new(&draft.0)?;
    file.write_all(bytes)?;
    file.sync_all()?;
    if let Some(known) = known {
        fs::set_permissions(&draft.0, known.permissions())?;
    }
    fs::rename(&draft.0, path)
}

/// A file that is not yet whole. It is removed if it stays so.
struct Draft(PathBuf);

impl Draft {
    fn beside(path: &Path) -> io::Result<Self> {
        let name = path.file_name();
        let name = name.ok_or_else(|| io::Error::other("it has no name of a file"))?;
        let mut draft = OsString::from(".");
        draft.push(name);
        draft.push(format!(".{}.draft", std::process::id()));
        Ok(Self(path.with_file_name(draft)))
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        // After it was renamed there is nothing to remove.
        let _ = fs::remove_file(&self.0);
    }
}
