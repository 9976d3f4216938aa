//! Ten million turns by exact phases.

use crate::bed::Bed;
use crate::geometry::four_bar;
use mech_runtime::{Mechanism, Phase, Real};
use std::f64::consts::TAU;

/// What takes phases: each struct has that of itself.
trait TurnTo {
    fn phase(&mut self, phase: Phase);
}

macro_rules! turned {
    ($($variant:ident $scalar:ident {$($method:tt)*})*) => { $(
        mod $variant {
            use super::*;

            turned! { @train
                struct Train: $scalar;
                ground { point a = (0, 0); point d = (4, 0); point e = (-5, 0); point f = (-9, 0); }
                link crank { point a = (0, 0); point b = (1, 0); }
                link coupler { point b = (0, 0); point c = (3.5, 0); }
                link rocker { point d = (0, 0); point c = (3, 0); }
                link wheel { point e = (0, 0); }
                link pinion { point f = (0, 0); }
                joint ja = revolute(ground.a, crank.a);
                joint jb = revolute(crank.b, coupler.b);
                joint jc = revolute(coupler.c, rocker.c);
                joint jd = revolute(ground.d, rocker.d);
                joint je = revolute(ground.e, wheel.e);
                joint jf = revolute(ground.f, pinion.f);
                joint slow = gear(crank, wheel, 20 : 60);
                joint quick = gear(wheel, pinion, 60 : 17);
                motor ja;
                start { coupler near 50 deg; }
                method $($method)*;
            }
            use train::Train;

            impl TurnTo for Train {
                fn phase(&mut self, phase: Phase) {
                    self.turn_to([phase]).expect("it turns for ever");
                }
            }

            #[test]
            fn ten_million_turns_leave_no_drift() {
                ten_million_turns(Bed::<Train>::new(TEXT));
            }

            #[test]
            fn backwards_for_ten_million_turns_leaves_no_drift() {
                backwards(Bed::<Train>::new(TEXT));
            }
        }
    )* };
    (@train $($text:tt)*) => {
        mod train {
            mech_runtime::mechanism! { pub(super) $($text)* }
        }
        const TEXT: &str = stringify!($($text)*);
    };
}

turned! {
    exact_f64 f64 {exact}
    exact_f32 f32 {exact}
    newton_f64 f64 {newton}
    newton_f32 f32 {newton}
}

/// The angle of a phase times a ratio, less whole turns, in whole numbers but for the last step.
fn angle(phase: Phase, numerator: i128, denominator: i128) -> f64 {
    let units = (i128::from(phase.turns()) << 64) + i128::from(phase.fraction());
    let whole = denominator << 64;
    // Within a turn before it becomes a float: 2^-53 of a turn of the wheel.
    let remainder = (units * numerator).rem_euclid(whole);
    #[expect(clippy::cast_precision_loss, reason = "an angle in double precision")]
    let part = remainder as f64 / whole as f64;
    TAU * part
}

fn assert_phase<M: Mechanism>(bed: &mut Bed<M>, phase: Phase) {
    // 1e-9 rad in double precision, 1e-5 in single.
    let most = if Bed::<M>::EPSILON > 1e-10 {
        1e-5
    } else {
        1e-9
    };
    for (link, numerator, denominator) in [("crank", 1, 1), ("wheel", -1, 3), ("pinion", 20, 17)] {
        let should = angle(phase, numerator, denominator);
        let [cos, sin, ..] = bed.pose(link);
        let (s, c) = should.sin_cos();
        let off = (sin * c - cos * s).atan2(cos * c + sin * s);
        assert!(off.abs() < most, "{link} is off by {off:e} at {phase:?}");
    }
    let should = four_bar([4.0, 1.0, 3.5, 3.0], angle(phase, 1, 1), true);
    bed.assert_at(("rocker", [3.0, 0.0]), should.at, should.sine);
    bed.assert_whole();
}

fn ten_million_turns<M: Mechanism<Scalar: Real> + TurnTo>(mut bed: Bed<M>) {
    for turns in (0..10_000_000_i64).step_by(997) {
        let phase = Phase::new(
            turns,
            turns.unsigned_abs().wrapping_mul(0x9e37_79b9_7f4a_7c15),
        );
        bed.mechanism.phase(phase);
        assert_phase(&mut bed, phase);
    }
    // Degree by degree at the end, and in one leap home.
    for degree in 0..=720 {
        let phase = Phase::new(10_000_000, 0) + Phase::of_turn(degree, 360).expect("a fraction");
        bed.mechanism.phase(phase);
        assert_phase(&mut bed, phase);
    }
    bed.mechanism.phase(Phase::ZERO);
    assert_phase(&mut bed, Phase::ZERO);
}

fn backwards<M: Mechanism<Scalar: Real> + TurnTo>(mut bed: Bed<M>) {
    for turns in (0..10_000_000_i64).step_by(4_999) {
        let phase = Phase::new(
            -turns,
            turns.unsigned_abs().wrapping_mul(0x9e37_79b9_7f4a_7c15),
        );
        bed.mechanism.phase(phase);
        assert_phase(&mut bed, phase);
    }
}
