//! The operations that measure quantities of a position.

use super::GaugedAngle;
use crate::bug::bug;
use crate::model::{
    AxisId, AxisKind, Boundary, InputId, JointId, JointKind, LinkId, Model, MotorId, Quantity, Spot,
};
use crate::plan::{Algebra, Arithmetic, Dyad, Plan, Rational, Source, Step, float_of};
use crate::program::Program;
use crate::program::build::{Seed, Tangents};
use crate::program::builder::SsaBuilder;
use crate::program::clearance::{corners, gap};
use crate::program::contact::{Contact, Guide, Pressed};
use crate::program::forced::{Circumstances, Motion};
use crate::program::node::{Op, Value};

/// A program to which measures are added.
pub(super) struct Measures<'a> {
    pub(super) model: &'a Model,
    plan: &'a Plan,
    program: &'a Program,
    pub(super) ssa: SsaBuilder,
    pub(super) motion: &'a Motion<'a>,
    pub(super) angles: Vec<GaugedAngle>,
    /// The angles over whole turns that were measured, each with its direction.
    directions: Vec<(Value, [Value; 2])>,
    /// The values whose derivatives are taken.
    pub(super) differentiated: Vec<Value>,
}

impl<'a> Measures<'a> {
    pub(super) fn new(
        model: &'a Model,
        plan: &'a Plan,
        program: &'a Program,
        motion: &'a Motion<'a>,
    ) -> Self {
        Self {
            model,
            plan,
            program,
            ssa: SsaBuilder::resume_in(program, motion),
            motion,
            angles: Vec::new(),
            directions: Vec::new(),
            differentiated: Vec::new(),
        }
    }

    /// The derivative of a value, where motors move so.
    pub(super) fn rate(&mut self, value: Value, tangents: &mut Tangents) -> Value {
        self.differentiated.push(value);
        tangents.of_all_up_to(&mut self.ssa, value)
    }

    /// The rate at which a direction turns.
    pub(super) fn turning(&mut self, direction: [Value; 2], tangents: &mut Tangents) -> Value {
        for part in direction {
            self.rate(part, tangents);
        }
        tangents.angular_velocity(&mut self.ssa, direction)
    }

    /// The rates of what is measured while motors move.
    pub(super) fn by_time(&mut self) -> Tangents {
        let mut tangents = Tangents::new(self.motion.seed(), self.model.motors.len());
        if let Motion::InTime(laws) = self.motion {
            for following in &laws.motors {
                tangents.hold(following.value, following.rate);
                tangents.hold(following.rate, following.second);
            }
        }
        self.with_angles(tangents)
    }

    /// The rates of what is measured while one motor alone moves, at a rate of one.
    pub(super) fn by_motor(&mut self, motor: MotorId) -> Tangents {
        let mut tangents = Tangents::new(Seed::Alone(motor.index()), self.model.motors.len());
        if let Motion::InTime(laws) = self.motion {
            for following in &laws.motors {
                let is_moving = following.motor == motor;
                let rate = self.ssa.constant(if is_moving { 1.0 } else { 0.0 });
                tangents.hold(following.value, rate);
            }
        }
        self.with_angles(tangents)
    }

    /// The same, with the rates of angles. That of an angle is its direction's: whole turns have no part in it.
    fn with_angles(&mut self, mut tangents: Tangents) -> Tangents {
        for &(angle, direction) in &self.directions {
            for part in direction {
                tangents.of_all_up_to(&mut self.ssa, part);
            }
            let rate = tangents.angular_velocity(&mut self.ssa, direction);
            tangents.set(&mut self.ssa, angle, rate);
        }
        tangents
    }

