//! Velocities and accelerations: the program goes on from positions to the rates of everything, loop after loop.
//!
//! The rates of a loop's unknowns solve the linear system of its Newton step, with the rate of the gap that what is known
//! leaves in the place of the gap; their second rates solve it again.

use super::Writer;
use super::size::Size;
use super::tangent::{Seed, Tangents};
use super::tied::{Tied, all_columns};
use crate::plan::{Algebra, Equation, Solution, Unknown};
use crate::program::node::{Op, Value};
use crate::program::{BlockId, Motion, RateMargin, System};

/// Links whose rates stand in one block.
const MOST_LINKS: usize = 48;

/// A loop that was closed.
pub(super) struct Closing {
    /// Which loop of the plan it closes.
    pub(super) number: usize,
    /// What its block is called.
    pub(super) name: String,
    /// The joints of the loop whose coordinates are unknown, for messages.
    pub(super) place: String,
    pub(super) equation: Equation<Value>,
    /// Its directions and ways, in the order of the equation's unknowns.
    pub(super) solution: Vec<Solution<Value>>,
    /// How its directions and ways follow from fewer unknowns, if rolling ties them.
    pub(super) tied: Option<Tied>,
}

/// The linear system for the rates of a loop.
pub(super) struct Solved {
    block: BlockId,
    pub(super) columns: Vec<Vec<Value>>,
    /// What the columns times the rates must add to zero.
    gap: Vec<Value>,
    rates: Vec<Value>,
}

