//! The generated API as data: each associated constant and method once.

mod condition;
mod table;

use crate::bug::bug;
pub(crate) use condition::{Condition, Owner};
pub(crate) use table::TABLE;

/// What of a mechanism an item is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Subject {
    Mechanism,
    /// The mechanism as an implementation of the trait.
    Trait,
    Link,
    Point,
    Joint,
    /// A joint that no motor drives.
    DependentJoint,
    Force,
    Torque,
    Spring,
    Param,
    Trace,
}

/// An associated constant, type or method.
pub(crate) struct Item {
    pub(crate) subject: Subject,
    pub(crate) condition: Condition,
    /// Its signature, and what it is in a mechanism with errors: there it is never run.
    ///
    /// These words stand for what depends on the mechanism: `pub` for its visibility, `scalar` for its precision, `struct_name`,
    /// `frame`, `none`, and counts such as `motor_count`. `name` is what the subject is called, also in `set_name` and `name_rate`.
    pub(crate) text: &'static str,
}

impl Item {
    /// What it is called.
    pub(crate) fn name(&self) -> &'static str {
        let mut after = ["fn ", "const ", "type "]
            .into_iter()
            .filter_map(|keyword| Some(self.text.split_once(keyword)?.1));
        let Some(after) = after.next() else {
            bug!("`{}` has no name", self.text);
        };
        let is_part = |letter: char| letter == '_' || letter.is_alphanumeric();
        let end = after.find(|letter| !is_part(letter));
        &after[..end.unwrap_or(after.len())]
    }

    /// Whether it is a constant or method whose name is the same for each mechanism.
    fn is_fixed(&self) -> bool {
        matches!(self.subject, Subject::Mechanism | Subject::Trait)
            && !self.text.starts_with("type ")
    }
}

/// What the trait provides, and what is derived.
const INHERITED: [&str; 4] = ["view", "clone", "default", "fmt"];

/// Whether no link, joint or other part of any mechanism may have this name.
pub(crate) fn is_reserved(name: &str) -> bool {
    let mut items = TABLE.iter().filter(|item| item.is_fixed());
    INHERITED.contains(&name)
        || items.any(|item| item.condition.owner().is_none() && item.name() == name)
}

/// The names that are taken only where something was asked for.
pub(crate) fn names_of(owner: Owner) -> impl Iterator<Item = &'static str> {
    let items = TABLE.iter().filter(|item| item.is_fixed());
    items
        .filter(move |item| item.condition.owner() == Some(owner))
        .map(Item::name)
}
