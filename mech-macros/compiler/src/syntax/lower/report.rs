//! Messages, put into the order of the text.

use crate::syntax::ast::Read;
use crate::syntax::{Message, Place, spelling};
use proc_macro2::Ident;
use std::collections::HashSet;

/// Where a statement stands: its number among those of the mechanism, and among those of the part in it, if it is in a part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct StatementPlace {
    pub(super) outer: usize,
    pub(super) inner: Option<usize>,
}

impl StatementPlace {
    /// The statement of this number that stands in no part.
    pub(super) fn of_mechanism(outer: usize) -> Self {
        Self { outer, inner: None }
    }
}

/// A statement, and the number of the item in it.
type Position = (StatementPlace, usize);

/// A message as it came.
struct Entry {
    position: Position,
    /// The instance of a part about which it is: `left[2]`.
    instance: Option<String>,
    message: Message,
}

/// The messages so far. Several passes read the text, so messages are sorted before they are shown.
#[derive(Default)]
pub(super) struct Report {
    position: Position,
    instance: Option<String>,
    entries: Vec<Entry>,
    /// What was said of unknown names, and in which instances.
    unknown: HashSet<(Option<String>, String)>,
}

impl Report {
    /// From now on, messages are about this statement, in this instance of a part.
    pub(super) fn enter(&mut self, statement: StatementPlace, instance: Option<String>) {
        self.position = (statement, 0);
        self.instance = instance;
    }

    /// From now on, messages are about the next item of the statement.
    pub(super) fn next_item(&mut self) {
        self.position.1 += 1;
    }

    /// The number of the statement that messages are about, among those of the mechanism or of the part.
    pub(super) fn statement(&self) -> usize {
        let StatementPlace { outer, inner } = self.position.0;
        inner.unwrap_or(outer)
    }

    /// Returns the number of messages.
    pub(super) fn len(&self) -> usize {
        self.entries.len()
    }

    /// Tells something about a place.
    pub(super) fn error(&mut self, place: Place, text: impl Into<String>) {
        self.pass_on(Message::new(place, text));
    }

    /// Tells why there is nothing of what is read.
    pub(super) fn refuse<T>(&mut self, place: Place, text: impl Into<String>) -> Option<T> {
        self.error(place, text);
        None
    }

    /// The same of a name that is unknown, wherever it stands: it is told once.
    pub(super) fn refuse_unknown<T>(&mut self, place: Place, text: String) -> Option<T> {
        if self.unknown.insert((self.instance.clone(), text.clone())) {
            self.error(place, text);
        }
        None
    }

    /// A number, unless it is too large; told if so.
    pub(super) fn finite(&mut self, value: f64, place: Place) -> Option<f64> {
        if value.is_finite() {
            return Some(value);
        }
        self.refuse(
            place,
            "this number is too large; the largest is about 1.8e308",
        )
    }

    /// Tells that a word is none of those that are known.
    pub(super) fn unknown(&mut self, word: &Ident, what: &str, known: &[&str]) {
        let remedy = spelling::remedy(&word.to_string(), known);
        let text = format!("unknown {what} `{word}`{remedy}");
        self.error(Place::at(word.span()), text);
    }

    /// Passes on a message of the grammar's.
    pub(super) fn pass_on(&mut self, mut message: Message) {
        // In a part its own names are written without the path of the instance.
        if let Some(instance) = &self.instance {
            message.text = message.text.replace(&format!("`{instance}."), "`");
        }
        self.entries.push(Entry {
            position: self.position,
            instance: self.instance.clone(),
            message,
        });
    }

    /// Returns the value that was read; reports the error if there is none.
    pub(super) fn read<'t, T>(&mut self, read: &'t Read<T>) -> Option<&'t T> {
        read.as_ref()
            .map_err(|error| self.pass_on(error.clone()))
            .ok()
    }

    /// Whether nothing is wrong so far.
    pub(super) fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Whether this was said of the item that messages are about.
    pub(super) fn has(&self, text: &str) -> bool {
        let mut entries = self.entries.iter();
        entries.any(|entry| entry.position == self.position && entry.message.text == text)
    }

    /// All messages in the order of the text; what is wrong with several instances of a part once.
    pub(super) fn finish(mut self) -> Vec<Message> {
        self.entries.sort_by_key(|entry| entry.position);
        let mut messages: Vec<(Entry, Vec<String>)> = Vec::new();
        for mut entry in self.entries {
            let Some(instance) = entry.instance.take() else {
                messages.push((entry, Vec::new()));
                continue;
            };
            // Of one instance the same may be said twice, about two places.
            let same = messages.iter_mut().find(|(earlier, instances)| {
                let said = earlier.position == entry.position
                    && earlier.message.text == entry.message.text;
                said && !instances.is_empty() && !instances.contains(&instance)
            });
            match same {
                Some((_, instances)) => instances.push(instance),
                None => messages.push((entry, vec![instance])),
            }
        }
        let named = messages.into_iter().map(|(mut entry, instances)| {
            if !instances.is_empty() {
                let instances: Vec<&str> = instances.iter().map(String::as_str).collect();
                entry.message.text += &format!("\n\nnote: in {}", spelling::list(&instances));
            }
            entry.message
        });
        named.collect()
    }
}
