//! Positions of rest: where springs, weights and loads bring the motors that are let go.
//!
//! The torques that hold a position are the slope of its potential energy. They are followed downhill by a quasi-Newton method: J. Nocedal and
//! S. J. Wright, *Numerical Optimization* (2006), chapters 3 and 6. Each step ends where the slope along it has become small.

use super::{Mover, obstacle, range_of};
use crate::failure::Failure;
use mech_compiler::Compiled;
use mech_compiler::evaluate::Stop;
use mech_compiler::model::{Model, MotorId};
use mech_compiler::program::Forces;

/// More steps than this are not made.
const MOST_STEPS: u32 = 2000;
/// A step moves no motor by more than this: radians, or parts of the size of the mechanism.
const LONGEST: f64 = 0.05;
/// A motor that has gone farther than this does not come to rest.
const FAR: f64 = 1e3;
/// A slope of less than this part of the greatest is none.
const LEVEL: f64 = 1e-10;
/// A slope along a step has become small if it is less than this part of what it was.
const SMALL: f64 = 0.3;
/// A position is tried so far beside one where nothing pulls.
const BESIDE: f64 = 1e-4;
/// So often a step is halved before what stops it is believed to.
const HALVINGS: u32 = 40;

/// Where a mechanism comes to rest.
#[derive(Clone, Debug)]
pub(crate) struct Rest {
    /// The values of all motors, in radians and scene units.
    pub(crate) motors: Vec<f64>,
    /// The torque or force with which each motor leans against an end of its range; none if it rests by itself, or is held.
    pub(crate) leaning: Vec<Option<f64>>,
    /// What stops it, if it leans against a dead point.
    pub(crate) stop: Option<String>,
}

/// A mechanism some of whose motors are let go. Values of motors are in radians, and in sizes of the mechanism.
struct Falling<'a> {
    model: &'a Model,
    machine: Mover<'a>,
    holding: Mover<'a>,
    loads: &'a [f64],
    /// The motors that are let go.
    free: Vec<MotorId>,
    /// The sizes of their values.
    sizes: Vec<f64>,
    ends: Vec<Option<[f64; 2]>>,
    /// The greatest slope that was met.
    steepest: f64,
}

/// Finds where a mechanism comes to rest from where a machine is, if these motors are let go, and the others are held. It has to be compiled
/// with forces.
pub(crate) fn find_rest(
    model: &Model,
    compiled: &Compiled,
    machine: Mover<'_>,
    free: Vec<MotorId>,
    loads: &[f64],
) -> Result<Rest, Failure> {
    let Some(program) = &compiled.forced.holding else {
        return Err(Failure::internal("forces have no program that holds"));
    };
    let size = |motor: &MotorId| {
        if model.turns(model.motor(*motor).joint) {
            1.0
        } else {
            model.size()
        }
    };
    let mut falling = Falling {
        model,
        machine,
        holding: Mover::of(model, program),
        loads,
        sizes: free.iter().map(size).collect(),
        ends: free.iter().map(|motor| range_of(model, *motor)).collect(),
        free,
        steepest: 0.0,
    };
    let told = |stop| {
        let why = obstacle(model, compiled, stop);
        Failure::mechanism(format!("forces are not determined there: {why}"))
    };
    let stop = falling.fall(told)?;
    if falling.steepest == 0.0 {
        return Err(Failure::mechanism(
            "nothing pulls at its motors: no weights, springs or loads do; declare `gravity` and masses, or a spring, or give `--load`",
        ));
    }
    let slopes = falling.pull().map_err(told)?;
    let motors = falling.machine.position().motors;
    let mut leaning = vec![None; model.motors.len()];
    for (number, motor) in falling.free.iter().enumerate() {
        let leans = falling.leans(number, slopes[number]);
        leaning[motor.index()] = leans.then(|| slopes[number] / falling.sizes[number]);
    }
    Ok(Rest {
        motors: motors[..model.motors.len()].to_vec(),
        leaning,
        stop: stop.map(|stop| obstacle(model, compiled, stop)),
    })
}

