//! What is asked of every mechanism: steps, leaps, bad numbers.

use super::recorder::Recorder;
use super::words::Words;
use core::hint::black_box;
use mech_probes::Listener;
use mech_runtime::{Mechanism, Real};

/// Numbers that nobody should give to a motor.
pub(super) const BAD: [f64; 7] =
    [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, 3.4e38, -1e30, 1e9];

/// Moves a mechanism by steps of this size, and as far as it can where it is blocked, back and forth; by leaps; and to bad numbers. Tells
/// where it is.
pub(super) fn all_moves<M: Mechanism>(recorder: &mut Recorder<impl Listener>, step: f64)
where
    M::Motors: Words,
    M::Scalar: Words,
{
    let mut mechanism = M::new();
    let start = mechanism.motors();
    let mut size = step;
    for _ in 0..black_box(12_u8) {
        let to = moved::<M>(mechanism.motors(), size);
        let outcome = mechanism.move_to(to);
        if outcome.is_err() {
            let reached = mechanism.move_toward(to);
            recorder.record(M::NAME, &(outcome, reached));
            size = -size;
        }
        recorder.record(M::NAME, &mechanism.poses());
    }
    for leap in [1.0, -2.7, 12.0, -200.0].map(|steps| steps * step) {
        let outcome = mechanism.move_to(moved::<M>(start, leap));
        recorder.record(M::NAME, &(outcome, mechanism.poses()));
    }
    for index in 0..start.as_ref().len() {
        for bad in BAD {
            let mut to = mechanism.motors();
            for motor in to.as_mut().iter_mut().skip(index).take(1) {
                *motor = Real::from_f64(black_box(bad));
            }
            let outcomes = (mechanism.move_to(to), mechanism.move_toward(to));
            recorder.record(M::NAME, &(outcomes, mechanism.poses()));
        }
    }
}

/// The values of all motors, farther by this.
fn moved<M: Mechanism>(mut motors: M::Motors, by: f64) -> M::Motors {
    for motor in motors.as_mut() {
        *motor += Real::from_f64(black_box(by));
    }
    motors
}
