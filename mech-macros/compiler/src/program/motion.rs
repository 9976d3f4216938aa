//! Rates and forces: what a program computes besides positions.

use super::forces::Forces;
use super::node::{BlockId, Value};

/// Values derived from positions: the rates of all poses, from those of the motors, or forces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    /// For each moving link its angular velocity, and the rates of x and y.
    pub velocities: Vec<[Value; 3]>,
    /// For each moving link its angular acceleration, and the second rates of x and y, if they were asked for.
    pub accelerations: Option<Vec<[Value; 3]>>,
    /// The margins of all loops: negative where a loop's rates are not determined.
    pub margins: Vec<RateMargin>,
    /// The linear systems that are solved as a whole.
    pub systems: Vec<System>,
    /// Forces, if the program computes these; then it computes nothing else.
    pub forces: Option<Forces<Value>>,
    /// The names of all loads' numbers.
    pub loads: Vec<String>,
}

/// A loop's test that it is not at a dead point or a change point.
#[derive(Clone, Debug, PartialEq)]
pub struct RateMargin {
    /// The joints of the loop whose coordinates are unknown, for messages.
    pub place: String,
    /// The determinant's size, less what rounding may make of zero.
    pub margin: Value,
}

/// A linear system of coupled loops.
#[derive(Clone, Debug, PartialEq)]
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

impl Motion {
    /// All values that it consists of.
    pub fn roots(&self) -> impl Iterator<Item = Value> + '_ {
        let accelerations = self.accelerations.iter().flatten().flatten();
        let velocities = self.velocities.iter().flatten();
        let margins = self.margins.iter().map(|margin| margin.margin);
        let forces = self.forces.iter().flat_map(Forces::roots);
        velocities
            .chain(accelerations)
            .copied()
            .chain(margins)
            .chain(forces)
    }
}
