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
    /// What a repair would make of the mechanism with this number in a file; none if nothing can be drawn of it.
    pub(crate) fn of(
        number: usize,
        mending: &Mending,
        path: &Path,
        index: usize,
        before: Option<&Drawing>,
    ) -> Option<Self> {
        let snapshot = Snapshot::of(Document::of(Source::new(path, &*mending.text)), index);
        let drawing = snapshot.drawing(before, false)?;
        Some(Self { number, drawing })
    }
}
