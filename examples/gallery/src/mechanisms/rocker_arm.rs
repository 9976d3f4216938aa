//! A trunk with an arm.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// An arm of two joints on the rocker of a four-bar linkage.
    pub struct RockerArm;

    // Entries of the palette, by their names in `mech_runtime::Palette`.
    const GROUND = 1;
    const BLUE = 2;
    const ORANGE = 3;
    const TEAL = 4;
    const RED = 5;
    const PURPLE = 7;
    const SLATE = 13;
    const INK = 14;
    const EYE = 15;
    const DARKER = 16; // to be added to a link's color
    const LIGHTER = 32; // likewise
    const GROUND_DARKER = 29; // to be added to the ground's

    const CRANK = 1.1;
    const COUPLER = 4.2;
    const ROCKER = 2.4; // to the coupler
    const MAST = 4.4; // and on to the shoulder
    const UPPER_ARM = 2.2;
    const HAND = 1.3; // to the middle of the grip

    const BAR = 0.15; // half the width of a bar
    const RIM = BAR + 0.04; // the same with its dark edge
    const PIN = 0.09;

    ground {
        point crank_shaft = (0.0, 0.0);
        point rocker_shaft = (4.3, 0.0);

        // The stands of the fixed axes: for each its body, its head, and a base with hatching.
        polygon [(-0.56, -1.6), (0.56, -1.6), (0.26, 0.0), (-0.26, 0.0)] on plane 0 color GROUND;
        circle (0.0, 0.0) radius 0.256 on plane 0 color GROUND;
        polygon [
            (-0.88, -1.6), (0.88, -1.6), (0.88, -1.68), (0.82, -1.68), (0.59, -1.9), (0.5, -1.9),
            (0.72, -1.68), (0.51, -1.68), (0.29, -1.9), (0.19, -1.9), (0.41, -1.68), (0.2, -1.68),
            (-0.02, -1.9), (-0.12, -1.9), (0.11, -1.68), (-0.1, -1.68), (-0.33, -1.9),
            (-0.43, -1.9), (-0.2, -1.68), (-0.41, -1.68), (-0.63, -1.9), (-0.73, -1.9),
            (-0.51, -1.68), (-0.88, -1.68),
        ] on plane 0 color GROUND + GROUND_DARKER;
        polygon [(3.74, -1.6), (4.86, -1.6), (4.56, 0.0), (4.04, 0.0)] on plane 0 color GROUND;
        circle (4.3, 0.0) radius 0.256 on plane 0 color GROUND;
        polygon [
            (3.42, -1.6), (5.18, -1.6), (5.18, -1.68), (5.12, -1.68), (4.89, -1.9), (4.8, -1.9),
            (5.02, -1.68), (4.81, -1.68), (4.59, -1.9), (4.49, -1.9), (4.71, -1.68), (4.5, -1.68),
            (4.28, -1.9), (4.18, -1.9), (4.41, -1.68), (4.2, -1.68), (3.97, -1.9), (3.87, -1.9),
            (4.1, -1.68), (3.89, -1.68), (3.67, -1.9), (3.57, -1.9), (3.79, -1.68), (3.42, -1.68),
        ] on plane 0 color GROUND + GROUND_DARKER;
    }

    link crank {
        point shaft = (0.0, 0.0);
        point pin = (CRANK, 0.0);
        circle (0.0, 0.0) radius 0.36 on plane 3 color BLUE + DARKER;
        circle (0.0, 0.0) radius 0.32 on plane 3 color BLUE;
        circle (0.0, 0.0) radius RIM on plane 3 color BLUE + DARKER;
        circle (CRANK, 0.0) radius RIM on plane 3 color BLUE + DARKER;
        polygon [
            (0.0, -RIM), (CRANK, -RIM), (CRANK, RIM), (0.0, RIM),
        ] on plane 3 color BLUE + DARKER;
        circle (0.0, 0.0) radius BAR on plane 3 color BLUE;
        circle (CRANK, 0.0) radius BAR on plane 3 color BLUE;
        polygon [(0.0, -BAR), (CRANK, -BAR), (CRANK, BAR), (0.0, BAR)] on plane 3 color BLUE;
        circle (0.0, 0.0) radius PIN on plane 7 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 7 color EYE;
        circle (CRANK, 0.0) radius PIN on plane 7 color INK;
        circle (CRANK, 0.0) radius PIN * 0.4 on plane 7 color EYE;
    }

    link coupler {
        point crank_pin = (0.0, 0.0);
        point rocker_pin = (COUPLER, 0.0);
        circle (0.0, 0.0) radius RIM on plane 2 color TEAL + DARKER;
        circle (COUPLER, 0.0) radius RIM on plane 2 color TEAL + DARKER;
        polygon [
            (0.0, -RIM), (COUPLER, -RIM), (COUPLER, RIM), (0.0, RIM),
        ] on plane 2 color TEAL + DARKER;
        circle (0.0, 0.0) radius BAR on plane 2 color TEAL;
        circle (COUPLER, 0.0) radius BAR on plane 2 color TEAL;
        polygon [(0.0, -BAR), (COUPLER, -BAR), (COUPLER, BAR), (0.0, BAR)] on plane 2 color TEAL;
    }

    // The last link of the trunk: a rocker that goes on past the coupler, and tapers.
    link rocker {
        point shaft = (0.0, 0.0);
        point pin = (ROCKER, 0.0);
        point shoulder = (MAST, 0.0);
        circle (0.0, 0.0) radius RIM + 0.12 on plane 1 color ORANGE + DARKER;
        circle (MAST, 0.0) radius RIM on plane 1 color ORANGE + DARKER;
        polygon [(0.0, -RIM - 0.12), (MAST, -RIM), (MAST, RIM), (0.0, RIM + 0.12)] on plane 1 color ORANGE + DARKER;
        circle (0.0, 0.0) radius BAR + 0.12 on plane 1 color ORANGE;
        circle (MAST, 0.0) radius BAR on plane 1 color ORANGE;
        polygon [(0.0, -BAR - 0.12), (MAST, -BAR), (MAST, BAR), (0.0, BAR + 0.12)] on plane 1 color ORANGE;
        polygon [(0.5, -0.13), (ROCKER - 0.4, -0.1), (ROCKER - 0.4, 0.1), (0.5, 0.13)]
            on plane 1 color ORANGE + LIGHTER;
        polygon [(ROCKER + 0.4, -0.08), (MAST - 0.45, -0.06), (MAST - 0.45, 0.06), (ROCKER + 0.4, 0.08)]
            on plane 1 color ORANGE + LIGHTER;
        circle (0.0, 0.0) radius PIN on plane 7 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 7 color EYE;
        circle (ROCKER, 0.0) radius PIN on plane 7 color INK;
        circle (ROCKER, 0.0) radius PIN * 0.4 on plane 7 color EYE;
    }

    link upper_arm {
        point shoulder = (0.0, 0.0);
        point wrist = (UPPER_ARM, 0.0);
        // The shoulder's motor.
        circle (0.0, 0.0) radius 0.36 on plane 5 color SLATE + DARKER;
        circle (0.0, 0.0) radius 0.32 on plane 5 color SLATE;
        circle (0.0, 0.0) radius RIM on plane 4 color PURPLE + DARKER;
        circle (UPPER_ARM, 0.0) radius RIM on plane 4 color PURPLE + DARKER;
        polygon [
            (0.0, -RIM), (UPPER_ARM, -RIM), (UPPER_ARM, RIM), (0.0, RIM),
        ] on plane 4 color PURPLE + DARKER;
        circle (0.0, 0.0) radius BAR on plane 4 color PURPLE;
        circle (UPPER_ARM, 0.0) radius BAR on plane 4 color PURPLE;
        polygon [
            (0.0, -BAR), (UPPER_ARM, -BAR), (UPPER_ARM, BAR), (0.0, BAR),
        ] on plane 4 color PURPLE;
        circle (0.0, 0.0) radius PIN on plane 7 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 7 color EYE;
    }

    link hand {
        point wrist = (0.0, 0.0);
        point grip = (HAND, 0.0);
        // Two fingers.
        polygon [
            (0.0, -RIM), (0.75, -RIM), (0.95, -0.44), (1.5, -0.36), (1.54, -0.24), (1.04, -0.26), (0.84, 0.0),
            (1.04, 0.26), (1.54, 0.24), (1.5, 0.36), (0.95, 0.44), (0.75, RIM), (0.0, RIM),
        ] on plane 5 color RED + DARKER;
        polygon [
            (0.0, -BAR), (0.74, -BAR), (0.96, -0.4), (1.44, -0.33), (1.46, -0.28), (1.02, -0.3), (0.78, 0.0),
            (1.02, 0.3), (1.46, 0.28), (1.44, 0.33), (0.96, 0.4), (0.74, BAR), (0.0, BAR),
        ] on plane 5 color RED;
        // The wrist's motor.
        circle (0.0, 0.0) radius 0.3 on plane 6 color SLATE + DARKER;
        circle (0.0, 0.0) radius 0.26 on plane 6 color SLATE;
        circle (0.0, 0.0) radius PIN on plane 7 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 7 color EYE;
    }

    // The trunk.
    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, coupler.crank_pin);
    joint c = revolute(coupler.rocker_pin, rocker.pin);
    joint d = revolute(ground.rocker_shaft, rocker.shaft);
    // The arm.
    joint shoulder = revolute(rocker.shoulder, upper_arm.shoulder);
    joint wrist = revolute(upper_arm.wrist, hand.wrist);

    motor a;
    motor shoulder;
    motor wrist;
    start { a = 0 deg; shoulder = -80 deg; wrist = -30 deg; rocker near 110 deg; }
    effects { acceleration; overlay; }
}

exhibited!(
    RockerArm,
    "rocker-arm",
    include_str!("rocker_arm.rs"),
    motion
);

/// One turn of the crank, while the arm reaches out once and the hand nods twice.
fn motion<T: Real>(phase: T) -> [T; 3] {
    let turn = phase * T::TURN;
    let (reach, _) = Real::sin_cos(turn + T::from_f64(0.6));
    let (_, nod) = Real::sin_cos(turn + turn);
    [
        turn,
        T::from_f64(-1.35) + T::from_f64(0.55) * reach,
        T::from_f64(-0.45) + T::from_f64(0.6) * nod,
    ]
}
