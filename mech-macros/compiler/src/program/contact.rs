//! The contact of a cam and the roller of its follower, from the carrier of both: pressure angle and curvature.
//!
//! Source: H. A. Rothbart, *Cam Design Handbook* (2004), chapters 6 and 7. Seen from the cam, the middle of the roller runs on the pitch
//! curve. Its velocity there is the tangent `t`, its acceleration `c` for a shaft that turns evenly. The pressure angle is that between the
//! normal and the way of the follower, the curvature `t × c / |t|³`.

use super::build::{Seed, Tangents};
use super::builder::SsaBuilder;
use super::node::{Op, Value};
use super::{Position, Program, Ssa, timing};
use crate::model::{AxisId, InputId, JointId, JointKind, Law, LinkId, Model, Precision};
use crate::plan::{Algebra, Numbers};

/// Where cam and follower are, and how they move.
pub(super) struct Contact<S> {
    /// The axis of the shaft.
    pub(super) center: [S; 2],
    /// The middle of the roller.
    pub(super) roller: [S; 2],
    pub(super) guide: Guide<S>,
    /// Whether the shaft's coordinate is that of the cam in the carrier, 1, or of the carrier in the cam, −1.
    pub(super) sense: f64,
    /// The first and the second derivative of the follower's coordinate by the shaft's.
    pub(super) slopes: [S; 2],
}

/// How the roller is led.
pub(super) enum Guide<S> {
    /// In this direction, if the coordinate grows: a unit vector.
    Along([S; 2]),
    /// About this place, counter-clockwise if the coordinate grows and the number is 1, else −1.
    About([S; 2], f64),
}

/// The numbers of a contact.
pub(super) struct Pressed<S> {
    /// The sine of the pressure angle, and its cosine, both times the same.
    pub(super) sine: S,
    pub(super) cosine: S,
    pub(super) curvature: S,
}

impl<S: Copy> Contact<S> {
    pub(super) fn pressed<A: Algebra<S>>(&self, a: &mut A) -> Pressed<S> {
        let quarter = |a: &mut A, [x, y]: [S; 2]| [a.neg(y), x];
        let [first, second] = self.slopes;
        let sense = a.constant(self.sense);
        let arm = a.minus(self.roller, self.center);
        // The way of the follower for a coordinate that grows by one, and how that bends.
        let (way, bend) = match self.guide {
            Guide::Along(direction) => (direction, None),
            Guide::About(pivot, sense) => {
                let lever = a.minus(self.roller, pivot);
                let (way, sense) = (quarter(a, lever), a.constant(sense));
                (a.scale(sense, way), Some(lever))
            }
        };
        let velocity = a.scale(first, way);
        let mut acceleration = a.scale(second, way);
        if let Some(lever) = bend {
            let square = a.mul(first, first);
            let inwards = a.scale(square, lever);
            acceleration = a.minus(acceleration, inwards);
        }
        // Seen from the cam, which turns at a rate of one.
        let turned = quarter(a, arm);
        let carried = a.scale(sense, turned);
        let tangent = a.minus(velocity, carried);
        let across = quarter(a, velocity);
        let two = a.constant(2.0);
        let twice = a.mul(two, sense);
        let across = a.scale(twice, across);
        let seen = a.minus(acceleration, across);
        let seen = a.minus(seen, arm);
        let square = a.dot(tangent, tangent);
        let length = a.sqrt(square);
        let cube = a.mul(square, length);
        let turning = a.cross(tangent, seen);
        // About the shaft the curve goes the other way than the cam turns.
        let turning = a.mul(sense, turning);
        let turning = a.neg(turning);
        Pressed {
            sine: a.dot(tangent, way),
            cosine: a.cross(tangent, way),
            curvature: a.div(turning, cube),
        }
    }
}

/// A cam that turns, with a roller: as it is at the start, with the shaft at any angle.
pub struct CamContact {
    /// The carrier, the cam and the follower are where they are at the start.
    center: [f64; 2],
    roller: [f64; 2],
    guide: Guide<f64>,
    sense: f64,
    /// The follower's coordinate at the start.
    start: f64,
    law: LawProgram,
    params: Vec<f64>,
    /// The radius of the roller, in scene units.
    pub radius: f64,
}

/// The pressure angle of a cam in radians, and the curvature of its pitch curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CamNumbers {
    /// Between the normal and the way of the follower, 0 to π/2.
    pub pressure: f64,
    /// One divided by the radius, in scene units: positive where the curve is convex.
    pub curvature: f64,
}

impl CamContact {
    /// The contact of a cam; none if its roller was not declared, its shaft slides, or a program does not find its links.
    #[must_use]
    pub fn new(model: &Model, program: &Program, cam: JointId) -> Option<Self> {
        let roller = model.roller_of(cam)?;
        let JointKind::Cam { shaft, follower, law } = model.joint(cam).kind else {
            return None;
        };
        let JointKind::Revolute(..) = model.joint(shaft).kind else {
            return None;
        };
        let carrier = model.carrier_of_cam(shaft, follower)?;
        let (center, sense) = model.beside(shaft, carrier)?;
        let (own, forwards) = model.beside(follower, carrier)?;
        let at_start = AtStart { model, start: &program.start, program };
        let guide = match model.joint(follower).kind {
            JointKind::Prismatic(from, _) => {
                let [x, y] = at_start.direction(from)?;
                Guide::Along([forwards * x, forwards * y])
            }
            _ => Guide::About(at_start.place(own)?, forwards),
        };
        Some(Self {
            center: at_start.place(center)?,
            roller: at_start.place(roller.point)?,
            guide,
            sense,
            start: at_start.coordinate(follower)?,
            law: LawProgram::new(model, model.law(law)),
            params: model.params.values().collect(),
            radius: roller.radius,
        })
    }

