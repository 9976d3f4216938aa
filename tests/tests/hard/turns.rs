//! Ten million turns by exact phases.

use crate::bed::{Bed, Tried};
use crate::geometry::Expected;
use mech_compiler::compile;
use mech_compiler::model::{Method, Precision};
use mech_compiler::program::Real;
use mech_runtime::Phase;
use mech_test_support::model;
use std::f64::consts::TAU;

/// A four-bar whose crank turns a wheel of three times its teeth, and that a pinion.
const TRAIN: &str = "struct Train;
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
    start { coupler near 50 deg; }";

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

fn turn<T: Real>(bed: &mut Bed<'_, T>, phase: Phase) {
    bed.turn_to(phase);
    // 1e-9 rad in double precision, 1e-5 in single.
    let most = if T::EPSILON > 1e-10 { 1e-5 } else { 1e-9 };
    for (link, numerator, denominator) in [("crank", 1, 1), ("wheel", -1, 3), ("pinion", 20, 17)] {
        let should = angle(phase, numerator, denominator);
        let [cos, sin, ..] = bed.pose(link);
        let (s, c) = should.sin_cos();
        let off = (sin * c - cos * s).atan2(cos * c + sin * s);
        assert!(off.abs() < most, "{link} is off by {off:e} at {phase:?}");
    }
}

fn ten_million_turns<T: Real>(method: Method, precision: Precision) {
    let mut model = model(TRAIN);
    (model.method, model.precision) = (Some(method), precision);
    let compiled = compile(&model).expect("it moves");
    let tried = Tried::new(&model, &compiled.program);
    let point = Expected::new("rocker 3 0 = four_bar 4 1 3.5 3");
    let mut bed = Bed::<T>::new(&tried, vec![point]);
    let fraction = |turns: i64| turns.unsigned_abs().wrapping_mul(0x9e37_79b9_7f4a_7c15);
    for turns in (0..10_000_000_i64).step_by(997) {
        turn(&mut bed, Phase::new(turns, fraction(turns)));
    }
    // Degree by degree at the end, and in one leap home.
    for degree in 0..=720 {
        let degrees = Phase::of_turn(degree, 360).expect("a fraction");
        turn(&mut bed, Phase::new(10_000_000, 0) + degrees);
    }
    turn(&mut bed, Phase::ZERO);
    for turns in (0..10_000_000_i64).step_by(4_999) {
        turn(&mut bed, Phase::new(-turns, fraction(turns)));
    }
}

#[test]
fn ten_million_turns_to_and_fro_leave_no_drift() {
    for method in [Method::Exact, Method::Newton] {
        ten_million_turns::<f64>(method, Precision::F64);
        ten_million_turns::<f32>(method, Precision::F32);
    }
}
