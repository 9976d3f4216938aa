//! The laws of motors in time as a program of their own, in double precision whatever the mechanism is computed in.

use super::build::{Seed, Tangents};
use super::builder::SsaBuilder;
use super::live::live;
use super::node::{Op, Value};
use super::{Position, Program};
use crate::model::{Effects, Inverse, Law, Model, MotorId, ParamId, Precision};

/// The laws of all motors that have one.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Timing {
    /// The operations: one straight block.
    pub program: Program,
    /// The values of each of these motors, in the order of their declaration.
    pub motors: Vec<LawValues>,
    /// The values of all params, in the order of their declaration.
    pub params: Vec<Value>,
}

/// The values of a motor at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LawValues {
    /// The motor.
    pub motor: MotorId,
    /// Its value, in radians or scene units.
    pub value: Value,
    /// Its rate, if velocities are asked for.
    pub rate: Option<Value>,
    /// Its second rate, if accelerations are asked for.
    pub second: Option<Value>,
}

impl Timing {
    /// The value of the time, if any law depends on it.
    #[must_use]
    pub fn time(&self) -> Option<Value> {
        let mut live = self.program.live_values();
        live.find(|&value| self.program.node(value).op == Op::Time)
    }

    /// The params that laws depend on: each with its value.
    pub fn used_params(&self) -> impl Iterator<Item = (ParamId, Value)> + '_ {
        let all = self.params.iter().enumerate();
        all.filter(|(_, value)| self.program.live[value.index()])
            .map(|(number, value)| (ParamId::new(number), *value))
    }
}

/// Lowers the laws of the motors, and their rates as far as effects ask for them; none if no motor has a law.
#[must_use]
pub fn build_timing(model: &Model) -> Option<Timing> {
    build_laws(model, model.lawful_motors().collect(), model.effects)
}

/// Lowers the path of a point, in the mechanism in which it is given, and its rates as far as these effects ask for them; none without a
/// path.
pub(crate) fn build_trajectory(
    inverted: &Model,
    inverse: &Inverse,
    effects: Effects,
) -> Option<Timing> {
    let laws = inverse.trajectory.iter().map(|law| inverted.law(*law));
    let laws = inverse.motors.iter().copied().zip(laws);
    build_laws(inverted, laws.collect(), effects)
}

fn build_laws(model: &Model, laws: Vec<(MotorId, &Law)>, effects: Effects) -> Option<Timing> {
    if laws.is_empty() {
        return None;
    }
    let mut ssa = SsaBuilder::new(at_rest(model), Precision::F64);
    ssa.block("laws".to_owned(), "What the laws of the motors say.".to_owned());
    let time = ssa.make(Op::Time);
    let params = ssa.params(model);
    let mut tangents = Tangents::new(Seed::Given, model.motors.len());
    let mut motors = Vec::new();
    for (motor, law) in laws {
        let name = &model.joint(model.motor(motor).joint).name;
        let value = ssa.law(law, time);
        if value != time {
            ssa.name(value, name);
        }
        let mut differentiate = |value: Value, name: String| {
            let rate = tangents.of_all_up_to(&mut ssa, value);
            ssa.name(rate, name)
        };
        let rate = effects.velocity.then(|| differentiate(value, format!("{name}_rate")));
        let second = rate
            .filter(|_| effects.acceleration)
            .map(|rate| differentiate(rate, format!("{name}_acceleration")));
        motors.push(LawValues { motor, value, rate, second });
    }
    let values = |timed: &LawValues| [Some(timed.value), timed.rate, timed.second];
    let mut program = Program {
        name: model.name.clone(),
        ssa: ssa.ssa,
        state: motors.iter().flat_map(values).flatten().collect(),
        curved: true,
        ..Program::default()
    };
    program.live = live(&program);
    program.cut_chains();
    Some(Timing { program, motors, params })
}

/// A position without links: motors at zero, and the params as they are at the start.
pub(super) fn at_rest(model: &Model) -> Position<f64> {
    let resting = vec![0.0; model.motors.len()];
    Position {
        motors: resting.into_iter().chain(model.params.values()).collect(),
        turns: vec![0; model.inputs()],
        ..Position::default()
    }
}
