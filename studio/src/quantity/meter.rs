//! A mechanism that moves and is measured.

use super::kind::{Needs, Order, Part, Quantity, Reaction, Spot, Subject};
use super::position::{Position, torques};
use super::turning::{Chain, whole_angle};
use crate::failure::Failure;
use crate::motion::{Moment, Mover, obstacle, place_of};
use mech_compiler::Compiled;
use mech_compiler::evaluate::Stop;
use mech_compiler::model::{
    AxisId, JointId, JointKind, LinkId, Load as ModelLoad, LoadKind, Model, MotorId,
};
use mech_compiler::program::{self, CamContact, CamNumbers, Forces, Program, clearance};
use mech_runtime::{Acceleration, Velocity};
use std::collections::BTreeMap;

/// A mechanism that moves and is measured.
pub(super) struct Meter<'a> {
    model: &'a Model,
    compiled: &'a Compiled,
    moving: Option<Mover<'a>>,
    forced: Option<Mover<'a>>,
    /// Where equilibrium does not determine the reactions, virtual work still tells the torques of the motors.
    inertia: Option<Mover<'a>>,
    /// The numbers of all loads.
    loads: Vec<f64>,
    /// The joints up to each link whose angle is measured.
    chains: BTreeMap<LinkId, Chain>,
    /// The contacts of the cams that are measured.
    contacts: BTreeMap<JointId, CamContact>,
}

impl<'a> Meter<'a> {
    /// A mechanism that is compiled for these quantities, with the numbers of all its loads.
    pub(super) fn new(
        model: &'a Model,
        compiled: &'a Compiled,
        quantities: &[Quantity],
        loads: Vec<f64>,
    ) -> Result<Self, Failure> {
        let needs = Needs::of(quantities);
        let forced = compiled.forced.inverse_dynamics.as_ref();
        let is_within = |one: &Quantity| {
            matches!(
                one.subject,
                Subject::Reaction(..) | Subject::Transmission(_)
            )
        };
        if forced.is_none() && quantities.iter().any(is_within) {
            return Err(Failure::mechanism(
                "reactions are not determined: joints of the mechanism are redundant; torques of motors are",
            ));
        }
        let direction = |one: &Quantity| match one.subject {
            Subject::Advantage(load, _) => Some((load, load_parts(model, &loads).nth(load)?.1)),
            _ => None,
        };
        let mut directions = quantities.iter().filter_map(direction);
        if let Some((load, _)) = directions.find(|(_, numbers)| *numbers == [0.0, 0.0]) {
            let name = &model.actions.loads[load].name;
            return Err(Failure::usage(format!(
                "an advantage is that over a load in its direction: `--load {name}=1,0`"
            )));
        }
        let is_angle = |one: &Quantity| matches!(one.subject, Subject::Transmission(_));
        if quantities.iter().any(is_angle)
            && transmissions(compiled) != compiled.plan.loops().count()
        {
            return Err(Failure::mechanism(
                "there is no transmission angle for each loop: some loops are solved together",
            ));
        }
        let inertia = compiled.forced.inertia.as_ref();
        let start = Position::of(&Mover::new(model, compiled).position());
        let links = quantities.iter().flat_map(Quantity::turning_links);
        let chains = links.filter_map(|link| {
            let heading = start.heading(compiled, link)?;
            let chain = Chain::to(model, link).from(model, compiled, &start, heading);
            Some((link, chain))
        });
        let contacts = quantities.iter().filter_map(|quantity| {
            let cam = quantity.cam()?;
            Some((cam, CamContact::new(model, &compiled.program, cam)?))
        });
        let mover = |program| Mover::of(model, program);
        Ok(Self {
            contacts: contacts.collect(),
            model,
            compiled,
            chains: chains.collect(),
            moving: compiled.moving.as_ref().map(mover),
            forced: forced.filter(|_| needs.force).map(mover),
            inertia: inertia
                .filter(|_| needs.force && forced.is_none())
                .map(mover),
            loads,
        })
    }

    /// The values of all quantities where the mechanism is, in radians and scene units: velocities at one moment, forces as at another that
    /// has other rates.
    pub(super) fn read(
        &mut self,
        at: &program::Position<f64>,
        moments: [&Moment; 2],
        quantities: &[Quantity],
    ) -> Result<Vec<Option<f64>>, Failure> {
        let position = self.position(at, moments, quantities)?;
        let values = quantities.iter().map(|quantity| {
            let value = self.value(&position, moments[0], quantity.subject);
            value.filter(|value| value.is_finite())
        });
        Ok(values.collect())
    }

