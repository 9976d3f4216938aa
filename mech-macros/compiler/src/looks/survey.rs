//! Where the links of a mechanism come to when its motors move.

use crate::model::{AxisId, JointId, LinkId, Model};
use crate::motion::sweep::{MostTurns, Sweep, interpolate, sweep_each, sweep_together};
use crate::motion::walk::{Arrival, Walker};
use crate::plan::Plan;
use crate::program::{Position, Program};
use mech_core::Pose;
use nalgebra::{Isometry2, Point2, Vector2};
use std::f64::consts::{PI, TAU};
use std::rc::Rc;

/// The number of operations that all positions may cost if each takes one step, and if moves go in pieces.
const BUDGET: usize = 400_000;
const BUDGET_OF_PIECES: usize = 1_600_000;
/// So many positions a sweep may cost whose moves need pieces.
const OF_SWEEP: usize = 128;
/// Positions in a turn of the fastest link, and of a whole sweep.
const SAMPLES: [usize; 2] = [8, 36];
const MOST_SAMPLES: usize = 144;
/// Turns of a motor that are looked at: a wheel behind a worm looks the same after each.
const MOST_TURNS: i64 = 4;
const ALL_TURNS: f64 = 3.9 * TAU;
/// Everything is where it was within this part of the mechanism's size.
const SAME: f64 = 1e-6;
/// A way that ends at once may begin beside a dead point. Then its first step is this part of a sample, and each next step so many times
/// as long.
const FIRST_STEP: f64 = 1.0 / 4096.0;
const LONGER: f64 = 4.0;
/// So many positions on the way of a single motor are kept. From each of them every other motor goes through its range, in a number of
/// samples between these two. In all these are not many more than the next number. From where slides then are farthest, each motor goes
/// through these parts of its range.
const BASES: usize = 4;
const SAMPLES_OF_PAIR: [usize; 2] = [3, 12];
const SAMPLES_OF_PAIRS: usize = 1200;
const PARTS: [f64; 2] = [1.0, 0.1];

/// The frames of all links at one position; none of links whose poses are not known.
pub(super) struct Frames(Vec<Option<Isometry2<f64>>>);

