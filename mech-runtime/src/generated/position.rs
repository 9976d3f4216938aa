//! The position of a mechanism.

use super::Stop;
use crate::blocked::Input;
use crate::{Blocked, Cause, Phase, Pose, Real, Scalar};

/// The values of the motors: each a number of whole turns and a remainder, in radians or scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motors<T, const MOTORS: usize> {
    /// The values, less the whole turns.
    pub values: [T; MOTORS],
    /// Whole turns: zero for what was given in radians, and for what slides.
    pub turns: [i32; MOTORS],
}

impl<T: Scalar, const MOTORS: usize> Motors<T, MOTORS> {
    /// Values in radians or scene units.
    #[must_use]
    #[inline]
    pub const fn new(values: [T; MOTORS]) -> Self {
        Self { values, turns: [0; MOTORS] }
    }

    /// The values in radians or scene units, whole turns among them.
    #[must_use]
    pub fn total(&self) -> [T; MOTORS] {
        let mut total = self.values;
        for (value, turns) in total.iter_mut().zip(self.turns) {
            if turns != 0 {
                *value += T::TURN * <T as Real>::from_i32(turns);
            }
        }
        total
    }

    /// Sets a motor to a value and whole turns beside it.
    #[inline]
    pub(super) fn set(&mut self, motor: usize, value: T, turns: i32) {
        if let (Some(given), Some(whole)) = (self.values.get_mut(motor), self.turns.get_mut(motor))
        {
            (*given, *whole) = (value, turns);
        }
    }

    /// Sets the phase of a motor.
    ///
    /// # Errors
    /// If it is beyond 2³¹ turns.
    pub fn turn(&mut self, motor: usize, phase: Phase, name: &'static str) -> Result<(), Stop> {
        let (turns, remainder) = <T as Real>::of_phase(phase);
        match (i32::try_from(turns), self.values.get_mut(motor), self.turns.get_mut(motor)) {
            (Ok(turns), Some(value), Some(whole)) => {
                (*value, *whole) = (remainder, turns);
                Ok(())
            }
            _ => Err(Stop::new(name, Cause::Overflow)),
        }
    }

    /// The same values, with the whole turns of turning motors counted separately.
    #[must_use]
    #[inline]
    pub fn reduced(self, turning: &[bool]) -> Self {
        let mut motors = self;
        let values = motors.values.iter_mut().zip(&mut motors.turns);
        for ((value, turns), _) in values.zip(turning).filter(|(_, turning)| **turning) {
            (*value, *turns) = mech_core::motors::reduced(*value, *turns);
        }
        motors
    }

    /// Sets a motor to the value of its law.
    ///
    /// # Errors
    /// If it is not a finite number of this type.
    #[inline]
    pub fn follow(&mut self, motor: usize, value: f64, name: &'static str) -> Result<(), Stop> {
        let given = <T as Real>::from_f64(value);
        let (Some(value), Some(turns)) = (self.values.get_mut(motor), self.turns.get_mut(motor))
        else {
            return Ok(());
        };
        if !Real::is_finite(given) {
            return Err(Stop::new(name, Cause::NotFinite));
        }
        (*value, *turns) = (given, 0);
        Ok(())
    }

    /// Sets a turning motor to the value of its law. Whole turns are counted separately, so many turns cost no accuracy.
    ///
    /// # Errors
    /// If it is not a finite number, or beyond 2³¹ turns.
    pub fn turn_by(&mut self, motor: usize, value: f64, name: &'static str) -> Result<(), Stop> {
        let turns = Real::round(value / core::f64::consts::TAU);
        if value.is_finite() && Real::abs(turns) > f64::from(i32::MAX) {
            return Err(Stop::new(name, Cause::Overflow));
        }
        self.follow(motor, value - turns * core::f64::consts::TAU, name)?;
        if let Some(whole) = self.turns.get_mut(motor) {
            #[expect(
                clippy::cast_possible_truncation,
                reason = "a whole number of turns within range"
            )]
            let turns = turns as i32;
            *whole = turns;
        }
        Ok(())
    }

    /// The displacement of each motor from here to the target, in radians or scene units.
    #[inline]
    pub(super) fn displacement_to(&self, target: &Self) -> [T; MOTORS] {
        let mut displacements = [T::ZERO; MOTORS];
        for (motor, displacement) in displacements.iter_mut().enumerate() {
            *displacement = mech_core::motors::displacement(
                (self.values[motor], self.turns[motor]),
                (target.values[motor], target.turns[motor]),
            );
        }
        displacements
    }

    /// Whether all values are finite numbers and none is farther from zero than this.
    #[must_use]
    #[inline]
    pub fn is_within(&self, reach: T) -> bool {
        self.values.iter().all(|value| Real::abs(*value) <= reach)
    }

    /// Whether all values are finite numbers.
    #[inline]
    pub fn is_finite(&self) -> bool {
        self.values.iter().all(|value| Real::is_finite(*value))
    }
}

/// Tests that the values or rates of all motors are finite numbers. The motors are the first inputs.
///
/// # Errors
/// The first motor of which one is not.
#[inline]
pub fn finite<T: Scalar, const MOTORS: usize, const INPUTS: usize>(
    values: [T; MOTORS],
    inputs: &[Input; INPUTS],
) -> Result<(), Stop> {
    const { assert!(MOTORS <= INPUTS, "every motor is an input") }
    let mut pairs = values.iter().zip(inputs);
    match pairs.find(|(value, _)| !Real::is_finite(**value)) {
        None => Ok(()),
        Some((_, input)) => Err(Stop::new(input.name(), Cause::NotFinite)),
    }
}

/// Everything that a move changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position<T, const MOTORS: usize, const LINKS: usize, const STATE: usize> {
    /// The values of the motors.
    pub motors: Motors<T, MOTORS>,
    /// The poses of the moving links.
    pub poses: [Pose<T>; LINKS],
    /// The state: whole turns of angles that gears need, and the branches of dyads that pass change points.
    pub state: [T; STATE],
}

impl<T: Scalar, const MOTORS: usize, const LINKS: usize, const STATE: usize>
    Position<T, MOTORS, LINKS, STATE>
{
    /// Whether all numbers are finite. The loops are checked already, but other links may overflow.
    #[inline]
    pub(super) fn is_finite(&self) -> bool {
        let finite = |pose: &Pose<T>| Real::is_finite(pose.cos + pose.sin + pose.x + pose.y);
        self.poses.iter().all(finite) && self.state.iter().all(|state| Real::is_finite(*state))
    }

    /// The error of a mechanism that stays here.
    #[cold]
    pub fn refuse(&self, stop: Stop, inputs: &'static [Input]) -> Blocked<[T; MOTORS]> {
        Blocked::new(stop.place, stop.cause, self.motors.total()).of(inputs)
    }
}
