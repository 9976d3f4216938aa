//! An independent judge of where a mechanism goes: the poses of all links are unknowns, every joint is an equation straight from
//! its definition, and the move is followed by Newton's method with secant prediction. It shares nothing with the compiler but the
//! model.

use mech_compiler::model::{JointId, JointKind, LawId, Model};
use mech_compiler::program::Position;
use mech_compiler::structure::Rolling;
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
    /// The mechanism cannot go on from this part of the move.
    Stops(f64),
    /// Too many steps would be needed.
    GivesUp,
}

/// Where rolling and cams are counted from.
#[derive(Clone, Debug)]
pub(crate) struct Anchor {
    pub(crate) links: Vec<Placed>,
    /// What is added to the raw coordinate of each motor's joint.
    pub(crate) motors: Vec<f64>,
    /// What is added to the raw coordinate of the shaft of each cam.
    pub(crate) shafts: Vec<f64>,
}

/// One cam.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cam {
    pub(crate) shaft: JointId,
    pub(crate) follower: JointId,
    pub(crate) law: LawId,
}

/// The judge, at a position.
#[derive(Clone, Debug)]
pub(crate) struct Judge<'m> {
    pub(crate) model: &'m Model,
    pub(crate) rollings: Vec<Rolling>,
    pub(crate) cams: Vec<Cam>,
    pub(crate) anchor: Anchor,
    /// Where all links are, the ground first.
    links: Vec<Placed>,
    motors: Vec<f64>,
    /// The size of the mechanism.
    pub(crate) size: f64,
}

/// No more steps than this on one move.
const MOST_STEPS: u32 = 40_000;
/// A step turns no link by more than this, and moves none by more than this part of the size.
const TURN: f64 = 0.05;
/// Shorter steps than this part of the move, or of a unit, are not tried.
const SHORTEST: f64 = 1e-11;

/// An angle less whole turns.
pub(crate) fn wrap(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
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
            // One slide through the origin has no size.
            size: Some(mech_tests::size(model))
                .filter(|size| *size > 1e-9)
                .unwrap_or(1.0),
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
            let off = follower - law.at(raw + TAU * f64::from(turns), &[]);
            if self.is_angle(cam.follower) {
                wrap(off)
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

    /// Newton's method from a guess: where it ends, and how far that is from the guess.
    fn correct(&self, guess: &[Placed], motors: &[f64]) -> Option<(Vec<Placed>, f64)> {
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
            let distance = (a[0] - b[0]).hypot(a[1] - b[1]) / extent;
            distance.max((a[2] - b[2]).abs())
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
        let probe = |seed: f64| {
            let mut part = seed;
            let side = DVector::from_fn(unknowns, |_, _| {
                part = (part + 0.618_033_988_7).fract();
                part - 0.5
            });
            lu.solve(&side)
                .map_or(0.0, |answer| side.norm() / answer.norm())
        };
        probe(0.1).min(probe(0.57))
    }

    /// Follows the straight move to these motor values. `fineness` divides its steps.
    pub(crate) fn follow(&mut self, to: &[f64], fineness: f64) -> Verdict {
        let from = self.motors.clone();
        let distance = from
            .iter()
            .zip(to)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        if distance == 0.0 {
            return Verdict::Arrives;
        }
        let (mut part, mut last): (f64, Option<(f64, Vec<Placed>)>) = (0.0, None);
        let shortest = (SHORTEST / distance).max(4.0 * f64::EPSILON);
        // No round number, lest a step end exactly on a change point.
        let mut step = (1e-3 / distance).min(0.01) * 0.913_7;
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
            let found = self.correct(&guess, &motors).filter(|(links, off)| {
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
                    gone / ((next - last.as_ref().map_or(0.0, |(before, _)| *before)) * distance);
                let room = self.room() / (self.size.max(1.0) * (1.0 + speed) * fineness);
                step = step.min((0.5 * room).max(1e-6) / distance);
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
