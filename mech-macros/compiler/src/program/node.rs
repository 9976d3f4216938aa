//! Values and the operations that make them.

use super::Position;
use crate::model::{InputId, MotorId, Number, in_32_bits};
use mech_core::{Real, Staircase};

/// A scalar: the result of one node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Value(pub(super) u32);

impl Value {
    /// The result of the node in this position.
    pub(crate) fn at(index: usize) -> Self {
        Self(in_32_bits(index))
    }

    /// Its position among the nodes.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A block of a program: one step of the plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BlockId(pub(super) u32);

impl BlockId {
    /// The block that runs first.
    pub(crate) const FIRST: Self = Self(0);

    /// The block in this position.
    pub(super) fn at(index: usize) -> Self {
        Self(in_32_bits(index))
    }

    /// Its position among the blocks.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A number of the last position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Slot {
    /// A number of the pose of a link, by its position among the links that a position stores.
    Pose(usize, Part),
    /// A number that is carried from position to position: an angle that a gear needs unwrapped, or on which side a dyad
    /// lies that passes change points.
    State(usize),
}

/// A number of a pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Part {
    /// The cosine of its angle.
    Cos,
    /// The sine of its angle.
    Sin,
    /// The abscissa of its origin.
    X,
    /// The ordinate of its origin.
    Y,
}

impl Part {
    /// All four, in the order in which poses are stored.
    pub const ALL: [Self; 4] = [Self::Cos, Self::Sin, Self::X, Self::Y];

    /// Its position in that order.
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }
}

/// An operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Op {
    /// A constant.
    Constant(Number),
    /// A motor's value, less whole turns, or a param's.
    Input(InputId),
    /// The whole turns of a motor, which are counted apart from its value.
    Turns(InputId),
    /// A fraction (numerator and denominator) of a motor's whole turns, as an angle in radians without whole turns.
    PartOfTurns(InputId, i64, i64),
    /// A number of the last position.
    Last(Slot),
    /// An unknown of a loop while it is being solved.
    Unknown(BlockId, usize),
    /// An unknown of a loop after it was solved.
    Solved(BlockId, usize),
    /// A result of a loop's dense system in a round: the steps of its unknowns, and after these its determinant.
    Dense(BlockId, usize),
    /// The time, of which the laws of motors are functions.
    Time,
    /// The rate given to a motor, by its number.
    Rate(MotorId),
    /// The second rate given to a motor, by its number.
    Acceleration(MotorId),
    /// A number of a load, by its position among those of all loads.
    Load(usize),
    /// A result of a linear system of the motion, by its number: the unknowns, and after these the determinant.
    Linear(usize, usize),
    /// −a.
    Neg(Value),
    /// The absolute value.
    Abs(Value),
    /// The square root.
    Sqrt(Value),
    /// a + b.
    Add(Value, Value),
    /// a − b.
    Sub(Value, Value),
    /// a · b.
    Mul(Value, Value),
    /// a / b.
    Div(Value, Value),
    /// The sine of an angle in radians.
    Sin(Value),
    /// The cosine of an angle in radians.
    Cos(Value),
    /// The greater of two numbers.
    Max(Value, Value),
    /// The size of a with the sign of b.
    CopySign(Value, Value),
    /// The second value if the first is not negative, else the third.
    Choose(Value, Value, Value),
    /// The angle in (−π, π] of the vector (b, a).
    Atan2(Value, Value),
    /// The nearest whole number.
    Round(Value),
    /// e to this power.
    Exp(Value),
    /// The height of a staircase at a place, of which each step takes this share.
    Stairs(Staircase, Value, Number),
}

impl Op {
    /// The values it is made from.
    pub fn operands(self) -> impl Iterator<Item = Value> {
        let mut operands = [None; 3];
        let mut places = operands.iter_mut();
        let _ = self.map(|operand| {
            if let Some(place) = places.next() {
                *place = Some(operand);
            }
            operand
        });
        operands.into_iter().flatten()
    }

