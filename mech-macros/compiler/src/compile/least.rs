//! A point is led by more motors than it needs: as the generated code does it, in any precision.

use super::inverse::Unreachable;
use crate::bug::bug;
use crate::evaluate::Machine;
use crate::model::{Inverse, Model, MotorId};
use crate::program::{Position, Program, Real};
use mech_core::Pose;
use mech_core::surplus::{self, SurplusMotors};
use std::array;

/// Leads the point of `follow` to a place, where more motors than needed follow it. The second machine is one of the program of rates.
///
/// # Errors
/// The obstacle to the point; where the mechanism is then is left open.
pub(super) fn lead<T: Real>(
    model: &Model,
    led: &Inverse,
    program: &Program,
    (mechanism, moving): (&mut Machine<'_, T>, &mut Machine<'_, T>),
    place: &[f64],
) -> Result<(), Unreachable> {
    let Some(stored) = program.stored.iter().position(|link| *link == led.link) else {
        bug!("the link of a point that is led has no pose");
    };
    let point = led.point.map_or([0.0; 2], |point| model.axis(point).at);
    let weights = led.motors.iter().map(|motor| {
        let far = model.unit_of(*motor);
        T::from_f64(far * far)
    });
    let weights = weights.collect();
    let start = mechanism.position().clone();
    let point = point.map(T::from_f64);
    let mut motors = Following { model, led, mechanism, moving, weights, stored, point };
    let there = match place.iter().copied().map(T::from_f64).collect::<Vec<T>>()[..] {
        [x, y] => surplus::lead(&mut motors, &start, [x, y]).map_err(|(stop, _)| stop)?,
        [x, y, angle] => {
            surplus::lead(&mut motors, &start, [x, y, angle]).map_err(|(stop, _)| stop)?
        }
        _ => bug!("a place has two numbers, and an angle perhaps"),
    };
    mechanism.put_back(there);
    Ok(())
}

/// A mechanism whose point is led by more motors than it needs.
struct Following<'w, 'm, 'r, T: Real> {
    model: &'w Model,
    led: &'w Inverse,
    mechanism: &'w mut Machine<'m, T>,
    /// The machine that computes rates.
    moving: &'w mut Machine<'r, T>,
    weights: Vec<T>,
    /// The number of the link's pose.
    stored: usize,
    /// The point that is led, in the frame of its link.
    point: [T; 2],
}

impl<T: Real> Following<'_, '_, '_, T> {
    fn pose(&self, at: &Position<T>) -> Pose<T> {
        Pose::from(at.poses[self.stored])
    }

    fn motors(&self) -> impl Iterator<Item = usize> + use<'_, T> {
        self.led.motors.iter().map(|motor: &MotorId| motor.index())
    }
}

impl<T: Real, const G: usize> SurplusMotors<T, G> for Following<'_, '_, '_, T> {
    type Position = Position<T>;
    type Stop = Unreachable;
    type Values = Vec<T>;
    type Held = Vec<Option<T>>;
    type Influence = Vec<[T; G]>;

    fn given(&self, at: &Position<T>) -> [T; G] {
        let pose = self.pose(at);
        let [x, y] = pose.apply(self.point);
        let all = [x, y, pose.sin.atan2(pose.cos)];
        array::from_fn(|number| all[number])
    }

    fn influence(&mut self, at: &Position<T>) -> Result<Vec<[T; G]>, Unreachable> {
        self.moving.put_back(at.clone());
        let [along, across] = self.pose(at).turn(self.point);
        let rest = vec![T::ZERO; self.model.motors.len()];
        let columns = self.motors().map(|motor| {
            let mut unit = rest.clone();
            unit[motor] = T::ONE;
            let found = self.moving.motion(&unit, &rest).map_err(Unreachable::Stopped)?;
            let [angular, x, y] = found.velocities[self.stored];
            let all = [x - angular * across, y + angular * along, angular];
            Ok(array::from_fn(|number| all[number]))
        });
        columns.collect()
    }

    fn values(&self, at: &Position<T>) -> Vec<T> {
        let whole = |motor: usize| match at.turns[motor] {
            0 => at.motors[motor],
            turns => at.motors[motor] + T::TURN * T::from_i32(turns),
        };
        self.motors().map(whole).collect()
    }

    fn free(&self) -> Vec<Option<T>> {
        vec![None; self.led.motors.len()]
    }

    fn go(&mut self, from: &Position<T>, values: &Vec<T>) -> Result<Position<T>, Unreachable> {
        let (mut motors, mut turns) = (from.motors.clone(), from.turns.clone());
        for (motor, value) in self.motors().zip(values) {
            (motors[motor], turns[motor]) = (*value, 0);
        }
        self.mechanism.put_back(from.clone());
        let moved = self.mechanism.advance(&motors, &turns);
        moved.map_err(|halt| Unreachable::Stopped(halt.stop))?;
        Ok(self.mechanism.position().clone())
    }

    fn weights(&self) -> &[T] {
        &self.weights
    }

    fn range(&self, number: usize) -> Option<[T; 2]> {
        let range = self.model.motor(self.led.motors[number]).range?;
        Some([range.low, range.high].map(T::from_f64))
    }

    fn is_angle(&self, number: usize) -> bool {
        number == Inverse::ANGLE
    }

    fn size(&self) -> T {
        T::from_f64(self.model.size())
    }

    fn undetermined(&self) -> Unreachable {
        Unreachable::Undetermined
    }

    fn unreached(&self) -> Unreachable {
        Unreachable::Apart
    }
}
