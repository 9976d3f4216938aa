//! The selected items, and the items under the mouse.

use super::Item;
use super::desk::Desk;
use super::drawing::Drawing;
use mech_compiler::model::LinkId;
use std::collections::BTreeSet;

#[derive(Default)]
pub(super) struct Selection {
    pub(super) items: BTreeSet<Item>,
    /// The item under the mouse, in the drawing or in the text.
    pub(super) hovered: Option<Item>,
    /// The item under the mouse or the cursor in the text.
    pub(super) under_text: Option<Item>,
}

impl Selection {
    /// Selects something more, or no more if it is selected.
    pub(super) fn toggle(&mut self, item: Item) {
        if !self.items.remove(&item) {
            self.items.insert(item);
        }
    }

    pub(super) fn select_links(&mut self, names: impl IntoIterator<Item = String>) {
        self.items = names.into_iter().map(Item::Link).collect();
    }

    /// Selects all handles within a frame with these corners, too.
    pub(super) fn add_within(&mut self, [a, b]: [[f64; 2]; 2], drawing: &Drawing) {
        let is_within = |place: [f64; 2]| {
            (0..2).all(|part| (a[part].min(b[part])..=a[part].max(b[part])).contains(&place[part]))
        };
        let inside = drawing.handles().filter(|handle| is_within(handle.place));
        self.items.extend(inside.map(|handle| handle.item.clone()));
    }

    /// Takes what is not there any more out of it.
    pub(super) fn forget_what_is_gone(&mut self, drawing: Option<&Drawing>) {
        let has = |item: &Item| drawing.is_some_and(|drawing| drawing.has(item));
        self.items.retain(has);
    }

    /// Whether something is selected or under the mouse.
    pub(super) fn marks(&self, item: &Item) -> bool {
        self.items.contains(item) || self.hovered.as_ref() == Some(item)
    }

    /// The names of the links that are selected.
    pub(super) fn links(&self) -> impl Iterator<Item = String> {
        self.items.iter().filter_map(|item| match item {
            Item::Link(name) => Some(name.clone()),
            _ => None,
        })
    }

    /// The places of the two handles that are selected, if there are two.
    pub(super) fn places(&self, drawing: Option<&Drawing>) -> Option<[[f64; 2]; 2]> {
        let handles = drawing?.handles();
        let selected = handles.filter(|handle| self.items.contains(handle.item));
        let places: Vec<[f64; 2]> = selected.map(|handle| handle.place).collect();
        <[[f64; 2]; 2]>::try_from(places).ok().filter(|[a, b]| a != b)
    }

    /// Returns the items to move so that all selected items move.
    fn handles(&self, drawing: &Drawing) -> impl Iterator<Item = Item> {
        self.items.iter().flat_map(|item| drawing.handles_of(item))
    }

    /// Returns the selected items, with those to move so that they move.
    pub(super) fn with_handles(&self, drawing: Option<&Drawing>) -> BTreeSet<Item> {
        let handles = drawing.into_iter().flat_map(|drawing| self.handles(drawing));
        handles.chain(self.items.iter().cloned()).collect()
    }

    /// Whether a joint or a point is selected, or belongs to a link that is selected with others.
    pub(super) fn moves(&self, item: &Item, drawing: Option<&Drawing>) -> bool {
        let is_among = |drawing| self.handles(drawing).any(|handle| handle == *item);
        self.items.contains(item) || self.items.len() > 1 && drawing.is_some_and(is_among)
    }

    /// A joint or a point with all that goes with it: joints on the same pin, and what else is selected, if it is selected itself.
    pub(super) fn going_with(&self, item: &Item, drawing: &Drawing, desk: &Desk) -> Vec<Item> {
        let mut items = drawing.on_same_pin(item);
        if self.moves(item, Some(drawing)) {
            for other in self.handles(drawing) {
                if !items.contains(&other) && !desk.is_locked(&other) {
                    items.push(other);
                }
            }
        }
        items
    }

    /// Finds an item of a link that drags the whole selection, and its place; none if the link is not selected with others.
    pub(super) fn handle_of(
        &self,
        link: LinkId,
        drawing: &Drawing,
        desk: &Desk,
    ) -> Option<(Item, [f64; 2])> {
        let item = Item::Link(drawing.model.link(link).name.clone());
        if self.items.len() < 2 || !self.items.contains(&item) {
            return None;
        }
        let mut handles = drawing.handles_of(&item).into_iter();
        let free = handles.find(|handle| !desk.is_locked(handle))?;
        let (_, axis) = drawing.mover(&free)?;
        Some((free, drawing.place(axis)))
    }
}
