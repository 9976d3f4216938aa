//! Through change points with continuous velocity: as declared by default.

use crate::bed::Bed;
use crate::geometry::{four_bar, mirrored, slider_crank};
use mech_runtime::Mechanism;
use mech_test_support::Dice;
use std::f64::consts::PI;

const STEPS: [f64; 11] = [
    1.0, 7.0, 30.0, 45.0, 60.0, 90.0, 120.0, 180.0, 359.0, -30.0, -90.0,
];
const TURNS: f64 = 100.0;

variants! {
    parallelogram by [exact newton] four_bar [2, 1, 2, 1] {
        motor ja;
        start { ja = 60 deg; rocker near 60 deg; }
        at change points go on;
    } {
        it_stays_one_for_a_hundred_turns: |bed| hundred_turns(&bed, RHOMBOID, &parallelogram_at);
        it_returns_the_way_it_came: |bed| to_and_fro(bed, RHOMBOID, &parallelogram_at);
        it_turns_round_on_its_change_points: |bed| round_at(bed, RHOMBOID, &parallelogram_at, PI);
        it_passes_in_the_smallest_steps: |bed| slowly(bed, RHOMBOID, &parallelogram_at, PI);
    }
}

variants! {
    antiparallelogram by [exact newton] four_bar [2, 1, 2, 1] {
        motor ja;
        start { ja = 60 deg; rocker near -60 deg; }
    } {
        it_stays_one_for_a_hundred_turns: |bed| hundred_turns(&bed, RHOMBOID, &antiparallelogram_at);
        it_returns_the_way_it_came: |bed| to_and_fro(bed, RHOMBOID, &antiparallelogram_at);
        it_turns_round_on_its_change_points: |bed| round_at(bed, RHOMBOID, &antiparallelogram_at, PI);
        it_passes_in_the_smallest_steps: |bed| slowly(bed, RHOMBOID, &antiparallelogram_at, PI);
    }
}

variants! {
    kite by [exact newton] four_bar [1, 1, 2, 2] {
        motor ja;
        start { ja = 60 deg; rocker near 45 deg; }
    } {
        it_goes_round_in_frames_that_miss_the_meeting_of_its_pins: |bed| in_between(&bed, KITE, &kite_at);
        it_goes_round_in_two_turns_for_a_hundred: |bed| hundred_turns(&bed, KITE, &kite_at);
        it_returns_the_way_it_came: |bed| to_and_fro(bed, KITE, &kite_at);
        it_turns_round_where_its_pins_meet: |bed| round_at(bed, KITE, &kite_at, 2.0 * PI);
        it_passes_in_the_smallest_steps: |bed| slowly(bed, KITE, &kite_at, 2.0 * PI);
        its_end_is_at_3_0_where_its_pins_meet: pins_meet;
    }
}

variants! {
    /// Its ground is no whole number: where its pins meet only rounding is left of the way between them.
    tilted_kite by [exact newton] {
        ground { point a = (0, 0); point d = (cos(0.3), sin(0.3)); }
        link crank { point a = (0, 0); point b = (1, 0); }
        link coupler { point b = (0, 0); point c = (2, 0); }
        link rocker { point d = (0, 0); point c = (2, 0); }
        joint ja = revolute(ground.a, crank.a);
        joint jb = revolute(crank.b, coupler.b);
        joint jc = revolute(coupler.c, rocker.c);
        joint jd = revolute(ground.d, rocker.d);
        motor ja;
        start { ja = 1.3; rocker near 1.1; }
    } {
        it_passes_where_its_pins_meet: tilted_pins_meet;
    }
}

variants! {
    square by [exact newton] four_bar [1, 1, 1, 1] {
        motor ja;
        start { ja = 60 deg; rocker near 60 deg; }
    } {
        it_stays_a_rhomb_in_frames_that_miss_the_meeting_of_its_pins: |bed| in_between(&bed, SQUARE, &square_at);
        it_stays_a_rhomb_for_a_hundred_turns: |bed| hundred_turns(&bed, SQUARE, &square_at);
        it_returns_the_way_it_came: |bed| to_and_fro(bed, SQUARE, &square_at);
        it_turns_round_on_its_change_points: |bed| round_at(bed, SQUARE, &square_at, PI);
        it_passes_in_the_smallest_steps: |bed| slowly(bed, SQUARE, &square_at, PI);
    }
}

variants! {
    /// Crank and rod of one length: the block goes through the shaft.
    equal_slider_crank by [exact newton] {
        ground { point a = (0, 0); line way = (0, 0) -> (1, 0); }
        link crank { point a = (0, 0); point b = (1, 0); }
        link rocker { point b = (0, 0); point c = (1, 0); }
        link block { point c = (0, 0); line way = (0, 0) -> (1, 0); }
        joint ja = revolute(ground.a, crank.a);
        joint jb = revolute(crank.b, rocker.b);
        joint jc = revolute(rocker.c, block.c);
        joint x = prismatic(ground.way, block.way);
        motor ja;
        start { ja = 60 deg; rocker near -60 deg; }
    } {
        its_block_is_at_twice_the_cosine_for_a_hundred_turns: |bed| hundred_turns(&bed, EQUAL, &equal_at);
        it_returns_the_way_it_came: |bed| to_and_fro(bed, EQUAL, &equal_at);
        it_turns_round_on_its_change_points: |bed| round_at(bed, EQUAL, &equal_at, PI / 2.0);
        it_passes_in_the_smallest_steps: |bed| slowly(bed, EQUAL, &equal_at, PI / 2.0);
    }
}

/// The length of the rocker, and the sine of the transmission angle at a crank angle.
type Kind = (f64, fn(f64) -> f64);

