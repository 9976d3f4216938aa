//! What forces do to the motors, by virtual work: each motor moves alone, and the power of everything that acts is what it has to
//! bring up.

use super::Writer;
use super::rates::Closing;
use super::tangent::{Seed, Tangents};
use super::wrench::{Body, Wrench};
use crate::model::LoadKind;
use crate::plan::Algebra;
use crate::program::node::Value;
use crate::program::{Forces, Inertia, Motion};

impl Writer<'_> {
    /// The torques of the motors that hold everything at rest.
    pub(super) fn holding(&mut self) -> Motion {
        let mut motion = Motion::default();
        let closings = std::mem::take(&mut self.closings);
        let mut influence_coefficients = self.influence_coefficients(&closings, &mut motion);
        self.builder
            .block("forces".to_owned(), "What acts.".to_owned());
        let bodies = self.bodies();
        let wrenches = self.wrenches(&bodies);
        let mut torques = Vec::new();
        for influence in &mut influence_coefficients {
            let power = self.power(&wrenches, influence);
            torques.push(self.builder.neg(power));
        }
        self.name_motors(&torques, "torque");
        motion.forces = Some(Forces::Holding(torques));
        motion.loads = self.model.actions.load_names();
        motion
    }

    /// Inertia and forces as the motors feel them.
    pub(super) fn inertia(&mut self) -> Motion {
        let mut motion = Motion::default();
        let closings = std::mem::take(&mut self.closings);
        let mut alone = self.influence_coefficients(&closings, &mut motion);
        let (mut coasting, solved) = self.driven(&closings, Seed::Coasting, &mut motion);
        self.driven_on(&closings, &solved, &mut coasting, &mut motion);
        self.builder.block(
            "inertia".to_owned(),
            "Inertia and forces as the motors feel them.".to_owned(),
        );
        let bodies = self.bodies();
        let mut wrenches = self.wrenches(&bodies);
        wrenches.extend(self.resistances(&mut coasting));
        for body in &bodies {
            wrenches.extend(self.inertial(body, &mut coasting));
        }
        let drive: Vec<Value> = alone
            .iter_mut()
            .map(|tangents| self.power(&wrenches, tangents))
            .collect();
        self.name_motors(&drive, "drive");
        let matrix = self.reduced(&bodies, &mut alone);
        let kinetic = self.kinetic(&matrix);
        let potential = self.potential(&bodies);
        motion.forces = Some(Forces::Inertia(Inertia {
            matrix,
            drive,
            energy: [kinetic, potential],
        }));
        motion.loads = self.model.actions.load_names();
        motion
    }

    /// What each motor does if it alone moves.
    pub(super) fn influence_coefficients(
        &mut self,
        closings: &[Closing],
        motion: &mut Motion,
    ) -> Vec<Tangents> {
        let motors = 0..self.model.motors.len();
        motors
            .map(|motor| self.driven(closings, Seed::Alone(motor), motion).0)
            .collect()
    }

    /// The power of forces and torques.
    fn power(&mut self, wrenches: &[Wrench], tangents: &mut Tangents) -> Value {
        let mut power = self.builder.constant(0.0);
        for wrench in wrenches {
            let part = match *wrench {
                Wrench::Force { at, force, .. } => {
                    let velocity = tangents.of_vector(&mut self.builder, at);
                    self.builder.dot(force, velocity)
                }
                Wrench::Torque { link, torque } => {
                    let direction = self.placement.pose(link).direction;
                    let turning = tangents.turning(&mut self.builder, direction);
                    self.builder.mul(torque, turning)
                }
            };
            power = self.builder.add(power, part);
        }
        power
    }

    /// What keeps a body from being accelerated: force and torque against its acceleration.
    pub(super) fn inertial(&mut self, body: &Body, tangents: &mut Tangents) -> [Wrench; 2] {
        let Body {
            link,
            mass,
            center,
            direction,
        } = *body;
        let builder = &mut self.builder;
        let velocity = tangents.of_vector(builder, center);
        let acceleration = tangents.of_vector(builder, velocity);
        let weight = builder.constant(-mass.mass);
        let force = builder.scaled(weight, acceleration);
        let turning = tangents.turning(builder, direction);
        let change = tangents.of(builder, turning);
        let inertia = builder.constant(-mass.inertia);
        let torque = builder.mul(inertia, change);
        [
            Wrench::Force {
                link,
                at: center,
                force,
            },
            Wrench::Torque { link, torque },
        ]
    }

    /// The reduced inertia.
    fn reduced(&mut self, bodies: &[Body], alone: &mut [Tangents]) -> Vec<Vec<Value>> {
        let zero = self.builder.constant(0.0);
        let mut matrix = vec![vec![zero; alone.len()]; alone.len()];
        for body in bodies {
            let builder = &mut self.builder;
            let moves: Vec<([Value; 2], Value)> = alone
                .iter_mut()
                .map(|tangents| {
                    let velocity = tangents.of_vector(builder, body.center);
                    (velocity, tangents.turning(builder, body.direction))
                })
                .collect();
            let [mass, inertia] =
                [body.mass.mass, body.mass.inertia].map(|number| builder.constant(number));
            for (row, (velocity, turning)) in moves.iter().enumerate() {
                for (column, (other, spin)) in moves.iter().enumerate().skip(row) {
                    let translation = builder.dot(*velocity, *other);
                    let translation = builder.mul(mass, translation);
                    let turn = builder.mul(*turning, *spin);
                    let turn = builder.mul(inertia, turn);
                    let part = builder.add(translation, turn);
                    matrix[row][column] = builder.add(matrix[row][column], part);
                    matrix[column][row] = matrix[row][column];
                }
            }
        }
        matrix
    }

    fn kinetic(&mut self, matrix: &[Vec<Value>]) -> Value {
        let builder = &mut self.builder;
        let rates: Vec<Value> = (0..matrix.len())
            .map(|motor| builder.make(crate::program::node::Op::Rate(motor)))
            .collect();
        let mut twice = builder.constant(0.0);
        for (row, &rate) in matrix.iter().zip(&rates) {
            for (&part, &other) in row.iter().zip(&rates) {
                let both = builder.mul(rate, other);
                let part = builder.mul(part, both);
                twice = builder.add(twice, part);
            }
        }
        let half = builder.constant(0.5);
        builder.mul(half, twice)
    }

    /// How fast each number of the loads is followed.
    pub(super) fn velocity_ratios(&mut self, tangents: &mut Tangents) -> Vec<Value> {
        let mut velocity_ratios = Vec::new();
        for load in &self.model.actions.loads {
            match load.kind {
                LoadKind::Force(point) => {
                    let (_, at) = self.point(point);
                    velocity_ratios.extend(tangents.of_vector(&mut self.builder, at));
                }
                LoadKind::Torque(link) => {
                    let direction = self.placement.pose(link).direction;
                    velocity_ratios.push(tangents.turning(&mut self.builder, direction));
                }
            }
        }
        velocity_ratios
    }

    fn name_motors(&mut self, values: &[Value], what: &str) {
        for (motor, &value) in self.model.motors.iter().zip(values) {
            let name = format!("{}_{what}", self.model.joint(motor.joint).name);
            self.builder.name(value, name);
        }
    }
}
