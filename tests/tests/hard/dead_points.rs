//! Up to a dead point, at it, and beyond it.

use crate::bed::Bed;
use crate::geometry::four_bar;
use mech_runtime::{Cause, Mechanism};

const LENGTHS: [f64; 4] = [4.0, 1.0, 2.0, 1.5];
/// acos(0.59375).
const LIMIT: f64 = 0.935_085_041_393_594_5;

variants! {
    /// Ground 4, crank 1, coupler 2, rocker 1.5.
    short_four_bar by [exact newton] four_bar [4, 1, 2, 1.5] {
        motor ja;
        start { ja = 0 deg; rocker near 120 deg; }
    } {
        it_comes_as_near_as_one_likes_to_its_dead_point: nearer_and_nearer;
        it_comes_there_from_the_start_in_one_leap: in_one_leap;
        it_stands_exactly_at_its_dead_point: exactly_there;
        it_is_blocked_beyond_and_tells_the_limit: beyond;
        it_comes_back_from_its_dead_point_on_its_own_side: back;
        it_goes_to_and_fro_between_its_dead_points: to_and_fro;
    }
}

variants! {
    /// The same with four rounds of iteration: it may refuse, but where it is it closes.
    short_four_bar_in_four_rounds by [newton_4] four_bar [4, 1, 2, 1.5] {
        motor ja;
        start { ja = 0 deg; rocker near 120 deg; }
    } {
        near_its_dead_point_it_is_right_or_refuses: right_or_refused;
    }
}

fn distances() -> impl Iterator<Item = f64> {
    (1..=16).map(|digits| 10.0_f64.powi(-digits))
}

#[track_caller]
fn assert_right<M: Mechanism>(bed: &mut Bed<M>) {
    let should = four_bar(LENGTHS, bed.motor(), true);
    bed.assert_at(("rocker", [1.5, 0.0]), should.at, should.sine);
    bed.assert_at(("coupler", [2.0, 0.0]), should.at, should.sine);
}

fn nearer_and_nearer<M: Mechanism>(mut bed: Bed<M>) {
    for distance in distances() {
        bed.must(&[LIMIT - distance]);
        assert_right(&mut bed);
    }
}

fn in_one_leap<M: Mechanism>(bed: Bed<M>) {
    for distance in distances() {
        for side in [1.0, -1.0] {
            let mut bed = bed.fresh();
            bed.must(&[side * (LIMIT - distance)]);
            assert_right(&mut bed);
        }
    }
}

fn exactly_there<M: Mechanism>(mut bed: Bed<M>) {
    bed.must(&[LIMIT]);
    assert_right(&mut bed);
    bed.must(&[-LIMIT]);
    assert_right(&mut bed);
}

fn beyond<M: Mechanism>(bed: Bed<M>) {
    // In double precision within 1e-12, in single as many units of rounding.
    let most = 1e-12 / f64::EPSILON * Bed::<M>::EPSILON;
    for target in [0.95, 1.0, 2.0, 3.0, 6.0, 7.0, 100.0, -1.0, -2.0, -3.0, -6.0] {
        let limit = LIMIT.copysign(target);
        let mut bed = bed.fresh();
        let stuck = bed.go(&[target]).expect_err("there is a dead point");
        assert_eq!(bed.motor(), 0.0);
        assert!(
            matches!(stuck.cause, Cause::Open | Cause::DeadPoint),
            "{stuck:?}"
        );
        let off = stuck.reached[0] - limit;
        assert!(off.abs() <= most, "to {target}: reached is off by {off:e}");
        let there = bed.toward(&[target]).expect("there is a dead point");
        assert_eq!(there, stuck, "it goes where it said it could");
        assert_right(&mut bed);
        // At the limit it is blocked where it is, and can go back.
        let again = bed.go(&[target]).expect_err("there is a dead point");
        assert!((again.reached[0] - limit).abs() <= most, "{again:?}");
        bed.must(&[0.0]);
        assert_right(&mut bed);
    }
}

fn back<M: Mechanism>(mut bed: Bed<M>) {
    for distance in distances() {
        bed.must(&[LIMIT - distance]);
        bed.must(&[0.3]);
        assert_right(&mut bed);
        assert!(bed.toward(&[2.0]).is_some());
        bed.must(&[LIMIT - distance]);
        assert_right(&mut bed);
        bed.must(&[-0.5]);
        assert_right(&mut bed);
    }
}

fn to_and_fro<M: Mechanism>(mut bed: Bed<M>) {
    for number in 0..500_u32 {
        let target = if number % 2 == 0 { 1.7 } else { -1.3 };
        assert!(bed.toward(&[target]).is_some());
        assert_right(&mut bed);
    }
}

fn right_or_refused<M: Mechanism>(mut bed: Bed<M>) {
    for degree in 1..=50 {
        bed.must(&[f64::from(degree).to_radians()]);
        assert_right(&mut bed);
    }
    for distance in distances() {
        let _ = bed.go(&[LIMIT - distance]);
        assert_right(&mut bed);
    }
    bed.go(&[1.0]).expect_err("there is a dead point");
}
