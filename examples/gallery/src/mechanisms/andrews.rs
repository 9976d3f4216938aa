//! Andrews' squeezing mechanism, a test of the literature on differential-algebraic equations.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// Andrews' squeezing mechanism: seven bodies, three loops, lengths in metres.
    ///
    /// The bodies are numbered as in Hairer & Wanner, *Solving Ordinary Differential Equations II*, section VII.7, and
    /// joints are named after the seven coordinates there. A link's own x axis lies such that the joint's coordinate
    /// is the one of that name, sign and zero included.
    pub struct AndrewsSqueezer;

    // Lengths in metres, by their names there.
    const RR = 0.007; const D = 0.028; const SS = 0.035; const SC = 0.018; const SD = 0.02;
    const E = 0.02; const ZT = 0.04; const ZF = 0.02; const U = 0.04;
    ground {
        point a = (-0.06934, -0.00227);
        point b = (-0.03635, 0.03273);
        point c = (0.014, 0.072); // where the spring of K3 is anchored
        point o = (0.0, 0.0);
    }
    link k1 { point o = (0.0, 0.0); point tip = (RR, 0.0); }
    link k2 { point tip = (0.0, 0.0); point e = (-D, 0.0); }
    link k3 { point b = (0.0, 0.0); point e = (0.0, -SS); point d = (SD, -SC); }
    link k4 { point tip = (0.0, 0.0); point e = (0.0, -E); }
    link k5 { point a = (0.0, 0.0); point tip = (ZT, 0.0); }
    link k6 { point tip = (0.0, 0.0); point e = (ZF, 0.0); }
    link k7 { point a = (0.0, 0.0); point tip = (0.0, -U); }
    joint beta = revolute(ground.o, k1.o);
    joint theta = revolute(k1.tip, k2.tip);
    joint gamma = revolute(ground.b, k3.b);
    joint delta = revolute(ground.a, k5.a);
    joint phi = revolute(k5.tip, k4.tip);
    joint epsilon = revolute(ground.a, k7.a);
    joint omega = revolute(k7.tip, k6.tip);
    // Four bodies meet in E: three pairs.
    joint e2 = revolute(k3.e, k2.e);
    joint e4 = revolute(k3.e, k4.e);
    joint e6 = revolute(k3.e, k6.e);
    spring pull = linear(ground.c, k3.d) stiffness 4530 rest 0.07785;
    motor beta;
    start { beta = -0.061713890014276; k3 near 0.4553; k5 near 0.4874; k7 near 1.2305; }
    effects { acceleration; overlay; }
}

exhibited!(AndrewsSqueezer, "andrews-squeezer", "andrews.rs", motion);

/// One turn of the crank.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [phase * T::TURN - T::from_f64(0.061_713_890_014_276)]
}
