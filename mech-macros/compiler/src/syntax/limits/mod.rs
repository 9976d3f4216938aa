//! The limits of what a stranger may send: macro, command, studio, page and dialogue read no text beyond them.
//!
//! A text is counted before anything is made of it, so that no text takes long, and none takes the stack.

#[cfg(test)]
mod tests;

use super::lexer::{Kind, Lexer};
use super::{Message, Place};
use proc_macro2::{Group, Span, TokenStream, TokenTree, token_stream};
use std::fmt::{self, Display, Formatter};
use std::ops::Range;

/// A limit of a text, or of the mechanism that it declares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Bytes in a text.
    Length,
    /// Brackets in one another.
    Depth,
    /// Characters of a number.
    Number,
    /// Characters of a word.
    Word,
    /// Words, numbers and marks of a text.
    Tokens,
    /// Statements of a text, and items in braces: each ends with `;` or `}`.
    Statements,
    /// Instances of parts.
    Instances,
    /// Statements of a mechanism, those of a part as often as it has instances.
    Copies,
    /// Links of a mechanism, with those of its instances.
    Links,
    /// Motors of a mechanism.
    Motors,
    /// Links of a mechanism of which rates are computed.
    Rates,
    /// Links of a mechanism of which forces are computed.
    Forces,
}

impl Limit {
    /// All of them.
    pub const ALL: [Self; 12] = [
        Self::Length,
        Self::Depth,
        Self::Number,
        Self::Word,
        Self::Tokens,
        Self::Statements,
        Self::Instances,
        Self::Copies,
        Self::Links,
        Self::Motors,
        Self::Rates,
        Self::Forces,
    ];

    /// The most that is read.
    #[must_use]
    pub const fn most(self) -> usize {
        match self {
            Self::Length => 1 << 20,
            Self::Depth => 100,
            Self::Number => 800,
            Self::Word | Self::Instances | Self::Rates => 1000,
            Self::Tokens => 200_000,
            Self::Statements => 10_000,
            Self::Copies => 20_000,
            Self::Links => 2500,
            Self::Motors => 300,
            Self::Forces => 500,
        }
    }

    /// What has a limit, and what is counted.
    #[must_use]
    pub const fn words(self) -> [&'static str; 2] {
        const TEXT: &str = "this text";
        const MECHANISM: &str = "this mechanism";
        match self {
            Self::Length => [TEXT, "bytes"],
            Self::Depth => ["this place", "brackets around it"],
            Self::Number => ["this number", "characters"],
            Self::Word => ["this word", "characters"],
            Self::Tokens => [TEXT, "words, numbers and marks"],
            Self::Statements => [TEXT, "statements"],
            Self::Instances => [MECHANISM, "instances of parts"],
            Self::Copies => [MECHANISM, "statements, with those of all instances"],
            Self::Links => [MECHANISM, "links"],
            Self::Motors => [MECHANISM, "motors"],
            Self::Rates => [MECHANISM, "links of which rates are computed"],
            Self::Forces => [MECHANISM, "links of which forces are computed"],
        }
    }
}

impl Display for Limit {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let [subject, counted] = self.words();
        let most = self.most();
        write!(f, "{subject} has more than {most} {counted}, which is the limit")
    }
}

/// A place from which on a text is beyond a limit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excess<P> {
    /// The limit.
    pub limit: Limit,
    /// The place.
    pub place: P,
}

impl Excess<Span> {
    /// Tells it.
    pub(crate) fn message(&self) -> Message {
        Message::new(Place::at(self.place), self.limit.to_string())
    }
}

/// Counts what stands in a text, whatever it is, in a time that grows with its length alone.
///
/// # Errors
/// The first place that is beyond a limit, in bytes.
pub fn of_text(text: &str) -> Result<(), Excess<Range<usize>>> {
    let most = Limit::Length.most();
    if text.len() > most {
        let boundary = |at: &usize| text.is_char_boundary(*at);
        let start = (0..=most).rev().find(boundary).unwrap_or(0);
        let end = (start + 1..text.len()).find(boundary).unwrap_or(text.len());
        return Err(Excess { limit: Limit::Length, place: start..end });
    }
    let mut counter = Counter::default();
    for lexeme in Lexer::new(text, 0) {
        let place = lexeme.start..lexeme.end;
        let written = &text[place.clone()];
        let counted = match lexeme.kind {
            Kind::Open => counter.open(),
            Kind::Close => counter.close(written == "}"),
            Kind::Mark => counter.mark(written == ";"),
            Kind::Word => counter.word(written),
        };
        counted.map_err(|limit| Excess { limit, place })?;
    }
    Ok(())
}

/// The same of tokens.
///
/// # Errors
/// The first place that is beyond a limit.
pub fn of_tokens(text: &TokenStream) -> Result<(), Excess<Span>> {
    let mut counter = Counter::default();
    // Nothing here calls itself: tokens may stand in more brackets than the stack holds calls.
    let mut waiting: Vec<(Option<Group>, token_stream::IntoIter)> =
        vec![(None, text.clone().into_iter())];
    while let Some((_, trees)) = waiting.last_mut() {
        let (place, counted) = match trees.next() {
            None => match waiting.pop() {
                Some((Some(group), _)) => {
                    let is_brace = group.delimiter() == proc_macro2::Delimiter::Brace;
                    (group.span_close(), counter.close(is_brace))
                }
                _ => break,
            },
            Some(TokenTree::Group(group)) => {
                let place = group.span_open();
                waiting.push((Some(group.clone()), group.stream().into_iter()));
                (place, counter.open())
            }
            Some(TokenTree::Punct(mark)) => (mark.span(), counter.mark(mark.as_char() == ';')),
            Some(TokenTree::Ident(word)) => (word.span(), counter.word(&word.to_string())),
            Some(TokenTree::Literal(literal)) => {
                (literal.span(), counter.literal(&literal.to_string()))
            }
        };
        counted.map_err(|limit| Excess { limit, place })?;
    }
    Ok(())
}

/// The counts of a text as far as it was read.
#[derive(Default)]
struct Counter {
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
    if count > limit.most() { Err(limit) } else { Ok(()) }
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
        within(text.len(), if is_number { Limit::Number } else { Limit::Word })
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
