//! A point that follows the pointer.

use super::drawing::{Drawing, Pose, relative};
use super::{Gesture, Item};
use crate::document::Document;
use crate::edit::{Drag, Dragged, Refusal};
use mech_compiler::model::LinkId;

/// A point that follows the pointer.
pub(crate) struct Dragging {
    /// What is dragged.
    pub(crate) item: Item,
    drag: Drag,
    /// The pose of its link in the scene, if places are told in the frame of the link.
    frame: Option<Pose>,
    /// Where it was asked to go last, as the drag counts.
    to: Option<[f64; 2]>,
    /// What came of that.
    pub(crate) dragged: Option<Dragged>,
    /// How that looks.
    pub(crate) preview: Option<Drawing>,
    /// Why it cannot go there.
    pub(crate) refusal: Option<Refusal>,
}

impl Dragging {
    /// Takes hold of a joint or a point, where the motors have these values.
    pub(crate) fn begin(
        document: &Document,
        index: usize,
        drawing: &Drawing,
        item: &Item,
        seen_at: Option<Vec<(String, f64)>>,
    ) -> Result<Self, Refusal> {
        let (path, link) = mover(drawing, item).unwrap_or((item.name().to_owned(), LinkId::GROUND));
        let frame = seen_at.is_none().then(|| drawing.pose(link));
        Ok(Self {
            item: item.clone(),
            drag: Drag::begin(document, index, &path, seen_at)?,
            frame,
            to: None,
            dragged: None,
            preview: None,
            refusal: None,
        })
    }

    /// Moves it to a place of the scene. Where it cannot go, it stays where it was last.
    pub(crate) fn move_to(&mut self, place: [f64; 2]) {
        let to = self.frame.map_or(place, |pose| relative(pose, place));
        if self.to == Some(to) {
            return;
        }
        match self.drag.move_to(to) {
            Ok(dragged) => {
                let poses = dragged.poses.clone();
                self.preview = Some(Drawing::new(dragged.model.clone(), poses));
                self.dragged = Some(dragged);
                self.refusal = None;
                self.to = Some(to);
            }
            Err(refusal) => self.refusal = Some(refusal),
        }
    }

    /// The gesture that leaves it where it is; none if it was not moved.
    pub(crate) fn gesture(&self) -> Option<Gesture> {
        self.to.map(|to| self.drag.command(to).into())
    }
}

/// What is moved in the text, and the link in whose frame it is told.
fn mover(drawing: &Drawing, item: &Item) -> Option<(String, LinkId)> {
    match item {
        Item::Joint(name) => drawing.mover_of_joint(drawing.joint(name)?),
        Item::Axis(path) => {
            let axis = drawing.axis(path)?;
            Some((path.clone(), drawing.model.axis(axis).link))
        }
        Item::Link(_) | Item::Action(_) => None,
    }
}
