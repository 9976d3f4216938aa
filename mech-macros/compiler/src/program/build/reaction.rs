//! What joints and motors do to links, as unknowns: in which directions each pushes, and where.

use super::Writer;
use crate::model::{AxisId, JointId, JointKind, LinkId, MotorId};
use crate::plan::Algebra;
use crate::program::node::Value;
use crate::structure::{Factor, Rolling, RollingEnd, Structure};

/// Where something pushes.
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

/// What an unknown of size one does to a link.
#[derive(Clone, Copy, Debug)]
pub(super) enum Push {
    /// A force of this size.
    Force {
        link: LinkId,
        at: Place,
        along: Along,
        size: Value,
    },
    /// A torque of this size.
    Torque { link: LinkId, size: Value },
}

/// An unknown: a part of the reaction in a joint, or the torque of a motor.
#[derive(Clone, Debug)]
pub(super) struct Unknown {
    pub(super) joint: JointId,
    /// What it is called.
    pub(super) name: String,
    /// What it does to each link.
    pub(super) pushes: Vec<Push>,
    /// What of the reaction it is, for one that is told.
    pub(super) part: Part,
}

/// What of a reaction an unknown is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Part {
    /// A force in this direction.
    Force(Along),
    /// A torque.
    Torque,
}

impl Writer<'_> {
    /// All unknowns of the reactions in all joints.
    pub(super) fn unknown_reactions(&mut self, structure: &Structure) -> Vec<Unknown> {
        let mut unknowns = Vec::new();
        for joint in self.model.joint_ids() {
            let motor = self.model.motor_of(joint);
            match self.model.joint(joint).kind {
                JointKind::Revolute(a, b) => {
                    unknowns.extend(self.pinned(joint, [a, b]));
                    if motor.is_some() {
                        unknowns.push(self.twist(joint, "torque"));
                    }
                }
                JointKind::Weld(a, b) => {
                    unknowns.extend(self.pinned(joint, [a, b]));
                    unknowns.push(self.twist(joint, "torque"));
                }
                JointKind::Prismatic(a, b) => {
                    unknowns.push(self.guided(joint, [a, b], Along::Across(joint), "normal"));
                    unknowns.push(self.twist(joint, "moment"));
                    if motor.is_some() {
                        unknowns.push(self.guided(joint, [a, b], Along::Slide(joint), "force"));
                    }
                }
                JointKind::Cam {
                    shaft, follower, ..
                } => unknowns.extend(self.cammed(joint, shaft, follower)),
                JointKind::Gear { .. } | JointKind::Belt { .. } | JointKind::Rack { .. } => {
                    let mut rollings = structure.rollings.iter();
                    if let Some(rolling) = rollings.find(|rolling| rolling.joint == joint) {
                        unknowns.push(self.rolled(structure, rolling));
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

    fn reaction_name(&self, joint: JointId, part: &str) -> String {
        format!("{}_{part}", self.model.joint(joint).name)
    }

    /// Two forces at a pin, along x and y.
    fn pinned(&mut self, joint: JointId, axes: [AxisId; 2]) -> [Unknown; 2] {
        [([1.0, 0.0], "x"), ([0.0, 1.0], "y")].map(|(direction, name)| {
            let along = Along::Scene(self.builder.vector(direction));
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
        let push = |(link, at), size| Push::Force {
            link,
            at,
            along,
            size,
        };
        let (one, back) = (self.builder.constant(1.0), self.builder.constant(-1.0));
        Unknown {
            joint,
            name: self.reaction_name(joint, name),
            pushes: vec![push(second, one), push(first, back)],
            part: Part::Force(along),
        }
    }

    /// A force between the links of a slide, where the second one's line begins.
    fn guided(&mut self, joint: JointId, [a, b]: [AxisId; 2], along: Along, name: &str) -> Unknown {
        let (first, link, own) = (self.link_of(a), self.link_of(b), Place::Own(b));
        let (_, there) = self.point(b);
        self.force(
            joint,
            name,
            along,
            [(first, Place::Scene(there)), (link, own)],
        )
    }

    /// A torque on the second link of a joint, and back on the first.
    fn twist(&mut self, joint: JointId, name: &str) -> Unknown {
        let (a, b) = self.model.ends(joint);
        let (one, back) = (self.builder.constant(1.0), self.builder.constant(-1.0));
        Unknown {
            joint,
            name: self.reaction_name(joint, name),
            pushes: vec![
                Push::Torque { link: b, size: one },
                Push::Torque {
                    link: a,
                    size: back,
                },
            ],
            part: Part::Torque,
        }
    }

    /// What a cam does: it pushes its follower, and is turned back by as much as the follower is faster than it.
    fn cammed(&mut self, joint: JointId, shaft: JointId, follower: JointId) -> Option<Unknown> {
        let slope = self.slope(joint)?;
        let back = self.builder.neg(slope);
        let one = self.builder.constant(1.0);
        let mut pushes = self.driving(follower, one);
        pushes.extend(self.driving(shaft, back));
        let part = match self.model.joint(follower).kind {
            JointKind::Prismatic(..) => Part::Force(Along::Slide(follower)),
            _ => Part::Torque,
        };
        Some(Unknown {
            joint,
            name: self.reaction_name(joint, "push"),
            pushes,
            part,
        })
    }

    /// What drives the coordinate of a joint: a torque, or a force along its slide.
    fn driving(&mut self, joint: JointId, size: Value) -> Vec<Push> {
        let back = self.builder.neg(size);
        if let JointKind::Prismatic(a, b) = self.model.joint(joint).kind {
            let (along, (link, there)) = (Along::Slide(joint), self.point(b));
            let push = |link, size| Push::Force {
                link,
                at: Place::Scene(there),
                along,
                size,
            };
            return vec![push(link, size), push(self.model.axis(a).link, back)];
        }
        let (a, b) = self.model.ends(joint);
        vec![
            Push::Torque { link: b, size },
            Push::Torque {
                link: a,
                size: back,
            },
        ]
    }

    /// What rolls: a force where the pitch circles touch, or, where they do not, torques alone.
    fn rolled(&mut self, structure: &Structure, rolling: &Rolling) -> Unknown {
        let joint = rolling.joint;
        let meshes = match self.model.joint(joint).kind {
            JointKind::Gear { .. } => self.meshing(structure, rolling),
            JointKind::Rack { .. } => self.racking(structure, rolling),
            _ => None,
        };
        let (a, b) = self.model.ends(joint);
        if let Some((at, along)) = meshes {
            let place = Place::Scene(at);
            return self.force(joint, "tooth", along, [(a, place), (b, place)]);
        }
        let sizes = rolling.ends.map(|(_, factor)| number(factor));
        let mut pushes = Vec::new();
        for ((end, _), size) in rolling.ends.iter().zip(sizes) {
            pushes.push(Push::Torque {
                link: end.link(),
                size: self.builder.constant(size),
            });
        }
        let on_carrier = self.builder.constant(-sizes[0] - sizes[1]);
        pushes.push(Push::Torque {
            link: rolling.carrier,
            size: on_carrier,
        });
        Unknown {
            joint,
            name: self.reaction_name(joint, "pull"),
            pushes,
            part: Part::Torque,
        }
    }

    /// Where two wheels touch, and in which direction the one pushes the other: across the line of their centres.
    fn meshing(&mut self, structure: &Structure, rolling: &Rolling) -> Option<([Value; 2], Along)> {
        let [(a, first), (b, second)] = rolling.ends;
        let (first, second) = (number(first), number(second));
        let here = center(structure, a, rolling.carrier)?;
        let there = center(structure, b, rolling.carrier)?;
        let [from, to] = [here, there].map(|axis| self.model.axis(axis));
        let [x, y] = [0, 1].map(|part| to.at[part] - from.at[part]);
        let distance = x.hypot(y);
        if first + second == 0.0 || distance <= 1e-9 * self.model.size() {
            return None;
        }
        let pose = self.placement.pose(rolling.carrier);
        let builder = &mut self.builder;
        let offset = builder.between(from, to);
        let distance = if from.varies() || to.varies() {
            let square = builder.dot(offset, offset);
            builder.sqrt(square)
        } else {
            builder.constant(distance)
        };
        let [x, y] = offset.map(|part| builder.div(part, distance));
        let part = builder.constant(first / (first + second));
        let (start, on) = (builder.place(from), builder.scaled(part, offset));
        let touch = builder.plus(start, on);
        let at = pose.carry_spot(builder, touch);
        let across = [builder.neg(y), x];
        let along = builder.turned(pose.direction, across);
        Some((at, Along::Scene(along)))
    }

    /// Where a pinion touches its bar, and in which direction it pushes it: along its line.
    fn racking(&mut self, structure: &Structure, rolling: &Rolling) -> Option<([Value; 2], Along)> {
        let [(pinion, turn), (bar, displacement)] = rolling.ends;
        let RollingEnd::Bar {
            slide, forwards, ..
        } = bar
        else {
            return None;
        };
        let JointKind::Prismatic(a, b) = self.model.joint(slide).kind else {
            return None;
        };
        let line = self.model.axis(if forwards { a } else { b });
        let radius = -number(turn) / number(displacement);
        let center = center(structure, pinion, rolling.carrier)?;
        let center = self.builder.place(self.model.axis(center));
        let beside = if line.turns() {
            let [x, y] = self.builder.direction(line);
            let radius = self.builder.constant(radius);
            let across = [y, self.builder.neg(x)];
            self.builder.scaled(radius, across)
        } else {
            let [x, y] = line.direction;
            self.builder.vector([radius * y, -radius * x])
        };
        let touch = self.builder.plus(center, beside);
        let pose = self.placement.pose(rolling.carrier);
        let at = pose.carry_spot(&mut self.builder, touch);
        let along = pose.heading(&mut self.builder, line);
        Some((at, Along::Scene(along)))
    }
}

/// The axis on the carrier about which a wheel turns.
fn center(structure: &Structure, end: RollingEnd, carrier: LinkId) -> Option<AxisId> {
    let link = end.link();
    let mut pins = structure.pins.iter();
    let shared = pins.find(|pin| pin.axis_of(link).is_some() && pin.axis_of(carrier).is_some())?;
    shared.axis_of(carrier)
}

fn number(factor: Factor) -> f64 {
    match factor {
        #[expect(clippy::cast_precision_loss, reason = "teeth are few")]
        Factor::Whole(teeth) => teeth as f64,
        Factor::Float(radius) => radius,
    }
}
