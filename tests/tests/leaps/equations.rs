//! The equations of the judge: every joint straight from its definition.

use super::judge::{Cam, Judge, Placed, wrap};
use mech_compiler::model::{AxisId, JointId, JointKind, LinkId};
use mech_compiler::structure::{Factor, Rolling, RollingEnd};

fn rotate([.., angle]: Placed, [a, b]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos * a - sin * b, sin * a + cos * b]
}

fn number(factor: Factor) -> f64 {
    match factor {
        #[expect(clippy::cast_precision_loss, reason = "numbers of teeth are small")]
        Factor::Whole(teeth) => teeth as f64,
        Factor::Float(radius) => radius,
    }
}

/// The equations at a place: their residuals and their derivatives by all unknowns.
pub(crate) struct Equations {
    pub(crate) residuals: Vec<f64>,
    /// Row, column, derivative.
    pub(crate) entries: Vec<(usize, usize, f64)>,
}

impl Equations {
    /// A new equation.
    fn row(&mut self, residual: f64) -> usize {
        self.residuals.push(residual);
        self.residuals.len() - 1
    }

    /// Adds a derivative by a coordinate of a link; the ground has none.
    fn add(&mut self, row: usize, link: LinkId, part: usize, slope: f64) {
        if link != LinkId::GROUND {
            self.entries.push((row, 3 * link.index() - 3 + part, slope));
        }
    }
}

/// The coordinate of a joint and its derivatives by the coordinates of the two links it joins.
pub(crate) struct Coordinate {
    pub(crate) value: f64,
    pub(crate) slopes: [(LinkId, [f64; 3]); 2],
}