    /// All that these quantities need to be known where the mechanism is.
    pub(super) fn position<'m>(
        &mut self,
        at: &program::Position<f64>,
        [moment, pushed]: [&'m Moment; 2],
        quantities: &[Quantity],
    ) -> Result<Position, Failure> {
        let mut position = Position::of(at);
        let rates = |moment: &'m Moment| moment.rates.each_ref().map(Vec::as_slice);
        position.rates = self.moving.as_mut().and_then(|machine| {
            machine.put_back(at);
            machine.motion(rates(moment)).ok()
        });
        if quantities.iter().any(Quantity::is_of_ground) {
            position.pushed = self.moving.as_mut().and_then(|machine| {
                machine.put_back(at);
                machine.motion(rates(pushed)).ok()
            });
        }
        for motor in quantities.iter().filter_map(Quantity::motor) {
            let rest = vec![0.0; self.model.motors.len()];
            let mut alone = rest.clone();
            alone[motor.index()] = 1.0;
            let moved = self.moving.as_mut().and_then(|machine| {
                machine.put_back(at);
                machine.motion([&alone, &rest]).ok()
            });
            position
                .influences
                .extend(moved.map(|rates| (motor, rates)));
        }
        for machine in self.forced.iter_mut().chain(&mut self.inertia) {
            machine.put_back(at);
            match machine.forces(rates(pushed), &self.loads) {
                Ok(found) => match found {
                    Forces::InverseDynamics(found) => {
                        position.torques = Some(found.torques.clone());
                        position.forces = Some(found);
                    }
                    Forces::Inertia(found) => {
                        position.torques = Some(torques(&found, &pushed.rates[1]));
                    }
                    Forces::Holding(_) => {}
                },
                // Not determined there.
                Err(Stop::Singular(_)) => {}
                Err(stop) => {
                    let why = obstacle(self.model, self.compiled, stop);
                    return Err(Failure::mechanism(format!(
                        "forces cannot be computed: {why}"
                    )));
                }
            }
        }
        Ok(position)
    }

    fn value(&self, at: &Position, moment: &Moment, subject: Subject) -> Option<f64> {
        match subject {
            Subject::Point(point, order, part) => {
                let vector = self.point(at, point, order)?;
                Some(part_of(vector, part))
            }
            Subject::Distance(ends) => {
                let [from, to] = ends.map(|end| match end {
                    Spot::Point(point) => self.point(at, point, Order::Place),
                    Spot::At(place) => Some(place),
                });
                let ([x, y], [to_x, to_y]) = (from?, to?);
                Some((to_x - x).hypot(to_y - y))
            }
            Subject::Clearance(links) => {
                let pose = |link| {
                    let pose = at.pose(self.compiled, link)?;
                    Some([pose.cos, pose.sin, pose.x, pose.y])
                };
                clearance(self.model, links, [pose(links[0])?, pose(links[1])?])
            }
            Subject::Angle(link, Order::Place) => self.angle(at, link),
            Subject::Between([from, to]) => Some(self.angle(at, to)? - self.angle(at, from)?),
            Subject::Power(motor) => {
                let torque = at.torques.as_ref()?.get(motor.index())?;
                Some(torque * moment.rates[0][motor.index()])
            }
            Subject::Angle(link, order) => Some(at.rate(self.compiled, link, order)?[0]),
            Subject::Centre(links, part) => Some(part_of(self.centre(at, links)?, part)),
            Subject::Influence(of, motor) => {
                let alone = at.with_rates(at.influences.get(&motor)?.clone());
                self.value(&alone, moment, of.rate())
            }
            Subject::Coordinate(joint, Order::Place) => match self.model.motor_of(joint) {
                Some(motor) => Some(moment.values[motor.index()]),
                None => self.coordinate(at, joint),
            },
            Subject::Coordinate(joint, order) => self.coordinate_rate(at, joint, order),
            Subject::Torque(motor) => at.torques.as_ref()?.get(motor.index()).copied(),
            Subject::Reaction(joint, part) => {
                let number = self.model.declared_joints().position(|one| one == joint)?;
                let reaction = *at.forces.as_ref()?.reactions.get(number)?;
                Some(part_of_reaction(reaction, part))
            }
            Subject::Ground(part) => Some(part_of_reaction(self.on_ground(at, true)?, part)),
            Subject::Shaking(part) => Some(part_of_reaction(self.on_ground(at, false)?, part)),
            Subject::Advantage(load, motor) => self.advantage(at, load, motor),
            Subject::Transmission(dyad) => at.forces.as_ref()?.transmission.get(dyad).copied(),
            Subject::Pressure(cam) => Some(self.contact(at, moment, cam)?.pressure),
            Subject::Curvature(cam) => Some(self.contact(at, moment, cam)?.curvature),
            Subject::Time => Some(moment.time),
        }
    }

