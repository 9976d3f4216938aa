//! A leg of Theo Jansen's beach beasts, declared as it is drawn.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// A leg of Theo Jansen's beach beasts. Its points are numbered from the crank shaft, 0, to the foot, 7.
    pub struct JansenLeg;

    // Entries of the palette, by their names in `mech_runtime::Palette`.
    const GROUND = 1;
    const BLUE = 2;
    const ORANGE = 3;
    const TEAL = 4;
    const RED = 5;
    const YELLOW = 6;
    const PURPLE = 7;
    const GREEN = 8;
    const INK = 14;
    const EYE = 15;
    const DARKER = 16; // to be added to a link's color
    const LIGHTER = 32; // likewise
    const GROUND_DARKER = 29; // to be added to the ground's
    const GROUND_LIGHTER = 30; // likewise

    // The points as they are at the start. All coordinates below are the scene's, too.
    const X1 = 9.61;
    const Y1 = 11.52;
    const X2 = -38;
    const Y2 = -7.8;
    const X3 = -35.24;
    const Y3 = 33.61;
    const X4 = -77.75;
    const Y4 = -2.54;
    const X5 = -20.1;
    const Y5 = -42.79;
    const X6 = -56.05;
    const Y6 = -35.42;
    const X7 = -22.22;
    const Y7 = -91.74;

    const BAR = 1.9; // half the width of a bar
    const RIM = BAR + 0.5; // the same with its dark edge
    const PIN = 1.2;
    const SHOE = 3.2;

    ground {
        // The beast's body holds points 0 and 2.
        polygon [
            (-1.41, 6.86), (-39.41, -0.94), (-36.59, -14.66), (1.41, -6.86),
        ] on plane 0 color GROUND + GROUND_DARKER;
        circle (0.0, 0.0) radius 7.0 on plane 0 color GROUND + GROUND_DARKER;
        circle (X2, Y2) radius 7.0 on plane 0 color GROUND + GROUND_DARKER;
        polygon [
            (-1.29, 6.27), (-39.29, -1.53), (-36.71, -14.07), (1.29, -6.27),
        ] on plane 0 color GROUND;
        circle (0.0, 0.0) radius 6.4 on plane 0 color GROUND;
        circle (X2, Y2) radius 6.4 on plane 0 color GROUND;

        // The beach.
        polygon [
            (-82.0, -95.1), (6.0, -95.1), (6.0, -96.3), (5.29, -96.3), (2.09, -99.5), (1.07, -99.5),
            (4.27, -96.3), (1.76, -96.3), (-1.44, -99.5), (-2.47, -99.5), (0.73, -96.3),
            (-1.77, -96.3), (-4.97, -99.5), (-6.0, -99.5), (-2.8, -96.3), (-5.31, -96.3),
            (-8.51, -99.5), (-9.53, -99.5), (-6.33, -96.3), (-8.84, -96.3), (-12.04, -99.5),
            (-13.07, -99.5), (-9.87, -96.3), (-12.37, -96.3), (-15.57, -99.5), (-16.6, -99.5),
            (-13.4, -96.3), (-15.91, -96.3), (-19.11, -99.5), (-20.13, -99.5), (-16.93, -96.3),
            (-19.44, -96.3), (-22.64, -99.5), (-23.67, -99.5), (-20.47, -96.3), (-22.97, -96.3),
            (-26.17, -99.5), (-27.2, -99.5), (-24.0, -96.3), (-26.51, -96.3), (-29.71, -99.5),
            (-30.73, -99.5), (-27.53, -96.3), (-30.04, -96.3), (-33.24, -99.5), (-34.27, -99.5),
            (-31.07, -96.3), (-33.57, -96.3), (-36.77, -99.5), (-37.8, -99.5), (-34.6, -96.3),
            (-37.11, -96.3), (-40.31, -99.5), (-41.33, -99.5), (-38.13, -96.3), (-40.64, -96.3),
            (-43.84, -99.5), (-44.87, -99.5), (-41.67, -96.3), (-44.17, -96.3), (-47.37, -99.5),
            (-48.4, -99.5), (-45.2, -96.3), (-47.71, -96.3), (-50.91, -99.5), (-51.93, -99.5),
            (-48.73, -96.3), (-51.24, -96.3), (-54.44, -99.5), (-55.47, -99.5), (-52.27, -96.3),
            (-54.77, -96.3), (-57.97, -99.5), (-59.0, -99.5), (-55.8, -96.3), (-58.31, -96.3),
            (-61.51, -99.5), (-62.53, -99.5), (-59.33, -96.3), (-61.84, -96.3), (-65.04, -99.5),
            (-66.07, -99.5), (-62.87, -96.3), (-65.37, -96.3), (-68.57, -99.5), (-69.6, -99.5),
            (-66.4, -96.3), (-68.91, -96.3), (-72.11, -99.5), (-73.13, -99.5), (-69.93, -96.3),
            (-72.44, -96.3), (-75.64, -99.5), (-76.67, -99.5), (-73.47, -96.3), (-75.97, -96.3),
            (-79.17, -99.5), (-80.2, -99.5), (-77.0, -96.3), (-82.0, -96.3),
        ] on plane 0 color GROUND + GROUND_DARKER;

        // Where the foot comes by, at every ten degrees of the crank.
        circle (-43.17, -91.75) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-39.17, -91.76) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-35.04, -91.79) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-30.82, -91.82) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-26.54, -91.82) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-22.29, -91.74) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-18.16, -91.57) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-14.26, -91.29) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-10.72, -90.89) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-7.69, -90.39) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-5.37, -89.81) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-3.95, -89.19) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-3.68, -88.52) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-4.83, -87.78) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-7.68, -86.82) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-12.41, -85.36) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-18.93, -82.89) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-26.53, -78.9) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-33.76, -73.51) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-39.98, -69.51) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-47.45, -71.16) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-55.44, -75.65) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-61.99, -79.77) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-66.74, -82.96) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-69.76, -85.36) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-71.26, -87.17) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-71.49, -88.57) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-70.68, -89.64) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-69.08, -90.45) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-66.85, -91.04) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-64.16, -91.44) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-61.14, -91.68) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-57.86, -91.8) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-54.39, -91.83) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-50.78, -91.81) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
        circle (-47.04, -91.77) radius 0.6 on plane 1 color GROUND + GROUND_LIGHTER;
    }

    link crank {
        circle (0.0, 0.0) radius 5.0 on plane 7 color RED + DARKER;
        circle (0.0, 0.0) radius 4.5 on plane 7 color RED;
        polygon [
            (1.84, -1.54), (11.45, 9.98), (7.77, 13.06), (-1.84, 1.54),
        ] on plane 7 color RED + DARKER;
        circle (0.0, 0.0) radius RIM on plane 7 color RED + DARKER;
        circle (X1, Y1) radius RIM on plane 7 color RED + DARKER;
        polygon [(1.46, -1.22), (11.07, 10.3), (8.15, 12.74), (-1.46, 1.22)] on plane 7 color RED;
        circle (0.0, 0.0) radius BAR on plane 7 color RED;
        circle (X1, Y1) radius BAR on plane 7 color RED;
        circle (0.0, 0.0) radius PIN on plane 8 color INK;
        circle (0.0, 0.0) radius PIN * 0.4 on plane 8 color EYE;
        circle (X1, Y1) radius PIN on plane 8 color INK;
        circle (X1, Y1) radius PIN * 0.4 on plane 8 color EYE;
    }

    link upper_rod {
        polygon [
            (10.67, 13.67), (-34.18, 35.76), (-36.3, 31.46), (8.55, 9.37),
        ] on plane 5 color GREEN + DARKER;
        circle (X1, Y1) radius RIM on plane 5 color GREEN + DARKER;
        circle (X3, Y3) radius RIM on plane 5 color GREEN + DARKER;
        polygon [
            (10.45, 13.22), (-34.4, 35.31), (-36.08, 31.91), (8.77, 9.82),
        ] on plane 5 color GREEN;
        circle (X1, Y1) radius BAR on plane 5 color GREEN;
        circle (X3, Y3) radius BAR on plane 5 color GREEN;
    }

    link upper_plate {
        // A triangle with round corners: its edge, and the face on it.
        polygon [
            (-35.61, -7.96), (-32.85, 33.45), (-36.79, 35.44), (-79.3, -0.71), (-78.06, -4.92),
            (-38.31, -10.18),
        ] on plane 4 color BLUE + DARKER;
        circle (X2, Y2) radius RIM on plane 4 color BLUE + DARKER;
        circle (X3, Y3) radius RIM on plane 4 color BLUE + DARKER;
        circle (X4, Y4) radius RIM on plane 4 color BLUE + DARKER;
        polygon [
            (-36.1, -7.93), (-33.34, 33.48), (-36.47, 35.06), (-78.98, -1.09), (-78.0, -4.42),
            (-38.25, -9.68),
        ] on plane 4 color BLUE;
        circle (X2, Y2) radius BAR on plane 4 color BLUE;
        circle (X3, Y3) radius BAR on plane 4 color BLUE;
        circle (X4, Y4) radius BAR on plane 4 color BLUE;
        polygon [(-41.0, -1.5), (-39.0, 24.5), (-66.5, 0.8)] on plane 4 color BLUE + LIGHTER;
        circle (X3, Y3) radius PIN on plane 8 color INK;
        circle (X3, Y3) radius PIN * 0.4 on plane 8 color EYE;
        circle (X4, Y4) radius PIN on plane 8 color INK;
        circle (X4, Y4) radius PIN * 0.4 on plane 8 color EYE;
        circle (X2, Y2) radius PIN on plane 8 color INK;
        circle (X2, Y2) radius PIN * 0.4 on plane 8 color EYE;
    }

    link lower_rod {
        polygon [
            (7.5, 12.67), (-22.21, -41.64), (-17.99, -43.94), (11.72, 10.37),
        ] on plane 6 color TEAL + DARKER;
        circle (X1, Y1) radius RIM on plane 6 color TEAL + DARKER;
        circle (X5, Y5) radius RIM on plane 6 color TEAL + DARKER;
        polygon [
            (7.94, 12.43), (-21.77, -41.88), (-18.43, -43.7), (11.28, 10.61),
        ] on plane 6 color TEAL;
        circle (X1, Y1) radius BAR on plane 6 color TEAL;
        circle (X5, Y5) radius BAR on plane 6 color TEAL;
    }

    link rocker {
        polygon [
            (-40.14, -8.89), (-22.24, -43.88), (-17.96, -41.7), (-35.86, -6.71),
        ] on plane 5 color PURPLE + DARKER;
        circle (X2, Y2) radius RIM on plane 5 color PURPLE + DARKER;
        circle (X5, Y5) radius RIM on plane 5 color PURPLE + DARKER;
        polygon [
            (-39.69, -8.67), (-21.79, -43.66), (-18.41, -41.92), (-36.31, -6.93),
        ] on plane 5 color PURPLE;
        circle (X2, Y2) radius BAR on plane 5 color PURPLE;
        circle (X5, Y5) radius BAR on plane 5 color PURPLE;
    }

    link tie {
        polygon [
            (-79.75, -3.86), (-58.05, -36.74), (-54.05, -34.1), (-75.75, -1.22),
        ] on plane 5 color YELLOW + DARKER;
        circle (X4, Y4) radius RIM on plane 5 color YELLOW + DARKER;
        circle (X6, Y6) radius RIM on plane 5 color YELLOW + DARKER;
        polygon [
            (-79.34, -3.59), (-57.64, -36.47), (-54.46, -34.37), (-76.16, -1.49),
        ] on plane 5 color YELLOW;
        circle (X4, Y4) radius BAR on plane 5 color YELLOW;
        circle (X6, Y6) radius BAR on plane 5 color YELLOW;
    }

    link lower_plate {
        point foot = (X7, Y7);
        polygon [
            (-19.62, -40.44), (-55.57, -33.07), (-58.11, -36.66), (-24.28, -92.98),
            (-19.82, -91.84), (-17.7, -42.89),
        ] on plane 4 color ORANGE + DARKER;
        circle (X5, Y5) radius RIM on plane 4 color ORANGE + DARKER;
        circle (X6, Y6) radius RIM on plane 4 color ORANGE + DARKER;
        circle (X7, Y7) radius RIM on plane 4 color ORANGE + DARKER;
        polygon [
            (-19.72, -40.93), (-55.67, -33.56), (-57.68, -36.4), (-23.85, -92.72), (-20.32, -91.82),
            (-18.2, -42.87),
        ] on plane 4 color ORANGE;
        circle (X5, Y5) radius BAR on plane 4 color ORANGE;
        circle (X6, Y6) radius BAR on plane 4 color ORANGE;
        circle (X7, Y7) radius BAR on plane 4 color ORANGE;
        polygon [(-23.3, -45.2), (-49.5, -39.8), (-24.9, -80.5)] on plane 4 color ORANGE + LIGHTER;
        circle (X7, Y7) radius SHOE on plane 4 color INK;
        circle (X5, Y5) radius PIN on plane 8 color INK;
        circle (X5, Y5) radius PIN * 0.4 on plane 8 color EYE;
        circle (X6, Y6) radius PIN on plane 8 color INK;
        circle (X6, Y6) radius PIN * 0.4 on plane 8 color EYE;
    }

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, upper_rod) at (X1, Y1);
    joint c = revolute(upper_rod, upper_plate) at (X3, Y3);
    joint d = revolute(ground, upper_plate) at (X2, Y2);
    joint e = revolute(crank, lower_rod) at (X1, Y1);
    joint f = revolute(lower_rod, rocker) at (X5, Y5);
    joint g = revolute(ground, rocker) at (X2, Y2);
    joint h = revolute(upper_plate, tie) at (X4, Y4);
    joint i = revolute(tie, lower_plate) at (X6, Y6);
    joint j = revolute(rocker, lower_plate) at (X5, Y5);

    motor a;
    effects { acceleration; overlay; }
}

exhibited!(JansenLeg, "jansen-leg", include_str!("jansen.rs"), motion);

/// One turn of the crank.
fn motion<T: Real>(phase: T) -> [T; 1] {
    [-phase * T::TURN]
}
