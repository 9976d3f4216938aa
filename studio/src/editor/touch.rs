//! What the user does to what is seen: selecting, holding, dragging, copying.

use super::dragging::Dragging;
use super::drawing::Drawing;
use super::ghost::Ghost;
use super::names::Names;
use super::path::Path;
use super::settings::Visible;
use super::worker::{Held, Led, Previewed, Task};
use super::{Editor, Item};
use crate::document::{Document, PartOffer, Source};
use crate::edit::Command;
use crate::play::{Control, Player};
use crate::text::written;
use mech_compiler::model::LinkId;

/// How many bodies are painted while something is dragged.
const MOST_BODIES: usize = 200;

impl Editor {
    /// What is seen: while something is dragged, the mechanism as it is then.
    pub(super) fn seen_drawing(&self) -> Option<&Drawing> {
        let dragged = self
            .dragging
            .as_ref()
            .and_then(|dragging| dragging.drawing.as_ref());
        dragged.or(self.drawing.as_ref())
    }

    /// What is painted: while something is dragged, the mechanism as it is then, as soon as that is known.
    pub(super) fn seen_player(&self) -> Option<&Player> {
        match &self.dragging {
            Some(dragging) if dragging.drawing.is_some() => dragging.preview.player.as_ref(),
            _ => self.player.as_ref(),
        }
    }

    /// The whole paths of traced points, as they are known.
    pub(super) fn seen_paths(&self) -> &[Path] {
        match &self.dragging {
            Some(dragging) if dragging.drawing.is_some() => &dragging.preview.paths,
            _ => &self.paths,
        }
    }

