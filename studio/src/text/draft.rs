//! A text that is being changed.

use serde::Serialize;
use std::ops::Range;

/// A replacement of a stretch of a text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "transfer", derive(serde::Deserialize))]
pub struct Replacement {
    /// The range that is replaced, in bytes.
    pub range: Range<usize>,
    /// By what.
    pub text: String,
}

impl Replacement {
    pub(crate) fn new(range: Range<usize>, text: impl Into<String>) -> Self {
        let text = text.into();
        Self { range, text }
    }
}

/// A text that is being changed: stretches of it are replaced. Everything else stays, byte for byte.
#[derive(Clone, Debug)]
pub(super) struct Draft<'t> {
    text: &'t str,
    /// In any order, and none within another.
    changes: Vec<Replacement>,
}

impl<'t> Draft<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        let changes = Vec::new();
        Self { text, changes }
    }

    /// Replaces a stretch. What overlaps with one that was replaced already stays as that has it.
    pub(super) fn replace(&mut self, range: Range<usize>, by: impl Into<String>) {
        if !self.is_changed(&range) {
            let text = by.into();
            self.changes.push(Replacement { range, text });
        }
    }

    /// Whether a part of a stretch was replaced or taken out.
    fn is_changed(&self, range: &Range<usize>) -> bool {
        let mut changes = self.changes.iter();
        changes.any(|known| overlap(&known.range, range))
    }

    /// Takes a stretch out. Two that overlap are one.
    fn take_out(&mut self, mut range: Range<usize>) {
        let alone = range.clone();
        self.changes.retain(|Replacement { range: known, text }| {
            let is_joined = text.is_empty() && overlap(known, &range);
            if is_joined {
                range = known.start.min(range.start)..known.end.max(range.end);
            }
            !is_joined
        });
        if range != alone {
            range = self.with_spaces(range);
        }
        self.replace(range, "");
    }

    /// A stretch with the spaces that would be left over at the beginning of its line, and with the line if nothing else is in it.
    fn with_spaces(&self, range: Range<usize>) -> Range<usize> {
        let start = self.line_of(range.start).start;
        if !self.text[start..range.start].trim().is_empty() {
            return range;
        }
        let after = &self.text[range.end..];
        let spaces = after.len() - after.trim_start_matches([' ', '\t']).len();
        if after[spaces..].starts_with('\n') {
            return start..range.end + spaces + 1;
        }
        range.start..range.end + spaces
    }

    pub(super) fn insert(&mut self, at: usize, text: impl Into<String>) {
        let text = text.into();
        self.changes.push(Replacement::new(at..at, text));
    }

    /// Adds a statement after another, in a line of its own where that has one.
    pub(super) fn insert_after(&mut self, sibling: &Range<usize>, statement: &str) {
        let line = self.line_of(sibling.start);
        let before = &self.text[line.start..sibling.start];
        let end = self.line_of(sibling.end).end;
        let after = self.text[sibling.end..end].trim();
        if before.trim().is_empty() && (after.is_empty() || after.starts_with("//")) {
            self.insert(end, format!("\n{before}{statement}"));
        } else {
            self.insert(sibling.end, format!(" {statement}"));
        }
    }

    /// Takes a statement out, with its lines where it fills them, and with the comment that is its own.
    pub(super) fn remove(&mut self, statement: &Range<usize>) {
        let first = self.line_of(statement.start);
        let last = self.line_of(statement.end);
        let before = &self.text[first.start..statement.start];
        let after = &self.text[statement.end..last.end];
        let is_alone = after.trim().is_empty() || after.trim_start().starts_with("//");
        if before.trim().is_empty() && is_alone {
            let start = self.start_of_comment(first.start, last.end);
            let end = (last.end + 1).min(self.text.len());
            return self.take_out(start..end);
        }
        // The space before it goes with it; at the beginning of a line that after it.
        let spaces = |text: &str| text.len() - text.trim_start_matches([' ', '\t']).len();
        let range = if before.trim().is_empty() {
            statement.start..statement.end + spaces(after)
        } else {
            let kept = before.trim_end_matches([' ', '\t']);
            first.start + kept.len()..statement.end
        };
        self.take_out(range);
    }

    /// The changes, in the order of their places.
    pub(super) fn edits(mut self) -> Vec<Replacement> {
        // Stable: what is inserted at one place stays in order.
        self.changes.sort_by_key(|edit| (edit.range.start, edit.range.end));
        self.changes
    }

    /// The line in which a byte stands, without its end.
    fn line_of(&self, byte: usize) -> Range<usize> {
        let start = self.text[..byte].rfind('\n').map_or(0, |at| at + 1);
        let end = self.text[byte..].find('\n').map_or(self.text.len(), |at| byte + at);
        start..end
    }

    /// Where the comment begins that belongs to a statement alone: lines of comment directly above it, if no other statement follows
    /// directly below. Else it may be about all of them.
    fn start_of_comment(&self, first: usize, last: usize) -> usize {
        let below = self.text[last..].lines().nth(1).unwrap_or("").trim();
        if !(below.is_empty() || below == "}" || below.starts_with("//")) {
            return first;
        }
        let mut start = first;
        while start > 0 {
            let line = self.line_of(start - 1);
            if !self.text[line.clone()].trim_start().starts_with("//") {
                break;
            }
            start = line.start;
        }
        start
    }
}

