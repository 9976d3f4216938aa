//! The iteration that closes a loop.

use super::node::Value;

/// The greatest gap, as a part of the loop's size, that a linear step may leave.
const LINEAR_GAP: f64 = 2e-3;

/// Newton's iteration on a loop's equations.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Newton {
    /// The number of its loop in the plan.
    pub number: usize,
    /// The joints of the loop whose coordinates are unknown, for messages.
    pub place: String,
    /// The scalars that are iterated: a direction has two, a length one.
    pub scalars: Vec<Scalar>,
    /// The gap of the loop, in scene units.
    pub gap: Vec<Value>,
    /// The determinant: of the 2×2 core of a loop's 3×3 system; of the dense system of coupled loops; or, where joints are
    /// redundant, the square of the one column.
    pub det: Value,
    /// For each unknown, the rates of the gap with it.
    pub columns: Vec<Vec<Value>>,
    /// Whether a step is found by solving the columns' system as a whole. If not, it is written out in formulas.
    pub dense: bool,
    /// The vectors that add to the gap, and where they begin: the sum of their lengths is the loop's size.
    pub sides: Vec<[Value; 2]>,
    /// The square of a round's step, angles in radians and lengths as parts of the loop's size, where the determinant's sign does
    /// not distinguish all assemblies: a step that is not followed by a much smaller one may end in another of them.
    pub step: Option<Value>,
    /// The lengths that are not fixed, where something slides: they add to that size.
    pub extent: Option<Value>,
    /// The number of rounds.
    pub rounds: Rounds,
    /// Whether directions are turned to first order only, as in a step of the linear system.
    pub linear: bool,
    /// The limits that a result must satisfy.
    pub limits: Limits,
}

/// A scalar that is iterated.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Scalar {
    /// Its name.
    pub name: String,
    /// Its value before the first round.
    pub first: Value,
    /// Its value in a round.
    pub now: Value,
    /// Its value in the next round.
    pub next: Value,
}

/// The number of rounds of an iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Rounds {
    /// Until the gap is closed to rounding, but not more than this.
    UntilClosed(u32),
    /// Exactly this many.
    Exactly(u32),
}

impl Rounds {
    /// The greatest gap, as a part of a loop's size, that passes for closed after them. A fixed number of rounds is taken to be enough
    /// if the first leaves no more than a thousandth of the loop's size, and each further one squares what is left.
    #[must_use]
    pub fn accept(self, linear: bool, epsilon: f64) -> f64 {
        let rounding = 16.0 * epsilon;
        match self {
            Self::UntilClosed(_) => rounding,
            Self::Exactly(_) if linear => LINEAR_GAP,
            Self::Exactly(rounds) => {
                let squared = (1..rounds.min(8)).fold(1e-3_f64, |left, _| left * left);
                squared.max(rounding)
            }
        }
    }
}

/// The sizes at the start that all tolerances are relative to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Limits {
    /// The sum of the lengths of the vectors round the loop, in scene units.
    pub size: f64,
    /// The product of the lengths of the two columns: the determinant is at most this, times a sine.
    pub reach: f64,
    /// The absolute value of the determinant.
    pub det: f64,
    /// Whether the determinant is positive at the start. It stays so: it changes its sign at a dead point only.
    pub positive: bool,
}

impl Newton {
    /// The same with other values.
    pub(super) fn map(&self, other: impl Fn(Value) -> Value) -> Self {
        let all = |values: &[Value]| values.iter().map(|value| other(*value)).collect();
        let scalar = |scalar: &Scalar| Scalar {
            name: scalar.name.clone(),
            first: other(scalar.first),
            now: other(scalar.now),
            next: other(scalar.next),
        };
        Self {
            number: self.number,
            place: self.place.clone(),
            scalars: self.scalars.iter().map(scalar).collect(),
            gap: all(&self.gap),
            det: other(self.det),
            columns: self.columns.iter().map(|column| all(column)).collect(),
            dense: self.dense,
            sides: self.sides.iter().map(|side| side.map(&other)).collect(),
            step: self.step.map(&other),
            extent: self.extent.map(&other),
            rounds: self.rounds,
            linear: self.linear,
            limits: self.limits,
        }
    }

    /// The square of its step, if each must be smaller than the one before: a single round has nothing to compare.
    #[must_use]
    pub fn contracting_step(&self) -> Option<Value> {
        self.step.filter(|_| !matches!(self.rounds, Rounds::Exactly(0 | 1)))
    }

    /// Whether the step that was found in the last round is made, too, unless that is the first: what is closed stays as it is. The system
    /// of coupled loops is solved before a round turns out to be the last, and its gap is a part of the size of all rings together, which
    /// leaves more than rounding.
    #[must_use]
    pub fn steps_on(&self) -> bool {
        self.dense && matches!(self.rounds, Rounds::UntilClosed(_))
    }

    /// A gap, as a part of the loop's size, at which no further round is worth while.
    #[must_use]
    pub fn tight(&self, epsilon: f64) -> f64 {
        4.0 * epsilon
    }

    /// The greatest gap, as a part of the loop's size, that passes for closed.
    #[must_use]
    pub fn accept(&self, epsilon: f64) -> f64 {
        self.rounds.accept(self.linear, epsilon)
    }

    /// Whether only rounding is left of the determinant at the start: there the unknowns do not follow from the equations.
    #[must_use]
    pub(crate) fn starts_dead(&self) -> bool {
        self.limits.det <= 64.0 * f64::EPSILON * self.limits.reach
    }

    /// The least determinant, its sign that of the start: a result below it is beyond a dead point or too near one. What is
    /// iterated for want of a closed form stays so far from it that rounding, which shifts a root, leaves it on its branch.
    #[must_use]
    pub fn floor(&self, epsilon: f64) -> f64 {
        match self.contracting_step() {
            None => 64.0 * epsilon * self.limits.reach,
            Some(_) => 64.0 * epsilon.sqrt() * self.limits.det,
        }
    }
}
