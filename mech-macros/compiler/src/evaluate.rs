//! Runs a program now: for the studio, and to check the generated code against.

use crate::program::{
    BlockId, BlockKind, Closed, Newton, Op, Position, Program, Real, Rounds, Slot, Value, solve,
};

/// The smallest part of a motor step that is tried before the mechanism is said to be blocked.
const FINEST: f64 = 1.0 / 4096.0;

/// Why a mechanism did not go where it was told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// There are not as many values as motors.
    MotorCount,
    /// The value for this motor is not a finite number.
    NotFinite(usize),
    /// The loop of this block does not close.
    Open(BlockId),
    /// The loop of this block would pass a dead point.
    DeadPoint(BlockId),
    /// A coordinate is beyond the range of the numbers.
    Overflow,
}

/// A mechanism that is moved by interpretation, in any precision, whatever the program was written for.
#[derive(Clone, Debug)]
pub struct Machine<'p, T> {
    program: &'p Program,
    position: Position<T>,
}

impl<'p, T: Real> Machine<'p, T> {
    /// The mechanism as it was assembled.
    #[must_use]
    pub fn new(program: &'p Program) -> Self {
        let number = |value: &f64| T::from_f64(*value);
        let start = &program.start;
        let position = Position {
            motors: start.motors.iter().map(number).collect(),
            poses: start
                .poses
                .iter()
                .map(|pose| pose.map(T::from_f64))
                .collect(),
            kept: start.kept.iter().map(number).collect(),
        };
        Self { program, position }
    }

    /// Where it is.
    #[must_use]
    pub fn position(&self) -> &Position<T> {
        &self.position
    }

    /// Gives the motors these values, one for each in order of declaration, in radians or scene units.
    ///
    /// # Errors
    /// The reason why it cannot go there; it then stays where it was.
    pub fn move_to(&mut self, motors: &[T]) -> Result<(), Stop> {
        if motors.len() != self.position.motors.len() {
            return Err(Stop::MotorCount);
        }
        if let Some(motor) = motors.iter().position(|value| !value.is_finite()) {
            return Err(Stop::NotFinite(motor));
        }
        self.position = match (self.step(&self.position, motors), self.subdivides()) {
            (Ok(position), _) => position,
            (Err(stop), false) => return Err(stop),
            (Err(stop), true) => self.by_pieces(motors, stop)?,
        };
        Ok(())
    }

    /// A fixed number of rounds is a promise about time, which subdivision would break.
    fn subdivides(&self) -> bool {
        let fixed = |block: BlockId| {
            matches!(
                self.program.newton(block),
                Some(Newton {
                    rounds: Rounds::Exactly(_),
                    ..
                })
            )
        };
        !self.program.block_ids().any(fixed)
    }

    fn by_pieces(&self, motors: &[T], mut stop: Stop) -> Result<Position<T>, Stop> {
        let mut position = self.position.clone();
        let (mut done, mut stride) = (0.0, 0.5);
        while stride >= FINEST {
            let target = done + stride;
            let part = |(&from, &to): (&T, &T)| {
                if target < 1.0 {
                    from + (to - from) * T::from_f64(target)
                } else {
                    to
                }
            };
            let aim: Vec<T> = self.position.motors.iter().zip(motors).map(part).collect();
            match self.step(&position, &aim) {
                Ok(next) if target < 1.0 => {
                    position = next;
                    done = target;
                    stride = (2.0 * stride).min(1.0 - done);
                }
                Ok(next) => return Ok(next),
                Err(reason) => {
                    stop = reason;
                    stride *= 0.5;
                }
            }
        }
        Err(stop)
    }

    /// Runs the program once.
    fn step(&self, last: &Position<T>, motors: &[T]) -> Result<Position<T>, Stop> {
        let mut values = vec![T::from_f64(0.0); self.program.nodes.len()];
        let live: Vec<Value> = self.program.live_values().collect();
        let mut solved = vec![false; self.program.blocks.len()];
        let closes = |(block, closed): (BlockId, &Closed), values: &[T]| {
            if values[closed.margin.index()] >= T::from_f64(0.0) {
                Ok(())
            } else {
                Err(Stop::Open(block))
            }
        };
        for &value in &live {
            let node = self.program.node(value);
            if node.iterated {
                continue;
            }
            if let Op::Solved(block, _) = node.op
                && !std::mem::replace(&mut solved[block.index()], true)
                && let BlockKind::Newton(newton) = &self.program.blocks[block.index()].kind
            {
                for before in self.program.margins().take_while(|(id, _)| *id < block) {
                    closes(before, &values)?;
                }
                self.iterate(block, newton, &live, &mut values)?;
            }
            values[value.index()] = match node.op {
                Op::Motor(motor) => motors[motor],
                Op::Last(slot) => read(last, slot),
                Op::Solved(block, index) => self.scalar(block, index, &values),
                op => op
                    .apply(|value| values[value.index()])
                    .unwrap_or(values[value.index()]),
            };
        }
        for margin in self.program.margins() {
            closes(margin, &values)?;
        }
        let get = |value: &Value| values[value.index()];
        let poses: Vec<[T; 4]> = self
            .program
            .poses
            .iter()
            .map(|pose| pose.map(|value| get(&value)))
            .collect();
        if poses.iter().flatten().any(|number| !number.is_finite()) {
            return Err(Stop::Overflow);
        }
        Ok(Position {
            motors: motors.to_vec(),
            poses,
            kept: self.program.kept.iter().map(get).collect(),
        })
    }

