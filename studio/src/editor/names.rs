//! Names for what is drawn, none of which is taken.

use super::drawing::Drawing;
use std::collections::BTreeSet;

/// Gives names that are not taken, each once.
pub(super) struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    /// Those that a mechanism has left.
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
