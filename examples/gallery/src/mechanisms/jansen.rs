//! A leg of Theo Jansen's beach beasts, declared as it is drawn.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// A leg of Theo Jansen's beach beasts. Its points are numbered from the crank shaft, 0, to the foot, 7.
    pub struct JansenLeg;

    link crank;
    link upper_rod;
    link upper_plate;
    link lower_rod;
    link rocker;
    link tie;
    link lower_plate { point foot = (-22.22, -91.74); }

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, upper_rod) at (9.61, 11.52);
    joint c = revolute(upper_rod, upper_plate) at (-35.24, 33.61);
    joint d = revolute(ground, upper_plate) at (-38, -7.8);
    joint e = revolute(crank, lower_rod) at (9.61, 11.52);
    joint f = revolute(lower_rod, rocker) at (-20.1, -42.79);
    joint g = revolute(ground, rocker) at (-38, -7.8);
    joint h = revolute(upper_plate, tie) at (-77.75, -2.54);
    joint i = revolute(tie, lower_plate) at (-56.05, -35.42);
    joint j = revolute(rocker, lower_plate) at (-20.1, -42.79);
    motor a;
    effects { acceleration; overlay; trace lower_plate.foot 256 color red; }
}

exhibited!(JansenLeg, "jansen-leg", "jansen.rs", motion);

/// One turn of the crank.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [-phase * T::TURN]
}
