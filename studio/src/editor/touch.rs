//! What the user does to what is seen: selecting, holding, dragging, copying.

use super::drag::Drag;
use super::drawing::Drawing;
use super::ghost::Ghost;
use super::names::Names;
use super::worker::{Held, Led, Previewed, Task};
use super::{Editor, Item};
use crate::document::{Document, PartOffer, Source};
use crate::edit::Command;
use crate::play::{Control, Player};
use crate::text::written;
use mech_compiler::model::LinkId;

impl Editor {
    /// Selects something, or adds it to what is selected, or takes it out of that.
    pub fn select(&mut self, item: Option<Item>, adds: bool) {
        match item {
            Some(item) if adds => {
                if !self.selection.remove(&item) {
                    self.selection.insert(item);
                }
            }
            Some(item) => self.selection = self.group_of(item),
            None if adds => {}
            None => self.selection.clear(),
        }
    }

    /// Writes a use of a part into the line, with the links that are selected, to be completed there.
    pub(super) fn propose_part(&mut self, offer: &PartOffer) {
        let path = format!("mech_runtime::parts::{}", offer.name);
        if !self.workspace().text().contains(&path) {
            self.perform(Command::Use { body: path });
        }
        let links = self.selection.iter().filter_map(|item| match item {
            Item::Link(name) => Some(name.clone()),
            _ => None,
        });
        let links: Vec<String> = std::iter::once("ground".to_owned()).chain(links).collect();
        let name = Names::of(self.scene.drawing()).numbered(&offer.name.to_lowercase());
        self.proposed = Some(format!("use {}", offer.use_as(&name, &links)));
    }

    /// Selects all links.
    pub(super) fn select_all(&mut self) {
        if let Some(drawing) = self.scene.drawing() {
            let links = drawing.model.declared_links();
            let links = links.map(|link| Item::Link(drawing.model.link(link).name.clone()));
            self.selection = links.collect();
        }
    }

    /// Selects all handles within a frame with these corners.
    pub(super) fn select_within(&mut self, [a, b]: [[f64; 2]; 2]) {
        let is_within = |place: [f64; 2]| {
            (0..2).all(|part| (a[part].min(b[part])..=a[part].max(b[part])).contains(&place[part]))
        };
        let handles = self
            .scene
            .seen_drawing()
            .into_iter()
            .flat_map(Drawing::handles);
        let inside = handles.filter(|handle| is_within(handle.place));
        let inside: Vec<Item> = inside.map(|handle| handle.item.clone()).collect();
        self.selection.extend(inside);
    }

    /// Takes hold of a joint or a point, to put it elsewhere. Other joints on the same pin go with it, unless it is to go alone.
    pub fn begin_drag(&mut self, item: &Item, is_alone: bool) {
        let Some(drawing) = self.scene.drawing() else {
            return;
        };
        // What was let go comes to rest first.
        if self.scene.drag.is_awaited() {
            return;
        }
        let is_held = |item: &Item| self.desk.is_locked(item);
        if drawing.on_same_pin(item).iter().any(is_held) {
            self.refuse(format!("{item} is locked; Edit > Unlock frees it"));
            return;
        }
        let items = if is_alone {
            vec![item.clone()]
        } else {
            self.going_with(drawing, item)
        };
        if let Some(player) = &mut self.scene.playing.player
            && player.plays()
        {
            player.obey(Control::PlayOrPause);
        }
        self.drag_on(items, None);
    }

    /// Takes hold of the first of some joints and points, with which the others go, and leads it to where the pointer is.
    pub(super) fn drag_on(&mut self, items: Vec<Item>, to: Option<[f64; 2]>) {
        let Some(drawing) = self.scene.drawing() else {
            return;
        };
        let pose = self.scene.playing.seen_at();
        let number = self.pending.number();
        let (drag, hold) = match Drag::begin(number, drawing, items, pose) {
            Ok(begun) => begun,
            Err(refusal) => {
                self.refuse(refusal);
                return;
            }
        };
        // What is known of the text already is not found out again.
        let text = if self.is_present(&self.snapshot) {
            Held::Known(self.snapshot.clone())
        } else {
            Held::Text(self.workspace().document(), self.workspace().index())
        };
        self.scene.drag = drag;
        self.give(Task::Hold(Box::new(hold), text));
        if let Some(to) = to {
            self.drag_to(to);
        }
    }

