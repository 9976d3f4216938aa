//! The reference: the same mechanism in thirty digits.

use crate::closure::close;
use crate::contestant::{Poses, Trace};
use crate::octuple::Octuple;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::Model;
use mech_compiler::program::Program;
use mech_compiler::{compile, reporter, syntax};
use mech_runtime::Real;
use proc_macro2::TokenStream;

/// A mechanism that the interpreter runs with more digits than any contestant has.
pub(crate) struct Reference {
    model: Model,
    program: Program,
    /// The axes of the moving links: the link, and the place in its frame.
    points: Vec<(usize, [f64; 2])>,
    /// The greatest distance between two axes at the start.
    pub(crate) size: f64,
    /// The value of the motor at the start.
    pub(crate) start: f64,
}

impl Reference {
    /// Reads and compiles the text of a mechanism with one motor, which names neither its scalar nor its method.
    ///
    /// # Errors
    /// The messages of the compiler.
    pub(crate) fn new(text: &str) -> Result<Self, String> {
        let (model, program) = compile_text(text)?;
        let [start] = program.start.motors[..] else {
            return Err("it does not have one motor".to_owned());
        };
        let axes = model.axes.iter();
        let axes = axes.map(|axis| (axis.link.index().checked_sub(1), axis.at));
        let places: Vec<[f64; 2]> = axes
            .clone()
            .map(|(link, at)| match link.and_then(|link| program.start.poses.get(link)) {
                None => at,
                Some(pose) => place(*pose, at),
            })
            .collect();
        let far = |a: &[f64; 2]| {
            let distances = places.iter().map(|b| (b[0] - a[0]).hypot(b[1] - a[1]));
            distances.fold(0.0, f64::max)
        };
        let size = places.iter().map(far).fold(0.0, f64::max);
        let points = axes.filter_map(|(link, at)| Some((link?, at))).collect();
        Ok(Self { model, program, points, size, start })
    }

    /// The positions for these values of the motor.
    ///
    /// # Errors
    /// The value at which it stops.
    pub(crate) fn trace(&self, values: &[f64]) -> Result<Trace<Octuple>, String> {
        let mut machine = Machine::<Octuple>::new(&self.program);
        let step = |&value: &f64| {
            let result = machine.move_to(&[value.into()]);
            result.map_err(|stop| format!("the reference stops at {value}: {stop:?}"))?;
            let mut poses = machine.position().poses.clone();
            close(&self.model, self.size, value, &mut poses)?;
            Ok(poses)
        };
        values.iter().map(step).collect()
    }

    /// The greatest distance between an axis in these positions and in those of the reference, over all positions.
    pub(crate) fn error(&self, trace: &[Poses<f64>], reference: &[Poses<Octuple>]) -> f64 {
        let pairs = trace.iter().zip(reference);
        pairs.map(|(poses, reference)| self.distance(poses, reference)).fold(0.0, f64::max)
    }

    fn distance(&self, poses: &[[f64; 4]], reference: &[[Octuple; 4]]) -> f64 {
        let distance = |&(link, at): &(usize, [f64; 2])| {
            // The differences are small: a float is enough for what is done with them.
            let difference = |part: usize| {
                let difference = Octuple::from(poses[link][part]) - reference[link][part];
                difference.to_f64()
            };
            let [x, y] = place([0, 1, 2, 3].map(difference), at);
            x.hypot(y)
        };
        self.points.iter().map(distance).fold(0.0, f64::max)
    }
}

fn place([cos, sin, x, y]: [f64; 4], [u, v]: [f64; 2]) -> [f64; 2] {
    [x + cos * u - sin * v, y + sin * u + cos * v]
}

fn compile_text(text: &str) -> Result<(Model, Program), String> {
    let text = format!("struct Reference: f64; {text} method exact;");
    let tokens: TokenStream = text.parse().map_err(|_| "it is not Rust".to_owned())?;
    let parsed = syntax::parse(tokens);
    if let Some(error) = parsed.errors.first() {
        return Err(error.text.clone());
    }
    let model = parsed.model;
    if model.links.iter().any(|link| link.die.is_some()) {
        return Err("there is no reference for slots".to_owned());
    }
    let compiled = compile(&model).map_err(|wrong| {
        let messages = wrong.iter().map(|wrong| reporter::text(wrong, &model));
        messages.collect::<Vec<_>>().join("; ")
    })?;
    Ok((model, compiled.program))
}
