//! Every joint as equations straight from its definition, with their derivatives by the places of all links.

use super::Judge;
use mech_compiler::model::{AxisId, JointId, JointKind, LinkId};
use mech_compiler::structure::{Factor, Rolling, RollingEnd};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Equations at a place: residuals and derivatives. The last column is of the way that the motors have gone.
pub(super) struct Equations {
    pub(super) residuals: DVector<f64>,
    pub(super) slopes: DMatrix<f64>,
    next: usize,
}

impl Equations {
    fn row(&mut self, residual: f64) -> usize {
        self.residuals[self.next] = residual;
        self.next += 1;
        self.next - 1
    }

    /// Adds derivatives by x, y and the angle of a link; the ground has none.
    fn add(&mut self, row: usize, link: LinkId, slopes: [f64; 3]) {
        if link != LinkId::GROUND {
            for (part, slope) in slopes.into_iter().enumerate() {
                self.slopes[(row, 3 * link.index() - 3 + part)] += slope;
            }
        }
    }
}

/// The coordinate of a joint and its derivatives by the places of the two links.
pub(super) struct Coordinate {
    pub(super) value: f64,
    slopes: [(LinkId, [f64; 3]); 2],
}

/// Where an axis is: its link, the arm from the link's centre to it, its place and its direction.
struct Axle {
    link: LinkId,
    arm: [f64; 2],
    at: [f64; 2],
    along: [f64; 2],
    angle: f64,
}