impl Frames {
    fn new(model: &Model, program: &Program, poses: &[[f64; 4]]) -> Self {
        let frame = |link: LinkId| {
            if link == LinkId::GROUND {
                return Some(Isometry2::identity());
            }
            Some(Pose::from(poses[program.place_of(link)?]).isometry())
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

    /// Returns the distance of a place along a line, from the line's origin.
    pub(super) fn along(&self, model: &Model, line: AxisId, place: Point2<f64>) -> Option<f64> {
        let offset = place - self.place(model, line)?;
        Some(offset.dot(&self.direction(model, line)?))
    }

    /// Returns the distance of a slide's block along its guide, from the guide's origin.
    pub(super) fn travel(&self, model: &Model, slide: Slide) -> Option<f64> {
        let place = self.place(model, slide.pin.unwrap_or(slide.block))?;
        self.along(model, slide.guide, place)
    }
}

/// Positions of a mechanism: the first is the start.
pub(super) struct Survey {
    pub(super) positions: Vec<Frames>,
}

impl Survey {
    /// Moves a mechanism with these slides as its motors can move it.
    pub(super) fn new(model: &Model, plan: &Plan, program: &Program, slides: &[Slide]) -> Self {
        // A mechanism with all its axes in one place is drawn as if its size were 1.
        let size = Some(model.size()).filter(|size| *size > 0.0);
        let size = size.unwrap_or(1.0);
        let mut surveyor = Surveyor::new(model, program, (slides, size));
        let most_turns = MostTurns::OfMotor(MOST_TURNS);
        sweep_each(model, plan, (most_turns, size), &mut |sweep| surveyor.sweep_alone(sweep));
        if model.motors.len() > 1 {
            sweep_together(model, &mut |sweep| surveyor.sweep_within_ranges(sweep));
            surveyor.stretch();
        }
        let positions = surveyor.positions.iter();
        let frames = positions.map(|position| Frames::new(model, program, &position.poses));
        Self { positions: frames.collect() }
    }

    /// The frames at the start.
    pub(super) fn start(&self) -> &Frames {
        &self.positions[0]
    }

    /// The frame of a link at the start.
    pub(super) fn at_start(&self, link: LinkId) -> Option<Isometry2<f64>> {
        self.start().frame(link)
    }

    /// The least and the greatest value over all positions that have one; none if no position has.
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

/// Moves a mechanism.
struct Surveyor<'a> {
    model: &'a Model,
    program: &'a Program,
    slides: &'a [Slide],
    walker: Walker<'a>,
    size: f64,
    /// From where to where each motor goes: as it is declared, or alone from the start. What can be turned for ever has no ends.
    ranges: Vec<[f64; 2]>,
    positions: Vec<Rc<Position<f64>>>,
    /// Some positions on the ways of single motors, each with the number of its motor.
    bases: Vec<(usize, Rc<Position<f64>>)>,
}

impl<'a> Surveyor<'a> {
    fn new(model: &'a Model, program: &'a Program, (slides, size): (&'a [Slide], f64)) -> Self {
        let endless = [f64::NEG_INFINITY, f64::INFINITY];
        let ranges = model.motors.iter().map(|motor| {
            let range = motor.range.as_ref();
            range.map_or(endless, |range| [range.low, range.high])
        });
        Self {
            model,
            program,
            slides,
            walker: Walker::new(program, BUDGET_OF_PIECES),
            size,
            ranges: ranges.collect(),
            positions: vec![Rc::new(program.start.clone())],
            bases: Vec::new(),
        }
    }

    /// Moves one motor; returns whether everything is as at the start after that, as far as it matters.
    fn sweep_alone(&mut self, sweep: &Sweep) -> bool {
        let moves = |displacement: &f64| *displacement != 0.0;
        let Some(motor) = sweep.displacements.iter().position(moves) else {
            return true;
        };
        let mut from = Rc::clone(&self.positions[0]);
        let joint = self.model.motors[motor].joint;
        let turns = self.model.turns(joint);
        let is_endless = turns && self.model.motors[motor].range.is_none();
        // Past change points it takes several turns until everything is where it was.
        let passes = is_endless && self.program.passes_change_points();
        loop {
            let known = self.positions.len();
            let came = self.sweep(&from, sweep);
            let way = &self.positions[known..];
            let bases = (1..=BASES).map(|base| (base * way.len()).div_ceil(BASES).max(1) - 1);
            self.bases.extend(bases.map(|base| (motor, Rc::clone(&way[base]))));
            from = self.walker.here();
            if came && (self.slides.is_empty() || self.is_as_at_start()) {
                return true;
            }
            let turned = (from.motors[motor] - self.positions[0].motors[motor]).abs();
            if !(came && passes && turned < ALL_TURNS) {
                break;
            }
        }
        let side = usize::from(sweep.displacements[motor] > 0.0);
        self.ranges[motor][side] = from.motors[motor];
        false
    }

    /// Moves all motors from the start, as far as none leaves its range.
    fn sweep_within_ranges(&mut self, sweep: &Sweep) -> bool {
        let start = Rc::clone(&self.positions[0]);
        let Sweep { mut displacements, turns } = sweep.clone();
        let values = displacements.iter_mut().zip(&start.motors);
        for ((displacement, start), [low, high]) in values.zip(&self.ranges) {
            *displacement = displacement.max(low - start).min(high - start);
        }
        let sweep = Sweep { displacements, turns };
        self.sweep(&start, &sweep)
    }

    /// Moves along a sweep and keeps the positions; returns whether it came to its end.
    fn sweep(&mut self, from: &Rc<Position<f64>>, sweep: &Sweep) -> bool {
        let affordable = BUDGET / self.walker.price / self.model.motors.len().max(1);
        let samples = affordable
            .min(MOST_SAMPLES)
            .min(sweep.turns * SAMPLES[1])
            .max((sweep.turns * SAMPLES[0]).min(MOST_SAMPLES));
        let (mut came, mut way) = self.move_by(from, &sweep.displacements, (samples, 1.0));
        if way.len() == 1 {
            (came, way) = self.move_by(from, &sweep.displacements, (samples, FIRST_STEP));
        }
        if !came {
            // A way that ends early is seen as closely as a whole one.
            let end = self.walker.position().motors.iter();
            let displacements = end.zip(&from.motors).map(|(end, from)| end - from);
            let displacements: Vec<f64> = displacements.collect();
            way.extend(self.move_by(from, &displacements, (samples, 1.0)).1);
        }
        self.positions.append(&mut way);
        came
    }

    /// Moves the motors so far; returns whether they came there, and the positions on the way.
    fn move_by(
        &mut self,
        from: &Position<f64>,
        displacements: &[f64],
        (samples, first): (usize, f64),
    ) -> (bool, Vec<Rc<Position<f64>>>) {
        self.walker.begin(from, OF_SWEEP);
        let mut way = Vec::new();
        #[expect(clippy::cast_precision_loss, reason = "a hundred samples")]
        let part_of = |sample: f64| sample / samples as f64;
        let steps = std::iter::successors(Some(first), |step| Some(step * LONGER));
        let steps = steps.take_while(|step| *step < 1.0).map(part_of);
        #[expect(clippy::cast_precision_loss, reason = "a hundred samples")]
        let parts = (1..=samples).map(|sample| part_of(sample as f64));
        let came = steps.chain(parts).all(|part| {
            let target = interpolate(&from.motors, displacements, part);
            let arrival = self.walker.visit(&target);
            way.push(self.walker.here());
            arrival == Arrival::There
        });
        (came, way)
    }

    /// Whether every link is where it was at the start.
    fn is_as_at_start(&self) -> bool {
        let poses = self.walker.position().poses.iter();
        let mut pairs = poses.zip(&self.program.start.poses);
        pairs.all(|(now, start)| {
            let off = |part: usize| (now[part] - start[part]).abs();
            off(0).max(off(1)) <= SAME && off(2).max(off(3)) <= SAME * self.size
        })
    }

    /// Looks for where slides go farthest that several motors may move.
    fn stretch(&mut self) {
        let model = self.model;
        let is_driven = |slide: &Slide| {
            let own = Some([slide.guide, slide.block]);
            let mut motors = model.motors.iter();
            motors.any(|motor| model.guide_and_block(motor.joint) == own)
        };
        let slides = self.slides.iter().filter(|slide| !is_driven(slide));
        let ends = slides.flat_map(|&slide| [-1.0, 1.0].map(|sense| (slide, sense)));
        let mut all: Vec<Farthest> = ends
            .map(|(slide, sense)| Farthest {
                slide,
                sense,
                out: f64::NEG_INFINITY,
                at: Rc::clone(&self.positions[0]),
            })
            .collect();
        self.note(&mut all, &self.positions);
        let motors = self.ranges.len();
        let bases = std::mem::take(&mut self.bases);
        let pairs = 2 * (bases.len() * (motors - 1) + PARTS.len() * all.len() * motors);
        let [least, most] = SAMPLES_OF_PAIR;
        let samples = (SAMPLES_OF_PAIRS / pairs.max(1)).clamp(least, most);
        if all.is_empty() || samples * pairs > BUDGET / self.walker.price {
            return;
        }
        for (own, base) in bases {
            for motor in (0..motors).filter(|motor| *motor != own) {
                self.look_around(&base, (motor, 1.0), samples, &mut all);
            }
        }
        for part in PARTS {
            for end in 0..all.len() {
                for motor in 0..motors {
                    let from = Rc::clone(&all[end].at);
                    self.look_around(&from, (motor, part), samples, &mut all);
                }
            }
        }
        self.positions.extend(all.into_iter().map(|end| end.at));
    }

    /// Moves a motor through a part of its range and notes where slides go farther.
    fn look_around(
        &mut self,
        from: &Position<f64>,
        (motor, part): (usize, f64),
        samples: usize,
        all: &mut [Farthest],
    ) {
        let ends = self.ranges[motor].into_iter().zip([-PI, PI]);
        for (end, half_turn) in ends {
            let way = end - from.motors[motor];
            let mut displacements = vec![0.0; from.motors.len()];
            displacements[motor] = part * if way.is_finite() { way } else { half_turn };
            let (_, way) = self.move_by(from, &displacements, (samples, 1.0));
            self.note(all, &way);
        }
    }

    /// Notes where slides go farther than is known.
    fn note(&self, all: &mut [Farthest], positions: &[Rc<Position<f64>>]) {
        for position in positions {
            let frames = Frames::new(self.model, self.program, &position.poses);
            for end in &mut *all {
                let out = frames.travel(self.model, end.slide);
                if let Some(out) = out.map(|out| end.sense * out).filter(|out| *out > end.out) {
                    (end.out, end.at) = (out, Rc::clone(position));
                }
            }
        }
    }
}

/// Where a slide goes farthest in one sense.
struct Farthest {
    slide: Slide,
    sense: f64,
    out: f64,
    at: Rc<Position<f64>>,
}

/// A prismatic joint: which link has the guide, and which one slides along it.
#[derive(Clone, Copy)]
pub(super) struct Slide {
    /// The line of the guide.
    pub(super) guide: AxisId,
    /// The line of what slides; of a slot, of its hidden die.
    pub(super) block: AxisId,
    /// The pin that slides in it, if it is a slot.
    pub(super) pin: Option<AxisId>,
}

impl Slide {
    /// The slide that a joint is, if it is one.
    pub(super) fn of(model: &Model, joint: JointId) -> Option<Self> {
        let [guide, block] = model.guide_and_block(joint)?;
        let die = model.link(model.axis(block).link).die;
        Some(Self { guide, block, pin: die.map(|(pin, _)| pin) })
    }
}
