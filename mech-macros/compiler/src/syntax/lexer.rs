//! Words, brackets and marks of a text that may be wrong in any way.

/// The kinds of lexemes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A word or a number; a number with a point is two.
    Word,
    /// An opening bracket.
    Open,
    /// A closing bracket.
    Close,
    /// Any other character.
    Mark,
}

/// A word, a bracket or a mark, and where it stands.
#[derive(Clone, Copy, Debug)]
pub struct Lexeme {
    /// Its kind.
    pub kind: Kind,
    /// Its first byte.
    pub start: usize,
    /// The byte after its last.
    pub end: usize,
}

/// Words, brackets and marks of a text. Spaces, comments and literals are left out.
pub struct Lexer<'t> {
    text: &'t str,
    at: usize,
    /// So many bytes may still be searched for ends that are not there: else a text of quotes takes the square of its length.
    vain: usize,
}

/// So many times may a text be searched to its end in vain.
const SEARCHES: usize = 16;

impl<'t> Lexer<'t> {
    /// Reads a text from a byte on, to its end.
    #[must_use]
    pub fn new(text: &'t str, at: usize) -> Self {
        let vain = SEARCHES.saturating_mul(text.len());
        Self { text, at, vain }
    }

    /// The length of what stands here and counts for nothing; none if something else does.
    fn hidden(&mut self) -> Option<usize> {
        let remaining = &self.text[self.at..];
        if self.vain == 0 && !remaining.starts_with(char::is_whitespace) {
            return None;
        }
        let found = hidden(remaining);
        if found.is_none() && has_end(remaining) {
            self.vain = self.vain.saturating_sub(remaining.len());
        }
        found
    }
}

/// Whether a comment or a literal begins here that is searched for its end.
fn has_end(text: &str) -> bool {
    let quoted = text.trim_start_matches(['b', 'c', 'r']);
    let quoted = quoted.trim_start_matches('#');
    text.starts_with("/*") || quoted.starts_with('"') || quoted.starts_with("'\\")
}

impl Iterator for Lexer<'_> {
    type Item = Lexeme;

    fn next(&mut self) -> Option<Lexeme> {
        loop {
            let remaining = &self.text[self.at..];
            let first = remaining.chars().next()?;
            if let Some(length) = self.hidden() {
                self.at += length;
                continue;
            }
            let start = self.at;
            let (kind, length) = match first {
                '(' | '[' | '{' => (Kind::Open, 1),
                ')' | ']' | '}' => (Kind::Close, 1),
                _ if is_of_word(first) => (Kind::Word, word(remaining)),
                _ => (Kind::Mark, first.len_utf8()),
            };
            self.at += length;
            let end = self.at;
            return Some(Lexeme { kind, start, end });
        }
    }
}

/// The length of what stands here and counts for nothing: a space, a comment, or a literal.
fn hidden(text: &str) -> Option<usize> {
    let first = text.chars().next()?;
    if first.is_whitespace() {
        return Some(first.len_utf8());
    }
    match text.as_bytes() {
        [b'/', b'/', ..] => Some(text.find('\n').unwrap_or(text.len())),
        [b'/', b'*', ..] => comment(text),
        [b'"', ..] => string(text),
        [b'b' | b'c', b'"', ..] => string(&text[1..]).map(|length| length + 1),
        [b'r', b'"' | b'#', ..] => raw_string(&text[1..]).map(|length| length + 1),
        [b'b' | b'c', b'r', b'"' | b'#', ..] => raw_string(&text[2..]).map(|length| length + 2),
        [b'\'', ..] => character(text),
        [b'b', b'\'', ..] => character(&text[1..]).map(|length| length + 1),
        _ => None,
    }
}

/// A block comment; none if it has no end.
fn comment(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    let mut at = 0;
    let bytes = text.as_bytes();
    while at + 1 < bytes.len() {
        match &bytes[at..at + 2] {
            b"/*" => {
                depth += 1;
                at += 2;
            }
            b"*/" => {
                depth -= 1;
                at += 2;
                if depth == 0 {
                    return Some(at);
                }
            }
            _ => at += 1,
        }
    }
    None
}

/// A string; none if it has no end.
fn string(text: &str) -> Option<usize> {
    let mut escaped = false;
    for (at, byte) in text.bytes().enumerate().skip(1) {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'"' => return Some(at + 1),
            _ => {}
        }
    }
    None
}

/// A raw string after its `r`; none if this is none, as in `r#type`.
fn raw_string(text: &str) -> Option<usize> {
    let hashes = text.bytes().take_while(|byte| *byte == b'#').count();
    let body = text[hashes..].strip_prefix('"')?;
    let end = format!("\"{}", "#".repeat(hashes));
    Some(hashes + 1 + body.find(&end)? + end.len())
}

/// A character; none if this is a lifetime.
fn character(text: &str) -> Option<usize> {
    let mut letters = text.char_indices().skip(1);
    let (_, first) = letters.next()?;
    if first == '\\' {
        // The escaped letter may be the quote itself.
        letters.next()?;
        let (end, _) = letters
            .take_while(|(_, letter)| *letter != '\n')
            .find(|(_, letter)| *letter == '\'')?;
        return Some(end + 1);
    }
    let (end, second) = letters.next()?;
    (second == '\'').then_some(end + 1)
}

/// Whether a letter can stand in a word.
#[must_use]
pub fn is_of_word(letter: char) -> bool {
    letter == '_' || letter.is_alphanumeric()
}

fn word(text: &str) -> usize {
    let end = text.find(|letter| !is_of_word(letter));
    end.unwrap_or(text.len())
}