    /// Whether the bodies of links are seen, and not the schematic.
    pub(super) fn shows_bodies(&self) -> bool {
        (self.held().is_none() || self.shows_bodies_of_drag())
            && self.settings.shows(Visible::Bodies)
            && self.seen_player().is_some()
    }

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
        let name = Names::of(self.drawing.as_ref()).numbered(&offer.name.to_lowercase());
        self.proposed = Some(format!("use {}", offer.use_as(&name, &links)));
    }

    /// Selects all links.
    pub(super) fn select_all(&mut self) {
        if let Some(drawing) = &self.drawing {
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
        let handles = self.seen_drawing().into_iter().flat_map(Drawing::handles);
        let inside = handles.filter(|handle| is_within(handle.place));
        let inside: Vec<Item> = inside.map(|handle| handle.item.clone()).collect();
        self.selection.extend(inside);
    }

    /// Takes hold of a joint or a point, to put it elsewhere. Other joints on the same pin go with it, unless it is to go alone.
    pub fn begin_drag(&mut self, item: &Item, is_alone: bool) {
        let Some(drawing) = &self.drawing else {
            return;
        };
        // What was let go comes to rest first.
        if self.dragging.as_ref().is_some_and(Dragging::is_awaited) {
            return;
        }
        let is_held = |item: &Item| self.desk.is_locked(item);
        if drawing.on_same_pin(item).iter().any(is_held) {
            self.refuse(format!("{item} is locked; Edit > Unlock frees it"));
            return;
        }
        if let Some(player) = &mut self.player
            && player.plays()
        {
            player.obey(Control::PlayOrPause);
        }
        let items = if is_alone {
            vec![item.clone()]
        } else {
            self.going_with(drawing, item)
        };
        self.drag_on(items, None);
    }

    /// Takes hold of the first of some joints and points, with which the others go, and leads it to where the pointer is.
    pub(super) fn drag_on(&mut self, items: Vec<Item>, to: Option<[f64; 2]>) {
        let Some(drawing) = &self.drawing else {
            return;
        };
        let pose = self.seen_at();
        let number = self.pending.number();
        let (dragging, hold) = match Dragging::begin(number, drawing, items, pose) {
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
        self.dragging = Some(dragging);
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
        let is_among = self.selection.len() > 1 && self.drawing.as_ref().is_some_and(of_link);
        self.selection.contains(item) || is_among
    }

    /// What of a link can be taken hold of to drag it with all that is selected, and where that is; none if it is not selected with others.
    pub(super) fn handle_of_selected(&self, link: LinkId) -> Option<(Item, [f64; 2])> {
        let drawing = self.drawing.as_ref()?;
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

    /// What the pointer holds.
    pub(super) fn held(&self) -> Option<&Dragging> {
        self.dragging
            .as_ref()
            .filter(|dragging| !dragging.is_released)
    }

    /// Moves what is dragged to a place of the scene.
    pub fn drag_to(&mut self, place: [f64; 2]) {
        let held = self
            .dragging
            .as_mut()
            .filter(|dragging| !dragging.is_released);
        let Some(dragging) = held else {
            return;
        };
        let number = dragging.number;
        if let Some(to) = dragging.lead(place) {
            self.give(Task::Lead { number, to });
        }
    }

    /// Takes over where what is dragged was led.
    pub(super) fn take_led(&mut self, led: Led) {
        let number = led.number;
        let mut dragged = self.dragging.as_mut();
        let Some(dragging) = dragged.take_if(|dragging| dragging.number == number) else {
            return;
        };
        dragging.take(led);
        let (is_released, is_awaited) = (dragging.is_released, dragging.is_awaited());
        self.tell_drag();
        if !is_released {
            self.give_preview();
        } else if !is_awaited {
            self.leave_dragged();
        }
    }

    /// Tells where what is dragged is, or why it cannot go there.
    fn tell_drag(&mut self) {
        let Some(dragging) = &self.dragging else {
            return;
        };
        if let Some(refusal) = &dragging.refusal {
            let why = refusal.to_string();
            self.refuse(why);
            return;
        }
        let notes = dragging
            .dragged
            .as_ref()
            .map(|dragged| dragged.notes.join("; "));
        let place = dragging.pointer.unwrap_or_default();
        let [x, y] = place.map(|part| crate::text::shortest(part, 1e-6));
        let items: Vec<String> = dragging.items.iter().map(ToString::to_string).collect();
        let told = format!(
            "{} to ({x}, {y}) {}",
            items.join(", "),
            notes.unwrap_or_default()
        );
        match dragging.preview.fault.clone() {
            Some(fault) => self.refuse(format!("{told}: {fault}")),
            None => self.tell(told),
        }
    }

    /// Whether bodies are seen while something is dragged: very many take longer to be painted than a frame may.
    fn shows_bodies_of_drag(&self) -> bool {
        let drawing = self.drawing.as_ref();
        drawing.is_some_and(|drawing| drawing.model.links.len() <= MOST_BODIES)
    }

    /// Has the text read as it is while something is dragged, unless one is being read.
    pub(super) fn give_preview(&mut self) {
        let has_bodies = self.shows_bodies_of_drag();
        let Some(dragging) = &mut self.dragging else {
            return;
        };
        let number = dragging.number;
        if let Some(edits) = dragging.unread() {
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
        let number = previewed.number;
        let mut dragged = self.dragging.as_mut();
        let Some(dragging) = dragged.take_if(|dragging| dragging.number == number) else {
            return;
        };
        let preview = &mut dragging.preview;
        preview.is_awaited = false;
        preview.fault = previewed.fault;
        preview.paths = previewed.paths;
        preview.player = previewed.mechanism.map(|mechanism| {
            let mut player = Player::new(mechanism, Vec::new(), self.camera.size());
            if let Some(before) = &self.player {
                player.stand_as(before.mechanism());
                player.show_layers(before.layers());
            }
            player
        });
        if self.held().is_some() {
            self.give_preview();
        }
    }

    /// Lets what is dragged go where it is, as one step: as soon as it is known whether it can stay there.
    pub fn end_drag(&mut self) {
        let held = self.dragging.as_mut();
        let Some(dragging) = held.filter(|dragging| !dragging.is_released) else {
            return;
        };
        dragging.is_released = true;
        if !dragging.is_awaited() {
            self.leave_dragged();
        }
    }

    /// Leaves what is dragged where it could go last. It is seen there until the text says the same.
    fn leave_dragged(&mut self) {
        match self.dragging.as_ref().and_then(Dragging::gesture) {
            Some(gesture) => self.perform(gesture),
            None => self.dragging = None,
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
                self.drawing.as_ref(),
            )
        });
    }
}
