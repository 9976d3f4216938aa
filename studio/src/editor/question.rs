//! Questions in a window of their own, and where the user goes from there.

use super::desk;
use super::example::Example;
use super::order::Export;
use std::path::Path;
#[cfg(target_arch = "wasm32")]
use std::path::PathBuf;

/// Something that is asked in a window of its own.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Dialog {
    File(FileUse, String),
    /// Whether the text is saved before another one is edited.
    Leave(Destination),
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum FileUse {
    Open,
    Picture,
    /// The text is written to it. Afterwards another one may be edited.
    Save(Option<Destination>),
    /// Something of this kind is written to it.
    Export(Export),
}

impl FileUse {
    /// The title of the question, and what its button says.
    pub(in crate::editor) const fn words(&self) -> (&'static str, &'static str) {
        match self {
            Self::Open => ("Open a file", "Open"),
            Self::Picture => ("Put a picture behind the drawing", "Show"),
            Self::Save(_) => ("Save to a file", "Save"),
            Self::Export(kind) => (kind.name(), "Write"),
        }
    }

    pub(in crate::editor) const fn hint(&self) -> &'static str {
        match self {
            Self::Picture => "photo.jpg",
            Self::Open | Self::Save(_) | Self::Export(_) => "four_bar.mech",
        }
    }

    pub(crate) const fn writes(&self) -> bool {
        matches!(self, Self::Save(_) | Self::Export(_))
    }

    /// Returns a name for the files that fit, and the endings of their names.
    pub(crate) const fn endings(&self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::Picture => ("pictures", &desk::ENDINGS),
            Self::Open => ("mechanisms", &["mech", "rs", "linkage2"]),
            Self::Save(_) => ("mechanisms", &["mech", "rs"]),
            Self::Export(kind) => (kind.name(), kind.endings()),
        }
    }
}

/// Where the user goes when the present text is left.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Destination {
    Empty,
    /// A file, or what a link of PMKS+ holds.
    File(String),
    /// A text that is known already, with the name of its file.
    #[cfg(target_arch = "wasm32")]
    Text(PathBuf, String),
    Example(&'static Example),
    /// Away: the window is closed.
    Away,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Ending {
    #[default]
    Stays,
    /// A line wants to close it.
    Wanted,
    /// It may be closed, whatever is lost.
    Granted,
}

impl Destination {
    /// A file with its text. On a computer it is the file that counts: it is read again, and watched.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn text(path: &Path, _: String) -> Self {
        Self::File(path.to_string_lossy().into_owned())
    }

    /// A file with its text: a page cannot read it again.
    #[cfg(target_arch = "wasm32")]
    pub(super) fn text(path: &Path, text: String) -> Self {
        Self::Text(path.to_owned(), text)
    }
}
