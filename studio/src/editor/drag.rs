//! A joint or a point that follows the pointer.
//!
//! Where it can go is found out beside the window, as everything is; the window shows the last place that is known.

use super::drawing::Drawing;
use super::placement::{Pose, SCENE};
use super::range::Path;
use super::worker::{Hold, Led, Undone};
use super::{Gesture, Item};
use crate::edit::{Follower, Refusal};
use crate::play::Player;
use crate::text::{Replacement, rounded, shortest};
use mech_compiler::model::AxisId;
use std::collections::BTreeSet;
use std::mem;

/// A drag: from when the pointer takes hold of something until the text says where it stays.
#[derive(Default)]
pub(crate) enum Drag {
    #[default]
    Nothing,
    /// Something is held, and was led nowhere yet.
    Grabbing(Grabbed),
    Led(Following),
    /// It was let go before it was known whether it can go where it was led last.
    Released(Following),
    /// It was let go where it can stay. It is seen there until its gesture is made.
    Left(u64, Box<Stay>),
}

/// The items that the pointer has taken hold of.
pub(crate) struct Grabbed {
    /// Which of all drags it is.
    number: u64,
    /// The dragged item, and those that go with it.
    items: Vec<Item>,
    /// The frame in which the places of the drag are told, as a pose in the scene.
    frame: Pose,
    before: Drawing,
    /// By how much places may be rounded.
    tolerance: f64,
}

/// The grabbed items that follow the pointer.
pub(crate) struct Following {
    grabbed: Grabbed,
    /// Where the pointer has led it last, in the scene.
    pointer: [f64; 2],
    /// Where it was asked to go last, as the drag counts.
    wanted: [f64; 2],
    /// Of what place it is known last whether it can go there.
    answered: Option<[f64; 2]>,
    refusal: Option<Refusal>,
    /// The last place where it could go.
    stay: Option<Box<Stay>>,
}

/// A place where something that is dragged can stay.
pub(crate) struct Stay {
    /// The gesture that leaves it there.
    gesture: Gesture,
    /// The edits of the text that say so.
    pub(crate) edits: Vec<Replacement>,
    notes: String,
    pub(crate) drawing: Drawing,
    /// The preview of the result; of a place a little before, while the compiler works.
    pub(crate) preview: Preview,
}

/// The preview of a text while something is dragged.
#[derive(Default)]
pub(crate) struct Preview {
    /// Whether a text is being read.
    pub(crate) is_awaited: bool,
    /// The edits of the text that was given last.
    given: Vec<Replacement>,
    pub(crate) player: Option<Player>,
    /// The whole paths of its traced points.
    pub(crate) paths: Vec<Path>,
    pub(crate) fault: Option<String>,
}

impl Drag {
    /// Takes hold of the first of some joints and points. The others go with it. With it stands what is to be held.
    pub(crate) fn begin(
        number: u64,
        drawing: &Drawing,
        items: Vec<Item>,
        pose: Option<Vec<(String, f64)>>,
    ) -> Result<(Self, Hold), Refusal> {
        let is_at_start = pose.is_none();
        let mut movers = items.iter().filter_map(|item| drawing.mover(item));
        let (path, axis) =
            movers.next().ok_or_else(|| Refusal::of("what is not there cannot be dragged"))?;
        let frame = |axis: AxisId| {
            if is_at_start { drawing.pose(drawing.model.axis(axis).link) } else { SCENE }
        };
        let from = |axis: AxisId| {
            if is_at_start { drawing.model.axis(axis).at } else { drawing.place(axis) }
        };
        let mut taken = BTreeSet::from([path.clone()]);
        let others = movers.filter(|(path, _)| taken.insert(path.clone()));
        let followers = others.map(|(path, other)| Follower {
            path,
            from: from(other),
            turn: turn(frame(axis), frame(other)),
        });
        let hold = Hold { number, path, pose, from: from(axis), followers: followers.collect() };
        let grabbed = Grabbed {
            number,
            frame: frame(axis),
            items,
            before: drawing.clone(),
            tolerance: 1e-6 * drawing.model.size(),
        };
        Ok((Self::Grabbing(grabbed), hold))
    }

