//! The unknowns of a loop.

use crate::model::{JointId, LinkId};

/// An unknown of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Unknown {
    /// The direction of the base of a cluster, seen from the first.
    Direction(LinkId),
    /// The coordinate of a sliding joint.
    Slide(JointId),
}

/// The value of an unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Solution<S> {
    /// A unit vector.
    Direction([S; 2]),
    /// A length.
    Slide(S),
}

impl<S: Copy> Solution<S> {
    /// Whether it is a direction.
    pub(crate) fn is_direction(&self) -> bool {
        matches!(self, Self::Direction(_))
    }

    /// The same with other numbers.
    pub(crate) fn map(&self, other: impl Fn(S) -> S) -> Self {
        match *self {
            Self::Direction(direction) => Self::Direction(direction.map(other)),
            Self::Slide(displacement) => Self::Slide(other(displacement)),
        }
    }

    /// Its numbers: a cosine and a sine, or a length.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = S> + use<S> {
        let (first, second) = match *self {
            Self::Direction([cos, sin]) => (cos, Some(sin)),
            Self::Slide(displacement) => (displacement, None),
        };
        std::iter::once(first).chain(second)
    }
}
