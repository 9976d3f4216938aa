//! Steps of time of mechanisms that the interpreter moves, by the runtime's own integrator.

use mech_compiler::evaluate::{Machine, Prepared, Stop};
use mech_compiler::program::{Forces, Position, Program};
use mech_runtime::generated::{self, Inertia, Input, Moment, Motors};
use mech_runtime::{Blocked, Cause, GaussLegendre, Pose, Scalar};

/// So many links and numbers of state there may be.
const LINKS: usize = 40;
const STATE: usize = 160;

type Fixed<T, const M: usize> = generated::Position<T, M, LINKS, STATE>;

/// A mechanism without params that moves under forces.
pub struct Simulated<'p, T: Scalar, const M: usize> {
    programs: [(&'p Program, Prepared<T>); 2],
    /// Where it is.
    pub position: Position<T>,
    /// How fast its motors move.
    pub rates: [T; M],
    inputs: &'static [Input; M],
    scales: &'static [T; M],
}

impl<'p, T: Scalar, const M: usize> Simulated<'p, T, M> {
    /// At its start: its program, that of its inertia, and for each motor its size if it slides.
    #[must_use]
    pub fn new(program: &'p Program, inertia: &'p Program, slides: [Option<f64>; M]) -> Self {
        let input = |slide: Option<f64>| match slide {
            None => Input::Turning("motor"),
            Some(_) => Input::Sliding("motor"),
        };
        let scale = |slide: Option<f64>| <T as mech_runtime::Real>::from_f64(slide.unwrap_or(1.0));
        Self {
            position: Machine::<T>::new(program).position().clone(),
            programs: [program, inertia].map(|program| (program, Prepared::new(program))),
            rates: [T::ZERO; M],
            inputs: Box::leak(Box::new(slides.map(input))),
            scales: Box::leak(Box::new(slides.map(scale))),
        }
    }

    /// A step of time under these torques.
    ///
    /// # Errors
    /// As those of `simulate_by`.
    pub fn step(
        &mut self,
        method: GaussLegendre,
        time: T,
        torques: [T; M],
    ) -> Result<(), Blocked<[T; M]>> {
        let moment = Moment {
            rates: self.rates,
            torques,
            time,
            inputs: self.inputs,
            turning: &[false; M],
            scales: self.scales,
        };
        let start = Self::fixed(&self.position);
        let done = generated::simulate(&start, &moment, method, |position, motors, rates| {
            let inertia = self.moved(position, motors, rates);
            inertia.map_err(|(cause, reached)| Blocked::new("", cause, reached))
        })?;
        (self.position, self.rates) = (self.free(&done.position), done.rates);
        Ok(())
    }

    /// Where it is.
    #[must_use]
    pub fn in_f64(&self) -> Position<f64> {
        let numbers = |all: &[T]| all.iter().map(|one| one.to_f64()).collect::<Vec<f64>>();
        let Position { motors, turns, poses, state } = &self.position;
        Position {
            motors: numbers(motors),
            turns: turns.clone(),
            poses: poses.iter().map(|pose| pose.map(mech_runtime::Real::to_f64)).collect(),
            state: numbers(state),
        }
    }

    fn moved(
        &self,
        position: &mut Fixed<T, M>,
        motors: Motors<T, M>,
        rates: [T; M],
    ) -> Result<Inertia<T, M>, (Cause, [T; M])> {
        let [(program, prepared), (inertia, prepared_inertia)] = &self.programs;
        let mut machine = Machine::at(program, prepared, self.free(position));
        machine.move_to(&motors.values).map_err(|stop| (cause(stop), motors.values))?;
        let there = machine.into_position();
        let felt = Machine::at(inertia, prepared_inertia, there.clone());
        let felt = felt.forces(&rates, &[T::ZERO; M], &[]).map_err(|stop| match stop {
            Stop::Open(_) => (Cause::Singular, motors.values),
            stop => (cause(stop), motors.values),
        })?;
        let Forces::Inertia(felt) = felt else {
            panic!("not the inertia");
        };
        *position = Self::fixed(&there);
        Ok(Inertia {
            matrix: std::array::from_fn(|row| {
                std::array::from_fn(|column| felt.matrix[row][column])
            }),
            drive: std::array::from_fn(|motor| felt.drive[motor]),
            kinetic: felt.energy[0],
            potential: felt.energy[1],
        })
    }

    fn fixed(position: &Position<T>) -> Fixed<T, M> {
        assert!(position.poses.len() <= LINKS && position.state.len() <= STATE, "it is too large");
        let none = Pose { cos: T::ZERO, sin: T::ZERO, x: T::ZERO, y: T::ZERO };
        Fixed {
            motors: Motors::new(std::array::from_fn(|motor| position.motors[motor])),
            poses: std::array::from_fn(|link| {
                position.poses.get(link).map_or(none, |&[cos, sin, x, y]| Pose { cos, sin, x, y })
            }),
            state: std::array::from_fn(|number| {
                position.state.get(number).copied().unwrap_or(T::ZERO)
            }),
        }
    }

    fn free(&self, position: &Fixed<T, M>) -> Position<T> {
        let poses = position.poses.iter().take(self.position.poses.len());
        Position {
            motors: position.motors.values.to_vec(),
            turns: vec![0; M],
            poses: poses.map(|pose| [pose.cos, pose.sin, pose.x, pose.y]).collect(),
            state: position.state[..self.position.state.len()].to_vec(),
        }
    }
}

/// What a stop of the interpreter is called in generated code.
fn cause(stop: Stop) -> Cause {
    match stop {
        Stop::Open(_) => Cause::Open,
        Stop::DeadPoint(_) => Cause::DeadPoint,
        Stop::ChangePoint(_) => Cause::ChangePoint,
        Stop::TooFar => Cause::TooFar,
        Stop::Singular(_) => Cause::Singular,
        Stop::NotFinite(_) => Cause::NotFinite,
        Stop::Overflow | Stop::MotorCount | Stop::Unasked => Cause::Overflow,
    }
}
