//! Exact angles, and the numerics that everything stands on.

use super::moves::BAD;
use super::recorder::Recorder;
use core::hint::black_box;
use mech_probes::Listener;
use mech_runtime::{Phase, Real};

/// Asks for all of it.
pub(super) fn ask(listener: &mut impl Listener) {
    let recorder = &mut Recorder::new(listener, "f64");
    for number in [0.0, 0.3, -2.75, 1e9, 4e18, 1e19].into_iter().chain(BAD) {
        phases(recorder, black_box(number));
    }
    for (numerator, denominator) in [(1, 360), (-7, 3), (i64::MIN, 1), (i64::MAX, u64::MAX), (5, 0)]
    {
        let phase = Phase::of_turn(black_box(numerator), black_box(denominator));
        recorder.record("of-turn", &phase);
    }
    for number in [0.0, 0.3, -2.0, 1e3, 1e5, 3e9, 1e16].into_iter().chain(BAD) {
        functions::<f64>(&mut Recorder::new(listener, "f64"), number);
        functions::<f32>(&mut Recorder::new(listener, "f32"), number);
    }
}

fn phases(recorder: &mut Recorder<impl Listener>, number: f64) {
    let (turns, degrees) = (Phase::from_turns(number), Phase::from_degrees(number));
    let radians = Phase::from_radians(number);
    recorder.record("phase", &(turns, degrees, radians));
    for phase in [turns, degrees, radians].into_iter().flatten() {
        let mut sum = (phase + Phase::new(black_box(i64::MAX), 1)) * black_box(i64::MIN);
        sum += -phase;
        sum -= Phase::of_turn(1, 7).unwrap_or(Phase::ZERO) - phase;
        for phase in [phase, sum] {
            recorder.record("phase", &(phase, phase.radians(), phase.split_f64()));
            let (turns, radians) = phase.split_f32();
            recorder.record("phase", &(turns, radians, phase.sin_cos_f64()));
            recorder.record("phase", &phase.sin_cos_f32());
        }
    }
}

fn functions<T: Real + super::words::Words>(recorder: &mut Recorder<impl Listener>, number: f64) {
    let x = T::from_f64(black_box(number));
    if Real::is_finite(x) {
        recorder.record("sin-cos", &Real::sin_cos(x));
        recorder.record("root", &(Real::sqrt(Real::abs(x)), Real::round(x)));
        recorder.record("atan", &(Real::atan2(x, T::HALF), Real::atan2(-T::HALF, x)));
        recorder.record("exp", &Real::exp(if x < T::ZERO { x } else { -x }));
    }
}
