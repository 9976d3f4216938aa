//! A trunk with an arm.

use crate::rocker_arm::RockerArm;
use crate::{Exhibit, Showcase};

/// One turn of the crank, while the arm reaches out once and the hand nods twice.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Showcase::<RockerArm> {
        title: "Arm on a rocker",
        caption: "Trunk and arm together. The trunk is a four-bar loop of crank, coupler and \
                  rocker, driven by one motor. Its rocker carries an arm, an open chain of two \
                  revolutes, the shoulder and the wrist, with two arm motors. An arm takes no part \
                  in any loop: its joints are simply put one after the other, and nothing in the \
                  trunk depends on them. So there are three motors for a mobility of 3.",
        frames: 120,
        still: 0.1,
        ..Showcase::untitled()
    })
}
