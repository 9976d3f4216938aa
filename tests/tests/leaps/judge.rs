//! An independent judge of where a mechanism goes: the poses of all links are unknowns, every joint is an equation straight from
//! its definition, and the way is followed by Newton's method with secant prediction. It shares nothing with the compiler but the
//! model.

use mech_compiler::model::{AxisId, JointId, JointKind, LawId, LinkId, Model};
use mech_compiler::program::Position;
use mech_compiler::structure::{Factor, Rolling, RollingEnd};
use mech_tests::with_ground;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// The place and the unwrapped angle of a link.
pub(crate) type Placed = [f64; 3];

/// Why the judge did not come to the target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// It came there.
    Arrives,
    /// The mechanism cannot go on from this part of the way.
    Stops(f64),
    /// Too many steps would be needed.
    GivesUp,
}

/// Where rolling and cams are counted from.
#[derive(Clone, Debug)]
struct Anchor {
    links: Vec<Placed>,
    /// What is added to the raw coordinate of each motor's joint.
    motors: Vec<f64>,
    /// What is added to the raw coordinate of the shaft of each cam.
    shafts: Vec<f64>,
}

/// One cam.
#[derive(Clone, Copy, Debug)]
struct Cam {
    shaft: JointId,
    follower: JointId,
    law: LawId,
}

/// The judge, at a position.
#[derive(Clone, Debug)]
pub(crate) struct Judge<'m> {
    model: &'m Model,
    rollings: Vec<Rolling>,
    cams: Vec<Cam>,
    anchor: Anchor,
    /// Where all links are, the ground first.
    links: Vec<Placed>,
    motors: Vec<f64>,
    /// The size of the mechanism.
    size: f64,
}

/// No more steps than this on one way.
const MOST_STEPS: u32 = 40_000;
/// A step turns no link by more than this, and moves none by more than this part of the size.
const TURN: f64 = 0.05;
/// Shorter steps than this part of the way, or of a unit, are not tried.
const SHORTEST: f64 = 1e-11;

