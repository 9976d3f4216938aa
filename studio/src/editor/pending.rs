//! Gestures that are tried, and those that wait for them.

use super::gesture::Gesture;
use super::tool::{NamedPick, Tool};
use crate::edit::{Command, Workspace};
use std::collections::VecDeque;

/// A gesture that is being tried, and those that wait for it.
#[derive(Default)]
pub(super) struct Pending {
    tried: Option<Tried>,
    waiting: VecDeque<Waiting>,
    /// The number of gestures that were tried. It tells the findings of earlier ones.
    count: u64,
}

pub(super) enum Waiting {
    Gesture(Gesture),
    Line(String),
    /// One whose commands depend on what will be where it was picked.
    Picks(Tool, Vec<NamedPick>),
    /// These links are declared once more, under names that will be free.
    Copies(Vec<String>),
    /// These statements are declared, under names that will be free.
    Paste(String),
}

/// A gesture that is being tried, on which text.
pub(super) struct Tried {
    number: u64,
    pub(super) gesture: Gesture,
    /// The line of the dialogue that makes it, if one does.
    pub(super) line: Option<String>,
    text: String,
    index: usize,
}

impl Tried {
    /// Whether it was tried on this text, for the same mechanism in it.
    pub(super) fn is_of(&self, workspace: &Workspace) -> bool {
        self.text == workspace.text() && self.index == workspace.index()
    }

    /// The gesture, to be tried on this text; or why it cannot be.
    pub(super) fn again(self, workspace: &Workspace) -> Result<Waiting, &'static str> {
        let is_repair = |command: &Command| matches!(command, Command::Repair { .. });
        // Repairs of another text have other numbers.
        if self.gesture.commands.iter().any(is_repair) {
            Err("the text has changed since this repair was offered")
        } else if self.index != workspace.index() {
            Err("another mechanism of the file was chosen meanwhile")
        } else {
            let gesture = Waiting::Gesture(self.gesture);
            Ok(self.line.map_or(gesture, Waiting::Line))
        }
    }
}

impl Pending {
    /// With the numbers of these going on, so that none is given twice.
    pub(super) fn after(before: &Self) -> Self {
        Self { count: before.count, ..Self::default() }
    }

    /// Whether nothing is tried and nothing waits.
    pub(super) fn is_empty(&self) -> bool {
        self.tried.is_none() && self.waiting.is_empty()
    }

    pub(super) const fn is_trying(&self) -> bool {
        self.tried.is_some()
    }

    /// Lets a gesture wait until those before it are made.
    pub(super) fn push(&mut self, waiting: Waiting) {
        self.waiting.push_back(waiting);
    }

    /// Lets a gesture be made before all that wait.
    pub(super) fn push_first(&mut self, waiting: Waiting) {
        self.waiting.push_front(waiting);
    }

    /// The next that waits, if nothing is tried.
    pub(super) fn pop(&mut self) -> Option<Waiting> {
        if self.is_trying() {
            return None;
        }
        self.waiting.pop_front()
    }

    /// Notes that a gesture is tried on a text. Gives its number.
    pub(super) fn begin(
        &mut self,
        gesture: Gesture,
        line: Option<String>,
        workspace: &Workspace,
    ) -> u64 {
        let number = self.number();
        self.tried = Some(Tried {
            number,
            gesture,
            line,
            text: workspace.text().to_owned(),
            index: workspace.index(),
        });
        number
    }

    /// A number that nothing has yet.
    pub(super) fn number(&mut self) -> u64 {
        self.count += 1;
        self.count
    }

    /// The gesture with this number, if its outcome is still waited for.
    pub(super) fn end(&mut self, number: u64) -> Option<Tried> {
        self.tried.take_if(|tried| tried.number == number)
    }

    /// Gives up the last gesture that was not made yet. Gives its title.
    pub(super) fn give_up_last(&mut self) -> Option<String> {
        match self.waiting.pop_back() {
            Some(Waiting::Gesture(gesture)) => Some(gesture.title),
            Some(Waiting::Line(line)) => Some(line),
            Some(Waiting::Picks(tool, _)) => Some(tool.name().to_owned()),
            Some(Waiting::Copies(_)) => Some("copies".to_owned()),
            Some(Waiting::Paste(_)) => Some("paste".to_owned()),
            None => self.tried.take().map(|tried| tried.gesture.title),
        }
    }

    /// Gives up all that was not made yet.
    pub(super) fn clear(&mut self) {
        self.tried = None;
        self.waiting.clear();
    }
}
