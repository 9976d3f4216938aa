//! The skeleton of the paper’s introduction.

use crate::skeleton::Skeleton;
use crate::{Exhibit, Showcase};

/// Two strides forwards, and back.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Showcase::<Skeleton> {
        title: "Skeleton",
        caption: "“A human skeleton has nearly 200 degrees of freedom”, says the paper, so that moving \
                  it by brute force would take 200 motors. This figure in profile has 232, and eight \
                  motors: one for the way, three for hip, knee and ankle of each leg, one for the \
                  arms. Gears on every joint hand on a part of what the bone before does, from the hip \
                  up the spine to the jaw, and from the shoulder to the finger tips; a cam lets the \
                  body rise and fall. Spine, ribs, fingers and toes are one part of three bones, used \
                  36 times.",
        frames: 240,
        still: 0.3,
        ..Showcase::untitled()
    })
}