impl Falling<'_> {
    /// The pull on each free motor where the machine is: the slope of its potential energy, downhill.
    fn pull(&mut self) -> Result<Vec<f64>, Stop> {
        self.holding.put_back(&self.machine.position());
        let still = vec![0.0; self.model.motors.len()];
        let Forces::Holding(torques) = self.holding.forces([&still, &still], self.loads)? else {
            return Err(Stop::Unasked);
        };
        let pairs = self.free.iter().zip(&self.sizes);
        Ok(pairs
            .map(|(motor, size)| -torques[motor.index()] * size)
            .collect())
    }

    /// The values of the free motors.
    fn place(&self) -> Vec<f64> {
        let motors = self.machine.position().motors;
        let pairs = self.free.iter().zip(&self.sizes);
        pairs
            .map(|(motor, size)| motors[motor.index()] / size)
            .collect()
    }

    /// Moves the free motors to other values, within their ranges.
    fn move_to(&mut self, place: &[f64]) -> Result<(), Stop> {
        let mut motors = self.machine.position().motors[..self.model.motors.len()].to_vec();
        for (number, motor) in self.free.iter().enumerate() {
            let value = place[number] * self.sizes[number];
            motors[motor.index()] = match self.ends[number] {
                Some([low, high]) => value.clamp(low, high),
                None => value,
            };
        }
        self.machine.move_to(&motors)
    }

    /// Whether a free motor is at an end of its range, and pulled beyond it.
    fn leans(&self, number: usize, slope: f64) -> bool {
        let Some(ends) = self.ends[number] else {
            return false;
        };
        let value = self.place()[number] * self.sizes[number];
        let slack = 1e-12 * (ends[1] - ends[0]);
        let is_level = slope.abs() <= LEVEL * self.steepest;
        !is_level
            && (slope < 0.0 && value <= ends[0] + slack || slope > 0.0 && value >= ends[1] - slack)
    }

    /// The pull as far as motors can follow it.
    fn free_pull(&mut self) -> Result<Vec<f64>, Stop> {
        let pull = self.pull()?;
        let steepest = pull
            .iter()
            .fold(self.steepest, |most, one| most.max(one.abs()));
        self.steepest = steepest;
        let free = pull.iter().enumerate();
        Ok(free
            .map(|(number, slope)| {
                let is_held = slope.abs() <= LEVEL * steepest || self.leans(number, *slope);
                if is_held { 0.0 } else { *slope }
            })
            .collect())
    }

    /// Falls until nothing pulls any more. Gives what stops it before, if anything does.
    fn fall(&mut self, told: impl Fn(Stop) -> Failure) -> Result<Option<Stop>, Failure> {
        let count = self.free.len();
        let mut inverse = Inverse::new(count);
        let begin = self.place();
        for _ in 0..MOST_STEPS {
            let slope = self.free_pull().map_err(&told)?;
            if slope.iter().all(|slope| *slope == 0.0) {
                if self.stays(&told)? {
                    return Ok(None);
                }
                inverse = Inverse::new(count);
                continue;
            }
            let way = inverse.direction(&slope);
            let from = self.place();
            let along = dot(&way, &slope);
            let (pulled, stop) = self.step(&from, &way, along).map_err(&told)?;
            let to = self.place();
            let moved = plus(&to, -1.0, &from);
            let size = moved.iter().fold(0.0, |most: f64, one| most.max(one.abs()));
            let Some(pulled) = pulled.filter(|_| size > 0.0) else {
                return Ok(stop);
            };
            inverse.learn(&moved, &plus(&slope, -1.0, &pulled));
            if plus(&to, -1.0, &begin).iter().any(|far| far.abs() > FAR) {
                break;
            }
            if stop.is_some() && size <= 1e-12 {
                return Ok(stop);
            }
        }
        Err(Failure::mechanism(
            "it does not come to rest: nothing stops what pulls at its motors; hold one by `--at`, or give it a range or a spring",
        ))
    }

    /// Goes a part of a way, on which it is pulled so much, until that has become small. Gives the pull there, and what stopped it.
    fn step(
        &mut self,
        from: &[f64],
        way: &[f64],
        along: f64,
    ) -> Result<(Option<Vec<f64>>, Option<Stop>), Stop> {
        let (mut pulled, mut stop) = (None, None);
        let mut part = 1.0;
        // Between what is too short and what is too long.
        let (mut short, mut long) = (0.0, f64::INFINITY);
        for _ in 0..HALVINGS {
            if let Err(blocked) = self.move_to(&plus(from, part, way)) {
                stop = Some(blocked);
                long = part;
            } else {
                let slope = self.pull()?;
                let left = dot(way, &slope);
                pulled = Some(slope);
                if left < -SMALL * along {
                    long = part;
                } else if left > 0.9 * along && part < 4.0 && long.is_infinite() {
                    short = part;
                } else {
                    break;
                }
            }
            part = if long.is_finite() {
                0.5 * (short + long)
            } else {
                2.0 * part
            };
        }
        Ok((pulled, stop))
    }

    /// Whether it comes back from a little beside where it is. Else it is left there.
    fn stays(&mut self, told: &impl Fn(Stop) -> Failure) -> Result<bool, Failure> {
        let (here, position) = (self.place(), self.machine.position());
        for number in 0..self.free.len() {
            for sign in [1.0, -1.0] {
                let mut beside = here.clone();
                beside[number] += sign * BESIDE;
                if self.move_to(&beside).is_ok() {
                    let slope = self.pull().map_err(told)?;
                    let moved = self.place()[number] - here[number];
                    if moved * sign > 0.0 && slope[number] * sign > 1e-7 * self.steepest {
                        return Ok(false);
                    }
                }
                self.machine.put_back(&position);
            }
        }
        Ok(true)
    }
}

