//! A mechanism with one method in one precision.

use crate::method::{Method, Precision};
use mech_runtime::{Mechanism, Real};
use std::hint::black_box;
use std::time::Instant;

/// The cosine, sine, x and y of every link.
pub(crate) type Poses<T> = Vec<[T; 4]>;
/// The positions, one after the other.
pub(crate) type Trace<T> = Vec<Poses<T>>;

/// A mechanism with one method in one precision.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contestant {
    /// The method.
    pub(crate) method: Method,
    /// The precision.
    pub(crate) precision: Precision,
    trace: fn(&[f64]) -> Result<Trace<f64>, Block>,
    time: fn(&[f64], u32) -> f64,
}

/// The place where a mechanism was blocked.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Block {
    /// The loop or the motor.
    pub(crate) place: &'static str,
    /// The number of the position that it did not reach.
    pub(crate) position: usize,
    /// The whole error.
    pub(crate) words: String,
}

impl Contestant {
    /// A mechanism with one motor.
    pub(crate) fn new<M: Mechanism>(method: Method, precision: Precision) -> Self {
        Self { method, precision, trace: trace::<M>, time: time::<M> }
    }

    /// Its positions for these values of its motor, one after the other.
    pub(crate) fn trace(&self, values: &[f64]) -> Result<Trace<f64>, Block> {
        (self.trace)(values)
    }

    /// The time of a position in nanoseconds, over so many sweeps.
    pub(crate) fn time(&self, values: &[f64], sweeps: u32) -> f64 {
        (self.time)(values, sweeps)
    }
}

fn motors<M: Mechanism>(mechanism: &M, value: f64) -> M::Motors {
    let mut motors = mechanism.motors();
    for motor in motors.as_mut() {
        *motor = Real::from_f64(value);
    }
    motors
}

fn trace<M: Mechanism>(values: &[f64]) -> Result<Trace<f64>, Block> {
    let mut mechanism = M::new();
    let mut trace = Vec::with_capacity(values.len());
    for (position, &value) in values.iter().enumerate() {
        let motors = motors(&mechanism, value);
        mechanism.move_to(motors).map_err(|blocked| Block {
            place: blocked.place,
            position,
            words: blocked.to_string(),
        })?;
        let poses = mechanism.poses().iter();
        trace.push(
            poses.map(|pose| [pose.cos, pose.sin, pose.x, pose.y].map(Real::to_f64)).collect(),
        );
    }
    Ok(trace)
}

fn time<M: Mechanism>(values: &[f64], sweeps: u32) -> f64 {
    let start = M::new();
    let values: Vec<_> = values.iter().map(|&value| motors(&start, value)).collect();
    let watch = Instant::now();
    for _ in 0..sweeps {
        let mut mechanism = start.clone();
        for &motors in &values {
            let result = mechanism.move_to(black_box(motors));
            black_box((result.is_ok(), mechanism.poses()));
        }
    }
    let elapsed = watch.elapsed().as_secs_f64() * 1e9;
    let positions = u32::try_from(values.len()).unwrap_or(u32::MAX);
    elapsed / f64::from(sweeps) / f64::from(positions)
}
