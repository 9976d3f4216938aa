//! The four-bar linkage in its most common form.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// A crank-rocker with a triangular coupler.
    pub struct CrankRocker;

    // Entries of the palette, by their names in `mech_runtime::Palette`.
    const GROUND = 1;
    const BLUE = 2;
    const ORANGE = 3;
    const TEAL = 4;
    const RED = 5;
    const INK = 14;
    const EYE = 15;
    const DARKER = 16; // to be added to a link's color
    const LIGHTER = 32; // likewise
    const GROUND_DARKER = 29; // to be added to the ground's
    const GROUND_LIGHTER = 30; // likewise

    // The four bars.
    const GROUND_BAR = 4.0;
    const CRANK = 1.0;
    const COUPLER = 3.5;
    const ROCKER = 3.0;

    const BAR = 0.15; // half the width of a bar
    const RIM = BAR + 0.04; // the same with its dark edge
    const PIN = 0.09;

    ground {
        point crank_shaft = (0.0, 0.0);
        point rocker_shaft = (GROUND_BAR, 0.0);

        // The stands of the fixed axes: for each its body, its head, and a base with hatching.
        polygon [(-0.52, -1.5), (0.52, -1.5), (0.24, 0.0), (-0.24, 0.0)] on plane 0 color GROUND;
        circle (0.0, 0.0) radius 0.24 on plane 0 color GROUND;
        polygon [
            (-0.83, -1.5), (0.83, -1.5), (0.83, -1.57), (0.77, -1.57), (0.56, -1.79), (0.47, -1.79),
            (0.68, -1.57), (0.48, -1.57), (0.27, -1.79), (0.18, -1.79), (0.39, -1.57),
            (0.19, -1.57), (-0.02, -1.79), (-0.11, -1.79), (0.1, -1.57), (-0.1, -1.57),
            (-0.31, -1.79), (-0.4, -1.79), (-0.19, -1.57), (-0.38, -1.57), (-0.59, -1.79),
            (-0.69, -1.79), (-0.48, -1.57), (-0.83, -1.57),
        ] on plane 0 color GROUND + GROUND_DARKER;
        polygon [(3.48, -1.5), (4.53, -1.5), (4.24, 0.0), (3.76, 0.0)] on plane 0 color GROUND;
        circle (4.0, 0.0) radius 0.24 on plane 0 color GROUND;
        polygon [
            (3.17, -1.5), (4.83, -1.5), (4.83, -1.57), (4.77, -1.57), (4.56, -1.79), (4.47, -1.79),
            (4.68, -1.57), (4.48, -1.57), (4.27, -1.79), (4.18, -1.79), (4.39, -1.57),
            (4.19, -1.57), (3.98, -1.79), (3.89, -1.79), (4.1, -1.57), (3.9, -1.57), (3.69, -1.79),
            (3.6, -1.79), (3.81, -1.57), (3.62, -1.57), (3.41, -1.79), (3.31, -1.79), (3.52, -1.57),
            (3.17, -1.57),
        ] on plane 0 color GROUND + GROUND_DARKER;

        // Where the coupler point comes by, at every ten degrees of the crank.
        circle (0.8, 2.3) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.92, 2.48) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (1.02, 2.65) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (1.08, 2.79) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (1.1, 2.92) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (1.09, 3.03) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (1.03, 3.11) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.95, 3.16) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.84, 3.19) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.71, 3.19) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.57, 3.17) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.42, 3.12) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.27, 3.04) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.12, 2.94) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.03, 2.83) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.16, 2.69) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.28, 2.55) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.39, 2.4) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.47, 2.24) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.54, 2.09) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.59, 1.94) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.62, 1.79) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.63, 1.66) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.62, 1.54) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.6, 1.44) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.55, 1.36) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.48, 1.3) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.4, 1.27) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.31, 1.27) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.2, 1.3) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (-0.07, 1.37) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.06, 1.46) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.2, 1.59) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.35, 1.75) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.51, 1.92) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
        circle (0.66, 2.11) radius 0.03 on plane -1 color GROUND + GROUND_LIGHTER;
    }

    link crank {
        point shaft = (0.0, 0.0);
        point pin = (CRANK, 0.0);
        circle (0.0, 0.0) radius 0.34 on plane 3 color BLUE + DARKER;
        circle (0.0, 0.0) radius 0.3 on plane 3 color BLUE;
        circle (0.0, 0.0) radius RIM on plane 3 color BLUE + DARKER;
        circle (CRANK, 0.0) radius RIM on plane 3 color BLUE + DARKER;
        polygon [
            (0.0, -RIM), (CRANK, -RIM), (CRANK, RIM), (0.0, RIM),
        ] on plane 3 color BLUE + DARKER;
        circle (0.0, 0.0) radius BAR on plane 3 color BLUE;
        circle (CRANK, 0.0) radius BAR on plane 3 color BLUE;
        polygon [(0.0, -BAR), (CRANK, -BAR), (CRANK, BAR), (0.0, BAR)] on plane 3 color BLUE;
        circle (0.0, 0.0) radius PIN on plane 4 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 4 color EYE;
        circle (CRANK, 0.0) radius PIN on plane 4 color INK;
        circle (CRANK, 0.0) radius PIN * 0.4 on plane 4 color EYE;
    }

    link coupler {
        point crank_pin = (0.0, 0.0);
        point rocker_pin = (COUPLER, 0.0);
        point tip = (1.75, 1.5);
        // A triangle with round corners: its edge, and the face on it.
        polygon [
            (0.0, -0.19), (3.5, -0.19), (3.62, 0.14), (1.87, 1.64), (1.63, 1.64), (-0.12, 0.14),
        ] on plane 1 color TEAL + DARKER;
        circle (0.0, 0.0) radius RIM on plane 1 color TEAL + DARKER;
        circle (COUPLER, 0.0) radius RIM on plane 1 color TEAL + DARKER;
        circle (1.75, 1.5) radius RIM on plane 1 color TEAL + DARKER;
        polygon [
            (0.0, -0.15), (3.5, -0.15), (3.6, 0.11), (1.85, 1.61), (1.65, 1.61), (-0.1, 0.11),
        ] on plane 1 color TEAL;
        circle (0.0, 0.0) radius BAR on plane 1 color TEAL;
        circle (COUPLER, 0.0) radius BAR on plane 1 color TEAL;
        circle (1.75, 1.5) radius BAR on plane 1 color TEAL;
        // A window in it.
        polygon [(0.62, 0.18), (2.88, 0.18), (1.75, 1.15)] on plane 1 color TEAL + LIGHTER;
        circle (1.75, 1.5) radius PIN on plane 1 color RED + DARKER;
        circle (1.75, 1.5) radius PIN * 0.7 on plane 1 color RED;
    }

    link rocker {
        point pin = (ROCKER, 0.0);
        point shaft = (0.0, 0.0);
        circle (0.0, 0.0) radius 0.29 on plane 2 color ORANGE + DARKER;
        circle (0.0, 0.0) radius 0.25 on plane 2 color ORANGE;
        circle (0.0, 0.0) radius RIM on plane 2 color ORANGE + DARKER;
        circle (ROCKER, 0.0) radius RIM on plane 2 color ORANGE + DARKER;
        polygon [
            (0.0, -RIM), (ROCKER, -RIM), (ROCKER, RIM), (0.0, RIM),
        ] on plane 2 color ORANGE + DARKER;
        circle (0.0, 0.0) radius BAR on plane 2 color ORANGE;
        circle (ROCKER, 0.0) radius BAR on plane 2 color ORANGE;
        polygon [(0.0, -BAR), (ROCKER, -BAR), (ROCKER, BAR), (0.0, BAR)] on plane 2 color ORANGE;
        circle (0.0, 0.0) radius PIN on plane 4 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 4 color EYE;
        circle (ROCKER, 0.0) radius PIN on plane 4 color INK;
        circle (ROCKER, 0.0) radius PIN * 0.4 on plane 4 color EYE;
    }

    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, coupler.crank_pin);
    joint c = revolute(coupler.rocker_pin, rocker.pin);
    joint d = revolute(ground.rocker_shaft, rocker.shaft);

    motor a;
    start { a = 0 deg; rocker near 110 deg; }
    effects { acceleration; overlay; }
}

exhibited!(CrankRocker, "four-bar", include_str!("four_bar.rs"), motion);

/// One turn of the crank.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [phase * T::TURN]
}
