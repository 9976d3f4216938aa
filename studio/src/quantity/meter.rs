//! Measures quantities while a mechanism moves.

use super::Units;
use super::kind::{Needs, Order, Part, Quantity, Reaction, Subject};
use super::load::{self, Load};
use crate::failure::Failure;
use crate::motion::{Drive, Moment, obstacle};
use mech_compiler::evaluate::{LinkRates, Machine};
use mech_compiler::model::{AxisId, JointId, JointKind, LinkId, Model};
use mech_compiler::program::{Forces, InverseDynamics};
use mech_compiler::{Compiled, compile};
use std::f64::consts::TAU;
use std::ops::Range;

/// What was measured: a row for each position.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Table {
    /// The name and the unit of each column. The first is what the mechanism is driven by.
    pub(crate) columns: Vec<(String, String)>,
    /// The values of each row, in these units; none where a value is not determined, as a velocity at a dead point.
    pub(crate) rows: Vec<Vec<Option<f64>>>,
    /// The number of the column over which the others are shown: the first, or the second.
    pub(crate) across: usize,
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
    /// How fast its motor moves, in radians or scene units per second.
    pub(crate) rate: f64,
    /// The number of steps: there is a row more.
    pub(crate) steps: u32,
    /// The loads that are not zero.
    pub(crate) loads: &'a [Load],
    pub(crate) units: &'a Units,
}

/// Measures quantities through a motion.
pub(crate) fn measure(of: &Measurement<'_>, quantities: &[Quantity]) -> Result<Table, Failure> {
    let quantities: Vec<Quantity> = of.over.iter().chain(quantities).cloned().collect();
    let quantities = &quantities;
    let needs = Needs::of(quantities);
    let compiled = &compiled_for(of.model, needs)?;
    let mut meter = Meter::new(of, compiled, quantities)?;
    let mut rows = Vec::new();
    for step in 0..=of.steps {
        let part = f64::from(step) / f64::from(of.steps.max(1));
        of.drive
            .move_to(of.model, compiled, &mut meter.machine, part)?;
        let moment = of.drive.moment(of.model, compiled, part, of.rate);
        let by = driver(of, moment.by);
        let mut row = vec![Some(by)];
        let values = meter.read(&moment, quantities)?;
        let shown = quantities.iter().zip(values).map(|(quantity, value)| {
            value.map(|value| of.units.shown(of.model, quantity.subject, value))
        });
        row.extend(shown);
        rows.push(row);
    }
    Ok(Table {
        columns: columns(of, quantities),
        rows,
        across: usize::from(of.over.is_some()),
    })
}

/// What the mechanism is driven by, as it is shown.
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

fn columns(of: &Measurement<'_>, quantities: &[Quantity]) -> Vec<(String, String)> {
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
    let others = others.map(|quantity| (quantity.name.clone(), unit(quantity.subject)));
    std::iter::once(first).chain(others).collect()
}

/// The mechanism with all that is needed, whatever effects it declares, and with everything shown.
fn compiled_for(model: &Model, needs: Needs) -> Result<Compiled, Failure> {
    let mut whole = Model {
        show: None,
        ..model.clone()
    };
    needs.add_to(&mut whole.effects);
    compile(&whole).map_err(|diagnoses| {
        let texts = diagnoses
            .iter()
            .map(|diagnosis| mech_compiler::reporter::text(diagnosis, &whole));
        let texts: Vec<String> = texts.collect();
        Failure::mechanism(format!("that cannot be computed: {}", texts.join("\n")))
    })
}

/// A mechanism that moves and is measured.
struct Meter<'a> {
    model: &'a Model,
    compiled: &'a Compiled,
    machine: Machine<'a, f64>,
    moving: Option<Machine<'a, f64>>,
    forced: Option<Machine<'a, f64>>,
    /// The numbers of all loads.
    loads: Vec<f64>,
    /// For each quantity its last value, from which an angle goes on over whole turns.
    last: Vec<Option<f64>>,
}

/// All that is known at a position.
struct Position<'p> {
    poses: &'p [[f64; 4]],
    rates: Option<LinkRates<f64>>,
    forces: Option<InverseDynamics<f64>>,
}

