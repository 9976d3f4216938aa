//! The items that are held during a drag.

use super::Text;
use crate::edit::{Command, Drag, Dragged, Follower, Refusal};
use crate::editor::Gesture;
use crate::editor::range::Path;
use crate::editor::snapshot::Snapshot;
use crate::play::{Derived, Mechanism};
use std::collections::BTreeSet;
use std::sync::Arc;

/// The item to be held, and its followers.
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(in crate::editor) struct Hold {
    /// Which of all drags it is for.
    pub(in crate::editor) number: u64,
    /// The path of the dragged item in the language.
    pub(in crate::editor) path: String,
    /// The values of motors at which it is seen, in degrees or scene units; none for the start.
    pub(in crate::editor) pose: Option<Vec<(String, f64)>>,
    /// Where it is at the beginning, as the drag counts.
    pub(in crate::editor) from: [f64; 2],
    pub(in crate::editor) followers: Vec<Follower>,
}

/// The text in which something is held.
pub(in crate::editor) enum Held {
    Known(Arc<Snapshot>),
    /// One of which nothing is known yet.
    Text(Text),
}

#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(in crate::editor) struct Led {
    /// Which of all drags it was.
    pub(in crate::editor) number: u64,
    /// The place, as the drag counts.
    pub(in crate::editor) to: [f64; 2],
    /// The drag at the place, and the gesture that leaves it there; or why it cannot go there.
    pub(in crate::editor) outcome: Result<(Dragged, Gesture), Refusal>,
}

impl Hold {
    pub(super) fn begin(self, text: &Held) -> Result<Drag, Refusal> {
        let Self { path, pose, from, followers, .. } = self;
        let known = match text {
            Held::Known(snapshot) => snapshot.known(),
            Held::Text(..) => None,
        };
        let drag = match (known, text) {
            (Some(known), _) => Drag::begin_known(known, &path, pose),
            (None, Held::Known(snapshot)) => {
                Drag::begin(&snapshot.document, snapshot.index, &path, pose)
            }
            (None, Held::Text(text)) => Drag::begin(&text.document, text.index, &path, pose),
        };
        drag?.with(from, followers)
    }
}

impl Led {
    /// Leads what is held to a place.
    pub(super) fn of(number: u64, drag: &Drag, to: [f64; 2]) -> Self {
        let commands = drag.commands(to);
        let title = commands.first().map(Command::title).unwrap_or_default();
        let gesture = Gesture::new(title, commands);
        let outcome = drag.move_to(to).map(|dragged| (dragged, gesture));
        Self { number, to, outcome }
    }
}

/// The compiler's findings on a text while something is dragged: only those that the window shows, which would have to free the others.
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(in crate::editor) struct Previewed {
    /// Which of all drags it is of.
    pub(in crate::editor) number: u64,
    pub(in crate::editor) fault: Option<String>,
    /// The mechanism with its bodies, if these are wanted and it moves.
    pub(in crate::editor) mechanism: Option<Mechanism>,
    /// The whole paths of its traced points.
    pub(in crate::editor) paths: Vec<Path>,
}

impl Previewed {
    /// Reads a text. Bodies may be wanted, with arrows that need something besides positions.
    pub(super) fn of(number: u64, text: Text, has_bodies: bool, needs: &BTreeSet<Derived>) -> Self {
        let snapshot = Snapshot::of(text.document, text.index);
        let first = snapshot.messages().first();
        let fault = first.and_then(|message| message.text.lines().next());
        let fault = fault.map(ToOwned::to_owned);
        let played = has_bodies.then(|| snapshot.played()).flatten();
        let (mechanism, paths) = match played.and_then(Result::ok) {
            Some((mut mechanism, _, paths)) => {
                for what in needs {
                    mechanism.prepare(*what);
                }
                (Some(mechanism), paths)
            }
            None => (None, snapshot.paths()),
        };
        Self { number, fault, mechanism, paths }
    }
}