impl Judge<'_> {
    pub(crate) fn is_angle(&self, joint: JointId) -> bool {
        matches!(self.model.joint(joint).kind, JointKind::Revolute(..))
    }

    /// Where an axis is and where it points.
    fn axis(&self, links: &[Placed], id: AxisId) -> (LinkId, [f64; 2], [f64; 2]) {
        let axis = self.model.axis(id);
        let at = links[axis.link.index()];
        (axis.link, rotate(at, axis.at), rotate(at, axis.direction))
    }

    /// The raw coordinate of a joint: an angle is that between the unwrapped angles of its links.
    pub(crate) fn coordinate(&self, links: &[Placed], joint: JointId) -> Coordinate {
        match self.model.joint(joint).kind {
            JointKind::Revolute(a, b) => {
                let angle = |id: AxisId| {
                    let axis = self.model.axis(id);
                    let own = axis.direction[1].atan2(axis.direction[0]);
                    (axis.link, links[axis.link.index()][2] + own)
                };
                let ((a, from), (b, to)) = (angle(a), angle(b));
                Coordinate {
                    value: to - from,
                    slopes: [(a, [0.0, 0.0, -1.0]), (b, [0.0, 0.0, 1.0])],
                }
            }
            JointKind::Prismatic(a, b) => {
                let (a, from, along) = self.axis(links, a);
                let (b, to, _) = self.axis(links, b);
                let [p, q] = [a, b].map(|link| links[link.index()]);
                let [x, y] = [p[0] + from[0], p[1] + from[1]];
                let [u, v] = [q[0] + to[0], q[1] + to[1]];
                let apart = [u - x, v - y];
                let [c, s] = along;
                Coordinate {
                    value: c * apart[0] + s * apart[1],
                    slopes: [
                        (
                            a,
                            [
                                -c,
                                -s,
                                c * from[1] - s * from[0] - s * apart[0] + c * apart[1],
                            ],
                        ),
                        (b, [c, s, s * to[0] - c * to[1]]),
                    ],
                }
            }
            _ => Coordinate {
                value: 0.0,
                slopes: [(LinkId::GROUND, [0.0; 3]); 2],
            },
        }
    }

    /// All equations at these places, with the motors at these values.
    pub(crate) fn equations(&self, links: &[Placed], motors: &[f64]) -> Equations {
        let mut all = Equations {
            residuals: Vec::new(),
            entries: Vec::new(),
        };
        for joint in &self.model.joints {
            match joint.kind {
                JointKind::Revolute(a, b) => self.coincide(&mut all, links, [a, b]),
                JointKind::Weld(a, b) => {
                    self.coincide(&mut all, links, [a, b]);
                    self.parallel(&mut all, links, [a, b]);
                }
                JointKind::Prismatic(a, b) => {
                    self.on_line(&mut all, links, [a, b]);
                    self.parallel(&mut all, links, [a, b]);
                }
                _ => {}
            }
        }
        for rolling in &self.rollings {
            self.rolls(&mut all, links, rolling);
        }
        for (cam, turns) in self.cams.iter().zip(&self.anchor.shafts) {
            self.follows(&mut all, links, cam, *turns);
        }
        for (number, motor) in self.model.motors.iter().enumerate() {
            let at = self.coordinate(links, motor.joint);
            let row = all.row(at.value + self.anchor.motors[number] - motors[number]);
            for (link, slopes) in at.slopes {
                (0..3).for_each(|part| all.add(row, link, part, slopes[part]));
            }
        }
        all
    }

    /// Two points are in the same place.
    fn coincide(&self, all: &mut Equations, links: &[Placed], ends: [AxisId; 2]) {
        let [(a, from, _), (b, to, _)] = ends.map(|end| self.axis(links, end));
        let (p, q) = (links[a.index()], links[b.index()]);
        for part in 0..2 {
            let row = all.row(q[part] + to[part] - p[part] - from[part]);
            let slope = |at: [f64; 2]| if part == 0 { -at[1] } else { at[0] };
            all.add(row, a, part, -1.0);
            all.add(row, a, 2, -slope(from));
            all.add(row, b, part, 1.0);
            all.add(row, b, 2, slope(to));
        }
    }

    /// Two directions are the same.
    fn parallel(&self, all: &mut Equations, links: &[Placed], ends: [AxisId; 2]) {
        let [(a, _, d), (b, _, e)] = ends.map(|end| self.axis(links, end));
        let row = all.row(self.size * (d[0] * e[1] - d[1] * e[0]));
        let slope = self.size * (d[0] * e[0] + d[1] * e[1]);
        all.add(row, a, 2, -slope);
        all.add(row, b, 2, slope);
    }

    /// The origin of the second line is on the first.
    fn on_line(&self, all: &mut Equations, links: &[Placed], ends: [AxisId; 2]) {
        let [(a, from, [c, s]), (b, to, _)] = ends.map(|end| self.axis(links, end));
        let (p, q) = (links[a.index()], links[b.index()]);
        let apart = [q[0] + to[0] - p[0] - from[0], q[1] + to[1] - p[1] - from[1]];
        let row = all.row(c * apart[1] - s * apart[0]);
        let own = -(c * from[0] + s * from[1]);
        [s, -c, own - c * apart[0] - s * apart[1]]
            .into_iter()
            .enumerate()
            .for_each(|(part, slope)| all.add(row, a, part, slope));
        [-s, c, c * to[0] + s * to[1]]
            .into_iter()
            .enumerate()
            .for_each(|(part, slope)| all.add(row, b, part, slope));
    }

    /// What rolls has gone equally far on both.
    fn rolls(&self, all: &mut Equations, links: &[Placed], rolling: &Rolling) {
        let factors = rolling.ends.map(|(_, factor)| number(factor));
        let largest = factors[0].abs().max(factors[1].abs());
        let row = all.row(0.0);
        for ((end, _), factor) in rolling.ends.into_iter().zip(factors) {
            let factor = factor / largest;
            let moved = match end {
                RollingEnd::Wheel(wheel) => {
                    let carrier = rolling.carrier;
                    all.add(row, wheel, 2, factor);
                    all.add(row, carrier, 2, -factor);
                    let angle = |all: &[Placed]| all[wheel.index()][2] - all[carrier.index()][2];
                    angle(links) - angle(&self.anchor.links)
                }
                RollingEnd::Bar {
                    slide, forwards, ..
                } => {
                    let sign = if forwards { 1.0 } else { -1.0 };
                    let at = self.coordinate(links, slide);
                    for (link, slopes) in at.slopes {
                        (0..3).for_each(|part| {
                            all.add(row, link, part, sign * factor * slopes[part]);
                        });
                    }
                    sign * (at.value - self.coordinate(&self.anchor.links, slide).value)
                }
            };
            all.residuals[row] += factor * moved;
        }
    }

    /// A follower is where its cam has it.
    fn follows(&self, all: &mut Equations, links: &[Placed], cam: &Cam, turns: f64) {
        let law = self.model.law(cam.law);
        let (shaft, follower) = (
            self.coordinate(links, cam.shaft),
            self.coordinate(links, cam.follower),
        );
        let at = shaft.value + turns;
        let off = follower.value - law.at(at, &[]);
        let off = if self.is_angle(cam.follower) {
            wrap(off)
        } else {
            off
        };
        let step = 1e-6;
        let slope = (law.at(at + step, &[]) - law.at(at - step, &[])) / (2.0 * step);
        let row = all.row(off);
        for (joint, by) in [(shaft, -slope), (follower, 1.0)] {
            for (link, slopes) in joint.slopes {
                (0..3).for_each(|part| all.add(row, link, part, by * slopes[part]));
            }
        }
    }
}