    /// Its numbers where the coordinate of the shaft is this.
    #[must_use]
    pub fn at(&self, shaft: f64) -> CamNumbers {
        let [value, first, second] = self.law.at(shaft, &self.params);
        let moved = value - self.start;
        let [x, y] = self.roller;
        let (roller, guide) = match self.guide {
            Guide::Along([dx, dy]) => ([x + moved * dx, y + moved * dy], self.guide.again()),
            Guide::About([px, py], sense) => {
                let (sin, cos) = (sense * moved).sin_cos();
                let (ax, ay) = (x - px, y - py);
                let turned = [px + cos * ax - sin * ay, py + sin * ax + cos * ay];
                (turned, self.guide.again())
            }
        };
        let contact = Contact {
            center: self.center,
            roller,
            guide,
            sense: self.sense,
            slopes: [first, second],
        };
        let pressed = contact.pressed(&mut Numbers);
        CamNumbers {
            pressure: pressed.sine.abs().atan2(pressed.cosine.abs()),
            curvature: pressed.curvature,
        }
    }
}

impl Guide<f64> {
    fn again(&self) -> Self {
        match *self {
            Self::Along(direction) => Self::Along(direction),
            Self::About(pivot, sense) => Self::About(pivot, sense),
        }
    }
}

/// Where axes are at the start.
struct AtStart<'a> {
    model: &'a Model,
    program: &'a Program,
    start: &'a Position<f64>,
}

impl AtStart<'_> {
    fn pose(&self, link: LinkId) -> Option<[f64; 4]> {
        if link == LinkId::GROUND {
            return Some([1.0, 0.0, 0.0, 0.0]);
        }
        self.start.poses.get(self.program.place_of(link)?).copied()
    }

    fn place(&self, axis: AxisId) -> Option<[f64; 2]> {
        let axis = self.model.axis(axis);
        let [cos, sin, x, y] = self.pose(axis.link)?;
        let turned = Numbers.rotate([cos, sin], axis.at);
        Some(Numbers.plus([x, y], turned))
    }

    fn direction(&self, axis: AxisId) -> Option<[f64; 2]> {
        let axis = self.model.axis(axis);
        let [cos, sin, ..] = self.pose(axis.link)?;
        Some(Numbers.rotate([cos, sin], axis.direction))
    }

    /// The coordinate of a joint, an angle between −π and π.
    fn coordinate(&self, joint: JointId) -> Option<f64> {
        let [from, to] = self.model.joint(joint).kind.axes()?;
        let along = self.direction(from)?;
        if let JointKind::Revolute(..) = self.model.joint(joint).kind {
            let to = self.direction(to)?;
            return Some(Numbers.cross(along, to).atan2(Numbers.dot(along, to)));
        }
        let between = Numbers.minus(self.place(to)?, self.place(from)?);
        Some(Numbers.dot(between, along))
    }
}

/// A law and its derivatives by its variable.
#[derive(Clone, Debug)]
pub(super) struct LawProgram {
    ssa: Ssa,
    /// The number of motors, after which params are given.
    motors: usize,
    values: [Value; 3],
}

impl LawProgram {
    /// The program of a law of this mechanism.
    pub(super) fn new(model: &Model, law: &Law) -> Self {
        let mut ssa = SsaBuilder::new(timing::at_rest(model), Precision::F64);
        ssa.block("law".to_owned(), "A law, and its slopes.".to_owned());
        let variable = ssa.make(Op::Time);
        ssa.params(model);
        let value = ssa.law(law, variable);
        let mut tangents = Tangents::new(Seed::Given, model.motors.len());
        let first = tangents.of_all_up_to(&mut ssa, value);
        let second = tangents.of_all_up_to(&mut ssa, first);
        Self { ssa: ssa.ssa, motors: model.motors.len(), values: [value, first, second] }
    }

    /// Its value and both derivatives, with these params: not finite where it has none.
    pub(super) fn at(&self, variable: f64, params: &[f64]) -> [f64; 3] {
        let mut values: Vec<f64> = Vec::with_capacity(self.ssa.nodes.len());
        for node in &self.ssa.nodes {
            let value = match node.op {
                Op::Time => variable,
                Op::Input(input) => self.param(input, params),
                // Rates of params are zero: they rest.
                op => op.apply(|value: Value| values[value.index()]).unwrap_or(0.0),
            };
            values.push(value);
        }
        self.values.map(|value| values[value.index()])
    }

    fn param(&self, input: InputId, params: &[f64]) -> f64 {
        let number = input.index().checked_sub(self.motors);
        let param = number.and_then(|number| params.get(number));
        param.copied().unwrap_or(f64::NAN)
    }
}
