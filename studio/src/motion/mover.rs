//! A mechanism that moves in its own precision.

use mech_compiler::evaluate::{Machine, Prepared, Stop};
use mech_compiler::model::{Model, Precision};
use mech_compiler::program::{Forces, LinkRates, Position, Program};
use mech_compiler::{Compiled, Unreachable, lead};
use mech_core::{Pose, Real};

/// A mechanism that moves as its generated code does, in the precision of its text. What it is given and what it tells is in double precision,
/// which holds the numbers of both.
#[derive(Clone, Debug)]
pub(crate) enum Mover<'p> {
    Single(Machine<'p, f32>),
    Double(Machine<'p, f64>),
}

/// A program that is prepared for motion once.
pub(crate) enum Ready {
    Single(Prepared<f32>),
    Double(Prepared<f64>),
}

impl Ready {
    pub(crate) fn new(model: &Model, program: &Program) -> Self {
        match model.precision {
            Precision::F32 => Self::Single(Prepared::new(program)),
            Precision::F64 => Self::Double(Prepared::new(program)),
        }
    }
}

/// The same for a machine in either precision.
macro_rules! either {
    ($mover:expr, $machine:ident => $done:expr) => {
        match $mover {
            Mover::Single($machine) => $done,
            Mover::Double($machine) => $done,
        }
    };
}

impl<'p> Mover<'p> {
    /// The mechanism as it was assembled.
    pub(crate) fn new(model: &Model, compiled: &'p Compiled) -> Self {
        Self::of(model, &compiled.program)
    }

    /// The mechanism as it was assembled, moved by another of its programs, as that of its rates.
    pub(crate) fn of(model: &Model, program: &'p Program) -> Self {
        match model.precision {
            Precision::F32 => Self::Single(Machine::new(program)),
            Precision::F64 => Self::Double(Machine::new(program)),
        }
    }

    /// The mechanism as it was assembled, in double precision whatever its text says: for what is not shown.
    pub(crate) fn exact(compiled: &'p Compiled) -> Self {
        Self::Double(Machine::new(&compiled.program))
    }

    /// The mechanism at a position that it had before.
    pub(crate) fn at(program: &'p Program, ready: &'p Ready, position: &Position<f64>) -> Self {
        match ready {
            Ready::Single(ready) => {
                Self::Single(Machine::at(program, ready, position.map(f32::from_f64)))
            }
            Ready::Double(ready) => Self::Double(Machine::at(program, ready, position.clone())),
        }
    }

    /// Its position.
    pub(crate) fn position(&self) -> Position<f64> {
        either!(self, machine => machine.position().map(Real::to_f64))
    }

    /// Puts it where it was.
    pub(crate) fn put_back(&mut self, position: &Position<f64>) {
        either!(self, machine => machine.put_back(position.map(Real::from_f64)));
    }

    /// Gives the motors these values.
    ///
    /// # Errors
    /// The reason why it cannot go there; it then stays where it was.
    pub(crate) fn move_to(&mut self, motors: &[f64]) -> Result<(), Stop> {
        either!(self, machine => machine.move_to(&rounded(motors)))
    }

    /// Moves towards these values of the motors as far as it can: what stops it, if it does not arrive.
    pub(crate) fn move_toward(&mut self, motors: &[f64]) -> Option<Stop> {
        either!(self, machine => machine.move_toward(&rounded(motors)).unwrap_or_else(Some))
    }

    /// Leads the point of `follow` to a place; the other machine is that of the inverse.
    ///
    /// # Errors
    /// What keeps it from coming there; the mechanism then stays where it was.
    pub(crate) fn lead(
        &mut self,
        model: &Model,
        compiled: &Compiled,
        inverse: &mut Mover<'_>,
        place: &[f64],
    ) -> Result<(), Unreachable> {
        match (self, inverse) {
            (Self::Single(own), Mover::Single(other)) => lead(model, compiled, (own, other), place),
            (Self::Double(own), Mover::Double(other)) => lead(model, compiled, (own, other), place),
            // Both have the precision of the text.
            _ => Err(Unreachable::Apart),
        }
    }

    /// The rates of all links where it is, if the motors move at these rates and second rates.
    ///
    /// # Errors
    /// As of [`Machine::motion`].
    pub(crate) fn motion(&self, [first, second]: [&[f64]; 2]) -> Result<LinkRates<f64>, Stop> {
        either!(self, machine => {
            let rates = machine.motion(&rounded(first), &rounded(second))?;
            let all = |rates: Vec<[_; 3]>| rates.into_iter().map(|one| one.map(Real::to_f64)).collect();
            Ok(LinkRates {
                velocities: all(rates.velocities),
                accelerations: rates.accelerations.map(all),
            })
        })
    }

    /// The forces where it is, if the motors move at these rates and second rates, and the loads are these numbers.
    ///
    /// # Errors
    /// As of [`Machine::forces`].
    pub(crate) fn forces(
        &self,
        [first, second]: [&[f64]; 2],
        loads: &[f64],
    ) -> Result<Forces<f64>, Stop> {
        either!(self, machine => {
            let found = machine.forces(&rounded(first), &rounded(second), &rounded(loads))?;
            Ok(found.map(Real::to_f64))
        })
    }
}

/// The nearest number of a precision.
pub(crate) fn in_precision(precision: Precision, number: f64) -> f64 {
    match precision {
        Precision::F32 => f32::from_f64(number).to_f64(),
        Precision::F64 => number,
    }
}

/// The nearest numbers of a precision.
fn rounded<T: Real>(numbers: &[f64]) -> Vec<T> {
    numbers.iter().copied().map(T::from_f64).collect()
}

/// The place in the scene of a point of a link in this pose, as generated code computes it, to the bit.
pub(crate) fn place_of(precision: Precision, pose: [f64; 4], point: [f64; 2]) -> [f64; 2] {
    match precision {
        Precision::F32 => place_in::<f32>(pose, point),
        Precision::F64 => place_in::<f64>(pose, point),
    }
}

fn place_in<T: Real>(pose: [f64; 4], point: [f64; 2]) -> [f64; 2] {
    let place = Pose::from(pose.map(T::from_f64)).apply(point.map(T::from_f64));
    place.map(Real::to_f64)
}
