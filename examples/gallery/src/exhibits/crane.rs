//! A double rocker: a mechanism that has limits.

use crate::crane::LuffingCrane;
use crate::{Exhibit, Showcase};

/// The jib is let down and hauled in once.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Showcase::<LuffingCrane> {
        title: "Level-luffing crane",
        caption: "A double rocker: neither jib nor tie can turn all the way round. Jib, tie and \
                  nose are made such that the tip, and the load below it, stay at one height while \
                  the jib is hauled in, so that luffing takes no work. Beyond the motion that is \
                  shown lie limits: let down to 28°, tie and nose are in one line, and \
                  the loop does not close any farther. Whoever drives the crane there is told so.",
        still: 0.6,
        ..Showcase::untitled()
    })
}
