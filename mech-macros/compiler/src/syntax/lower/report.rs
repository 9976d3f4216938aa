//! Messages, put into the order of the text.

use crate::syntax::{Message, Place};

/// Where in the text something stands: the number of its statement, and of the item in that statement.
type Position = (usize, usize);

/// The messages so far. Several passes read the text, so messages are sorted before they are shown.
#[derive(Default)]
pub(super) struct Report {
    position: Position,
    messages: Vec<(Position, Message)>,
}

impl Report {
    /// From now on, messages are about this statement.
    pub(super) fn enter(&mut self, statement: usize) {
        self.position = (statement, 0);
    }

    /// From now on, messages are about the next item of the statement.
    pub(super) fn next_item(&mut self) {
        self.position.1 += 1;
    }

    /// The number of the statement that messages are about.
    pub(super) fn statement(&self) -> usize {
        self.position.0
    }

    /// Tells something about a place.
    pub(super) fn error(&mut self, place: Place, text: impl Into<String>) {
        self.pass_on(Message::new(place, text));
    }

    /// Passes on a message of the grammar's.
    pub(super) fn pass_on(&mut self, message: Message) {
        self.messages.push((self.position, message));
    }

    /// Whether nothing is wrong so far.
    pub(super) fn is_empty(&self) -> bool {
        self.messages.is_empty()
    }

    /// All messages in the order of the text.
    pub(super) fn finish(mut self) -> Vec<Message> {
        self.messages.sort_by_key(|(position, _)| *position);
        self.messages
            .into_iter()
            .map(|(_, message)| message)
            .collect()
    }
}