    /// The same operation on other values.
    #[must_use]
    pub(crate) fn map(self, mut other: impl FnMut(Value) -> Value) -> Self {
        match self {
            Self::Neg(a) => Self::Neg(other(a)),
            Self::Abs(a) => Self::Abs(other(a)),
            Self::Sqrt(a) => Self::Sqrt(other(a)),
            Self::Add(a, b) => Self::Add(other(a), other(b)),
            Self::Sub(a, b) => Self::Sub(other(a), other(b)),
            Self::Mul(a, b) => Self::Mul(other(a), other(b)),
            Self::Div(a, b) => Self::Div(other(a), other(b)),
            Self::Sin(a) => Self::Sin(other(a)),
            Self::Cos(a) => Self::Cos(other(a)),
            Self::Max(a, b) => Self::Max(other(a), other(b)),
            Self::CopySign(a, b) => Self::CopySign(other(a), other(b)),
            Self::Choose(test, a, b) => Self::Choose(other(test), other(a), other(b)),
            Self::Atan2(a, b) => Self::Atan2(other(a), other(b)),
            Self::Round(a) => Self::Round(other(a)),
            Self::Exp(a) => Self::Exp(other(a)),
            Self::Stairs(stairs, place, share) => Self::Stairs(stairs, other(place), share),
            Self::Constant(_)
            | Self::Input(_)
            | Self::Turns(_)
            | Self::PartOfTurns(..)
            | Self::Last(_)
            | Self::Unknown(..)
            | Self::Solved(..)
            | Self::Dense(..)
            | Self::Time
            | Self::Rate(_)
            | Self::Acceleration(_)
            | Self::Load(_)
            | Self::Linear(..) => self,
        }
    }
}

/// A value in its place.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Node {
    /// The operation that makes it.
    pub op: Op,
    /// The block in which it is made.
    pub block: BlockId,
    /// Whether it is made anew in every round of its block's iteration.
    pub iterated: bool,
    /// Its name, if it means something to a reader.
    pub name: Option<String>,
}

impl Op {
    /// The result of the operation, if it is arithmetic on values; the others come from outside.
    // Programs are run many thousand times while they are compiled, and a compiler itself is often built without optimisation.
    #[expect(
        clippy::inline_always,
        reason = "without optimisation a call costs more than the operation"
    )]
    #[inline(always)]
    pub fn apply<T: Real>(self, get: impl Fn(Value) -> T) -> Option<T> {
        Some(match self {
            Self::Constant(number) => T::from_f64(number.get()),
            Self::Neg(a) => -get(a),
            Self::Abs(a) => get(a).abs(),
            Self::Sqrt(a) => get(a).sqrt(),
            Self::Add(a, b) => get(a) + get(b),
            Self::Sub(a, b) => get(a) - get(b),
            Self::Mul(a, b) => get(a) * get(b),
            Self::Div(a, b) => get(a) / get(b),
            Self::Sin(a) => get(a).sin_cos().0,
            Self::Cos(a) => get(a).sin_cos().1,
            Self::Max(a, b) => get(a).max(get(b)),
            Self::CopySign(a, b) => get(a).copysign(get(b)),
            Self::Choose(test, a, b) => {
                if get(test) >= T::ZERO {
                    get(a)
                } else {
                    get(b)
                }
            }
            Self::Atan2(a, b) => get(a).atan2(get(b)),
            Self::Round(a) => get(a).round(),
            Self::Exp(a) => get(a).exp(),
            Self::Stairs(stairs, place, share) => stairs.at(get(place), T::from_f64(share.get())),
            // All others come from outside.
            _ => return None,
        })
    }

    /// The result of the operation at the start, where nothing has turned, moves or acts, and no step is missing.
    pub(super) fn at_start(self, start: &Position<f64>, get: impl Fn(Value) -> f64) -> f64 {
        match self {
            Self::Input(input) => start.motors[input.index()],
            Self::Last(slot) => start.at(slot),
            // All else that comes from outside is zero.
            op => op.apply(get).unwrap_or(0.0),
        }
    }
}