    /// A quantity that no equilibrium tells.
    pub(super) fn quantity(
        &mut self,
        quantity: Quantity,
        circumstances: &Circumstances<'_>,
    ) -> Value {
        match quantity {
            Quantity::Coordinate(joint) => self.coordinate(joint),
            Quantity::Angle(link) => {
                let [cos, sin, ..] = self.pose(link);
                self.angle([cos, sin])
            }
            Quantity::AngleBetween(links) => {
                let [from, to] = links.map(|link| {
                    let [cos, sin, ..] = self.pose(link);
                    [cos, sin]
                });
                self.angle_from(from, to)
            }
            Quantity::X(axis) => self.point(axis)[0],
            Quantity::Y(axis) => self.point(axis)[1],
            Quantity::Distance(spots) => self.distance(spots),
            Quantity::CentreX(links) => self.centre(links)[0],
            Quantity::CentreY(links) => self.centre(links)[1],
            Quantity::Ground(part) => self.on_ground(part, true, circumstances),
            Quantity::Shaking(part) => self.on_ground(part, false, circumstances),
            Quantity::Advantage(load, motor) => self.advantage(load, motor, circumstances),
            Quantity::Transmission(_)
            | Quantity::Clearance(_)
            | Quantity::Torque(_)
            | Quantity::Power(_)
            | Quantity::Reaction(..)
            | Quantity::Time => {
                bug!("this is measured of a dyad, of a corner, of forces, or in a table")
            }
            Quantity::Pressure(cam) => {
                let pressed = self.pressed(cam);
                let ssa = &mut self.ssa;
                let (sine, cosine) = (ssa.abs(pressed.sine), ssa.abs(pressed.cosine));
                ssa.make(Op::Atan2(sine, cosine))
            }
            Quantity::Curvature(cam) => self.pressed(cam).curvature,
        }
    }

    pub(super) fn pose(&mut self, link: LinkId) -> [Value; 4] {
        if link == LinkId::GROUND {
            return [1.0, 0.0, 0.0, 0.0].map(|number| self.ssa.constant(number));
        }
        self.program.poses[self.program.pose_index(link)]
    }

    /// The place of an axis in the scene.
    pub(super) fn point(&mut self, axis: AxisId) -> [Value; 2] {
        let axis = self.model.axis(axis);
        self.carried(axis.link, axis.at)
    }

    /// The place in the scene of a place on a link.
    pub(super) fn carried(&mut self, link: LinkId, at: [f64; 2]) -> [Value; 2] {
        let [cos, sin, x, y] = self.pose(link);
        let arm = self.ssa.vector(at);
        let arm = self.ssa.rotate([cos, sin], arm);
        self.ssa.plus([x, y], arm)
    }

    /// The direction of an axis in the scene.
    fn direction(&mut self, axis: AxisId) -> [Value; 2] {
        let axis = self.model.axis(axis);
        let [cos, sin, ..] = self.pose(axis.link);
        let along = self.ssa.vector(axis.direction);
        self.ssa.rotate([cos, sin], along)
    }

    fn coordinate(&mut self, joint: JointId) -> Value {
        if let Some(motor) = self.model.motor_of(joint) {
            return self.ssa.make(Op::Input(InputId::of_motor(motor)));
        }
        let kind = self.model.joint(joint).kind;
        let Some(axes) = kind.axes() else {
            bug!("a joint without a coordinate is measured");
        };
        let [from, to] = axes.map(|axis| self.model.seen_axis(axis));
        let along = self.direction(from);
        if let JointKind::Revolute(..) = kind {
            let to = self.direction(to);
            let back = self.ssa.conjugate(along);
            let turn = self.ssa.rotate(back, to);
            let [cos, sin] = turn.map(|part| self.ssa.at_start(part));
            let meshed = self.meshed(axes, sin.atan2(cos));
            return meshed.unwrap_or_else(|| self.angle(turn));
        }
        let (from, to) = (self.point(from), self.point(to));
        let between = self.ssa.minus(to, from);
        let slide = self.ssa.dot(between, along);
        let start = self.ssa.at_start(slide);
        self.meshed(axes, start).unwrap_or(slide)
    }

    fn angle_from(&mut self, from: [Value; 2], to: [Value; 2]) -> Value {
        let back = self.ssa.conjugate(from);
        let turn = self.ssa.rotate(back, to);
        self.angle(turn)
    }

