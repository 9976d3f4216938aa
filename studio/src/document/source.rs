//! A file with a text, as it was read.

use crate::failure::Failure;
use crate::input;
use crate::output::{self, Output, OutputKind, Over};
use mech_compiler::limits::Limit;
use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The longest text that is read, in bytes. No source file comes near it; noise does.
pub const LONGEST: u64 = Limit::Length.most() as u64;

/// The longest drawing of another program that is read, in bytes.
const LONGEST_FOREIGN: u64 = 16 << 20;

/// A file with a text, as it was read.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub struct Source {
    path: PathBuf,
    text: String,
}

/// A place in a text, as editors count: from 1. Columns are characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spot {
    /// The line.
    pub line: usize,
    /// The column.
    pub column: usize,
}

impl Source {
    /// Reads a file.
    ///
    /// # Errors
    /// If it cannot be read, is longer than [`LONGEST`], or is not UTF-8.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let text = text_of(path)?;
        Ok(Self::new(path, text))
    }

    /// Reads a plain file. Who opens a pipe or a device may wait for ever.
    pub(crate) fn read_plain(path: &Path) -> Result<Self, Failure> {
        let bytes = input::read(path, LONGEST).map_err(|error| unread(path, &error))?;
        Ok(Self::new(path, utf_8(path, bytes)?))
    }

    /// Reads what another program wrote. What is not UTF-8 is Latin-1.
    pub(crate) fn read_foreign(path: &Path) -> Result<Self, Failure> {
        let file = File::open(path).map_err(|error| unread(path, &error))?;
        Self::read_foreign_from(path, file)
    }

    /// The same of a plain file.
    #[cfg(feature = "editor")]
    pub(crate) fn read_foreign_plain(path: &Path) -> Result<Self, Failure> {
        let bytes = input::read(path, LONGEST_FOREIGN).map_err(|error| unread(path, &error))?;
        Self::read_foreign_from(path, &*bytes)
    }

    /// The same of what has a name but is no file of its own, such as the standard input.
    pub(crate) fn read_foreign_from(
        name: impl AsRef<Path>,
        input: impl Read,
    ) -> Result<Self, Failure> {
        let bytes = bytes_from(name.as_ref(), input, LONGEST_FOREIGN)?;
        let text = String::from_utf8(bytes);
        let text =
            text.unwrap_or_else(|error| error.as_bytes().iter().copied().map(char::from).collect());
        Ok(Self::new(name.as_ref(), text))
    }

    /// A text that was not read from a file.
    pub fn new(path: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        Self { path: path.into(), text: text.into() }
    }

    /// Where it was read.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Where a byte stands.
    #[must_use]
    pub fn spot(&self, byte: usize) -> Spot {
        let mut end = byte.min(self.text.len());
        while !self.text.is_char_boundary(end) {
            end -= 1;
        }
        let before = &self.text[..end];
        let start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Spot { line: before.matches('\n').count() + 1, column: before[start..].chars().count() + 1 }
    }

    /// The same text with everything but some ranges blank, so that what stands there keeps its place in bytes.
    #[must_use]
    pub fn masked(&self, range: &Range<usize>) -> String {
        let mut masked = " ".repeat(range.start);
        masked.push_str(&self.text[range.clone()]);
        masked
    }

    /// Replaces the text in the file.
    ///
    /// # Errors
    /// If the file is not as it was read, or cannot be written. It then stays as it is.
    pub fn replace(&self, text: &str) -> Result<(), Failure> {
        output::write(self.replacement(text))
    }

    /// Another text for the file, which takes the place of this one only.
    pub(crate) fn replacement(&self, text: &str) -> Output {
        let output = Output::new(&self.path, OutputKind::Mechanism, text);
        output.over(Over::Text(self.text.clone()))
    }
}

fn text_of(path: &Path) -> Result<String, Failure> {
    let file = File::open(path).map_err(|error| unread(path, &error))?;
    text_from(path, file)
}

fn text_from(path: &Path, input: impl Read) -> Result<String, Failure> {
    utf_8(path, bytes_from(path, input, LONGEST)?)
}

fn utf_8(path: &Path, bytes: Vec<u8>) -> Result<String, Failure> {
    String::from_utf8(bytes).map_err(|error| {
        let place = error.utf8_error().valid_up_to();
        unread(path, &format!("byte {place} is not UTF-8"))
    })
}

fn bytes_from(path: &Path, input: impl Read, longest: u64) -> Result<Vec<u8>, Failure> {
    input::read_from(input, longest).map_err(|error| unread(path, &error))
}

fn unread(path: &Path, why: &dyn std::fmt::Display) -> Failure {
    Failure::file(format!("cannot read `{}`: {why}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_count_from_one() {
        let source = Source::new("a.mech", "ab\nçd\n");
        let spot = |byte| {
            let Spot { line, column } = source.spot(byte);
            (line, column)
        };
        assert_eq!(spot(0), (1, 1));
        assert_eq!(spot(3), (2, 1));
        // Within a character: at its beginning.
        assert_eq!(spot(4), (2, 1));
        assert_eq!(spot(5), (2, 2));
        assert_eq!(spot(99), (3, 1));
    }
}
