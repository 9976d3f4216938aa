//! Positions in time: a program of positions in which motors are where their laws have them. The time is an input, after all others.

use super::build::{Seed, Tangents};
use super::builder::SsaBuilder;
use super::live::live;
use super::node::{Node, Op, Value};
use super::{Block, BlockId, BlockKind, Position, Program, Ssa};
use crate::model::{InputId, Law, Model, MotorId, ParamId, Precision};
use crate::plan::Arithmetic;

/// A program of positions whose motors follow their laws.
#[derive(Clone, Debug)]
pub(crate) struct InTime {
    /// The program. What the laws compute stands before everything else.
    pub(crate) program: Program,
    /// The input that is the time.
    pub(crate) time: InputId,
    /// The motors that follow a law which changes.
    pub(crate) motors: Vec<Following>,
    /// The number of operations of the laws.
    laws: usize,
}

/// A motor that follows a law, as values of the program.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Following {
    /// The motor.
    pub(crate) motor: MotorId,
    /// Where it is. Links are placed by this value, and nothing else is.
    pub(crate) value: Value,
    /// Its rate.
    pub(crate) rate: Value,
    /// Its second rate.
    pub(crate) second: Value,
}

impl InTime {
    /// The program of positions, in time.
    pub(crate) fn new(model: &Model, positions: &Program) -> Self {
        let (mut ssa, time) = laws(model, positions);
        let mut tangents = Tangents::new(Seed::Alone(time.index()), model.motors.len());
        let variable = ssa.make(Op::Input(time));
        let laws = model.lawful_motors();
        let laws = laws.map(|(motor, law)| {
            let values = with_slopes(&mut ssa, &mut tangents, law, variable);
            (motor, values)
        });
        let mut laws: Vec<(MotorId, [Value; 3])> = laws.collect();
        laws.retain(|(_, [value, ..])| ssa.number(*value).is_none());
        let nodes = &ssa.ssa.nodes;
        let mut program = positions.after(nodes);
        program.params.push("t".to_owned());
        program.reduced.push(false);
        program.start = ssa.start;
        let mut motors = Vec::new();
        for (motor, [value, rate, second]) in laws {
            let own = Op::Input(InputId::of_motor(motor));
            let mut all = program.ssa.nodes.iter_mut().enumerate();
            let found = all.find(|(_, node)| node.op == own);
            let value = found.map_or(value, |(index, node)| {
                node.op = nodes[value.index()].op;
                Value::at(index)
            });
            motors.push(Following { motor, value, rate, second });
        }
        program.live = live(&program);
        Self { program, time, motors, laws: nodes.len() }
    }

    /// Lets a builder that goes on with this program read motors and their rates from it.
    pub(super) fn give_to(&self, ssa: &mut SsaBuilder, motors: usize) {
        // A motor's value is made once more: what else has the same operation is no motor's. Constants are those of positions.
        let laws = self.program.ssa.nodes[..self.laws].iter().enumerate();
        for (index, node) in laws.filter(|(_, node)| !matches!(node.op, Op::Constant(_))) {
            ssa.give(node.op, Value::at(index));
        }
        let zero = ssa.constant(0.0);
        for motor in (0..motors).map(MotorId::new) {
            ssa.give(Op::Rate(motor), zero);
            ssa.give(Op::Acceleration(motor), zero);
        }
        for following in &self.motors {
            let motor = following.motor;
            ssa.give(Op::Input(InputId::of_motor(motor)), following.value);
            ssa.give(Op::Rate(motor), following.rate);
            ssa.give(Op::Acceleration(motor), following.second);
        }
    }
}

/// The beginning of a program of laws, with the input that is the time: it starts at zero.
fn laws(model: &Model, positions: &Program) -> (SsaBuilder, InputId) {
    let time = InputId::of_param(ParamId::new(model.params.all().len()), model.motors.len());
    let mut start: Position<f64> = positions.start.clone();
    start.motors.push(0.0);
    start.turns.push(0);
    let mut ssa = SsaBuilder::new(start, Precision::F64);
    ssa.params(model);
    (ssa, time)
}

/// A law of the time, with its first two derivatives.
fn with_slopes(
    ssa: &mut SsaBuilder,
    tangents: &mut Tangents,
    law: &Law,
    time: Value,
) -> [Value; 3] {
    let value = ssa.law(law, time);
    let rate = tangents.of_all_up_to(ssa, value);
    let second = tangents.of_all_up_to(ssa, rate);
    [value, rate, second]
}

impl Program {
    /// The same program of positions after some other operations, which stand in its first block.
    fn after(&self, others: &[Node]) -> Self {
        let moved = |value: Value| Value::at(value.index() + others.len());
        let block = |block: &Block| Block {
            kind: match &block.kind {
                BlockKind::Straight => BlockKind::Straight,
                BlockKind::ClosedForm(closed) => BlockKind::ClosedForm(closed.map(moved)),
                BlockKind::Newton(newton) => BlockKind::Newton(newton.map(moved)),
            },
            ..block.clone()
        };
        let others = others.iter().map(|node| Node { block: BlockId::FIRST, ..node.clone() });
        let own = self.ssa.nodes.iter().map(|node| Node { op: node.op.map(moved), ..node.clone() });
        let solutions = self.solutions.iter().map(|(number, solutions)| {
            let solutions = solutions.iter();
            (*number, solutions.map(|one| one.map(moved)).collect())
        });
        let followed = self.followed.iter();
        Self {
            ssa: Ssa {
                nodes: others.chain(own).collect(),
                blocks: self.ssa.blocks.iter().map(block).collect(),
            },
            poses: self.poses.iter().map(|pose| pose.map(moved)).collect(),
            state: self.state.iter().map(|value| moved(*value)).collect(),
            solutions: solutions.collect(),
            followed: followed.map(|(what, value)| (*what, moved(*value))).collect(),
            derived: None,
            live: Vec::new(),
            ..self.clone()
        }
    }
}
