//! Measures quantities while a mechanism moves.

use super::Units;
use super::kind::{Needs, Order, Part, Quantity, Reaction, Spot, Subject};
use super::load::{self, Load};
use super::position::{Position, torques};
use super::turning::{Chain, whole_angle};
use crate::failure::Failure;
use crate::motion::{Drive, Moment, Mover, PlaneMotion, obstacle, place_of, turns};
use mech_compiler::evaluate::Stop;
use mech_compiler::model::{AxisId, JointId, JointKind, LinkId, Model, Precision};
use mech_compiler::program::{self, CamContact, CamNumbers, Forces, Program, clearance};
use mech_compiler::{Compiled, compile};
use mech_runtime::{Acceleration, Velocity};
use std::collections::BTreeMap;
use std::ops::Range;

/// A table of measurements: a row for each position.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Table {
    /// The name and the unit of each column. The first is what the mechanism is driven by.
    pub(crate) columns: Vec<(String, String)>,
    /// The values of each row, in these units; none where a value is not determined, as a velocity at a dead point.
    pub(crate) rows: Vec<Vec<Option<f64>>>,
    /// The number of the column over which the others are shown: the first, or the second.
    pub(crate) across: usize,
    pub(crate) precision: Precision,
}

impl Table {
    /// The numbers of the columns that are shown over that.
    pub(crate) fn curves(&self) -> Range<usize> {
        self.across + 1..self.columns.len()
    }

    /// Whether what has this unit is shown over the same unit, as the path of a point is: then both axes have one scale. Angles of links say
    /// nothing by their shape.
    pub(crate) fn is_path(&self, unit: &str) -> bool {
        self.across > 0 && self.columns[self.across].1 == unit && unit != "deg"
    }
}

/// A motion that is measured.
pub(crate) struct Measurement<'a> {
    pub(crate) model: &'a Model,
    pub(crate) drive: &'a Drive,
    /// Over what the others are shown, if not over what the mechanism is driven by.
    pub(crate) over: Option<Quantity>,
    /// The speed of its motor, in radians or scene units per second: without it, velocities are those at 1, and forces those at rest.
    pub(crate) rate: Option<f64>,
    /// The number of steps: there is a row more.
    pub(crate) steps: u32,
    /// The loads that are not zero.
    pub(crate) loads: &'a [Load],
    pub(crate) units: &'a Units,
}

/// Measures quantities through a motion, in the precision of the mechanism.
pub(crate) fn measure(of: &Measurement<'_>, quantities: &[Quantity]) -> Result<Table, Failure> {
    let quantities: Vec<Quantity> = of.over.iter().chain(quantities).cloned().collect();
    let prepared = Prepared::new(of, &quantities)?;
    let parts = of.parts();
    let rows = of.drive.attempt(|drive| prepared.rows(drive, &parts))?;
    Ok(Table {
        columns: columns(of, &quantities),
        rows,
        across: usize::from(of.over.is_some()),
        precision: of.model.precision,
    })
}

impl Measurement<'_> {
    /// The parts of the motion at which it is measured, 0 to 1.
    pub(super) fn parts(&self) -> Vec<f64> {
        let parts = (0..=self.steps).map(|step| f64::from(step) / f64::from(self.steps.max(1)));
        parts.collect()
    }
}

/// A mechanism that is compiled for what is measured.
pub(super) struct Prepared<'a> {
    of: &'a Measurement<'a>,
    quantities: &'a [Quantity],
    model: Model,
    compiled: Compiled,
}

impl<'a> Prepared<'a> {
    pub(super) fn new(
        of: &'a Measurement<'a>,
        quantities: &'a [Quantity],
    ) -> Result<Self, Failure> {
        let model = with_needs(of.model, quantities);
        Ok(Self {
            compiled: compiled_for(&model)?,
            of,
            quantities,
            model,
        })
    }

