//! Figure 1 of the paper: a piston driven through a pair of gears.

use crate::geared_piston::GearedPiston;
use crate::{Exhibit, Showcase};

/// Two turns of the pinion are one of the wheel.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Showcase::<GearedPiston> {
        title: "Piston driven through gears",
        caption: "The mechanism of the paper’s first figure. The motor turns the pinion of 20 \
                  teeth; the wheel of 40 turns the other way at half the speed, which is worked \
                  out in whole numbers at compile time. A crank pin on the wheel, a connecting rod \
                  and the piston in its bore make a slider-crank: one loop of three revolutes and \
                  a prismatic, solved once the gear has told it where the wheel is.",
        frames: 144,
        still: 0.08,
        ..Showcase::untitled()
    })
}
