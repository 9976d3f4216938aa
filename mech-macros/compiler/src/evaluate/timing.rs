//! The laws of motors, at a time.

use crate::bug::bug;
use crate::program::{Op, Timing, Value};

impl Timing {
    /// For each motor that has a law its value, its rate and its second rate at a time and with these params, as far as they were
    /// asked for, else zero: the same bits as the generated code.
    #[must_use]
    pub fn at(&self, time: f64, params: &[f64]) -> Vec<[f64; 3]> {
        let program = &self.program;
        let mut values = vec![0.0; program.ssa.nodes.len()];
        for (param, value) in self.used_params() {
            values[value.index()] = params[param.index()];
        }
        for value in program.live_values() {
            let op = program.node(value).op;
            if matches!(op, Op::Input(_)) {
                // A param, which is known.
                continue;
            }
            let found = match op {
                Op::Time => Some(time),
                op => op.apply(|value: Value| values[value.index()]),
            };
            values[value.index()] = found.unwrap_or_else(|| bug!("a law reads {op:?}"));
        }
        let get = |value: Value| values[value.index()];
        let timed = self.motors.iter().map(|timed| {
            let rates = [timed.rate, timed.second].map(|rate| rate.map_or(0.0, get));
            [get(timed.value), rates[0], rates[1]]
        });
        timed.collect()
    }
}