    /// What drives it and all quantities in these parts of a motion, a row for each.
    pub(super) fn rows(
        &self,
        drive: &Drive,
        parts: &[f64],
    ) -> Result<Vec<Vec<Option<f64>>>, Failure> {
        let Self {
            of,
            quantities,
            model,
            compiled,
        } = self;
        let mut meter = Meter::new(of, model, compiled, quantities)?;
        let mut rows = vec![Vec::new(); parts.len()];
        drive.visit(model, compiled, parts, |number, at| {
            let moment = drive.moment(model, compiled, parts[number], of.rate.unwrap_or(1.0));
            let pushed = drive.moment(model, compiled, parts[number], of.rate.unwrap_or(0.0));
            let values = meter.read(at, [&moment, &pushed], quantities)?;
            let shown = quantities.iter().zip(values).map(|(quantity, value)| {
                value.map(|value| of.units.shown(model, quantity.subject, value))
            });
            rows[number] = std::iter::once(Some(driver(of, moment.by)))
                .chain(shown)
                .collect();
            Ok(())
        })?;
        Ok(rows)
    }
}

/// Converts the value that drives the mechanism to the unit in which it is shown.
fn driver(of: &Measurement<'_>, value: f64) -> f64 {
    match of.drive.motor() {
        Some(motor) => {
            let joint = of.model.motor(motor).joint;
            let subject = Subject::Coordinate(joint, Order::Place);
            of.units.shown(of.model, subject, value)
        }
        None => value,
    }
}

pub(super) fn columns(of: &Measurement<'_>, quantities: &[Quantity]) -> Vec<(String, String)> {
    let unit = |subject| of.units.of(of.model, subject);
    let first = match of.drive.motor() {
        Some(motor) => {
            let joint = of.model.motor(motor).joint;
            let name = format!("motor {}", of.model.joint(joint).name);
            (name, unit(Subject::Coordinate(joint, Order::Place)))
        }
        None => ("t".to_owned(), "s".to_owned()),
    };
    let others = quantities.iter();
    let others = others.map(|quantity| {
        let name = format!("{}{}", quantity.name, assumed(of, quantity.subject));
        (name, unit(quantity.subject))
    });
    std::iter::once(first).chain(others).collect()
}

/// The rate of the motor for which a force holds, as words after its name.
fn assumed(of: &Measurement<'_>, subject: Subject) -> String {
    match (subject, of.drive.motor(), of.rate.unwrap_or(0.0)) {
        (Subject::Torque(_) | Subject::Reaction(..), Some(_), 0.0) => " at rest".to_owned(),
        (Subject::Torque(_) | Subject::Power(_) | Subject::Reaction(..), Some(_), rate) => {
            format!(" at rate {rate}")
        }
        _ => String::new(),
    }
}

/// A mechanism with everything shown that declares what is needed, whatever effects it has: angles go on over whole turns however long a
/// step is.
fn with_needs(model: &Model, quantities: &[Quantity]) -> Model {
    let mut whole = Model {
        show: None,
        ..model.clone()
    };
    Needs::of(quantities).add_to(&mut whole.effects);
    for quantity in quantities {
        whole.continuous.extend(quantity.joint());
        for link in quantity.turning_links() {
            whole.continuous.extend(Chain::to(model, link).joints());
        }
    }
    whole.continuous.retain(|&joint| turns(model, joint));
    whole.continuous.sort_unstable();
    whole.continuous.dedup();
    whole
}

/// The mechanism, compiled: where equilibrium does not determine the forces within it, with what virtual work tells of the motors.
fn compiled_for(model: &Model) -> Result<Compiled, Failure> {
    let compiled = compile(model).map_err(|diagnoses| {
        let texts = diagnoses
            .iter()
            .map(|diagnosis| mech_compiler::reporter::text(diagnosis, model));
        let texts: Vec<String> = texts.collect();
        Failure::mechanism(format!("that cannot be computed: {}", texts.join("\n")))
    })?;
    let forced = &compiled.forced;
    if !model.effects.force || forced.inverse_dynamics.is_some() || forced.inertia.is_some() {
        return Ok(compiled);
    }
    let mut moved = model.clone();
    moved.effects.dynamics = true;
    compiled_for(&moved)
}

