//! Where the links of a mechanism come to when its motors move.

use crate::kinematics;
use crate::model::{AxisId, LinkId, Model};
use crate::motion::sweep::{MostTurns, Sweep, interpolate, sweep_motors};
use crate::motion::walk::{Arrival, Walker};
use crate::plan::Plan;
use crate::program::Program;
use nalgebra::{Isometry2, Point2, Vector2};

/// How many operations all positions may cost if each takes one step, and if moves go in pieces.
const BUDGET: usize = 400_000;
const BUDGET_OF_PIECES: usize = 1_600_000;
/// So many positions may a sweep cost where it goes in pieces.
const OF_SWEEP: usize = 128;
/// Positions in a turn of the fastest link, and of a whole sweep.
const SAMPLES: [usize; 2] = [8, 36];
const MOST_SAMPLES: usize = 144;
/// Turns of a motor that are looked at: a wheel behind a worm looks the same after each.
const MOST_TURNS: i64 = 4;

/// The frames of all links at one position; none of links whose poses are not known.
pub(super) struct Frames(Vec<Option<Isometry2<f64>>>);

impl Frames {
    fn new(model: &Model, program: &Program, poses: &[[f64; 4]]) -> Self {
        let frame = |link: LinkId| {
            if link == LinkId::GROUND {
                return Some(Isometry2::identity());
            }
            Some(kinematics::frame(poses[program.place_of(link)?]))
        };
        Self(model.link_ids().map(frame).collect())
    }

    /// The frame of a link.
    pub(super) fn frame(&self, link: LinkId) -> Option<Isometry2<f64>> {
        self.0[link.index()]
    }

    /// The place of an axis in the scene.
    pub(super) fn place(&self, model: &Model, axis: AxisId) -> Option<Point2<f64>> {
        let axis = model.axis(axis);
        Some(self.frame(axis.link)? * Point2::from(axis.at))
    }

    /// The direction of an axis in the scene.
    pub(super) fn direction(&self, model: &Model, axis: AxisId) -> Option<Vector2<f64>> {
        let axis = model.axis(axis);
        Some(self.frame(axis.link)? * Vector2::from(axis.direction))
    }

    /// How far a place is along a line, seen from the line's origin.
    pub(super) fn along(&self, model: &Model, line: AxisId, place: Point2<f64>) -> Option<f64> {
        let offset = place - self.place(model, line)?;
        Some(offset.dot(&self.direction(model, line)?))
    }
}

/// Positions of a mechanism: the first is the start.
pub(super) struct Survey {
    pub(super) positions: Vec<Frames>,
}

impl Survey {
    /// Moves a mechanism as its motors can move it.
    pub(super) fn new(model: &Model, plan: &Plan, program: &Program) -> Self {
        let start = &program.start;
        let mut positions = vec![Frames::new(model, program, &start.poses)];
        let mut walker = Walker::new(program, BUDGET_OF_PIECES);
        let sweeps = model.motors.len().max(1);
        let affordable = (BUDGET / walker.price / sweeps).min(MOST_SAMPLES);
        sweep_motors(model, plan, MostTurns::OfMotor(MOST_TURNS), |sweep| {
            let Sweep {
                displacements,
                turns,
            } = sweep;
            let displacements = &within_ranges(model, &start.motors, displacements);
            let samples = affordable
                .min(turns * SAMPLES[1])
                .max((turns * SAMPLES[0]).min(MOST_SAMPLES));
            let mut go = |displacements: &[f64]| {
                walker.begin(start, OF_SWEEP);
                let came = (1..=samples).all(|sample| {
                    #[expect(clippy::cast_precision_loss, reason = "a hundred samples")]
                    let part = sample as f64 / samples as f64;
                    let target = interpolate(&start.motors, displacements, part);
                    let arrival = walker.visit(&target);
                    positions.push(Frames::new(model, program, &walker.seen().poses));
                    arrival == Arrival::There
                });
                (came, walker.position().motors.clone())
            };
            let (came, reached) = go(displacements);
            if !came {
                // A way that ends early is seen as closely as a whole one.
                let way = reached.iter().zip(&start.motors);
                go(&way.map(|(end, start)| end - start).collect::<Vec<f64>>());
            }
            came
        });
        Self { positions }
    }

    /// The frames at the start.
    pub(super) fn start(&self) -> &Frames {
        &self.positions[0]
    }

    /// The frame of a link at the start.
    pub(super) fn at_start(&self, link: LinkId) -> Option<Isometry2<f64>> {
        self.start().frame(link)
    }

    /// The least and the greatest of what a position has; none if no position has any.
    pub(super) fn range(&self, value: impl Fn(&Frames) -> Option<f64>) -> Option<[f64; 2]> {
        let values = self.positions.iter().filter_map(value);
        values.fold(None, |range, value| {
            let [low, high] = range.unwrap_or([value; 2]);
            Some([f64::min(low, value), f64::max(high, value)])
        })
    }

    /// The greater side of the box around the places of all axes, wherever they come to; none if all are in one place.
    pub(super) fn size(&self, model: &Model) -> Option<f64> {
        let axes = || (0..model.axes.len()).map(AxisId::new);
        let sides = [0, 1].map(|part| {
            let places = |frames: &Frames, better: fn(f64, f64) -> f64| {
                let places = axes().filter_map(|axis| frames.place(model, axis));
                places.map(|place| place[part]).reduce(better)
            };
            let low = self.range(|frames| places(frames, f64::min));
            let high = self.range(|frames| places(frames, f64::max));
            low.zip(high).map_or(0.0, |(low, high)| high[1] - low[0])
        });
        let size = sides[0].max(sides[1]);
        (size > 0.0).then_some(size)
    }
}

/// The same displacements, as far as no motor leaves its declared range: all together they would.
fn within_ranges(model: &Model, start: &[f64], displacements: &[f64]) -> Vec<f64> {
    let mut kept = displacements.to_vec();
    for (motor, (displacement, start)) in model.motors.iter().zip(kept.iter_mut().zip(start)) {
        if let Some(range) = &motor.range {
            *displacement = displacement.clamp(range.low - start, range.high - start);
        }
    }
    kept
}
