//! The first slip in a text that does not even consist of words, numbers and marks.

mod bracket;
mod quote;
mod sign;

use super::Source;
use crate::text::{Kind, Lexeme, Lexer, Replacement, written};
use std::ops::Range;

/// So many bytes are read, in all, to choose among changes.
const MOST: usize = 1 << 19;
/// So many changes are tried.
const TRIED: usize = 64;

/// What keeps a text from being read.
#[derive(Debug)]
pub(super) struct Unlexed {
    /// Where it stands in the file, in bytes.
    pub(super) place: Range<usize>,
    /// The text for the user.
    pub(super) text: String,
    /// The change that mends it, if one is known.
    pub(super) change: Option<Replacement>,
}

impl Unlexed {
    /// One that no change is known for.
    pub(super) fn new(place: Range<usize>, text: impl Into<String>) -> Self {
        let (text, change) = (text.into(), None);
        Self { place, text, change }
    }
}

/// A stretch of a file that does not lex.
struct Body<'t> {
    source: &'t Source,
    /// The file up to the end of the stretch.
    text: &'t str,
    start: usize,
    lexemes: Vec<Lexeme>,
    /// Counts the faults of another text for it; none if that does not lex, either.
    faults: &'t dyn Fn(&str) -> Option<usize>,
}

/// Finds the first slip in a stretch of a file. The lexer stops `at` this byte; the function counts the faults of another text for the
/// stretch, and has none if that does not lex, either.
pub(super) fn slip(
    source: &Source,
    range: &Range<usize>,
    at: usize,
    faults: &dyn Fn(&str) -> Option<usize>,
) -> Unlexed {
    let text = &source.text()[..range.end];
    let at = (range.start..=at.clamp(range.start, range.end))
        .rfind(|&at| text.is_char_boundary(at))
        .unwrap_or(range.start);
    let body = Body {
        source,
        text,
        start: range.start,
        lexemes: Lexer::new(text, range.start).collect(),
        faults,
    };
    let is_bracket = text[at..].starts_with(['(', ')', '[', ']', '{', '}']);
    sign::slip(&body, at)
        .or_else(|| quote::slip(&body, at))
        .or_else(|| bracket::slip(&body).filter(|_| is_bracket))
        .unwrap_or_else(|| body.unknown(at))
}

impl Body<'_> {
    fn word(&self, index: usize) -> &str {
        let lexeme = self.lexemes.get(index);
        lexeme.map_or("", |lexeme| &self.text[lexeme.start..lexeme.end])
    }

    fn place(&self, index: usize) -> Range<usize> {
        self.lexemes[index].start..self.lexemes[index].end
    }

    /// The first of some changes that leaves the fewest faults; none if the text lexes after none of them.
    fn best<E>(
        &self,
        edits: impl IntoIterator<Item = (E, Replacement)>,
    ) -> Option<(E, Replacement)> {
        let tried = (MOST / (self.text.len() - self.start).max(1)).clamp(1, TRIED);
        let mut best: Option<(usize, (E, Replacement))> = None;
        for (edit, change) in edits.into_iter().take(tried) {
            let after = written(self.text, std::slice::from_ref(&change));
            let Some(faults) = (self.faults)(&after[self.start..]) else {
                continue;
            };
            if best.as_ref().is_none_or(|(fewest, _)| faults < *fewest) {
                best = Some((faults, (edit, change)));
            }
            if faults == 0 {
                break;
            }
        }
        best.map(|(_, edit)| edit)
    }

    /// What the lexer cannot read, and nobody foresaw.
    fn unknown(&self, at: usize) -> Unlexed {
        let index = self.lexemes.partition_point(|lexeme| lexeme.end <= at);
        let word = self.word(index);
        if self.lexemes.get(index).is_none_or(|lexeme| lexeme.start != at) {
            let end = self.text[at..].chars().next().map_or(at, |sign| at + sign.len_utf8());
            return Unlexed::new(
                at..end,
                "this cannot be read: a quote or a bracket may be without its partner",
            );
        }
        let place = self.place(index);
        let is_mark = self.lexemes[index].kind == Kind::Mark;
        let removal = Replacement::new(place.clone(), "");
        let removal = is_mark.then_some(((), removal));
        Unlexed {
            place,
            text: if word.starts_with(|first: char| first.is_ascii_digit()) {
                format!("`{word}` is no number")
            } else if is_mark {
                format!("`{}` has no meaning here; remove it", word.escape_debug())
            } else {
                format!("`{word}` is no word and no number")
            },
            change: self.best(removal).map(|((), change)| change),
        }
    }
}

#[cfg(test)]
mod tests;
