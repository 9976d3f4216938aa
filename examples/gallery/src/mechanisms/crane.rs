//! A double rocker: a mechanism that has limits.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// A level-luffing crane: jib and tie rock, and the tip of the nose between them goes to and fro at one height.
    pub struct LuffingCrane;

    // Entries of the palette, by their names in `mech_runtime::Palette`.
    const GROUND = 1;
    const BLUE = 2;
    const ORANGE = 3;
    const TEAL = 4;
    const RED = 5;
    const INK = 14;
    const EYE = 15;
    const DARKER = 16; // to be added to a link's color
    const GROUND_DARKER = 29; // to be added to the ground's
    const GROUND_LIGHTER = 30; // likewise

    const JIB = 7.4;
    const TIE = 7.3;
    const BACK = 1.5; // of the nose, behind the head of the jib
    const NOSE = 6.3; // its whole length

    const BAR = 0.16; // half the width of a bar
    const RIM = BAR + 0.06; // the same with its dark edge
    const PIN = 0.13;

    ground {
        point jib_foot = (0.0, 0.0);
        point tie_foot = (-2.2, 2.5);

        // The house of the crane on its turntable, with a window.
        polygon [
            (-3.6, -1.2), (0.7, -1.2), (0.4, 0.3), (-0.6, 0.4), (-1.9, 2.8), (-2.5, 2.8), (-3.6, 0.6),
        ] on plane 0 color GROUND + GROUND_DARKER;
        polygon [
            (-3.48, -1.08), (0.56, -1.08), (0.3, 0.19), (-0.67, 0.29), (-1.97, 2.68), (-2.43, 2.68), (-3.48, 0.57),
        ] on plane 0 color GROUND;
        polygon [(-3.1, -0.6), (-1.6, -0.6), (-1.6, 0.4), (-3.1, 0.4)] on plane 0 color GROUND + GROUND_LIGHTER;
        polygon [(-3.0, -1.7), (0.2, -1.7), (0.2, -1.2), (-3.0, -1.2)] on plane 0 color GROUND + GROUND_DARKER;
        // The quay.
        polygon [(-4.4, -2.3), (3.0, -2.3), (3.0, -1.7), (-4.4, -1.7)] on plane 0 color GROUND + GROUND_LIGHTER;
    }

    link jib {
        point foot = (0.0, 0.0);
        point head = (JIB, 0.0);
        circle (0.0, 0.0) radius RIM + 0.12 on plane 2 color BLUE + DARKER;
        circle (JIB, 0.0) radius RIM on plane 2 color BLUE + DARKER;
        polygon [(0.0, -RIM - 0.12), (JIB, -RIM), (JIB, RIM), (0.0, RIM + 0.12)] on plane 2 color BLUE + DARKER;
        circle (0.0, 0.0) radius BAR + 0.12 on plane 2 color BLUE;
        circle (JIB, 0.0) radius BAR on plane 2 color BLUE;
        polygon [(0.0, -BAR - 0.12), (JIB, -BAR), (JIB, BAR), (0.0, BAR + 0.12)] on plane 2 color BLUE;
        circle (0.0, 0.0) radius PIN on plane 4 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 4 color EYE;
        circle (JIB, 0.0) radius PIN on plane 4 color INK;
        circle (JIB, 0.0) radius PIN * 0.4 on plane 4 color EYE;
    }

    link tie {
        point foot = (0.0, 0.0);
        point end = (TIE, 0.0);
        circle (0.0, 0.0) radius RIM on plane 1 color TEAL + DARKER;
        circle (TIE, 0.0) radius RIM on plane 1 color TEAL + DARKER;
        polygon [(0.0, -RIM), (TIE, -RIM), (TIE, RIM), (0.0, RIM)] on plane 1 color TEAL + DARKER;
        circle (0.0, 0.0) radius BAR on plane 1 color TEAL;
        circle (TIE, 0.0) radius BAR on plane 1 color TEAL;
        polygon [(0.0, -BAR), (TIE, -BAR), (TIE, BAR), (0.0, BAR)] on plane 1 color TEAL;
        circle (0.0, 0.0) radius PIN on plane 4 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 4 color EYE;
        circle (TIE, 0.0) radius PIN on plane 4 color INK;
        circle (TIE, 0.0) radius PIN * 0.4 on plane 4 color EYE;
    }

    link nose {
        point back = (0.0, 0.0);
        point head = (BACK, 0.0);
        point tip = (NOSE, 0.0);
        polygon [
            (-0.1, -RIM), (NOSE, -RIM), (NOSE, RIM), (BACK, 0.62), (-0.1, RIM),
        ] on plane 3 color ORANGE + DARKER;
        circle (0.0, 0.0) radius RIM on plane 3 color ORANGE + DARKER;
        circle (NOSE, 0.0) radius 0.36 on plane 3 color ORANGE + DARKER;
        polygon [
            (-0.1, -BAR), (NOSE, -BAR), (NOSE, BAR), (BACK, 0.54), (-0.1, BAR),
        ] on plane 3 color ORANGE;
        circle (0.0, 0.0) radius BAR on plane 3 color ORANGE;
        circle (NOSE, 0.0) radius 0.3 on plane 3 color ORANGE;
        circle (NOSE, 0.0) radius PIN on plane 4 color RED;
    }

    joint luff = revolute(ground.jib_foot, jib.foot);
    joint swing = revolute(ground.tie_foot, tie.foot);
    joint head = revolute(jib.head, nose.head);
    joint back = revolute(tie.end, nose.back);

    motor luff;
    start { luff = 55 deg; nose near -53 deg; }
    effects { acceleration; overlay; trace nose.tip 720 on plane 5 color RED; }
}

exhibited!(
    LuffingCrane,
    "luffing-crane",
    include_str!("crane.rs"),
    motion
);

/// The jib is let down and hauled in once.
fn motion<T: Real>(phase: T) -> [T; 1] {
    let (sin, _) = Real::sin_cos(phase * T::TURN);
    [T::from_f64(0.96) + T::from_f64(0.32) * sin]
}
