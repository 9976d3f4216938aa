//! The places of a text near a message, and the changes that a slip of a hand asks for there.

use crate::document::{Declaration, Document, Message};
use crate::text::keyword::{KEYWORDS, is_keyword};
use crate::text::{Kind, Lexeme, Lexer, Replacement, closing, is_of_word};
use mech_compiler::syntax::{self, spelling};
use std::collections::BTreeSet;
use std::ops::Range;

/// So many words and marks of a place are looked at.
const FAR: usize = 12;

/// A change that may mend a text.
pub(super) struct Slip {
    pub(super) words: String,
    /// Replacements in the order of their places.
    pub(super) edits: Vec<Replacement>,
}

impl Slip {
    fn new(words: String, range: Range<usize>, text: impl Into<String>) -> Self {
        Self { words, edits: vec![Replacement::new(range, text)] }
    }
}

/// The words and marks of a text, near which slips are looked for.
pub(super) struct Near<'t> {
    text: &'t str,
    tokens: Vec<Lexeme>,
    /// The words of the text, names among them, and those of the language.
    words: BTreeSet<&'t str>,
}

impl<'t> Near<'t> {
    pub(super) fn new(document: &'t Document, declaration: &Declaration) -> Option<Self> {
        let (text, body) = (document.source().text(), declaration.body.as_ref()?);
        let tokens: Vec<Lexeme> = Lexer::new(&text[..body.end], body.start).collect();
        let words = tokens.iter().filter(|token| token.kind == Kind::Word);
        let words = words.map(|token| &text[token.start..token.end]);
        let words = words.filter(|word| !word.starts_with(|first: char| first.is_ascii_digit()));
        Some(Self { words: words.chain(KEYWORDS.split_whitespace()).collect(), text, tokens })
    }

