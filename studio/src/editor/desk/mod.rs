//! The desk: a picture to be traced, locks and groups. It stands around the text and is no part of it.

mod backdrop;
#[cfg(not(target_arch = "wasm32"))]
mod record;

pub(super) use backdrop::{Backdrop, ENDINGS, LONGEST_FILE, is_picture};

use super::drawing::Drawing;
use super::item::Item;
use crate::failure::Failure;
use crate::play::Camera;
use std::collections::BTreeSet;
use std::path::Path;

#[derive(Default)]
pub(super) struct Desk {
    pub(super) backdrop: Option<Backdrop>,
    /// The locked items, which the pointer cannot move.
    pub(super) locked: BTreeSet<Item>,
    /// The groups of items that are selected together.
    pub(super) groups: Vec<BTreeSet<Item>>,
    /// The file in which it is kept.
    #[cfg(not(target_arch = "wasm32"))]
    file: record::DeskFile,
}

impl Desk {
    pub(super) fn is_locked(&self, item: &Item) -> bool {
        self.locked.contains(item)
    }

    /// Keeps the pointer from moving items, or lets it move them again. Tells so.
    pub(super) fn lock(&mut self, items: BTreeSet<Item>, is_locked: bool) -> &'static str {
        if is_locked {
            self.locked.extend(items);
            "locked: the pointer does not move it"
        } else {
            self.locked.retain(|item| !items.contains(item));
            "unlocked"
        }
    }

    /// Returns the present items of the item's group, or the item alone.
    pub(super) fn group_of(&self, item: Item, drawing: Option<&Drawing>) -> BTreeSet<Item> {
        let Some(group) = self.groups.iter().find(|group| group.contains(&item)) else {
            return [item].into();
        };
        let is_there = |item: &&Item| drawing.is_some_and(|drawing| drawing.has(item));
        group.iter().filter(is_there).cloned().collect()
    }

    /// Lets items be selected together from now on. Tells so, or why they cannot be.
    pub(super) fn group(&mut self, items: BTreeSet<Item>) -> Result<String, &'static str> {
        let count = items.len();
        if count < 2 {
            return Err(
                "a group needs two things: hold Shift and click, or drag a frame around them",
            );
        }
        self.ungroup(&items);
        self.groups.push(items);
        Ok(format!("a group of {count} things"))
    }

    /// Takes items out of the groups that they are in. A group of one is none.
    pub(super) fn ungroup(&mut self, items: &BTreeSet<Item>) {
        for group in &mut self.groups {
            group.retain(|item| !items.contains(item));
        }
        self.groups.retain(|group| group.len() > 1);
    }

    /// Puts the picture in a file behind the drawing, as wide as what is seen. Tells so.
    pub(super) fn show_file(&mut self, path: &Path, camera: &Camera) -> Result<String, Failure> {
        // It is found again from any folder.
        let path = &std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        let read = backdrop::read_file(path)
            .map_err(|error| Failure::file(format!("cannot read `{}`: {error}", path.display())));
        self.show(path, &read?, camera)
    }

    /// Puts a picture behind the drawing, as wide as what is seen. Tells so.
    pub(super) fn show(
        &mut self,
        path: &Path,
        bytes: &[u8],
        camera: &Camera,
    ) -> Result<String, Failure> {
        let view = camera.view();
        let backdrop = Backdrop::read(path, bytes)?;
        let extent = camera.extent().map(|side| 0.8 * side / view.scale());
        self.backdrop = Some(backdrop.within(view.center(), extent));
        let path = path.display();
        Ok(format!("`{path}` is behind the drawing; see Properties"))
    }
}
