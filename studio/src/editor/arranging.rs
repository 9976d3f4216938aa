//! What the user arranges around the text: locks, groups, and a picture to be traced.

use super::desk::{Backdrop, Desk};
use super::drawing::Drawing;
use super::{Editor, Item};
use crate::failure::Failure;
use std::collections::BTreeSet;
use std::path::Path;

impl Editor {
    /// Brings back what was kept beside the file.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn lay_desk(&mut self) {
        if self.workspace().is_named() {
            let (desk, done) = Desk::of(self.workspace().path());
            self.desk = desk;
            self.refuse_failed(done);
        }
    }

    /// Keeps it beside the file, if there is one.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn save_desk(&mut self) {
        if self.workspace().saved().is_some() {
            let path = self.workspace().path().to_owned();
            let saved = self.desk.save(&path);
            self.refuse_failed(saved);
        }
    }

    /// Whether the pointer cannot move something.
    #[must_use]
    pub fn is_locked(&self, item: &Item) -> bool {
        self.desk.is_locked(item)
    }

    /// What is selected with an item, as far as it is there.
    pub(super) fn group_of(&self, item: Item) -> BTreeSet<Item> {
        let mut group = self.desk.group_of(item);
        if group.len() > 1 {
            let drawing = self.scene.drawing();
            group.retain(|item| drawing.is_some_and(|drawing| drawing.has(item)));
        }
        group
    }

    /// What is selected, with all that has to be moved so that it moves.
    fn selected_with_handles(&self) -> BTreeSet<Item> {
        let drawing = self.scene.drawing().into_iter();
        let handles = drawing.flat_map(|drawing: &Drawing| {
            let selected = self.selection.iter();
            selected.flat_map(|item| drawing.handles_of(item))
        });
        handles.chain(self.selection.iter().cloned()).collect()
    }

    /// Keeps the pointer from moving what is selected.
    pub(super) fn lock_selected(&mut self) {
        let items = self.selected_with_handles();
        self.desk.locked.extend(items);
        self.tell("locked: the pointer does not move it");
    }

    /// Lets the pointer move what is selected again.
    pub(super) fn unlock_selected(&mut self) {
        for item in self.selected_with_handles() {
            self.desk.locked.remove(&item);
        }
        self.tell("unlocked");
    }

    /// Lets what is selected be selected together from now on.
    pub(super) fn group_selected(&mut self) {
        let items = self.selected_with_handles();
        if items.len() < 2 {
            self.refuse(
                "a group needs two things: hold Shift and click, or drag a frame around them",
            );
            return;
        }
        self.desk.ungroup(&items);
        self.selection.clone_from(&items);
        self.tell(format!("a group of {} things", items.len()));
        self.desk.groups.push(items);
    }

    /// Lets what is selected be selected alone again.
    pub(super) fn ungroup_selected(&mut self) {
        let items = self.selection.clone();
        self.desk.ungroup(&items);
        self.tell("ungrouped");
    }

    /// Puts the picture in a file behind the drawing.
    pub(super) fn show_picture(&mut self, path: &Path) {
        // It is found again from any folder.
        let path = &std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        let read = std::fs::read(path)
            .map_err(|error| Failure::file(format!("cannot read `{}`: {error}", path.display())));
        let shown = read.and_then(|bytes| self.set_backdrop(path, &bytes));
        self.refuse_failed(shown);
    }

    /// Puts a picture behind the drawing, as wide as what is seen.
    ///
    /// # Errors
    /// If the bytes are no picture that can be read.
    pub(super) fn set_backdrop(&mut self, path: &Path, bytes: &[u8]) -> Result<(), Failure> {
        let view = self.scene.camera.view();
        let [width, height] = self.scene.camera.extent();
        let backdrop = Backdrop::read(path, bytes)?;
        let extent = [width, height].map(|side| 0.8 * side / view.scale());
        self.desk.backdrop = Some(backdrop.within(view.center(), extent));
        self.tell(format!(
            "`{}` is behind the drawing; see Properties",
            path.display()
        ));
        Ok(())
    }

    /// The picture behind the drawing, if there is one: its file, its centre and its width in scene units.
    #[must_use]
    pub fn backdrop(&self) -> Option<(&Path, [f64; 2], f64)> {
        let backdrop = self.desk.backdrop.as_ref()?;
        Some((&backdrop.path, backdrop.place.center, backdrop.place.width))
    }

    /// Makes the picture larger or smaller about the first of two selected handles, so that their distance in it becomes this one.
    pub(super) fn scale_backdrop(&mut self, distance: f64) {
        let Some([from, to]) = self.selected_places() else {
            return;
        };
        let before = (to[0] - from[0]).hypot(to[1] - from[1]);
        let factor = distance / before;
        if let Some(backdrop) = &mut self.desk.backdrop
            && factor.is_finite()
            && factor > 0.0
        {
            backdrop.place.scale_about(from, factor);
        }
    }

    /// The places of the two handles that are selected, if there are two.
    pub(super) fn selected_places(&self) -> Option<[[f64; 2]; 2]> {
        let handles = self.scene.drawing()?.handles();
        let selected = handles.filter(|handle| self.selection.contains(handle.item));
        let places: Vec<[f64; 2]> = selected.map(|handle| handle.place).collect();
        <[[f64; 2]; 2]>::try_from(places)
            .ok()
            .filter(|[a, b]| a != b)
    }
}
