//! A move under way, exactly as in the generated code's runtime.

use super::Stop;
use super::run::Runner;
use crate::program::Position;
use mech_core::Real;
use mech_core::journey::{self, Halt, Journey, Watch};

/// A move under way.
pub(super) struct Way<'a, 'p, T> {
    runner: &'a Runner<'p>,
    start: &'a Position<T>,
    motors: &'a [T],
    turns: &'a [i32],
    ways: Vec<T>,
    subdivides: bool,
}

impl<'a, 'p, T: Real> Way<'a, 'p, T> {
    pub(super) fn new(
        runner: &'a Runner<'p>,
        start: &'a Position<T>,
        motors: &'a [T],
        turns: &'a [i32],
    ) -> Self {
        let way = motors
            .iter()
            .zip(turns)
            .enumerate()
            .map(|(index, (motor, turns))| {
                let way = *motor - start.motors[index];
                let turns = turns.wrapping_sub(start.turns[index]);
                if turns == 0 {
                    way
                } else {
                    way + T::TURN * T::from_i32(turns)
                }
            });
        Self {
            ways: way.collect(),
            subdivides: runner.program.subdivides(),
            runner,
            start,
            motors,
            turns,
        }
    }

    /// Where it leads.
    pub(super) fn gone(&self) -> Result<Position<T>, Halt<Position<T>, Stop, T>> {
        if let Ok(mut position) = self.at(self.start, T::ONE)
            && journey::is_clear(self, self.start, &position, T::ONE)
        {
            self.note_sense(&mut position);
            return Ok(position);
        }
        journey::go(self, self.start)
    }
}

impl<T: Real> Journey<T> for Way<'_, '_, T> {
    type Position = Position<T>;
    type Stop = Stop;

    fn at(&self, last: &Position<T>, part: T) -> Result<Position<T>, Stop> {
        if part >= T::ONE {
            return self.runner.step(last, (self.motors, self.turns));
        }
        let start = self.start.motors.iter().zip(&self.ways);
        let motors: Vec<T> = start.map(|(value, way)| *value + *way * part).collect();
        self.runner.step(last, (&motors, &self.start.turns))
    }

    fn watches(&self) -> usize {
        self.runner.program.watches.len()
    }

    fn watch(&self, index: usize) -> Watch<T> {
        let watch = &self.runner.program.watches[index];
        let mut change = T::ZERO;
        for (rate, way) in watch.rates.iter().zip(&self.ways) {
            change = change + T::from_f64(*rate) * way.abs();
        }
        Watch {
            change,
            at_zero: watch.at_zero,
        }
    }

    fn sine(&self, position: &Position<T>, index: usize) -> T {
        position.kept[self.runner.program.watches[index].kept]
    }

    fn tiny_square(&self, position: &Position<T>, index: usize) -> T {
        position.kept[self.runner.program.watches[index].kept + 1]
    }

    fn turn_over(&self, position: &mut Position<T>, index: usize) {
        let sine = &mut position.kept[self.runner.program.watches[index].kept];
        *sine = -*sine;
    }

    fn goes_on(&self, position: &Position<T>, index: usize) -> bool {
        let Some(first) = self.runner.program.senses else {
            return false;
        };
        let rates = &self.runner.program.watches[index].rates;
        let mut along = T::ZERO;
        for (motor, (rate, way)) in rates.iter().zip(&self.ways).enumerate() {
            along = along + T::from_f64(*rate) * *way * position.kept[first + motor];
        }
        along > T::ZERO
    }

    fn note_sense(&self, position: &mut Position<T>) {
        let Some(first) = self.runner.program.senses else {
            return;
        };
        for (sense, way) in position.kept.iter_mut().skip(first).zip(&self.ways) {
            if *way != T::ZERO {
                *sense = T::ONE.copysign(*way);
            }
        }
    }

    fn stopped_at(&self, index: usize) -> Stop {
        Stop::ChangePoint(self.runner.program.watches[index].block)
    }

    fn too_far(&self) -> Stop {
        Stop::TooFar
    }

    fn pieces(&self) -> T {
        let strides = self.runner.program.strides.iter().flatten();
        strides.zip(&self.ways).fold(T::ONE, |most, (stride, way)| {
            most.max(way.abs() / T::from_f64(*stride))
        })
    }

    fn subdivides(&self) -> bool {
        self.subdivides
    }
}