    /// The place in the scene at which two links move as one; none if they turn at the same rate, as it is at infinity then.
    fn centre(&self, at: &Position, links: [LinkId; 2]) -> Option<[f64; 2]> {
        let [first, second] = links.map(|link| at.motion(self.compiled, link));
        first?.centre(second?)
    }

    /// What the ground gets: what accelerates the masses is set against that, and, unless only that is asked for, weights and loads.
    fn on_ground(&self, at: &Position, is_whole: bool) -> Option<[f64; 3]> {
        let rates = at.with_rates(at.pushed.clone()?);
        let mut sum = [0.0; 3];
        let mut add = |[x, y]: [f64; 2], place: [f64; 2], torque: f64| {
            let moment = cross(place, [x, y]) + torque;
            for (sum, part) in sum.iter_mut().zip([x, y, moment]) {
                *sum += part;
            }
        };
        let actions = &self.model.actions;
        let gravity = actions.gravity.filter(|_| is_whole).unwrap_or_default();
        for link in self.model.declared_links() {
            let Some(mass) = self.model.link(link).mass else {
                continue;
            };
            let pose = rates.pose(self.compiled, link)?;
            let place = place_of(self.model.precision, pose.into(), mass.center);
            let order = Order::Acceleration;
            let [x, y] = rates.vector(self.compiled, link, place, order)?;
            let [turning, ..] = rates.rate(self.compiled, link, order)?;
            let force = [gravity[0] - x, gravity[1] - y].map(|part| part * mass.mass);
            add(force, place, -mass.inertia * turning);
        }
        for (load, numbers) in load_parts(self.model, &self.loads).filter(|_| is_whole) {
            match (load.kind, numbers) {
                (LoadKind::Force(point), &[x, y]) => {
                    add([x, y], self.point(at, point, Order::Place)?, 0.0);
                }
                (LoadKind::Torque(_), &[torque]) => add([0.0; 2], [0.0; 2], torque),
                _ => return None,
            }
        }
        Some(sum)
    }

    /// What a load gets for what a motor gives: one divided by the velocity ratio in the direction of the load.
    fn advantage(&self, at: &Position, load: usize, motor: MotorId) -> Option<f64> {
        let alone = at.with_rates(at.influences.get(&motor)?.clone());
        let (load, numbers) = load_parts(self.model, &self.loads).nth(load)?;
        let ratio = match (load.kind, numbers) {
            (LoadKind::Force(point), &[x, y]) => {
                let velocity = self.point(&alone, point, Order::Velocity)?;
                dot(velocity, [x, y]) / x.hypot(y)
            }
            (LoadKind::Torque(link), _) => alone.rate(self.compiled, link, Order::Velocity)?[0],
            _ => return None,
        };
        Some(ratio.recip())
    }

    /// The contact of a cam and its roller.
    fn contact(&self, at: &Position, moment: &Moment, cam: JointId) -> Option<CamNumbers> {
        let JointKind::Cam { shaft, .. } = self.model.joint(cam).kind else {
            return None;
        };
        let shaft = self.value(at, moment, Subject::Coordinate(shaft, Order::Place))?;
        Some(self.contacts.get(&cam)?.at(shaft))
    }

    /// The angle of a link over whole turns.
    fn angle(&self, at: &Position, link: LinkId) -> Option<f64> {
        let heading = at.heading(self.compiled, link)?;
        let chain = self.chains.get(&link)?;
        Some(chain.whole(self.model, self.compiled, at, heading))
    }

