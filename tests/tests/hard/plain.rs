//! Four-bars far from any singularity, and large steps.

use crate::bed::Bed;
use crate::geometry::four_bar;
use mech_runtime::Mechanism;

const PLAIN: [f64; 4] = [4.0, 1.0, 3.5, 3.0];
const NEARLY_FOLDED: [f64; 4] = [4.0, 1.0, 2.55, 2.55];

/// Crank angles in degrees, and where the coupler–rocker joint is there, from 20 to 40 digits.
const ROWS: [(f64, [f64; 2]); 9] = [
    (0.0, [3.041_666_666_666_666_7, 2.842_815_017_235_947_8]),
    (30.0, [3.379_928_337_681_953_3, 2.935_219_094_648_666]),
    (45.0, [3.402_421_202_477_752_2, 2.939_880_878_667_002_1]),
    (90.0, [2.987_218_950_531_729_7, 2.823_875_802_126_918_8]),
    (135.0, [2.311_013_265_926_601_2, 2.479_379_723_262_266_6]),
    (180.0, [1.825, 2.066_246_597_093_386_6]),
    (225.0, [1.657_088_296_922_477, 1.873_703_485_502_01]),
    (270.0, [1.777_486_931_821_211_5, 2.015_052_272_715_154_1]),
    (315.0, [2.248_154_277_474_726, 2.435_371_956_081_842_7]),
];

variants! {
    plain_four_bar by [exact newton newton_4] four_bar [4, 1, 3.5, 3] {
        motor ja;
        start { coupler near 50 deg; }
    } {
        it_is_where_twenty_digits_say: where_twenty_digits_say;
        it_is_where_geometry_says_at_every_degree: |bed| every_degree(bed, PLAIN);
    } and by [linear] {
        frame_to_frame_steps_stay_within_their_promise: linear_steps;
    }
}

variants! {
    nearly_folded_four_bar_in_four_rounds by [newton_4] four_bar [4, 1, 2.55, 2.55] {
        motor ja;
        start { coupler near 50 deg; }
    } {
        it_refuses_steps_that_are_too_long_rather_than_jump: |bed| refused_or_right(&bed, NEARLY_FOLDED);
    }
}

fn where_twenty_digits_say<M: Mechanism>(mut bed: Bed<M>) {
    // The angles are those of the nearest numbers: in single precision the rows themselves are that far off.
    let mut angle = 0.0;
    for (degrees, should) in ROWS {
        while angle <= degrees {
            bed.must(&[f64::to_radians(angle)]);
            angle += 1.0;
        }
        bed.assert_at(("coupler", [3.5, 0.0]), should, 1.0);
        bed.assert_at(("rocker", [3.0, 0.0]), should, 1.0);
    }
}

fn every_degree<M: Mechanism>(mut bed: Bed<M>, lengths: [f64; 4]) {
    for degree in -720..=720 {
        if degree == -720 {
            (-720..=0)
                .rev()
                .for_each(|degree| bed.must(&[f64::from(degree).to_radians()]));
        }
        bed.must(&[f64::from(degree).to_radians()]);
        let should = four_bar(lengths, bed.motor(), true);
        bed.assert_at(("rocker", [lengths[3], 0.0]), should.at, should.sine);
    }
}

fn refused_or_right<M: Mechanism>(bed: &Bed<M>, lengths: [f64; 4]) {
    let (mut right, mut refused) = (0, 0);
    for step in [1.0, 7.0, 30.0, 45.0, 90.0, 120.0, 180.0] {
        let mut bed = bed.fresh();
        for number in 1..=400_u32 {
            match bed.go(&[f64::to_radians(step * f64::from(number))]) {
                Ok(()) => right += 1,
                Err(_) => refused += 1,
            }
            let should = four_bar(lengths, bed.motor(), true);
            bed.assert_at(("rocker", [lengths[3], 0.0]), should.at, should.sine);
        }
    }
    assert!(
        right >= 400 && refused > 0,
        "{right} right, {refused} refused"
    );
}

fn linear_steps<M: Mechanism>(mut bed: Bed<M>) {
    for degree in 1..=720 {
        bed.must(&[f64::from(degree).to_radians()]);
    }
}
