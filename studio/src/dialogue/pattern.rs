//! The patterns of lines: `point <path:new> at <at:place>`.
//!
//! A pattern consists of words, of slots `<name:what>`, and of what may be left out, in square brackets.

use super::words::Word;
use std::collections::BTreeMap;

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Element {
    Word(&'static str),
    /// A slot, which the user fills in.
    Slot {
        /// The name under which it is found again.
        name: &'static str,
        /// The kind of words that fit it.
        what: What,
    },
    /// An optional part; it begins with a word.
    Optional(Vec<Element>),
}

/// The kind of words that fit a slot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum What {
    /// A new name or path.
    New,
    Link,
    Joint,
    /// A point, a line, or a link.
    End,
    Any,
    /// A number; it goes on to the next word of the pattern.
    Value,
    /// A number that counts.
    Number,
    /// `(x, y)`
    Place,
    One(Vec<&'static str>),
    /// Everything up to the next word of the pattern, or to the end.
    Rest,
}

/// The words that a user filled in, by the names of the slots.
pub(super) type Found = BTreeMap<&'static str, String>;

/// A line that does not fit a pattern.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Misfit {
    /// At which of its words.
    pub(super) at: usize,
    /// The elements that would fit there.
    pub(super) wants: Vec<Element>,
}

pub(super) fn read(pattern: &'static str) -> Vec<Element> {
    let mut rows = vec![Vec::new()];
    for piece in pattern.split_whitespace() {
        let inner = piece.trim_start_matches('[');
        rows.extend((inner.len()..piece.len()).map(|_| Vec::new()));
        let bare = if inner.starts_with('<') {
            inner.trim_end_matches(']')
        } else {
            inner.strip_suffix(']').unwrap_or(inner)
        };
        let element = match bare.strip_prefix('<').and_then(|slot| slot.strip_suffix('>')) {
            Some(slot) => {
                let (name, what) = slot.split_once(':').unwrap_or((slot, slot));
                let what = what_of(what);
                Element::Slot { name, what }
            }
            None => Element::Word(bare),
        };
        if let Some(row) = rows.last_mut() {
            row.push(element);
        }
        for _ in bare.len()..inner.len() {
            if let Some(done) = rows.pop()
                && let Some(row) = rows.last_mut()
            {
                row.push(Element::Optional(done));
            }
        }
    }
    rows.swap_remove(0)
}

fn what_of(word: &'static str) -> What {
    match word {
        "new" => What::New,
        "link" => What::Link,
        "joint" => What::Joint,
        "end" => What::End,
        "any" => What::Any,
        "value" => What::Value,
        "number" => What::Number,
        "place" => What::Place,
        "rest" => What::Rest,
        choices => What::One(choices.split('|').collect()),
    }
}

/// A pattern as the user reads it: `point PATH at (x, y)`.
pub(super) fn shown(elements: &[Element]) -> String {
    let shown = elements.iter().map(|element| match element {
        Element::Word(word) => (*word).to_owned(),
        Element::Slot { name, what } => match what {
            What::Place => "(x, y)".to_owned(),
            What::One(words) => words.join("|"),
            What::Rest => format!("{}...", name.to_uppercase()),
            _ => name.to_uppercase(),
        },
        Element::Optional(inner) => format!("[{}]", shown(inner)),
    });
    shown.collect::<Vec<_>>().join(" ")
}

pub(super) fn fit(elements: &[Element], line: &str, words: &[Word]) -> Result<Found, Misfit> {
    let mut fitting = Fitting { line, words, at: 0, found: Found::new(), skipped: Vec::new() };
    fitting.all(elements, &[])?;
    if fitting.at < words.len() {
        return Err(fitting.misfit(&[]));
    }
    Ok(fitting.found)
}

struct Fitting<'l> {
    line: &'l str,
    words: &'l [Word],
    at: usize,
    found: Found,
    /// The optional elements that were left out before the present word.
    skipped: Vec<Element>,
}

