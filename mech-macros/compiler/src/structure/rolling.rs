//! Rolling pairs: gears, belts and racks.

use super::pin::Pin;
use super::welded::Welded;
use crate::model::{JointId, LinkId};

/// Two coordinates tied by rolling: `factor · coordinate` of the one and of the other sum to a constant, both seen from the
/// carrier.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Rolling {
    /// The joint.
    pub joint: JointId,
    /// The link in which both axes keep their place.
    pub carrier: LinkId,
    /// The two parts that roll on each other, each with its factor.
    pub ends: [(RollingEnd, Factor); 2],
}

/// A part that rolls on another.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum RollingEnd {
    /// A wheel: its coordinate is the angle from the carrier to it.
    Wheel(LinkId),
    /// A toothed bar: its coordinate is that of its sliding joint on the carrier; negated if that is declared from the bar.
    Bar {
        /// The bar.
        link: LinkId,
        /// The joint by which it slides on the carrier.
        slide: JointId,
        /// Whether the slide is declared from the carrier to the bar.
        forwards: bool,
    },
}

impl RollingEnd {
    /// The wheel or bar.
    #[must_use]
    pub fn link(self) -> LinkId {
        match self {
            Self::Wheel(link) | Self::Bar { link, .. } => link,
        }
    }
}

/// An exact number.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Factor {
    /// A number of teeth.
    Whole(i64),
    /// A radius: a float stands for exactly itself.
    Float(f64),
}

impl Factor {
    /// The opposite of it.
    pub(super) fn negate(self) -> Self {
        match self {
            Self::Whole(value) => Self::Whole(-value),
            Self::Float(value) => Self::Float(-value),
        }
    }
}

/// The axes on which links turn, and what is welded to what.
pub(super) type Shafts<'s> = (&'s [Pin], &'s Welded);