    /// A point in the scene, or its velocity or acceleration.
    fn point(&self, at: &Position, point: AxisId, order: Order) -> Option<[f64; 2]> {
        let axis = self.model.axis(point);
        let pose = at.pose(self.compiled, axis.link)?;
        if order == Order::Place {
            return Some(place_of(self.model.precision, pose.into(), axis.at));
        }
        let [turning, x, y] = at.rate(self.compiled, axis.link, Order::Velocity)?;
        let angular = turning;
        if order == Order::Velocity {
            return Some(Velocity { angular, x, y }.of_point(pose, axis.at));
        }
        let [angular, x, y] = at.rate(self.compiled, axis.link, Order::Acceleration)?;
        Some(Acceleration { angular, x, y }.of_point(pose, turning, axis.at))
    }

    /// The direction of an axis in the scene.
    fn direction(&self, at: &Position, id: AxisId) -> Option<[f64; 2]> {
        let axis = self.model.axis(id);
        Some(at.pose(self.compiled, axis.link)?.turn(axis.direction))
    }

    fn coordinate(&self, at: &Position, joint: JointId) -> Option<f64> {
        let [a, b] = self.axes(joint)?;
        let along = self.direction(at, a)?;
        if let Some(angle) = whole_angle(self.model, self.compiled, at, joint) {
            return Some(angle);
        }
        if let JointKind::Revolute(..) = self.model.joint(joint).kind {
            let to = self.direction(at, b)?;
            return Some(cross(along, to).atan2(dot(along, to)));
        }
        let [from, to] = [
            self.point(at, a, Order::Place)?,
            self.point(at, b, Order::Place)?,
        ];
        Some(dot([to[0] - from[0], to[1] - from[1]], along))
    }

    fn coordinate_rate(&self, at: &Position, joint: JointId, order: Order) -> Option<f64> {
        let [a, b] = self.axes(joint)?;
        let [guide, other] = [a, b].map(|id| self.model.axis(id).link);
        let turning = |order| {
            Some(
                at.rate(self.compiled, other, order)?[0] - at.rate(self.compiled, guide, order)?[0],
            )
        };
        if let JointKind::Revolute(..) = self.model.joint(joint).kind {
            return turning(order);
        }
        // Along the guide as seen from it: the guide's own turning is taken out.
        let along = self.direction(at, a)?;
        let across = [-along[1], along[0]];
        let between = |order| {
            let [from, to] = [self.point(at, a, order)?, self.point(at, b, order)?];
            Some([to[0] - from[0], to[1] - from[1]])
        };
        let spin = at.rate(self.compiled, guide, Order::Velocity)?[0];
        let (apart, speed) = (between(Order::Place)?, between(Order::Velocity)?);
        if order == Order::Velocity {
            return Some(dot(speed, along) + spin * dot(apart, across));
        }
        let change = at.rate(self.compiled, guide, Order::Acceleration)?[0];
        let second = between(Order::Acceleration)?;
        Some(
            dot(second, along) + 2.0 * spin * dot(speed, across) + change * dot(apart, across)
                - spin * spin * dot(apart, along),
        )
    }

    /// The axes between which a coordinate is measured.
    fn axes(&self, joint: JointId) -> Option<[AxisId; 2]> {
        let axes = self.model.joint(joint).kind.axes()?;
        Some(axes.map(|axis| self.model.seen_axis(axis)))
    }
}

/// All loads, with their numbers.
fn load_parts<'m>(
    model: &'m Model,
    numbers: &'m [f64],
) -> impl Iterator<Item = (&'m ModelLoad, &'m [f64])> {
    let loads = model.actions.numbered_loads();
    loads.map(|(first, load)| (load, &numbers[first..first + load.kind.numbers()]))
}

/// Counts the transmission angles that are computed.
fn transmissions(compiled: &Compiled) -> usize {
    let program = compiled.forced.inverse_dynamics.as_ref();
    match program.and_then(Program::forces) {
        Some(Forces::InverseDynamics(found)) => found.transmission.len(),
        _ => 0,
    }
}

fn part_of_reaction([x, y, torque]: [f64; 3], part: Reaction) -> f64 {
    match part {
        Reaction::Force(part) => part_of([x, y], part),
        Reaction::Torque => torque,
    }
}

fn part_of([x, y]: [f64; 2], part: Part) -> f64 {
    match part {
        Part::X => x,
        Part::Y => y,
        Part::Norm => x.hypot(y),
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
