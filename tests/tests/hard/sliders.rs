//! Slider-cranks: offset, too short to turn, and driven from the block.

use crate::bed::Bed;
use crate::geometry::slider_crank;
use mech_runtime::{Cause, Mechanism};
use std::f64::consts::FRAC_PI_6;

variants! {
    centric_slider_crank by [exact newton newton_4] slider_crank [1, 3, 0] {
        motor ja;
        start { rod near 0 deg; }
    } {
        it_passes_its_dead_centres: |bed| turns(bed, 3.0, 0.0, &[(0.0, 4.0), (180.0, 2.0)]);
    }
}

variants! {
    offset_slider_crank by [exact newton newton_4] slider_crank [1, 3, 0.5] {
        motor ja;
        start { rod near 0 deg; }
    } {
        it_is_where_twenty_digits_say: |bed| turns(bed, 3.0, 0.5, &OFFSET);
    }
}

variants! {
    slider_crank_with_a_short_rod by [exact newton] slider_crank [1, 0.5, 0] {
        motor ja;
        start { rod near 0 deg; }
    } {
        it_turns_by_thirty_degrees_and_no_further: thirty_degrees;
    }
}

variants! {
    engine by [exact newton] slider_crank [1, 3, 0] {
        motor x;
        start { x = 3; crank near 80 deg; }
    } {
        driven_from_its_block_it_ends_at_its_dead_centres: dead_centres;
    }
}

const OFFSET: [(f64, f64); 4] = [
    (0.0, 3.958_039_891_549_808),
    (90.0, 2.958_039_891_549_808),
    (180.0, 1.958_039_891_549_808),
    (270.0, 2.598_076_211_353_316),
];

fn turns<M: Mechanism>(mut bed: Bed<M>, rod: f64, offset: f64, rows: &[(f64, f64)]) {
    for degree in 0..=1080 {
        let degrees = f64::from(degree);
        bed.must(&[degrees.to_radians()]);
        let should = slider_crank(1.0, rod, offset, bed.motor());
        bed.assert_at(("block", [0.0, 0.0]), should.at, should.sine);
        bed.assert_at(("rod", [rod, 0.0]), should.at, should.sine);
        for (_, x) in rows.iter().filter(|row| row.0 == degrees) {
            bed.assert_at(("block", [0.0, 0.0]), [*x, offset], 1.0);
        }
    }
}

fn thirty_degrees<M: Mechanism>(bed: Bed<M>) {
    let most = 1e-12 / f64::EPSILON * Bed::<M>::EPSILON;
    for sign in [1.0, -1.0] {
        let mut bed = bed.fresh();
        for number in (0..=30).chain((0..30).rev()) {
            bed.must(&[sign * FRAC_PI_6 * f64::from(number) / 30.0]);
            let should = slider_crank(1.0, 0.5, 0.0, bed.motor());
            bed.assert_at(("block", [0.0, 0.0]), should.at, should.sine);
        }
        for target in [0.53, 1.0, 2.0, 3.0, 6.0] {
            let stuck = bed.go(&[sign * target]).expect_err("the rod is too short");
            assert!(matches!(stuck.cause, Cause::Open | Cause::DeadPoint));
            let off = stuck.reached[0] - sign * FRAC_PI_6;
            assert!(off.abs() <= most, "to {target}: off by {off:e}");
        }
    }
}

fn dead_centres<M: Mechanism>(bed: Bed<M>) {
    let most = 1e-12 / f64::EPSILON * Bed::<M>::EPSILON;
    for (target, limit) in [
        (5.0, 4.0),
        (4.001, 4.0),
        (1.0, 2.0),
        (-3.0, 2.0),
        (-1e3, 2.0),
    ] {
        let mut bed = bed.fresh();
        let stuck = bed.go(&[target]).expect_err("there is a dead centre");
        let off = stuck.reached[0] - limit;
        assert!(off.abs() <= most, "to {target}: off by {off:e}");
        assert!(bed.toward(&[target]).is_some());
        bed.must(&[3.0]);
        assert_crank(&mut bed);
    }
    let mut bed = bed.fresh();
    for digits in 1..=16 {
        for place in [4.0 - 10.0_f64.powi(-digits), 2.0 + 10.0_f64.powi(-digits)] {
            bed.must(&[place]);
            assert_crank(&mut bed);
        }
    }
    for place in [4.0, 2.0, 4.0, 3.0, 2.0] {
        bed.must(&[place]);
        assert_crank(&mut bed);
    }
}

/// The crank pin, by the law of cosines in factors, always above the guide.
fn assert_crank<M: Mechanism>(bed: &mut Bed<M>) {
    let x = bed.motor();
    let area = ((4.0 - x) * (4.0 + x) * (x - 2.0) * (x + 2.0))
        .max(0.0)
        .sqrt();
    let along = (x * x - 8.0) / (2.0 * x);
    bed.assert_at(("crank", [1.0, 0.0]), [along, area / (2.0 * x)], area / 6.0);
}
