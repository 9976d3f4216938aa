//! Why a command could not do what it was told.

use mech_runtime::files::FileError;
use mech_runtime::raster::TooLarge;
use std::fmt::{self, Display, Formatter};
use std::process::ExitCode;

/// Why a command could not do what it was told: in words, and by the code with which it ends.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub struct Failure {
    kind: FailureKind,
    text: String,
}

/// The kinds of failures, each with its exit code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub enum FailureKind {
    /// Something is wrong with the mechanism: 1.
    Mechanism,
    /// Something is wrong with the command: 2.
    Usage,
    /// A file cannot be read or written: 3.
    File,
    /// Something is wrong with this program: 70.
    Internal,
    /// Nobody reads on, as `head` does when it has enough: 0.
    Unread,
}

impl FailureKind {
    /// The code with which the program ends.
    #[must_use]
    pub const fn code(self) -> u8 {
        match self {
            Self::Mechanism => 1,
            Self::Usage => 2,
            Self::File => 3,
            Self::Internal => 70,
            Self::Unread => 0,
        }
    }
}

impl Failure {
    /// Something is wrong with the mechanism. The text is lower-case, without a final period.
    pub fn mechanism(text: impl Into<String>) -> Self {
        Self::new(FailureKind::Mechanism, text)
    }

    /// Something is wrong with the command.
    pub(crate) fn usage(text: impl Into<String>) -> Self {
        Self::new(FailureKind::Usage, text)
    }

    /// A file cannot be read or written.
    pub fn file(text: impl Into<String>) -> Self {
        Self::new(FailureKind::File, text)
    }

    /// Something is wrong with this program: what that is, in a few words.
    pub(crate) fn internal(what: impl Display) -> Self {
        let text =
            format!("internal error: {what}. Please report it, with the command and the file");
        Self::new(FailureKind::Internal, text)
    }

    /// A failure that the user has read already.
    pub(crate) fn reported(kind: FailureKind) -> Self {
        Self::new(kind, "")
    }

    /// Whether the user has read it already.
    pub(crate) fn is_reported(&self) -> bool {
        self.text.is_empty()
    }

    /// Nobody reads on.
    pub(crate) fn unread() -> Self {
        Self::new(FailureKind::Unread, "")
    }

    pub(crate) fn new(kind: FailureKind, text: impl Into<String>) -> Self {
        let text = text.into();
        Self { kind, text }
    }

    /// Its kind.
    #[must_use]
    pub const fn kind(&self) -> FailureKind {
        self.kind
    }

    /// The code with which the program ends.
    pub(crate) fn exit_code(&self) -> ExitCode {
        self.kind.code().into()
    }
}

impl Display for Failure {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl std::error::Error for Failure {}

/// A picture that cannot be written down.
impl From<FileError> for Failure {
    fn from(error: FileError) -> Self {
        Self::file(format!("the picture cannot be written: {error}"))
    }
}

/// A picture that exceeds the memory.
impl From<TooLarge> for Failure {
    fn from(error: TooLarge) -> Self {
        Self::usage(format!("the picture cannot be painted: {error}"))
    }
}
