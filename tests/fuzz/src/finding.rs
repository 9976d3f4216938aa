//! What was found about a text.

use std::fmt::{self, Display, Formatter};

/// How findings begin that are not mended yet, a line each.
const KNOWN: &str = include_str!("../known.txt");

/// Before the details of a finding.
pub(crate) const DETAILS: &str = " -- ";

/// What was found about a text.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Finding(String);

impl Finding {
    /// Something in words, of one line. Numbers in it say nothing.
    pub(crate) fn new(what: impl Display) -> Self {
        let what = what.to_string();
        let line = what.split_whitespace().collect::<Vec<_>>().join(" ");
        Self(line.chars().take(300).collect())
    }

    /// The same for what differs by numbers, names and details alone.
    pub(crate) fn kind(&self) -> String {
        let (what, _) = self.0.split_once(DETAILS).unwrap_or((&self.0, ""));
        // Every second piece is quoted.
        let unquoted: String = what.split('`').step_by(2).collect();
        let words = unquoted.split_whitespace().map(|word| {
            let number = word.find(|letter: char| letter.is_ascii_digit());
            &word[..number.unwrap_or(word.len())]
        });
        words.filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
    }

    /// Whether somebody has found it before, and it is not mended yet.
    pub(crate) fn is_known(&self) -> bool {
        let kind = self.kind();
        let mut lines = KNOWN.lines().filter(|line| !line.starts_with('#'));
        lines.any(|line| kind.starts_with(&Self::new(line).kind()))
    }
}

impl Display for Finding {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}
