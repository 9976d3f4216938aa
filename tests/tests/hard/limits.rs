//! How far it goes, against limits from formulas.

use crate::bed::Bed;
use crate::geometry::{bisect, four_bar};
use mech_runtime::{Mechanism, Reached, Real};
use std::f64::consts::{FRAC_PI_2, PI};

variants! {
    /// An arm that a pin drives past a guide of its own: 0.5 beside its shaft, 2 below that of the crank of 1.7.
    offset_arm by [exact newton] {
        ground { point a = (0, 2); point d = (0, 0); }
        link crank { point a = (0, 0); point b = (1.7, 0); }
        link die { point b = (0, 0); line way = (0, 0) -> (1, 0); }
        link arm { point d = (0, 0); line way = (0, 0.5) -> (1, 0); }
        joint ja = revolute(ground.a, crank.a);
        joint jb = revolute(crank.b, die.b);
        joint x = prismatic(arm.way, die.way);
        joint jd = revolute(ground.d, arm.d);
        motor ja;
        start { ja = 0 deg; arm near 40 deg; }
    } {
        it_ends_where_the_pin_is_at_the_height_of_the_guide: arm_ends;
    }
}

variants! {
    /// An offset slider-crank whose rod is too short: 2 sin t is at most 0.5 + 1.5 and at least 0.5 − 1.5.
    offset_rocker by [exact newton] slider_crank [2, 1.5, 0.25] {
        motor ja;
        start { rod near 0 deg; }
    } {
        it_ends_where_its_rod_is_across_its_guide: offset_rocker_ends;
    }
}

fn offset_rocker_ends<M: Mechanism>(bed: Bed<M>) {
    let (up, down) = (0.875_f64.asin(), -0.625_f64.asin());
    ends(
        &bed,
        &[(2.0, up), (1.1, up), (30.0, up), (-1.0, down), (-5.0, down)],
    );
}

variants! {
    /// A slider-crank whose block a motor pushes, offset by 0.5: it ends stretched and folded.
    pushed by [exact newton] slider_crank [1, 3, 0.5] {
        motor x;
        start { x = 3; crank near 80 deg; }
    } {
        it_ends_stretched_and_folded: |bed| {
            ends(&bed, &[(5.0, 15.75_f64.sqrt()), (1e4, 15.75_f64.sqrt()), (0.0, 3.75_f64.sqrt()), (-7.0, 3.75_f64.sqrt())]);
        };
    }
}

variants! {
    /// A plain four-bar whose rocker carries a rod to a block that cannot follow it up: two loops.
    six_bar by [exact newton] {
        ground { point a = (0, 0); point d = (4, 0); line way = (0, 1.95) -> (1, 0); }
        link crank { point a = (0, 0); point b = (1, 0); }
        link coupler { point b = (0, 0); point c = (3.5, 0); }
        link rocker { point d = (0, 0); point c = (3, 0); }
        link rod { point c = (0, 0); point e = (0.9, 0); }
        link block { point e = (0, 0); line way = (0, 0) -> (1, 0); }
        joint ja = revolute(ground.a, crank.a);
        joint jb = revolute(crank.b, coupler.b);
        joint jc = revolute(coupler.c, rocker.c);
        joint jd = revolute(ground.d, rocker.d);
        joint je = revolute(rocker.c, rod.c);
        joint jf = revolute(rod.e, block.e);
        joint x = prismatic(ground.way, block.way);
        motor ja;
        start { ja = 180 deg; coupler near 40 deg; rod near 0 deg; }
    } {
        its_first_loop_ends_where_its_second_does: six_bar_ends;
    }
}

fn arm_ends<M: Mechanism>(bed: Bed<M>) {
    // 2² + 1.7² + 2 · 2 · 1.7 sin t = 0.5².
    let dip = (6.64_f64 / 6.8).asin();
    let up = PI + dip;
    ends(
        &bed,
        &[
            (-3.0, -dip),
            (-2.0, -dip),
            (-10.0, -dip),
            (5.0, up),
            (6.0, up),
        ],
    );
}

fn six_bar_ends<M: Mechanism>(bed: Bed<M>) {
    let over = |angle: f64| four_bar([4.0, 1.0, 3.5, 3.0], angle, true).at[1] - 2.85;
    let (before, after) = (
        bisect(FRAC_PI_2 - 0.5, PI, over),
        bisect(2.0 * PI - 0.1, 2.0 * PI + 0.8, over),
    );
    ends(
        &bed,
        &[(0.0, before), (-20.0, before), (6.8, after), (12.0, after)],
    );
}

/// From the start towards a target, and the limit there.
#[track_caller]
fn ends<M: Mechanism>(bed: &Bed<M>, limits: &[(f64, f64)]) {
    // In double precision within 1e-12, in single as many units of rounding.
    let most = 1e-12 / f64::EPSILON * Bed::<M>::EPSILON;
    for &(target, limit) in limits {
        let mut bed = bed.fresh();
        let start = bed.motor();
        let refused = bed.go(&[target]).expect_err("it ends before");
        let stuck = bed.toward(&[target]).expect("it ends before");
        assert_eq!(refused, stuck, "it goes where it said it could");
        let off = bed.motor() - limit;
        assert!(
            off.abs() <= most,
            "to {target}: it ends at {:?}, off by {off:e}",
            bed.motor()
        );
        // It is not past its limit by more than rounding, and can go back, and comes here again from there.
        bed.must(&[f64::midpoint(start, limit)]);
        assert!(bed.toward(&[target]).is_some());
        let off = bed.motor() - limit;
        assert!(off.abs() <= most, "a second time it ends off by {off:e}");
        bed.must(&[start]);
    }
    let mut bed = bed.fresh();
    let here = bed.mechanism.motors();
    assert!(matches!(
        bed.mechanism.move_toward(here),
        Ok(Reached::Target)
    ));
    let mut nowhere = here;
    nowhere.as_mut()[0] = <M::Scalar as Real>::from_f64(f64::NAN);
    assert!(bed.mechanism.move_toward(nowhere).is_err());
    assert_eq!(bed.mechanism.motors(), here);
}
