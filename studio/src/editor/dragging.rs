//! A point that follows the pointer.
//!
//! Where it can go is found out beside the window, as everything is; the window shows the last place that is known.

use super::drawing::Drawing;
use super::path::Path;
use super::pose::{Pose, SCENE};
use super::worker::{Hold, Led};
use super::{Gesture, Item};
use crate::edit::{Command, Dragged, Follower, Refusal};
use crate::play::Player;
use crate::text::{Replacement, rounded};
use mech_compiler::model::AxisId;
use std::collections::BTreeSet;

/// A point that follows the pointer.
pub(crate) struct Dragging {
    /// Which of all drags it is.
    pub(crate) number: u64,
    /// What is dragged, and what goes with it.
    pub(crate) items: Vec<Item>,
    /// The frame in which the places of the drag are told, as a pose in the scene.
    frame: Pose,
    /// The mechanism as it was.
    before: Drawing,
    /// By how much places may be rounded.
    tolerance: f64,
    /// Where the pointer has led it last, in the scene.
    pub(crate) pointer: Option<[f64; 2]>,
    /// Where it was asked to go last, as the drag counts.
    wanted: Option<[f64; 2]>,
    /// Of what place it is known last whether it can go there.
    answered: Option<[f64; 2]>,
    /// What leaves it at the last place where it could go.
    commands: Vec<Command>,
    /// What came of that place.
    pub(crate) dragged: Option<Dragged>,
    /// How that looks.
    pub(crate) drawing: Option<Drawing>,
    /// Why it cannot go where it was asked to.
    pub(crate) refusal: Option<Refusal>,
    /// What the compiler makes of that; of a place a little before, while it works.
    pub(crate) preview: Preview,
    /// Whether the pointer has let it go. It is seen until the text says the same.
    pub(crate) is_released: bool,
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
    /// Takes hold of the first of some joints and points. The others go with it. With it stands what is to be held.
    pub(crate) fn begin(
        number: u64,
        drawing: &Drawing,
        items: Vec<Item>,
        pose: Option<Vec<(String, f64)>>,
    ) -> Result<(Self, Hold), Refusal> {
        let is_at_start = pose.is_none();
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
        let hold = Hold {
            number,
            path,
            pose,
            from: from(axis),
            followers: followers.collect(),
        };
        let dragging = Self {
            number,
            frame: frame(axis),
            items,
            before: drawing.clone(),
            tolerance: 1e-6 * drawing.model.size(),
            pointer: None,
            wanted: None,
            answered: None,
            commands: Vec::new(),
            dragged: None,
            drawing: None,
            refusal: None,
            preview: Preview::default(),
            is_released: false,
        };
        Ok((dragging, hold))
    }

    /// Leads it to a place of the scene. Gives that place as the drag counts, if it was not asked to go there last. There is none without
    /// coordinates.
    pub(crate) fn lead(&mut self, place: [f64; 2]) -> Option<[f64; 2]> {
        if !place.iter().all(|part| part.is_finite()) {
            return None;
        }
        self.pointer = Some(place);
        // In the frame of a link that is turned, places have many digits; those that nobody sees are left out.
        let to = match self.frame {
            SCENE => place,
            pose => pose
                .relative(place)
                .map(|part| rounded(part, self.tolerance)),
        };
        if self.wanted == Some(to) {
            return None;
        }
        self.wanted = Some(to);
        Some(to)
    }

    /// Takes over where it was led. Where it cannot go, it stays where it was last.
    pub(crate) fn take(&mut self, led: Led) {
        self.answered = Some(led.to);
        match led.outcome {
            Ok((dragged, commands)) => {
                let poses = dragged.poses.iter().map(|pose| pose.map(Pose::from));
                let (model, poses) = (dragged.model.clone(), poses.collect());
                self.drawing = Some(self.before.with_numbers(model, poses));
                self.dragged = Some(dragged);
                self.commands = commands;
                self.refusal = None;
            }
            Err(refusal) => self.refusal = Some(refusal),
        }
    }

    /// Whether it is not known yet whether it can go where it was asked to go last.
    pub(crate) fn is_awaited(&self) -> bool {
        self.wanted != self.answered
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

    /// The gesture that leaves it where it could go last; none if it was not moved.
    pub(crate) fn gesture(&self) -> Option<Gesture> {
        let title = self.commands.first()?.title();
        Some(Gesture::new(title, self.commands.clone()))
    }
}

/// The turn from one frame to another, as a direction.
fn turn(pose: Pose, other: Pose) -> [f64; 2] {
    let (x, y) = (0.0, 0.0);
    Pose { x, y, ..other }.relative([pose.cos, pose.sin])
}
