//! Andrews' squeezing mechanism, a test of the literature on differential-algebraic equations.

use crate::andrews::AndrewsSqueezer;
use crate::{Exhibit, Showcase};

/// One turn of the crank.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Showcase::<AndrewsSqueezer> {
        title: "Andrews’ squeezing mechanism",
        caption: "A test of solvers since 1978: seven bodies, drawn to scale, a few centimetres in \
                  size. The crank K1 moves K2, whose far end is pinned to the ternary plate K3: \
                  the first loop. In the same pin E hang the dyads K4, K5 and K6, K7, both held at \
                  the left: a loop each, which need the first but not one another. Four bodies \
                  meet in E, and that counts as three revolutes; so 3 × 7 − 2 × 10 = 1, and one \
                  motor moves it all. The anchor at the upper right is where the spring of K3 ends \
                  in the original.",
        still: 0.2,
        ..Showcase::untitled()
    })
}