impl Judge<'_> {
    /// The place of a link: x and y of its centre in units, and its angle.
    pub(super) fn place(place: &DVector<f64>, link: LinkId) -> [f64; 3] {
        if link == LinkId::GROUND {
            return [0.0; 3];
        }
        let first = 3 * link.index() - 3;
        [place[first], place[first + 1], place[first + 2]]
    }

    fn axle(&self, place: &DVector<f64>, id: AxisId) -> Axle {
        let axis = self.model.axis(id);
        let [x, y, angle] = Self::place(place, axis.link);
        let center = self.centers[axis.link.index()];
        let (sin, cos) = angle.sin_cos();
        let turned = |[a, b]: [f64; 2]| [cos * a - sin * b, sin * a + cos * b];
        let arm = turned([0, 1].map(|part| (axis.at[part] - center[part]) / self.unit));
        let shift =
            if axis.link == LinkId::GROUND { center.map(|part| part / self.unit) } else { [x, y] };
        Axle {
            link: axis.link,
            arm,
            at: [shift[0] + arm[0], shift[1] + arm[1]],
            along: turned(axis.direction),
            angle: angle + axis.direction[1].atan2(axis.direction[0]),
        }
    }

    /// The coordinate of a joint: an unwrapped angle in radians, or a displacement in units.
    pub(super) fn coordinate(&self, place: &DVector<f64>, joint: JointId) -> Coordinate {
        match self.model.joint(joint).kind {
            JointKind::Revolute(a, b) => {
                let [a, b] = [a, b].map(|axis| self.axle(place, axis));
                Coordinate {
                    value: b.angle - a.angle,
                    slopes: [(a.link, [0.0, 0.0, -1.0]), (b.link, [0.0, 0.0, 1.0])],
                }
            }
            JointKind::Prismatic(a, b) => {
                let [a, b] = [a, b].map(|axis| self.axle(place, axis));
                let [c, s] = a.along;
                let [u, v] = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
                Coordinate {
                    value: c * u + s * v,
                    slopes: [
                        (a.link, [-c, -s, c * a.arm[1] - s * a.arm[0] - s * u + c * v]),
                        (b.link, [c, s, s * b.arm[0] - c * b.arm[1]]),
                    ],
                }
            }
            _ => panic!("this joint has no coordinate"),
        }
    }

    /// How many equations there are.
    pub(super) fn count(&self) -> usize {
        let of_joint = |kind: &JointKind| match kind {
            JointKind::Revolute(..) | JointKind::Prismatic(..) => 2,
            JointKind::Weld(..) => 3,
            _ => 1,
        };
        let joints: usize = self.model.joints.iter().map(|joint| of_joint(&joint.kind)).sum();
        joints + self.model.motors.len()
    }

    /// All equations at a place, the last number of which is the way; the motors are at `from` plus `way` times `direction`.
    pub(super) fn equations(
        &self,
        place: &DVector<f64>,
        [from, direction]: [&[f64]; 2],
    ) -> Equations {
        let count = self.count();
        let mut all = Equations {
            residuals: DVector::zeros(count),
            slopes: DMatrix::zeros(count, place.len()),
            next: 0,
        };
        for joint in &self.model.joints {
            match joint.kind {
                JointKind::Revolute(a, b) => self.coincide(&mut all, place, [a, b]),
                JointKind::Weld(a, b) => {
                    self.coincide(&mut all, place, [a, b]);
                    self.parallel(&mut all, place, [a, b]);
                }
                JointKind::Prismatic(a, b) => {
                    self.on_line(&mut all, place, [a, b]);
                    self.parallel(&mut all, place, [a, b]);
                }
                _ => {}
            }
        }
        for rolling in &self.rollings {
            self.rolls(&mut all, place, rolling);
        }
        for number in 0..self.cams.len() {
            self.follows(&mut all, place, number);
        }
        let way = place.len() - 1;
        for (number, motor) in self.model.motors.iter().enumerate() {
            let at = self.coordinate(place, motor.joint);
            let goal = from[number] + direction[number] * place[way];
            let row = all.row(at.value + self.offsets[number] - goal);
            all.slopes[(row, way)] = -direction[number];
            at.slopes.into_iter().for_each(|(link, slopes)| all.add(row, link, slopes));
        }
        all
    }

    /// Two points are in the same place.
    fn coincide(&self, all: &mut Equations, place: &DVector<f64>, ends: [AxisId; 2]) {
        let [a, b] = ends.map(|end| self.axle(place, end));
        let row = all.row(b.at[0] - a.at[0]);
        all.add(row, a.link, [-1.0, 0.0, a.arm[1]]);
        all.add(row, b.link, [1.0, 0.0, -b.arm[1]]);
        let row = all.row(b.at[1] - a.at[1]);
        all.add(row, a.link, [0.0, -1.0, -a.arm[0]]);
        all.add(row, b.link, [0.0, 1.0, b.arm[0]]);
    }

    /// Two directions are the same.
    fn parallel(&self, all: &mut Equations, place: &DVector<f64>, ends: [AxisId; 2]) {
        let [a, b] = ends.map(|end| self.axle(place, end));
        let row = all.row(a.along[0] * b.along[1] - a.along[1] * b.along[0]);
        let slope = a.along[0] * b.along[0] + a.along[1] * b.along[1];
        all.add(row, a.link, [0.0, 0.0, -slope]);
        all.add(row, b.link, [0.0, 0.0, slope]);
    }

    /// The origin of the second line is on the first.
    fn on_line(&self, all: &mut Equations, place: &DVector<f64>, ends: [AxisId; 2]) {
        let [a, b] = ends.map(|end| self.axle(place, end));
        let ([c, s], [u, v]) = (a.along, [b.at[0] - a.at[0], b.at[1] - a.at[1]]);
        let row = all.row(c * v - s * u);
        all.add(row, a.link, [s, -c, -(c * a.arm[0] + s * a.arm[1]) - c * u - s * v]);
        all.add(row, b.link, [-s, c, c * b.arm[0] + s * b.arm[1]]);
    }

    /// What rolls has gone equally far on both.
    fn rolls(&self, all: &mut Equations, place: &DVector<f64>, rolling: &Rolling) {
        // A radius is a length: the displacement of a bar is in units.
        let factors = rolling.ends.map(|(end, factor)| match (end, factor) {
            #[expect(clippy::cast_precision_loss, reason = "numbers of teeth are small")]
            (_, Factor::Whole(teeth)) => teeth as f64,
            (_, Factor::Float(radius)) => radius,
        });
        let bar = rolling.ends.iter().any(|(end, _)| matches!(end, RollingEnd::Bar { .. }));
        let factors = [0, 1].map(|number| {
            let wheel = matches!(rolling.ends[number].0, RollingEnd::Wheel(_));
            if bar && wheel { factors[number] / self.unit } else { factors[number] }
        });
        let largest = factors[0].abs().max(factors[1].abs());
        let row = all.row(0.0);
        for ((end, _), factor) in rolling.ends.into_iter().zip(factors) {
            let factor = factor / largest;
            let moved = match end {
                RollingEnd::Wheel(wheel) => {
                    all.add(row, wheel, [0.0, 0.0, factor]);
                    all.add(row, rolling.carrier, [0.0, 0.0, -factor]);
                    let angle =
                        |all| Self::place(all, wheel)[2] - Self::place(all, rolling.carrier)[2];
                    angle(place) - angle(&self.anchor)
                }
                RollingEnd::Bar { slide, forwards, .. } => {
                    let sign = if forwards { 1.0 } else { -1.0 };
                    let at = self.coordinate(place, slide);
                    for (link, slopes) in at.slopes {
                        all.add(row, link, slopes.map(|slope| sign * factor * slope));
                    }
                    sign * (at.value - self.coordinate(&self.anchor, slide).value)
                }
            };
            all.residuals[row] += factor * moved;
        }
    }

    /// A follower is where its cam has it.
    fn follows(&self, all: &mut Equations, place: &DVector<f64>, number: usize) {
        let cam = self.cams[number];
        let law = self.model.law(cam.law);
        let (shaft, follower) =
            (self.coordinate(place, cam.shaft), self.coordinate(place, cam.follower));
        let [input, output] = [cam.shaft, cam.follower]
            .map(|joint| if self.is_angle(joint) { 1.0 } else { self.unit });
        let at = shaft.value * input + self.turns_of_shafts[number];
        let off = follower.value - law.at(at, &[]) / output;
        let off = if self.is_angle(cam.follower) { wrap(off) } else { off };
        let step = 1e-6 * input;
        let slope =
            (law.at(at + step, &[]) - law.at(at - step, &[])) / (2.0 * step) * input / output;
        let row = all.row(off);
        for (joint, by) in [(shaft, -slope), (follower, 1.0)] {
            for (link, slopes) in joint.slopes {
                all.add(row, link, slopes.map(|one| by * one));
            }
        }
    }
}

/// An angle less whole turns.
#[must_use]
pub fn wrap(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