    /// The present value of an unknown: it stands in the place of the node that reads it inside the iteration.
    fn scalar(&self, block: BlockId, index: usize, values: &[T]) -> T {
        self.program.newton(block).map_or(values[0], |newton| {
            values[newton.scalars[index].now.index()]
        })
    }

    fn iterate(
        &self,
        block: BlockId,
        newton: &Newton,
        live: &[Value],
        values: &mut [T],
    ) -> Result<(), Stop> {
        for scalar in &newton.scalars {
            values[scalar.now.index()] = values[scalar.first.index()];
        }
        let body: Vec<Value> = live
            .iter()
            .copied()
            .filter(|&value| {
                let node = self.program.node(value);
                node.block == block && node.iterated && !matches!(node.op, Op::Unknown(..))
            })
            .collect();
        let within = |values: &[T], part: f64| {
            let fixed = newton.limits.size;
            let limit = match newton.extent {
                None => T::from_f64(part * fixed),
                Some(extent) => T::from_f64(part) * (T::from_f64(fixed) + values[extent.index()]),
            };
            let small = |value: Value| values[value.index()].abs() <= limit;
            newton.gap.iter().copied().all(small)
        };
        let mut rounds = 0;
        loop {
            let mut dense = None;
            for &value in &body {
                let op = self.program.node(value).op;
                if let Op::Dense(_, index) = op {
                    let (steps, det) = dense.get_or_insert_with(|| system(newton, values));
                    values[value.index()] = steps.get(index).copied().unwrap_or(*det);
                } else if let Some(result) = op.apply(|value| values[value.index()]) {
                    values[value.index()] = result;
                }
            }
            let done = match newton.rounds {
                Rounds::Exactly(exact) => rounds == exact,
                Rounds::UntilClosed(most) => {
                    rounds == most || within(values, newton.tight(T::EPSILON))
                }
            };
            if done {
                break;
            }
            let next: Vec<T> = newton
                .scalars
                .iter()
                .map(|scalar| values[scalar.next.index()])
                .collect();
            for (scalar, next) in newton.scalars.iter().zip(next) {
                values[scalar.now.index()] = next;
            }
            rounds += 1;
        }
        if !within(values, newton.accept(T::EPSILON)) {
            return Err(Stop::Open(block));
        }
        let det = values[newton.det.index()];
        let det = if newton.limits.positive { det } else { -det };
        if det >= T::from_f64(newton.floor(T::EPSILON)) {
            Ok(())
        } else {
            Err(Stop::DeadPoint(block))
        }
    }
}

/// Solves the system of coupled loops: columns times steps is what is missing.
fn system<T: Real>(newton: &Newton, values: &[T]) -> (Vec<T>, T) {
    let get = |value: &Value| values[value.index()];
    let row = |row: usize| {
        newton
            .columns
            .iter()
            .map(|column| get(&column[row]))
            .collect()
    };
    let rows = (0..newton.gap.len()).map(row).collect();
    solve(rows, newton.gap.iter().map(|gap| -get(gap)).collect())
}

fn read<T: Real>(last: &Position<T>, slot: Slot) -> T {
    match slot {
        Slot::Kept(index) => last.kept[index],
        Slot::Pose(link, part) => last.poses[link][part.index()],
    }
}

/// Lets the program itself close the loops of its start, so that the assembled position is as exact as any later one.
///
/// # Errors
/// The loop that does not close.
pub fn settle(program: &mut Program) -> Result<(), Stop> {
    let machine = Machine::<f64>::new(program);
    let start = machine.step(machine.position(), &machine.position().motors)?;
    program.start = start;
    Ok(())
}
