//! Why a command is refused.

use crate::failure::{Failure, FailureKind};
use std::fmt::{self, Display, Formatter};

/// The rules of assembly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub enum Rule {
    /// A joint joins two links.
    TwoLinks,
    /// Two axes are joined once.
    Once,
    /// Joints leave a freedom.
    Freedom,
    /// Nothing is held more than once.
    HeldOnce,
    /// The axes can coincide.
    Coincidence,
    /// A rolling pair has a carrier, and its sizes fit.
    Rolling,
}

impl Display for Rule {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::TwoLinks => "a rule of assembly forbids it: a joint joins two different links",
            Self::Once => "a rule of assembly forbids it: two axes are joined only once",
            Self::Freedom => "a rule of assembly forbids it: something has to be able to move",
            Self::HeldOnce => "a rule of assembly forbids it: no part is held more than once",
            Self::Coincidence => {
                "a rule of assembly forbids it: the axes cannot be made to coincide"
            }
            Self::Rolling => {
                "a rule of assembly forbids it: what rolls has a carrier on which it fits"
            }
        })
    }
}

/// Why a command is refused. Nothing was changed.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub struct Refusal {
    reason: String,
    /// The rule of assembly that forbids it.
    rule: Option<Rule>,
    /// The compiler's messages on the text that would result.
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

    pub(super) fn internal(what: &str) -> Self {
        Self { kind: FailureKind::Internal, ..Self::of(Failure::internal(what).to_string()) }
    }

    pub(super) fn failed(failure: &Failure) -> Self {
        Self { kind: failure.kind(), ..Self::of(failure.to_string()) }
    }

    /// The rule of assembly that forbids it, if one does.
    #[must_use]
    pub fn rule(&self) -> Option<Rule> {
        self.rule
    }

    /// Returns the compiler's messages on the text that would result.
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