    pub(crate) const fn is_nothing(&self) -> bool {
        matches!(self, Self::Nothing)
    }

    /// Returns the items that the pointer holds, with those that go with them; none if it holds nothing.
    pub(crate) fn held(&self) -> Option<&[Item]> {
        match self {
            Self::Grabbing(grabbed) | Self::Led(Following { grabbed, .. }) => Some(&grabbed.items),
            _ => None,
        }
    }

    /// Returns the grabbed items that follow the pointer, or have to come to rest.
    fn following(&self) -> Option<&Following> {
        match self {
            Self::Led(following) | Self::Released(following) => Some(following),
            _ => None,
        }
    }

    /// Whether the answer for the place to which it was led last is awaited.
    pub(crate) fn is_awaited(&self) -> bool {
        self.following().is_some_and(Following::is_awaited)
    }

    /// The last place where it could go: it is seen there.
    pub(crate) fn stay(&self) -> Option<&Stay> {
        match self {
            Self::Left(_, stay) => Some(stay),
            _ => self.following()?.stay.as_deref(),
        }
    }

    /// Leads what is held to a place of the scene. Gives its number and that place as the drag counts, if it was not asked to go there last.
    /// There is none without coordinates.
    pub(crate) fn lead(&mut self, place: [f64; 2]) -> Option<(u64, [f64; 2])> {
        if !place.iter().all(|part| part.is_finite()) {
            return None;
        }
        let (asked, led) = match mem::take(self) {
            Self::Grabbing(grabbed) => {
                let to = grabbed.place(place);
                let following = Following {
                    pointer: place,
                    wanted: to,
                    answered: None,
                    refusal: None,
                    stay: None,
                    grabbed,
                };
                (Some(to), Self::Led(following))
            }
            Self::Led(mut following) => {
                let to = following.grabbed.place(place);
                following.pointer = place;
                let before = mem::replace(&mut following.wanted, to);
                (Some(to).filter(|to| *to != before), Self::Led(following))
            }
            other => (None, other),
        };
        *self = led;
        self.number().zip(asked)
    }

    /// Takes over where it was led: where it cannot go, it stays where it was last. Tells where it is, or why it cannot go there; nothing if
    /// nobody waits for that.
    pub(crate) fn take(&mut self, led: Led) -> Option<Result<String, String>> {
        match self {
            Self::Led(following) | Self::Released(following)
                if following.grabbed.number == led.number =>
            {
                following.take(led);
                Some(following.told())
            }
            _ => None,
        }
    }

    /// The edits of the text that is to be read next, and the number of the drag; none while one is being read, or if the last was given.
    pub(crate) fn unread(&mut self) -> Option<(u64, Vec<Replacement>)> {
        let Self::Led(following) = self else {
            return None;
        };
        let Stay { edits, preview, .. } = following.stay.as_deref_mut()?;
        if preview.is_awaited || preview.given == *edits {
            return None;
        }
        preview.is_awaited = true;
        preview.given.clone_from(edits);
        Some((following.grabbed.number, edits.clone()))
    }

    pub(crate) fn preview_mut(&mut self, number: u64) -> Option<&mut Preview> {
        if self.number() != Some(number) {
            return None;
        }
        let stay = match self {
            Self::Led(following) | Self::Released(following) => following.stay.as_mut(),
            Self::Left(_, stay) => Some(stay),
            _ => None,
        };
        stay.map(|stay| &mut stay.preview)
    }

    /// Lets go of what is held. Gives the gesture that leaves it where it is, if it is known that it can stay there.
    pub(crate) fn release(&mut self) -> Option<Gesture> {
        *self = match mem::take(self) {
            Self::Grabbing(_) => Self::Nothing,
            Self::Led(following) => Self::Released(following),
            other => other,
        };
        self.come_to_rest()
    }

    /// Leaves what was let go where it could go last, as soon as that is known. Gives the gesture that does so.
    pub(crate) fn come_to_rest(&mut self) -> Option<Gesture> {
        let Self::Released(following) = self else {
            return None;
        };
        if following.is_awaited() {
            return None;
        }
        let (number, stay) = (following.grabbed.number, following.stay.take());
        *self = stay.map_or(Self::Nothing, |stay| Self::Left(number, stay));
        self.left().cloned()
    }

