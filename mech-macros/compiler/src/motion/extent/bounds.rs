//! Where points of links can be at most, wherever the motors are: proved from lengths and declared ranges alone, without moving anything.
//!
//! A pin is where both its links can have it, and on a link two points keep their distance. What is found for one joint narrows the next,
//! round after round. A chain of arms reaches as far as all of them together; a loop only as far as its shortest way to the ground.

use crate::certify::Interval;
use crate::model::{Axis, AxisId, JointId, JointKind, LinkId, Model};
use std::f64::consts::TAU;

/// Rounds at most; more are needed only where links are declared far from what they hang on.
const ROUNDS: usize = 12;
/// Of a link with more joints only pairs with the first so many are looked at.
const PARTNERS: usize = 16;
/// Less than this part of the whole is no gain.
const GAIN: f64 = 1e-3;

/// An upright box: of x and of y.
type Region = [Interval; 2];

/// Bounds on the angles of links and on the places of their joints.
pub(super) struct Bounds<'m> {
    model: &'m Model,
    /// The range of each motor.
    ranges: &'m [Interval],
    /// The angle of each link.
    angles: Vec<Interval>,
    /// The place of each axis.
    places: Vec<Region>,
    /// For each link the axes of its joints.
    joints: Vec<Vec<AxisId>>,
}

impl<'m> Bounds<'m> {
    /// The bounds of a mechanism whose motors stay within these ranges.
    pub(super) fn new(model: &'m Model, ranges: &'m [Interval]) -> Self {
        let place = |axis: &Axis| {
            if axis.link == LinkId::GROUND {
                axis.at.map(Interval::point)
            } else {
                [Interval::ENTIRE; 2]
            }
        };
        let mut angles = vec![Interval::ENTIRE; model.links.len()];
        angles[LinkId::GROUND.index()] = Interval::ZERO;
        let mut bounds = Self {
            model,
            ranges,
            angles,
            places: model.axes.iter().map(place).collect(),
            joints: joints_of_links(model),
        };
        bounds.narrow();
        bounds
    }

    /// Where a point of a link can be, by its place in the link's frame.
    pub(super) fn of_point(&self, link: LinkId, at: [f64; 2]) -> Region {
        let partners = self.joints[link.index()].iter().take(PARTNERS);
        partners.fold([Interval::ENTIRE; 2], |region, &joint| {
            meet(region, self.beside(joint, link, at))
        })
    }

    /// Where a point of a link can be, seen from one of its joints.
    fn beside(&self, joint: AxisId, link: LinkId, at: [f64; 2]) -> Region {
        let from = self.model.axis(joint).at;
        let offset = self.turned(link, [at[0] - from[0], at[1] - from[1]]);
        add(self.places[joint.index()], offset)
    }

    /// A vector of a link in the scene.
    fn turned(&self, link: LinkId, [x, y]: [f64; 2]) -> Region {
        let own = self.angles[link.index()];
        if own == Interval::ZERO || (x, y) == (0.0, 0.0) {
            return [x, y].map(Interval::point);
        }
        let length = (Interval::point(x).square() + Interval::point(y).square()).sqrt();
        let angle = own + Interval::point(y.atan2(x));
        if angle.width() >= TAU {
            return [length * Interval::new(-1.0, 1.0); 2];
        }
        [length * angle.cos(), length * angle.sin()]
    }

    /// Narrows everything until nothing more is gained.
    fn narrow(&mut self) {
        let axes = |kind| match kind {
            JointKind::Revolute(a, b) | JointKind::Weld(a, b) | JointKind::Prismatic(a, b) => {
                Some([a, b])
            }
            _ => None,
        };
        let joints = self.model.joint_ids();
        let mut order: Vec<(JointId, [AxisId; 2])> =
            joints.filter_map(|id| Some((id, axes(self.model.joint(id).kind)?))).collect();
        for _ in 0..ROUNDS {
            let before = (self.angles.clone(), self.places.clone());
            for &(joint, ends) in &order {
                self.narrow_joint(joint);
                for axis in ends {
                    self.narrow_link(axis);
                }
            }
            let is_same = |(a, b): (&Interval, &Interval)| {
                // A bound that was infinite and is finite is a gain.
                let close = |a: f64, b: f64| a == b || (a - b).abs() <= GAIN * (1.0 + a.abs());
                close(a.low(), b.low()) && close(a.high(), b.high())
            };
            let places = self.places.as_flattened().iter();
            let places = places.zip(before.1.as_flattened());
            let mut all = self.angles.iter().zip(&before.0).chain(places);
            if all.all(is_same) {
                return;
            }
            // The joint that is declared last may be nearest to the ground.
            order.reverse();
        }
    }

