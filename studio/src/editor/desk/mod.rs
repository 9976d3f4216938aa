//! What stands around the text and is no part of it: a picture to be traced, what is locked, and what is grouped.

mod backdrop;
#[cfg(not(target_arch = "wasm32"))]
mod record;

pub(super) use backdrop::{Backdrop, ENDINGS, is_picture};

use super::Item;
use std::collections::BTreeSet;

/// What stands around the text and is no part of it.
#[derive(Default)]
pub(super) struct Desk {
    /// The picture behind the drawing.
    pub(super) backdrop: Option<Backdrop>,
    /// What the pointer cannot move.
    pub(super) locked: BTreeSet<Item>,
    /// What is selected together.
    pub(super) groups: Vec<BTreeSet<Item>>,
    /// The file in which it is kept.
    #[cfg(not(target_arch = "wasm32"))]
    file: record::DeskFile,
}

impl Desk {
    /// Whether the pointer cannot move it.
    pub(super) fn is_locked(&self, item: &Item) -> bool {
        self.locked.contains(item)
    }

    /// What is selected with an item: its group, or the item alone.
    pub(super) fn group_of(&self, item: Item) -> BTreeSet<Item> {
        let group = self.groups.iter().find(|group| group.contains(&item));
        group.cloned().unwrap_or_else(|| [item].into())
    }

    /// Takes items out of the groups that they are in. A group of one is none.
    pub(super) fn ungroup(&mut self, items: &BTreeSet<Item>) {
        for group in &mut self.groups {
            group.retain(|item| !items.contains(item));
        }
        self.groups.retain(|group| group.len() > 1);
    }
}
