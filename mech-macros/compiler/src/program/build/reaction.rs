//! The reactions in joints and the torques of motors as unknowns: in which directions each pushes, and where.

use super::Positions;
use super::lowering::Lowering;
use crate::model::{AxisId, JointId, JointKind, LinkId, MotorId};
use crate::plan::{Algebra, Arithmetic, Pose};
use crate::program::node::Value;
use crate::structure::{Factor, Rolling, RollingEnd, Structure};

/// The point of application of a force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Place {
    /// At an axis of the link that is pushed.
    Own(AxisId),
    /// At a point of the scene.
    Scene([Value; 2]),
}

/// The direction of a force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Along {
    /// Any, in the scene.
    Scene([Value; 2]),
    /// Along the line of a slide.
    Slide(JointId),
    /// Across the line of a slide.
    Across(JointId),
}

/// The force or torque of an unknown of size one on a link.
#[derive(Clone, Copy, Debug)]
pub(super) enum Push {
    /// A force of this size.
    Force { link: LinkId, at: Place, along: Along, size: Value },
    /// A torque of this size.
    Torque { link: LinkId, size: Value },
}

impl Push {
    /// The link on which it acts.
    pub(super) fn link(&self) -> LinkId {
        match *self {
            Self::Force { link, .. } | Self::Torque { link, .. } => link,
        }
    }
}

/// An unknown: a part of the reaction in a joint, or the torque of a motor.
#[derive(Clone, Debug)]
pub(super) struct Unknown {
    pub(super) joint: JointId,
    /// Its name.
    pub(super) name: String,
    /// Its forces and torques on all links.
    pub(super) pushes: Vec<Push>,
    /// The part of the joint's reaction that it is.
    pub(super) part: Part,
}

/// A part of a reaction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Part {
    /// A force in this direction.
    Force(Along),
    /// A torque.
    Torque,
}

