//! The words of a line, taken one after the other.

use eframe::egui::Key;
use mech_studio::editor::Item;
use std::str::FromStr;
use std::vec::IntoIter;

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Word {
    Name(String),
    Quoted(String),
    Place([f64; 2]),
}

/// The words that are still to be taken, and the block below them.
#[derive(Clone)]
pub(super) struct Words<'b> {
    left: IntoIter<Word>,
    pub(super) block: Option<&'b str>,
}

impl<'b> Words<'b> {
    pub(super) fn of(line: &str, block: Option<&'b str>) -> Result<Self, String> {
        let (mut words, mut rest) = (Vec::new(), line.trim());
        while let Some(first) = rest.chars().next() {
            let (word, after) = match first {
                '"' => quoted(rest)?,
                '(' => place(rest)?,
                _ => {
                    let (word, after) = rest.split_once(' ').unwrap_or((rest, ""));
                    (Word::Name(word.to_owned()), after)
                }
            };
            words.push(word);
            rest = after.trim_start();
        }
        let left = words.into_iter();
        Ok(Self { left, block })
    }

    pub(super) fn is_at_end(&self) -> bool {
        self.left.as_slice().is_empty()
    }

    /// Nothing is left.
    pub(super) fn end(&self) -> Result<(), String> {
        let left = self.left.as_slice();
        let is_at_end = left.is_empty().then_some(());
        is_at_end.ok_or_else(|| format!("too much: {left:?}"))
    }

    pub(super) fn word(&mut self) -> Result<Word, String> {
        self.left.next().ok_or_else(|| "a word is missing".to_owned())
    }

    /// A word in quotes or without.
    pub(super) fn text(&mut self) -> Result<String, String> {
        match self.word()? {
            Word::Name(text) | Word::Quoted(text) => Ok(text),
            other @ Word::Place(_) => Err(format!("{other:?} is no word")),
        }
    }

    pub(super) fn place(&mut self) -> Result<[f64; 2], String> {
        match self.word()? {
            Word::Place(place) => Ok(place),
            other => Err(format!("{other:?} is no place")),
        }
    }

    pub(super) fn number<T: FromStr>(&mut self) -> Result<T, String> {
        let text = self.text()?;
        text.parse().map_err(|_| format!("{text} is no number"))
    }

    /// All that is left, at least one.
    pub(super) fn all<T>(
        &mut self,
        one: impl Fn(&mut Self) -> Result<T, String>,
    ) -> Result<Vec<T>, String> {
        let mut all = vec![one(self)?];
        while !self.is_at_end() {
            all.push(one(self)?);
        }
        Ok(all)
    }

    pub(super) fn key(&mut self) -> Result<Key, String> {
        let name = self.text()?;
        Key::from_name(&name).ok_or_else(|| format!("{name} is no key"))
    }

    /// Takes this word if it is the next one. Returns whether it is.
    pub(super) fn takes(&mut self, name: &str) -> bool {
        let takes = self.left.as_slice().first() == Some(&Word::Name(name.to_owned()));
        if takes {
            self.left.next();
        }
        takes
    }

    pub(super) fn item(&mut self) -> Result<Item, String> {
        let (kind, name) = (self.text()?, self.text()?);
        match &*kind {
            "link" => Ok(Item::Link(name)),
            "joint" => Ok(Item::Joint(name)),
            "point" => Ok(Item::Axis(name)),
            "action" => Ok(Item::Action(name)),
            _ => Err(format!("{kind} is no kind of item")),
        }
    }
}

/// Reads a word in quotes at the beginning: `\n` is a new line, `\"` a quote.
fn quoted(line: &str) -> Result<(Word, &str), String> {
    let mut text = String::new();
    let mut letters = line.char_indices().skip(1);
    while let Some((at, letter)) = letters.next() {
        match letter {
            '"' => return Ok((Word::Quoted(text), &line[at + 1..])),
            '\\' => match letters.next() {
                Some((_, 'n')) => text.push('\n'),
                Some((_, '"')) => text.push('"'),
                _ => return Err(format!("an unknown `\\` in {line}")),
            },
            _ => text.push(letter),
        }
    }
    Err(format!("a quote is missing in {line}"))
}

/// A place at the beginning, as in `(1, 2)`.
fn place(line: &str) -> Result<(Word, &str), String> {
    let read = || {
        let (inside, after) = line[1..].split_once(')')?;
        let (x, y) = inside.split_once(',')?;
        let place = [x.trim().parse().ok()?, y.trim().parse().ok()?];
        Some((Word::Place(place), after))
    };
    read().ok_or_else(|| format!("{line} is no place"))
}
