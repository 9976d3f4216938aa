//! A trunk with an arm.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// An arm of two joints on the rocker of a four-bar linkage.
    pub struct RockerArm;
    look machine;

    const MAST = 4.4; // of the rocker, on past the coupler to the shoulder
    const UPPER_ARM = 2.2;
    const HAND = 1.3; // to the middle of the grip

    ground {
        point crank_shaft = (0.0, 0.0);
        point rocker_shaft = (4.3, 0.0);
        stand (0.0, 0.0);
        stand (4.3, 0.0);
    }
    link crank { point shaft = (0.0, 0.0); point pin = (1.1, 0.0); }
    link coupler { point crank_pin = (0.0, 0.0); point rocker_pin = (4.2, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.4, 0.0); point shoulder = (MAST, 0.0); }
    link upper_arm { point shoulder = (0.0, 0.0); point wrist = (UPPER_ARM, 0.0); }
    link hand {
        point wrist = (0.0, 0.0);
        point grip = (HAND, 0.0);
        polygon [(0.5, -0.1), (0.8, -0.5), (1.5, -0.42), (1.5, -0.3), (0.9, -0.3), (0.7, 0.0), (0.9, 0.3), (1.5, 0.3), (1.5, 0.42), (0.8, 0.5), (0.5, 0.1)] on plane 40 color slate;
        bar [(0.0, 0.0), (0.6, 0.0)] width 0.3 on plane 40 color red;
    }

    // The trunk.
    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, coupler.crank_pin);
    joint c = revolute(coupler.rocker_pin, rocker.pin);
    joint d = revolute(ground.rocker_shaft, rocker.shaft);
    // The arm.
    joint shoulder = revolute(rocker.shoulder, upper_arm.shoulder);
    joint wrist = revolute(upper_arm.wrist, hand.wrist);
    motor a; motor shoulder; motor wrist;
    start { a = 0 deg; shoulder = -80 deg; wrist = -30 deg; rocker near 110 deg; }
    effects { acceleration; overlay; }
}

exhibited!(RockerArm, "rocker-arm", "rocker_arm.rs", motion);

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
