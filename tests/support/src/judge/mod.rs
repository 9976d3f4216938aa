//! An independent judge of where a mechanism goes. The places of all links are unknowns, every joint is equations straight from its
//! definition, and the curve of solutions is followed by its arc length. So turning points of the motors are seen for what they are,
//! and where curves cross, the smooth one goes on. It shares nothing with the compiler but the model and who carries what rolls.

mod curve;
mod equations;
mod fall;

pub use curve::{Curve, End};
pub use equations::wrap;
pub use fall::Fall;

use mech_compiler::model::{JointId, JointKind, LawId, LinkId, Model};
use mech_compiler::structure::Rolling;
use nalgebra::DVector;
use std::f64::consts::TAU;

/// One cam.
#[derive(Clone, Copy, Debug)]
struct Cam {
    shaft: JointId,
    follower: JointId,
    law: LawId,
}

/// The equations of a mechanism that stood at a known position.
#[derive(Clone, Debug)]
pub struct Judge<'m> {
    model: &'m Model,
    rollings: Vec<Rolling>,
    cams: Vec<Cam>,
    /// The middle of each link's axes, in its frame: links that lie far from the origin of their frame do not seem to run.
    centers: Vec<[f64; 2]>,
    /// The unit of length: a typical link.
    unit: f64,
    /// Where rolling is counted from: the first place.
    anchor: DVector<f64>,
    /// What is added to the coordinate of each motor's joint.
    offsets: Vec<f64>,
    turns_of_shafts: Vec<f64>,
}

/// Where all links are, angles unwrapped.
#[derive(Clone, Debug)]
pub struct Place(DVector<f64>);

impl<'m> Judge<'m> {
    /// The judge of a mechanism that is at these poses (cosine, sine, x and y of every link, the ground first) and values of motors.
    #[must_use]
    pub fn new(model: &'m Model, rollings: &[Rolling], poses: &[[f64; 4]], motors: &[f64]) -> Self {
        let cams = model.joints.iter().filter_map(|joint| match joint.kind {
            JointKind::Cam { shaft, follower, law } => Some(Cam { shaft, follower, law }),
            _ => None,
        });
        let (centers, unit) = centers(model);
        let mut judge = Self {
            model,
            rollings: rollings.to_vec(),
            cams: cams.collect(),
            centers,
            unit,
            anchor: DVector::zeros(3 * model.links.len() - 2),
            offsets: Vec::new(),
            turns_of_shafts: Vec::new(),
        };
        for (number, [cos, sin, x, y]) in poses.iter().enumerate().skip(1) {
            let [a, b] = judge.centers[number];
            let first = 3 * number - 3;
            judge.anchor[first] = (x + cos * a - sin * b) / unit;
            judge.anchor[first + 1] = (y + sin * a + cos * b) / unit;
            judge.anchor[first + 2] = sin.atan2(*cos);
        }
        let raw = |joint| judge.coordinate(&judge.anchor, joint).value;
        let all = model.motors.iter().zip(judge.scaled(motors));
        let offsets: Vec<f64> = all.map(|(motor, value)| value - raw(motor.joint)).collect();
        let turns = judge.cams.iter().map(|cam| judge.turns_of_shaft(cam, &offsets));
        judge.turns_of_shafts = turns.collect();
        judge.offsets = offsets;
        judge
    }

    /// The place where it began.
    #[must_use]
    pub fn start(&self) -> Place {
        Place(self.anchor.clone())
    }

    /// By how many whole turns the coordinate of a shaft is more than its poses tell: those with which the law has the follower
    /// nearest to where it is.
    fn turns_of_shaft(&self, cam: &Cam, offsets: &[f64]) -> f64 {
        let unit = |joint| if self.is_angle(joint) { 1.0 } else { self.unit };
        let raw = self.coordinate(&self.anchor, cam.shaft).value * unit(cam.shaft);
        if let Some(motor) = self.model.motor_of(cam.shaft) {
            return offsets[motor.index()] * unit(cam.shaft);
        }
        if !self.is_angle(cam.shaft) {
            return 0.0;
        }
        let follower = self.coordinate(&self.anchor, cam.follower).value * unit(cam.follower);
        let law = self.model.law(cam.law);
        let off = |turns: i32| {
            let off = follower - law.at(raw + TAU * f64::from(turns), &[]);
            if self.is_angle(cam.follower) { wrap(off) } else { off }.abs()
        };
        let nearest = (0..200).flat_map(|turns| [turns, -turns]).min_by(|a, b| {
            let (a, b) = (off(*a), off(*b));
            // All are equally good for a law that returns every turn.
            if (a - b).abs() < 1e-9 { std::cmp::Ordering::Equal } else { a.total_cmp(&b) }
        });
        TAU * f64::from(nearest.unwrap_or(0))
    }

    fn is_angle(&self, joint: JointId) -> bool {
        matches!(self.model.joint(joint).kind, JointKind::Revolute(..))
    }

    /// Values of motors with lengths in units.
    fn scaled(&self, motors: &[f64]) -> Vec<f64> {
        let all = self.model.motors.iter().zip(motors);
        all.map(
            |(motor, value)| {
                if self.is_angle(motor.joint) { *value } else { value / self.unit }
            },
        )
        .collect()
    }

    /// How far the joints are from closed at a place, as a part of a typical link.
    #[must_use]
    pub fn gap(&self, place: &Place, motors: &[f64]) -> f64 {
        let none = vec![0.0; motors.len()];
        self.equations(&place.0, [&self.scaled(motors), &none]).residuals.amax()
    }

    /// Cosine, sine, x and y of all links, the ground first.
    #[must_use]
    pub fn poses(&self, place: &Place) -> Vec<[f64; 4]> {
        let pose = |link: LinkId| {
            let [x, y, angle] = Self::place(&place.0, link);
            let ([a, b], (sin, cos)) = (self.centers[link.index()], angle.sin_cos());
            if link == LinkId::GROUND {
                return [1.0, 0.0, 0.0, 0.0];
            }
            [cos, sin, x * self.unit - cos * a + sin * b, y * self.unit - sin * a - cos * b]
        };
        (0..self.model.links.len()).map(|link| pose(LinkId::new(link))).collect()
    }
}

impl Place {
    /// The unwrapped angle of a link that is not the ground.
    #[must_use]
    pub fn angle(&self, link: LinkId) -> f64 {
        self.0[3 * link.index() - 1]
    }
}

/// The middle of each link's axes, and the length of a typical link.
fn centers(model: &Model) -> (Vec<[f64; 2]>, f64) {
    let (mut middles, mut spreads) = (Vec::new(), Vec::new());
    for link in model.link_ids() {
        let places: Vec<[f64; 2]> =
            model.axes.iter().filter(|axis| axis.link == link).map(|axis| axis.at).collect();
        let ends = |part: usize| {
            let all = || places.iter().map(|place| place[part]);
            (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max))
        };
        let ((left, right), (low, high)) = (ends(0), ends(1));
        if places.is_empty() {
            middles.push([0.0; 2]);
            continue;
        }
        middles.push([f64::midpoint(left, right), f64::midpoint(low, high)]);
        spreads.push((right - left).hypot(high - low));
    }
    spreads.retain(|spread| *spread > 1e-9);
    spreads.sort_by(f64::total_cmp);
    (middles, spreads.get(spreads.len() / 2).copied().unwrap_or(1.0))
}
