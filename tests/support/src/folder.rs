//! Texts that stand in folders of `tests/cases`, with what is known of them in their comments.

use std::fs;
use std::path::{Path, PathBuf};

/// A file of a folder.
pub struct Case {
    /// Its name without its ending.
    pub name: String,
    /// All of it.
    pub text: String,
}

impl Case {
    /// What follows this word in comments that begin with it.
    pub fn marks<'c>(&'c self, word: &'c str) -> impl Iterator<Item = &'c str> {
        let comments = self.text.lines().filter_map(|line| line.strip_prefix("// "));
        comments.filter_map(move |comment| comment.strip_prefix(word)).map(str::trim)
    }

    /// The statements, where each has lines of its own.
    pub fn statements(&self) -> impl Iterator<Item = &str> {
        self.text.lines().filter(|line| !line.starts_with("//"))
    }
}

/// The folder of the whole repository.
#[must_use]
pub fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// All files of a folder, in the order of their names.
///
/// # Panics
/// If it has none, or one that cannot be read.
#[must_use]
pub fn folder(name: &str) -> Vec<Case> {
    let folder = repository().join("tests/cases").join(name);
    let files = fs::read_dir(&folder).unwrap_or_else(|wrong| panic!("{name}: {wrong}"));
    let mut files: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    assert!(!files.is_empty(), "{name} is empty");
    files.sort();
    let case = |path: PathBuf| Case {
        name: path.file_stem().expect("a name").to_string_lossy().into_owned(),
        text: fs::read_to_string(&path).expect("a text"),
    };
    files.into_iter().map(case).collect()
}