/// A mechanism that moves and is measured.
struct Meter<'a> {
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
    fn new(
        of: &Measurement<'_>,
        model: &'a Model,
        compiled: &'a Compiled,
        quantities: &[Quantity],
    ) -> Result<Self, Failure> {
        let needs = Needs::of(quantities);
        let is_power = |one: &Quantity| matches!(one.subject, Subject::Power(_));
        if of.rate.is_none() && of.drive.motor().is_some() && quantities.iter().any(is_power) {
            return Err(Failure::usage(
                "a power needs the rate at which the motor moves: `--rate 1`",
            ));
        }
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
            loads: load::numbers(model, of.loads)?,
        })
    }

    /// The values of all quantities where the mechanism is, in radians and scene units: velocities at one moment, forces as at another that
    /// has other rates.
    fn read<'m>(
        &mut self,
        at: &program::Position<f64>,
        [moment, pushed]: [&'m Moment; 2],
        quantities: &[Quantity],
    ) -> Result<Vec<Option<f64>>, Failure> {
        let mut position = Position::of(at);
        let rates = |moment: &'m Moment| moment.rates.each_ref().map(Vec::as_slice);
        position.rates = self.moving.as_mut().and_then(|machine| {
            machine.put_back(at);
            machine.motion(rates(moment)).ok()
        });
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
        let values = quantities.iter().map(|quantity| {
            let value = self.value(&position, moment, quantity.subject);
            value.filter(|value| value.is_finite())
        });
        Ok(values.collect())
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
            Subject::Angle(link, order) => Some(self.rate(at, link, order)?[0]),
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
                let [x, y, torque] = *at.forces.as_ref()?.reactions.get(number)?;
                Some(match part {
                    Reaction::Force(part) => part_of([x, y], part),
                    Reaction::Torque => torque,
                })
            }
            Subject::Transmission(dyad) => at.forces.as_ref()?.transmission.get(dyad).copied(),
            Subject::Pressure(cam) => Some(self.contact(at, moment, cam)?.pressure),
            Subject::Curvature(cam) => Some(self.contact(at, moment, cam)?.curvature),
            Subject::Time => Some(moment.time),
        }
    }

    /// The place in the scene at which two links move as one; none if they turn at the same rate, as it is at infinity then.
    fn centre(&self, at: &Position, links: [LinkId; 2]) -> Option<[f64; 2]> {
        let mut motions = [PlaneMotion::default(); 2];
        for (motion, link) in motions.iter_mut().zip(links) {
            let pose = at.pose(self.compiled, link)?;
            *motion = PlaneMotion::new(self.rate(at, link, Order::Velocity)?, pose);
        }
        let [first, second] = motions;
        first.centre(second)
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

    /// The angular rate of a link, and those of x and y.
    fn rate(&self, at: &Position, link: LinkId, order: Order) -> Option<[f64; 3]> {
        if link == LinkId::GROUND {
            return Some([0.0; 3]);
        }
        let place = self.compiled.program.place_of(link)?;
        let rates = at.rates.as_ref()?;
        let all = match order {
            Order::Velocity => &rates.velocities,
            _ => rates.accelerations.as_ref()?,
        };
        all.get(place).copied()
    }

    /// A point in the scene, or its velocity or acceleration.
    fn point(&self, at: &Position, point: AxisId, order: Order) -> Option<[f64; 2]> {
        let axis = self.model.axis(point);
        let pose = at.pose(self.compiled, axis.link)?;
        if order == Order::Place {
            return Some(place_of(self.model.precision, pose.into(), axis.at));
        }
        let [turning, x, y] = self.rate(at, axis.link, Order::Velocity)?;
        let angular = turning;
        if order == Order::Velocity {
            return Some(Velocity { angular, x, y }.of_point(pose, axis.at));
        }
        let [angular, x, y] = self.rate(at, axis.link, Order::Acceleration)?;
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
        let turning =
            |order| Some(self.rate(at, other, order)?[0] - self.rate(at, guide, order)?[0]);
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
        let spin = self.rate(at, guide, Order::Velocity)?[0];
        let (apart, speed) = (between(Order::Place)?, between(Order::Velocity)?);
        if order == Order::Velocity {
            return Some(dot(speed, along) + spin * dot(apart, across));
        }
        let change = self.rate(at, guide, Order::Acceleration)?[0];
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

/// Counts the transmission angles that are computed.
fn transmissions(compiled: &Compiled) -> usize {
    let program = compiled.forced.inverse_dynamics.as_ref();
    match program.and_then(Program::forces) {
        Some(Forces::InverseDynamics(found)) => found.transmission.len(),
        _ => 0,
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
