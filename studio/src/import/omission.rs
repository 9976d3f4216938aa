//! Omissions of an import.

use std::fmt::{self, Display, Formatter};

/// Something that could not be carried over, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Omission {
    /// The name of its subject: `connector 3`.
    pub(super) of: String,
    /// The loss, in a sentence.
    pub(super) what: String,
}

impl Omission {
    pub(super) fn new(of: impl Into<String>, what: impl Into<String>) -> Self {
        let (of, what) = (of.into(), what.into());
        Self { of, what }
    }

    /// A motor is on one joint.
    pub(super) fn free_links(of: &str) -> Self {
        let what = "its motor moves the first of several links on it; the others are free";
        Self::new(of, what)
    }
}

impl Display for Omission {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.of, self.what)
    }
}

/// All of it, a line each; nothing if nothing is lost.
pub(crate) fn listed(omissions: &[Omission]) -> String {
    if omissions.is_empty() {
        return String::new();
    }
    let lines = omissions.iter().map(|one| format!("  {one}\n"));
    format!("not carried over:\n{}", lines.collect::<String>())
}
