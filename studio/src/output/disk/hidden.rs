//! Hidden files beside others, which are ours alone.

use super::draft::{Draft, put_all};
use super::place::unwritten;
use super::rights;
use crate::failure::Failure;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// The hidden file beside another: `.NAME` with an ending.
pub(crate) fn hidden_beside(path: &Path, ending: &str) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(ending);
    path.with_file_name(name)
}

/// Writes a hidden file that belongs to another, which tells who may read it. A link that is there is replaced, not followed.
///
/// # Errors
/// If it cannot be written. What is there stays as it is.
pub(crate) fn keep(path: &Path, bytes: &[u8], like: &Path) -> Result<(), Failure> {
    let draft = Draft::of(path, bytes, rights::like(like));
    let draft = draft.map_err(|error| unwritten(path, &error))?;
    put_all(vec![draft]).map_err(|(path, error)| unwritten(&path, &error))
}

/// Makes a hidden file that belongs to another, which tells who may read it.
pub(crate) fn create_like(path: &Path, like: &Path) -> io::Result<File> {
    rights::create(path, rights::like(like).as_ref())
}

/// Removes a file, if it is there.
pub(crate) fn remove(path: &Path) -> Result<(), Failure> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => {
            let path = path.display();
            Err(Failure::file(format!("cannot remove `{path}`: {error}")))
        }
        _ => Ok(()),
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::keep;
    use std::fs;

    #[test]
    fn a_link_is_replaced_and_not_followed() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        fs::write(path("theirs"), "theirs").expect("a file");
        std::os::unix::fs::symlink("theirs", path(".a.desk")).expect("a link");
        keep(&path(".a.desk"), b"ours", &path("a")).expect("it can be written");
        assert_eq!(fs::read_to_string(path("theirs")).expect("a file"), "theirs");
        let ours = fs::symlink_metadata(path(".a.desk")).expect("it is there");
        assert!(ours.is_file());
    }
}
