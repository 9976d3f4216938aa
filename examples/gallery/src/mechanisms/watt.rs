//! A six-bar linkage, declared as in a drawing.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// A Watt six-bar: two four-bar loops that share a ternary link.
    pub struct Watt;

    // Entries of the palette, by their names in `mech_runtime::Palette`.
    const GROUND = 1;
    const BLUE = 2;
    const ORANGE = 3;
    const TEAL = 4;
    const PURPLE = 7;
    const YELLOW = 6;
    const INK = 14;
    const EYE = 15;
    const DARKER = 16; // to be added to a link's color
    const LIGHTER = 32; // likewise
    const GROUND_DARKER = 29; // to be added to the ground's

    const BAR = 0.14; // half the width of a bar
    const RIM = BAR + 0.04; // the same with its dark edge
    const PIN = 0.08;

    // All coordinates are the scene's, with everything as it is at the start.
    ground {
        // The stands of the fixed axes: for each its body, its head, and a base with hatching.
        polygon [(-0.49, -1.5), (0.49, -1.5), (0.22, 0.0), (-0.22, 0.0)] on plane 0 color GROUND;
        circle (0.0, 0.0) radius 0.224 on plane 0 color GROUND;
        polygon [
            (-0.77, -1.5), (0.77, -1.5), (0.77, -1.57), (0.72, -1.57), (0.52, -1.77), (0.43, -1.77),
            (0.63, -1.57), (0.45, -1.57), (0.25, -1.77), (0.17, -1.77), (0.36, -1.57),
            (0.18, -1.57), (-0.02, -1.77), (-0.1, -1.77), (0.09, -1.57), (-0.09, -1.57),
            (-0.29, -1.77), (-0.37, -1.77), (-0.18, -1.57), (-0.36, -1.57), (-0.55, -1.77),
            (-0.64, -1.77), (-0.45, -1.57), (-0.77, -1.57),
        ] on plane 0 color GROUND + GROUND_DARKER;
        polygon [(3.51, -1.5), (4.49, -1.5), (4.22, 0.0), (3.78, 0.0)] on plane 0 color GROUND;
        circle (4.0, 0.0) radius 0.224 on plane 0 color GROUND;
        polygon [
            (3.23, -1.5), (4.77, -1.5), (4.77, -1.57), (4.72, -1.57), (4.52, -1.77), (4.43, -1.77),
            (4.63, -1.57), (4.45, -1.57), (4.25, -1.77), (4.17, -1.77), (4.36, -1.57),
            (4.18, -1.57), (3.98, -1.77), (3.9, -1.77), (4.09, -1.57), (3.91, -1.57), (3.71, -1.77),
            (3.63, -1.77), (3.82, -1.57), (3.64, -1.57), (3.45, -1.77), (3.36, -1.77),
            (3.55, -1.57), (3.23, -1.57),
        ] on plane 0 color GROUND + GROUND_DARKER;
        polygon [(6.21, -1.5), (7.19, -1.5), (6.92, 0.0), (6.48, 0.0)] on plane 0 color GROUND;
        circle (6.7, 0.0) radius 0.224 on plane 0 color GROUND;
        polygon [
            (5.93, -1.5), (7.47, -1.5), (7.47, -1.57), (7.42, -1.57), (7.22, -1.77), (7.13, -1.77),
            (7.33, -1.57), (7.15, -1.57), (6.95, -1.77), (6.87, -1.77), (7.06, -1.57),
            (6.88, -1.57), (6.68, -1.77), (6.6, -1.77), (6.79, -1.57), (6.61, -1.57), (6.41, -1.77),
            (6.33, -1.77), (6.52, -1.57), (6.34, -1.57), (6.15, -1.77), (6.06, -1.77),
            (6.25, -1.57), (5.93, -1.57),
        ] on plane 0 color GROUND + GROUND_DARKER;
    }

    link crank {
        circle (0.0, 0.0) radius 0.34 on plane 4 color BLUE + DARKER;
        circle (0.0, 0.0) radius 0.3 on plane 4 color BLUE;
        polygon [
            (0.18, 0.0), (0.18, 1.2), (-0.18, 1.2), (-0.18, 0.0),
        ] on plane 4 color BLUE + DARKER;
        circle (0.0, 0.0) radius RIM on plane 4 color BLUE + DARKER;
        circle (0.0, 1.2) radius RIM on plane 4 color BLUE + DARKER;
        polygon [(0.14, 0.0), (0.14, 1.2), (-0.14, 1.2), (-0.14, 0.0)] on plane 4 color BLUE;
        circle (0.0, 0.0) radius BAR on plane 4 color BLUE;
        circle (0.0, 1.2) radius BAR on plane 4 color BLUE;
        circle (0.0, 0.0) radius PIN on plane 6 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 6 color EYE;
        circle (0.0, 1.2) radius PIN on plane 6 color INK;
        circle (0.0, 1.2) radius PIN * 0.4 on plane 6 color EYE;
    }

    link coupler {
        polygon [
            (0.05, 1.03), (3.75, 2.03), (3.65, 2.37), (-0.05, 1.37),
        ] on plane 2 color TEAL + DARKER;
        circle (0.0, 1.2) radius RIM on plane 2 color TEAL + DARKER;
        circle (3.7, 2.2) radius RIM on plane 2 color TEAL + DARKER;
        polygon [(0.04, 1.06), (3.74, 2.06), (3.66, 2.34), (-0.04, 1.34)] on plane 2 color TEAL;
        circle (0.0, 1.2) radius BAR on plane 2 color TEAL;
        circle (3.7, 2.2) radius BAR on plane 2 color TEAL;
    }

    link bell_crank {
        // A triangle with round corners: its edge, and the face on it.
        polygon [
            (6.35, 3.17), (3.65, 2.37), (3.52, 2.18), (3.82, -0.02), (4.14, -0.11), (6.54, 2.89),
        ] on plane 3 color YELLOW + DARKER;
        circle (4.0, 0.0) radius RIM on plane 3 color YELLOW + DARKER;
        circle (3.7, 2.2) radius RIM on plane 3 color YELLOW + DARKER;
        circle (6.4, 3.0) radius RIM on plane 3 color YELLOW + DARKER;
        polygon [
            (6.36, 3.13), (3.66, 2.33), (3.56, 2.18), (3.86, -0.02), (4.11, -0.09), (6.51, 2.91),
        ] on plane 3 color YELLOW;
        circle (4.0, 0.0) radius BAR on plane 3 color YELLOW;
        circle (3.7, 2.2) radius BAR on plane 3 color YELLOW;
        circle (6.4, 3.0) radius BAR on plane 3 color YELLOW;
        polygon [(4.2, 0.7), (4.02, 2.0), (5.5, 2.48)] on plane 3 color YELLOW + LIGHTER;
        circle (4.0, 0.0) radius PIN on plane 6 color INK;
        circle (4.0, 0.0) radius PIN * 0.4 on plane 6 color EYE;
        circle (3.7, 2.2) radius PIN on plane 6 color INK;
        circle (3.7, 2.2) radius PIN * 0.4 on plane 6 color EYE;
        circle (6.4, 3.0) radius PIN on plane 6 color INK;
        circle (6.4, 3.0) radius PIN * 0.4 on plane 6 color EYE;
    }

    link connecting_rod {
        polygon [
            (6.27, 2.88), (8.47, 0.58), (8.73, 0.82), (6.53, 3.12),
        ] on plane 2 color PURPLE + DARKER;
        circle (6.4, 3.0) radius RIM on plane 2 color PURPLE + DARKER;
        circle (8.6, 0.7) radius RIM on plane 2 color PURPLE + DARKER;
        polygon [(6.3, 2.9), (8.5, 0.6), (8.7, 0.8), (6.5, 3.1)] on plane 2 color PURPLE;
        circle (6.4, 3.0) radius BAR on plane 2 color PURPLE;
        circle (8.6, 0.7) radius BAR on plane 2 color PURPLE;
    }

    link rocker {
        circle (6.7, 0.0) radius 0.29 on plane 5 color ORANGE + DARKER;
        circle (6.7, 0.0) radius 0.25 on plane 5 color ORANGE;
        polygon [
            (6.76, -0.17), (8.66, 0.53), (8.54, 0.87), (6.64, 0.17),
        ] on plane 5 color ORANGE + DARKER;
        circle (6.7, 0.0) radius RIM on plane 5 color ORANGE + DARKER;
        circle (8.6, 0.7) radius RIM on plane 5 color ORANGE + DARKER;
        polygon [(6.75, -0.13), (8.65, 0.57), (8.55, 0.83), (6.65, 0.13)] on plane 5 color ORANGE;
        circle (6.7, 0.0) radius BAR on plane 5 color ORANGE;
        circle (8.6, 0.7) radius BAR on plane 5 color ORANGE;
        circle (6.7, 0.0) radius PIN on plane 6 color INK;
        circle (6.7, 0.0) radius PIN * 0.4 on plane 6 color EYE;
        circle (8.6, 0.7) radius PIN on plane 6 color INK;
        circle (8.6, 0.7) radius PIN * 0.4 on plane 6 color EYE;
    }

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, coupler) at (0.0, 1.2);
    joint c = revolute(coupler, bell_crank) at (3.7, 2.2);
    joint d = revolute(ground, bell_crank) at (4.0, 0.0);
    joint e = revolute(bell_crank, connecting_rod) at (6.4, 3.0);
    joint f = revolute(connecting_rod, rocker) at (8.6, 0.7);
    joint g = revolute(ground, rocker) at (6.7, 0.0);

    motor a;
    effects { acceleration; overlay; }
}

exhibited!(Watt, "watt-six-bar", include_str!("watt.rs"), motion);

/// One turn of the crank.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [phase * T::TURN]
}
