//! What is counted of a text, be it letters or tokens.

use super::Limit;

/// The counts of a text as far as it was read.
#[derive(Default)]
pub(super) struct Counter {
    depth: usize,
    tokens: usize,
    statements: usize,
}

/// Counts one more.
fn count(counted: &mut usize, limit: Limit) -> Result<(), Limit> {
    *counted += 1;
    within(*counted, limit)
}

fn within(count: usize, limit: Limit) -> Result<(), Limit> {
    if count > limit.most() {
        Err(limit)
    } else {
        Ok(())
    }
}

impl Counter {
    /// An opening bracket.
    pub(super) fn open(&mut self) -> Result<(), Limit> {
        count(&mut self.tokens, Limit::Tokens)?;
        count(&mut self.depth, Limit::Depth)
    }

    /// A closing bracket, which may end a statement.
    pub(super) fn close(&mut self, is_end: bool) -> Result<(), Limit> {
        self.depth = self.depth.saturating_sub(1);
        self.mark(is_end)
    }

    /// A mark, which may end a statement.
    pub(super) fn mark(&mut self, is_end: bool) -> Result<(), Limit> {
        count(&mut self.tokens, Limit::Tokens)?;
        if is_end {
            count(&mut self.statements, Limit::Statements)?;
        }
        Ok(())
    }

    /// A word, or a number without a point.
    pub(super) fn word(&mut self, text: &str) -> Result<(), Limit> {
        count(&mut self.tokens, Limit::Tokens)?;
        let is_number = text.starts_with(|first: char| first.is_ascii_digit());
        within(
            text.len(),
            if is_number {
                Limit::Number
            } else {
                Limit::Word
            },
        )
    }

    /// A number, or a literal in quotes, which may be as long as the text.
    pub(super) fn literal(&mut self, text: &str) -> Result<(), Limit> {
        if !text.starts_with(|first: char| first.is_ascii_digit()) {
            return count(&mut self.tokens, Limit::Tokens);
        }
        let mut parts = text.split(['.', '-', '+']).filter(|part| !part.is_empty());
        parts.try_for_each(|part| self.word(part))?;
        (0..text.matches(['.', '-', '+']).count()).try_for_each(|_| self.mark(false))
    }
}
