//! A leg of Theo Jansen's beach beasts, declared as it is drawn.

use crate::jansen::JansenLeg;
use crate::{Exhibit, Showcase};

/// One turn of the crank.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Showcase::<JansenLeg> {
        title: "Jansen’s leg",
        caption: "A leg of the beasts that walk on Dutch beaches. The crank drives two dyads at \
                  once, upper rod and upper plate, lower rod and rocker: two loops that need \
                  nothing but the motor. A third, tie and lower plate, hangs between them and \
                  needs both. The two plates are ternary links, each a dyad that was made rigid, \
                  so that the points of the leg are a chain of five dyads. The foot goes straight \
                  along the sand for half a turn and comes back through the air; the dots show it \
                  at every ten degrees of the crank.",
        ..Showcase::untitled()
    })
}
