//! Change points where something else was declared than to go on.

use crate::bed::Bed;
use crate::geometry::four_bar;
use mech_runtime::{Cause, Mechanism};
use std::f64::consts::PI;

const LENGTHS: [f64; 4] = [2.0, 1.0, 2.0, 1.0];

variants! {
    branch_keeper by [exact newton] four_bar [2, 1, 2, 1] {
        motor ja;
        start { ja = 60 deg; rocker near 60 deg; }
        at change points keep branch;
    } {
        it_is_always_folded_in_the_same_sense: same_sense;
    }
}

/// Where rounding hides the side: a sine of so many roots of a unit of rounding.
const HIDDEN: f64 = 16.0;

fn same_sense<M: Mechanism>(bed: Bed<M>) {
    let hidden = HIDDEN * Bed::<M>::EPSILON.sqrt();
    for step in [1.0, 7.0, 30.0, 45.0, 90.0, 120.0, 180.0, -50.0] {
        let mut bed = bed.fresh();
        for number in 1..=1000_u32 {
            let target = f64::to_radians(60.0 + step * f64::from(number));
            if let Err(stuck) = bed.go(&[target]) {
                // An iteration may stop where the branches meet; the closed form has no reason to.
                panic!("{target}: {stuck:?}");
            }
            let should = four_bar(LENGTHS, bed.motor(), true);
            if should.sine > hidden {
                bed.assert_at(("rocker", [1.0, 0.0]), should.at, should.sine);
            }
        }
    }
}

variants! {
    stopper by [exact newton] four_bar [2, 1, 2, 1] {
        motor ja;
        start { ja = 60 deg; rocker near 60 deg; }
        at change points stop;
    } {
        it_stops_at_its_change_points: stops;
    }
}

fn stops<M: Mechanism>(bed: Bed<M>) {
    let hidden = HIDDEN * Bed::<M>::EPSILON.sqrt();
    for (target, place) in [(4.0, PI), (3.2, PI), (10.0, PI), (-1.0, 0.0), (-20.0, 0.0)] {
        let mut bed = bed.fresh();
        let refused = bed.go(&[target]).expect_err("it stops before");
        let stuck = bed.toward(&[target]).expect("it stops before");
        let again = bed.go(&[target]).expect_err("it is there");
        let causes = [refused, stuck, again].map(|stuck| stuck.cause);
        assert_eq!(causes, [Cause::ChangePoint; 3]);
        assert!(
            (bed.motor() - place).abs() < hidden,
            "{target}: {:?}",
            bed.motors()
        );
        for angle in [1.0, 2.5] {
            bed.must(&[angle]);
            let [cos, sin, ..] = bed.pose("rocker");
            let (should_sin, should_cos) = bed.motor().sin_cos();
            let off = (cos - should_cos).hypot(sin - should_sin);
            assert!(off < 512.0 * Bed::<M>::EPSILON, "at {angle} off by {off:e}");
        }
    }
}