fn turned([.., angle]: Placed, [a, b]: [f64; 2]) -> [f64; 2] {
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

/// An angle less whole turns.
pub(crate) fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// The equations at a place: their residuals and their derivatives by all unknowns.
struct Equations {
    residuals: Vec<f64>,
    /// Row, column, derivative.
    entries: Vec<(usize, usize, f64)>,
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
struct Coordinate {
    value: f64,
    slopes: [(LinkId, [f64; 3]); 2],
}

impl<'m> Judge<'m> {
    /// The judge where a mechanism is; rolling is counted from here.
    pub(crate) fn new(model: &'m Model, rollings: &[Rolling], at: &Position<f64>) -> Self {
        let poses = with_ground(model, &at.poses);
        let place = |pose: &[f64; 4]| [pose[2], pose[3], pose[1].atan2(pose[0])];
        let links: Vec<Placed> = poses.iter().map(place).collect();
        let cams = model.joints.iter().filter_map(|joint| match joint.kind {
            JointKind::Cam {
                shaft,
                follower,
                law,
            } => Some(Cam {
                shaft,
                follower,
                law,
            }),
            _ => None,
        });
        let mut judge = Self {
            model,
            rollings: rollings.to_vec(),
            cams: cams.collect(),
            anchor: Anchor {
                links: links.clone(),
                motors: Vec::new(),
                shafts: Vec::new(),
            },
            motors: at.motors[..model.motors.len()].to_vec(),
            size: mech_tests::size(model).max(1e-9),
            links,
        };
        let raw = |joint| judge.coordinate(&judge.links, joint).value;
        let motors = model.motors.iter().zip(&judge.motors);
        let motors: Vec<f64> = motors
            .map(|(motor, value)| value - raw(motor.joint))
            .collect();
        let shafts = judge
            .cams
            .iter()
            .map(|cam| judge.turns_of_shaft(cam, &motors));
        let shafts = shafts.collect();
        judge.anchor.motors = motors;
        judge.anchor.shafts = shafts;
        judge
    }

    /// By how many whole turns the coordinate of a shaft is more than its poses tell: those with which the law has the follower
    /// nearest to where it is.
    fn turns_of_shaft(&self, cam: &Cam, motors: &[f64]) -> f64 {
        let raw = self.coordinate(&self.links, cam.shaft).value;
        if let Some(motor) = self.model.motor_of(cam.shaft) {
            return motors[motor.index()];
        }
        if !self.is_angle(cam.shaft) {
            return 0.0;
        }
        let follower = self.coordinate(&self.links, cam.follower).value;
        let law = self.model.law(cam.law);
        let off = |turns: i32| {
            let off = follower - law.at(raw + TAU * f64::from(turns));
            if self.is_angle(cam.follower) {
                wrapped(off)
            } else {
                off
            }
            .abs()
        };
        let nearest = (0..200).flat_map(|turns| [turns, -turns]).min_by(|a, b| {
            let (a, b) = (off(*a), off(*b));
            // All are equally good for a law that returns every turn.
            if (a - b).abs() < 1e-9 {
                std::cmp::Ordering::Equal
            } else {
                a.total_cmp(&b)
            }
        });
        TAU * f64::from(nearest.unwrap_or(0))
    }

    fn is_angle(&self, joint: JointId) -> bool {
        matches!(self.model.joint(joint).kind, JointKind::Revolute(..))
    }

    /// Where an axis is and where it points.
    fn axis(&self, links: &[Placed], id: AxisId) -> (LinkId, [f64; 2], [f64; 2]) {
        let axis = self.model.axis(id);
        let at = links[axis.link.index()];
        (axis.link, turned(at, axis.at), turned(at, axis.direction))
    }

    /// The raw coordinate of a joint: an angle is that between the unwrapped angles of its links.
    fn coordinate(&self, links: &[Placed], joint: JointId) -> Coordinate {
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
    fn equations(&self, links: &[Placed], motors: &[f64]) -> Equations {
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

    /// What rolls has gone the same way on both.
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
                            all.add(row, link, part, sign * factor * slopes[part])
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
        let off = follower.value - law.at(at);
        let off = if self.is_angle(cam.follower) {
            wrapped(off)
        } else {
            off
        };
        let step = 1e-6;
        let slope = (law.at(at + step) - law.at(at - step)) / (2.0 * step);
        let row = all.row(off);
        for (joint, by) in [(shaft, -slope), (follower, 1.0)] {
            for (link, slopes) in joint.slopes {
                (0..3).for_each(|part| all.add(row, link, part, by * slopes[part]));
            }
        }
    }

    /// Newton's method from a guess: where it ends, and how far that is from the guess.
    fn corrected(&self, guess: &[Placed], motors: &[f64]) -> Option<(Vec<Placed>, f64)> {
        let mut links = guess.to_vec();
        let unknowns = 3 * (links.len() - 1);
        for round in 0..8 {
            let all = self.equations(&links, motors);
            let mut matrix = DMatrix::zeros(all.residuals.len(), unknowns);
            for (row, column, slope) in all.entries {
                matrix[(row, column)] += slope;
            }
            let right = DVector::from_vec(all.residuals);
            let change = if matrix.nrows() == unknowns {
                matrix.lu().solve(&right)?
            } else {
                matrix.svd(true, true).solve(&right, 1e-9).ok()?
            };
            if change.iter().any(|part| !part.is_finite()) {
                return None;
            }
            for (place, part) in change.iter().enumerate() {
                links[1 + place / 3][place % 3] -= part;
            }
            let most = change.amax();
            if most < 1e-12 * (1.0 + self.extent(&links)) && round > 0 {
                let off = self.apart(guess, &links);
                return Some((links, off));
            }
        }
        // At a badly conditioned place rounding keeps the corrections from vanishing: what counts is whether it closes.
        let all = self.equations(&links, motors);
        let open = all
            .residuals
            .iter()
            .fold(0.0_f64, |most, one| most.max(one.abs()));
        (open < 1e-11 * (self.size + self.extent(&links))).then(|| {
            let off = self.apart(guess, &links);
            (links, off)
        })
    }

    fn extent(&self, links: &[Placed]) -> f64 {
        let far = links.iter().map(|[x, y, _]| x.abs().max(y.abs()));
        far.fold(self.size, f64::max)
    }

    /// How far two places of all links are apart: in radians, or in sizes.
    fn apart(&self, a: &[Placed], b: &[Placed]) -> f64 {
        let extent = self.extent(b);
        let apart = a.iter().zip(b).map(|(a, b)| {
            let way = (a[0] - b[0]).hypot(a[1] - b[1]) / extent;
            way.max((a[2] - b[2]).abs())
        });
        apart.fold(0.0, f64::max)
    }

    /// How near the equations are to being singular: the inverse of how far the links go for a unit change of the equations.
    fn room(&self) -> f64 {
        let all = self.equations(&self.links, &self.motors);
        let unknowns = 3 * (self.links.len() - 1);
        let mut matrix = DMatrix::zeros(all.residuals.len(), unknowns);
        for (row, column, slope) in all.entries {
            matrix[(row, column)] += slope;
        }
        if matrix.nrows() != unknowns {
            // What is redundant is singular by its shape: its other singular values tell.
            let values = matrix.singular_values();
            return values.iter().copied().fold(f64::INFINITY, f64::min);
        }
        let lu = matrix.lu();
        let probe = |seed: usize| {
            let part =
                |row: usize, _| ((row * 7 + seed * 3 + 1) as f64 * 1.618_033_988_7).fract() - 0.5;
            let side = DVector::from_fn(unknowns, |row, _| part(row, 0));
            lu.solve(&side)
                .map_or(0.0, |answer| side.norm() / answer.norm())
        };
        probe(0).min(probe(1))
    }

    /// Follows the straight way to these motor values. `fineness` divides its steps.
    pub(crate) fn follow(&mut self, to: &[f64], fineness: f64) -> Verdict {
        let from = self.motors.clone();
        let way = from
            .iter()
            .zip(to)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        if way == 0.0 {
            return Verdict::Arrives;
        }
        let (mut part, mut last): (f64, Option<(f64, Vec<Placed>)>) = (0.0, None);
        let shortest = (SHORTEST / way).max(4.0 * f64::EPSILON);
        // No round number, lest a step end exactly on a change point.
        let mut step = (1e-3 / way).min(0.01) * 0.913_7;
        for _ in 0..MOST_STEPS {
            if part >= 1.0 {
                self.motors = to.to_vec();
                return Verdict::Arrives;
            }
            let next = (part + step).min(1.0);
            let motors: Vec<f64> = from
                .iter()
                .zip(to)
                .map(|(a, b)| a + (b - a) * next)
                .collect();
            let ahead = last
                .as_ref()
                .map_or(0.0, |(before, _)| (next - part) / (part - before));
            let guess: Vec<Placed> = match &last {
                None => self.links.clone(),
                Some((_, before)) => {
                    let on = |(now, before): (&Placed, &Placed)| {
                        [0, 1, 2].map(|axis| now[axis] + ahead * (now[axis] - before[axis]))
                    };
                    self.links.iter().zip(before).map(on).collect()
                }
            };
            let found = self.corrected(&guess, &motors).filter(|(links, off)| {
                let gone = self.apart(&self.links, links);
                // The first step has nothing to predict from.
                let well = *off <= 0.1 * gone + 1e-9 || last.is_none() && gone < 0.01;
                well && gone <= TURN / fineness
            });
            if let Some((links, off)) = found {
                let gone = self.apart(&self.links, &links);
                last = Some((part, std::mem::replace(&mut self.links, links)));
                self.motors = motors;
                part = next;
                if off < 0.03 * gone + 1e-10 {
                    step *= 1.4;
                }
                // Near where it is singular: short enough to tell a change point from two dead points side by side.
                let speed =
                    gone / ((next - last.as_ref().map_or(0.0, |(before, _)| *before)) * way);
                let room = self.room() / (self.size.max(1.0) * (1.0 + speed) * fineness);
                step = step.min((0.5 * room).max(1e-6) / way);
            } else {
                step *= 0.5;
                if step < shortest {
                    return Verdict::Stops(part);
                }
            }
        }
        Verdict::GivesUp
    }

    /// Cosine, sine, x and y of all links, the ground first.
    pub(crate) fn poses(&self) -> Vec<[f64; 4]> {
        let pose = |&[x, y, angle]: &Placed| [angle.cos(), angle.sin(), x, y];
        self.links.iter().map(pose).collect()
    }
}
