//! Loops with two slides and more.

use crate::bed::Bed;
use mech_runtime::Mechanism;

macro_rules! wedges {
    ($($name:ident $slope:literal $methods:tt;)*) => { $(
        variants! {
            $name by $methods {
                link crank;
                link block;
                link yoke;
                joint a = revolute(ground, crank) at (0, 0);
                joint b = revolute(crank, block) at (0.6, 0.8);
                joint s = prismatic(block, yoke) at (0.6, 0.8) along (1, $slope);
                joint x = prismatic(ground, yoke) at (0.6, 0.8) along (1, 0);
                motor a;
            } {
                it_errs_by_no_more_than_rounding_by_the_sine_of_the_angle: |bed| yoke(bed, $slope);
            }
        }
    )* };
}

wedges! {
    guides_at_1e_2 1e-2 [exact newton linear];
    guides_at_1e_3 1e-3 [exact newton linear];
    guides_at_1e_4 1e-4 [exact newton linear];
    guides_at_1e_5 1e-5 [exact_f64 newton_f64];
}

variants! {
    three_slides by [exact newton linear] {
        link wedge;
        link follower { point tip = (2, 3); }
        joint x = prismatic(ground, wedge) at (0, 0) along (1, 0);
        joint face = prismatic(wedge, follower) at (2, 1) along (2, 1);
        joint y = prismatic(ground, follower) at (2, 2) along (0, 1);
        motor x;
    } {
        a_wedge_lifts_by_half_its_displacement: wedge;
    }
}

variants! {
    four_slides by [exact newton linear] {
        link a;
        link b;
        link c;
        joint x = prismatic(ground, a) at (0, 0) along (1, 0);
        joint y = prismatic(a, b) at (1, 0) along (0, 1);
        joint u = prismatic(b, c) at (1, 1) along (1, 1);
        joint v = prismatic(ground, c) at (2, 1) along (1, -2);
        motor x;
        motor y;
    } {
        two_motors_move_them_anywhere: four;
    }
}

/// The block's pin is on the yoke's slanted way: it goes down by as much as the way rises.
fn yoke<M: Mechanism>(mut bed: Bed<M>, slope: f64) {
    for degree in 1..=720 {
        bed.must(&[f64::from(degree).to_radians()]);
        let (sin, cos) = bed.motor().sin_cos();
        let pin = [0.6 * cos - 0.8 * sin, 0.6 * sin + 0.8 * cos];
        let (across, up) = (pin[0] - 0.6, pin[1] - 0.8);
        bed.assert_at(("block", [0.6, 0.8]), pin, 1.0);
        let [_, _, x, y] = bed.pose("yoke");
        let off = (x - (across - up / slope)).hypot(y);
        let most = 64.0 * Bed::<M>::EPSILON * 4.0 / slope;
        assert!(
            off <= most,
            "at {degree} off by {off:e}, more than {most:e}"
        );
    }
}

fn wedge<M: Mechanism>(mut bed: Bed<M>) {
    for number in 0..200_u32 {
        let value = f64::from(number * 37 % 200) * 0.1 - 10.0;
        bed.must(&[value]);
        let value = bed.motor();
        bed.assert_at(("follower", [2.0, 3.0]), [2.0, 3.0 - value / 2.0], 0.4);
        bed.assert_at(("wedge", [0.0, 0.0]), [value, 0.0], 1.0);
    }
    // As far as one likes: relative to how far that is.
    for value in [1e3, 1e9, -1e20, 1e30] {
        let mut bed = bed.fresh();
        bed.must(&[value]);
        let value = bed.motor();
        bed.assert_at(("follower", [2.0, 3.0]), [2.0, 3.0 - value / 2.0], 0.4);
    }
}

fn four<M: Mechanism>(mut bed: Bed<M>) {
    for number in 0..400_u32 {
        let part = |factor: u32| f64::from(number * factor % 200) * 0.05 - 5.0;
        bed.must(&[part(37), part(61)]);
        let motors = bed.motors();
        let (x, y) = (motors[0], motors[1]);
        bed.assert_at(("b", [0.0, 0.0]), [x, y], 1.0);
        // c is where (x, y) + u (1, 1) = v (1, -2).
        let v = (x - y) / 3.0;
        bed.assert_at(("c", [0.0, 0.0]), [v, -2.0 * v], 0.3);
    }
}
