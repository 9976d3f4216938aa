//! The statements of a mechanism, as they stand in its text.

use super::token::{Token, TokenKind};
use std::ops::Range;

/// A statement of a mechanism, or a clause of one that has clauses, as it stands in a text.
#[derive(Clone, Debug)]
pub struct StatementText<'s> {
    tokens: &'s [Token],
    range: Range<usize>,
}

/// The statements among these of the tokens: they end with `;`, or with a closing brace after which no `;` stands. The last may lack its end.
pub(super) fn split(tokens: &[Token], range: Range<usize>) -> Vec<StatementText<'_>> {
    let mut found = Vec::new();
    let mut first = range.start;
    let mut depth = 0_usize;
    for index in range.clone() {
        match &tokens[index].kind {
            TokenKind::Open(..) => depth += 1,
            TokenKind::Close(..) => depth = depth.saturating_sub(1),
            TokenKind::Single(_) => {}
        }
        let next = index + 1;
        let ends = match &*tokens[index].text {
            ";" => true,
            "}" => next < range.end && tokens[next].text != ";",
            _ => false,
        };
        if depth == 0 && ends || next == range.end {
            let begin = after_attributes(tokens, first..next);
            found.push(StatementText::new(tokens, begin..next));
            first = next;
        }
    }
    found
}

/// Where a statement begins after its attributes and doc comments.
fn after_attributes(tokens: &[Token], range: Range<usize>) -> usize {
    let mut at = range.start;
    while at + 1 < range.end && tokens[at].text == "#" && tokens[at + 1].text == "[" {
        let mut depth = 0_usize;
        let end = (at + 1..range.end).find(|&index| {
            match &tokens[index].kind {
                TokenKind::Open(..) => depth += 1,
                TokenKind::Close(..) => depth -= 1,
                TokenKind::Single(_) => {}
            }
            depth == 0
        });
        match end {
            Some(end) if end + 1 < range.end => at = end + 1,
            _ => break,
        }
    }
    at
}

impl<'s> StatementText<'s> {
    pub(super) fn new(tokens: &'s [Token], range: Range<usize>) -> Self {
        Self { tokens, range }
    }

    /// The numbers of its tokens in the text.
    #[must_use]
    pub fn range(&self) -> Range<usize> {
        self.range.clone()
    }

    /// A word, number, mark or bracket of it by its number in it; nothing after the last.
    #[must_use]
    pub fn word(&self, index: usize) -> &'s str {
        let tokens: &'s [Token] = &self.tokens[self.range()];
        tokens.get(index).map_or("", |token| &token.text)
    }

    /// The number in the text of its token with this number in it.
    #[must_use]
    pub fn token(&self, index: usize) -> usize {
        self.range.start + index
    }

    /// Returns the number of its tokens.
    #[must_use]
    pub fn len(&self) -> usize {
        self.range.len()
    }

    /// Whether it has no tokens: no statement has none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.range.is_empty()
    }

    /// Whether it begins with this word: `joint`, `motor`.
    #[must_use]
    pub fn is(&self, word: &str) -> bool {
        self.word(0) == word
    }

    /// The path that begins at a word: `left[2].foot.tip`, without spaces, and the number of the word after it.
    #[must_use]
    pub fn path(&self, from: usize) -> (String, usize) {
        let mut path = self.word(from).to_owned();
        let mut at = from + 1;
        loop {
            match self.word(at) {
                "." => {
                    path += ".";
                    path += self.word(at + 1);
                    at += 2;
                }
                "[" => {
                    path += &["[", self.word(at + 1), "]"].concat();
                    at += 3;
                }
                _ => return (path, at),
            }
        }
    }

    /// Whether what it declares, after its first word, has this name.
    #[must_use]
    pub fn declares(&self, word: &str, name: &str) -> bool {
        self.is(word) && name.starts_with(self.word(1)) && self.path(1).0 == name
    }

    /// Whether some path in it is this one, or begins with it.
    #[must_use]
    pub fn mentions(&self, name: &str) -> bool {
        let starts = (1..self.len()).filter(|&at| {
            let is_word = self.tokens[self.token(at)].is_word();
            is_word && self.word(at - 1) != "."
        });
        let mut paths = starts.map(|at| self.path(at).0);
        paths.any(|path| begins_with(&path, name))
    }

    /// The number of the first word or mark that is this one.
    #[must_use]
    pub fn find(&self, word: &str) -> Option<usize> {
        (0..self.len()).find(|&index| self.word(index) == word)
    }

    /// The number of the last word or mark that is this one.
    #[must_use]
    pub fn rfind(&self, word: &str) -> Option<usize> {
        (0..self.len()).rfind(|&index| self.word(index) == word)
    }

    /// The clauses between its braces: of `start { … }` and the like.
    #[must_use]
    pub fn clauses(&self) -> Vec<StatementText<'s>> {
        match (self.find("{"), self.rfind("}")) {
            (Some(open), Some(close)) if open < close => {
                split(self.tokens, self.token(open + 1)..self.token(close))
            }
            _ => Vec::new(),
        }
    }
}

/// Whether a path is this name, or something in what has this name.
pub(super) fn begins_with(path: &str, name: &str) -> bool {
    let inside = path.strip_prefix(name);
    inside.is_some_and(|inside| inside.is_empty() || inside.starts_with('.'))
}
