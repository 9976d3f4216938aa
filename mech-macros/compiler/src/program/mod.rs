//! The program: straight-line operations on scalars, block by block, from motor values and the last position to the next
//! position. Emitting it as Rust and running it now are readings of the same thing.

mod build;
mod builder;
mod calibrate;
mod dense;
mod live;
mod newton;
mod node;
mod real;

pub use build::build;
pub(crate) use dense::solve;
pub use newton::{Limits, Newton, Rounds, Scalar};
pub use node::{BlockId, Node, Number, Op, Part, Slot, Value};
pub use real::Real;

use crate::model::Precision;

/// A straight-line program.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// The name of the mechanism.
    pub name: String,
    /// What it computes in.
    pub precision: Precision,
    /// All values, each after those it is made from.
    pub nodes: Vec<Node>,
    /// The blocks, in the order in which they run.
    pub blocks: Vec<Block>,
    /// The names of the motors' joints.
    pub motors: Vec<String>,
    /// The names of the moving links.
    pub links: Vec<String>,
    /// For each moving link the cosine, sine, x and y of its new pose.
    pub poses: Vec<[Value; 4]>,
    /// The new values of the angles that are kept unwrapped.
    pub angles: Vec<Value>,
    /// Which values anything depends on.
    pub live: Vec<bool>,
    /// The position in which the mechanism is assembled.
    pub start: Position<f64>,
}

/// One step of the plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// What it is called: a function's name.
    pub name: String,
    /// What it does, for a reader.
    pub title: String,
    /// How.
    pub kind: BlockKind,
}

/// How a block works.
#[derive(Clone, Debug, PartialEq)]
pub enum BlockKind {
    /// One operation after another.
    Straight,
    /// The same, with an iteration in it.
    Newton(Newton),
}

/// A position of a mechanism: everything that is carried from one move to the next.
#[derive(Clone, Debug, PartialEq)]
pub struct Position<T> {
    /// The values of the motors.
    pub motors: Vec<T>,
    /// For each moving link the cosine, sine, x and y of its pose.
    pub poses: Vec<[T; 4]>,
    /// The unwrapped angles.
    pub angles: Vec<T>,
}

impl Program {
    /// Whether its constants and its start are within the range of the scalar type.
    #[must_use]
    pub fn fits(&self) -> bool {
        let start = self.start.poses.iter().flatten().chain(&self.start.angles);
        let constants = self.nodes.iter().filter_map(|node| match node.op {
            Op::Constant(number) => Some(number.get()),
            _ => None,
        });
        start
            .copied()
            .chain(constants)
            .all(|number| self.precision.holds(number))
    }

    /// The node that makes a value.
    #[must_use]
    pub fn node(&self, value: Value) -> &Node {
        &self.nodes[value.index()]
    }

    /// All values that something depends on, each after those it is made from.
    pub fn live_values(&self) -> impl Iterator<Item = Value> + '_ {
        (0u32..)
            .map(Value)
            .zip(&self.live)
            .filter(|(_, live)| **live)
            .map(|(value, _)| value)
    }

    /// The loop of a block, if it solves one.
    #[must_use]
    pub fn newton(&self, block: BlockId) -> Option<&Newton> {
        match &self.blocks[block.index()].kind {
            BlockKind::Newton(newton) => Some(newton),
            BlockKind::Straight => None,
        }
    }

    /// The ids of all blocks, in the order in which they run.
    pub fn block_ids(&self) -> impl Iterator<Item = BlockId> + use<> {
        (0u32..).take(self.blocks.len()).map(BlockId)
    }
}
