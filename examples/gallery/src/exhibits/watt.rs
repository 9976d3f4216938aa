//! A six-bar linkage, declared as in a drawing.

use crate::watt::Watt;
use crate::{Exhibit, Showcase};

/// One turn of the crank.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Showcase::<Watt> {
        title: "Watt’s six-bar linkage",
        caption: "Two four-bar loops in a row. In the first, crank and coupler rock the bell \
                  crank, a ternary link; in the second, the bell crank rocks the rocker on the \
                  right through a connecting rod. The second loop waits for the first, and \
                  together they swing the rocker through 138°, much farther than a single four-bar \
                  could at such good transmission angles. Windscreen wipers are made this way. The \
                  links are declared as they are drawn, in the coordinates of the scene.",
        ..Showcase::untitled()
    })
}