/// A text after changes that stand in the order of their places.
pub(crate) fn written(text: &str, edits: &[Replacement]) -> String {
    let mut changed = String::with_capacity(text.len() + 64);
    let mut at = 0;
    for Replacement { range, text: by } in edits {
        changed += &text[at.min(range.start)..range.start];
        changed += by;
        at = range.end.max(at);
    }
    changed + &text[at..]
}

/// Whether two stretches have bytes in common.
fn overlap(a: &Range<usize>, b: &Range<usize>) -> bool {
    a.start < b.end && b.start < a.end && !a.is_empty()
}

#[cfg(test)]
mod tests {
    use super::{Draft, written};

    fn changed(text: &str, change: impl FnOnce(&mut Draft<'_>)) -> String {
        let mut draft = Draft::new(text);
        change(&mut draft);
        written(text, &draft.edits())
    }

    fn without(text: &str, what: &str) -> String {
        let start = text.find(what).expect("it is there");
        changed(text, |draft| draft.remove(&(start..start + what.len())))
    }

    #[test]
    fn a_statement_takes_its_line_and_its_comment_with_it() {
        assert_eq!(without("a;\n  b; // why\nc;\n", "b;"), "a;\nc;\n");
        assert_eq!(without("a; b; c;", "b;"), "a; c;");
        assert_eq!(without("a; b;\nc;", "a;"), "b;\nc;");
        assert_eq!(without("a;\n\n// of b\nb;\n\nc;", "b;"), "a;\n\n\nc;");
        // A comment on several statements stays.
        assert_eq!(without("// of both\nb;\nc;", "b;"), "// of both\nc;");
    }

    #[test]
    fn statements_on_one_line_go_one_by_one() {
        let all = |text: &str, gone: &[&str]| {
            changed(text, |draft| {
                for what in gone {
                    let start = text.find(what).expect("it is there");
                    draft.remove(&(start..start + what.len()));
                }
            })
        };
        assert_eq!(all("a; b; c;\nd;", &["a;", "b;"]), "c;\nd;");
        assert_eq!(all("a; b; c;", &["b;", "a;"]), "c;");
        assert_eq!(all("  a; b;\nc;", &["b;", "a;"]), "c;");
        assert_eq!(all("a;\nb;\nc;", &["b;", "c;"]), "a;\n");
    }

    #[test]
    fn a_statement_is_added_as_its_sibling_stands() {
        let after = |text: &str| {
            let start = text.find("a;").expect("it is there");
            changed(text, |draft| draft.insert_after(&(start..start + 2), "b;"))
        };
        assert_eq!(after("  a; // why\n  c;"), "  a; // why\n  b;\n  c;");
        assert_eq!(after("  a;"), "  a;\n  b;");
        assert_eq!(after("{ a; c; }"), "{ a; b; c; }");
        assert_eq!(after("  a; c;"), "  a; b; c;");
    }
}
