//! The statements of a mechanism, as they stand in its text.

use super::{Kind, Lexeme, Lexer};
use std::ops::Range;

/// A statement of a mechanism, or a clause of one that has clauses.
#[derive(Clone, Debug)]
pub(crate) struct Statement<'t> {
    text: &'t str,
    lexemes: Vec<Lexeme>,
}

/// The statements in a range of a text. The last may lack its end.
pub(crate) fn statements<'t>(text: &'t str, range: &Range<usize>) -> Vec<Statement<'t>> {
    let lexemes = Lexer::new(&text[..range.end], range.start).collect::<Vec<_>>();
    split(text, &lexemes)
}

/// Statements end with `;`, or with a closing brace after which no `;` stands.
fn split<'t>(text: &'t str, lexemes: &[Lexeme]) -> Vec<Statement<'t>> {
    let mut found = Vec::new();
    let mut first = 0;
    let mut depth = 0_usize;
    let word = |lexeme: &Lexeme| &text[lexeme.start..lexeme.end];
    for (index, lexeme) in lexemes.iter().enumerate() {
        match lexeme.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            Kind::Word | Kind::Mark => {}
        }
        let next = lexemes.get(index + 1).map(word);
        let ends = match word(lexeme) {
            ";" => true,
            "}" => next != Some(";"),
            _ => false,
        };
        if depth == 0 && ends || next.is_none() {
            let lexemes = lexemes[first..=index].to_vec();
            found.push(Statement { text, lexemes });
            first = index + 1;
        }
    }
    found
}

impl<'t> Statement<'t> {
    /// Where it stands, in bytes.
    pub(crate) fn range(&self) -> Range<usize> {
        let ends = self.lexemes.first().zip(self.lexemes.last());
        ends.map_or(0..0, |(first, last)| first.start..last.end)
    }

    /// A word or mark by its number; nothing after the last.
    pub(crate) fn word(&self, index: usize) -> &'t str {
        let lexeme = self.lexemes.get(index);
        lexeme.map_or("", |lexeme| &self.text[lexeme.start..lexeme.end])
    }

    /// Where a word or mark stands, by its number.
    pub(crate) fn place(&self, index: usize) -> Option<Range<usize>> {
        let lexeme = self.lexemes.get(index)?;
        Some(lexeme.start..lexeme.end)
    }

    /// How many words and marks it has.
    pub(crate) fn len(&self) -> usize {
        self.lexemes.len()
    }

    /// What begins with this word: `joint`, `motor`.
    pub(crate) fn is(&self, word: &str) -> bool {
        self.word(0) == word
    }

    /// The path that begins at a word: `left[2].foot.tip`, without spaces, and the number of the word after it.
    pub(crate) fn path(&self, from: usize) -> (String, usize) {
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
    pub(crate) fn declares(&self, word: &str, name: &str) -> bool {
        self.is(word) && self.path(1).0 == name
    }

    /// Whether some path in it is this one, or begins with it.
    pub(crate) fn mentions(&self, name: &str) -> bool {
        let starts = (1..self.len()).filter(|&at| {
            let is_word = self.lexemes[at].kind == Kind::Word;
            is_word && !matches!(self.word(at - 1), ".")
        });
        let mut paths = starts.map(|at| self.path(at).0);
        paths.any(|path| {
            let inside = path.strip_prefix(name);
            inside.is_some_and(|inside| inside.is_empty() || inside.starts_with('.'))
        })
    }

    /// The number of the first word or mark that is this one.
    pub(crate) fn find(&self, word: &str) -> Option<usize> {
        (0..self.len()).find(|&index| self.word(index) == word)
    }

    /// The clauses between its braces: of `start { … }` and the like.
    pub(crate) fn clauses(&self) -> Vec<Statement<'t>> {
        match (self.find("{"), self.rfind("}")) {
            (Some(open), Some(close)) if open < close => {
                split(self.text, &self.lexemes[open + 1..close])
            }
            _ => Vec::new(),
        }
    }

    /// The number of the last word or mark that is this one.
    pub(crate) fn rfind(&self, word: &str) -> Option<usize> {
        (0..self.len())
            .rev()
            .find(|&index| self.word(index) == word)
    }
}
