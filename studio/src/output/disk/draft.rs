//! Drafts: files beside others, whose places they take when all is written.

use super::rights;
use std::ffi::{OsStr, OsString};
use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};

const ENDING: &str = ".draft";

/// A file that is written whole, and does not stand in its place yet. It is removed if it never does.
pub(super) struct Draft {
    file: NamedTempFile,
    target: PathBuf,
    /// Whether a file is there that it takes the place of.
    is_over: bool,
}

impl Draft {
    /// Writes a draft of a file. It has the rights of the file whose place it takes, or these, from its first byte.
    pub(super) fn of(target: &Path, bytes: &[u8], rights: Option<Permissions>) -> io::Result<Self> {
        let known = fs::symlink_metadata(target).ok();
        let is_over = known.is_some();
        let known = known.filter(fs::Metadata::is_file);
        // A file that may not be written is not replaced either.
        if known.is_some() {
            OpenOptions::new().write(true).open(target)?;
        }
        remove_stale(target);
        let rights = rights.or_else(|| known.map(|known| known.permissions()));
        let (prefix, folder) = beside(target)?;
        let mut builder = Builder::new();
        builder.prefix(&prefix).suffix(ENDING);
        rights::give(rights.as_ref(), &mut builder);
        let mut file = builder.tempfile_in(folder)?;
        // Nobody takes it for one that was left. Some disks have no locks.
        let _ = file.as_file().try_lock();
        file.write_all(bytes)?;
        // What the user's mask took away comes back.
        if let Some(rights) = rights {
            file.as_file().set_permissions(rights)?;
        }
        file.as_file().sync_all()?;
        Ok(Self { file, target: target.to_owned(), is_over })
    }

    /// Puts it in its place.
    fn put(self) -> io::Result<()> {
        let Self { file, target, is_over } = self;
        if is_over {
            return file.persist(&target).map(drop).map_err(Into::into);
        }
        match file.persist_noclobber(&target) {
            Ok(_) => Ok(()),
            Err(error) if error.error.kind() == ErrorKind::AlreadyExists => Err(error.into()),
            // Some disks cannot tell.
            Err(error) => error.file.persist(&target).map(drop).map_err(Into::into),
        }
    }
}

/// Puts drafts in their places: all, or none. An error says which could not be put there.
pub(super) fn put_all(drafts: Vec<Draft>) -> Result<(), (PathBuf, io::Error)> {
    let mut done: Vec<(PathBuf, Option<NamedTempFile<()>>)> = Vec::new();
    let last = drafts.len().saturating_sub(1);
    for (number, draft) in drafts.into_iter().enumerate() {
        let target = draft.target.clone();
        // After the last one nothing can fail.
        let before =
            if draft.is_over && number < last { second_name(&target).map(Some) } else { Ok(None) };
        let put = before.and_then(|before| draft.put().map(|()| before));
        match put {
            Ok(before) => done.push((target, before)),
            Err(error) => {
                for (target, before) in done.into_iter().rev() {
                    put_back(&target, before)?;
                }
                return Err((target, error));
            }
        }
    }
    Ok(())
}

/// A second name for a file, under which it stays when another takes its place. A disk without such names has a copy.
fn second_name(target: &Path) -> io::Result<NamedTempFile<()>> {
    let (prefix, folder) = beside(target)?;
    let mut builder = Builder::new();
    builder.prefix(&prefix).suffix(ENDING);
    builder.make_in(folder, |name| match fs::hard_link(target, name) {
        Err(error) if error.kind() != ErrorKind::AlreadyExists => {
            let known = fs::metadata(target)?.permissions();
            drop(rights::create(name, Some(&known))?);
            fs::copy(target, name).map(drop)
        }
        done => done,
    })
}

fn put_back(target: &Path, before: Option<NamedTempFile<()>>) -> Result<(), (PathBuf, io::Error)> {
    let done = match before {
        Some(before) => before.persist(target).map(drop).map_err(io::Error::from),
        None => fs::remove_file(target),
    };
    done.map_err(|error| (target.to_owned(), error))
}

/// What the names of a file's drafts begin with, and the folder in which they are.
fn beside(target: &Path) -> io::Result<(OsString, &Path)> {
    let name = target.file_name();
    let name = name.ok_or_else(|| io::Error::other("it has no name of a file"))?;
    let mut prefix = OsString::from(".");
    prefix.push(name);
    prefix.push(".");
    let folder = target.parent().filter(|folder| *folder != Path::new(""));
    Ok((prefix, folder.unwrap_or(Path::new("."))))
}

/// Removes the drafts of a file that were left when a program was killed. Those that are being written are locked.
fn remove_stale(target: &Path) {
    let Ok((prefix, folder)) = beside(target) else {
        return;
    };
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let drafts = entries.filter(|entry| is_draft(&entry.file_name(), &prefix));
    // A link or a pipe is none of ours.
    for draft in drafts.filter(|entry| entry.file_type().is_ok_and(|kind| kind.is_file())) {
        let path = draft.path();
        if File::open(&path).is_ok_and(|file| file.try_lock().is_ok()) {
            // What cannot be removed stays; the file is written all the same.
            let _ = fs::remove_file(path);
        }
    }
}

/// Whether a name is that of a draft: `.NAME.`, a few letters or digits, and the ending.
fn is_draft(name: &OsStr, prefix: &OsStr) -> bool {
    let name = name.as_encoded_bytes();
    let middle = name
        .strip_prefix(prefix.as_encoded_bytes())
        .and_then(|rest| rest.strip_suffix(ENDING.as_bytes()));
    middle.is_some_and(|middle| {
        (1..=10).contains(&middle.len()) && middle.iter().all(u8::is_ascii_alphanumeric)
    })
}

#[cfg(test)]
mod tests {
    use super::{Draft, put_all};
    use std::fs;

    #[test]
    fn where_one_cannot_be_put_all_are_as_before() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        fs::write(path("a"), "before").expect("a file");
        let draft = |name: &str| Draft::of(&path(name), b"after", None).expect("a draft");
        let drafts = vec![draft("a"), draft("b"), draft("c"), draft("d")];
        // Meanwhile something comes into the way of the third.
        fs::create_dir(path("c")).expect("a folder");
        let (which, _) = put_all(drafts).expect_err("a folder is there");
        assert_eq!(which, path("c"));
        assert_eq!(fs::read_to_string(path("a")).expect("a file"), "before");
        let names = fs::read_dir(folder.path()).expect("a folder");
        let names = names.map(|entry| entry.expect("an entry").file_name());
        let mut names: Vec<_> = names.collect();
        names.sort();
        assert_eq!(names, ["a", "c"]);
        let drafts = vec![draft("a"), draft("b")];
        put_all(drafts).expect("nothing is in the way");
        assert_eq!(fs::read_to_string(path("a")).expect("a file"), "after");
        assert_eq!(fs::read_to_string(path("b")).expect("a file"), "after");
    }
}
