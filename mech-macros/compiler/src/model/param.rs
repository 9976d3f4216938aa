//! Numbers that may be changed while a mechanism runs, and what is computed from them.

use super::{Axis, FormulaId, Model, Origin, ParamId};

/// A number that may be changed while the mechanism runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// Its name.
    pub name: String,
    /// Where its name was declared.
    pub origin: Origin,
    /// Its value at the start, when the mechanism is assembled.
    pub value: f64,
}

/// How a number is computed that depends on params.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Formula {
    /// A number that does not.
    Constant(f64),
    /// The value of a param.
    Param(ParamId),
    /// −a.
    Neg(FormulaId),
    /// a + b.
    Add(FormulaId, FormulaId),
    /// a − b.
    Sub(FormulaId, FormulaId),
    /// a · b.
    Mul(FormulaId, FormulaId),
    /// a / b.
    Div(FormulaId, FormulaId),
    /// The square root.
    Sqrt(FormulaId),
    /// The sine of an angle in radians.
    Sin(FormulaId),
    /// The cosine of an angle in radians.
    Cos(FormulaId),
}

/// The params of a mechanism, and every number that is computed from them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Params {
    all: Vec<Param>,
    /// Each after those it is made from.
    formulas: Vec<Formula>,
}

/// What formulas are evaluated in: numbers, the values of a program, Rust tokens.
pub trait Arithmetic {
    /// A number.
    type Scalar: Clone;

    /// A constant.
    fn constant(&mut self, value: f64) -> Self::Scalar;
    /// The value of a param.
    fn param(&mut self, param: ParamId) -> Self::Scalar;
    /// −a.
    fn neg(&mut self, a: Self::Scalar) -> Self::Scalar;
    /// a + b.
    fn add(&mut self, a: Self::Scalar, b: Self::Scalar) -> Self::Scalar;
    /// a − b.
    fn sub(&mut self, a: Self::Scalar, b: Self::Scalar) -> Self::Scalar;
    /// a · b.
    fn mul(&mut self, a: Self::Scalar, b: Self::Scalar) -> Self::Scalar;
    /// a / b.
    fn div(&mut self, a: Self::Scalar, b: Self::Scalar) -> Self::Scalar;
    /// The square root.
    fn sqrt(&mut self, a: Self::Scalar) -> Self::Scalar;
    /// The sine of an angle in radians.
    fn sin(&mut self, a: Self::Scalar) -> Self::Scalar;
    /// The cosine of an angle in radians.
    fn cos(&mut self, a: Self::Scalar) -> Self::Scalar;
}

impl Params {
    /// Adds a param after all others.
    pub fn add(&mut self, param: Param) -> ParamId {
        self.all.push(param);
        ParamId::new(self.all.len() - 1)
    }

    /// Adds a formula, unless it is known: equal formulas are one.
    pub fn formula(&mut self, formula: Formula) -> FormulaId {
        let known = self.formulas.iter().position(|known| *known == formula);
        FormulaId::new(known.unwrap_or_else(|| {
            self.formulas.push(formula);
            self.formulas.len() - 1
        }))
    }

    /// All params, in the order in which `set_params` takes their values.
    #[must_use]
    pub fn all(&self) -> &[Param] {
        &self.all
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// The ids of all params.
    pub fn ids(&self) -> impl ExactSizeIterator<Item = ParamId> + use<> {
        (0..self.all.len()).map(ParamId::new)
    }

    /// The values of all params at the start.
    pub fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.all.iter().map(|param| param.value)
    }

    /// All formulas, each evaluated once, by their numbers.
    pub fn evaluate<A: Arithmetic>(&self, arithmetic: &mut A) -> Vec<A::Scalar> {
        let mut values: Vec<A::Scalar> = Vec::with_capacity(self.formulas.len());
        for formula in &self.formulas {
            let get = |id: FormulaId| values[id.index()].clone();
            let value = match *formula {
                Formula::Constant(value) => arithmetic.constant(value),
                Formula::Param(param) => arithmetic.param(param),
                Formula::Neg(a) => arithmetic.neg(get(a)),
                Formula::Add(a, b) => arithmetic.add(get(a), get(b)),
                Formula::Sub(a, b) => arithmetic.sub(get(a), get(b)),
                Formula::Mul(a, b) => arithmetic.mul(get(a), get(b)),
                Formula::Div(a, b) => arithmetic.div(get(a), get(b)),
                Formula::Sqrt(a) => arithmetic.sqrt(get(a)),
                Formula::Sin(a) => arithmetic.sin(get(a)),
                Formula::Cos(a) => arithmetic.cos(get(a)),
            };
            values.push(value);
        }
        values
    }
}

impl Axis {
    /// Whether where it is in its link depends on a param.
    #[must_use]
    pub fn varies(&self) -> bool {
        self.formulas.iter().any(Option::is_some)
    }
}

impl Model {
    /// How many numbers are given from outside: the values of the motors, and after these those of the params.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.motors.len() + self.params.len()
    }

    /// How far a param has to go until some axis has gone as far as the mechanism is large, as far as its slope at the start tells:
    /// none if nothing depends on it.
    #[must_use]
    pub fn param_scale(&self, param: ParamId) -> Option<f64> {
        let slopes = self.params.evaluate(&mut Slopes {
            params: &self.params,
            by: param,
        });
        let used = self.axes.iter().flat_map(|axis| axis.formulas).flatten();
        let slopes = used.map(|formula| slopes[formula.index()]);
        let steepest = slopes.map(|(_, slope)| slope.abs()).fold(0.0, f64::max);
        let scale = self.size().max(f64::MIN_POSITIVE) / steepest;
        scale.is_finite().then_some(scale)
    }
}

/// Numbers at the start with their slopes: by how much each grows with one param.
struct Slopes<'p> {
    params: &'p Params,
    by: ParamId,
}

impl Arithmetic for Slopes<'_> {
    type Scalar = (f64, f64);

    fn constant(&mut self, value: f64) -> (f64, f64) {
        (value, 0.0)
    }

    fn param(&mut self, param: ParamId) -> (f64, f64) {
        let value = self.params.all[param.index()].value;
        (value, if param == self.by { 1.0 } else { 0.0 })
    }

    fn neg(&mut self, (a, da): (f64, f64)) -> (f64, f64) {
        (-a, -da)
    }

    fn add(&mut self, (a, da): (f64, f64), (b, db): (f64, f64)) -> (f64, f64) {
        (a + b, da + db)
    }

    fn sub(&mut self, (a, da): (f64, f64), (b, db): (f64, f64)) -> (f64, f64) {
        (a - b, da - db)
    }

    fn mul(&mut self, (a, da): (f64, f64), (b, db): (f64, f64)) -> (f64, f64) {
        (a * b, da * b + a * db)
    }

    fn div(&mut self, (a, da): (f64, f64), (b, db): (f64, f64)) -> (f64, f64) {
        (a / b, (da - a / b * db) / b)
    }

    fn sqrt(&mut self, (a, da): (f64, f64)) -> (f64, f64) {
        let root = libm::sqrt(a);
        (root, if da == 0.0 { 0.0 } else { 0.5 * da / root })
    }

    fn sin(&mut self, (a, da): (f64, f64)) -> (f64, f64) {
        (libm::sin(a), da * libm::cos(a))
    }

    fn cos(&mut self, (a, da): (f64, f64)) -> (f64, f64) {
        (libm::cos(a), -da * libm::sin(a))
    }
}
