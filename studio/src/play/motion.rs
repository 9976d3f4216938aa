//! The motion that a mechanism makes by itself.

use crate::failure::Failure;
use crate::motion::{Basis, Drive, Moment, Reach, Span};
use mech_compiler::Compiled;
use mech_compiler::model::{Model, MotorId};
use std::f64::consts::{PI, TAU};

/// Rates of motors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rates {
    /// The rates, in radians or scene units per second. Missing ones are 0.
    pub first: Vec<f64>,
    /// The second rates.
    pub second: Vec<f64>,
}

/// The duration of a pass, in seconds: as long as a film.
const SECONDS: f64 = 4.0;
/// The part of its reach that a motor uses, so that rounding does not carry it beyond the ends.
const USED: f64 = 0.98;

/// The motion that a mechanism makes by itself, by a phase that goes on and on.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Motion {
    /// By the laws of its motors; the phase is the time in seconds.
    Laws(Drive),
    /// One motor after the other makes its pass, while the others rest; a pass is 1 of the phase.
    Passes(Vec<Pass>),
}

/// A pass of a motor alone, from where it is at the start and back.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Pass {
    motor: MotorId,
    way: Way,
}

#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
enum Way {
    Round,
    /// To and fro: from the phase of a sine that is 0 in the middle, and as far as this to either side.
    ToAndFro {
        from: f64,
        half: f64,
    },
}

impl Motion {
    /// The motion of a mechanism. A motor goes through its declared range, or once round, or as far as the mechanism lets it.
    pub(super) fn new(model: &Model, compiled: &Compiled) -> Result<Self, Failure> {
        if model.has_laws() {
            // A part of it is a time.
            let span = Span { from: Some(0.0.into()), to: Some(1.0.into()) };
            let drive = Drive::new(model, compiled, None, span, &[])?;
            return Ok(Self::Laws(drive));
        }
        let mut passes = Vec::new();
        for motor in model.motor_ids() {
            let way = Way::new(model, compiled, motor)?;
            passes.extend(way.map(|way| Pass { motor, way }));
        }
        Ok(Self::Passes(passes))
    }

    /// The duration of 1 of the phase, in seconds.
    pub(super) const fn seconds(&self) -> f64 {
        match self {
            Self::Laws(_) => 1.0,
            Self::Passes(_) => SECONDS,
        }
    }

    /// After how much of the phase every motor has moved.
    pub(super) fn length(&self) -> f64 {
        match self {
            Self::Laws(_) => 1.0,
            Self::Passes(passes) => u32::try_from(passes.len()).map_or(1.0, f64::from).max(1.0),
        }
    }

    /// The motors at a phase. From the ends of it, it goes on.
    pub(super) fn at(&self, model: &Model, compiled: &Compiled, phase: f64) -> Moment {
        match self {
            Self::Laws(drive) => drive.moment(model, compiled, phase, 0.0),
            Self::Passes(passes) => {
                let count = model.motors.len();
                let mut values = compiled.program.start.motors[..count].to_vec();
                let mut rates = [vec![0.0; count], vec![0.0; count]];
                let number = phase.floor();
                let length = self.length();
                let (round, turn) = ((number / length).floor(), number.rem_euclid(length));
                for (pass, place) in passes.iter().zip(0_u32..) {
                    let place = f64::from(place);
                    let part = if place < turn {
                        1.0
                    } else if place > turn {
                        0.0
                    } else {
                        phase - number
                    };
                    let motor = pass.motor.index();
                    let [value, first, second] = pass.way.at(round, part);
                    values[motor] += value;
                    if place == turn {
                        rates[0][motor] = first / SECONDS;
                        rates[1][motor] = second / (SECONDS * SECONDS);
                    }
                }
                Moment { by: phase, time: SECONDS * phase, values, rates }
            }
        }
    }
}

impl Way {
    /// The way of a motor from the start; none if it cannot move.
    fn new(model: &Model, compiled: &Compiled, motor: MotorId) -> Result<Option<Self>, Failure> {
        let base = &compiled.program.start.motors[..model.motors.len()];
        let Reach { ends, basis, .. } = Reach::of(model, compiled, motor, base)?;
        if basis == Basis::Round {
            return Ok(Some(Self::Round));
        }
        let [low, high] = ends;
        let half = USED * (high - low) / 2.0;
        let offset = base[motor.index()] - f64::midpoint(low, high);
        let is_usable = half.is_finite() && half > 0.0;
        Ok(is_usable
            .then(|| Self::ToAndFro { from: (offset / half).clamp(-1.0, 1.0).asin(), half }))
    }

    /// Computes the distance of the motor from its start after so many passes and a part of one, with its first and second derivative.
    fn at(self, round: f64, part: f64) -> [f64; 3] {
        match self {
            Self::Round => [TAU * (round + part), TAU, 0.0],
            Self::ToAndFro { from, half } => {
                let (sin, cos) = (from + 2.0 * PI * part).sin_cos();
                [half * (sin - from.sin()), half * TAU * cos, -half * TAU * TAU * sin]
            }
        }
    }
}
