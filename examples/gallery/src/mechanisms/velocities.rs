//! The four-bar linkage as a textbook draws it: the diagram, the path of its coupler point, velocities.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// A crank-rocker, with the path and the velocities of its points.
    pub struct CouplerCurve;

    const PALE_ORANGE = 93; // `Palette::shade(Palette::ORANGE, 13)`
    const RED = 5; // `Palette::RED`

    ground { point crank_shaft = (0, 0); point rocker_shaft = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler {
        point crank_pin = (0, 0);
        point rocker_pin = (3.5, 0);
        point tracer = (1.5, 1.75);
        polygon [(0, 0), (3.5, 0), (1.5, 1.75)] on plane 1 color PALE_ORANGE;
    }
    link rocker { point shaft = (0, 0); point pin = (3, 0); }

    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, coupler.crank_pin);
    joint c = revolute(coupler.rocker_pin, rocker.pin);
    joint d = revolute(ground.rocker_shaft, rocker.shaft);

    motor a;
    start { coupler near 50 deg; }
    look none;
    effects { acceleration; overlay; trace coupler.tracer 720 color RED; }
}

exhibited!(CouplerCurve, "four-bar-velocities", "velocities.rs", motion);

/// The trace is that of one turn: after it, every new place is one that it was at before.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [phase * T::TURN]
}
