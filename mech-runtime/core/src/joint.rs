//! Kinds of joints and of their coordinates.

/// The kind of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum JointKind {
    /// Two links turn about a common point.
    Revolute,
    /// Two links slide along a common line.
    Prismatic,
    /// A pin of the second link turns and slides in a slot of the first.
    Slot,
    /// Two links are one.
    Weld,
    /// Two toothed wheels roll on each other.
    Gear,
    /// A belt runs over two wheels.
    Belt,
    /// A wheel rolls on a toothed bar.
    Rack,
    /// The second link follows the cam of the first.
    Cam,
}

/// The kind of a coordinate: its unit, and whether it counts whole turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Coordinate {
    /// A length in scene units.
    Length,
    /// An angle in radians between −π and π, by an arc tangent. `continuous` in the declaration makes it [`Turns`](Self::Turns).
    Angle,
    /// An angle in radians that counts whole turns: of a motor, of a link that motors turn by gears and belts, or declared
    /// `continuous`.
    Turns,
}

impl JointKind {
    /// The word by which it is declared.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Revolute => "revolute",
            Self::Prismatic => "prismatic",
            Self::Slot => "slot",
            Self::Weld => "weld",
            Self::Gear => "gear",
            Self::Belt => "belt",
            Self::Rack => "rack",
            Self::Cam => "cam",
        }
    }
}

impl Coordinate {
    /// The name of its unit: `rad` or `scene units`.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Length => "scene units",
            Self::Angle | Self::Turns => "rad",
        }
    }
}
