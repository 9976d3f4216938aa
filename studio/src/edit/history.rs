//! Texts that were, so that steps can be undone.

/// The texts of a file, one after the other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct History {
    first: String,
    steps: Vec<Step>,
    /// The number of steps that are made; the others are undone.
    made: usize,
}

/// A step from one text to the next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// The title of the gesture or command.
    pub title: String,
    /// The text after it.
    pub text: String,
}

impl History {
    /// A text, without a step.
    pub fn new(text: impl Into<String>) -> Self {
        Self {
            first: text.into(),
            steps: Vec::new(),
            made: 0,
        }
    }

    /// The text of today.
    #[must_use]
    pub fn text(&self) -> &str {
        match self.made.checked_sub(1) {
            Some(last) => &self.steps[last].text,
            None => &self.first,
        }
    }

    /// The steps that are made, the last of them last.
    #[must_use]
    pub fn made(&self) -> &[Step] {
        &self.steps[..self.made]
    }

    /// The steps that are undone, the next to be made again first.
    #[must_use]
    pub fn undone(&self) -> &[Step] {
        &self.steps[self.made..]
    }

    /// Makes a step. Those that are undone are gone for ever.
    pub fn push(&mut self, title: impl Into<String>, text: impl Into<String>) {
        self.steps.truncate(self.made);
        self.steps.push(Step {
            title: title.into(),
            text: text.into(),
        });
        self.made += 1;
    }

    /// Lets the last step lead to another text, if it has this title and no step is undone. Returns whether it does.
    pub(crate) fn amend(&mut self, title: &str, text: &str) -> bool {
        let is_last = self.made == self.steps.len();
        let last = self.steps.last_mut();
        let last = last.filter(|last| is_last && last.title == title);
        let is_amended = last.is_some();
        if let Some(last) = last {
            text.clone_into(&mut last.text);
        }
        is_amended
    }

    /// Goes back by a step, and gives its title; none at the beginning.
    pub fn undo(&mut self) -> Option<&str> {
        self.made = self.made.checked_sub(1)?;
        Some(&self.steps[self.made].title)
    }

    /// Makes the next step again that was undone, and gives its title; none if there is none.
    pub fn redo(&mut self) -> Option<&str> {
        let step = self.steps.get(self.made)?;
        self.made += 1;
        Some(&step.title)
    }
}
