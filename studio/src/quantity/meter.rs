//! A mechanism that moves and is measured.

use super::needs::Needs;
use super::position::{Position, torques};
use super::turning::{Chain, whole_angle};
use crate::failure::Failure;
use crate::motion::{Moment, Mover, obstacle, place_of};
use mech_compiler::Compiled;
use mech_compiler::evaluate::Stop;
use mech_compiler::model::{
    AxisId, AxisKind, FormulaId, JointId, JointKind, LinkId, LoadKind, Measurand, Measured, Model,
    MotorId, Quantity, Rate, ReactionPart, Spot,
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
    /// A mechanism that is compiled for these measurands, with the numbers of all its loads.
    pub(super) fn new(
        model: &'a Model,
        compiled: &'a Compiled,
        measurands: &[Measurand],
        loads: Vec<f64>,
    ) -> Result<Self, Failure> {
        for measurand in measurands {
            refuse(model, compiled, measurand, &loads)?;
        }
        let quantities = || measurands.iter().flat_map(quantities);
        let contacts = quantities().filter_map(|quantity| match quantity {
            Quantity::Pressure(cam) | Quantity::Curvature(cam) => {
                Some((cam, CamContact::new(model, &compiled.program, cam)?))
            }
            _ => None,
        });
        let mut meter = Self::of_needs(model, compiled, &Needs::of(measurands), loads);
        meter.contacts = contacts.collect();
        Ok(meter)
    }

    /// A mechanism that is compiled for these needs, with the numbers of all its loads.
    pub(super) fn of_needs(
        model: &'a Model,
        compiled: &'a Compiled,
        needs: &Needs,
        loads: Vec<f64>,
    ) -> Self {
        let forced = compiled.forced.inverse_dynamics.as_ref();
        let inertia = compiled.forced.inertia.as_ref();
        let start = Position::of(&Mover::new(model, compiled).position());
        let chains = needs.links.iter().filter_map(|&link| {
            let heading = start.heading(compiled, link)?;
            let chain = Chain::to(model, link).from(model, compiled, &start, heading);
            Some((link, chain))
        });
        let mover = |program| Mover::of(model, program);
        Self {
            contacts: BTreeMap::new(),
            model,
            compiled,
            chains: chains.collect(),
            moving: compiled.moving.as_ref().map(mover),
            forced: forced.filter(|_| needs.force).map(mover),
            inertia: inertia.filter(|_| needs.force && forced.is_none()).map(mover),
            loads,
        }
    }

    /// The values of all measurands where the mechanism is, in radians and scene units: velocities at one moment, forces as at another that
    /// has other rates.
    pub(super) fn read(
        &mut self,
        at: &program::Position<f64>,
        moments: [&Moment; 2],
        measurands: &[Measurand],
    ) -> Result<Vec<Option<f64>>, Failure> {
        let mut position = self.position(at, moments)?;
        let quantities = || measurands.iter().flat_map(quantities);
        if quantities().any(|one| matches!(one, Quantity::Ground(_) | Quantity::Shaking(_))) {
            position.pushed = self.rates(at, moments[1].rates.each_ref().map(Vec::as_slice));
        }
        let influences = measurands.iter().flat_map(Measurand::own);
        let influences = influences.filter_map(|one| match one {
            Measured::Influence(_, motor) | Measured::Quantity(Quantity::Advantage(_, motor)) => {
                Some(*motor)
            }
            _ => None,
        });
        for motor in influences {
            let rest = vec![0.0; self.model.motors.len()];
            let mut alone = rest.clone();
            alone[motor.index()] = 1.0;
            let moved = self.rates(at, [&alone, &rest]);
            position.influences.extend(moved.map(|rates| (motor, rates)));
        }
        let values = measurands.iter().map(|measurand| {
            let value = self.value(&position, moments[0], measurand);
            value.filter(|value| value.is_finite())
        });
        Ok(values.collect())
    }

    /// The rates of all links where the mechanism is, if its motors have these; none where they are not determined.
    fn rates(
        &mut self,
        at: &program::Position<f64>,
        motors: [&[f64]; 2],
    ) -> Option<program::LinkRates<f64>> {
        let machine = self.moving.as_mut()?;
        machine.put_back(at);
        machine.motion(motors).ok()
    }

    /// Where the mechanism is, with its rates and forces.
    pub(super) fn position<'m>(
        &mut self,
        at: &program::Position<f64>,
        [moment, pushed]: [&'m Moment; 2],
    ) -> Result<Position, Failure> {
        let mut position = Position::of(at);
        let rates = |moment: &'m Moment| moment.rates.each_ref().map(Vec::as_slice);
        position.rates = self.rates(at, rates(moment));
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
                    return Err(Failure::mechanism(format!("forces cannot be computed: {why}")));
                }
            }
        }
        Ok(position)
    }

    /// The value of a measurand; none where it is not determined.
    fn value(&self, at: &Position, moment: &Moment, measurand: &Measurand) -> Option<f64> {
        let own = measurand.formulas().variables(measurand.subject());
        let mut variables = vec![f64::NAN; measurand.measured().len()];
        for number in own {
            variables[number] = match measurand.measured()[number] {
                Measured::Quantity(quantity) => self.quantity(at, moment, quantity)?,
                Measured::Rate(rate, of) => {
                    let [number] = measurand.formulas().variables(of)[..] else {
                        return None;
                    };
                    self.rate(at, measurand.measured()[number].quantity()?, rate)?
                }
                Measured::Influence(of, motor) => {
                    self.influence(at, moment, measurand, (of, motor))?
                }
                Measured::Summary(..) => return None,
            };
        }
        Some(measurand.value(&variables))
    }

    /// The slope of a formula by a motor, while all others stand.
    fn influence(
        &self,
        at: &Position,
        moment: &Moment,
        measurand: &Measurand,
        (of, motor): (FormulaId, MotorId),
    ) -> Option<f64> {
        let alone = at.with_rates(at.influences.get(&motor)?.clone());
        let mut variables = vec![(f64::NAN, f64::NAN); measurand.measured().len()];
        for number in measurand.formulas().variables(of) {
            let quantity = measurand.measured()[number].quantity()?;
            let value = self.quantity(at, moment, quantity)?;
            variables[number] = (value, self.rate(&alone, quantity, Rate::Velocity)?);
        }
        Some(measurand.slope(of, &variables))
    }

    fn quantity(&self, at: &Position, moment: &Moment, quantity: Quantity) -> Option<f64> {
        match quantity {
            Quantity::X(point) => Some(self.place(at, point)?[0]),
            Quantity::Y(point) => Some(self.place(at, point)?[1]),
            Quantity::Distance(ends) => self.distance(at, ends),
            Quantity::Clearance(links) => {
                let pose = |link| {
                    let pose = at.pose(self.compiled, link)?;
                    Some([pose.cos, pose.sin, pose.x, pose.y])
                };
                clearance(self.model, links, [pose(links[0])?, pose(links[1])?])
            }
            Quantity::Angle(link) => self.angle(at, link),
            Quantity::AngleBetween([from, to]) => Some(self.angle(at, to)? - self.angle(at, from)?),
            Quantity::CentreX(links) => Some(self.centre(at, links)?[0]),
            Quantity::CentreY(links) => Some(self.centre(at, links)?[1]),
            Quantity::Coordinate(joint) => match self.model.motor_of(joint) {
                Some(motor) => Some(moment.values[motor.index()]),
                None => self.coordinate(at, joint),
            },
            Quantity::Torque(motor) => at.torques.as_ref()?.get(motor.index()).copied(),
            Quantity::Power(motor) => {
                let torque = at.torques.as_ref()?.get(motor.index())?;
                Some(torque * moment.rates[0][motor.index()])
            }
            Quantity::Reaction(joint, part) => {
                let number = self.model.declared_joints().position(|one| one == joint)?;
                Some(part_of(*at.forces.as_ref()?.reactions.get(number)?, part))
            }
            Quantity::Ground(part) => Some(part_of(self.on_ground(at, true)?, part)),
            Quantity::Shaking(part) => Some(part_of(self.on_ground(at, false)?, part)),
            Quantity::Advantage(load, motor) => self.advantage(at, load, motor),
            Quantity::Transmission(joint) => {
                let dyad = self.compiled.plan.number_of_loop(joint?)?;
                at.forces.as_ref()?.transmission.get(dyad).copied()
            }
            Quantity::Pressure(cam) => Some(self.contact(at, moment, cam)?.pressure),
            Quantity::Curvature(cam) => Some(self.contact(at, moment, cam)?.curvature),
            Quantity::Time => Some(moment.time),
        }
    }

    /// The derivative by the time of a place, an angle, a coordinate or a distance.
    fn rate(&self, at: &Position, quantity: Quantity, rate: Rate) -> Option<f64> {
        let turning = |link| Some(at.rate(self.compiled, link, rate)?[0]);
        match quantity {
            Quantity::X(point) => Some(self.rate_of_point(at, point, rate)?[0]),
            Quantity::Y(point) => Some(self.rate_of_point(at, point, rate)?[1]),
            Quantity::Angle(link) => turning(link),
            Quantity::AngleBetween([from, to]) => Some(turning(to)? - turning(from)?),
            Quantity::Coordinate(joint) => self.coordinate_rate(at, joint, rate),
            Quantity::Distance(ends) => self.distance_rate(at, ends),
            _ => None,
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
            let rate = Rate::Acceleration;
            let [x, y] = rates.vector(self.compiled, link, place, rate)?;
            let [turning, ..] = rates.rate(self.compiled, link, rate)?;
            let force = [gravity[0] - x, gravity[1] - y].map(|part| part * mass.mass);
            add(force, place, -mass.inertia * turning);
        }
        for (load, numbers) in self.model.actions.loads_with(&self.loads).filter(|_| is_whole) {
            match (load.kind, numbers) {
                (LoadKind::Force(point), &[x, y]) => {
                    add([x, y], self.place(at, point)?, 0.0);
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
        let mut loads = self.model.actions.loads_with(&self.loads);
        let (load, numbers) = loads.nth(load)?;
        let ratio = match (load.kind, numbers) {
            (LoadKind::Force(point), &[x, y]) => {
                let velocity = self.rate_of_point(&alone, point, Rate::Velocity)?;
                dot(velocity, [x, y]) / x.hypot(y)
            }
            (LoadKind::Torque(link), _) => alone.rate(self.compiled, link, Rate::Velocity)?[0],
            _ => return None,
        };
        Some(ratio.recip())
    }

    /// The contact of a cam and its roller.
    fn contact(&self, at: &Position, moment: &Moment, cam: JointId) -> Option<CamNumbers> {
        let JointKind::Cam { shaft, .. } = self.model.joint(cam).kind else {
            return None;
        };
        let shaft = self.quantity(at, moment, Quantity::Coordinate(shaft))?;
        Some(self.contacts.get(&cam)?.at(shaft))
    }

    /// The angle of a link over whole turns.
    fn angle(&self, at: &Position, link: LinkId) -> Option<f64> {
        let heading = at.heading(self.compiled, link)?;
        let chain = self.chains.get(&link)?;
        Some(chain.whole(self.model, self.compiled, at, heading))
    }

    /// The place of a point in the scene.
    fn place(&self, at: &Position, point: AxisId) -> Option<[f64; 2]> {
        let axis = self.model.axis(point);
        let pose = at.pose(self.compiled, axis.link)?;
        Some(place_of(self.model.precision, pose.into(), axis.at))
    }

    /// The velocity or acceleration of a point.
    fn rate_of_point(&self, at: &Position, point: AxisId, rate: Rate) -> Option<[f64; 2]> {
        let axis = self.model.axis(point);
        let pose = at.pose(self.compiled, axis.link)?;
        let [turning, x, y] = at.rate(self.compiled, axis.link, Rate::Velocity)?;
        let angular = turning;
        if rate == Rate::Velocity {
            return Some(Velocity { angular, x, y }.of_point(pose, axis.at));
        }
        let [angular, x, y] = at.rate(self.compiled, axis.link, Rate::Acceleration)?;
        Some(Acceleration { angular, x, y }.of_point(pose, turning, axis.at))
    }

    /// The distance of two places, or of a place and a line.
    fn distance(&self, at: &Position, ends: [Spot; 2]) -> Option<f64> {
        let [from, to] = ends.map(|end| match end {
            Spot::Axis(axis) => self.place(at, axis),
            Spot::At(place) => Some(place),
        });
        let between = difference([from?, to?]);
        Some(match self.line_of(ends) {
            Some(line) => cross(self.direction(at, line)?, between).abs(),
            None => between[0].hypot(between[1]),
        })
    }

    /// The line, if a distance is that of one.
    fn line_of(&self, ends: [Spot; 2]) -> Option<AxisId> {
        ends.into_iter().find_map(|end| match end {
            Spot::Axis(axis) => (self.model.axis(axis).kind == AxisKind::Line).then_some(axis),
            Spot::At(_) => None,
        })
    }

    /// How fast a distance changes.
    fn distance_rate(&self, at: &Position, ends: [Spot; 2]) -> Option<f64> {
        let [from, to] = ends.map(|end| match end {
            Spot::Axis(axis) => {
                Some((self.place(at, axis)?, self.rate_of_point(at, axis, Rate::Velocity)?))
            }
            Spot::At(place) => Some((place, [0.0; 2])),
        });
        let ((from, from_rate), (to, to_rate)) = (from?, to?);
        let (between, rate) = (difference([from, to]), difference([from_rate, to_rate]));
        let Some(line) = self.line_of(ends) else {
            return Some(dot(between, rate) / between[0].hypot(between[1]));
        };
        let along = self.direction(at, line)?;
        let [turning, ..] = at.rate(self.compiled, self.model.axis(line).link, Rate::Velocity)?;
        let turned = [-turning * along[1], turning * along[0]];
        let sense = cross(along, between).signum();
        Some(sense * (cross(turned, between) + cross(along, rate)))
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
        let between = difference([self.place(at, a)?, self.place(at, b)?]);
        Some(dot(between, along))
    }

    fn coordinate_rate(&self, at: &Position, joint: JointId, rate: Rate) -> Option<f64> {
        let [a, b] = self.axes(joint)?;
        let [guide, other] = [a, b].map(|id| self.model.axis(id).link);
        if let JointKind::Revolute(..) = self.model.joint(joint).kind {
            return self.rate(at, Quantity::AngleBetween([guide, other]), rate);
        }
        // Along the guide as seen from it: the guide's own turning is taken out.
        let along = self.direction(at, a)?;
        let across = [-along[1], along[0]];
        let between = |rate| {
            let [from, to] = [a, b].map(|end| self.rate_of_point(at, end, rate));
            Some(difference([from?, to?]))
        };
        let spin = at.rate(self.compiled, guide, Rate::Velocity)?[0];
        let apart = difference([self.place(at, a)?, self.place(at, b)?]);
        let speed = between(Rate::Velocity)?;
        if rate == Rate::Velocity {
            return Some(dot(speed, along) + spin * dot(apart, across));
        }
        let change = at.rate(self.compiled, guide, Rate::Acceleration)?[0];
        let second = between(Rate::Acceleration)?;
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

/// Counts the transmission angles that are computed.
fn transmissions(compiled: &Compiled) -> usize {
    let program = compiled.forced.inverse_dynamics.as_ref();
    match program.and_then(Program::forces) {
        Some(Forces::InverseDynamics(found)) => found.transmission.len(),
        _ => 0,
    }
}

fn part_of([x, y, torque]: [f64; 3], part: ReactionPart) -> f64 {
    match part {
        ReactionPart::X => x,
        ReactionPart::Y => y,
        ReactionPart::Torque => torque,
    }
}

/// Complains where equilibrium does not determine the forces within a mechanism.
pub(super) fn needs_reactions(compiled: &Compiled) -> Result<(), Failure> {
    if compiled.forced.inverse_dynamics.is_some() {
        return Ok(());
    }
    Err(Failure::mechanism(
        "reactions are not determined: joints of the mechanism are redundant; torques of motors are",
    ))
}

/// All quantities of a measurand.
fn quantities(measurand: &Measurand) -> impl Iterator<Item = Quantity> {
    measurand.measured().iter().filter_map(Measured::quantity)
}

/// Complains about what this mechanism does not tell.
fn refuse(
    model: &Model,
    compiled: &Compiled,
    measurand: &Measurand,
    loads: &[f64],
) -> Result<(), Failure> {
    let is_angle = |one: Quantity| matches!(one, Quantity::Transmission(_));
    let is_within = |one| is_angle(one) || matches!(one, Quantity::Reaction(..));
    if quantities(measurand).any(is_within) {
        needs_reactions(compiled)?;
    }
    let loads_of_advantages = quantities(measurand).filter_map(|one| match one {
        Quantity::Advantage(load, _) => model.actions.loads_with(loads).nth(load),
        _ => None,
    });
    for (load, numbers) in loads_of_advantages {
        if numbers == [0.0, 0.0] {
            return Err(Failure::usage(format!(
                "an advantage is that over a load in its direction: `--load {}=1,0`",
                load.name
            )));
        }
    }
    if quantities(measurand).any(is_angle)
        && transmissions(compiled) != compiled.plan.loops().count()
    {
        return Err(Failure::mechanism(
            "there is no transmission angle for each loop: some loops are solved together",
        ));
    }
    let has_rate = |number: &usize| {
        let quantity = measurand.measured()[*number].quantity();
        matches!(
            quantity,
            Some(
                Quantity::X(_)
                    | Quantity::Y(_)
                    | Quantity::Angle(_)
                    | Quantity::AngleBetween(_)
                    | Quantity::Coordinate(_)
                    | Quantity::Distance(_)
            )
        )
    };
    for measured in measurand.own() {
        if let Measured::Influence(of, _) = measured
            && !measurand.formulas().variables(*of).iter().all(has_rate)
        {
            return Err(Failure::usage(format!(
                "`{}`: a table has the influence on places, distances, angles and coordinates; `expect` tells that on the rest",
                measurand.name
            )));
        }
    }
    Ok(())
}

/// The way from one place to another.
fn difference([from, to]: [[f64; 2]; 2]) -> [f64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
