//! Velocities and accelerations: from positions to the rates of everything, loop after loop.
//!
//! The rates of a loop's unknowns solve the linear system of its Newton step, with the rate of the gap that what is known
//! leaves in the place of the gap; their second rates solve it again.

use super::Positions;
use super::SolvedLoop;
use super::lowering::Lowering;
use super::size::Size;
use super::tangent::{Seed, Tangents};
use super::tied::all_columns;
use crate::plan::{Arithmetic, Solution, Unknown};
use crate::program::builder::SsaBuilder;
use crate::program::calibrate::reach;
use crate::program::node::{Op, Value};
use crate::program::{BlockId, LinearEquations, LinkRates, RateMargin, System};

/// Links whose rates stand in one block.
const MOST_LINKS: usize = 48;

/// The linear system for the rates of a loop, and its solution.
pub(super) struct LoopRates {
    block: BlockId,
    pub(super) columns: Vec<Vec<Value>>,
    /// The right side: with the columns times the rates it adds to zero.
    gap: Vec<Value>,
    rates: Vec<Value>,
}

impl Lowering<'_> {
    /// Derives the rates of all poses.
    pub(super) fn derive_rates(
        &mut self,
        positions: &Positions,
        poses: &[[Value; 4]],
        equations: &mut LinearEquations,
    ) -> LinkRates<Value> {
        let (mut tangents, rates) = self.all_rates(positions, Seed::Given, equations);
        let velocities = self.link_rates("velocities", poses, &mut tangents);
        let accelerations = self.model.effects.acceleration.then(|| {
            self.add_second_rates(positions, &rates, &mut tangents, equations);
            let mut accelerations = Vec::new();
            for some in velocities.chunks(MOST_LINKS) {
                self.ssa.block("accelerations".to_owned(), "Accelerations.".to_owned());
                for rates in some {
                    accelerations.push(rates.map(|rate| tangents.of(&mut self.ssa, rate)));
                }
            }
            accelerations
        });
        LinkRates { velocities, accelerations }
    }

    /// The rates of what all loops solve, if the motors do this.
    pub(super) fn all_rates(
        &mut self,
        positions: &Positions,
        seed: Seed,
        equations: &mut LinearEquations,
    ) -> (Tangents, Vec<LoopRates>) {
        let mut tangents = Tangents::new(seed, self.model.motors.len());
        for angle in &positions.angles {
            tangents.set_angle(angle.value, angle.between);
        }
        let mut all = Vec::new();
        for solved in &positions.loops {
            let (title, name) = match seed {
                Seed::Given | Seed::Coasting => ("Rates of".to_owned(), "rates".to_owned()),
                Seed::Alone(given) => {
                    let name = self.given_name(given);
                    (format!("What `{name}` does to"), format!("follows_{name}"))
                }
            };
            let title = format!("{title} the loop that {} close.", solved.place);
            let block = self.ssa.block(format!("{}_{name}", solved.name), title);
            all.push(self.loop_rates(block, solved, &mut tangents, equations));
        }
        (tangents, all)
    }

    /// The name of a motor, or of a param by its number after the motors.
    fn given_name(&self, given: usize) -> &str {
        let (motors, params) = (&self.model.motors, self.model.params.all());
        match motors.get(given) {
            Some(motor) => &self.model.joint(motor.joint).name,
            None => &params[given - motors.len()].name,
        }
    }

    /// The second rates of what all loops solve.
    pub(super) fn add_second_rates(
        &mut self,
        positions: &Positions,
        rates: &[LoopRates],
        tangents: &mut Tangents,
        equations: &mut LinearEquations,
    ) {
        for (solved, rates) in positions.loops.iter().zip(rates) {
            let title = format!("Second rates of the loop that {} close.", solved.place);
            self.ssa.block(format!("{}_second_rates", solved.name), title);
            self.loop_second_rates(rates, tangents, equations);
        }
    }

    /// The rates of these poses: angular velocity, and the rates of x and y.
    pub(super) fn link_rates(
        &mut self,
        name: &str,
        poses: &[[Value; 4]],
        tangents: &mut Tangents,
    ) -> Vec<[Value; 3]> {
        let mut rates = Vec::new();
        for some in poses.chunks(MOST_LINKS) {
            self.ssa.block(name.to_owned(), "Velocities.".to_owned());
            for &[cos, sin, x, y] in some {
                let turning = tangents.angular_velocity(&mut self.ssa, [cos, sin]);
                let [x, y] = tangents.of_vector(&mut self.ssa, [x, y]);
                rates.push([turning, x, y]);
            }
        }
        rates
    }

    /// The rates of what a loop solves.
    fn loop_rates(
        &mut self,
        block: BlockId,
        solved: &SolvedLoop,
        tangents: &mut Tangents,
        equations: &mut LinearEquations,
    ) -> LoopRates {
        let SolvedLoop { equation, solution, tied, .. } = solved;
        let residuals = equation.residuals(&mut self.ssa, solution);
        // The gap is linear in what is known: its rate is the gap of what changes.
        let ssa = &mut self.ssa;
        let moved = equation.map(|value| tangents.of(ssa, value));
        let moved = moved.residuals(&mut self.ssa, solution);
        let mut gap = moved.gap();
        let all = all_columns(&residuals, solution.len());
        let columns = match tied {
            None => all,
            Some(tied) => {
                for (direction, known) in tied.known() {
                    let rate = tangents.of(&mut self.ssa, known);
                    for (gap, part) in gap.iter_mut().zip(&all[direction]) {
                        let share = self.ssa.mul(rate, *part);
                        *gap = self.ssa.add(*gap, share);
                    }
                }
                tied.columns(&mut self.ssa, &all)
            }
        };
        let (rates, det) = self.solve_rates(block, &columns, &gap, equations);
        self.ssa.name(det, "det");
        let most = self.ssa.greatest_det(&columns);
        let least = self.ssa.part_of(16.0 * self.ssa.epsilon.sqrt(), most);
        let size = self.ssa.abs(det);
        let margin = self.ssa.sub(size, least);
        // The effects of several motors on a loop depend on the same determinant.
        if equations.margins.iter().all(|other| other.margin != margin) {
            equations.margins.push(RateMargin { place: solved.place.clone(), margin });
        }
        for (unknown, solution) in solution.iter().enumerate() {
            let rate = match tied {
                None => rates[unknown],
                Some(tied) => {
                    tied.rate(&mut self.ssa, unknown, &rates, |ssa, known| tangents.of(ssa, known))
                }
            };
            let moving = match equation.unknowns[unknown] {
                Unknown::Direction(base) => self.name_of(base),
                Unknown::Slide(joint) => &self.model.joint(joint).name,
            };
            let moving = format!("{moving}_rate");
            self.ssa.name(rate, moving);
            match *solution {
                Solution::Direction(direction) => {
                    tangents.set_turning(&mut self.ssa, direction, rate);
                }
                Solution::Slide(displacement) => {
                    tangents.set(&mut self.ssa, displacement, rate);
                }
            }
        }
        LoopRates { block, columns, gap, rates }
    }

    /// The second rates of what a loop solves.
    fn loop_second_rates(
        &mut self,
        solved: &LoopRates,
        tangents: &mut Tangents,
        equations: &mut LinearEquations,
    ) {
        let ssa = &mut self.ssa;
        let mut gap: Vec<Value> = solved.gap.iter().map(|&gap| tangents.of(ssa, gap)).collect();
        for (column, &rate) in solved.columns.iter().zip(&solved.rates) {
            for (gap, &part) in gap.iter_mut().zip(column) {
                let changed = tangents.of(ssa, part);
                let share = ssa.mul(changed, rate);
                *gap = ssa.add(*gap, share);
            }
        }
        let (second, _) = self.solve_rates(solved.block, &solved.columns, &gap, equations);
        for (&rate, second) in solved.rates.iter().zip(second) {
            // A coordinate that never moves has no acceleration.
            if self.ssa.number(rate).is_none() {
                let name = self.ssa.name_of(rate).map(|name| format!("{name}_change"));
                if let Some(name) = name {
                    self.ssa.name(second, name);
                }
                tangents.set(&mut self.ssa, rate, second);
            }
        }
    }

    /// Solves the linear system of a loop, and gives its determinant.
    fn solve_rates(
        &mut self,
        block: BlockId,
        columns: &[Vec<Value>],
        gap: &[Value],
        equations: &mut LinearEquations,
    ) -> (Vec<Value>, Value) {
        if columns.len() <= 3 {
            return self.ssa.solve_linear(block, columns, gap);
        }
        let (rates, det) = self.solve_dense(columns, gap, equations);
        for &rate in &rates {
            self.ssa.name(rate, "rate");
        }
        (rates, det)
    }

    /// The unknowns of a linear system that is solved as a whole, and its determinant: columns times unknowns and the right side add
    /// to zero.
    pub(super) fn solve_dense(
        &mut self,
        columns: &[Vec<Value>],
        right: &[Value],
        equations: &mut LinearEquations,
    ) -> (Vec<Value>, Value) {
        let system = equations.systems.len();
        equations.systems.push(System {
            block: self.ssa.current(),
            columns: columns.to_vec(),
            right: right.to_vec(),
        });
        let mut linear = |index| self.ssa.make(Op::Linear(system, index));
        let unknowns = (0..columns.len()).map(&mut linear).collect();
        (unknowns, linear(columns.len()))
    }
}

impl SsaBuilder {
    /// The product of the columns' lengths: the determinant is at most this.
    fn greatest_det(&mut self, columns: &[Vec<Value>]) -> Size {
        if !columns.iter().any(|column| self.any_varies(column)) {
            return Size::Fixed(reach(columns, |value| self.at_start(value)));
        }
        let mut most = self.constant(1.0);
        for column in columns {
            let length = self.about(column);
            most = self.mul(most, length);
        }
        Size::Varying(most)
    }
}
