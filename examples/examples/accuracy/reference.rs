//! The same mechanism in thirty digits.

use crate::contestant::Poses;
use crate::double_double::DoubleDouble;
use mech_compiler::evaluate::Machine;
use mech_compiler::program::Program;
use mech_compiler::{compile, reporter, syntax};
use mech_runtime::Real;
use proc_macro2::TokenStream;

/// A mechanism as its text says, run by the interpreter in more digits than any contestant has.
pub(crate) struct Reference {
    exact: Program,
    newton: Program,
    /// The axes of the moving links: the link, and where in its frame.
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
    /// What is wrong with it.
    pub(crate) fn new(text: &str) -> Result<Self, String> {
        let (exact, axes) = program(text, "exact")?;
        let (newton, _) = program(text, "newton")?;
        let [start] = exact.start.motors[..] else {
            return Err("it does not have one motor".to_owned());
        };
        let places: Vec<[f64; 2]> = axes
            .iter()
            .map(|(link, at)| match link {
                None => *at,
                Some(link) => placed(exact.start.poses[*link], *at),
            })
            .collect();
        let far = |a: &[f64; 2]| {
            let distances = places.iter().map(|b| (b[0] - a[0]).hypot(b[1] - a[1]));
            distances.fold(0.0, f64::max)
        };
        let size = places.iter().map(far).fold(0.0, f64::max);
        let points = axes.into_iter();
        let points = points.filter_map(|(link, at)| Some((link?, at))).collect();
        Ok(Self {
            exact,
            newton,
            points,
            size,
            start,
        })
    }

    /// The positions for these values of the motor.
    ///
    /// # Errors
    /// Where it cannot go.
    pub(crate) fn trace(&self, values: &[f64]) -> Result<Vec<Poses<DoubleDouble>>, String> {
        run(&self.exact, values)
    }

    /// The greatest distance between positions found in closed form and by iteration: how far the reference is to be trusted. The
    /// two share no constants but the lengths.
    ///
    /// # Errors
    /// Where one of them cannot go.
    pub(crate) fn doubt(&self, values: &[f64]) -> Result<f64, String> {
        let (exact, newton) = (run(&self.exact, values)?, run(&self.newton, values)?);
        let pairs = exact.iter().zip(&newton);
        Ok(pairs
            .map(|(exact, newton)| self.distance(exact, newton))
            .fold(0.0, f64::max))
    }

    /// The greatest distance between an axis in these positions and in those of the reference, over all positions.
    pub(crate) fn error(
        &self,
        trace: &[Poses<f64>],
        reference: &[Poses<DoubleDouble>],
    ) -> f64 {
        let pairs = trace.iter().zip(reference);
        pairs
            .map(|(poses, reference)| {
                let poses: Poses<DoubleDouble> = poses
                    .iter()
                    .map(|pose| pose.map(DoubleDouble::from))
                    .collect();
                self.distance(&poses, reference)
            })
            .fold(0.0, f64::max)
    }

    fn distance(&self, a: &[[DoubleDouble; 4]], b: &[[DoubleDouble; 4]]) -> f64 {
        let distance = |&(link, [x, y]): &(usize, [f64; 2])| {
            let (a, b) = (a[link], b[link]);
            let [cos, sin, dx, dy] = [0, 1, 2, 3].map(|part| (a[part] - b[part]).to_f64());
            (dx + cos * x - sin * y).hypot(dy + sin * x + cos * y)
        };
        self.points.iter().map(distance).fold(0.0, f64::max)
    }
}

fn placed([cos, sin, x, y]: [f64; 4], [u, v]: [f64; 2]) -> [f64; 2] {
    [x + cos * u - sin * v, y + sin * u + cos * v]
}

/// The axes of the ground and the declared links: the link, if it moves, and where in its frame.
type Axes = Vec<(Option<usize>, [f64; 2])>;

fn program(text: &str, method: &str) -> Result<(Program, Axes), String> {
    let text = format!("struct Reference: f64; {text} method {method};");
    let tokens: TokenStream = text.parse().map_err(|_| "it is not Rust".to_owned())?;
    let parsed = syntax::parse(tokens);
    if let Some(error) = parsed.errors.first() {
        return Err(error.text.clone());
    }
    let model = parsed.model;
    let compiled = compile(&model).map_err(|wrong| {
        let told: Vec<String> = wrong
            .iter()
            .map(|wrong| reporter::text(wrong, &model))
            .collect();
        told.join("; ")
    })?;
    let declared = |axis: &&mech_compiler::model::Axis| model.link(axis.link).die.is_none();
    let axes = model.axes.iter().filter(declared);
    let axes = axes.map(|axis| (axis.link.index().checked_sub(1), axis.at));
    let axes = axes.collect();
    Ok((compiled.program, axes))
}

fn run(program: &Program, values: &[f64]) -> Result<Vec<Poses<DoubleDouble>>, String> {
    let mut machine = Machine::<DoubleDouble>::new(program);
    let step = |&value: &f64| {
        let gone = machine.move_to(&[value.into()]);
        gone.map_err(|stop| format!("the reference stops at {value}: {stop:?}"))?;
        Ok(machine.position().poses.clone())
    };
    values.iter().map(step).collect()
}
