//! Forces and torques on links: what gravity, springs, dampers and loads do.

use super::Writer;
use super::tangent::Tangents;
use crate::bug::bug;
use crate::model::{AxisId, Between, Damper, JointId, LinkId, LoadKind, Mass, Spring};
use crate::plan::Algebra;
use crate::program::node::{Op, Value};

/// A force at a point of a link, or a torque on it, in the scene.
#[derive(Clone, Copy, Debug)]
pub(super) enum Wrench {
    Force {
        link: LinkId,
        at: [Value; 2],
        force: [Value; 2],
    },
    Torque {
        link: LinkId,
        torque: Value,
    },
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

impl Writer<'_> {
    /// All links that have a mass.
    pub(super) fn bodies(&mut self) -> Vec<Body> {
        let mut bodies = Vec::new();
        for link in self.model.declared_links() {
            let Some(mass) = self.model.link(link).mass else {
                continue;
            };
            let pose = self.placement.pose(link);
            let center = pose.carry_point(&mut self.builder, mass.center);
            let name = format!("{}_center", self.name_of(link));
            let center = self.builder.name_vector(center, &name);
            bodies.push(Body {
                link,
                mass,
                center,
                direction: pose.direction,
            });
        }
        bodies
    }

    /// What acts on links whatever their velocities.
    pub(super) fn wrenches(&mut self, bodies: &[Body]) -> Vec<Wrench> {
        let mut wrenches = Vec::new();
        let actions = &self.model.actions;
        if let Some(gravity) = actions.gravity {
            for body in bodies {
                let weight = gravity.map(|part| part * body.mass.mass);
                wrenches.push(Wrench::Force {
                    link: body.link,
                    at: body.center,
                    force: self.builder.vector(weight),
                });
            }
        }
        for spring in &actions.springs {
            wrenches.extend(self.pull(spring));
        }
        for (number, load) in actions.numbered_loads() {
            let mut given = |part: usize, what: &str| {
                let value = self.builder.make(Op::Load(number + part));
                self.builder.name(value, format!("{}{what}", load.name))
            };
            wrenches.push(match load.kind {
                LoadKind::Torque(link) => Wrench::Torque {
                    link,
                    torque: given(0, ""),
                },
                LoadKind::Force(point) => {
                    let force = [given(0, "_x"), given(1, "_y")];
                    let (link, at) = self.point(point);
                    Wrench::Force { link, at, force }
                }
            });
        }
        wrenches
    }

    /// What resists velocities.
    pub(super) fn resistances(&mut self, tangents: &mut Tangents) -> Vec<Wrench> {
        let mut wrenches = Vec::new();
        for damper in &self.model.actions.dampers {
            wrenches.extend(self.resist(damper, tangents));
        }
        wrenches
    }

    /// A point in the scene, and the link that it is fixed to.
    pub(super) fn point(&mut self, point: AxisId) -> (LinkId, [Value; 2]) {
        let axis = self.model.axis(point);
        let at = self
            .placement
            .pose(axis.link)
            .carry(&mut self.builder, axis);
        (axis.link, at)
    }

    /// What a spring does to the links at its ends.
    fn pull(&mut self, spring: &Spring) -> [Wrench; 2] {
        let stiffness = self.builder.constant(spring.stiffness);
        match spring.between {
            Between::Points(a, b) => {
                let ([first, second], span) = self.span(a, b);
                let tension = if spring.rest == 0.0 {
                    stiffness
                } else {
                    // Tension a unit of length: k (1 − rest / length).
                    let inverse = self.inverse_length(span);
                    let rest = self.builder.constant(spring.rest);
                    let discriminant = self.builder.mul(rest, inverse);
                    let one = self.builder.constant(1.0);
                    let stretch = self.builder.sub(one, discriminant);
                    self.builder.mul(stiffness, stretch)
                };
                let force = self.builder.scaled(tension, span);
                let force = self.builder.name_vector(force, &spring.name);
                self.opposed(first, second, force)
            }
            Between::Joint(joint) => {
                let deflection = self.deflection(joint, spring.rest);
                let torque = self.builder.mul(stiffness, deflection);
                let torque = self.builder.name(torque, spring.name.clone());
                self.twisted(joint, torque)
            }
        }
    }

    /// Twice the energy in a spring, divided by its stiffness: the square of how far it is from rest.
    fn stretch_square(&mut self, spring: &Spring) -> Value {
        match spring.between {
            Between::Points(a, b) => {
                let (_, span) = self.span(a, b);
                let square = self.builder.dot(span, span);
                if spring.rest == 0.0 {
                    return square;
                }
                let length = self.builder.sqrt(square);
                let rest = self.builder.constant(spring.rest);
                let stretch = self.builder.sub(length, rest);
                self.builder.mul(stretch, stretch)
            }
            Between::Joint(joint) => {
                let deflection = self.deflection(joint, spring.rest);
                self.builder.mul(deflection, deflection)
            }
        }
    }

