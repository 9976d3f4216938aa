//! A beach beast on twelve of Theo Jansen’s legs.

use crate::walker::Walker;
use crate::{Exhibit, Showcase};

/// One turn of the axle.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Showcase::<Walker> {
        title: "Walker on twelve legs",
        caption: "Twelve of Theo Jansen’s legs on one axle: six to the left, and six mirrored ones to \
                  the right, whose pins are evenly spaced. The leg is a part of the library, used \
                  twelve times. The report says once what all of them have alike. They are computed \
                  side by side, by one function. The lines are the paths of two feet; the beast is \
                  seen by somebody who walks beside it.",
        frames: 90,
        still: 0.08,
        ..Showcase::untitled()
    })
}
