//! Laws: functions of one variable, which a motor follows in time, or the follower of a cam.

use super::formula::Now;
use super::{
    Arithmetic, BinaryFunction, Formula, FormulaArithmetic, FormulaId, Formulas, Function, Number,
    Origin, ParamId,
};
use mech_core::Staircase;
use std::f64::consts::TAU;

/// A function of one variable.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Law {
    /// All that it is made from.
    formulas: Formulas,
    /// Which of these it is.
    value: FormulaId,
    /// As it was written.
    pub written: String,
    /// Where it was declared.
    pub origin: Origin,
}

impl Law {
    /// The function that is this one of some formulas.
    #[must_use]
    pub fn new(formulas: Formulas, value: FormulaId, written: String, origin: Origin) -> Self {
        Self { formulas, value, written, origin }
    }

    /// All formulas that it is made from, each after those that it needs.
    #[must_use]
    pub fn formulas(&self) -> &Formulas {
        &self.formulas
    }

    /// Which of its formulas it is.
    #[must_use]
    pub fn value(&self) -> FormulaId {
        self.value
    }

    /// Its value in an arithmetic.
    pub fn evaluate<A: FormulaArithmetic>(&self, arithmetic: &mut A) -> A::Scalar {
        self.formulas.evaluate_one(self.value, arithmetic)
    }

    /// Its value for a value of the variable and of all params: not finite where it has none.
    #[must_use]
    pub fn at(&self, variable: f64, params: &[f64]) -> f64 {
        self.evaluate(&mut Now { variables: &[variable], params })
    }
}

/// Values of params, from their numbers. What is the same with both does not depend on what the params are.
const SAMPLES: [fn(f64) -> f64; 2] = [f64::sqrt, f64::cbrt];

/// The change of a number when the variable grows by a whole turn.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Winding {
    /// It never changes.
    Fixed(f64),
    /// When the variable makes a whole turn, the value grows by so many whole turns.
    By(f64),
    /// Otherwise.
    Else,
}

impl Winding {
    fn by(self) -> Option<f64> {
        match self {
            Self::Fixed(_) => Some(0.0),
            Self::By(turns) => Some(turns),
            Self::Else => None,
        }
    }

    /// Combines two of them: `turns` gives the turns of the result from those of both.
    fn join(self, other: Self, turns: impl FnOnce(f64, f64) -> Option<f64>) -> Self {
        let both = self.by().zip(other.by());
        both.and_then(|(a, b)| turns(a, b)).map_or(Self::Else, Self::By)
    }
}

impl Law {
    /// By how many whole turns its value goes on when the variable does by one: zero, if it is periodic. Nothing, if that depends
    /// on where it is, or is unknown.
    #[must_use]
    pub fn winding(&self) -> Option<f64> {
        let [first, second] = SAMPLES.map(|sample| self.evaluate(&mut Windings { sample }).by());
        let (turns, other) = (first?, second?);
        ((turns - other).abs() <= ROUNDING * turns.abs()).then_some(turns)
    }

    /// Whether it is one number, whatever its variable and the params are.
    #[must_use]
    pub fn is_fixed(&self) -> bool {
        let mut all = self.formulas.all().iter();
        !all.any(|formula| matches!(formula, Formula::Variable(_) | Formula::Param(_)))
    }

    /// Whether it is made of segments.
    #[must_use]
    pub fn is_motion(&self) -> bool {
        let mut all = self.formulas.all().iter();
        all.any(|formula| matches!(formula, Formula::Stairs(..)))
    }

    /// Whether its variable is in it.
    #[must_use]
    pub fn varies(&self) -> bool {
        self.formulas.all().contains(&Formula::Variable(0))
    }
}

/// Numbers that differ less than by this part of them differ by rounding.
const ROUNDING: f64 = 1e-12;

impl Formulas {
    /// Whether a number is zero whatever the params are.
    pub(crate) fn is_always_zero(&self, number: FormulaId) -> bool {
        SAMPLES.iter().all(|sample| {
            let mut windings = Windings { sample: *sample };
            self.evaluate_one(number, &mut windings) == Winding::Fixed(0.0)
        })
    }
}

/// The sum of two numbers; zero, if only rounding is left of them.
fn sum(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if sum.abs() <= ROUNDING * a.abs() { 0.0 } else { sum }
}