impl<'a> Meter<'a> {
    fn new(
        of: &Measurement<'a>,
        compiled: &'a Compiled,
        quantities: &[Quantity],
    ) -> Result<Self, Failure> {
        let needs = Needs::of(quantities);
        let forced = compiled.forced.inverse_dynamics.as_ref();
        if needs.force && forced.is_none() {
            return Err(Failure::mechanism(
                "forces are not determined: joints of the mechanism are redundant",
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
        Ok(Self {
            model: of.model,
            compiled,
            machine: Machine::new(&compiled.program),
            moving: compiled.moving.as_ref().map(Machine::new),
            forced: forced.filter(|_| needs.force).map(Machine::new),
            loads: load::numbers(of.model, of.loads)?,
            last: vec![None; quantities.len()],
        })
    }

    /// The values of all quantities where the mechanism is, in radians and scene units.
    fn read(
        &mut self,
        moment: &Moment,
        quantities: &[Quantity],
    ) -> Result<Vec<Option<f64>>, Failure> {
        let at = self.machine.position().clone();
        let [first, second] = &moment.rates;
        let rates = self.moving.as_mut().and_then(|machine| {
            machine.put_back(at.clone());
            machine.motion(first, second).ok()
        });
        let forces = match &mut self.forced {
            None => None,
            Some(machine) => {
                machine.put_back(at.clone());
                match machine.forces(first, second, &self.loads) {
                    Ok(Forces::InverseDynamics(found)) => Some(found),
                    // Not determined there.
                    Ok(_) | Err(mech_compiler::evaluate::Stop::Singular(_)) => None,
                    Err(stop) => {
                        let why = obstacle(self.model, self.compiled, stop);
                        return Err(Failure::mechanism(format!(
                            "forces cannot be computed: {why}"
                        )));
                    }
                }
            }
        };
        let position = Position {
            poses: &at.poses,
            rates,
            forces,
        };
        let mut values = Vec::new();
        for (number, quantity) in quantities.iter().enumerate() {
            let value = self.value(&position, moment, quantity.subject);
            let value = value.map(|value| self.unwrapped(quantity.subject, number, value));
            self.last[number] = value.or(self.last[number]);
            values.push(value.filter(|value| value.is_finite()));
        }
        Ok(values)
    }

    fn value(&self, at: &Position<'_>, moment: &Moment, subject: Subject) -> Option<f64> {
        match subject {
            Subject::Point(point, order, part) => {
                let vector = self.point(at, point, order)?;
                Some(part_of(vector, part))
            }
            Subject::Angle(link, Order::Place) => {
                let [cos, sin, ..] = self.pose(at, link)?;
                Some(sin.atan2(cos))
            }
            Subject::Angle(link, order) => Some(self.rate(at, link, order)?[0]),
            Subject::Coordinate(joint, Order::Place) => match self.model.motor_of(joint) {
                Some(motor) => Some(moment.values[motor.index()]),
                None => self.coordinate(at, joint),
            },
            Subject::Coordinate(joint, order) => self.coordinate_rate(at, joint, order),
            Subject::Torque(motor) => Some(at.forces.as_ref()?.torques[motor.index()]),
            Subject::Reaction(joint, part) => {
                let number = self.model.declared_joints().position(|one| one == joint)?;
                let [x, y, torque] = *at.forces.as_ref()?.reactions.get(number)?;
                Some(match part {
                    Reaction::Force(part) => part_of([x, y], part),
                    Reaction::Torque => torque,
                })
            }
            Subject::Transmission(dyad) => at.forces.as_ref()?.transmission.get(dyad).copied(),
            Subject::Time => Some(moment.time),
        }
    }

    /// An angle goes on from its last value by less than half a turn.
    fn unwrapped(&self, subject: Subject, number: usize, value: f64) -> f64 {
        let is_angle = match subject {
            Subject::Angle(_, Order::Place) => true,
            Subject::Coordinate(joint, Order::Place) => {
                let turns = matches!(self.model.joint(joint).kind, JointKind::Revolute(..));
                turns && self.model.motor_of(joint).is_none()
            }
            _ => false,
        };
        match self.last[number] {
            Some(last) if is_angle => value + TAU * ((last - value) / TAU).round(),
            _ => value,
        }
    }

    fn pose(&self, at: &Position<'_>, link: LinkId) -> Option<[f64; 4]> {
        if link == LinkId::GROUND {
            return Some([1.0, 0.0, 0.0, 0.0]);
        }
        let place = self.compiled.program.place_of(link)?;
        at.poses.get(place).copied()
    }

    /// The angular rate of a link, and those of x and y.
    fn rate(&self, at: &Position<'_>, link: LinkId, order: Order) -> Option<[f64; 3]> {
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
    fn point(&self, at: &Position<'_>, point: AxisId, order: Order) -> Option<[f64; 2]> {
        let axis = self.model.axis(point);
        let [cos, sin, x, y] = self.pose(at, axis.link)?;
        let arm = turned([cos, sin], axis.at);
        if order == Order::Place {
            return Some([x + arm[0], y + arm[1]]);
        }
        let [turning, u, v] = self.rate(at, axis.link, Order::Velocity)?;
        if order == Order::Velocity {
            return Some([u - turning * arm[1], v + turning * arm[0]]);
        }
        let [change, u, v] = self.rate(at, axis.link, Order::Acceleration)?;
        let square = turning * turning;
        Some([
            u - change * arm[1] - square * arm[0],
            v + change * arm[0] - square * arm[1],
        ])
    }

    /// The direction of an axis in the scene.
    fn direction(&self, at: &Position<'_>, id: AxisId) -> Option<[f64; 2]> {
        let axis = self.model.axis(id);
        let [cos, sin, ..] = self.pose(at, axis.link)?;
        Some(turned([cos, sin], axis.direction))
    }

    fn coordinate(&self, at: &Position<'_>, joint: JointId) -> Option<f64> {
        let [a, b] = self.axes(joint)?;
        let along = self.direction(at, a)?;
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

    fn coordinate_rate(&self, at: &Position<'_>, joint: JointId, order: Order) -> Option<f64> {
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

/// How many transmission angles are computed.
fn transmissions(compiled: &Compiled) -> usize {
    let program = compiled.forced.inverse_dynamics.as_ref();
    let motion = program.and_then(|program| program.motion.as_ref());
    match motion.and_then(|motion| motion.forces.as_ref()) {
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

fn turned([cos, sin]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    [cos * x - sin * y, sin * x + cos * y]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