impl Fitting<'_> {
    fn word(&self, at: usize) -> Option<&str> {
        self.words.get(at).map(|word| word.of(self.line))
    }

    fn misfit(&self, wants: &[Element]) -> Misfit {
        let skipped = self.skipped.iter().chain(wants);
        Misfit { at: self.at, wants: skipped.cloned().collect() }
    }

    fn all(&mut self, elements: &[Element], after: &[Element]) -> Result<(), Misfit> {
        for (index, element) in elements.iter().enumerate() {
            let mut following = elements[index + 1..].to_vec();
            following.extend_from_slice(after);
            match element {
                Element::Word(word) => {
                    if self.word(self.at) != Some(word) {
                        return Err(self.misfit(std::slice::from_ref(element)));
                    }
                    self.take(1);
                }
                Element::Slot { name, what } => self.slot(element, (name, what), &following)?,
                Element::Optional(inner) => {
                    let first = inner.first();
                    let comes = match first {
                        Some(Element::Word(word)) => self.word(self.at) == Some(word),
                        _ => self.at < self.words.len(),
                    };
                    if comes {
                        self.all(inner, &following)?;
                    } else {
                        self.skipped.extend(first.cloned());
                    }
                }
            }
        }
        Ok(())
    }

    fn take(&mut self, count: usize) {
        self.at += count;
        self.skipped.clear();
    }

    fn slot(
        &mut self,
        element: &Element,
        (name, what): (&'static str, &What),
        following: &[Element],
    ) -> Result<(), Misfit> {
        let length = match what {
            What::Value | What::Rest => self.length_to(following, *what == What::Value),
            _ => usize::from(self.word(self.at).is_some_and(|word| is_a(word, what))),
        };
        let last = (self.at + length).checked_sub(1);
        let ends = self.words.get(self.at).zip(last.and_then(|last| self.words.get(last)));
        let Some((first, last)) = ends.filter(|_| length > 0) else {
            return Err(self.misfit(std::slice::from_ref(element)));
        };
        let text = self.line[first.range.start..last.range.end].to_owned();
        self.found.insert(name, text);
        self.take(length);
        Ok(())
    }

    /// Counts the words of a slot: up to a word that may follow it.
    fn length_to(&self, following: &[Element], is_value: bool) -> usize {
        let mut stops = Vec::new();
        for element in following {
            match element {
                Element::Word(word) => {
                    stops.push(*word);
                    break;
                }
                Element::Optional(inner) => {
                    stops.extend(inner.iter().filter_map(|one| match one {
                        Element::Word(word) => Some(*word),
                        _ => None,
                    }));
                }
                Element::Slot { .. } => break,
            }
        }
        let remaining = &self.words[self.at.min(self.words.len())..];
        let is_stop = |word: &Word| stops.contains(&word.of(self.line));
        let end = remaining.iter().position(is_stop);
        // A number that a slot follows is one word.
        let next_is_slot = matches!(following.first(), Some(Element::Slot { .. }));
        if is_value && next_is_slot {
            return remaining.len().min(1);
        }
        end.unwrap_or(remaining.len())
    }
}

/// Whether a word can stand in a slot.
fn is_a(word: &str, what: &What) -> bool {
    let is_name = word.starts_with(|letter: char| letter == '_' || letter.is_alphabetic());
    match what {
        What::Place => word.starts_with('('),
        What::Number => word.chars().all(|digit| digit.is_ascii_digit()),
        What::One(words) => words.contains(&word),
        _ => is_name,
    }
}

#[cfg(test)]
mod tests {
    use super::super::words::words;
    use super::*;

    fn fitted(pattern: &'static str, line: &str) -> Result<Vec<(String, String)>, usize> {
        let found = fit(&read(pattern), line, &words(line).expect("brackets match"));
        let found = found.map_err(|misfit| misfit.at)?;
        Ok(found.into_iter().map(|(name, text)| (name.to_owned(), text)).collect())
    }

    #[test]
    fn what_may_be_left_out_is_left_out() {
        const MOTOR: &str =
            "motor <joint> [= <law:value>] [in <low:value> ..= <high:value>] [by <step:value>]";
        let pair = |name: &str, text: &str| (name.to_owned(), text.to_owned());
        assert_eq!(fitted(MOTOR, "motor a"), Ok(vec![pair("joint", "a")]));
        assert_eq!(
            fitted(MOTOR, "motor a = 2 * t in 0 ..= 30 deg by 1 deg"),
            Ok(vec![
                pair("high", "30 deg"),
                pair("joint", "a"),
                pair("law", "2 * t"),
                pair("low", "0"),
                pair("step", "1 deg"),
            ])
        );
        assert_eq!(fitted(MOTOR, "motor"), Err(1));
        assert_eq!(fitted(MOTOR, "motor a b"), Err(2));
        assert_eq!(fitted(MOTOR, "motor a in 3"), Err(4));
    }

    #[test]
    fn patterns_are_shown_as_users_write() {
        let pattern = read("join <name:new> = <kind:revolute|weld> <a:end> [at <at:place>]");
        assert_eq!(shown(&pattern), "join NAME = revolute|weld A [at (x, y)]");
    }
}
