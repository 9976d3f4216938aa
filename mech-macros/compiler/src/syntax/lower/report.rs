//! Messages, put into the order of the text.

use super::unknown::Unknown;
use crate::syntax::ast::{Read, Text};
use crate::syntax::{Listing, Message, Place, spelling};
use proc_macro2::{Ident, TokenStream};
use std::collections::HashMap;

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
    /// The instances of a part about which it is: `left[2]`.
    instances: Vec<String>,
    /// The name that is unknown, if that is the message.
    unknown: Option<Unknown>,
    message: Message,
}

/// The messages so far. Several passes read the text, so messages are sorted before they are shown.
#[derive(Default)]
pub(super) struct Report {
    position: Position,
    instance: Option<String>,
    entries: Vec<Entry>,
    /// Which entry tells that a name is unknown. Looked up only, never iterated.
    unknown: HashMap<Unknown, usize>,
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
    pub(super) fn refuse_unknown<T>(
        &mut self,
        unknown: Unknown,
        place: Place,
        text: String,
    ) -> Option<T> {
        if let Some(&index) = self.unknown.get(&unknown) {
            let entry = &mut self.entries[index];
            let here = self.instance.iter();
            let others = here.filter(|instance| !entry.instances.contains(instance));
            if entry.position == self.position {
                entry.instances.extend(others.cloned().collect::<Vec<_>>());
            }
            return None;
        }
        self.unknown.insert(unknown.clone(), self.entries.len());
        self.error(place, text);
        let entry = self.entries.last_mut()?;
        entry.unknown = Some(unknown);
        None
    }

    /// A number, unless it is too large; told if so.
    pub(super) fn finite(&mut self, value: f64, place: Place) -> Option<f64> {
        if value.is_finite() {
            return Some(value);
        }
        self.refuse(place, "this number is too large; the largest is about 1.8e308")
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
            instances: self.instance.iter().cloned().collect(),
            unknown: None,
            message,
        });
    }

    /// Returns the value that was read; reports the error if there is none.
    pub(super) fn read<'t, T>(&mut self, read: &'t Read<T>) -> Option<&'t T> {
        read.as_ref().map_err(|error| self.pass_on(error.clone())).ok()
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

    /// Says of unknown names what is known of them at the end: which of them are misspelt where they are declared.
    fn explain_unknown(&mut self, text: &Text, tokens: &TokenStream) {
        let unknown = self.entries.iter_mut();
        let unknown = unknown.filter_map(|entry| Some((entry.unknown.take()?, entry)));
        let mut listing = None;
        // More are not shown.
        for (unknown, entry) in unknown.take(Message::MOST) {
            let (listing, ends) = listing.get_or_insert_with(|| Listing::by_statements(text));
            if let Some(text) = unknown.without_ground(listing) {
                entry.message.text = text;
            } else if let Some((index, text)) = unknown.misspelt(listing, tokens) {
                let before = ends.iter().take_while(|end| **end <= index);
                let statement = StatementPlace::of_mechanism(before.count() + 1);
                entry.position = (statement, 0);
                entry.message = Message::new(listing.names[index].place, text);
            } else if let Some(text) = unknown.undeclared(listing) {
                entry.message.text = text;
            }
        }
    }

    /// The first message that came.
    pub(super) fn first(self) -> Option<Message> {
        let first = self.entries.into_iter().next();
        first.map(|entry| entry.message)
    }

    /// All messages in the order of the text; what is wrong with several instances of a part once.
    pub(super) fn finish(mut self, text: &Text, tokens: &TokenStream) -> Vec<Message> {
        self.explain_unknown(text, tokens);
        self.entries.sort_by_key(|entry| entry.position);
        let mut told: Vec<Entry> = Vec::new();
        for entry in self.entries {
            // Of one instance the same may be said twice, about two places.
            let same = told.iter_mut().find(|earlier| {
                let said = earlier.position == entry.position
                    && earlier.message.text == entry.message.text;
                let is_told = |instance| earlier.instances.contains(instance);
                said && !earlier.instances.is_empty()
                    && !entry.instances.is_empty()
                    && !entry.instances.iter().any(is_told)
            });
            match same {
                Some(same) => same.instances.extend(entry.instances),
                None => told.push(entry),
            }
        }
        let named = told.into_iter().map(|mut entry| {
            if !entry.instances.is_empty() {
                let instances: Vec<&str> = entry.instances.iter().map(String::as_str).collect();
                entry.message.text += &format!("\n\nnote: in {}", spelling::list(&instances));
            }
            entry.message
        });
        named.collect()
    }
}
