//! A test bed: moves a mechanism and holds each position against its declaration.

use crate::geometry::{Expected, Tolerance};
use mech_compiler::evaluate::{Machine, Stop};
use mech_compiler::model::{Axis, JointKind, Method, Model};
use mech_compiler::program::{Position, Program, Real};
use mech_test_support::{lengths, with_ground, worst_gap, worst_stretch};
use std::rc::Rc;

/// A gap of this many units of rounding of the size passes for closed, in each coordinate.
const ROUNDING: f64 = 64.0;
/// Where rounding hides the side: a sine of so many roots of a unit of rounding.
const HIDDEN: f64 = 16.0;

/// What is tried.
pub(crate) struct Tried<'m> {
    pub(crate) model: &'m Model,
    program: &'m Program,
    lengths: f64,
}

impl<'m> Tried<'m> {
    pub(crate) fn new(model: &'m Model, program: &'m Program) -> Self {
        let lengths = lengths(model).sum();
        Self { model, program, lengths }
    }
}

/// A mechanism on the test bed.
#[derive(Clone)]
pub(crate) struct Bed<'m, T: Real> {
    tried: &'m Tried<'m>,
    points: Rc<[Expected]>,
    machine: Machine<'m, T>,
}

impl<'m, T: Real> Bed<'m, T> {
    /// At the start.
    pub(crate) fn new(tried: &'m Tried<'m>, points: Vec<Expected>) -> Self {
        let bed = Self { tried, points: points.into(), machine: Machine::new(tried.program) };
        bed.assert_whole();
        bed
    }

    /// The same mechanism as it was assembled.
    pub(crate) fn fresh(&self) -> Self {
        let mut bed = self.clone();
        bed.machine = Machine::new(self.tried.program);
        bed
    }

    /// The value of the only motor.
    pub(crate) fn motor(&self) -> f64 {
        self.machine.position().motors[0].to_f64()
    }

    /// So many roundings of what is as large as one.
    pub(crate) fn roundings(count: f64) -> f64 {
        count * T::EPSILON
    }

    /// Where rounding hides the side of a loop.
    pub(crate) fn hidden() -> f64 {
        HIDDEN * T::EPSILON.sqrt()
    }

    /// Moves it; wherever it then is, it is whole, and if it did not move, nothing changed.
    pub(crate) fn move_to(&mut self, value: f64) -> Result<(), Stop> {
        let before = self.machine.position().clone();
        let result = self.machine.move_to(&[T::from_f64(value)]);
        if result.is_err() {
            let same = bits(self.machine.position()) == bits(&before);
            assert!(same, "a refused move changes something");
        }
        self.assert_whole();
        result
    }

    /// Moves it, which must succeed, to where it is right.
    #[track_caller]
    pub(crate) fn must(&mut self, value: f64) {
        let from = self.motor();
        if let Err(stop) = self.move_to(value) {
            panic!("from {from} to {value}: {stop:?}");
        }
        self.assert_right();
    }

    /// Moves it as far as it goes towards this value; gives why not all the way.
    pub(crate) fn toward(&mut self, value: f64) -> Option<Stop> {
        let stop = self.machine.move_toward(&[T::from_f64(value)]);
        self.assert_right();
        stop.expect("values are finite")
    }

    /// Moves it to a phase.
    pub(crate) fn turn_to(&mut self, phase: mech_runtime::Phase) {
        self.machine.turn_to(&[phase]).expect("it turns for ever");
        self.assert_right();
    }

    /// The pose of a link.
    pub(crate) fn pose(&self, link: &str) -> [f64; 4] {
        let mut links = self.tried.program.links.iter();
        let at = links.position(|name| name == link);
        self.machine.position().poses[at.expect("the link is declared")].map(T::to_f64)
    }