/// What is known of the inverse of the second derivatives.
struct Inverse {
    rows: Vec<Vec<f64>>,
    is_known: bool,
}

impl Inverse {
    fn new(count: usize) -> Self {
        let row = |number| {
            (0..count)
                .map(|other| f64::from(u8::from(other == number)))
                .collect()
        };
        Self {
            rows: (0..count).map(row).collect(),
            is_known: false,
        }
    }

    /// The way to go where this pulls: no motor farther than the longest step.
    fn direction(&mut self, slope: &[f64]) -> Vec<f64> {
        let mut way: Vec<f64> = self.rows.iter().map(|row| dot(row, slope)).collect();
        for (part, slope) in way.iter_mut().zip(slope) {
            // What leans against an end stays there.
            if *slope == 0.0 {
                *part = 0.0;
            }
        }
        if dot(&way, slope) <= 0.0 {
            *self = Self::new(slope.len());
            way = slope.to_vec();
        }
        let most = way.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
        if most > LONGEST || !self.is_known {
            let share = LONGEST / most;
            for part in &mut way {
                *part *= share;
            }
        }
        way
    }

    /// Takes a step by which the slopes changed so much (BFGS).
    fn learn(&mut self, step: &[f64], change: &[f64]) {
        let along = dot(step, change);
        if along <= 1e-14 * dot(change, change).sqrt() * dot(step, step).sqrt() {
            return;
        }
        if !self.is_known {
            let share = along / dot(change, change);
            for row in &mut self.rows {
                for entry in row {
                    *entry *= share;
                }
            }
            self.is_known = true;
        }
        let across: Vec<f64> = self.rows.iter().map(|row| dot(row, change)).collect();
        let both = (along + dot(change, &across)) / (along * along);
        for (row, (own, left)) in self.rows.iter_mut().zip(step.iter().zip(&across)) {
            for (entry, (other, right)) in row.iter_mut().zip(step.iter().zip(&across)) {
                *entry += both * own * other - (left * other + own * right) / along;
            }
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn plus(a: &[f64], factor: f64, b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + factor * b).collect()
}
