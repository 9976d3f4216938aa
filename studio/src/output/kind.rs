//! Files that are written, and their kinds: by which endings and which first bytes one is known.

use std::path::{Path, PathBuf};

/// A kind of file that is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OutputKind {
    Png,
    Gif,
    Svg,
    Csv,
    Dot,
    #[cfg_attr(not(feature = "editor"), expect(dead_code, reason = "the window writes it"))]
    Report,
    /// The text of a mechanism, in a file of its own or in Rust.
    Mechanism,
    /// A mechanism that was written as Rust.
    #[cfg_attr(not(feature = "editor"), expect(dead_code, reason = "the window writes it"))]
    Rust,
}

impl OutputKind {
    /// How many of its first bytes tell what a file is.
    pub(super) const FIRST: u64 = 4096;

    /// Returns the endings of its files' names; the first is the usual one.
    pub(crate) const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Png => &["png", "apng"],
            Self::Gif => &["gif"],
            Self::Svg => &["svg"],
            Self::Csv => &["csv"],
            Self::Dot => &["dot", "gv"],
            Self::Report => &["txt"],
            Self::Mechanism => &["mech", "rs"],
            Self::Rust => &["rs"],
        }
    }

    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Png => "a PNG picture",
            Self::Gif => "a GIF picture",
            Self::Svg => "an SVG picture",
            Self::Csv => "a table of mech",
            Self::Dot => "a graph in DOT",
            Self::Report => "a report of mech",
            Self::Mechanism | Self::Rust => "a mechanism",
        }
    }

    /// Whether a file has one of its endings.
    pub(crate) fn has_ending(self, path: &Path) -> bool {
        ends_in(path, self.endings())
    }

    /// Whether a file that begins with these bytes is one of this kind. An empty one holds nothing that could be lost.
    pub(super) fn begins(self, bytes: &[u8]) -> bool {
        let text = || String::from_utf8_lossy(bytes);
        bytes.is_empty()
            || match self {
                Self::Png => bytes.starts_with(b"\x89PNG\r\n\x1a\n"),
                Self::Gif => bytes.starts_with(b"GIF8"),
                Self::Svg => {
                    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
                    let bytes = bytes.trim_ascii_start();
                    bytes.starts_with(b"<svg") || bytes.starts_with(b"<?xml")
                }
                Self::Csv => has_unit(&text()),
                Self::Dot => bytes.starts_with(b"graph ") || bytes.starts_with(b"digraph "),
                Self::Report => {
                    let text = text();
                    let second = text.lines().nth(1);
                    second.is_some_and(|line| line.starts_with("  mobility "))
                }
                Self::Mechanism | Self::Rust => text().contains("mechanism!"),
            }
    }
}

/// Whether the first cell of a table is a name with a unit, as `motor a [deg]`.
fn has_unit(table: &str) -> bool {
    let line = table.lines().next().unwrap_or_default();
    let cell = line.split(',').next().unwrap_or_default();
    let cell = cell.trim_matches('"');
    cell.contains(" [") && cell.ends_with(']')
}

#[derive(Clone, Debug)]
pub(crate) struct Output {
    pub(crate) path: PathBuf,
    pub(super) kind: OutputKind,
    pub(super) bytes: Vec<u8>,
    pub(super) over: Over,
    /// The files from which it was made: it never takes the place of one of them.
    pub(super) inputs: Vec<PathBuf>,
}

/// Whether the name of a file has one of these endings, in letters of any size.
pub(crate) fn ends_in(path: &Path, endings: &[&str]) -> bool {
    let ending = path.extension().unwrap_or_default();
    endings.iter().any(|known| ending.eq_ignore_ascii_case(known))
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

#[cfg(test)]
mod tests {
    use super::OutputKind;

    #[test]
    fn a_kind_is_known_by_its_first_bytes() {
        for (kind, is, is_not) in [
            (OutputKind::Png, &b"\x89PNG\r\n\x1a\n\0"[..], &b"\x89PNG"[..]),
            (OutputKind::Gif, b"GIF89a", b"GIF"),
            (OutputKind::Svg, b"\xef\xbb\xbf\n<?xml ", b"<html><svg"),
            (OutputKind::Csv, b"motor a [deg],b [deg]\n0,1\n", b"name,[unit]\n"),
            (OutputKind::Csv, b"t [s]", b"t\n[s]"),
            (OutputKind::Dot, b"graph A {", b"graphic"),
            (OutputKind::Report, b"A\n  mobility  1 = 3", b"A\nmobility"),
            (OutputKind::Rust, b"use x;\nmechanism! {", b"fn main() {}"),
        ] {
            assert!(kind.begins(is), "{kind:?}");
            assert!(!kind.begins(is_not), "{kind:?}");
            assert!(kind.begins(b""), "{kind:?}");
        }
    }
}
