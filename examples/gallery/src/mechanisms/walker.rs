//! A beach beast on twelve of Theo Jansen's legs.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// Six legs to the left of the axle and six mirrored ones to the right.
    pub struct Walker;
    look machine;
    use mech_runtime::parts::JansenLeg;

    ground {
        point shaft = (0, 0);
        polygon [(-52, -14), (52, -14), (46, 14), (-46, 14)] on plane -1 color ground;
        circle (0, 0) radius 26 on plane -1 color ground dark;
        rail [(-130, -94), (130, -94)] width 6;
    }
    link axle { point shaft = (0, 0); }
    joint main = revolute(ground.shaft, axle.shaft);
    motor main;
    use left[6]: JansenLeg(phase = k * 60 deg) { frame = ground, crank = axle };
    use right[6]: JansenLeg(phase = k * 60 deg) mirrored { frame = ground, crank = axle };
    effects { trace left[0].foot.tip 720 color red; trace right[0].foot.tip 720 color blue; }
}

exhibited!(Walker, "walker", "walker.rs", motion);

/// One turn of the axle.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [phase * T::TURN]
}
