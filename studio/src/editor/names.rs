//! Names for what is drawn, none of which is taken.

use super::drawing::Drawing;
use crate::text::is_of_word;
use std::collections::BTreeSet;

/// Gives names that are not taken, each once.
pub(super) struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    pub(super) fn of(drawing: Option<&Drawing>) -> Self {
        let mut taken = BTreeSet::new();
        if let Some(drawing) = drawing {
            let model = &drawing.model;
            taken.extend(model.links.iter().map(|link| link.name.clone()));
            taken.extend(model.joints.iter().map(|joint| joint.name.clone()));
            let actions = &model.actions;
            taken.extend(actions.springs.iter().map(|one| one.name.clone()));
            taken.extend(actions.dampers.iter().map(|one| one.name.clone()));
            taken.extend(actions.loads.iter().map(|one| one.name.clone()));
        }
        Self { taken }
    }

    pub(super) fn within(text: &str) -> Self {
        let words = text.split(|letter| !is_of_word(letter));
        Self { taken: words.map(ToOwned::to_owned).collect() }
    }

    /// A name like another: that itself, if it is free.
    pub(super) fn like(&mut self, name: &str, is_joint: bool) -> String {
        if self.taken.insert(name.to_owned()) {
            return name.to_owned();
        }
        if is_joint && name.len() == 1 {
            return self.joint();
        }
        self.numbered(name.trim_end_matches(|last: char| last.is_ascii_digit()))
    }

    /// A word with a number: `bar3`.
    pub(super) fn numbered(&mut self, word: &str) -> String {
        self.first((1..).map(|number: u32| format!("{word}{number}")))
    }

    /// A letter, as long as there are some, for a joint.
    pub(super) fn joint(&mut self) -> String {
        let letters = ('a'..='z').map(String::from);
        self.first(letters.chain((1..).map(|number: u32| format!("joint{number}"))))
    }

    fn first(&mut self, mut names: impl Iterator<Item = String>) -> String {
        // There is always another number.
        let free = names.find(|name| !self.taken.contains(name));
        let free = free.unwrap_or_default();
        self.taken.insert(free.clone());
        free
    }
}
