//! Changes of a text.

use std::ops::Range;

/// A change of a text. The tokens of the text are counted from its first, brackets among them; all numbers are those before any change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Edit {
    /// This text stands in place of these tokens.
    Replace(Range<usize>, String),
    /// This text stands directly before a token.
    Before(usize, String),
    /// This text stands directly after a token.
    After(usize, String),
    /// These tokens go: a statement, a clause or a part of one. What fills lines goes with them and with the comment on it.
    Remove(Range<usize>),
    /// A statement or a clause is added after another: in a line of its own where that has one.
    Add(Range<usize>, String),
}

/// Changes of a text that are made together. No two change the same tokens.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Edits(Vec<Edit>);

impl Edits {
    /// All of them, in the order in which they were made.
    pub fn iter(&self) -> impl Iterator<Item = &Edit> {
        self.0.iter()
    }

    /// Whether nothing is changed.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether some of these tokens are replaced or removed.
    #[must_use]
    pub fn is_changed(&self, tokens: &Range<usize>) -> bool {
        let mut changed = self.0.iter().filter_map(Edit::changed);
        changed.any(|known| known.start < tokens.end && tokens.start < known.end)
    }

    /// Whether all of these tokens are removed.
    pub(super) fn is_removed(&self, tokens: &Range<usize>) -> bool {
        self.0.iter().any(|edit| match edit {
            Edit::Remove(gone) => gone.start <= tokens.start && tokens.end <= gone.end,
            _ => false,
        })
    }

    /// Replaces tokens. Where some of them are changed already, that stays.
    pub fn replace(&mut self, tokens: Range<usize>, by: impl Into<String>) {
        if !self.is_changed(&tokens) {
            self.0.push(Edit::Replace(tokens, by.into()));
        }
    }

    /// Puts a text directly before a token.
    pub fn insert_before(&mut self, token: usize, text: impl Into<String>) {
        self.0.push(Edit::Before(token, text.into()));
    }

    /// Puts a text directly after a token.
    pub fn insert_after(&mut self, token: usize, text: impl Into<String>) {
        self.0.push(Edit::After(token, text.into()));
    }

    /// Removes tokens: a statement, a clause or a part of one.
    pub fn remove(&mut self, tokens: Range<usize>) {
        let is_within = |inner: &Range<usize>, outer: &Range<usize>| {
            outer.start <= inner.start && inner.end <= outer.end
        };
        let mut changed = self.0.iter().filter_map(Edit::changed);
        if changed.any(|known| is_within(&tokens, known)) {
            return;
        }
        self.0.retain(|edit| !edit.changed().is_some_and(|known| is_within(known, &tokens)));
        self.0.push(Edit::Remove(tokens));
    }

    /// Adds a statement or a clause after another.
    pub fn add(&mut self, after: Range<usize>, text: impl Into<String>) {
        self.0.push(Edit::Add(after, text.into()));
    }
}

impl Edit {
    /// The tokens that are there no more.
    fn changed(&self) -> Option<&Range<usize>> {
        match self {
            Self::Replace(tokens, _) | Self::Remove(tokens) => Some(tokens),
            Self::Before(..) | Self::After(..) | Self::Add(..) => None,
        }
    }

    /// Where it is made: the tokens that it replaces, or the place between two; and by what.
    pub(super) fn splice(&self) -> (Range<usize>, &str) {
        match self {
            Self::Replace(tokens, text) => (tokens.clone(), text),
            Self::Remove(tokens) => (tokens.clone(), ""),
            Self::Before(token, text) => (*token..*token, text),
            Self::After(token, text) => (token + 1..token + 1, text),
            Self::Add(after, text) => (after.end..after.end, text),
        }
    }

    /// A token of the statement in which it is made.
    pub(super) fn anchor(&self) -> usize {
        match self {
            Self::Replace(tokens, _) | Self::Remove(tokens) | Self::Add(tokens, _) => tokens.start,
            Self::Before(token, _) | Self::After(token, _) => *token,
        }
    }
}
