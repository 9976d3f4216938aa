//! Texts that were kept beside a file and never saved, as after a crash.

use crate::document::Source;
use crate::edit::Workspace;
use crate::failure::Failure;
use crate::output::{create_like, hidden_beside, remove, words};
use std::fs::{File, TryLockError};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// A text that was kept and never saved.
pub(super) struct Left {
    pub(super) path: PathBuf,
    pub(super) text: String,
    /// The file, which no other window takes as long as it is locked here. A crash unlocks it.
    lock: Option<File>,
}

impl Left {
    /// A text that is kept here from now on.
    pub(super) fn at(path: PathBuf, text: String) -> Self {
        let lock = lock(&path);
        Self { path, text, lock }
    }

    /// Unlocks its file, so that another can take its place.
    pub(super) fn unlock(&mut self) {
        self.lock = None;
    }

    /// Locks its file again, if no other has taken its place.
    pub(super) fn lock_again(&mut self) {
        self.lock = lock(&self.path);
    }
}

/// Locks a file against other windows; none if it cannot be, as on some disks.
fn lock(path: &Path) -> Option<File> {
    let file = File::open(path).ok()?;
    file.try_lock().ok()?;
    Some(file)
}

/// Whether another window keeps its text in this file.
fn is_of_other_window(path: &Path) -> bool {
    let file = File::open(path);
    file.is_ok_and(|file| matches!(file.try_lock(), Err(TryLockError::WouldBlock)))
}

/// The largest number of texts that are kept beside a file: one for each window in which it is edited.
const MOST: usize = 9;

/// The file beside which a text is kept. One without a name is kept in this folder.
pub(super) fn place_of(workspace: &Workspace, unnamed: &Path) -> PathBuf {
    if workspace.is_named() {
        workspace.path().to_owned()
    } else {
        unnamed.join(workspace.path().file_name().unwrap_or_default())
    }
}

/// The names under which texts are kept beside a file.
fn slots(place: &Path) -> impl Iterator<Item = PathBuf> {
    (1..=MOST).map(move |number| match number {
        1 => hidden_beside(place, ".autosave"),
        number => hidden_beside(place, &format!(".{number}.autosave")),
    })
}

/// The texts that were left beside a file, other than this one, and why one cannot be read. Those that tell nothing are removed; those of
/// other windows stay theirs.
pub(super) fn left_at(place: &Path, text: &str) -> (Vec<Left>, Result<(), Failure>) {
    let (mut found, mut done) = (Vec::new(), Ok(()));
    // A link or a pipe is none of ours.
    let is_ours = |path: &PathBuf| path.symlink_metadata().is_ok_and(|known| known.is_file());
    let slots = slots(place).filter(is_ours);
    for path in slots.filter(|path| !is_of_other_window(path)) {
        match Source::read_plain(&path) {
            Ok(source) if source.text().is_empty() || source.text() == text => {
                done = done.and(remove(&path));
            }
            Ok(source) => found.push(Left::at(path, source.text().to_owned())),
            Err(failure) => done = done.and(Err(failure)),
        }
    }
    (found, done)
}

/// Takes the first name beside a file that no other window has, and that no text was left under.
pub(super) fn claim(place: &Path) -> Result<PathBuf, Failure> {
    let failed = |path: &Path, error: &dyn std::fmt::Display| {
        Failure::file(format!("cannot write `{}`: {error}", path.display()))
    };
    for path in slots(place) {
        match create_like(&path, place) {
            Ok(_) => return Ok(path),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(failed(&path, &words(&error))),
        }
    }
    Err(failed(place, &"too many texts are kept beside it"))
}