    fn word(&self, token: usize) -> &'t str {
        self.tokens.get(token).map_or("", |token| &self.text[token.start..token.end])
    }

    fn range(&self, tokens: Range<usize>) -> Range<usize> {
        self.tokens[tokens.start].start..self.tokens[tokens.end - 1].end
    }

    /// Whether a token is a name, or a word of the language.
    fn is_word(&self, token: usize) -> bool {
        self.words.contains(self.word(token))
    }

    /// The changes near the place of a message, the likeliest first.
    pub(super) fn slips(&self, Message { place, text }: &Message) -> Vec<Slip> {
        let first = self.tokens.partition_point(|token| token.end <= place.start);
        let end = self.tokens.partition_point(|token| token.start < place.end);
        if first >= self.tokens.len() {
            return Vec::new();
        }
        // Of a message about more than that, the beginning counts.
        let last = (end.max(first + 1) - 1).min(first + FAR);
        let statement = self.statement(first);
        let mut slips = Vec::from_iter(self.offered(place, text));
        let mut named = vec![last];
        named.extend((first != last).then_some(first));
        for token in named.into_iter().filter(|token| self.is_word(*token)) {
            slips.extend(self.misspelt(token));
            slips.extend(self.undeclared(token, &statement));
        }
        let around = first.saturating_sub(2)..(last + 3).min(self.tokens.len());
        let mut around: Vec<usize> = around.collect();
        around.sort_by_key(|token| {
            if *token < first { 2 * (first - token) } else { 2 * (token - first) + 1 }
        });
        slips.extend(self.commas(&around, &statement));
        for &token in &around {
            slips.extend(self.exchanged(token));
        }
        for &token in &around {
            slips.extend(self.missing(token, &["; ", ", ", " = ", ": "]));
            slips.extend(
                (token > 0 && self.word(token - 1) == ",")
                    .then(|| self.without(token - 1..token + 1)),
            );
            slips.push(self.without(token..token + 1));
            slips.extend(self.bracketed(token));
        }
        for &token in &around {
            slips.extend(self.missing(
                token,
                &[
                    " at ", " along ", " near ", " in ", " deg", ")", "(", " ..= ", ".", " = 1",
                    "joint ", "link ", "motor ", "const ", "point ", "allow ", "trace ",
                ],
            ));
        }
        for &token in &around {
            slips.extend(self.keywords(token));
            if self.word(token) == "," && token + 1 < self.tokens.len() {
                slips.push(self.without(token..token + 2));
            }
        }
        slips.extend(self.unquoted(place));
        slips.extend(self.named_coordinates(&statement));
        slips.extend(self.bracketed_place(first));
        slips.extend(self.in_effects(&statement));
        slips.extend(self.other_names(last));
        slips.push(self.without(statement));
        slips
    }

    /// The change that a message offers in its words.
    fn offered(&self, place: &Range<usize>, words: &str) -> Option<Slip> {
        let written = self.text.get(place.clone())?;
        let Some(offer) = syntax::Message::offer(words) else {
            let left_out = syntax::Message::left_out(words)?;
            let is_here = written == left_out;
            return is_here.then(|| Slip::new(format!("remove `{written}`"), place.clone(), ""));
        };
        let words = format!("write `{offer}` for `{written}`");
        Some(Slip::new(words, place.clone(), offer))
    }

    /// A name without its quotes.
    fn unquoted(&self, place: &Range<usize>) -> Option<Slip> {
        let written = self.text.get(place.clone())?;
        let inside = written.strip_prefix('"')?.strip_suffix('"')?;
        let words = format!("write `{inside}` for `{written}`");
        Some(Slip::new(words, place.clone(), inside))
    }

    /// Coordinates without their names: `(x = 1, y = 2)`.
    fn named_coordinates(&self, statement: &Range<usize>) -> Option<Slip> {
        let is_name = |token: &usize| {
            ["x", "y"].contains(&self.word(*token))
                && self.word(token + 1) == "="
                && *token > 0
                && token + 2 < self.tokens.len()
                && ["(", ","].contains(&self.word(token - 1))
        };
        let edits = statement.clone().filter(is_name);
        let edits = edits.map(|token| {
            Replacement::new(self.tokens[token].start..self.tokens[token + 2].start, "")
        });
        let edits: Vec<Replacement> = edits.collect();
        let words = "leave `x =` and `y =` out".to_owned();
        (!edits.is_empty()).then_some(Slip { words, edits })
    }

    /// Brackets around the numbers of a place: `at 1, 2`.
    fn bracketed_place(&self, first: usize) -> Option<Slip> {
        let is_number =
            |token: usize| self.word(token).starts_with(|first: char| first.is_ascii_digit());
        let goes_on =
            |token: &usize| is_number(*token) || [".", ",", "-"].contains(&self.word(*token));
        let end = (first..self.tokens.len()).find(|token| !goes_on(token))?;
        if end < first + 3 {
            return None;
        }
        let range = self.range(first..end);
        let edit = |at: usize, text: &str| Replacement::new(at..at, text);
        Some(Slip {
            words: format!("write `({})`", &self.text[range.clone()]),
            edits: vec![edit(range.start, "("), edit(range.end, ")")],
        })
    }

    /// An effect in the block where effects stand.
    fn in_effects(&self, statement: &Range<usize>) -> Option<Slip> {
        if !self.is_word(statement.start) || statement.is_empty() {
            return None;
        }
        let written = &self.text[self.range(statement.clone())];
        Some(self.replaced(statement.clone(), &format!("effects {{ {written} }}")))
    }

    fn other_names(&self, token: usize) -> Vec<Slip> {
        const DECLARING: [&str; 7] = ["link", "joint", "point", "line", "const", "param", "port"];
        if !self.is_word(token) {
            return Vec::new();
        }
        let declared =
            (1..self.tokens.len()).filter(|token| DECLARING.contains(&self.word(token - 1)));
        let mut names: Vec<&str> =
            declared.map(|token| self.word(token)).chain(["ground"]).collect();
        names.retain(|name| *name != self.word(token));
        names.into_iter().map(|name| self.replaced(token..token + 1, name)).collect()
    }

    fn statement(&self, token: usize) -> Range<usize> {
        let ends = |token: &usize| matches!(self.word(*token), ";" | "{" | "}");
        let start = (0..token).rev().find(ends).map_or(0, |end| end + 1);
        let end = (token..self.tokens.len()).find(ends);
        start..end.map_or(self.tokens.len(), |end| end + 1)
    }

    fn replaced(&self, tokens: Range<usize>, by: &str) -> Slip {
        let range = self.range(tokens);
        let words = format!("write `{by}` for `{}`", &self.text[range.clone()]);
        Slip::new(words, range, by)
    }

    fn without(&self, tokens: Range<usize>) -> Slip {
        let range = self.range(tokens.clone());
        let words = format!(
            "remove `{}`",
            self.text[range.clone()].split_whitespace().collect::<Vec<_>>().join(" ")
        );
        // The spaces before it go with it.
        let before = self.text[..range.start].trim_end_matches(' ').len();
        let start = if self.text[..before].ends_with('\n') { range.start } else { before };
        Slip::new(words, start..range.end, "")
    }

    /// Words that look like this one: here, or where another is declared that nothing else names.
    fn misspelt(&self, token: usize) -> Vec<Slip> {
        let word = self.word(token);
        let follows = token.checked_sub(1).map_or("", |before| self.word(before));
        if follows.starts_with(|first: char| first.is_ascii_digit()) && word != "deg" {
            return vec![self.replaced(token..token + 1, "deg"), self.without(token..token + 1)];
        }
        let others = self.words.iter().copied().filter(|other| *other != word);
        let mut alike = spelling::alike(word, others);
        alike.sort_by_key(|(distance, _)| *distance);
        let alike: Vec<&str> = alike.into_iter().map(|(_, other)| other).collect();
        let single = |name: &str| {
            let mut all = (0..self.tokens.len()).filter(|token| self.word(*token) == name);
            let only = all.next()?;
            all.next().is_none().then_some(only)
        };
        let all = (0..self.tokens.len()).filter(|token| self.word(*token) == word);
        let count = all.count();
        let here = alike.iter().map(|other| self.replaced(token..token + 1, other));
        let there = alike
            .iter()
            .filter_map(|name| single(name))
            .map(|other| self.replaced(other..other + 1, word));
        if count > 1 { there.chain(here).collect() } else { here.chain(there).collect() }
    }

    /// A declaration of a name that has none.
    fn undeclared(&self, token: usize, statement: &Range<usize>) -> Option<Slip> {
        let word = self.word(token);
        let text = format!("link {word};");
        let at = self.tokens[statement.start].start;
        let line = self.text[..at].rfind('\n').map_or(0, |end| end + 1);
        let before = &self.text[line..at];
        let gap = if before.trim().is_empty() { format!("\n{before}") } else { " ".to_owned() };
        let is_name = !is_keyword(word);
        is_name.then(|| Slip::new(format!("add `{text}`"), at..at, format!("{text}{gap}")))
    }

    /// Several names after one word: `link a, b;`.
    fn commas(&self, around: &[usize], statement: &Range<usize>) -> Option<Slip> {
        let keyword = self.word(statement.start);
        let is_comma = |token: &usize| statement.contains(token) && self.word(*token) == ",";
        if !around.iter().any(is_comma) || !self.is_word(statement.start) {
            return None;
        }
        let commas = statement.clone().filter(|token| self.word(*token) == ",");
        let edits = commas
            .map(|token| Replacement::new(self.range(token..token + 1), format!("; {keyword}")));
        Some(Slip { words: format!("write `{keyword}` for each of them"), edits: edits.collect() })
    }

    /// Another mark in the place of one.
    fn exchanged(&self, token: usize) -> Vec<Slip> {
        const MARKS: [&str; 9] = [":", "=", ",", ";", ".", "..=", "->", "*", "//"];
        if self.tokens[token].kind != Kind::Mark {
            return Vec::new();
        }
        // Marks of several letters are several tokens.
        let is_mark =
            |token: usize| self.tokens.get(token).is_some_and(|token| token.kind == Kind::Mark);
        let joined =
            |token: usize| is_mark(token) && self.tokens[token].start == self.tokens[token - 1].end;
        let (mut first, mut end) = (token, token + 1);
        while first > 0 && is_mark(first - 1) && joined(first) {
            first -= 1;
        }
        while joined(end) {
            end += 1;
        }
        let written = &self.text[self.range(first..end)];
        let others = MARKS.into_iter().filter(|mark| *mark != written);
        others.map(|mark| self.replaced(first..end, mark)).collect()
    }

    /// Brackets of another kind, or a point for those of an index.
    fn bracketed(&self, token: usize) -> Vec<Slip> {
        const BRACKETS: [[&str; 2]; 4] = [["(", ")"], ["{", "}"], ["[", "]"], [".", ""]];
        if self.tokens[token].kind != Kind::Open {
            return Vec::new();
        }
        let Some(closing) = closing(&self.tokens, token) else {
            return Vec::new();
        };
        let others = BRACKETS.into_iter().filter(|[open, _]| *open != self.word(token));
        let slip = |[open, close]: [&str; 2]| {
            let edit =
                |token: usize, text: &str| Replacement::new(self.range(token..token + 1), text);
            let inside = &self.text[self.tokens[token].end..self.tokens[closing].start];
            Slip {
                words: format!(
                    "write `{open}{inside}{close}` for `{}`",
                    &self.text[self.range(token..closing + 1)]
                ),
                edits: vec![edit(token, open), edit(closing, close)],
            }
        };
        others.map(slip).collect()
    }

    /// What may be missing before a token.
    fn missing(&self, token: usize, all: &[&str]) -> Vec<Slip> {
        let before =
            token.checked_sub(1).map_or(self.tokens[token].start, |before| self.tokens[before].end);
        let slip = |text: &&str| {
            // A mark or a unit stands at what is before, a word before what follows.
            let stays = text.trim_start().len() < text.len()
                || text.trim_end().len() == text.len()
                || text.starts_with([';', ',', ':']);
            let (at, text) = if stays && text.trim() != "(" {
                (before, text.trim_end().to_owned())
            } else {
                (self.tokens[token].start, (*text).to_owned())
            };
            let gap = if self.text[at..].starts_with(is_of_word)
                && text.ends_with(|last: char| last.is_alphanumeric())
            {
                " "
            } else {
                ""
            };
            let words = format!("write `{}` before `{}`", text.trim(), self.word(token));
            Slip::new(words, at..at, text + gap)
        };
        all.iter().map(slip).collect()
    }

    /// Words of the language in the place of a word.
    fn keywords(&self, token: usize) -> Vec<Slip> {
        const WORDS: [&str; 12] = [
            "at",
            "along",
            "near",
            "in",
            "revolute",
            "prismatic",
            "slot",
            "link",
            "joint",
            "motor",
            "const",
            "point",
        ];
        if self.tokens[token].kind != Kind::Word {
            return Vec::new();
        }
        let words = WORDS.into_iter().filter(|word| *word != self.word(token));
        words.map(|word| self.replaced(token..token + 1, word)).collect()
    }
}