const RHOMBOID: Kind = (1.0, |angle| {
    four_bar([2.0, 1.0, 2.0, 1.0], angle, true).sine
});
const KITE: Kind = (2.0, |angle| {
    four_bar([1.0, 1.0, 2.0, 2.0], angle, true).sine
});
const SQUARE: Kind = (1.0, |angle| four_bar([1.0; 4], angle, true).sine);
const EQUAL: Kind = (1.0, |angle| slider_crank(1.0, 1.0, 0.0, angle).sine);

type At = dyn Fn(f64) -> [f64; 2];

fn parallelogram_at(angle: f64) -> [f64; 2] {
    [2.0 + angle.cos(), angle.sin()]
}

/// The parallelogram's corner on the other side of the diagonal.
fn antiparallelogram_at(angle: f64) -> [f64; 2] {
    mirrored(
        parallelogram_at(angle),
        [angle.cos(), angle.sin()],
        [2.0, 0.0],
    )
}

/// On the axis of symmetry through the ground's crank shaft, at half the crank's angle.
fn kite_at(angle: f64) -> [f64; 2] {
    let (sin, cos) = (angle / 2.0).sin_cos();
    let far = cos + (4.0 - sin * sin).sqrt();
    [far * cos, far * sin]
}

fn square_at(angle: f64) -> [f64; 2] {
    [1.0 + angle.cos(), angle.sin()]
}

fn equal_at(angle: f64) -> [f64; 2] {
    [2.0 * angle.cos(), 0.0]
}

#[track_caller]
fn assert_there<M: Mechanism>(bed: &mut Bed<M>, (length, sine): Kind, at: &At) {
    let angle = bed.motor();
    bed.assert_at(("rocker", [length, 0.0]), at(angle), sine(angle));
}

fn hundred_turns<M: Mechanism>(bed: &Bed<M>, kind: Kind, at: &At) {
    for step in STEPS {
        let mut bed = bed.fresh();
        let mut degrees = 60.0_f64;
        while degrees.abs() < 360.0 * TURNS {
            degrees += step;
            bed.must(&[degrees.to_radians()]);
            assert_there(&mut bed, kind, at);
        }
    }
}

/// In steps that never come to a change point, but pass it.
fn in_between<M: Mechanism>(bed: &Bed<M>, kind: Kind, at: &At) {
    for step in [1.1, 7.7, 29.3, 91.7, 131.3, -44.1] {
        let mut bed = bed.fresh();
        let mut degrees = 60.05_f64;
        while degrees.abs() < 360.0 * TURNS {
            degrees += step;
            if (degrees / 180.0 - (degrees / 180.0).round()).abs() > 1e-4 {
                bed.must(&[degrees.to_radians()]);
                assert_there(&mut bed, kind, at);
            }
        }
    }
}

/// At random, by little and by much, now and then exactly to a change point or past it.
fn to_and_fro<M: Mechanism>(mut bed: Bed<M>, kind: Kind, at: &At) {
    let mut dice = Dice::new(7);
    let mut angle = 1.0;
    for _ in 0..4000 {
        let quarters = (2.0 * angle / PI).round();
        angle = match dice.below(6) {
            0 => quarters * PI / 2.0,
            1 => (quarters + 1.0) * PI / 2.0,
            2 => quarters * PI / 2.0 + dice.between(-1e-3, 1e-3),
            3 => quarters * PI / 2.0 + dice.between(-1e-7, 1e-7),
            _ => angle + dice.between(-3.0, 3.0),
        };
        if angle.abs() > 40.0 {
            angle = 1.0;
        }
        bed.must(&[angle]);
        assert_there(&mut bed, kind, at);
    }
}

/// To a change point exactly, to rest there, and back.
fn round_at<M: Mechanism>(mut bed: Bed<M>, kind: Kind, at: &At, place: f64) {
    for before in [1.0, 0.1, 1e-3, -1.0, -0.1, -1e-3] {
        for rests in 1..=3 {
            bed.must(&[place - before]);
            assert_there(&mut bed, kind, at);
            for _ in 0..rests {
                bed.must(&[place]);
                assert_there(&mut bed, kind, at);
            }
            bed.must(&[place - before]);
            assert_there(&mut bed, kind, at);
            // To it, and on; and the same back.
            for target in [place, place + before, place, place - 0.5 * before] {
                bed.must(&[target]);
                assert_there(&mut bed, kind, at);
            }
        }
    }
}

fn slowly<M: Mechanism>(mut bed: Bed<M>, kind: Kind, at: &At, place: f64) {
    for reach in [1e-2, 1e-4, 1e-6, 1e-8] {
        for sign in [1.0, -1.0] {
            for number in -20..=20 {
                bed.must(&[place + sign * f64::from(number) * reach]);
                assert_there(&mut bed, kind, at);
            }
        }
    }
}

fn pins_meet<M: Mechanism>(mut bed: Bed<M>) {
    bed.must(&[0.0]);
    bed.assert_at(("rocker", [2.0, 0.0]), [3.0, 0.0], 1.0);
    bed.must(&[-1.0]);
    assert_there(&mut bed, KITE, &kite_at);
}

fn tilted_pins_meet<M: Mechanism>(mut bed: Bed<M>) {
    const TILT: f64 = 0.3;
    let (sin, cos) = TILT.sin_cos();
    for angle in [0.0, -1.0, -1e-4, 0.0, 1e-4, 0.0, 1e-6, -1e-6, 0.0, 2.0] {
        bed.must(&[angle + TILT]);
        let [x, y] = kite_at(angle);
        bed.assert_at(
            ("rocker", [2.0, 0.0]),
            [cos * x - sin * y, sin * x + cos * y],
            1.0,
        );
    }
}
