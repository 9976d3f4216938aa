//! A move under way, exactly as in the generated code's runtime.

use super::Stop;
use super::run::Runner;
use crate::program::Position;
use mech_core::journey::{self, Growth, Halt, Journey, Watch};
use mech_core::{Real, motors};

/// A move under way.
pub(super) struct Way<'a, 'p, T> {
    runner: &'a Runner<'p>,
    start: &'a Position<T>,
    values: &'a [T],
    turns: &'a [i32],
    ways: Vec<T>,
    subdivides: bool,
}

impl<'a, 'p, T: Real> Way<'a, 'p, T> {
    pub(super) fn new(
        runner: &'a Runner<'p>,
        start: &'a Position<T>,
        values: &'a [T],
        turns: &'a [i32],
    ) -> Self {
        let way = |motor: usize| {
            let start = (start.motors[motor], start.turns[motor]);
            motors::way(start, (values[motor], turns[motor]))
        };
        Self {
            ways: (0..values.len()).map(way).collect(),
            subdivides: runner.program.subdivides(),
            runner,
            start,
            values,
            turns,
        }
    }

    fn strides(&self) -> impl Iterator<Item = T> + '_ {
        let strides = self.runner.program.strides.iter().flatten();
        strides.map(|stride| T::from_f64(*stride))
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
            return self.runner.step(last, (self.values, self.turns));
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
        let rates = watch.rates.iter().map(|rate| T::from_f64(*rate));
        Watch {
            change: motors::change(rates, &self.ways),
            guessed: watch.guessed,
            at_zero: watch.at_zero,
            iterated: watch.iterated,
        }
    }

    fn sine(&self, position: &Position<T>, index: usize) -> T {
        position.kept[self.runner.program.watches[index].kept]
    }

    fn growth(&self, index: usize) -> impl Iterator<Item = Growth<T>> {
        let growth = self.runner.program.watches[index].growth.iter();
        growth.map(|growth| in_precision(*growth))
    }

    fn follows(&self) -> usize {
        self.runner.program.follows.len()
    }

    fn turn(&self, index: usize) -> T {
        let rates = self.runner.program.follows[index].rates.iter();
        motors::change(rates.map(|rate| T::from_f64(*rate)), &self.ways)
    }

    fn turn_growth(&self, index: usize) -> impl Iterator<Item = Growth<T>> {
        let growth = self.runner.program.follows[index].growth.iter();
        growth.map(|growth| in_precision(*growth))
    }

    fn input(&self, position: &Position<T>, input: usize) -> T {
        position.motors[input] + T::TURN * T::from_i32(position.turns[input])
    }

    fn tiny_square(&self, position: &Position<T>, index: usize) -> T {
        position.kept[self.runner.program.watches[index].kept + 1]
    }

    fn turn_over(&self, position: &mut Position<T>, index: usize) {
        let sine = &mut position.kept[self.runner.program.watches[index].kept];
        *sine = -*sine;
    }

    fn beyond(&self, before: &Position<T>, at: &Position<T>) -> Position<T> {
        let program = self.runner.program;
        let mut beyond = at.clone();
        for (pose, before) in beyond.poses.iter_mut().zip(&before.poses) {
            *pose = motors::mirrored_pose(*before, *pose);
        }
        let sines = program.watches.iter().map(|watch| watch.kept);
        motors::mirror_carried(&mut beyond.kept, &before.kept, program.senses, &sines);
        beyond
    }

    fn goes_on(&self, position: &Position<T>, index: usize) -> bool {
        let Some(first) = self.runner.program.senses else {
            return false;
        };
        let rates = self.runner.program.watches[index].rates.iter();
        let rates = rates.map(|rate| T::from_f64(*rate));
        motors::along(rates, &self.ways, &position.kept[first..]) > T::ZERO
    }

    fn note_sense(&self, position: &mut Position<T>) {
        if let Some(first) = self.runner.program.senses {
            motors::note_senses(&mut position.kept[first..], &self.ways);
        }
    }

    fn is_open(&self, stop: &Stop, index: usize) -> bool {
        *stop == Stop::Open(self.runner.program.watches[index].block)
    }

    fn stopped_at(&self, index: usize) -> Stop {
        Stop::ChangePoint(self.runner.program.watches[index].block)
    }

    fn too_far(&self) -> Stop {
        Stop::TooFar
    }

    fn pieces(&self) -> T {
        motors::pieces(self.strides(), &self.ways)
    }

    fn is_one_piece(&self) -> bool {
        motors::in_one_piece(self.strides(), &self.ways)
    }

    fn subdivides(&self) -> bool {
        self.subdivides
    }
}

fn in_precision<T: Real>(growth: Growth<f64>) -> Growth<T> {
    match growth {
        Growth::Near(index) => Growth::Near(index),
        Growth::Far(input, unit) => Growth::Far(input, T::from_f64(unit)),
    }
}
