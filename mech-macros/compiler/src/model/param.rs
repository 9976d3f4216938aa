//! Numbers that may be changed while a mechanism runs.

use super::formula::Slopes;
use super::{
    Axis, Formula, FormulaArithmetic, FormulaId, Formulas, JointKind, Law, Model, Origin, ParamId,
};
use std::f64::consts::TAU;

/// A number that may be changed while the mechanism runs.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Param {
    /// Its name.
    pub name: String,
    /// Where its name was declared.
    pub origin: Origin,
    /// Its value at the start, when the mechanism is assembled.
    pub value: f64,
}

/// The params of a mechanism, and every number that is computed from them.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Params {
    all: Vec<Param>,
    formulas: Formulas,
}

impl Params {
    /// Adds a param after all others.
    pub fn add(&mut self, param: Param) -> ParamId {
        self.all.push(param);
        ParamId::new(self.all.len() - 1)
    }

    /// Adds a formula, unless it is known: equal formulas are one.
    pub fn formula(&mut self, formula: Formula) -> FormulaId {
        self.formulas.add(formula)
    }

    /// Every number that is computed from params.
    pub(crate) fn formulas_mut(&mut self) -> &mut Formulas {
        &mut self.formulas
    }

    /// All params, in the order in which `set_params` takes their values.
    #[must_use]
    pub fn all(&self) -> &[Param] {
        &self.all
    }

    /// Returns the number of params.
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
    pub fn evaluate<A: FormulaArithmetic>(&self, arithmetic: &mut A) -> Vec<A::Scalar> {
        self.formulas.evaluate(arithmetic)
    }

    /// One formula, without any that it is not made from.
    pub fn evaluate_one<A: FormulaArithmetic>(
        &self,
        id: FormulaId,
        arithmetic: &mut A,
    ) -> A::Scalar {
        self.formulas.evaluate_one(id, arithmetic)
    }
}

impl Axis {
    /// Whether where it is in its link, or its direction there, depends on a param.
    #[must_use]
    pub fn varies(&self) -> bool {
        self.all_formulas().next().is_some()
    }

    /// Whether its direction in its link depends on a param.
    #[must_use]
    pub fn turns(&self) -> bool {
        self.direction_formulas.iter().any(Option::is_some)
    }

    /// Returns the formulas of all its numbers that depend on params.
    pub(crate) fn all_formulas(&self) -> impl Iterator<Item = FormulaId> + '_ {
        let all = self.formulas.iter().chain(&self.direction_formulas);
        all.flatten().copied()
    }
}

impl Model {
    /// Returns the number of inputs: the values of the motors, and after these those of the params.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.motors.len() + self.params.len()
    }

    /// The value of a law for a value of its variable, with the params as they are at the start.
    #[must_use]
    pub fn at_start(&self, law: &Law, variable: f64) -> f64 {
        law.at(variable, &self.params.values().collect::<Vec<f64>>())
    }

    /// By how much a param must change until some axis or follower has moved as far as the mechanism is large, by its slope at the
    /// start: none if nothing depends on it.
    #[must_use]
    pub fn param_scale(&self, param: ParamId) -> Option<f64> {
        let params: Vec<f64> = self.params.values().collect();
        let slopes =
            self.params.evaluate(&mut Slopes { variables: &[], params: &params, by: Some(param) });
        let size = self.size().max(f64::MIN_POSITIVE);
        let slope = |formula: FormulaId| slopes[formula.index()].1.abs();
        let axes = self.axes.iter().map(|axis| {
            let [placed, turned] = [axis.formulas, axis.direction_formulas]
                .map(|formulas| formulas.into_iter().flatten().map(slope).fold(0.0, f64::max));
            placed.max(size * turned)
        });
        let followers = self.cams().map(|(_, _, follower, law)| {
            let slides = matches!(self.joint(follower).kind, JointKind::Prismatic(..));
            let steepest = steepest(law, param, &params);
            if slides { steepest } else { steepest * size }
        });
        let scale = size / axes.chain(followers).fold(0.0, f64::max);
        scale.is_finite().then_some(scale)
    }
}

/// The greatest slope of a law by a param, at some places of a turn.
fn steepest(law: &Law, by: ParamId, params: &[f64]) -> f64 {
    const PLACES: u8 = 16;
    let places = (0..PLACES).map(|place| TAU * f64::from(place) / f64::from(PLACES));
    let slopes = places.map(|variable| {
        let (_, slope) =
            law.evaluate(&mut Slopes { variables: &[(variable, 0.0)], params, by: Some(by) });
        slope.abs()
    });
    // Places where it has none do not count.
    slopes.filter(|slope| slope.is_finite()).fold(0.0, f64::max)
}