    /// The gesture that leaves it where it was let go, if that is waited for.
    pub(crate) fn left(&self) -> Option<&Gesture> {
        match self {
            Self::Left(_, stay) => Some(&stay.gesture),
            _ => None,
        }
    }

    /// Where it was on its way: what is dragged, and where the pointer has led it. None if it is known where it stays.
    pub(crate) fn under_way(self) -> Option<(Vec<Item>, Option<[f64; 2]>)> {
        match self {
            Self::Nothing | Self::Left(..) => None,
            Self::Grabbing(grabbed) => Some((grabbed.items, None)),
            Self::Led(following) | Self::Released(following) => {
                Some((following.grabbed.items, Some(following.pointer)))
            }
        }
    }

    /// Waits no more for what was not done.
    pub(crate) fn take_undone(&mut self, undone: Undone) {
        if let Undone::Preview(number) = undone
            && let Some(preview) = self.preview_mut(number)
        {
            preview.is_awaited = false;
        }
        self.give_up_if(|drag| match undone {
            Undone::Try => drag.left().is_some(),
            Undone::Drag(number) => drag.number() == Some(number),
            Undone::All => true,
            _ => false,
        });
    }

    /// Forgets the drag, if it is in such a state. Returns whether it was.
    pub(crate) fn give_up_if(&mut self, is_it: impl FnOnce(&Self) -> bool) -> bool {
        let is_given_up = is_it(self);
        if is_given_up {
            *self = Self::Nothing;
        }
        is_given_up
    }

    pub(crate) const fn number(&self) -> Option<u64> {
        match self {
            Self::Nothing => None,
            Self::Grabbing(grabbed)
            | Self::Led(Following { grabbed, .. })
            | Self::Released(Following { grabbed, .. }) => Some(grabbed.number),
            Self::Left(number, _) => Some(*number),
        }
    }
}

impl Grabbed {
    /// A place of the scene as the drag counts.
    fn place(&self, place: [f64; 2]) -> [f64; 2] {
        // In the frame of a link that is turned, places have many digits; those that nobody sees are left out.
        match self.frame {
            SCENE => place,
            pose => pose.relative(place).map(|part| rounded(part, self.tolerance)),
        }
    }
}

impl Following {
    fn is_awaited(&self) -> bool {
        self.answered != Some(self.wanted)
    }

    fn take(&mut self, led: Led) {
        self.answered = Some(led.to);
        self.refusal = match led.outcome {
            Ok((dragged, gesture)) => {
                let poses = dragged.poses.into_iter().map(|pose| pose.map(Pose::from));
                let drawing = self.grabbed.before.with_numbers(dragged.model, poses.collect());
                let before = self.stay.take();
                self.stay = Some(Box::new(Stay {
                    gesture,
                    edits: dragged.edits,
                    notes: dragged.notes.join("; "),
                    drawing,
                    preview: before.map(|before| before.preview).unwrap_or_default(),
                }));
                None
            }
            Err(refusal) => Some(refusal),
        };
    }

    fn told(&self) -> Result<String, String> {
        if let Some(refusal) = &self.refusal {
            return Err(refusal.to_string());
        }
        let [x, y] = self.pointer.map(|part| shortest(part, 1e-6));
        let items: Vec<String> = self.grabbed.items.iter().map(ToString::to_string).collect();
        let (notes, fault) = match &self.stay {
            Some(stay) => (stay.notes.as_str(), stay.preview.fault.as_deref()),
            None => ("", None),
        };
        let told = format!("{} to ({x}, {y}) {notes}", items.join(", "));
        match fault {
            Some(fault) => Err(format!("{told}: {fault}")),
            None => Ok(told),
        }
    }
}

/// The turn from one frame to another, as a direction.
fn turn(pose: Pose, other: Pose) -> [f64; 2] {
    let (x, y) = (0.0, 0.0);
    Pose { x, y, ..other }.relative([pose.cos, pose.sin])
}
