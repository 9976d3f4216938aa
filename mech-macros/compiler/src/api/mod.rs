//! The generated API as data: each associated constant and method once.

mod condition;
mod table;

use crate::bug::bug;
pub use condition::Asked;
pub(crate) use condition::{Condition, Owner};
use std::collections::BTreeSet;
use std::sync::LazyLock;
pub(crate) use table::TABLE;

/// The parts of a mechanism that have an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Subject {
    /// The mechanism itself, by its inherent implementation.
    Mechanism,
    /// The mechanism itself, by its implementation of the trait.
    Trait,
    /// The mechanism itself, by both.
    Both,
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
    /// Its signature, and its body in a mechanism with errors, which is never run.
    ///
    /// These words stand for what depends on the mechanism: `pub` for its visibility, `scalar` for its precision, `struct_name`,
    /// `frame`, `none`, and counts such as `motor_count`. `name` is the name of the part, also in `set_name` and `name_rate`.
    text: &'static str,
}

impl Item {
    /// Its text in the inherent implementation; none if it does not stand there.
    pub(crate) fn method(&self) -> Option<String> {
        (self.subject != Subject::Trait).then(|| self.text.to_owned())
    }

    /// Its text in the implementation of the trait; none if it does not stand there.
    pub(crate) fn trait_item(&self) -> Option<String> {
        let is_of_trait = matches!(self.subject, Subject::Trait | Subject::Both);
        is_of_trait.then(|| {
            let text = self.text.replacen("pub const fn", "fn", 1);
            text.replacen("pub ", "", 1)
        })
    }

    /// Its name.
    pub(crate) fn name(&self) -> &'static str {
        let mut keywords = ["fn ", "const ", "type "].into_iter();
        let after = keywords.find_map(|keyword| Some(self.text.split_once(keyword)?.1));
        let Some(after) = after else {
            bug!("`{}` has no name", self.text);
        };
        let is_part = |letter: char| letter == '_' || letter.is_alphanumeric();
        let end = after.find(|letter| !is_part(letter));
        &after[..end.unwrap_or(after.len())]
    }

    /// Whether it is a constant or method with the same name in each mechanism.
    pub(crate) fn is_fixed(&self) -> bool {
        let is_of_mechanism =
            matches!(self.subject, Subject::Mechanism | Subject::Trait | Subject::Both);
        is_of_mechanism && !self.text.starts_with("type ")
    }
}

/// The names of methods that the trait provides or that are derived.
const INHERITED: [&str; 4] = ["view", "clone", "default", "fmt"];

/// Whether no link, joint or other part of any mechanism may have this name.
pub(crate) fn is_reserved(name: &str) -> bool {
    // Asked for each name of a mechanism: the table is read once for all of them.
    static RESERVED: LazyLock<BTreeSet<&str>> = LazyLock::new(|| {
        let items = TABLE.iter().filter(|item| item.is_fixed());
        let items = items.filter(|item| item.condition.owner().is_none());
        items.map(Item::name).chain(INHERITED).collect()
    });
    RESERVED.contains(name)
}

/// The names that an owner takes.
pub(crate) fn names_of(owner: Owner) -> BTreeSet<&'static str> {
    let items = TABLE.iter().filter(|item| item.is_fixed());
    items.filter(|item| item.condition.owner() == Some(owner)).map(Item::name).collect()
}
