//! Motor torques by virtual work: each motor moves alone, and its power balances that of all other forces.

use super::Positions;
use super::lowering::Lowering;
use super::tangent::{Seed, Tangents};
use super::wrench::{Body, Wrench};
use crate::model::{LoadKind, MotorId};
use crate::plan::{Algebra, Arithmetic};
use crate::program::node::{Op, Value};
use crate::program::{Inertia, LinearEquations};

impl Lowering<'_> {
    /// The torques of the motors that hold everything at rest.
    pub(super) fn derive_holding(
        &mut self,
        positions: &Positions,
        equations: &mut LinearEquations,
    ) -> Vec<Value> {
        let mut influence_coefficients = self.influence_coefficients(positions, equations);
        self.ssa.block("forces".to_owned(), "What acts.".to_owned());
        let bodies = self.bodies();
        let wrenches = self.wrenches(&bodies);
        let mut torques = Vec::new();
        for influence in &mut influence_coefficients {
            let power = self.power(&wrenches, influence);
            torques.push(self.ssa.neg(power));
        }
        self.name_motors(&torques, "torque");
        torques
    }

    /// Inertia and forces as the motors feel them.
    pub(super) fn derive_inertia(
        &mut self,
        positions: &Positions,
        equations: &mut LinearEquations,
    ) -> Inertia<Value> {
        let mut alone = self.influence_coefficients(positions, equations);
        let (mut coasting, rates) = self.all_rates(positions, Seed::Coasting, equations);
        self.add_second_rates(positions, &rates, &mut coasting, equations);
        self.ssa
            .block("inertia".to_owned(), "Inertia and forces as the motors feel them.".to_owned());
        let bodies = self.bodies();
        let mut wrenches = self.wrenches(&bodies);
        wrenches.extend(self.resistances(&mut coasting));
        for body in &bodies {
            wrenches.extend(self.inertial_wrenches(body, &mut coasting));
        }
        let drive: Vec<Value> =
            alone.iter_mut().map(|tangents| self.power(&wrenches, tangents)).collect();
        self.name_motors(&drive, "drive");
        let matrix = self.reduced_inertia(&bodies, &mut alone);
        let kinetic = self.kinetic_energy(&matrix);
        let potential = self.potential_energy(&bodies);
        Inertia { matrix, drive, energy: [kinetic, potential] }
    }

    /// The rates of everything for a unit rate of each motor alone.
    pub(super) fn influence_coefficients(
        &mut self,
        positions: &Positions,
        equations: &mut LinearEquations,
    ) -> Vec<Tangents> {
        let motors = 0..self.model.motors.len();
        motors.map(|motor| self.all_rates(positions, Seed::Alone(motor), equations).0).collect()
    }

    /// The power of forces and torques.
    fn power(&mut self, wrenches: &[Wrench], tangents: &mut Tangents) -> Value {
        let mut power = self.ssa.constant(0.0);
        for wrench in wrenches {
            let part = match *wrench {
                Wrench::Force { at, force, .. } => {
                    let velocity = tangents.of_vector(&mut self.ssa, at);
                    self.ssa.dot(force, velocity)
                }
                Wrench::Torque { link, torque } => {
                    let direction = self.placement.pose(link).direction;
                    let turning = tangents.angular_velocity(&mut self.ssa, direction);
                    self.ssa.mul(torque, turning)
                }
            };
            power = self.ssa.add(power, part);
        }
        power
    }

    /// The force and torque that a body's inertia sets against its acceleration (d'Alembert).
    pub(super) fn inertial_wrenches(
        &mut self,
        body: &Body,
        tangents: &mut Tangents,
    ) -> [Wrench; 2] {
        let Body { link, mass, center, direction } = *body;
        let ssa = &mut self.ssa;
        let velocity = tangents.of_vector(ssa, center);
        let acceleration = tangents.of_vector(ssa, velocity);
        let weight = ssa.constant(-mass.mass);
        let force = ssa.scale(weight, acceleration);
        let turning = tangents.angular_velocity(ssa, direction);
        let change = tangents.of(ssa, turning);
        let inertia = ssa.constant(-mass.inertia);
        let torque = ssa.mul(inertia, change);
        [Wrench::Force { link, at: center, force }, Wrench::Torque { link, torque }]
    }

    /// The reduced inertia.
    fn reduced_inertia(&mut self, bodies: &[Body], alone: &mut [Tangents]) -> Vec<Vec<Value>> {
        let zero = self.ssa.constant(0.0);
        let mut matrix = vec![vec![zero; alone.len()]; alone.len()];
        for body in bodies {
            let ssa = &mut self.ssa;
            let moves: Vec<([Value; 2], Value)> = alone
                .iter_mut()
                .map(|tangents| {
                    let velocity = tangents.of_vector(ssa, body.center);
                    (velocity, tangents.angular_velocity(ssa, body.direction))
                })
                .collect();
            let [mass, inertia] =
                [body.mass.mass, body.mass.inertia].map(|number| ssa.constant(number));
            for (row, (velocity, turning)) in moves.iter().enumerate() {
                for (column, (other, spin)) in moves.iter().enumerate().skip(row) {
                    let translation = ssa.dot(*velocity, *other);
                    let translation = ssa.mul(mass, translation);
                    let turn = ssa.mul(*turning, *spin);
                    let turn = ssa.mul(inertia, turn);
                    let part = ssa.add(translation, turn);
                    matrix[row][column] = ssa.add(matrix[row][column], part);
                    matrix[column][row] = matrix[row][column];
                }
            }
        }
        matrix
    }

    /// The kinetic energy, from the reduced inertia.
    fn kinetic_energy(&mut self, matrix: &[Vec<Value>]) -> Value {
        let ssa = &mut self.ssa;
        let rates: Vec<Value> =
            (0..matrix.len()).map(|motor| ssa.make(Op::Rate(MotorId::new(motor)))).collect();
        let mut twice = ssa.constant(0.0);
        for (row, &rate) in matrix.iter().zip(&rates) {
            for (&part, &other) in row.iter().zip(&rates) {
                let both = ssa.mul(rate, other);
                let part = ssa.mul(part, both);
                twice = ssa.add(twice, part);
            }
        }
        let half = ssa.constant(0.5);
        ssa.mul(half, twice)
    }

    /// The rate of each load's point or link, in the order of the loads' numbers.
    pub(super) fn velocity_ratios(&mut self, tangents: &mut Tangents) -> Vec<Value> {
        let mut velocity_ratios = Vec::new();
        for load in &self.model.actions.loads {
            match load.kind {
                LoadKind::Force(point) => {
                    let at = self.point(point);
                    velocity_ratios.extend(tangents.of_vector(&mut self.ssa, at));
                }
                LoadKind::Torque(link) => {
                    let direction = self.placement.pose(link).direction;
                    velocity_ratios.push(tangents.angular_velocity(&mut self.ssa, direction));
                }
            }
        }
        velocity_ratios
    }

    /// Names a number for each motor.
    fn name_motors(&mut self, values: &[Value], what: &str) {
        for (motor, &value) in self.model.motors.iter().zip(values) {
            let name = format!("{}_{what}", self.model.joint(motor.joint).name);
            self.ssa.name(value, name);
        }
    }
}