impl Lowering<'_> {
    /// All unknowns of the reactions in all joints.
    pub(super) fn unknown_reactions(
        &mut self,
        positions: &Positions,
        structure: &Structure,
    ) -> Vec<Unknown> {
        let mut unknowns = Vec::new();
        for joint in self.model.joint_ids() {
            let motor = self.model.motor_of(joint);
            match self.model.joint(joint).kind {
                JointKind::Revolute(a, b) => {
                    unknowns.extend(self.pin_forces(joint, [a, b]));
                    if motor.is_some() {
                        unknowns.push(self.joint_torque(joint, "torque"));
                    }
                }
                JointKind::Weld(a, b) => {
                    unknowns.extend(self.pin_forces(joint, [a, b]));
                    unknowns.push(self.joint_torque(joint, "torque"));
                }
                JointKind::Prismatic(a, b) => {
                    unknowns.push(self.slide_force(joint, [a, b], Along::Across(joint), "normal"));
                    unknowns.push(self.joint_torque(joint, "moment"));
                    if motor.is_some() {
                        unknowns.push(self.slide_force(
                            joint,
                            [a, b],
                            Along::Slide(joint),
                            "force",
                        ));
                    }
                }
                JointKind::Cam { shaft, follower, .. } => {
                    let slope = self.slope(positions, joint);
                    unknowns
                        .extend(slope.map(|slope| self.cam_push(joint, slope, [shaft, follower])));
                }
                JointKind::Gear { .. } | JointKind::Belt { .. } | JointKind::Rack { .. } => {
                    let mut rollings = structure.rollings.iter();
                    if let Some(rolling) = rollings.find(|rolling| rolling.joint == joint) {
                        unknowns.push(self.rolling_force(structure, rolling));
                    }
                }
            }
        }
        unknowns
    }

    /// The unknown that is the torque or force of a motor.
    pub(super) fn is_drive(&self, unknown: &Unknown, motor: MotorId) -> bool {
        if self.model.motor(motor).joint != unknown.joint {
            return false;
        }
        match self.model.joint(unknown.joint).kind {
            JointKind::Revolute(..) => unknown.part == Part::Torque,
            _ => unknown.part == Part::Force(Along::Slide(unknown.joint)),
        }
    }

    /// An unknown of a joint.
    fn unknown(&self, joint: JointId, name: &str, pushes: Vec<Push>, part: Part) -> Unknown {
        Unknown { joint, name: format!("{}_{name}", self.model.joint(joint).name), pushes, part }
    }

    /// Two forces at a pin, along x and y.
    fn pin_forces(&mut self, joint: JointId, axes: [AxisId; 2]) -> [Unknown; 2] {
        [([1.0, 0.0], "x"), ([0.0, 1.0], "y")].map(|(direction, name)| {
            let along = Along::Scene(self.ssa.vector(direction));
            let [first, second] = axes.map(|axis| (self.link_of(axis), Place::Own(axis)));
            self.force(joint, name, along, [first, second])
        })
    }

    /// A force on the second link of a joint, and back on the first.
    fn force(
        &mut self,
        joint: JointId,
        name: &str,
        along: Along,
        [first, second]: [(LinkId, Place); 2],
    ) -> Unknown {
        let push = |(link, at), size| Push::Force { link, at, along, size };
        let (one, back) = (self.ssa.constant(1.0), self.ssa.constant(-1.0));
        self.unknown(joint, name, vec![push(second, one), push(first, back)], Part::Force(along))
    }

    /// A force between the links of a slide, where the second one's line begins.
    fn slide_force(
        &mut self,
        joint: JointId,
        [a, b]: [AxisId; 2],
        along: Along,
        name: &str,
    ) -> Unknown {
        let (first, link, own) = (self.link_of(a), self.link_of(b), Place::Own(b));
        let there = self.point(b);
        self.force(joint, name, along, [(first, Place::Scene(there)), (link, own)])
    }

    /// A torque on the second link of a joint, and back on the first.
    fn joint_torque(&mut self, joint: JointId, name: &str) -> Unknown {
        let one = self.ssa.constant(1.0);
        let pushes = self.torques(joint, one);
        self.unknown(joint, name, pushes, Part::Torque)
    }

    /// A torque of this size on the second link of a joint, and back on the first.
    fn torques(&mut self, joint: JointId, size: Value) -> Vec<Push> {
        let (a, b) = self.model.ends(joint);
        let back = self.ssa.neg(size);
        [(b, size), (a, back)].map(|(link, size)| Push::Torque { link, size }).to_vec()
    }

    /// The push of a cam on its follower, which turns the shaft back by as much as the follower is faster than it.
    fn cam_push(
        &mut self,
        joint: JointId,
        slope: Value,
        [shaft, follower]: [JointId; 2],
    ) -> Unknown {
        let back = self.ssa.neg(slope);
        let one = self.ssa.constant(1.0);
        let mut pushes = self.pushes_along(follower, one);
        pushes.extend(self.pushes_along(shaft, back));
        let part = match self.model.joint(follower).kind {
            JointKind::Prismatic(..) => Part::Force(Along::Slide(follower)),
            _ => Part::Torque,
        };
        self.unknown(joint, "push", pushes, part)
    }

    /// The pushes that drive the coordinate of a joint: torques, or forces along its slide.
    fn pushes_along(&mut self, joint: JointId, size: Value) -> Vec<Push> {
        let JointKind::Prismatic(a, b) = self.model.joint(joint).kind else {
            return self.torques(joint, size);
        };
        let back = self.ssa.neg(size);
        let at = Place::Scene(self.point(b));
        let along = Along::Slide(joint);
        let pushes = [(b, size), (a, back)].map(|(axis, size)| Push::Force {
            link: self.link_of(axis),
            at,
            along,
            size,
        });
        pushes.to_vec()
    }

    /// The force of what rolls, where the pitch circles touch; where they do not touch, torques alone.
    fn rolling_force(&mut self, structure: &Structure, rolling: &Rolling) -> Unknown {
        let joint = rolling.joint;
        let contact = match self.model.joint(joint).kind {
            JointKind::Gear { .. } => self.wheel_contact(structure, rolling),
            JointKind::Rack { .. } => self.rack_contact(structure, rolling),
            _ => None,
        };
        let (a, b) = self.model.ends(joint);
        if let Some((at, along)) = contact {
            let place = Place::Scene(at);
            return self.force(joint, "tooth", along, [(a, place), (b, place)]);
        }
        let [(first, p), (second, q)] =
            rolling.ends.map(|(end, factor)| (end.link(), number(factor)));
        // Of size one is the moment on the second, whatever the unit of the factors.
        let p = p / q;
        let torques = [(first, p), (second, 1.0), (rolling.carrier, -p - 1.0)];
        let pushes =
            torques.map(|(link, size)| Push::Torque { link, size: self.ssa.constant(size) });
        self.unknown(joint, "pull", pushes.to_vec(), Part::Torque)
    }

    /// The point where two wheels touch, and the direction in which the one pushes the other: across the line of their centres.
    fn wheel_contact(
        &mut self,
        structure: &Structure,
        rolling: &Rolling,
    ) -> Option<([Value; 2], Along)> {
        let [(a, first), (b, second)] = rolling.ends;
        let (first, second) = (number(first), number(second));
        let carrier = rolling.carrier;
        let [here, there] = [a, b].map(|end| structure.hub(end.link(), carrier));
        let [here, there] = [here?[1], there?[1]];
        let [from, to] = [here, there].map(|axis| self.model.axis(axis));
        let places = [from, to].map(|axis| structure.welded.place(axis, carrier));
        let [x, y] = [0, 1].map(|part| places[1][part] - places[0][part]);
        let distance = x.hypot(y);
        if first + second == 0.0 || distance <= 1e-9 * self.model.size() {
            return None;
        }
        let is_one = from.link == to.link;
        let (pose, start, offset) = if is_one {
            let offset = self.ssa.between(from, to);
            (self.placement.pose(from.link), self.ssa.place(from), offset)
        } else {
            // On links that are welded: in the scene.
            let [start, end] = [here, there].map(|axis| self.point(axis));
            let offset = self.ssa.minus(end, start);
            (Pose::identity(&mut self.ssa), start, offset)
        };
        let ssa = &mut self.ssa;
        let distance = if is_one && !from.varies() && !to.varies() {
            ssa.constant(distance)
        } else {
            let square = ssa.dot(offset, offset);
            ssa.sqrt(square)
        };
        let [x, y] = offset.map(|part| ssa.div(part, distance));
        let part = ssa.constant(first / (first + second));
        let on = ssa.scale(part, offset);
        let touch = ssa.plus(start, on);
        let at = pose.carry_spot(ssa, touch);
        let across = [ssa.neg(y), x];
        let along = ssa.rotate(pose.direction, across);
        Some((at, Along::Scene(along)))
    }

    /// The point where a pinion touches its bar, and the direction in which it pushes it: along its line.
    fn rack_contact(
        &mut self,
        structure: &Structure,
        rolling: &Rolling,
    ) -> Option<([Value; 2], Along)> {
        let [(pinion, turn), (bar, displacement)] = rolling.ends;
        let RollingEnd::Bar { slide, forwards, .. } = bar else {
            return None;
        };
        let JointKind::Prismatic(a, b) = self.model.joint(slide).kind else {
            return None;
        };
        let line = self.model.axis(if forwards { a } else { b });
        let radius = -number(turn) / number(displacement);
        let [_, center] = structure.hub(pinion.link(), rolling.carrier)?;
        let beside = if line.turns() {
            let [x, y] = self.ssa.direction(line);
            let radius = self.ssa.constant(radius);
            let across = [y, self.ssa.neg(x)];
            self.ssa.scale(radius, across)
        } else {
            let [x, y] = line.direction;
            self.ssa.vector([radius * y, -radius * x])
        };
        let pose = self.placement.pose(line.link);
        let at = if self.link_of(center) == line.link {
            let center = self.ssa.place(self.model.axis(center));
            let touch = self.ssa.plus(center, beside);
            pose.carry_spot(&mut self.ssa, touch)
        } else {
            let center = self.point(center);
            let beside = self.ssa.rotate(pose.direction, beside);
            self.ssa.plus(center, beside)
        };
        let along = pose.heading(&mut self.ssa, line);
        Some((at, Along::Scene(along)))
    }
}

fn number(factor: Factor) -> f64 {
    match factor {
        #[expect(clippy::cast_precision_loss, reason = "teeth are few")]
        Factor::Whole(teeth) => teeth as f64,
        Factor::Float(radius) => radius,
    }
}
