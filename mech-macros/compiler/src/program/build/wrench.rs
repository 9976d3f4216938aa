//! Forces and torques on links: what gravity, springs, dampers and loads do.

use super::lowering::Lowering;
use super::tangent::Tangents;
use crate::bug::bug;
use crate::model::{AxisId, Between, Damper, JointId, LinkId, LoadKind, Mass, Spring};
use crate::plan::{Algebra, Arithmetic};
use crate::program::node::{Op, Value};

/// A force at a point of a link, or a torque on it, in the scene.
#[derive(Clone, Copy, Debug)]
pub(super) enum Wrench {
    Force { link: LinkId, at: [Value; 2], force: [Value; 2] },
    Torque { link: LinkId, torque: Value },
}

impl Wrench {
    /// The link on which it acts.
    pub(super) fn link(&self) -> LinkId {
        match *self {
            Self::Force { link, .. } | Self::Torque { link, .. } => link,
        }
    }
}

/// Two points in the scene, on links.
#[derive(Clone, Copy)]
struct Span {
    links: [LinkId; 2],
    points: [[Value; 2]; 2],
    /// From the first point to the second.
    offset: [Value; 2],
}

/// A link that has a mass.
#[derive(Clone, Copy, Debug)]
pub(super) struct Body {
    pub(super) link: LinkId,
    pub(super) mass: Mass,
    /// Its centre of mass in the scene.
    pub(super) center: [Value; 2],
    pub(super) direction: [Value; 2],
}

