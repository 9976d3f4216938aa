//! A double rocker: a mechanism that has limits.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// A level-luffing crane: jib and tie rock, and the tip of the nose between them goes to and fro at one height.
    pub struct LuffingCrane;
    look machine;

    const BACK = 1.5; // of the nose, behind the head of the jib
    const NOSE = 6.3; // its whole length

    ground {
        point jib_foot = (0.0, 0.0);
        point tie_foot = (-2.2, 2.5);
        // The house of the crane with its window, on a turntable on the quay.
        polygon [(-3.6, -1.2), (0.7, -1.2), (0.4, 0.3), (-0.6, 0.4), (-1.9, 2.8), (-2.5, 2.8), (-3.6, 0.6)];
        polygon [(-3.1, -0.6), (-1.6, -0.6), (-1.6, 0.4), (-3.1, 0.4)] color ground light;
        polygon [(-3.0, -1.7), (0.2, -1.7), (0.2, -1.2), (-3.0, -1.2)] color ground dark;
        rail [(-4.4, -1.7), (3.0, -1.7)] width 0.6;
    }
    link jib { point foot = (0.0, 0.0); point head = (7.4, 0.0); }
    link tie { point foot = (0.0, 0.0); point end = (7.3, 0.0); }
    link nose { point back = (0.0, 0.0); point head = (BACK, 0.0); point tip = (NOSE, 0.0); }

    joint luff = revolute(ground.jib_foot, jib.foot);
    joint swing = revolute(ground.tie_foot, tie.foot);
    joint head = revolute(jib.head, nose.head);
    joint back = revolute(tie.end, nose.back);
    motor luff;
    start { luff = 55 deg; nose near -53 deg; }
    effects { acceleration; overlay; trace nose.tip 720 on plane 5 color red; }
}

exhibited!(LuffingCrane, "luffing-crane", "crane.rs", motion);

/// The jib is let down and hauled in once.
fn motion<T: Real>(phase: T) -> [T; 1] {
    let (sin, _) = Real::sin_cos(phase * T::TURN);
    [T::from_f64(0.96) + T::from_f64(0.32) * sin]
}
