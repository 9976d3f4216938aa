//! An excavator with three cylinders.

use crate::excavator::Excavator;
use crate::{Exhibit, Showcase};

/// The bucket reaches out, digs, lifts and empties.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Showcase::<Excavator> {
        title: "Excavator",
        caption: "Three cylinders, each a part of the library, move boom, stick and bucket. Each motor \
                  has a range, the stroke of its cylinder, and the compiler has proved that all \
                  strokes are free in any combination, so that `move_within` cannot fail. A \
                  four-bar between the last cylinder and the bucket lets it turn by more than a lever \
                  could.",
        frames: 150,
        still: 0.1,
        ..Showcase::untitled()
    })
}