    /// The potential energy of gravity and springs.
    pub(super) fn potential(&mut self, bodies: &[Body]) -> Value {
        let mut energy = self.builder.constant(0.0);
        let actions = &self.model.actions;
        if let Some(gravity) = actions.gravity {
            for body in bodies {
                let weight = self
                    .builder
                    .vector(gravity.map(|part| part * body.mass.mass));
                let work = self.builder.dot(weight, body.center);
                energy = self.builder.sub(energy, work);
            }
        }
        for spring in &actions.springs {
            let square = self.stretch_square(spring);
            let half = self.builder.constant(spring.stiffness / 2.0);
            let part = self.builder.mul(half, square);
            energy = self.builder.add(energy, part);
        }
        energy
    }

    fn resist(&mut self, damper: &Damper, tangents: &mut Tangents) -> [Wrench; 2] {
        let damping = self.builder.constant(damper.damping);
        match damper.between {
            Between::Points(a, b) => {
                let ([first, second], span) = self.span(a, b);
                let (from, to) = (
                    tangents.of_vector(&mut self.builder, first.1),
                    tangents.of_vector(&mut self.builder, second.1),
                );
                let apart = self.builder.minus(to, from);
                let inverse = self.inverse_length(span);
                let along = self.builder.scaled(inverse, span);
                let lengthening = self.builder.dot(apart, along);
                let tension = self.builder.mul(damping, lengthening);
                let force = self.builder.scaled(tension, along);
                let force = self.builder.name_vector(force, &damper.name);
                self.opposed(first, second, force)
            }
            Between::Joint(joint) => {
                let (a, b) = self.model.ends(joint);
                let [from, to] = [a, b].map(|link| {
                    let direction = self.placement.pose(link).direction;
                    tangents.turning(&mut self.builder, direction)
                });
                let rate = self.builder.sub(to, from);
                let torque = self.builder.mul(damping, rate);
                let torque = self.builder.name(torque, damper.name.clone());
                self.twisted(joint, torque)
            }
        }
    }

    /// Two points with their links, and the way from the first to the second.
    fn span(&mut self, a: AxisId, b: AxisId) -> ([(LinkId, [Value; 2]); 2], [Value; 2]) {
        let (first, second) = (self.point(a), self.point(b));
        let span = self.builder.minus(second.1, first.1);
        ([first, second], span)
    }

    /// One over the length of a way; where that is zero, a large number, so that the way times it is still zero.
    fn inverse_length(&mut self, span: [Value; 2]) -> Value {
        let square = self.builder.dot(span, span);
        let length = self.builder.sqrt(square);
        let least = self.model.size() * self.model.precision.epsilon().sqrt();
        let least = least.max(f64::from(f32::MIN_POSITIVE));
        let least = self.builder.constant(least);
        let length = self.builder.max(length, least);
        let one = self.builder.constant(1.0);
        self.builder.div(one, length)
    }

    /// A pull of one end towards the other, and of the other back.
    fn opposed(
        &mut self,
        (first, at): (LinkId, [Value; 2]),
        (second, there): (LinkId, [Value; 2]),
        force: [Value; 2],
    ) -> [Wrench; 2] {
        let back = force.map(|part| self.builder.neg(part));
        [
            Wrench::Force {
                link: first,
                at,
                force,
            },
            Wrench::Force {
                link: second,
                at: there,
                force: back,
            },
        ]
    }

    /// A torque that turns the links of a joint back.
    fn twisted(&mut self, joint: JointId, torque: Value) -> [Wrench; 2] {
        let (first, second) = self.model.ends(joint);
        let back = self.builder.neg(torque);
        [
            Wrench::Torque {
                link: first,
                torque,
            },
            Wrench::Torque {
                link: second,
                torque: back,
            },
        ]
    }

    /// How far a joint is turned from an angle, whole turns included.
    fn deflection(&mut self, joint: JointId, rest: f64) -> Value {
        let rest = self.builder.constant(rest);
        // Only revolute joints have torsional springs, and the angles of all of these are known.
        let Some(angle) = self.sprung_coordinate(joint) else {
            let name = &self.model.joint(joint).name;
            bug!("a torsional spring is on joint `{name}`, whose angle is not known");
        };
        self.builder.sub(angle, rest)
    }
}
