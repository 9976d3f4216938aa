//! What a repair would make of the mechanism, seen before it is made.

use super::drawing::Drawing;
use super::snapshot::Snapshot;
use crate::document::{Document, Source};
use crate::mend::Mending;
use std::path::Path;

/// What a repair would make of the mechanism.
pub(crate) struct Ghost {
    /// The number of the repair, from 1.
    pub(crate) number: usize,
    /// How the mechanism would be drawn.
    pub(crate) drawing: Drawing,
}

impl Ghost {
    /// What a repair would make of the mechanism with this number in a file; none if it has no text.
    pub(crate) fn of(
        number: usize,
        mending: &Mending,
        path: &Path,
        index: usize,
        before: Option<&Drawing>,
    ) -> Option<Self> {
        let text = mending.text.as_deref()?;
        let snapshot = Snapshot::of(Document::of(Source::new(path, text)), index);
        let drawing = snapshot.drawing(before, false)?;
        Some(Self { number, drawing })
    }
}
