//! An excavator with three cylinders.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// An excavator on its tracks: three cylinders move boom, stick and bucket, each through its whole stroke, in any order.
    pub struct Excavator;
    look machine;
    use mech_runtime::parts::Cylinder;

    ground {
        point boom_foot = (0.5, 1.9);
        polygon [(-2.3, 0.35), (-1.9, 0), (2.1, 0), (2.5, 0.35), (2.1, 0.85), (-1.9, 0.85)] color ink;
        circle (-1.85, 0.42) radius 0.3 color steel; circle (2.05, 0.42) radius 0.3 color steel;
        polygon [(-0.6, 0.85), (0.8, 0.85), (0.8, 1.05), (-0.6, 1.05)] color ground dark;
        polygon [(-2.5, 1.05), (1.5, 1.05), (1.5, 1.5), (0.2, 2.1), (-2.3, 2.1), (-2.5, 1.8)] color yellow dark;
        polygon [(-1.1, 2.1), (-1, 3.4), (0.1, 3.4), (0.35, 2.1)] color yellow;
        polygon [(-0.85, 2.35), (-0.8, 3.2), (0, 3.2), (0.15, 2.35)] color sky light;
        rail [(-4.5, 0), (9.5, 0)] width 0.4;
    }
    link boom {
        point foot = (0, 0); point tip = (5.6, 0);
        polygon [(-0.25, -0.2), (0.2, -0.25), (2.4, 0.15), (5.7, -0.2), (5.85, 0.1), (2.4, 1.15), (1.8, 1.05), (-0.2, 0.2)] on plane 2 color yellow;
    }
    link stick {
        point elbow = (0, 0); point lever = (2.4, 0.02); point wrist = (2.9, 0);
        polygon [(-1.05, -0.5), (-0.75, -0.5), (0.1, -0.3), (3.05, -0.12), (3.05, 0.12), (0.4, 0.5), (0.1, 0.45)] on plane 1 color yellow;
    }
    link lever { point pivot = (0, 0); point end = (0.6, 0); }
    link tie { point end = (0, 0); point ear = (0.62, 0); }
    link bucket {
        point wrist = (0, 0); point ear = (-0.05, 0.4); point teeth = (1.3, -0.15);
        polygon [(-0.2, -0.15), (-0.2, 0.5), (0.1, 0.62), (0.55, 0.75), (1, 0.5), (1.3, -0.15), (1.05, 0), (0.9, -0.1)] on plane 0 color steel dark;
    }

    joint shoulder = revolute(ground.boom_foot, boom.foot);
    joint elbow = revolute(boom.tip, stick.elbow);
    joint wrist = revolute(stick.wrist, bucket.wrist);
    joint hinge = revolute(stick.lever, lever.pivot);
    joint knuckle = revolute(lever.end, tie.end);
    joint ear = revolute(tie.ear, bucket.ear);
    use lift: Cylinder { base = ground at (1.15, 1.35), load = boom at (2.3, 0.35) };
    use crowd: Cylinder { base = boom at (2.1, 0.95), load = stick at (-0.85, -0.35) };
    use curl: Cylinder { base = stick at (0.35, 0.35), load = lever at (0.6, 0) };
    motor lift.stroke in 1.65 ..= 2.65;
    motor crowd.stroke in 2.75 ..= 3.95;
    motor curl.stroke in 1.75 ..= 2.5;
    start {
        lift.stroke = 2.404; crowd.stroke = 2.8; curl.stroke = 1.934;
        boom near 36 deg; stick near -43 deg; lever near 60 deg; bucket near -45 deg;
    }
    effects { acceleration; overlay; trace bucket.teeth 360 on plane 20 color red; }
}

exhibited!(Excavator, "excavator", "excavator.rs", motion);

/// The bucket reaches out, digs, lifts and empties.
fn motion<T: Real>(phase: T) -> [T; 3] {
    let around = |part: f64| Real::sin_cos(phase * T::TURN + T::from_f64(part)).0;
    let stroke =
        |middle: f64, half: f64, part: f64| T::from_f64(middle) + T::from_f64(half) * around(part);
    [stroke(2.05, 0.38, 1.2), stroke(3.3, 0.5, -1.6), stroke(2.12, 0.36, -2.6)]
}
