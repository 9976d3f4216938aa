//! Angles followed over whole turns as the mechanism moves, where it may pass change points on the way.

use crate::evaluate::Machine;
use crate::program::{Gauge, Position, Program, Value, computing};
use std::f64::consts::TAU;

/// A step may turn no angle by more than this, in radians.
const MOST: f64 = 0.5;

/// Shorter steps than this part of the way are not made.
const LEAST: f64 = 1e-9;

/// The angles of a mechanism that one motor moves.
pub(super) struct Follow {
    program: Program,
    motor: usize,
    angles: Vec<Value>,
    references: Vec<f64>,
    /// The places that were visited.
    known: Vec<Visited>,
}

struct Visited {
    position: Position<f64>,
    angles: Vec<f64>,
}

impl Follow {
    /// The angles of a gauge from the start on.
    pub(super) fn new(gauge: &Gauge, motor: usize) -> Self {
        let angles: Vec<Value> = gauge.angles.iter().map(|angle| angle.beyond).collect();
        let start = &gauge.program.start;
        let references = gauge.angles.iter();
        let references: Vec<f64> = references
            .map(|angle| start.state[angle.reference])
            .collect();
        let program = computing(&gauge.program, &angles);
        let known = vec![Visited {
            position: Machine::<f64>::new(&program).into_position(),
            angles: references.clone(),
        }];
        Self {
            program,
            motor,
            angles,
            references,
            known,
        }
    }

    /// The angles at a place; nothing if they turn too fast on the way there, or it is not reached.
    pub(super) fn angles_at(&mut self, place: &[f64]) -> Option<Vec<f64>> {
        let (motor, goal) = (self.motor, place[self.motor]);
        let far = |visited: &Visited| (visited.position.motors[motor] - goal).abs();
        let nearest = self.known.iter().min_by(|a, b| far(a).total_cmp(&far(b)))?;
        let mut machine = Machine::<f64>::new(&self.program);
        machine.put_back(nearest.position.clone());
        let mut angles = nearest.angles.clone();
        let way = far(nearest).max(f64::MIN_POSITIVE);
        let mut step = goal - machine.position().motors[motor];
        while machine.position().motors[motor] != goal {
            let before = machine.position().clone();
            let left = goal - before.motors[motor];
            let is_last = step.abs() >= left.abs();
            let mut values = before.motors.clone();
            values[motor] = if is_last {
                goal
            } else {
                before.motors[motor] + step
            };
            machine.move_to(&values).ok()?;
            let position = machine.position().clone();
            let beyond = machine.look_at(&values, &self.angles)?;
            let now = beyond.iter().zip(&self.references).zip(&angles);
            let now = now.map(|((beyond, reference), before)| {
                let angle = beyond + reference;
                angle + TAU * ((before - angle) / TAU).round()
            });
            let now: Vec<f64> = now.collect();
            let turned = now
                .iter()
                .zip(&angles)
                .map(|(now, before)| (now - before).abs());
            if turned.fold(0.0, f64::max) > MOST {
                machine.put_back(before);
                step *= 0.5;
                if step.abs() < LEAST * way {
                    return None;
                }
                continue;
            }
            machine.put_back(position.clone());
            angles.clone_from(&now);
            self.known.push(Visited {
                position,
                angles: now,
            });
        }
        Some(angles)
    }
}
