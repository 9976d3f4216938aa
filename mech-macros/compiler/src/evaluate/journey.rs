//! A move under way, exactly as in the generated code's runtime.

use super::Stop;
use super::run::Runner;
use crate::program::Position;
use mech_core::journey::{self, Growth, Halt, Journey, Standing, Turn, Watch};
use mech_core::{Real, motors};

/// A move under way.
pub(super) struct Move<'a, 'p, T: Real> {
    runner: &'a Runner<'p, T>,
    start: &'a Position<T>,
    values: &'a [T],
    turns: &'a [i32],
    displacements: Vec<T>,
    subdivides: bool,
}

impl<'a, 'p, T: Real> Move<'a, 'p, T> {
    pub(super) fn new(
        runner: &'a Runner<'p, T>,
        start: &'a Position<T>,
        values: &'a [T],
        turns: &'a [i32],
    ) -> Self {
        let displacement = |motor: usize| {
            let start = (start.motors[motor], start.turns[motor]);
            motors::displacement(start, (values[motor], turns[motor]))
        };
        Self {
            displacements: (0..values.len()).map(displacement).collect(),
            subdivides: runner.program.subdivides(),
            runner,
            start,
            values,
            turns,
        }
    }

    /// The index in the state of the number that tells where a watched loop is beside a change point.
    fn place_of_standing(&self, index: usize) -> Option<usize> {
        let first = self.runner.program.layout.motion_signs?;
        Some(first + self.displacements.len() + index)
    }

    fn max_steps(&self) -> impl Iterator<Item = T> + '_ {
        let max_steps = self.runner.program.max_steps.iter().flatten();
        max_steps.map(|step| T::from_f64(*step))
    }

    /// The position at the end of the move, or where and why it stops.
    pub(super) fn run(&self) -> Result<Position<T>, Halt<Position<T>, Stop, T>> {
        if let Ok(mut position) = self.at(self.start, T::ONE)
            && journey::is_clear(self, self.start, &position, T::ONE)
        {
            self.note_motion_signs(&mut position);
            return Ok(position);
        }
        self.travel()
    }

    /// The position at the end, whatever lies between.
    pub(super) fn leap(&self) -> Result<Position<T>, Stop> {
        let mut position = self.at(self.start, T::ONE)?;
        self.note_motion_signs(&mut position);
        Ok(position)
    }

    /// The same, always as a journey.
    pub(super) fn travel(&self) -> Result<Position<T>, Halt<Position<T>, Stop, T>> {
        journey::travel(self, self.start)
    }
}

impl<T: Real> Journey<T> for Move<'_, '_, T> {
    type Position = Position<T>;
    type Stop = Stop;

    fn at(&self, last: &Position<T>, part: T) -> Result<Position<T>, Stop> {
        if part >= T::ONE {
            return self.runner.step(last, (self.values, self.turns));
        }
        let start = self.start.motors.iter().zip(&self.displacements);
        let motors: Vec<T> =
            start.map(|(value, displacement)| *value + *displacement * part).collect();
        self.runner.step(last, (&motors, &self.start.turns))
    }

    fn watches(&self) -> usize {
        self.runner.program.watches.len()
    }

    fn watch(&self, index: usize) -> Watch<T> {
        let watch = &self.runner.program.watches[index];
        let rates = watch.rates.iter().map(|rate| T::from_f64(*rate));
        Watch {
            change: motors::change(rates, &self.displacements),
            guessed: watch.guessed,
            at_zero: watch.at_zero,
            iterated: watch.iterated,
        }
    }

    fn sine(&self, position: &Position<T>, index: usize) -> T {
        position.state[self.runner.program.watches[index].sine]
    }

    fn growth(&self, index: usize) -> impl Iterator<Item = Growth<T>> {
        let growth = self.runner.program.watches[index].growth.iter();
        growth.map(|growth| in_precision(*growth))
    }

    fn follows(&self) -> usize {
        self.runner.program.follows.len()
    }

    fn turn(&self, index: usize) -> Turn<T> {
        let follow = &self.runner.program.follows[index];
        let rates = follow.rates.iter().map(|rate| T::from_f64(*rate));
        Turn { change: motors::change(rates, &self.displacements), guessed: follow.guessed }
    }

    fn angle(&self, position: &Position<T>, index: usize) -> T {
        position.state[self.runner.program.follows[index].angle]
    }

    fn turn_growth(&self, index: usize) -> impl Iterator<Item = Growth<T>> {
        let growth = self.runner.program.follows[index].growth.iter();
        growth.map(|growth| in_precision(*growth))
    }

    fn input(&self, position: &Position<T>, input: usize) -> T {
        position.motors[input] + T::TURN * T::from_i32(position.turns[input])
    }

    fn rounding_square(&self, position: &Position<T>, index: usize) -> T {
        position.state[self.runner.program.watches[index].rounding_square]
    }

    fn turn_over(&self, position: &mut Position<T>, index: usize) {
        let sine = &mut position.state[self.runner.program.watches[index].sine];
        *sine = -*sine;
    }

    fn standing(&self, position: &Position<T>, index: usize) -> Standing {
        let place = self.place_of_standing(index);
        place.map_or(Standing::Away, |place| Standing::of(position.state[place]))
    }

    fn set_standing(&self, position: &mut Position<T>, index: usize, standing: Standing) {
        if let Some(place) = self.place_of_standing(index) {
            position.state[place] = standing.number();
        }
    }

    fn beyond(&self, before: &Position<T>, at: &Position<T>) -> Position<T> {
        let program = self.runner.program;
        let mut beyond = at.clone();
        for (pose, before) in beyond.poses.iter_mut().zip(&before.poses) {
            *pose = motors::mirrored_pose(*before, *pose);
        }
        let watched = program.watches.iter().map(|watch| [watch.sine, watch.rounding_square]);
        motors::mirror_state(
            &mut beyond.state,
            &before.state,
            program.layout.motion_signs,
            &watched,
        );
        beyond
    }

    fn sense(&self, position: &Position<T>, index: usize) -> T {
        let Some(first) = self.runner.program.layout.motion_signs else {
            return T::ZERO;
        };
        let rates = self.runner.program.watches[index].rates.iter();
        let rates = rates.map(|rate| T::from_f64(*rate));
        motors::along(rates, &self.displacements, &position.state[first..])
    }

    fn note_motion_signs(&self, position: &mut Position<T>) {
        if let Some(first) = self.runner.program.layout.motion_signs {
            motors::note_motion_signs(&mut position.state[first..], &self.displacements);
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
        motors::pieces(self.max_steps(), &self.displacements)
    }

    fn is_one_piece(&self) -> bool {
        motors::in_one_piece(self.max_steps(), &self.displacements)
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
