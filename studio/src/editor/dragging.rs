//! A point that follows the pointer.

use super::drawing::{Drawing, Pose, SCENE, relative};
use super::path::Path;
use super::{Gesture, Item};
use crate::edit::{Drag, Dragged, Follower, Refusal};
use crate::play::Player;
use crate::text::{Replacement, rounded};
use mech_compiler::model::AxisId;
use std::collections::BTreeSet;

/// A point that follows the pointer.
pub(crate) struct Dragging {
    /// What is dragged, and what goes with it.
    pub(crate) items: Vec<Item>,
    drag: Drag,
    /// The pose in the scene of the frame in which its place is told.
    frame: Pose,
    /// The mechanism as it was.
    before: Drawing,
    /// By how much places may be rounded.
    tolerance: f64,
    /// Where the pointer has led it last, in the scene.
    pointer: Option<[f64; 2]>,
    /// Where it was asked to go last, as the drag counts.
    to: Option<[f64; 2]>,
    /// What came of that.
    pub(crate) dragged: Option<Dragged>,
    /// How that looks.
    pub(crate) drawing: Option<Drawing>,
    /// Why it cannot go there.
    pub(crate) refusal: Option<Refusal>,
    /// What the compiler makes of that; of a place a little before, while it works.
    pub(crate) preview: Preview,
}

/// What the compiler makes of a text while something is dragged.
#[derive(Default)]
pub(crate) struct Preview {
    /// Whether a text is being read.
    pub(crate) is_awaited: bool,
    /// The edits of the text that was given last.
    pub(crate) given: Vec<Replacement>,
    /// The mechanism, if it moves.
    pub(crate) player: Option<Player>,
    /// The whole paths of its traced points.
    pub(crate) paths: Vec<Path>,
    /// What is wrong first.
    pub(crate) fault: Option<String>,
}

impl Dragging {
    /// Takes hold of the first of some joints and points, by what begins a drag of a path. The others go with it.
    pub(crate) fn begin(
        drawing: &Drawing,
        items: Vec<Item>,
        is_at_start: bool,
        drag: impl FnOnce(&str) -> Result<Drag, Refusal>,
    ) -> Result<Self, Refusal> {
        let mut movers = items.iter().filter_map(|item| drawing.mover(item));
        let (path, axis) = movers
            .next()
            .ok_or_else(|| Refusal::of("what is not there cannot be dragged"))?;
        let frame = |axis: AxisId| {
            if is_at_start {
                drawing.pose(drawing.model.axis(axis).link)
            } else {
                SCENE
            }
        };
        let from = |axis: AxisId| {
            if is_at_start {
                drawing.model.axis(axis).at
            } else {
                drawing.place(axis)
            }
        };
        let mut taken = BTreeSet::from([path.clone()]);
        let others = movers.filter(|(path, _)| taken.insert(path.clone()));
        let followers = others.map(|(path, other)| Follower {
            path,
            from: from(other),
            turn: turn(frame(axis), frame(other)),
        });
        let followers: Vec<Follower> = followers.collect();
        Ok(Self {
            drag: drag(&path)?.with(from(axis), followers)?,
            frame: frame(axis),
            items,
            before: drawing.clone(),
            tolerance: 1e-6 * drawing.model.size(),
            pointer: None,
            to: None,
            dragged: None,
            drawing: None,
            refusal: None,
            preview: Preview::default(),
        })
    }

    /// Moves it to a place of the scene. Where it cannot go, it stays where it was last.
    pub(crate) fn move_to(&mut self, place: [f64; 2]) {
        self.pointer = Some(place);
        // In the frame of a link that is turned, places have many digits; those that nobody sees are left out.
        let to = match self.frame {
            SCENE => place,
            pose => relative(pose, place).map(|part| rounded(part, self.tolerance)),
        };
        if self.to == Some(to) {
            return;
        }
        match self.drag.move_to(to) {
            Ok(dragged) => {
                let poses = dragged.poses.clone();
                self.drawing = Some(self.before.with_numbers(dragged.model.clone(), poses));
                self.dragged = Some(dragged);
                self.refusal = None;
                self.to = Some(to);
            }
            Err(refusal) => self.refusal = Some(refusal),
        }
    }

    /// What is held, and where the pointer has led it.
    pub(crate) fn held(self) -> (Vec<Item>, Option<[f64; 2]>) {
        (self.items, self.pointer)
    }

    /// The edits of the text that is to be read next; none while one is being read, or if the last was given.
    pub(crate) fn unread(&mut self) -> Option<Vec<Replacement>> {
        let edits = &self.dragged.as_ref()?.edits;
        if self.preview.is_awaited || self.preview.given == *edits {
            return None;
        }
        self.preview.is_awaited = true;
        self.preview.given.clone_from(edits);
        Some(edits.clone())
    }

    /// The gesture that leaves it where it is; none if it was not moved.
    pub(crate) fn gesture(&self) -> Option<Gesture> {
        let to = self.to?;
        let commands = self.drag.commands(to);
        let title = commands.first()?.title();
        Some(Gesture::new(title, commands))
    }
}

/// The turn from one frame to another, as a direction.
fn turn([cos, sin, ..]: Pose, [other_cos, other_sin, ..]: Pose) -> [f64; 2] {
    [
        cos * other_cos + sin * other_sin,
        sin * other_cos - cos * other_sin,
    ]
}
