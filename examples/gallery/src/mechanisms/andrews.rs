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

    // Entries of the palette, by their names in `mech_runtime::Palette`.
    const GROUND = 1;
    const BLUE = 2;
    const ORANGE = 3;
    const TEAL = 4;
    const RED = 5;
    const YELLOW = 6;
    const PINK = 9;
    const SLATE = 13;
    const INK = 14;
    const EYE = 15;
    const DARKER = 16; // to be added to a link's color
    const LIGHTER = 32; // likewise
    const GROUND_DARKER = 29; // to be added to the ground's

    // Lengths in metres, by their names there.
    const RR = 0.007;
    const D = 0.028;
    const SS = 0.035;
    const SC = 0.018;
    const SD = 0.02;
    const E = 0.02;
    const ZT = 0.04;
    const ZF = 0.02;
    const U = 0.04;

    const BAR = 0.0017; // half the width of a bar
    const RIM = BAR + 0.0004; // the same with its dark edge
    const PIN = 0.001;

    ground {
        point a = (-0.06934, -0.00227);
        point b = (-0.03635, 0.03273);
        point c = (0.014, 0.072); // where the spring of K3 is anchored; a mechanism has no springs yet
        point o = (0.0, 0.0);

        // The stands of the fixed axes: for each its body, its head, and a base with hatching.
        polygon [
            (-0.0746, -0.0183), (-0.0641, -0.0183), (-0.0669, -0.0023), (-0.0717, -0.0023),
        ] on plane 0 color GROUND;
        circle (-0.0693, -0.0023) radius 0.0024 on plane 0 color GROUND;
        polygon [
            (-0.0776, -0.0183), (-0.0611, -0.0183), (-0.0611, -0.019), (-0.0617, -0.019),
            (-0.0638, -0.0211), (-0.0647, -0.0211), (-0.0626, -0.019), (-0.0645, -0.019),
            (-0.0666, -0.0211), (-0.0676, -0.0211), (-0.0655, -0.019), (-0.0674, -0.019),
            (-0.0695, -0.0211), (-0.0704, -0.0211), (-0.0683, -0.019), (-0.0703, -0.019),
            (-0.0724, -0.0211), (-0.0733, -0.0211), (-0.0712, -0.019), (-0.0732, -0.019),
            (-0.0753, -0.0211), (-0.0762, -0.0211), (-0.0741, -0.019), (-0.0776, -0.019),
        ] on plane 0 color GROUND + GROUND_DARKER;
        polygon [
            (-0.0416, 0.0457), (-0.0311, 0.0457), (-0.034, 0.0327), (-0.0387, 0.0327),
        ] on plane 0 color GROUND;
        circle (-0.0364, 0.0327) radius 0.0024 on plane 0 color GROUND;
        polygon [
            (-0.0446, 0.0457), (-0.0281, 0.0457), (-0.0281, 0.0465), (-0.0287, 0.0465),
            (-0.0308, 0.0486), (-0.0317, 0.0486), (-0.0296, 0.0465), (-0.0316, 0.0465),
            (-0.0337, 0.0486), (-0.0346, 0.0486), (-0.0325, 0.0465), (-0.0344, 0.0465),
            (-0.0365, 0.0486), (-0.0375, 0.0486), (-0.0354, 0.0465), (-0.0373, 0.0465),
            (-0.0394, 0.0486), (-0.0403, 0.0486), (-0.0382, 0.0465), (-0.0402, 0.0465),
            (-0.0423, 0.0486), (-0.0432, 0.0486), (-0.0411, 0.0465), (-0.0446, 0.0465),
        ] on plane 0 color GROUND + GROUND_DARKER;
        polygon [
            (-0.0052, -0.0183), (0.0052, -0.0183), (0.0024, 0.0), (-0.0024, 0.0),
        ] on plane 0 color GROUND;
        circle (0.0, 0.0) radius 0.0024 on plane 0 color GROUND;
        polygon [
            (-0.0083, -0.0183), (0.0083, -0.0183), (0.0083, -0.0191), (0.0077, -0.0191),
            (0.0056, -0.0212), (0.0046, -0.0212), (0.0067, -0.0191), (0.0048, -0.0191),
            (0.0027, -0.0212), (0.0018, -0.0212), (0.0039, -0.0191), (0.0019, -0.0191),
            (-0.0002, -0.0212), (-0.0011, -0.0212), (0.001, -0.0191), (-0.001, -0.0191),
            (-0.0031, -0.0212), (-0.004, -0.0212), (-0.0019, -0.0191), (-0.0038, -0.0191),
            (-0.0059, -0.0212), (-0.0069, -0.0212), (-0.0048, -0.0191), (-0.0083, -0.0191),
        ] on plane 0 color GROUND + GROUND_DARKER;
        polygon [
            (0.0105, 0.08), (0.0175, 0.08), (0.0156, 0.072), (0.0124, 0.072),
        ] on plane 0 color GROUND;
        circle (0.014, 0.072) radius 0.0016 on plane 0 color GROUND;
        polygon [
            (0.0085, 0.08), (0.0195, 0.08), (0.0195, 0.0805), (0.0191, 0.0805), (0.0177, 0.0819),
            (0.0171, 0.0819), (0.0185, 0.0805), (0.0172, 0.0805), (0.0158, 0.0819),
            (0.0152, 0.0819), (0.0166, 0.0805), (0.0153, 0.0805), (0.0139, 0.0819),
            (0.0133, 0.0819), (0.0147, 0.0805), (0.0134, 0.0805), (0.012, 0.0819), (0.0113, 0.0819),
            (0.0127, 0.0805), (0.0114, 0.0805), (0.01, 0.0819), (0.0094, 0.0819), (0.0108, 0.0805),
            (0.0085, 0.0805),
        ] on plane 0 color GROUND + GROUND_DARKER;
        circle (0.014, 0.072) radius PIN on plane 9 color INK;
        circle (0.014, 0.072) radius PIN * 0.4 on plane 9 color EYE;
    }

    // K1, the crank, an eccentric disc.
    link k1 {
        point o = (0.0, 0.0);
        point tip = (RR, 0.0);
        circle (0.0, 0.0) radius 0.0098 on plane 1 color SLATE + DARKER;
        circle (0.0, 0.0) radius 0.0094 on plane 1 color SLATE;
        circle (0.0, 0.0) radius 0.004 on plane 1 color SLATE + LIGHTER;
        circle (-0.0062, 0.0) radius 0.0016 on plane 1 color SLATE + DARKER;
        circle (0.0, 0.0) radius PIN on plane 1 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 1 color EYE;
        circle (RR, 0.0) radius PIN on plane 9 color INK;
        circle (RR, 0.0) radius PIN * 0.4 on plane 9 color EYE;
    }

    // K2, from the crank to E. It points from E to the crank.
    link k2 {
        point tip = (0.0, 0.0);
        point e = (-D, 0.0);
        circle (0.0, 0.0) radius RIM on plane 2 color ORANGE + DARKER;
        circle (-D, 0.0) radius RIM on plane 2 color ORANGE + DARKER;
        polygon [(0.0, -RIM), (-D, -RIM), (-D, RIM), (0.0, RIM)] on plane 2 color ORANGE + DARKER;
        circle (0.0, 0.0) radius BAR on plane 2 color ORANGE;
        circle (-D, 0.0) radius BAR on plane 2 color ORANGE;
        polygon [(0.0, -BAR), (-D, -BAR), (-D, BAR), (0.0, BAR)] on plane 2 color ORANGE;
    }

    // K3, a ternary plate. It is drawn to the left by the spring.
    link k3 {
        point b = (0.0, 0.0);
        point e = (0.0, -SS);
        point d = (SD, -SC); // where the spring is attached
        polygon [
            (-0.0021, 0.0), (-0.0021, -0.035), (0.0014, -0.0366), (0.0214, -0.0196),
            (0.0214, -0.0164), (0.0014, 0.0016),
        ] on plane 3 color YELLOW + DARKER;
        circle (0.0, 0.0) radius RIM on plane 3 color YELLOW + DARKER;
        circle (0.0, -SS) radius RIM on plane 3 color YELLOW + DARKER;
        circle (SD, -SC) radius RIM on plane 3 color YELLOW + DARKER;
        polygon [
            (-0.0017, 0.0), (-0.0017, -0.035), (0.0011, -0.0363), (0.0211, -0.0193),
            (0.0211, -0.0167), (0.0011, 0.0013),
        ] on plane 3 color YELLOW;
        circle (0.0, 0.0) radius BAR on plane 3 color YELLOW;
        circle (0.0, -SS) radius BAR on plane 3 color YELLOW;
        circle (SD, -SC) radius BAR on plane 3 color YELLOW;
        polygon [
            (0.0026, -0.0066), (0.0026, -0.0288), (0.0148, -0.0176),
        ] on plane 3 color YELLOW + LIGHTER;
        circle (0.0, 0.0) radius PIN on plane 9 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 9 color EYE;
        circle (0.0, -SS) radius PIN on plane 9 color INK;
        circle (0.0, -SS) radius PIN * 0.4 on plane 9 color EYE;
        circle (SD, -SC) radius PIN on plane 9 color EYE;
        circle (SD, -SC) radius PIN * 0.5 on plane 9 color YELLOW + DARKER;
    }

    // K4, from K5 to E.
    link k4 {
        point tip = (0.0, 0.0);
        point e = (0.0, -E);
        polygon [
            (-0.0021, 0.0), (-0.0021, -0.02), (0.0021, -0.02), (0.0021, 0.0),
        ] on plane 4 color TEAL + DARKER;
        circle (0.0, 0.0) radius RIM on plane 4 color TEAL + DARKER;
        circle (0.0, -E) radius RIM on plane 4 color TEAL + DARKER;
        polygon [
            (-0.0017, 0.0), (-0.0017, -0.02), (0.0017, -0.02), (0.0017, 0.0),
        ] on plane 4 color TEAL;
        circle (0.0, 0.0) radius BAR on plane 4 color TEAL;
        circle (0.0, -E) radius BAR on plane 4 color TEAL;
    }

    // K5, on A.
    link k5 {
        point a = (0.0, 0.0);
        point tip = (ZT, 0.0);
        circle (0.0, 0.0) radius RIM on plane 5 color BLUE + DARKER;
        circle (ZT, 0.0) radius RIM on plane 5 color BLUE + DARKER;
        polygon [(0.0, -RIM), (ZT, -RIM), (ZT, RIM), (0.0, RIM)] on plane 5 color BLUE + DARKER;
        circle (0.0, 0.0) radius BAR on plane 5 color BLUE;
        circle (ZT, 0.0) radius BAR on plane 5 color BLUE;
        polygon [(0.0, -BAR), (ZT, -BAR), (ZT, BAR), (0.0, BAR)] on plane 5 color BLUE;
        circle (ZT, 0.0) radius PIN on plane 9 color INK;
        circle (ZT, 0.0) radius PIN * 0.4 on plane 9 color EYE;
    }

    // K6, from K7 to E.
    link k6 {
        point tip = (0.0, 0.0);
        point e = (ZF, 0.0);
        circle (0.0, 0.0) radius RIM on plane 6 color PINK + DARKER;
        circle (ZF, 0.0) radius RIM on plane 6 color PINK + DARKER;
        polygon [(0.0, -RIM), (ZF, -RIM), (ZF, RIM), (0.0, RIM)] on plane 6 color PINK + DARKER;
        circle (0.0, 0.0) radius BAR on plane 6 color PINK;
        circle (ZF, 0.0) radius BAR on plane 6 color PINK;
        polygon [(0.0, -BAR), (ZF, -BAR), (ZF, BAR), (0.0, BAR)] on plane 6 color PINK;
    }

    // K7, on A too.
    link k7 {
        point a = (0.0, 0.0);
        point tip = (0.0, -U);
        polygon [
            (-0.0021, 0.0), (-0.0021, -0.04), (0.0021, -0.04), (0.0021, 0.0),
        ] on plane 7 color RED + DARKER;
        circle (0.0, 0.0) radius RIM on plane 7 color RED + DARKER;
        circle (0.0, -U) radius RIM on plane 7 color RED + DARKER;
        polygon [
            (-0.0017, 0.0), (-0.0017, -0.04), (0.0017, -0.04), (0.0017, 0.0),
        ] on plane 7 color RED;
        circle (0.0, 0.0) radius BAR on plane 7 color RED;
        circle (0.0, -U) radius BAR on plane 7 color RED;
        circle (0.0, 0.0) radius PIN on plane 9 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 9 color EYE;
        circle (0.0, -U) radius PIN on plane 9 color INK;
        circle (0.0, -U) radius PIN * 0.4 on plane 9 color EYE;
    }

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

    motor beta;
    start {
        beta = -0.061713890014276;
        k3 near 0.4553;
        k5 near 0.4874;
        k7 near 1.2305;
    }
    effects { acceleration; overlay; }
}

exhibited!(
    AndrewsSqueezer,
    "andrews-squeezer",
    include_str!("andrews.rs"),
    motion
);

/// One turn of the crank.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [phase * T::TURN - T::from_f64(0.061_713_890_014_276)]
}
