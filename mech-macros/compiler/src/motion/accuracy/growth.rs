//! Whether rounding errors grow with the turns of a motor: then no accuracy holds wherever it is.

use crate::evaluate::Machine;
use crate::model::{Model, MotorId};
use crate::program::{Op, Program, Value};
use std::f64::consts::TAU;

/// So many turns of a motor are looked at: an angle that comes back within them does not grow.
const TURNS: u32 = 8;
/// So near to its start an angle has come back.
const NEAR: f64 = 1e-6;

/// The growth of a value and of its rounding error.
#[derive(Clone, Copy, Debug, Default)]
struct Growth {
    /// The motor with whose turns the value grows without bound, if one does.
    size: Option<MotorId>,
    /// Its rounding error does.
    error: Option<MotorId>,
}

/// A motor that may turn any number of times while the rounding errors of a position grow with its turns.
pub(super) fn growing(model: &Model, program: &Program) -> Option<MotorId> {
    let endless = |motor: &MotorId| {
        let motor = model.motor(*motor);
        let turns = model.turns(motor.joint);
        turns && motor.range.is_none()
    };
    let endless: Vec<MotorId> = model.motor_ids().filter(endless).collect();
    let winding = winding(program, &endless);
    let mut found: Vec<Growth> = Vec::with_capacity(program.ssa.nodes.len());
    let mut blocks = vec![None; program.ssa.blocks.len()];
    for node in &program.ssa.nodes {
        let growth = match node.op {
            Op::Input(input) if program.reduced.get(input.index()) != Some(&true) => {
                of_motor(input.index(), &endless)
            }
            Op::Turns(input) => of_motor(input.index(), &endless),
            Op::Round(_) => Growth { size: winding, error: None },
            Op::Solved(block, _) => Growth { size: None, error: blocks[block.index()] },
            op => of_operation(program, op, |value| found[value.index()]),
        };
        let own = &mut blocks[node.block.index()];
        *own = own.or(growth.error);
        found.push(growth);
    }
    let mut parts = program.poses.iter().flatten();
    parts.find_map(|part| found[part.index()].error.or(found[part.index()].size))
}

fn of_motor(motor: usize, endless: &[MotorId]) -> Growth {
    let size = endless.iter().find(|id| id.index() == motor);
    Growth { size: size.copied(), error: None }
}

fn of_operation(program: &Program, op: Op, get: impl Fn(Value) -> Growth) -> Growth {
    let first = |part: fn(&Growth) -> Option<MotorId>| {
        op.operands().find_map(|operand| part(&get(operand)))
    };
    let (size, error) = (first(|growth| growth.size), first(|growth| growth.error));
    match op {
        // A given angle is exact, whatever its size, and so are its sine and cosine.
        Op::Sin(_) | Op::Cos(_) | Op::Atan2(..) => Growth { size: None, error },
        Op::Neg(_) => Growth { size, error },
        Op::Mul(a, b) if is_power_of_two(program, a) || is_power_of_two(program, b) => {
            Growth { size, error }
        }
        _ => Growth { size, error: error.or(size) },
    }
}

/// Whether a product with it is exact.
fn is_power_of_two(program: &Program, value: Value) -> bool {
    match program.node(value).op {
        Op::Constant(number) => {
            let mantissa = number.get().to_bits() & ((1 << 52) - 1);
            number.get().is_normal() && mantissa == 0
        }
        _ => false,
    }
}

/// The first motor that winds up an angle which is carried from position to position: it does not come back after some turns.
fn winding(program: &Program, endless: &[MotorId]) -> Option<MotorId> {
    let carried: Vec<usize> = (0..program.state.len())
        .filter(|&state| is_followed(program, program.state[state]))
        .collect();
    if carried.is_empty() {
        return None;
    }
    endless.iter().copied().find(|motor| {
        let mut machine = Machine::<f64>::new(program);
        let start = machine.position().clone();
        for _ in 0..TURNS {
            let mut motors = machine.position().motors.clone();
            motors[motor.index()] += TAU;
            if machine.move_to(&motors).is_err() {
                return false;
            }
            let state = &machine.position().state;
            if carried.iter().all(|&index| (state[index] - start.state[index]).abs() < NEAR) {
                return false;
            }
        }
        true
    })
}

/// Whether a value is an angle that is followed over whole turns.
fn is_followed(program: &Program, value: Value) -> bool {
    let mut waiting = vec![value];
    let mut depth = 0;
    while let Some(value) = waiting.pop() {
        depth += 1;
        match program.node(value).op {
            Op::Round(_) | Op::Solved(..) => return true,
            // The angle is a principal one and whole turns times a turn.
            Op::Add(..) | Op::Mul(..) if depth < 8 => {
                waiting.extend(program.node(value).op.operands());
            }
            _ => {}
        }
    }
    false
}
