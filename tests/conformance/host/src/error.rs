//! What can go wrong.

use std::fmt;
use std::io;
use std::path::PathBuf;

/// What can go wrong.
#[derive(Debug)]
pub enum Error {
    /// Called with other arguments than it should be.
    Usage,
    /// A file that cannot be read or written.
    File {
        /// Where it is.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A line of a file that is not what it should be.
    Line {
        /// The line.
        text: String,
    },
    /// An image that cannot be read.
    Image {
        /// Where it is.
        path: PathBuf,
        /// Why.
        source: object::read::Error,
    },
    /// The firmware says something else than this machine.
    Differs(String),
    /// What it costs is not what it is said to.
    Figures(Vec<String>),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Usage => write!(f, "usage: mech-conformance FOLDER [--all | --update]"),
            Self::File { path, source } => write!(f, "{}: {source}", path.display()),
            Self::Line { text } => write!(f, "not a line of the firmware's: `{text}`"),
            Self::Image { path, source } => write!(f, "{}: {source}", path.display()),
            Self::Differs(what) => write!(f, "{what}"),
            Self::Figures(lines) => {
                write!(f, "figures differ from docs/embedded.csv:")?;
                for line in lines {
                    write!(f, "\n  {line}")?;
                }
                write!(f, "\nif that is what you want: tests/conformance/run --update")
            }
        }
    }
}