    /// The angle of a direction over whole turns.
    pub(super) fn angle(&mut self, direction: [Value; 2]) -> Value {
        let [cos, sin] = direction.map(|part| self.ssa.at_start(part));
        let reference = self.ssa.carry(sin.atan2(cos));
        let turn = [self.ssa.make(Op::Cos(reference.last)), self.ssa.make(Op::Sin(reference.last))];
        let back = self.ssa.conjugate(turn);
        let [cos, sin] = self.ssa.rotate(back, direction);
        let beyond = self.ssa.make(Op::Atan2(sin, cos));
        self.angles.push(GaugedAngle { reference: reference.index, beyond, is_measured: true });
        let angle = self.ssa.add(reference.last, beyond);
        self.directions.push((angle, direction));
        angle
    }

    fn distance(&mut self, [from, to]: [Spot; 2]) -> Value {
        let is_line = |spot: Spot| match spot {
            Spot::Axis(axis) => self.model.axis(axis).kind == AxisKind::Line,
            Spot::At(_) => false,
        };
        let line = [from, to].into_iter().find(|spot| is_line(*spot));
        let [from, to] = [from, to].map(|spot| match spot {
            Spot::Axis(axis) => self.point(axis),
            Spot::At(place) => self.ssa.vector(place),
        });
        let between = self.ssa.minus(to, from);
        if let Some(Spot::Axis(line)) = line {
            let along = self.direction(line);
            let across = self.ssa.cross(along, between);
            return self.ssa.abs(across);
        }
        let square = self.ssa.dot(between, between);
        self.ssa.sqrt(square)
    }

    /// The distance of a corner of two bodies from the other body.
    pub(super) fn clearance(&mut self, links: [LinkId; 2], number: usize) -> Option<Value> {
        let boundaries = Boundary::of_both(self.model, links)?;
        let (own, corner) = *corners(&boundaries).get(number)?;
        let [cos, sin, x, y] = self.pose(links[own]);
        let [other_cos, other_sin, other_x, other_y] = self.pose(links[1 - own]);
        let curves = &boundaries[1 - own].curves;
        let gap = gap(&mut self.ssa, corner, curves, |ssa, at| {
            let arm = ssa.vector(at);
            let arm = ssa.rotate([cos, sin], arm);
            let place = ssa.plus([x, y], arm);
            let between = ssa.minus(place, [other_x, other_y]);
            let back = ssa.conjugate([other_cos, other_sin]);
            ssa.rotate(back, between)
        })?;
        let zero = self.ssa.constant(0.0);
        Some(self.ssa.max(gap, zero))
    }

    /// The coordinate of a cam's shaft: a sum of motors, if it is one. Its law tells whether it goes on over whole turns.
    fn shaft(&mut self, cam: JointId, shaft: JointId) -> Value {
        let mut steps = self.plan.steps.iter();
        let found = steps.find_map(|step| match step {
            Step::Cam(found) if found.by == cam => Some(found),
            _ => None,
        });
        let mut starts = self.plan.start.cams.iter();
        let start = starts.find(|start| start.cam == cam);
        let (Some(found), Some(start)) = (found, start) else {
            bug!("a cam has no step in the plan");
        };
        if let Some(sum) = self.sum_of_motors(start.shaft, &found.parts) {
            return sum;
        }
        let angle = self.coordinate(shaft);
        if let Some(own) = self.angles.last_mut() {
            own.is_measured = false;
        }
        angle
    }

    /// What is moved by parts of what sources have moved, from its value at the start; nothing if some of them are no motors.
    fn sum_of_motors(&mut self, start: f64, parts: &[(usize, Rational)]) -> Option<Value> {
        let parts = parts.iter().map(|(number, part)| {
            let Source::Motor(motor) = self.plan.sources[*number] else {
                return None;
            };
            Some((motor, float_of(part), self.plan.start.sources[*number]))
        });
        let parts = parts.collect::<Option<Vec<_>>>()?;
        let offset = parts.iter().map(|(_, part, at_start)| part * at_start);
        let mut sum = self.ssa.constant(start - offset.sum::<f64>());
        for (motor, part, _) in parts {
            let (input, part) =
                (self.ssa.make(Op::Input(InputId::of_motor(motor))), self.ssa.constant(part));
            let share = self.ssa.mul(part, input);
            sum = self.ssa.add(sum, share);
        }
        Some(sum)
    }