impl Writer<'_> {
    /// Notes a loop that was closed, unless nothing needs its solution.
    pub(super) fn closed(&mut self, closing: Closing) {
        if !self.idle.contains(&(self.loops - 1)) {
            self.closings.push(closing);
        }
    }

    /// Extends the program by the rates of all poses.
    pub(super) fn motion(&mut self, poses: &[[Value; 4]]) -> Motion {
        let mut motion = Motion::default();
        let closings = std::mem::take(&mut self.closings);
        let (mut tangents, solved) = self.driven(&closings, Seed::Given, &mut motion);
        motion.velocities = self.link_rates("velocities", poses, &mut tangents);
        if self.model.effects.acceleration {
            self.driven_on(&closings, &solved, &mut tangents, &mut motion);
            let mut accelerations = Vec::new();
            for some in motion.velocities.chunks(MOST_LINKS) {
                self.builder
                    .block("accelerations".to_owned(), "Accelerations.".to_owned());
                for rates in some {
                    accelerations.push(rates.map(|rate| tangents.of(&mut self.builder, rate)));
                }
            }
            motion.accelerations = Some(accelerations);
        }
        motion
    }

    /// The rates of what all loops solve, if the motors do this.
    pub(super) fn driven(
        &mut self,
        closings: &[Closing],
        seed: Seed,
        motion: &mut Motion,
    ) -> (Tangents, Vec<Solved>) {
        let mut tangents = Tangents::new(seed, self.model.motors.len());
        for (angle, ends) in &self.angles {
            tangents.is_angle(*angle, *ends);
        }
        let mut solved = Vec::new();
        for closing in closings {
            let (title, name) = match seed {
                Seed::Given | Seed::Coasting => ("Rates of".to_owned(), "rates".to_owned()),
                Seed::Alone(given) => {
                    let name = self.given_name(given);
                    (format!("What `{name}` does to"), format!("follows_{name}"))
                }
            };
            let title = format!("{title} the loop that {} close.", closing.place);
            let block = self
                .builder
                .block(format!("{}_{name}", closing.name), title);
            solved.push(self.rates(block, closing, &mut tangents, motion));
        }
        (tangents, solved)
    }

    /// What a motor, or a param after them, is called.
    fn given_name(&self, given: usize) -> &str {
        let (motors, params) = (&self.model.motors, self.model.params.all());
        match motors.get(given) {
            Some(motor) => &self.model.joint(motor.joint).name,
            None => &params[given - motors.len()].name,
        }
    }

    /// The second rates of what all loops solve.
    pub(super) fn driven_on(
        &mut self,
        closings: &[Closing],
        solved: &[Solved],
        tangents: &mut Tangents,
        motion: &mut Motion,
    ) {
        for (closing, rates) in closings.iter().zip(solved) {
            let title = format!("Second rates of the loop that {} close.", closing.place);
            self.builder
                .block(format!("{}_second_rates", closing.name), title);
            self.accelerations(rates, tangents, motion);
        }
    }

    pub(super) fn link_rates(
        &mut self,
        name: &str,
        poses: &[[Value; 4]],
        tangents: &mut Tangents,
    ) -> Vec<[Value; 3]> {
        let mut rates = Vec::new();
        for some in poses.chunks(MOST_LINKS) {
            self.builder
                .block(name.to_owned(), "Velocities.".to_owned());
            for &[cos, sin, x, y] in some {
                let turning = tangents.turning(&mut self.builder, [cos, sin]);
                let [x, y] = tangents.of_vector(&mut self.builder, [x, y]);
                rates.push([turning, x, y]);
            }
        }
        rates
    }

    /// The rates of what a loop solves.
    pub(super) fn rates(
        &mut self,
        block: BlockId,
        closing: &Closing,
        tangents: &mut Tangents,
        motion: &mut Motion,
    ) -> Solved {
        let Closing {
            equation,
            solution,
            tied,
            ..
        } = closing;
        let residuals = equation.residuals(&mut self.builder, solution);
        // The way round is linear in what is known: its rate is the way round what changes.
        let builder = &mut self.builder;
        let moved = equation.map(|value| tangents.of(builder, value));
        let moved = moved.residuals(&mut self.builder, solution);
        let mut gap: Vec<Value> = moved.rings.iter().flat_map(|ring| ring.gap).collect();
        let all = all_columns(&residuals, solution.len());
        let columns = match tied {
            None => all,
            Some(tied) => {
                for (direction, known) in tied.known() {
                    let rate = tangents.of(&mut self.builder, known);
                    for (gap, part) in gap.iter_mut().zip(&all[direction]) {
                        let share = self.builder.mul(rate, *part);
                        *gap = self.builder.add(*gap, share);
                    }
                }
                tied.columns(&mut self.builder, &all)
            }
        };
        let (rates, det) = self.solved_rates(block, (&columns, &gap), motion);
        self.builder.name(det, "det");
        let most = self.greatest_det(&columns);
        let least = self.part_of(16.0 * self.model.precision.epsilon().sqrt(), most);
        let size = self.builder.abs(det);
        let margin = self.builder.sub(size, least);
        // What several motors do to a loop hangs on the same determinant.
        if motion.margins.iter().all(|other| other.margin != margin) {
            motion.margins.push(RateMargin {
                place: closing.place.clone(),
                margin,
            });
        }
        for (unknown, solution) in solution.iter().enumerate() {
            let rate = match tied {
                None => rates[unknown],
                Some(tied) => tied.rate(&mut self.builder, (unknown, &rates), |builder, known| {
                    tangents.of(builder, known)
                }),
            };
            let moving = match equation.unknowns[unknown] {
                Unknown::Direction(base) => self.name_of(base),
                Unknown::Slide(joint) => &self.model.joint(joint).name,
            };
            let moving = format!("{moving}_rate");
            self.builder.name(rate, moving);
            match *solution {
                Solution::Direction(direction) => {
                    tangents.set_turning(&mut self.builder, direction, rate);
                }
                Solution::Slide(displacement) => {
                    tangents.set(&mut self.builder, displacement, rate);
                }
            }
        }
        Solved {
            block,
            columns,
            gap,
            rates,
        }
    }

    /// The second rates of what a loop solves.
    fn accelerations(&mut self, solved: &Solved, tangents: &mut Tangents, motion: &mut Motion) {
        let builder = &mut self.builder;
        let mut gap: Vec<Value> = solved
            .gap
            .iter()
            .map(|&gap| tangents.of(builder, gap))
            .collect();
        for (column, &rate) in solved.columns.iter().zip(&solved.rates) {
            for (gap, &part) in gap.iter_mut().zip(column) {
                let changed = tangents.of(builder, part);
                let share = builder.mul(changed, rate);
                *gap = builder.add(*gap, share);
            }
        }
        let (second, _) = self.solved_rates(solved.block, (&solved.columns, &gap), motion);
        for (&rate, second) in solved.rates.iter().zip(second) {
            // What never moves is never faster.
            if self.builder.number(rate).is_none() {
                let name = self
                    .builder
                    .name_of(rate)
                    .map(|name| format!("{name}_change"));
                if let Some(name) = name {
                    self.builder.name(second, name);
                }
                tangents.set(&mut self.builder, rate, second);
            }
        }
    }

    /// Solves the linear system of a loop, and gives its determinant.
    fn solved_rates(
        &mut self,
        block: BlockId,
        (columns, gap): (&[Vec<Value>], &[Value]),
        motion: &mut Motion,
    ) -> (Vec<Value>, Value) {
        if columns.len() <= 3 {
            return self.steps(block, columns, gap);
        }
        let (rates, det) = self.dense(columns, gap, motion);
        for &rate in &rates {
            self.builder.name(rate, "rate");
        }
        (rates, det)
    }

    /// The unknowns of a linear system that is solved as a whole, and its determinant: columns times unknowns and the right side add
    /// to zero.
    pub(super) fn dense(
        &mut self,
        columns: &[Vec<Value>],
        right: &[Value],
        motion: &mut Motion,
    ) -> (Vec<Value>, Value) {
        let system = motion.systems.len();
        motion.systems.push(System {
            block: self.builder.current(),
            columns: columns.to_vec(),
            right: right.to_vec(),
        });
        let mut linear = |index| self.builder.make(Op::Linear(system, index));
        let unknowns = (0..columns.len()).map(&mut linear).collect();
        (unknowns, linear(columns.len()))
    }

    /// The product of the columns' lengths: the determinant is at most this.
    fn greatest_det(&mut self, columns: &[Vec<Value>]) -> Size {
        if !columns.iter().any(|column| self.any_varies(column)) {
            return Size::Fixed(columns.iter().map(|column| self.length(column)).product());
        }
        let mut most = self.builder.constant(1.0);
        for column in columns {
            let length = self.about(column);
            most = self.builder.mul(most, length);
        }
        Size::Varying(most)
    }

    /// How long a column is at the start.
    fn length(&self, column: &[Value]) -> f64 {
        let squares = column
            .iter()
            .map(|&part| self.builder.at_start(part).powi(2));
        squares.sum::<f64>().sqrt()
    }
}
