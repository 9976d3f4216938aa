//! How much room a mechanism takes, found by sweeping its motors.

use crate::evaluate::Machine;
use crate::model::{LinkId, Model};
use crate::motion::sweep::{Sweep, interpolate, sweep_motors};
use crate::plan::Plan;
use crate::program::Program;

/// How many operations it may cost.
const BUDGET: usize = 150_000;
/// Turns of a motor.
const MOST_TURNS: i64 = 400;
/// Samples in a turn.
const SAMPLES: [usize; 2] = [24, 120];

/// The smallest upright box around all that is seen wherever it was moved to: lower left and upper right corner. What is seen
/// are shapes, or joints and named points if there is no shape; if there is nothing, the box is the origin.
pub(crate) fn extent(model: &Model, plan: &Plan, program: &Program) -> [[f64; 2]; 2] {
    let mut around = Around::new(model, program);
    let mut machine = Machine::<f64>::new(program);
    around.look(&machine.position().poses);
    sweep_motors(model, plan, MOST_TURNS, |sweep| {
        let Sweep {
            displacements,
            turns,
        } = sweep;
        let live = program.live.iter().filter(|live| **live).count() + around.points();
        let affordable = BUDGET / (live * turns * displacements.len()).max(1);
        let samples = turns * affordable.clamp(SAMPLES[0], SAMPLES[1]);
        machine = Machine::new(program);
        for sample in 1..=samples {
            #[expect(clippy::cast_precision_loss, reason = "a few thousand samples")]
            let part = sample as f64 / samples as f64;
            if machine
                .move_to(&interpolate(&program.start.motors, displacements, part))
                .is_err()
            {
                return false;
            }
            around.look(&machine.position().poses);
        }
        true
    });
    around.corners()
}

/// A box that grows, and what is looked at.
struct Around {
    /// For each pose its points, and how far each reaches.
    moving: Vec<Vec<([f64; 2], f64)>>,
    low: [f64; 2],
    high: [f64; 2],
}

impl Around {
    fn new(model: &Model, program: &Program) -> Self {
        let seen = |id: LinkId| &model.link(id).shapes;
        let links = || std::iter::once(LinkId::GROUND).chain(program.stored.iter().copied());
        let has_shapes = links().any(|id| !seen(id).is_empty());
        let points = |id: LinkId| -> Vec<([f64; 2], f64)> {
            if has_shapes {
                let shapes = seen(id).iter().flat_map(|shape| {
                    let (points, reach) = shape.kind.reach();
                    points.iter().map(move |&point| (point, reach))
                });
                shapes.collect()
            } else {
                let axes = model.axes.iter().filter(|axis| axis.link == id);
                axes.map(|axis| (axis.at, 0.0)).collect()
            }
        };
        let mut around = Self {
            moving: program.stored.iter().map(|&id| points(id)).collect(),
            low: [f64::INFINITY; 2],
            high: [f64::NEG_INFINITY; 2],
        };
        for (point, reach) in points(LinkId::GROUND) {
            around.grow(point, reach);
        }
        around
    }

    fn points(&self) -> usize {
        self.moving.iter().map(Vec::len).sum()
    }

    fn look(&mut self, poses: &[[f64; 4]]) {
        let moving = std::mem::take(&mut self.moving);
        for (&[cos, sin, x, y], points) in poses.iter().zip(&moving) {
            for &([u, v], reach) in points {
                self.grow([x + cos * u - sin * v, y + sin * u + cos * v], reach);
            }
        }
        self.moving = moving;
    }

    fn grow(&mut self, point: [f64; 2], reach: f64) {
        for (axis, coordinate) in point.into_iter().enumerate() {
            self.low[axis] = self.low[axis].min(coordinate - reach);
            self.high[axis] = self.high[axis].max(coordinate + reach);
        }
    }

    fn corners(&self) -> [[f64; 2]; 2] {
        if self.low[0] <= self.high[0] {
            [self.low, self.high]
        } else {
            [[0.0; 2]; 2]
        }
    }
}