    /// A joint or a point with all that goes with it: joints on the same pin, and what else is selected, if it is selected itself.
    fn going_with(&self, drawing: &Drawing, item: &Item) -> Vec<Item> {
        let mut items = drawing.on_same_pin(item);
        if self.is_selected_with(item) {
            let selected = self.selection.iter();
            let others = selected.flat_map(|one| drawing.handles_of(one));
            for other in others {
                if !items.contains(&other) && !self.desk.is_locked(&other) {
                    items.push(other);
                }
            }
        }
        items
    }

    /// Whether a joint or a point is selected, or belongs to a link that is selected with others.
    pub(super) fn is_selected_with(&self, item: &Item) -> bool {
        let of_link = |drawing: &Drawing| {
            let mut selected = self.selection.iter();
            selected.any(|one| drawing.handles_of(one).contains(item))
        };
        let is_among = self.selection.len() > 1 && self.scene.drawing().is_some_and(of_link);
        self.selection.contains(item) || is_among
    }

    /// What of a link can be taken hold of to drag it with all that is selected, and where that is; none if it is not selected with others.
    pub(super) fn handle_of_selected(&self, link: LinkId) -> Option<(Item, [f64; 2])> {
        let drawing = self.scene.drawing()?;
        let item = Item::Link(drawing.model.link(link).name.clone());
        if self.selection.len() < 2 || !self.selection.contains(&item) {
            return None;
        }
        let handles = drawing.handles_of(&item);
        let free = handles
            .into_iter()
            .find(|handle| !self.desk.is_locked(handle))?;
        let (_, axis) = drawing.mover(&free)?;
        Some((free, drawing.place(axis)))
    }

    /// Moves what is dragged to a place of the scene.
    pub fn drag_to(&mut self, place: [f64; 2]) {
        if let Some((number, to)) = self.scene.drag.lead(place) {
            self.give(Task::Lead { number, to });
        }
    }

    /// Takes over where what is dragged was led.
    pub(super) fn take_led(&mut self, led: Led) {
        if !self.scene.drag.take(led) {
            return;
        }
        match self.scene.drag.told() {
            Some(Ok(told)) => self.tell(told),
            Some(Err(why)) => self.refuse(why),
            None => {}
        }
        self.give_preview();
        if let Some(gesture) = self.scene.drag.come_to_rest() {
            self.perform(gesture);
        }
    }

    /// Has the text read as it is while something is dragged, unless one is being read.
    pub(super) fn give_preview(&mut self) {
        let has_bodies = self.scene.shows_bodies_of_drag();
        if let Some((number, edits)) = self.scene.drag.unread() {
            let text = written(self.session.workspace.text(), &edits);
            let source = Source::new(self.workspace().path(), text);
            let task = Task::Preview {
                number,
                document: Document::of(source),
                index: self.workspace().index(),
                has_bodies,
            };
            self.give(task);
        }
    }

    /// Takes over what the compiler makes of a text while something is dragged.
    pub(super) fn take_preview(&mut self, previewed: Previewed) {
        let Some(preview) = self.scene.drag.preview_mut(previewed.number) else {
            return;
        };
        preview.is_awaited = false;
        preview.fault = previewed.fault;
        preview.paths = previewed.paths;
        preview.player = previewed.mechanism.map(|mechanism| {
            let mut player = Player::new(mechanism, Vec::new(), self.scene.camera.size());
            if let Some(before) = &self.scene.playing.player {
                player.stand_as(before.mechanism());
                player.show_layers(before.layers());
            }
            player
        });
        self.give_preview();
    }

    /// Lets what is dragged go where it is, as one step: as soon as it is known whether it can stay there.
    pub fn end_drag(&mut self) {
        if let Some(gesture) = self.scene.drag.release() {
            self.perform(gesture);
        }
    }

    /// Shows what a repair would make of the mechanism, by its number from 1; or nothing any more.
    pub(super) fn preview_mending(&mut self, number: Option<usize>) {
        if self.ghost.as_ref().map(|ghost| ghost.number) == number {
            return;
        }
        self.ghost = number.and_then(|number| {
            let mending = self.mendings.get(number.checked_sub(1)?)?;
            let document = self.snapshot.document.source();
            Ghost::of(
                number,
                mending,
                document.path(),
                self.snapshot.index,
                self.scene.drawing(),
            )
        });
    }
}
