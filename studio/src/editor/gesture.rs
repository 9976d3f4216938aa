//! Gestures: each is one step to undo.

use crate::edit::Command;

/// A gesture: commands that are made one after the other, and undone together.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub struct Gesture {
    /// A short description.
    pub title: String,
    /// The commands, in their order; one at least.
    pub commands: Vec<Command>,
}

impl Gesture {
    /// Several commands under one title.
    pub fn new(title: impl Into<String>, commands: Vec<Command>) -> Self {
        Self { title: title.into(), commands }
    }
}

impl From<Command> for Gesture {
    fn from(command: Command) -> Self {
        Self::new(command.title(), vec![command])
    }
}
