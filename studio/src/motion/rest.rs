//! Positions of rest: where springs, weights and loads bring the motors that are let go.

use super::{Mover, obstacle, range_of};
use crate::failure::Failure;
use mech_compiler::Compiled;
use mech_compiler::evaluate::Stop;
use mech_compiler::model::{Model, MotorId};
use mech_compiler::program::Forces;
use mech_core::rest::{self, Unrest};

/// Where a mechanism comes to rest.
#[derive(Clone, Debug)]
pub(crate) struct Rest {
    /// The values of all motors, in radians and scene units.
    pub(crate) motors: Vec<f64>,
    /// The torques or forces that hold motors, or those that lean against an end of their range; zero for those that rest by themselves.
    pub(crate) torques: Vec<f64>,
}

/// A mechanism that falls.
#[derive(Clone)]
struct Falling<'a> {
    machine: Mover<'a>,
    holding: Mover<'a>,
    loads: &'a [f64],
    /// A rate of zero for each motor.
    still: &'a [f64],
}

impl rest::Falling<f64> for Falling<'_> {
    type Numbers = Vec<f64>;
    type Stop = Stop;

    fn motors(&self) -> Vec<f64> {
        let mut motors = self.machine.position().motors;
        motors.truncate(self.still.len());
        motors
    }

    fn move_to(&mut self, motors: &Vec<f64>) -> Result<Vec<f64>, Stop> {
        let before = self.machine.position();
        self.machine.move_to(motors)?;
        self.holding.put_back(&self.machine.position());
        match self.holding.forces([self.still; 2], self.loads) {
            Ok(Forces::Holding(torques)) => Ok(torques),
            found => {
                self.machine.put_back(&before);
                Err(found.err().unwrap_or(Stop::Unasked))
            }
        }
    }
}

/// Finds where a mechanism comes to rest from where a machine is, if these motors are let go, and the others are held. It has to be compiled
/// with forces.
pub(crate) fn find_rest(
    model: &Model,
    compiled: &Compiled,
    machine: Mover<'_>,
    free: &[MotorId],
    loads: &[f64],
) -> Result<Rest, Failure> {
    let Some(program) = &compiled.forced.holding else {
        return Err(Failure::internal("forces have no program that holds"));
    };
    let count = model.motors.len();
    let units: Vec<f64> = model.motor_ids().map(|motor| model.unit_of(motor)).collect();
    let here = machine.position().motors;
    let ends = model.motor_ids().map(|motor| {
        if free.contains(&motor) {
            range_of(model, motor).unwrap_or([f64::NEG_INFINITY, f64::INFINITY])
        } else {
            [here[motor.index()]; 2]
        }
    });
    let ends: Vec<[f64; 2]> = ends.collect();
    let mut falling =
        Falling { machine, holding: Mover::of(model, program), loads, still: &vec![0.0; count] };
    let mut rows = vec![vec![0.0; count]; count];
    match rest::fall(&mut falling, &units, &ends, &mut rows) {
        Ok(torques) => Ok(Rest {
            motors: rest::Falling::motors(&falling),
            torques,
        }),
        Err(unrest) => Err(Failure::mechanism(match unrest {
            Unrest::Stopped(stop) => {
                let why = obstacle(model, compiled, stop);
                format!("forces are not determined there: {why}")
            }
            Unrest::Unloaded => "nothing pulls at its motors: no weights, springs or loads do; declare `gravity` and masses, or a spring, or \
                give `--load`".to_owned(),
            Unrest::Endless => "it does not come to rest: nothing stops what pulls at its motors; hold one by `--at`, or give it a range or \
                a spring".to_owned(),
        })),
    }
}
