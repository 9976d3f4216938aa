//! Where files are, and why they cannot be written there.

use crate::failure::Failure;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// The file that a path leads to, through all links, whether it is there or not. Its folder has to be there.
pub(super) fn target(path: &Path) -> io::Result<PathBuf> {
    if let Ok(found) = fs::canonicalize(path) {
        return Ok(found);
    }
    let name = path.file_name();
    let name = name.ok_or_else(|| io::Error::other("it has no name of a file"))?;
    Ok(folder_of(path)?.join(name))
}

/// The folder of a file, through all links.
pub(super) fn folder_of(path: &Path) -> io::Result<PathBuf> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => fs::canonicalize(folder)?,
        _ => fs::canonicalize(".")?,
    };
    if folder.is_dir() { Ok(folder) } else { Err(ErrorKind::NotADirectory.into()) }
}

/// Whether two paths lead to the same file, by links of any kind. Devices and pipes are no files.
pub(super) fn is_same(one: &Path, other: &Path) -> bool {
    let (Ok(a), Ok(b)) = (fs::metadata(one), fs::metadata(other)) else {
        return false;
    };
    a.is_file() && b.is_file() && is_one(one, &a, other, &b)
}

#[cfg(unix)]
fn is_one(_: &Path, a: &fs::Metadata, _: &Path, b: &fs::Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (a.dev(), a.ino()) == (b.dev(), b.ino())
}

/// Without numbers of files, hard links are not found.
#[cfg(not(unix))]
fn is_one(one: &Path, _: &fs::Metadata, other: &Path, _: &fs::Metadata) -> bool {
    let found = fs::canonicalize(one).ok();
    found.is_some() && found == fs::canonicalize(other).ok()
}

/// Whether what is written to a path goes on from what is there: a device, a pipe, or a file that `/dev/stdout` leads to.
pub(super) fn is_stream(path: &Path, target: &Path) -> bool {
    let is_led = path.starts_with("/dev") && !target.starts_with("/dev");
    is_led || fs::metadata(target).is_ok_and(|known| !known.is_file())
}

/// A file that cannot be written.
pub(super) fn unwritten(path: &Path, error: &io::Error) -> Failure {
    let (path, why) = (path.display(), words(error));
    Failure::file(format!("cannot write `{path}`: {why}"))
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
        ErrorKind::AlreadyExists => "another program has just made it",
        _ => return error.to_string(),
    };
    words.to_owned()
}