    /// The coordinate of a joint that gears, belts and racks move by motors alone, from its value at the start: a sum of motors, exactly.
    fn meshed(&mut self, axes: [AxisId; 2], start: f64) -> Option<Value> {
        let plan = self.plan;
        let (parts, is_forward) = plan.steps.iter().find_map(|step| match step {
            Step::Mesh(mesh) => Some((&mesh.parts, mesh.connection.turns_between(axes)?)),
            _ => None,
        })?;
        if is_forward {
            return self.sum_of_motors(start, parts);
        }
        let back = self.sum_of_motors(-start, parts)?;
        Some(self.ssa.neg(back))
    }

    /// The contact of a cam and its roller.
    fn pressed(&mut self, cam: JointId) -> Pressed<Value> {
        let model = self.model;
        let (Some(roller), JointKind::Cam { shaft, follower, law }) =
            (model.roller_of(cam), model.joint(cam).kind)
        else {
            bug!("a cam without a roller is measured");
        };
        let carrier = model.carrier_of_cam(shaft, follower);
        let found = carrier.and_then(|carrier| {
            Some((model.beside(shaft, carrier)?, model.beside(follower, carrier)?))
        });
        let Some(((center, sense), (own, forwards))) = found else {
            bug!("the joints of a cam have no link in common");
        };
        let angle = self.shaft(cam, shaft);
        let value = self.ssa.law(model.law(law), angle);
        // Nothing moves but the shaft, at a rate of one.
        let mut tangents = Tangents::new(Seed::Alone(usize::MAX), model.motors.len());
        let one = self.ssa.constant(1.0);
        tangents.set(&mut self.ssa, angle, one);
        let first = tangents.of_all_up_to(&mut self.ssa, value);
        let second = tangents.of_all_up_to(&mut self.ssa, first);
        let guide = match model.joint(follower).kind {
            JointKind::Prismatic(from, _) => {
                let along = self.direction(model.seen_axis(from));
                let forwards = self.ssa.constant(forwards);
                Guide::Along(self.ssa.scale(forwards, along))
            }
            _ => Guide::About(self.point(model.seen_axis(own)), forwards),
        };
        let contact = Contact {
            center: self.point(model.seen_axis(center)),
            roller: self.point(roller.point),
            guide,
            sense,
            slopes: [first, second],
        };
        contact.pressed(&mut self.ssa)
    }

    /// The transmission angle of the dyad that closes a loop: between the directions in which its two unknowns move what they join. Both
    /// its sine and its cosine follow from lengths, whatever the branch.
    pub(super) fn transmission(&mut self, number: usize) -> Option<Value> {
        let mut all = self.program.closed_forms();
        let (_, closed) = all.find(|(_, closed)| closed.number == number)?;
        let ssa = &mut self.ssa;
        let zero = ssa.constant(0.0);
        let discriminant = ssa.max(closed.discriminant, zero);
        let across = ssa.sqrt(discriminant);
        let along = match closed.dyad {
            Dyad::TwoCircles { goal, arms } => {
                let [a, b] = arms.map(|arm| ssa.dot(arm, arm));
                let (arms, apart) = (ssa.add(a, b), ssa.dot(goal, goal));
                ssa.sub(arms, apart)
            }
            Dyad::CircleAndLine { goal, along, .. } => ssa.cross(along, goal),
            Dyad::TurningLine { arm, along, .. } => ssa.cross(along, arm),
            Dyad::TwoLines { lines: [a, b], .. } => {
                let (across, along) = (ssa.cross(a, b), ssa.dot(a, b));
                let (across, along) = (ssa.abs(across), ssa.abs(along));
                return Some(ssa.make(Op::Atan2(across, along)));
            }
        };
        let along = ssa.abs(along);
        Some(ssa.make(Op::Atan2(across, along)))
    }
}
