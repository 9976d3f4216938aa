//! A text as words and marks, and what one slip of a hand makes of it.

use super::dice::Dice;
use mech_compiler::syntax::lexer::{Kind, Lexeme, Lexer};
use std::ops::Range;

pub(super) struct Slip {
    pub(super) text: String,
    /// Where the slip stands in that text.
    pub(super) place: Range<usize>,
    /// The names of what was left out.
    pub(super) names: Vec<String>,
}

impl Slip {
    /// The same, where a message may also stand at, or tell, a name of what was left out.
    pub(super) fn told_by(self, names: Vec<String>) -> Self {
        Self { names, ..self }
    }
}

/// A text, and its words, brackets and marks.
pub(super) struct Text<'t> {
    pub(super) text: &'t str,
    pub(super) lexemes: Vec<Lexeme>,
}

/// Words that declare the name after them.
const DECLARING: [&str; 9] =
    ["link", "joint", "point", "line", "const", "param", "port", "part", "use"];

impl<'t> Text<'t> {
    pub(super) fn of(text: &'t str) -> Self {
        let lexemes = Lexer::new(text, 0).collect();
        Self { text, lexemes }
    }

    /// The word or mark with this number; none is empty.
    pub(super) fn word(&self, index: usize) -> &'t str {
        let lexeme = self.lexemes.get(index);
        lexeme.map_or("", |one| &self.text[one.start..one.end])
    }

    /// Whether this word, or a mark of one or more letters, stands there.
    pub(super) fn is(&self, index: usize, what: &str) -> bool {
        let starts = |one: &Lexeme| self.text[one.start..].starts_with(what);
        let is_word = what.starts_with(char::is_alphanumeric);
        self.word(index) == what || !is_word && self.lexemes.get(index).is_some_and(starts)
    }

    pub(super) fn is_name(&self, index: usize) -> bool {
        self.word(index).starts_with(char::is_alphabetic)
    }

    /// Whether a number without a sign begins there.
    pub(super) fn is_number(&self, index: usize) -> bool {
        let is_part = index > 0 && self.is(index - 1, ".");
        self.word(index).starts_with(|one: char| one.is_ascii_digit()) && !is_part
    }

    /// The byte after the number that begins there.
    pub(super) fn end_of_number(&self, index: usize) -> usize {
        let has_point = self.is(index + 1, ".") && !self.is(index + 1, "..");
        self.lexemes[index + if has_point { 2 } else { 0 }].end
    }

    /// One of the words and marks for which this is so.
    pub(super) fn find(&self, dice: &mut Dice, fits: impl Fn(usize) -> bool) -> Option<usize> {
        let all: Vec<usize> = (0..self.lexemes.len()).filter(|&one| fits(one)).collect();
        (!all.is_empty()).then(|| *dice.pick(&all))
    }

    pub(super) fn with(&self, place: Range<usize>, new: &str) -> Slip {
        let (before, after) = (&self.text[..place.start], &self.text[place.end..]);
        Slip {
            text: [before, new, after].concat(),
            place: place.start..place.start + new.len(),
            names: Vec::new(),
        }
    }

    /// The text with something else for so many words and marks.
    pub(super) fn instead(&self, words: Range<usize>, new: &str) -> Slip {
        self.with(self.bytes(words), new)
    }

    /// One of the words or marks `old` for which something is so, written otherwise.
    pub(super) fn exchange(
        &self,
        dice: &mut Dice,
        (olds, news): (&[&str], &[&str]),
        fits: impl Fn(usize) -> bool,
    ) -> Option<Slip> {
        let old_at = |index| olds.iter().find(|old| self.is(index, old));
        let index = self.find(dice, |one| old_at(one).is_some() && fits(one))?;
        let start = self.lexemes[index].start;
        Some(self.with(start..start + old_at(index)?.len(), dice.pick::<&str>(news)))
    }

    pub(super) fn bytes(&self, words: Range<usize>) -> Range<usize> {
        self.lexemes[words.start].start..self.lexemes[words.end - 1].end
    }

    pub(super) fn is_declared(&self, index: usize) -> bool {
        let is_path = self.is(index + 1, "::");
        index > 0 && DECLARING.contains(&self.word(index - 1)) && self.is_name(index) && !is_path
    }

    /// Whether a declared name is used there.
    pub(super) fn is_used(&self, index: usize) -> bool {
        let name = self.word(index);
        let declares = |one| self.word(one) == name && self.is_declared(one);
        self.is_name(index)
            && !self.is_declared(index)
            && !DECLARING.contains(&name)
            && (0..self.lexemes.len()).any(declares)
    }

    /// All statements, those in braces too, as ranges of words.
    pub(super) fn statements(&self) -> Vec<Range<usize>> {
        let (mut open, mut found) = (vec![0], Vec::new());
        for index in 0..self.lexemes.len() {
            match self.word(index) {
                "{" => open.push(index + 1),
                "}" if open.len() > 1 => drop(open.pop()),
                ";" => {}
                _ => continue,
            }
            let is_end = self.is(index, ";") || self.is(index, "}") && !self.is(index + 1, ";");
            if let Some(start) = open.last_mut().filter(|_| is_end) {
                found.push(*start..index + 1);
                *start = index + 1;
            }
        }
        found.retain(|one| !one.is_empty());
        found
    }

    /// One of the statements that begin with one of these words, and for which something is so.
    pub(super) fn statement(
        &self,
        dice: &mut Dice,
        heads: &[&str],
        fits: impl Fn(&Range<usize>) -> bool,
    ) -> Option<Range<usize>> {
        let mut all = self.statements();
        all.retain(|one| heads.contains(&self.word(one.start)) && fits(one));
        (!all.is_empty()).then(|| dice.pick(&all).clone())
    }

    /// Whether one of the statements begins there.
    pub(super) fn is_head(&self, index: usize) -> bool {
        self.is_name(index) && (index == 0 || ["{", "}", ";"].contains(&self.word(index - 1)))
    }

    pub(super) fn partner(&self, index: usize) -> Option<usize> {
        let mut depth = 0_i32;
        let mut step = |one: &usize| {
            depth += match self.lexemes[*one].kind {
                Kind::Open => 1,
                Kind::Close => -1,
                _ => 0,
            };
            depth == 0
        };
        match self.lexemes[index].kind {
            Kind::Open => (index..self.lexemes.len()).find(&mut step),
            _ => (0..=index).rev().find(&mut step),
        }
    }

    pub(super) fn bracket(&self, index: usize) -> Option<usize> {
        let is_open = |one: &usize| self.lexemes[*one].kind == Kind::Open;
        let is_around = |one: &usize| self.partner(*one).is_some_and(|end| end > index);
        (0..index).rev().filter(is_open).find(is_around)
    }

    pub(super) fn names(&self, words: Range<usize>) -> Vec<String> {
        let names = words.filter(|&one| self.is_declared(one) || self.is_used(one));
        names.map(|one| self.word(one).to_owned()).collect()
    }

    /// A word as a hasty hand writes it, which is no other word of the text.
    pub(super) fn misspelt(&self, index: usize, dice: &mut Dice) -> Option<String> {
        let word: Vec<char> = self.word(index).chars().collect();
        if word.len() < 3 {
            return None;
        }
        let at = dice.below(word.len() - 1);
        let mut other = word.clone();
        match dice.below(4) {
            0 => other.swap(at, at + 1),
            1 => drop(other.remove(at + 1)),
            2 => other.insert(at, word[at]),
            _ => other[at + 1] = *dice.pick(&['e', 'r', 'a', 'n', 't']),
        }
        let other: String = other.into_iter().collect();
        let is_known = (0..self.lexemes.len()).any(|one| self.word(one) == other);
        let is_name = other.starts_with(|one: char| one.is_alphabetic());
        (!is_known && is_name).then_some(other)
    }

    /// The text with one of these words misspelt.
    pub(super) fn misspell(&self, dice: &mut Dice, fits: impl Fn(usize) -> bool) -> Option<Slip> {
        let index = self.find(dice, |one| self.word(one).len() > 2 && fits(one))?;
        let other = self.misspelt(index, dice)?;
        Some(self.instead(index..index + 1, &other))
    }
}
