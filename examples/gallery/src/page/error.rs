//! The errors of the gallery.

use crate::Stuck;
use mech_runtime::files::FileError;
use std::{fmt, io, path::PathBuf};

/// An error of the gallery.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// The command line asks for exhibits that do not exist.
    Unknown {
        /// The unknown names.
        names: Vec<String>,
        /// The names of all exhibits.
        known: Vec<&'static str>,
    },
    /// A mechanism cannot make its motion.
    Stuck(Stuck),
    /// A mechanism is never visible.
    Invisible,
    /// A picture could not be made into a file.
    Picture(FileError),
    /// A file could not be written.
    File {
        /// The path.
        path: PathBuf,
        /// The cause.
        source: io::Error,
    },
    /// Some exhibits failed, for reasons that were printed already.
    Missing {
        /// Their names.
        names: Vec<&'static str>,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { names, known } => {
                let (names, known) = (names.join("`, `"), known.join("`, `"));
                write!(f, "no exhibit is called `{names}`; there are `{known}`")
            }
            Self::Stuck(stuck) => stuck.fmt(f),
            Self::Invisible => f.write_str("nothing is seen of it: give it a shape"),
            Self::Picture(error) => write!(f, "cannot make the picture: {error}"),
            Self::File { path, source } => write!(f, "cannot write {}: {source}", path.display()),
            Self::Missing { names } => write!(f, "the gallery lacks `{}`", names.join("`, `")),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Stuck(error) => Some(error),
            Self::Picture(error) => Some(error),
            Self::File { source, .. } => Some(source),
            Self::Unknown { .. } | Self::Invisible | Self::Missing { .. } => None,
        }
    }
}

impl From<Stuck> for Error {
    fn from(stuck: Stuck) -> Self {
        Self::Stuck(stuck)
    }
}

impl From<FileError> for Error {
    fn from(error: FileError) -> Self {
        Self::Picture(error)
    }
}