    /// Narrows the bounds of a joint's two ends to each other.
    fn narrow_joint(&mut self, id: JointId) {
        let model = self.model;
        match model.joint(id).kind {
            JointKind::Revolute(a, b) => {
                if let Some(range) = self.range(id) {
                    self.narrow_angles([a, b], range);
                }
                self.share_place(a, b);
            }
            JointKind::Weld(a, b) => {
                self.narrow_angles([a, b], Interval::ZERO);
                self.share_place(a, b);
            }
            JointKind::Prismatic(a, b) => {
                self.narrow_angles([a, b], Interval::ZERO);
                self.narrow_slide([a, b], self.range(id).unwrap_or(Interval::ENTIRE));
            }
            JointKind::Gear { .. }
            | JointKind::Belt { .. }
            | JointKind::Rack { .. }
            | JointKind::Cam { .. } => {}
        }
    }

    /// Returns the range of the motor of a joint, if it has one.
    fn range(&self, joint: JointId) -> Option<Interval> {
        let mut motors = self.model.motors.iter().zip(self.ranges);
        motors.find(|(motor, _)| motor.joint == joint).map(|(_, range)| *range)
    }

    /// The second of two axes is turned by this against the first.
    fn narrow_angles(&mut self, ends: [AxisId; 2], turn: Interval) {
        let [a, b] = ends.map(|axis| self.model.axis(axis));
        let own = |axis: &Axis| Interval::point(axis.direction[1].atan2(axis.direction[0]));
        let between = turn + (own(a) - own(b));
        let (from, to) = (a.link.index(), b.link.index());
        self.angles[to] = meet_angles(self.angles[to], self.angles[from] + between);
        self.angles[from] = meet_angles(self.angles[from], self.angles[to] - between);
    }

    fn share_place(&mut self, a: AxisId, b: AxisId) {
        let both = meet(self.places[a.index()], self.places[b.index()]);
        self.put(a, both);
        self.put(b, both);
    }

    fn put(&mut self, axis: AxisId, place: Region) {
        // Places on the ground are known.
        if self.model.axis(axis).link != LinkId::GROUND {
            self.places[axis.index()] = place;
        }
    }

    /// The second axis has its origin on the line of the first, so far along.
    fn narrow_slide(&mut self, [a, b]: [AxisId; 2], range: Interval) {
        let guide = self.model.axis(a);
        let [cos, sin] = self.turned(guide.link, guide.direction);
        let [from, to] = [a, b].map(|axis| self.places[axis.index()]);
        let apart = add(to, from.map(|part| -part));
        let along = (apart[0] * cos + apart[1] * sin).meet(range);
        // Along a line whose direction is known each coordinate tells how far.
        let by = |apart: Interval, direction: Interval| apart / direction;
        let along = along.meet(by(apart[0], cos)).meet(by(apart[1], sin));
        let way = [along * cos, along * sin];
        self.put(b, meet(to, add(from, way)));
        self.put(a, meet(from, add(to, way.map(|part| -part))));
    }

    /// Narrows the places of a link's other joints by the place of one: their distances from it are constant.
    fn narrow_link(&mut self, from: AxisId) {
        let link = self.model.axis(from).link;
        let others = self.joints[link.index()].clone();
        let has_all = others.iter().take(PARTNERS).any(|&joint| joint == from);
        let count = if has_all { others.len() } else { PARTNERS };
        for &other in others.iter().take(count).filter(|&&other| other != from) {
            let seen = self.beside(from, link, self.model.axis(other).at);
            let place = meet(self.places[other.index()], seen);
            let distance = self.distance(from, other);
            self.put(other, on_circle(place, self.places[from.index()], distance));
        }
    }

    fn distance(&self, a: AxisId, b: AxisId) -> Interval {
        let [a, b] = [a, b].map(|axis| self.model.axis(axis).at.map(Interval::point));
        ((a[0] - b[0]).square() + (a[1] - b[1]).square()).sqrt()
    }
}

/// For each link the axes that its joints have, each place once; the ground's are known.
fn joints_of_links(model: &Model) -> Vec<Vec<AxisId>> {
    let mut joints: Vec<Vec<AxisId>> = vec![Vec::new(); model.links.len()];
    for joint in &model.joints {
        if let JointKind::Revolute(a, b) | JointKind::Weld(a, b) | JointKind::Prismatic(a, b) =
            joint.kind
        {
            for axis in [a, b] {
                joints[model.axis(axis).link.index()].push(axis);
            }
        }
    }
    for axes in &mut joints {
        axes.sort_unstable();
        axes.dedup();
    }
    joints
}

/// The places of a region that can be at such a distance from a place of another region.
fn on_circle(place: Region, center: Region, distance: Interval) -> Region {
    let [x, y] = add(place, center.map(|part| -part));
    let most = |other: Interval| {
        let left = (distance.square() - other.square()).high().max(0.0);
        let most = Interval::point(left).sqrt().high();
        Interval::new(-most, most)
    };
    meet(place, add(center, [most(y), most(x)]))
}

fn meet(a: Region, b: Region) -> Region {
    [a[0].meet(b[0]), a[1].meet(b[1])]
}

/// The angles that are in both ranges. Whole turns do not count: a range wider than a turn says nothing.
fn meet_angles(known: Interval, found: Interval) -> Interval {
    if found.width() < known.width() { found } else { known }
}

fn add(a: Region, b: Region) -> Region {
    [a[0] + b[0], a[1] + b[1]]
}
