//! Nearly a change point, and none: the branch must not flip.

use crate::bed::Bed;
use crate::geometry::{four_bar, slider_crank};
use mech_runtime::Mechanism;

macro_rules! slider_cranks {
    ($($name:ident $length:literal $methods:tt;)*) => { $(
        variants! {
            $name by $methods slider_crank [1, $length, 0] {
                motor ja;
                start { ja = 0 deg; rod near 0 deg; }
            } {
                its_block_never_goes_over_to_the_other_side: |bed| slider_crank_turns(&bed, $length);
            }
        }
    )* };
}

slider_cranks! {
    rod_longer_by_a_hundredth 1.01 [exact newton];
    rod_longer_by_a_ten_thousandth 1.0001 [exact newton];
    rod_longer_by_a_millionth 1.000_001 [exact_f64 newton_f64];
}

macro_rules! gaps {
    ($($name:ident $gap:literal $methods:tt;)*) => { $(
        variants! {
            $name by $methods four_bar [4, 1, (2.5 + $gap / 2), (2.5 + $gap / 2)] {
                motor ja;
                start { coupler near 50 deg; }
            } {
                it_passes_its_nearly_flat_position_unflipped: |bed| nearly_flat(&bed, $gap);
            }
        }
    )* };
}

gaps! {
    gap_of_1e_3 1e-3 [exact newton];
    gap_of_1e_4 1e-4 [exact newton];
    gap_of_1e_5 1e-5 [exact_f64 newton_f64];
    gap_of_1e_6 1e-6 [exact_f64];
    gap_of_1e_7 1e-7 [exact_f64 newton_f64];
    gap_of_1e_8 1e-8 [exact_f64];
    gap_of_1e_9 1e-9 [exact_f64 newton_f64];
}

const STEPS: [f64; 13] = [
    1.0, 7.0, 30.0, 45.0, 90.0, 120.0, 180.0, 300.0, 359.0, 1000.0, -1.5, -77.0, -180.0,
];

fn slider_crank_turns<M: Mechanism>(bed: &Bed<M>, length: f64) {
    for step in STEPS {
        let mut bed = bed.fresh();
        for number in 1..=1500_u32 {
            bed.must(&[f64::to_radians(step * f64::from(number))]);
            let should = slider_crank(1.0, length, 0.0, bed.motor());
            bed.assert_at(("block", [0.0, 0.0]), should.at, should.sine);
        }
    }
    let mut bed = bed.fresh();
    for number in -200..=200 {
        bed.must(&[std::f64::consts::FRAC_PI_2 + 1e-5 * f64::from(number)]);
        let should = slider_crank(1.0, length, 0.0, bed.motor());
        bed.assert_at(("block", [0.0, 0.0]), should.at, should.sine);
    }
}

fn nearly_flat<M: Mechanism>(bed: &Bed<M>, gap: f64) {
    let lengths = [4.0, 1.0, 2.5 + gap / 2.0, 2.5 + gap / 2.0];
    for step in STEPS {
        let mut bed = bed.fresh();
        for number in 1..=1500_u32 {
            bed.must(&[f64::to_radians(step * f64::from(number))]);
            let should = four_bar(lengths, bed.motor(), true);
            bed.assert_at(("rocker", [lengths[3], 0.0]), should.at, should.sine);
        }
    }
    let mut bed = bed.fresh();
    for number in -200..=200 {
        bed.must(&[std::f64::consts::PI + gap.sqrt() * 0.05 * f64::from(number)]);
        let should = four_bar(lengths, bed.motor(), true);
        bed.assert_at(("rocker", [lengths[3], 0.0]), should.at, should.sine);
    }
}
