//! The path of a point that motors follow: whether they can.

use crate::compiled::Compiled;
use crate::evaluate::{Machine, Stop};
use crate::kinematics::LinkFrames;
use crate::model::{Inverse, JointKind, Law, Model, Range};
use crate::structure::{Diagnosis, InverseTrouble, TrajectoryStop};
use std::f64::consts::TAU;

/// So many places are looked at until the path comes back.
const PLACES: i32 = 360;

/// Leads the point to where its path begins, and along it, if it comes back after a time that is known.
///
/// # Errors
/// If it is stopped at a place that is looked at.
pub(super) fn check(
    model: &Model,
    inverse: &Inverse,
    inverted: &Model,
    compiled: &Compiled,
) -> Result<(), Diagnosis> {
    let laws: Vec<&Law> = inverse
        .trajectory
        .iter()
        .map(|law| model.law(*law))
        .collect();
    if laws.is_empty() {
        return Ok(());
    }
    let period = model.period_of_trajectory(inverse);
    let params: Vec<f64> = model.params.values().collect();
    let mut follower = Follower::new(model, inverse, inverted, compiled);
    for place in 0..=if period.is_some() { PLACES } else { 0 } {
        let time = period.unwrap_or(0.0) * f64::from(place) / f64::from(PLACES);
        let given: Vec<f64> = laws.iter().map(|law| law.at(time, &params)).collect();
        if let Err(stop) = follower.lead(&given) {
            let trouble = InverseTrouble::Trajectory { time, given, stop };
            return Err(Diagnosis::Inverse { trouble });
        }
    }
    Ok(())
}

/// A mechanism in which a point is led.
struct Follower<'a> {
    model: &'a Model,
    inverse: &'a Inverse,
    inverted: &'a Model,
    compiled: &'a Compiled,
    machine: Machine<'a, f64>,
    /// The values of the motors that follow, over any number of turns.
    following: Vec<f64>,
}

impl<'a> Follower<'a> {
    fn new(
        model: &'a Model,
        inverse: &'a Inverse,
        inverted: &'a Model,
        compiled: &'a Compiled,
    ) -> Self {
        let joints = inverse.motors.iter().map(|motor| model.motor(*motor).joint);
        Self {
            model,
            inverse,
            inverted,
            compiled,
            machine: Machine::new(&compiled.program),
            following: joints.map(|joint| model.start.value(joint)).collect(),
        }
    }

    /// Leads the point to a place, with its angle less than half a turn from the present one.
    fn lead(&mut self, given: &[f64]) -> Result<(), TrajectoryStop> {
        let position = self.machine.position();
        let mut motors = position.motors.clone();
        for (number, (motor, value)) in self.inverse.motors.iter().zip(given).enumerate() {
            if !value.is_finite() {
                return Err(TrajectoryStop::Law);
            }
            let present = motors[motor.index()];
            let value = match number {
                Inverse::ANGLE => nearest(*value, present),
                _ => *value,
            };
            let range = self.inverse.region.get(number);
            if range.is_some_and(|range| leaves(value, range)) {
                return Err(TrajectoryStop::Region(number));
            }
            motors[motor.index()] = value;
        }
        motors.truncate(self.model.motors.len());
        self.machine
            .move_to(&motors)
            .map_err(|stop| self.obstacle(stop))?;
        self.follow()
    }

    /// Lets the motors follow, and tests whether they stay within their ranges.
    fn follow(&mut self) -> Result<(), TrajectoryStop> {
        let poses = &self.machine.position().poses;
        let frames = LinkFrames::of_some(self.inverted, &self.compiled.program.stored, poses);
        for (motor, value) in self.inverse.motors.iter().zip(&mut self.following) {
            let joint = self.model.motor(*motor).joint;
            let Some(coordinate) = frames.coordinate(joint) else {
                continue;
            };
            *value = match self.model.joint(joint).kind {
                JointKind::Revolute(..) => nearest(coordinate, *value),
                _ => coordinate,
            };
            let range = self.model.motor(*motor).range;
            if range.is_some_and(|range| leaves(*value, &range)) {
                return Err(TrajectoryStop::Range(*motor, *value));
            }
        }
        Ok(())
    }

    fn obstacle(&self, stop: Stop) -> TrajectoryStop {
        let (plan, program) = (&self.compiled.plan, &self.compiled.program);
        let number = match stop {
            Stop::Open(block) | Stop::DeadPoint(block) | Stop::ChangePoint(block) => {
                program.loop_of(block)
            }
            Stop::Singular(number) => Some(number),
            _ => None,
        };
        let ring = number.and_then(|number| plan.loops().nth(number));
        ring.map_or(TrajectoryStop::TooLarge, |ring| {
            let declared = ring.unknowns().into_iter();
            let declared = declared.filter(|joint| joint.index() < self.model.joints.len());
            TrajectoryStop::Loop(declared.collect())
        })
    }
}

/// The same angle, less than half a turn from another.
fn nearest(angle: f64, other: f64) -> f64 {
    angle + TAU * ((other - angle) / TAU).round()
}

/// Whether a value is outside of a range by more than rounding.
fn leaves(value: f64, Range { low, high, .. }: &Range) -> bool {
    const ROUNDING: f64 = 1e-9;
    let slack = ROUNDING * low.abs().max(high.abs()).max(1.0);
    value < low - slack || value > high + slack
}