    /// Poses of all links, the ground first.
    pub(crate) fn poses(&self) -> Vec<[f64; 4]> {
        let poses = self.machine.position().poses.iter();
        let poses: Vec<[f64; 4]> = poses.map(|pose| pose.map(T::to_f64)).collect();
        with_ground(self.tried.model, &poses)
    }

    /// Holds all points against where they should be, and the whole against its declaration.
    #[track_caller]
    pub(crate) fn assert_right(&self) {
        self.assert_whole();
        for point in self.points.iter() {
            let is_hidden = point.only_seen && point.sine(self.motor()).abs() <= Self::hidden();
            if !is_hidden {
                self.assert_at(point);
            }
        }
    }

    /// Holds a point of a link against where it should be, by the conditioning of the position: the sine of the transmission
    /// angle. At a dead point half of the digits are left.
    #[track_caller]
    pub(crate) fn assert_at(&self, point: &Expected) {
        let ([cos, sin, x, y], [u, v]) = (self.pose(&point.link), point.on_link);
        let (is, should) = ([x + cos * u - sin * v, y + sin * u + cos * v], point.at(self.motor()));
        let off = (is[0] - should[0]).hypot(is[1] - should[1]);
        let rounding = ROUNDING * T::EPSILON;
        let most = match point.tolerance {
            Tolerance::Within(size) => rounding * size,
            _ => rounding * self.size() / point.sine(self.motor()).abs().max(rounding.sqrt()),
        };
        assert!(
            off <= most,
            "at {} {} is at {is:?} instead of {should:?}: off by {off:e}, more than {most:e}",
            self.motor(),
            point.link
        );
    }

    /// The lengths that rounding is relative to: of the links, and of the coordinates of what they are joined by.
    pub(crate) fn size(&self) -> f64 {
        let (poses, model) = (self.poses(), self.tried.model);
        let at = |axis: &Axis| {
            let ([u, v], [cos, sin, x, y]) = (axis.at, poses[axis.link.index()]);
            (x + cos * u - sin * v).hypot(y + sin * u + cos * v)
        };
        let joined = model.joints.iter().map(|joint| match joint.kind {
            JointKind::Revolute(a, b) | JointKind::Prismatic(a, b) => {
                at(model.axis(a)).max(at(model.axis(b)))
            }
            _ => 0.0,
        });
        self.tried.lengths + joined.sum::<f64>()
    }

    /// Its pins are where they should be, and its links as long as they were declared.
    #[track_caller]
    fn assert_whole(&self) {
        let poses = self.poses();
        assert!(
            poses.iter().flatten().all(|number| number.is_finite()),
            "at {} a pose is not finite",
            self.motor()
        );
        let model = self.tried.model;
        let part = match model.method {
            Some(Method::Linear) => 1e-2,
            // Each round but the first squares a thousandth. Of a loop's size, a link that two rings share is counted twice.
            Some(Method::NewtonSteps(rounds)) => {
                let promised = 2.0 * 1e-3_f64.powi(1 << (rounds - 1).min(4));
                promised.max(ROUNDING * T::EPSILON)
            }
            _ => ROUNDING * T::EPSILON,
        };
        // A linear step turns to first order: what it promises for gaps, it promises for lengths.
        let longest = match model.method {
            Some(Method::Linear) => part,
            _ => 16.0 * T::EPSILON,
        };
        let stretch = worst_stretch(&poses) / T::EPSILON;
        let (gap, most) = (worst_gap(model, &poses), std::f64::consts::SQRT_2 * part * self.size());
        assert!(
            stretch * T::EPSILON <= longest && gap <= most,
            "at {} a link is stretched by {stretch:.0} eps, or there is a gap of {gap:e}, more than {most:e}",
            self.motor()
        );
    }
}

/// Every bit of a position.
fn bits<T: Real>(position: &Position<T>) -> Vec<u64> {
    let numbers = position.poses.iter().flatten().chain(&position.motors);
    let numbers = numbers.chain(&position.state);
    numbers.map(|number| number.to_f64().to_bits()).collect()
}
