//! Why a command is refused.

use super::Rule;
use crate::failure::{Failure, FailureKind};
use std::fmt::{self, Display, Formatter};

/// Why a command is refused. Nothing was changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    reason: String,
    /// The rule of assembly that forbids it.
    rule: Option<Rule>,
    /// What the compiler says of the text that would result.
    messages: Vec<String>,
    kind: FailureKind,
}

impl Refusal {
    /// One for this reason, which is lower-case and has no final period.
    pub(crate) fn of(reason: impl Into<String>) -> Self {
        Self {
            reason: reason.into(),
            rule: None,
            messages: Vec::new(),
            kind: FailureKind::Mechanism,
        }
    }

    /// A text that could not be read.
    pub(super) fn unread(messages: Vec<String>) -> Self {
        let first = messages.first().and_then(|message| message.lines().next());
        let first = first.unwrap_or("this mechanism could not be read");
        Self {
            reason: format!("the text could not be read any more: {first}"),
            messages,
            ..Self::of("")
        }
    }

    /// A rule of assembly forbids it.
    pub(super) fn forbidden(rule: Rule, messages: Vec<String>) -> Self {
        let first = messages.first().and_then(|message| message.lines().next());
        let why = first.map(|first| format!(": {first}"));
        Self {
            reason: format!("{rule}{}", why.unwrap_or_default()),
            rule: Some(rule),
            messages,
            ..Self::of("")
        }
    }

    /// A mistake of ours.
    pub(super) fn internal(what: &str) -> Self {
        Self {
            kind: FailureKind::Internal,
            ..Self::of(Failure::internal(what).to_string())
        }
    }

    pub(super) fn failed(failure: &Failure) -> Self {
        Self {
            kind: failure.kind(),
            ..Self::of(failure.to_string())
        }
    }

    /// The rule of assembly that forbids it, if one does.
    #[must_use]
    pub fn rule(&self) -> Option<Rule> {
        self.rule
    }

    /// What the compiler says of the text that would result.
    #[must_use]
    pub fn messages(&self) -> &[String] {
        &self.messages
    }

    /// Whether it is a mistake of this program.
    #[must_use]
    pub fn is_internal(&self) -> bool {
        self.kind == FailureKind::Internal
    }
}

impl Display for Refusal {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.reason)
    }
}

impl std::error::Error for Refusal {}

impl From<Refusal> for Failure {
    fn from(refusal: Refusal) -> Self {
        Self::new(refusal.kind, refusal.reason)
    }
}
