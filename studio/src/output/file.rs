//! A file that is to be written.

use super::kind::OutputKind;
use std::path::{Path, PathBuf};

#[derive(Clone, Debug)]
pub(crate) struct Output {
    pub(crate) path: PathBuf,
    pub(super) kind: OutputKind,
    pub(super) bytes: Vec<u8>,
    pub(super) over: Over,
    /// The files from which it was made: it never takes the place of one of them.
    pub(super) inputs: Vec<PathBuf>,
}

/// What a file may take the place of.
#[derive(Clone, Debug)]
pub(crate) enum Over {
    /// A file of its kind, or an empty one. What the user can do if it is another.
    OfKind(&'static str),
    /// Any file: the user has said so.
    Any,
    /// None. What the user can do instead, if anything.
    Nothing(&'static str),
    /// The file from which this text was read.
    Text(String),
}

impl Output {
    /// A file of this kind, which takes the place of one of its kind only.
    pub(crate) fn new(
        path: impl Into<PathBuf>,
        kind: OutputKind,
        bytes: impl Into<Vec<u8>>,
    ) -> Self {
        Self {
            path: path.into(),
            kind,
            bytes: bytes.into(),
            over: Over::OfKind("choose another name"),
            inputs: Vec::new(),
        }
    }

    /// The same, which may take the place of other files.
    pub(crate) fn over(self, over: Over) -> Self {
        Self { over, ..self }
    }

    /// The same, made from these files.
    pub(crate) fn from<P: AsRef<Path>>(self, inputs: impl IntoIterator<Item = P>) -> Self {
        let inputs = inputs.into_iter();
        let inputs = inputs.map(|path| path.as_ref().to_owned()).collect();
        Self { inputs, ..self }
    }
}
