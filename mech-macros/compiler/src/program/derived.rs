//! The results of a program besides positions.

use super::forces::Forces;
use super::node::{BlockId, Value};
use super::sensitivity::Sensitivity;

/// The values that a program derives from positions, and the linear equations that it solves for them.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Derived {
    /// The equations.
    pub equations: LinearEquations,
    /// The values.
    pub results: Results,
}

/// The values that a program derives from positions.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Results {
    /// The rates of all poses, from those of the motors.
    Rates(LinkRates<Value>),
    /// Forces.
    Forces {
        /// The forces.
        forces: Forces<Value>,
        /// The names of all loads' numbers.
        loads: Vec<String>,
    },
    /// The rates of everything with each param.
    Sensitivity(Sensitivity),
}

/// The rates of all poses.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LinkRates<V> {
    /// For each moving link its angular velocity, and the rates of x and y.
    pub velocities: Vec<[V; 3]>,
    /// For each moving link its angular acceleration, and the second rates of x and y, if they were asked for.
    pub accelerations: Option<Vec<[V; 3]>>,
}

impl<V: Copy> LinkRates<V> {
    /// All values that they consist of.
    pub fn roots(&self) -> impl Iterator<Item = V> + '_ {
        let accelerations = self.accelerations.iter().flatten();
        self.velocities.iter().chain(accelerations).flatten().copied()
    }

    /// The same rates, each number replaced by what `each` makes of it.
    pub fn map<W>(&self, each: impl Fn(V) -> W) -> LinkRates<W> {
        let rows = |rates: &Vec<[V; 3]>| rates.iter().map(|rates| rates.map(&each)).collect();
        LinkRates {
            velocities: rows(&self.velocities),
            accelerations: self.accelerations.as_ref().map(rows),
        }
    }
}

/// The linear equations of loops and of equilibrium.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LinearEquations {
    /// The margins of all loops: negative where a loop's rates are not determined.
    pub margins: Vec<RateMargin>,
    /// The linear systems that are solved as a whole.
    pub systems: Vec<System>,
}

/// A loop's test that it is not at a dead point or a change point.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RateMargin {
    /// The joints of the loop whose coordinates are unknown, for messages.
    pub place: String,
    /// The determinant's size, less what rounding may make of zero.
    pub margin: Value,
}

/// A linear system of coupled loops.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct System {
    /// The block in which it is solved.
    pub block: BlockId,
    /// For each unknown the rates of the gaps with it.
    pub columns: Vec<Vec<Value>>,
    /// The right side: with the columns times the unknowns it adds to zero.
    pub right: Vec<Value>,
}

impl System {
    /// All values that it is made of.
    pub(crate) fn coefficients(&self) -> impl Iterator<Item = &Value> {
        self.columns.iter().flatten().chain(&self.right)
    }
}

impl Derived {
    /// All values that it consists of.
    pub(super) fn roots(&self) -> Vec<Value> {
        let mut roots = match &self.results {
            Results::Rates(rates) => rates.roots().collect(),
            Results::Forces { forces, .. } => forces.roots(),
            Results::Sensitivity(sensitivity) => sensitivity.roots().collect(),
        };
        roots.extend(self.equations.margins.iter().map(|margin| margin.margin));
        roots
    }
}
