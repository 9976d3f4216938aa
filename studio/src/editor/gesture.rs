//! What a user does at once: one step to undo.

use crate::edit::Command;

/// What a user does at once: commands that are made one after the other, and undone together.
#[derive(Clone, Debug, PartialEq)]
pub struct Gesture {
    /// What it does, in a few words.
    pub title: String,
    /// The commands, in their order; one at least.
    pub commands: Vec<Command>,
}

impl Gesture {
    /// Several commands under one title.
    pub fn new(title: impl Into<String>, commands: Vec<Command>) -> Self {
        Self {
            title: title.into(),
            commands,
        }
    }
}

impl From<Command> for Gesture {
    fn from(command: Command) -> Self {
        Self::new(command.title(), vec![command])
    }
}