/// The arithmetic of how numbers change over a whole turn.
struct Windings {
    /// From a whole number for each param the number that stands for it.
    sample: fn(f64) -> f64,
}

impl Windings {
    /// The result of two numbers that both have to stay as they are.
    fn still(a: Winding, b: Winding) -> Winding {
        a.join(b, |a, b| (a == 0.0 && b == 0.0).then_some(0.0))
    }
}

impl Arithmetic for Windings {
    type Scalar = Winding;

    fn constant(&mut self, value: f64) -> Winding {
        Winding::Fixed(value)
    }

    fn neg(&mut self, a: Winding) -> Winding {
        match a {
            Winding::Fixed(a) => Winding::Fixed(-a),
            a => a.join(Winding::By(0.0), |a, _| Some(-a)),
        }
    }

    fn add(&mut self, a: Winding, b: Winding) -> Winding {
        match (a, b) {
            (Winding::Fixed(a), Winding::Fixed(b)) => Winding::Fixed(a + b),
            (a, b) => a.join(b, |a, b| Some(sum(a, b))),
        }
    }

    fn sub(&mut self, a: Winding, b: Winding) -> Winding {
        match (a, b) {
            (Winding::Fixed(a), Winding::Fixed(b)) => Winding::Fixed(a - b),
            (a, b) => a.join(b, |a, b| Some(sum(a, -b))),
        }
    }

    fn mul(&mut self, a: Winding, b: Winding) -> Winding {
        match (a, b) {
            (Winding::Fixed(a), Winding::Fixed(b)) => Winding::Fixed(a * b),
            (Winding::Fixed(factor), Winding::By(turns))
            | (Winding::By(turns), Winding::Fixed(factor)) => Winding::By(factor * turns),
            (a, b) => Self::still(a, b),
        }
    }

    fn div(&mut self, a: Winding, b: Winding) -> Winding {
        match (a, b) {
            (Winding::Fixed(a), Winding::Fixed(b)) => Winding::Fixed(a / b),
            (Winding::By(turns), Winding::Fixed(divisor)) => Winding::By(turns / divisor),
            (a, b) => Self::still(a, b),
        }
    }
}

impl FormulaArithmetic for Windings {
    fn variable(&mut self, _: usize) -> Winding {
        Winding::By(1.0)
    }

    // It stays what it is while the variable goes on.
    fn param(&mut self, param: ParamId) -> Winding {
        #[expect(clippy::cast_precision_loss, reason = "a small whole number")]
        let number = param.index() as f64;
        Winding::Fixed((self.sample)(number + 2.0))
    }

    fn of(&mut self, function: Function, a: Winding) -> Winding {
        if let Winding::Fixed(a) = a {
            return Winding::Fixed(function.at(a));
        }
        let periodic = |turns: f64| turns == 0.0 || function.is_periodic() && turns.fract() == 0.0;
        a.join(Winding::By(0.0), |a, _| periodic(a).then_some(0.0))
    }

    fn of_both(&mut self, function: BinaryFunction, a: Winding, b: Winding) -> Winding {
        match (function, a, b) {
            (function, Winding::Fixed(a), Winding::Fixed(b)) => Winding::Fixed(function.at(a, b)),
            (BinaryFunction::Min | BinaryFunction::Max, a, b) => {
                a.join(b, |a, b| (a == b).then_some(a))
            }
            // A number that goes on by whole times the divisor is where it was.
            (BinaryFunction::Mod, Winding::By(turns), Winding::Fixed(by))
                if (turns * TAU / by).fract() == 0.0 =>
            {
                Winding::By(0.0)
            }
            (_, a, b) => Self::still(a, b),
        }
    }

    fn stairs(&mut self, stairs: Staircase, place: Winding, share: Number) -> Winding {
        if let Winding::Fixed(place) = place {
            return Winding::Fixed(stairs.at(place, share.get()));
        }
        place.join(Winding::By(0.0), |turns, _| {
            let steps = turns * TAU;
            let whole = steps.round();
            let is_whole = (steps - whole).abs() <= ROUNDING * whole.abs();
            (steps == 0.0 || stairs.repeats && is_whole).then_some(whole / TAU)
        })
    }
}
