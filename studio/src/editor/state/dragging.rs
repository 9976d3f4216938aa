//! The user's drags of joints and points.

use super::Editor;
use crate::document::{Document, Source};
use crate::editor::arrow::needs;
use crate::editor::drag::Drag;
use crate::editor::item::Item;
use crate::editor::worker::{Held, Task, Text};
use crate::play::Control;
use crate::text::written;

impl Editor {
    /// Takes hold of a joint or a point, to put it elsewhere. Other joints on the same pin go with it, unless it is to go alone.
    pub fn begin_drag(&mut self, item: &Item, is_alone: bool) {
        let Some(drawing) = self.sight.drawing() else {
            return;
        };
        // An item that was let go comes to rest first.
        if self.sight.drag.is_awaited() {
            return;
        }
        let is_held = |item: &Item| self.desk.is_locked(item);
        if drawing.on_same_pin(item).iter().any(is_held) {
            self.talk.refuse(format!("{item} is locked; Edit > Unlock frees it"));
            return;
        }
        let items = if is_alone {
            vec![item.clone()]
        } else {
            self.selection.going_with(item, drawing, &self.desk)
        };
        if let Some(player) = &mut self.sight.playing.player
            && player.plays()
        {
            player.obey(Control::PlayOrPause);
        }
        self.drag_on(items, None);
    }

    /// Takes hold of the first of some joints and points, with which the others go, and leads it to where the pointer is.
    pub(super) fn drag_on(&mut self, items: Vec<Item>, to: Option<[f64; 2]>) {
        let Some(drawing) = self.sight.drawing() else {
            return;
        };
        let pose = self.sight.playing.seen_at();
        let number = self.analysis.pending.number();
        let (drag, hold) = match Drag::begin(number, drawing, items, pose) {
            Ok(begun) => begun,
            Err(refusal) => {
                self.talk.refuse(refusal);
                return;
            }
        };
        // A text that was already analysed is not analysed again.
        let text = if self.analysis.snapshot.is_of(self.workspace()) {
            Held::Known(self.analysis.snapshot.clone())
        } else {
            Held::Text(Text::of(self.workspace()))
        };
        self.sight.drag = drag;
        self.give(Task::Hold(Box::new(hold), text));
        if let Some(to) = to {
            self.drag_to(to);
        }
    }

    /// Moves what is dragged to a place of the scene.
    pub fn drag_to(&mut self, place: [f64; 2]) {
        if let Some((number, to)) = self.sight.drag.lead(place) {
            self.give(Task::Lead(number, to));
        }
    }

    /// Has the text read as it is while something is dragged, unless one is being read.
    pub(super) fn give_preview(&mut self) {
        let has_bodies = self.sight.shows_bodies_of_drag();
        if let Some((number, edits)) = self.sight.drag.unread() {
            let text = written(self.session.workspace.text(), &edits);
            let source = Source::new(self.workspace().path(), text);
            let document = Document::of(source);
            let index = self.workspace().index();
            let needs = needs(&self.sight, &self.settings);
            let text = Text { document, index };
            self.give(Task::Preview(number, text, has_bodies, needs));
        }
    }

    /// Lets what is dragged go where it is, as one step: as soon as it is known whether it can stay there.
    pub fn end_drag(&mut self) {
        if let Some(gesture) = self.sight.drag.release() {
            self.perform(gesture);
        }
    }
}
