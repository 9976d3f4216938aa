//! The four-bar linkage in its most common form.

use crate::four_bar::CrankRocker;
use crate::{Exhibit, Showcase};

/// One turn of the crank.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Showcase::<CrankRocker> {
        title: "Four-bar linkage",
        caption: "The crank is the shortest bar, and with the longest it is shorter than the other \
                  two together: by Grashof’s rule it turns all the way round while the rocker \
                  swings to and fro. The coupler between them is a plate, and its red point runs \
                  along a coupler curve; the dots show it at every ten degrees of the crank. One \
                  loop of four revolutes, of which one has the motor.",
        still: 0.1,
        ..Showcase::untitled()
    })
}
