//! Finds the calls of macros in a Rust file, without reading the rest: it may be wrong in any way.

use crate::text::{Kind, Lexeme, Lexer};
use mech_compiler::syntax::STATEMENTS;
use std::ops::Range;

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Call<'t> {
    /// The name of the macro, without its path.
    pub(super) name: &'t str,
    /// From the first word of its path to its closing bracket.
    pub(super) whole: Range<usize>,
    /// Between its brackets; nothing if these are not closed.
    pub(super) body: Option<Range<usize>>,
}

/// The calls of these macros, in order. Calls in comments, in strings and in `macro_rules!` are none. After one without an end there
/// is nothing: all that follows is in it.
pub(super) fn calls<'t>(text: &'t str, names: &[&str]) -> Vec<Call<'t>> {
    let lexemes: Vec<Lexeme> = Lexer::new(text, 0).collect();
    let closings = closings(text, &lexemes);
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(name) = lexemes.get(at) {
        let Some(open) = call_at(text, &lexemes, at) else {
            at += 1;
            continue;
        };
        let (word, close) = (&text[name.start..name.end], closings[open]);
        if names.contains(&word) {
            let end = close.map_or(text.len(), |close| lexemes[close].end);
            found.push(Call {
                name: word,
                whole: start_of_path(text, &lexemes, at)..end,
                body: close.map(|close| lexemes[open].end..lexemes[close].start),
            });
            let Some(close) = close else {
                break;
            };
            at = close;
        }
        at = match close {
            Some(close) if word == "macro_rules" => close,
            _ => at + 1,
        };
    }
    found
}

/// What a call has in its brackets as it is indented: up to a `}` that is indented no further than its first line, or up to the end.
pub(super) fn indented_body(text: &str, call: usize) -> Option<Range<usize>> {
    let mut lexemes = Lexer::new(text, call);
    let start = lexemes.find(|lexeme| lexeme.kind == Kind::Open)?.end;
    let most = indent(text, call);
    let mut end = start;
    for line in text[start..].split_inclusive('\n') {
        if end > start && line.trim_start().starts_with('}') && indent(text, end) <= most {
            break;
        }
        end += line.len();
    }
    Some(start..end)
}

/// Whether a call of ours seems to end elsewhere than at its closing bracket: that is indented less, or a statement follows, which is no
/// Rust, or a brace that stands where one would close the call.
pub(super) fn has_doubtful_end(text: &str, call: usize, close: usize) -> bool {
    let mut lexemes = Lexer::new(text, close).skip(1);
    let [call, close] = [call, close].map(|byte| indent(text, byte));
    close < call
        || lexemes.next().is_some_and(|next| match &text[next.start..next.end] {
            "}" => close > call && indent(text, next.start) == call,
            "const" | "use" => false,
            word => {
                let after = lexemes.next();
                STATEMENTS.contains(&word) && after.is_some_and(|after| after.kind == Kind::Word)
            }
        })
}

/// How far the line is indented in which a byte stands.
fn indent(text: &str, byte: usize) -> usize {
    let line = text[..byte].rfind('\n').map_or(0, |at| at + 1);
    text[line..].len() - text[line..].trim_start_matches([' ', '\t']).len()
}

/// The word after the first of these words that stands in no brackets: `Name` in `struct Name;`.
pub(super) fn word_after<'t>(text: &'t str, first: &str) -> Option<&'t str> {
    let mut depth = 0_usize;
    let mut lexemes = Lexer::new(text, 0);
    while let Some(lexeme) = lexemes.next() {
        match lexeme.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            Kind::Word if depth == 0 && &text[lexeme.start..lexeme.end] == first => {
                let next = lexemes.next().filter(|next| next.kind == Kind::Word)?;
                return Some(&text[next.start..next.end]);
            }
            Kind::Word | Kind::Mark => {}
        }
    }
    None
}

/// The opening bracket of the call whose name stands here; none if none does.
fn call_at(text: &str, lexemes: &[Lexeme], at: usize) -> Option<usize> {
    let is_mark = |index: usize, mark: &str| {
        let lexeme = lexemes.get(index);
        lexeme.is_some_and(|lexeme| &text[lexeme.start..lexeme.end] == mark)
    };
    let is = |index: usize, kind| {
        let lexeme = lexemes.get(index);
        lexeme.is_some_and(|lexeme| lexeme.kind == kind)
    };
    if !is(at, Kind::Word) || !is_mark(at + 1, "!") {
        return None;
    }
    // `macro_rules! name {`
    let named = usize::from(is(at + 2, Kind::Word));
    is(at + 2 + named, Kind::Open).then_some(at + 2 + named)
}

/// For each lexeme the bracket that closes it, if it is closed. A bracket that closes none of its kind counts for nothing; one that
/// passes over others leaves these open.
fn closings(text: &str, lexemes: &[Lexeme]) -> Vec<Option<usize>> {
    const KINDS: [(&str, &str); 3] = [("(", ")"), ("[", "]"), ("{", "}")];
    let mut closings = vec![None; lexemes.len()];
    let mut waiting: Vec<(usize, usize)> = Vec::new();
    let mut counts = [0_usize; 3];
    for (index, lexeme) in lexemes.iter().enumerate() {
        let bracket = &text[lexeme.start..lexeme.end];
        let kind = KINDS.iter().position(|(open, close)| bracket == *open || bracket == *close);
        match (lexeme.kind, kind) {
            (Kind::Open, Some(kind)) => {
                waiting.push((kind, index));
                counts[kind] += 1;
            }
            (Kind::Close, Some(kind)) if counts[kind] > 0 => {
                while let Some((other, open)) = waiting.pop() {
                    counts[other] -= 1;
                    if other == kind {
                        closings[open] = Some(index);
                        break;
                    }
                }
            }
            _ => {}
        }
    }
    closings
}

/// Where the path begins whose last word stands here.
fn start_of_path(text: &str, lexemes: &[Lexeme], last: usize) -> usize {
    let is = |index: usize, mark: &str| {
        let lexeme = lexemes.get(index);
        lexeme.is_some_and(|lexeme| &text[lexeme.start..lexeme.end] == mark)
    };
    let mut first = last;
    while first >= 3
        && is(first - 1, ":")
        && is(first - 2, ":")
        && lexemes[first - 3].kind == Kind::Word
    {
        first -= 3;
    }
    lexemes[first].start
}

#[cfg(test)]
mod tests;
