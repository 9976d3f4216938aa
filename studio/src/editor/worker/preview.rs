//! The preview while something is dragged.

use super::Text;
use crate::editor::path::Path;
use crate::editor::snapshot::Snapshot;
use crate::play::{Derived, Mechanism};
use std::collections::BTreeSet;

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
        Self {
            number,
            fault,
            mechanism,
            paths,
        }
    }
}