impl Lowering<'_> {
    /// All links that have a mass.
    pub(super) fn bodies(&mut self) -> Vec<Body> {
        let mut bodies = Vec::new();
        for link in self.model.declared_links() {
            let Some(mass) = self.model.link(link).mass else {
                continue;
            };
            let pose = self.placement.pose(link);
            let center = pose.carry_point(&mut self.ssa, mass.center);
            let name = format!("{}_center", self.name_of(link));
            let center = self.ssa.name_vector(center, &name);
            bodies.push(Body { link, mass, center, direction: pose.direction });
        }
        bodies
    }

    /// The forces and torques on links that do not depend on velocities: gravity, springs, loads.
    pub(super) fn wrenches(&mut self, bodies: &[Body]) -> Vec<Wrench> {
        let mut wrenches = Vec::new();
        let actions = &self.model.actions;
        if let Some(gravity) = actions.gravity {
            for body in bodies {
                let weight = gravity.map(|part| part * body.mass.mass);
                wrenches.push(Wrench::Force {
                    link: body.link,
                    at: body.center,
                    force: self.ssa.vector(weight),
                });
            }
        }
        for spring in &actions.springs {
            wrenches.extend(self.pull(spring));
        }
        for (number, load) in actions.numbered_loads() {
            let mut given = |part: usize, what: &str| {
                let value = self.ssa.make(Op::Load(number + part));
                self.ssa.name(value, format!("{}{what}", load.name))
            };
            wrenches.push(match load.kind {
                LoadKind::Torque(link) => Wrench::Torque { link, torque: given(0, "") },
                LoadKind::Force(point) => {
                    let force = [given(0, "_x"), given(1, "_y")];
                    let (link, at) = (self.link_of(point), self.point(point));
                    Wrench::Force { link, at, force }
                }
            });
        }
        wrenches
    }

    /// The forces and torques of dampers, from the rates of everything.
    pub(super) fn resistances(&mut self, tangents: &mut Tangents) -> Vec<Wrench> {
        let dampers = self.model.actions.dampers.iter();
        dampers.flat_map(|damper| self.resist(damper, tangents)).collect()
    }

    /// The forces or torques of a spring on the links at its ends.
    fn pull(&mut self, spring: &Spring) -> [Wrench; 2] {
        let stiffness = self.ssa.constant(spring.stiffness);
        match spring.between {
            Between::Points(a, b) => {
                let span = self.span(a, b);
                let tension = if spring.rest == 0.0 {
                    stiffness
                } else {
                    // Tension a unit of length: k (1 − rest / length).
                    let inverse = self.inverse_length(span.offset);
                    let rest = self.ssa.constant(spring.rest);
                    let part = self.ssa.mul(rest, inverse);
                    let one = self.ssa.constant(1.0);
                    let stretch = self.ssa.sub(one, part);
                    self.ssa.mul(stiffness, stretch)
                };
                let force = self.ssa.scale(tension, span.offset);
                let force = self.ssa.name_vector(force, &spring.name);
                self.tension(span, force)
            }
            Between::Joint(joint) => {
                let deflection = self.deflection(joint, spring.rest);
                let torque = self.ssa.mul(stiffness, deflection);
                let torque = self.ssa.name(torque, spring.name.clone());
                self.joint_torques(joint, torque)
            }
        }
    }

    /// Twice the energy in a spring, divided by its stiffness: the square of how far it is from rest.
    fn stretch_square(&mut self, spring: &Spring) -> Value {
        match spring.between {
            Between::Points(a, b) => {
                let span = self.span(a, b).offset;
                let square = self.ssa.dot(span, span);
                if spring.rest == 0.0 {
                    return square;
                }
                let length = self.ssa.sqrt(square);
                let rest = self.ssa.constant(spring.rest);
                let stretch = self.ssa.sub(length, rest);
                self.ssa.mul(stretch, stretch)
            }
            Between::Joint(joint) => {
                let deflection = self.deflection(joint, spring.rest);
                self.ssa.mul(deflection, deflection)
            }
        }
    }

    /// The potential energy of gravity and springs.
    pub(super) fn potential_energy(&mut self, bodies: &[Body]) -> Value {
        let mut energy = self.ssa.constant(0.0);
        let actions = &self.model.actions;
        if let Some(gravity) = actions.gravity {
            for body in bodies {
                let weight = self.ssa.vector(gravity.map(|part| part * body.mass.mass));
                let work = self.ssa.dot(weight, body.center);
                energy = self.ssa.sub(energy, work);
            }
        }
        for spring in &actions.springs {
            let square = self.stretch_square(spring);
            let half = self.ssa.constant(spring.stiffness / 2.0);
            let part = self.ssa.mul(half, square);
            energy = self.ssa.add(energy, part);
        }
        energy
    }

    /// The forces or torques of a damper on the links at its ends.
    fn resist(&mut self, damper: &Damper, tangents: &mut Tangents) -> [Wrench; 2] {
        let damping = self.ssa.constant(damper.damping);
        match damper.between {
            Between::Points(a, b) => {
                let span = self.span(a, b);
                let [from, to] = span.points.map(|point| tangents.of_vector(&mut self.ssa, point));
                let apart = self.ssa.minus(to, from);
                let inverse = self.inverse_length(span.offset);
                let along = self.ssa.scale(inverse, span.offset);
                let lengthening = self.ssa.dot(apart, along);
                let tension = self.ssa.mul(damping, lengthening);
                let force = self.ssa.scale(tension, along);
                let force = self.ssa.name_vector(force, &damper.name);
                self.tension(span, force)
            }
            Between::Joint(joint) => {
                let (a, b) = self.model.ends(joint);
                let [from, to] = [a, b].map(|link| {
                    let direction = self.placement.pose(link).direction;
                    tangents.angular_velocity(&mut self.ssa, direction)
                });
                let rate = self.ssa.sub(to, from);
                let torque = self.ssa.mul(damping, rate);
                let torque = self.ssa.name(torque, damper.name.clone());
                self.joint_torques(joint, torque)
            }
        }
    }

    /// The span between two points.
    fn span(&mut self, a: AxisId, b: AxisId) -> Span {
        let points = [self.point(a), self.point(b)];
        Span {
            links: [a, b].map(|axis| self.link_of(axis)),
            points,
            offset: self.ssa.minus(points[1], points[0]),
        }
    }

    /// One over the length of an offset; where that is zero, a large number, so that the offset times it is still zero.
    fn inverse_length(&mut self, span: [Value; 2]) -> Value {
        let square = self.ssa.dot(span, span);
        let length = self.ssa.sqrt(square);
        let least = self.model.size() * self.ssa.epsilon.sqrt();
        let least = least.max(f64::from(f32::MIN_POSITIVE));
        let least = self.ssa.constant(least);
        let length = self.ssa.max(length, least);
        let one = self.ssa.constant(1.0);
        self.ssa.div(one, length)
    }

    /// A pull of one end towards the other, and of the other back.
    fn tension(&mut self, span: Span, force: [Value; 2]) -> [Wrench; 2] {
        let back = force.map(|part| self.ssa.neg(part));
        [(0, force), (1, back)].map(|(end, force)| Wrench::Force {
            link: span.links[end],
            at: span.points[end],
            force,
        })
    }

    /// A torque that turns the links of a joint back.
    fn joint_torques(&mut self, joint: JointId, torque: Value) -> [Wrench; 2] {
        let (first, second) = self.model.ends(joint);
        let back = self.ssa.neg(torque);
        [Wrench::Torque { link: first, torque }, Wrench::Torque { link: second, torque: back }]
    }

    /// The angle from the rest of a torsional spring to a joint's coordinate, whole turns included.
    fn deflection(&mut self, joint: JointId, rest: f64) -> Value {
        let rest = self.ssa.constant(rest);
        // Only revolute joints have torsional springs, and the angles of all of these are known.
        let Some(angle) = self.sprung_coordinate(joint) else {
            let name = &self.model.joint(joint).name;
            bug!("a torsional spring is on joint `{name}`, whose angle is not known");
        };
        self.ssa.sub(angle, rest)
    }
}
