//! Figure 1 of the paper: a piston driven through a pair of gears.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// A piston driven through a pair of gears: figure 1 of the paper.
    pub struct GearedPiston;

    // Entries of the palette, by their names in `mech_runtime::Palette`.
    const GROUND = 1;
    const BLUE = 2;
    const ORANGE = 3;
    const TEAL = 4;
    const RED = 5;
    const INK = 14;
    const EYE = 15;
    const SHADE = 46;
    const DARKER = 16; // to be added to a link's color
    const LIGHTER = 32; // likewise
    const GROUND_DARKER = 29; // to be added to the ground's

    const THROW = 1.0; // of the crank pin on the wheel
    const ROD = 4.0;

    const BAR = 0.15; // half the width of the rod
    const RIM = BAR + 0.04; // the same with its dark edge
    const PIN = 0.1;
    const BORE = 0.64; // half the width of the cylinder
    const WALL = BORE + 0.24;

    ground {
        point pinion_shaft = (-3.0, 0.0);
        point wheel_shaft = (0.0, 0.0);
        line bore = (0.0, 0.0) -> (1.0, 0.0);

        // The stands of the fixed axes: for each its body, its head, and a base with hatching.
        polygon [(-3.56, -2.5), (-2.44, -2.5), (-2.74, 0.0), (-3.26, 0.0)] on plane 0 color GROUND;
        circle (-3.0, 0.0) radius 0.256 on plane 0 color GROUND;
        polygon [
            (-3.88, -2.5), (-2.12, -2.5), (-2.12, -2.58), (-2.18, -2.58), (-2.41, -2.8),
            (-2.5, -2.8), (-2.28, -2.58), (-2.49, -2.58), (-2.71, -2.8), (-2.81, -2.8),
            (-2.59, -2.58), (-2.8, -2.58), (-3.02, -2.8), (-3.12, -2.8), (-2.89, -2.58),
            (-3.1, -2.58), (-3.33, -2.8), (-3.43, -2.8), (-3.2, -2.58), (-3.41, -2.58),
            (-3.63, -2.8), (-3.73, -2.8), (-3.51, -2.58), (-3.88, -2.58),
        ] on plane 0 color GROUND + GROUND_DARKER;
        polygon [(-0.56, -2.5), (0.56, -2.5), (0.26, 0.0), (-0.26, 0.0)] on plane 0 color GROUND;
        circle (0.0, 0.0) radius 0.256 on plane 0 color GROUND;
        polygon [
            (-0.88, -2.5), (0.88, -2.5), (0.88, -2.58), (0.82, -2.58), (0.59, -2.8), (0.5, -2.8),
            (0.72, -2.58), (0.51, -2.58), (0.29, -2.8), (0.19, -2.8), (0.41, -2.58), (0.2, -2.58),
            (-0.02, -2.8), (-0.12, -2.8), (0.11, -2.58), (-0.1, -2.58), (-0.33, -2.8),
            (-0.43, -2.8), (-0.2, -2.58), (-0.41, -2.58), (-0.63, -2.8), (-0.73, -2.8),
            (-0.51, -2.58), (-0.88, -2.58),
        ] on plane 0 color GROUND + GROUND_DARKER;

        // The cylinder: its foot, two walls and a head, and what it encloses.
        polygon [(3.7, -2.5), (5.1, -2.5), (4.9, -0.7), (3.9, -0.7)] on plane 0 color GROUND;
        polygon [
            (3.4, -2.5), (5.4, -2.5), (5.4, -2.58), (5.34, -2.58), (5.12, -2.8), (5.03, -2.8),
            (5.25, -2.58), (5.04, -2.58), (4.82, -2.8), (4.73, -2.8), (4.95, -2.58), (4.75, -2.58),
            (4.53, -2.8), (4.43, -2.8), (4.65, -2.58), (4.45, -2.58), (4.23, -2.8), (4.14, -2.8),
            (4.36, -2.58), (4.15, -2.58), (3.93, -2.8), (3.84, -2.8), (4.06, -2.58), (3.86, -2.58),
            (3.64, -2.8), (3.54, -2.8), (3.76, -2.58), (3.4, -2.58),
        ] on plane 0 color GROUND + GROUND_DARKER;
        polygon [(2.35, -WALL), (6.1, -WALL), (6.1, WALL), (2.35, WALL)]
            on plane 0 color GROUND + GROUND_DARKER;
        polygon [(2.39, 0.04 - WALL), (6.06, 0.04 - WALL), (6.06, WALL - 0.04), (2.39, WALL - 0.04)]
            on plane 0 color GROUND;
        polygon [(2.35, -BORE), (5.82, -BORE), (5.82, BORE), (2.35, BORE)]
            on plane 0 color GROUND + GROUND_DARKER;
        polygon [(2.35, 0.04 - BORE), (5.78, 0.04 - BORE), (5.78, BORE - 0.04), (2.35, BORE - 0.04)]
            on plane 0 color SHADE;
    }

    link pinion {
        point shaft = (0.0, 0.0);
        // Twenty teeth, one in a row of the list; the first on the x axis.
        polygon [
            (0.88, -0.118), (1.09, -0.042), (1.09, 0.042), (0.88, 0.118),
            (0.873, 0.16), (1.05, 0.297), (1.024, 0.377), (0.8, 0.384),
            (0.781, 0.422), (0.907, 0.607), (0.857, 0.675), (0.643, 0.613),
            (0.613, 0.643), (0.675, 0.857), (0.607, 0.907), (0.422, 0.781),
            (0.384, 0.8), (0.377, 1.024), (0.297, 1.05), (0.16, 0.873),
            (0.118, 0.88), (0.042, 1.09), (-0.042, 1.09), (-0.118, 0.88),
            (-0.16, 0.873), (-0.297, 1.05), (-0.377, 1.024), (-0.384, 0.8),
            (-0.422, 0.781), (-0.607, 0.907), (-0.675, 0.857), (-0.613, 0.643),
            (-0.643, 0.613), (-0.857, 0.675), (-0.907, 0.607), (-0.781, 0.422),
            (-0.8, 0.384), (-1.024, 0.377), (-1.05, 0.297), (-0.873, 0.16),
            (-0.88, 0.118), (-1.09, 0.042), (-1.09, -0.042), (-0.88, -0.118),
            (-0.873, -0.16), (-1.05, -0.297), (-1.024, -0.377), (-0.8, -0.384),
            (-0.781, -0.422), (-0.907, -0.607), (-0.857, -0.675), (-0.643, -0.613),
            (-0.613, -0.643), (-0.675, -0.857), (-0.607, -0.907), (-0.422, -0.781),
            (-0.384, -0.8), (-0.377, -1.024), (-0.297, -1.05), (-0.16, -0.873),
            (-0.118, -0.88), (-0.042, -1.09), (0.042, -1.09), (0.118, -0.88),
            (0.16, -0.873), (0.297, -1.05), (0.377, -1.024), (0.384, -0.8),
            (0.422, -0.781), (0.607, -0.907), (0.675, -0.857), (0.613, -0.643),
            (0.643, -0.613), (0.857, -0.675), (0.907, -0.607), (0.781, -0.422),
            (0.8, -0.384), (1.024, -0.377), (1.05, -0.297), (0.873, -0.16),
        ] on plane 1 color BLUE;
        circle (0.0, 0.0) radius 0.78 on plane 1 color BLUE + DARKER;
        circle (0.0, 0.0) radius 0.74 on plane 1 color BLUE + LIGHTER;
        circle (0.0, 0.0) radius 0.3 on plane 1 color BLUE;
        circle (0.48, 0.0) radius 0.14 on plane 1 color BLUE + DARKER;
        circle (0.48 * cos(120 deg), 0.48 * sin(120 deg)) radius 0.14 on plane 1 color BLUE + DARKER;
        circle (0.48 * cos(240 deg), 0.48 * sin(240 deg)) radius 0.14 on plane 1 color BLUE + DARKER;
        circle (0.0, 0.0) radius PIN on plane 4 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 4 color EYE;
    }

    link wheel {
        point shaft = (0.0, 0.0);
        point pin = (THROW, 0.0);
        // Forty teeth. The first is half a pitch above the x axis, so that a gap meets the pinion's tooth.
        polygon [
            (1.883, 0.03), (2.087, 0.122), (2.08, 0.206), (1.865, 0.265),
            (1.856, 0.324), (2.042, 0.447), (2.022, 0.529), (1.801, 0.554),
            (1.782, 0.61), (1.947, 0.761), (1.915, 0.839), (1.692, 0.828),
            (1.665, 0.882), (1.804, 1.056), (1.76, 1.128), (1.541, 1.083),
            (1.506, 1.131), (1.617, 1.325), (1.562, 1.389), (1.353, 1.311),
            (1.311, 1.353), (1.389, 1.562), (1.325, 1.617), (1.131, 1.506),
            (1.083, 1.541), (1.128, 1.76), (1.056, 1.804), (0.882, 1.665),
            (0.828, 1.692), (0.839, 1.915), (0.761, 1.947), (0.61, 1.782),
            (0.554, 1.801), (0.529, 2.022), (0.447, 2.042), (0.324, 1.856),
            (0.265, 1.865), (0.206, 2.08), (0.122, 2.087), (0.03, 1.883),
            (-0.03, 1.883), (-0.122, 2.087), (-0.206, 2.08), (-0.265, 1.865),
            (-0.324, 1.856), (-0.447, 2.042), (-0.529, 2.022), (-0.554, 1.801),
            (-0.61, 1.782), (-0.761, 1.947), (-0.839, 1.915), (-0.828, 1.692),
            (-0.882, 1.665), (-1.056, 1.804), (-1.128, 1.76), (-1.083, 1.541),
            (-1.131, 1.506), (-1.325, 1.617), (-1.389, 1.562), (-1.311, 1.353),
            (-1.353, 1.311), (-1.562, 1.389), (-1.617, 1.325), (-1.506, 1.131),
            (-1.541, 1.083), (-1.76, 1.128), (-1.804, 1.056), (-1.665, 0.882),
            (-1.692, 0.828), (-1.915, 0.839), (-1.947, 0.761), (-1.782, 0.61),
            (-1.801, 0.554), (-2.022, 0.529), (-2.042, 0.447), (-1.856, 0.324),
            (-1.865, 0.265), (-2.08, 0.206), (-2.087, 0.122), (-1.883, 0.03),
            (-1.883, -0.03), (-2.087, -0.122), (-2.08, -0.206), (-1.865, -0.265),
            (-1.856, -0.324), (-2.042, -0.447), (-2.022, -0.529), (-1.801, -0.554),
            (-1.782, -0.61), (-1.947, -0.761), (-1.915, -0.839), (-1.692, -0.828),
            (-1.665, -0.882), (-1.804, -1.056), (-1.76, -1.128), (-1.541, -1.083),
            (-1.506, -1.131), (-1.617, -1.325), (-1.562, -1.389), (-1.353, -1.311),
            (-1.311, -1.353), (-1.389, -1.562), (-1.325, -1.617), (-1.131, -1.506),
            (-1.083, -1.541), (-1.128, -1.76), (-1.056, -1.804), (-0.882, -1.665),
            (-0.828, -1.692), (-0.839, -1.915), (-0.761, -1.947), (-0.61, -1.782),
            (-0.554, -1.801), (-0.529, -2.022), (-0.447, -2.042), (-0.324, -1.856),
            (-0.265, -1.865), (-0.206, -2.08), (-0.122, -2.087), (-0.03, -1.883),
            (0.03, -1.883), (0.122, -2.087), (0.206, -2.08), (0.265, -1.865),
            (0.324, -1.856), (0.447, -2.042), (0.529, -2.022), (0.554, -1.801),
            (0.61, -1.782), (0.761, -1.947), (0.839, -1.915), (0.828, -1.692),
            (0.882, -1.665), (1.056, -1.804), (1.128, -1.76), (1.083, -1.541),
            (1.131, -1.506), (1.325, -1.617), (1.389, -1.562), (1.311, -1.353),
            (1.353, -1.311), (1.562, -1.389), (1.617, -1.325), (1.506, -1.131),
            (1.541, -1.083), (1.76, -1.128), (1.804, -1.056), (1.665, -0.882),
            (1.692, -0.828), (1.915, -0.839), (1.947, -0.761), (1.782, -0.61),
            (1.801, -0.554), (2.022, -0.529), (2.042, -0.447), (1.856, -0.324),
            (1.865, -0.265), (2.08, -0.206), (2.087, -0.122), (1.883, -0.03),
        ] on plane 1 color ORANGE;
        circle (0.0, 0.0) radius 1.7 on plane 1 color ORANGE + DARKER;
        circle (0.0, 0.0) radius 1.66 on plane 1 color ORANGE + LIGHTER;
        circle (1.12 * cos(36 deg), 1.12 * sin(36 deg)) radius 0.36 on plane 1 color ORANGE + DARKER;
        circle (1.12 * cos(108 deg), 1.12 * sin(108 deg)) radius 0.36 on plane 1 color ORANGE + DARKER;
        circle (1.12 * cos(180 deg), 1.12 * sin(180 deg)) radius 0.36 on plane 1 color ORANGE + DARKER;
        circle (1.12 * cos(252 deg), 1.12 * sin(252 deg)) radius 0.36 on plane 1 color ORANGE + DARKER;
        circle (1.12 * cos(324 deg), 1.12 * sin(324 deg)) radius 0.36 on plane 1 color ORANGE + DARKER;
        circle (0.0, 0.0) radius 0.38 on plane 1 color ORANGE;
        circle (THROW, 0.0) radius 0.28 on plane 1 color ORANGE;
        circle (0.0, 0.0) radius PIN on plane 4 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 4 color EYE;
    }

    link rod {
        point big_end = (0.0, 0.0);
        point small_end = (ROD, 0.0);
        // The edge, and the face on it.
        circle (0.0, 0.0) radius RIM + 0.07 on plane 3 color TEAL + DARKER;
        circle (ROD, 0.0) radius RIM on plane 3 color TEAL + DARKER;
        polygon [(0.0, -RIM), (ROD, -RIM), (ROD, RIM), (0.0, RIM)] on plane 3 color TEAL + DARKER;
        circle (0.0, 0.0) radius BAR + 0.07 on plane 3 color TEAL;
        circle (ROD, 0.0) radius BAR on plane 3 color TEAL;
        polygon [(0.0, -BAR), (ROD, -BAR), (ROD, BAR), (0.0, BAR)] on plane 3 color TEAL;
        circle (0.0, 0.0) radius PIN on plane 4 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 4 color EYE;
        circle (ROD, 0.0) radius PIN on plane 4 color INK;
        circle (ROD, 0.0) radius PIN * 0.4 on plane 4 color EYE;
    }

    link piston {
        point pin = (0.0, 0.0);
        line axis = (0.0, 0.0) -> (1.0, 0.0);
        polygon [(-0.5, -0.6), (0.7, -0.6), (0.7, 0.6), (-0.5, 0.6)] on plane 2 color RED + DARKER;
        polygon [(-0.46, -0.56), (0.66, -0.56), (0.66, 0.56), (-0.46, 0.56)] on plane 2 color RED;
        // The grooves of its rings.
        polygon [(0.34, -0.6), (0.4, -0.6), (0.4, 0.6), (0.34, 0.6)] on plane 2 color RED + DARKER;
        polygon [(0.5, -0.6), (0.56, -0.6), (0.56, 0.6), (0.5, 0.6)] on plane 2 color RED + DARKER;
        circle (0.0, 0.0) radius 0.3 on plane 2 color RED + LIGHTER;
    }

    joint d = revolute(ground.pinion_shaft, pinion.shaft);
    joint e = revolute(ground.wheel_shaft, wheel.shaft);
    joint mesh = gear(pinion, wheel, 20 : 40);
    joint f = revolute(wheel.pin, rod.big_end);
    joint g = revolute(rod.small_end, piston.pin);
    joint h = prismatic(ground.bore, piston.axis);

    motor d;
    start { d = 0 deg; rod near 0 deg; }
    effects { acceleration; overlay; }
}

exhibited!(
    GearedPiston,
    "geared-piston",
    include_str!("geared_piston.rs"),
    motion
);

/// Two turns of the pinion are one of the wheel.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [(phase + phase) * T::TURN]
}
