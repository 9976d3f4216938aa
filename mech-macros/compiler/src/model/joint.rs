//! Joints and motors.

use super::{AxisId, JointId, LawId, LinkId, Origin};
use std::fmt::{self, Display, Formatter};

/// A joint between two links.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Joint {
    /// Its name.
    pub name: String,
    /// Where its name was declared.
    pub origin: Origin,
    /// Its kind, and the parts that it joins.
    pub kind: JointKind,
    /// Whether it is the pivot of a slot: then the slide that follows it has the slot's name and coordinate, and this one is
    /// not shown.
    pub hidden: bool,
}

/// The kinds of joint. The coordinate of a joint is that of its second part relative to its first.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum JointKind {
    /// Two point axes coincide; the coordinate is the angle from the first's direction to the second's, in radians.
    Revolute(AxisId, AxisId),
    /// Two line axes coincide; the coordinate is the displacement from the first's origin to the second's, along the line.
    Prismatic(AxisId, AxisId),
    /// Two point axes coincide, in place and in direction: the links are one.
    Weld(AxisId, AxisId),
    /// Two toothed wheels roll on each other.
    Gear {
        /// The first wheel.
        a: LinkId,
        /// The second wheel.
        b: LinkId,
        /// The sizes of the two.
        ratio: Ratio,
        /// The link that carries them, if it was said.
        on: Option<LinkId>,
    },
    /// A belt or chain runs over two wheels: they turn in the same sense.
    Belt {
        /// The first wheel.
        a: LinkId,
        /// The second wheel.
        b: LinkId,
        /// The sizes of the two, both positive.
        ratio: Ratio,
        /// The link that carries them, if it was said.
        on: Option<LinkId>,
    },
    /// A pinion rolls on a toothed bar.
    Rack {
        /// The wheel.
        pinion: LinkId,
        /// The bar.
        bar: LinkId,
        /// The pinion's pitch radius, in scene units: the displacement of the bar along its line for one radian of the pinion, both
        /// seen from their carrier. Negative if the bar is on the other side.
        radius: f64,
        /// The link that carries them, if it was said.
        on: Option<LinkId>,
    },
    /// A cam: the coordinate of one joint is a function of that of another, with which it has a link in common.
    Cam {
        /// The joint that turns the cam, or slides it: revolute or prismatic.
        shaft: JointId,
        /// The joint by which the follower moves: revolute or prismatic.
        follower: JointId,
        /// The coordinate of the follower as a function of that of the shaft.
        law: LawId,
    },
}

impl JointKind {
    /// The same without what it joins; a slot is a slide.
    #[must_use]
    pub fn plain(self) -> mech_core::JointKind {
        use mech_core::JointKind as Plain;
        match self {
            Self::Revolute(..) => Plain::Revolute,
            Self::Prismatic(..) => Plain::Prismatic,
            Self::Weld(..) => Plain::Weld,
            Self::Gear { .. } => Plain::Gear,
            Self::Belt { .. } => Plain::Belt,
            Self::Rack { .. } => Plain::Rack,
            Self::Cam { .. } => Plain::Cam,
        }
    }

    /// Whether it ties two coordinates and has none of its own: something that rolls, or a cam.
    #[must_use]
    pub fn ties(self) -> bool {
        self.rolls() || matches!(self, Self::Cam { .. })
    }

    /// Whether it is a pair of wheels, or a wheel and a bar, that roll: it ties two coordinates and has none of its own.
    #[must_use]
    pub fn rolls(self) -> bool {
        matches!(self, Self::Gear { .. } | Self::Belt { .. } | Self::Rack { .. })
    }
}

/// The sizes of two meshing wheels. One of them is negative for an internal gear (a ring); none is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Ratio {
    /// Numbers of teeth: exact.
    Teeth(i64, i64),
    /// Pitch radii, in scene units.
    Radii(f64, f64),
}

impl Ratio {
    /// Both sizes as they are written.
    #[must_use]
    pub fn sizes(self) -> [f64; 2] {
        match self {
            #[expect(clippy::cast_precision_loss, reason = "no wheel has so many teeth")]
            Self::Teeth(a, b) => [a as f64, b as f64],
            Self::Radii(a, b) => [a, b],
        }
    }

    /// The pitch radii of two wheels that mesh, whose centres are so far apart.
    #[must_use]
    pub fn pitch_radii(self, apart: f64) -> [f64; 2] {
        let sizes = self.sizes();
        let unit = apart / (sizes[0] + sizes[1]).abs();
        sizes.map(|size| size.abs() * unit)
    }

    /// The radii of two pulleys whose centres are so far apart.
    #[must_use]
    pub fn pulley_radii(self, apart: f64) -> [f64; 2] {
        let sizes = self.sizes();
        let unit = match self {
            Self::Radii(..) => 1.0,
            // Teeth say nothing about the size of a pulley: a third of the distance looks well.
            Self::Teeth(..) => apart / (3.0 * sizes[0].max(sizes[1])),
        };
        sizes.map(|size| size * unit)
    }

    /// Whether one of the wheels is a ring.
    #[must_use]
    pub fn is_internal(self) -> bool {
        self.sizes().iter().any(|size| *size < 0.0)
    }

    /// Whether one of the wheels is a ring, and is not larger than the wheel in it.
    #[must_use]
    pub fn ring_is_small(self) -> bool {
        let [a, b] = self.sizes();
        self.is_internal() && a + b >= 0.0
    }

    /// The same with the other wheel as the ring.
    #[must_use]
    pub fn turned_out(self) -> Self {
        match self {
            Self::Teeth(a, b) => Self::Teeth(-a, -b),
            Self::Radii(a, b) => Self::Radii(-a, -b),
        }
    }
}

/// As it is declared: teeth are whole, radii have a decimal point.
impl Display for Ratio {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Teeth(a, b) => write!(f, "{a} : {b}"),
            Self::Radii(a, b) => write!(f, "{a:?} : {b:?}"),
        }
    }
}

/// A motor: the coordinate of its joint is given from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Motor {
    /// The joint it drives: revolute or prismatic.
    pub joint: JointId,
    /// Where it was declared.
    pub origin: Origin,
    /// The values between which it has to move without blocking, if any were declared.
    pub range: Option<Range>,
    /// The greatest difference between one value and the next, in radians or scene units, if one was declared: positive.
    pub step: Option<f64>,
    /// Its coordinate as a function of the time, if it follows a law.
    pub law: Option<LawId>,
}

/// The values that a motor may take, both ends among them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Range {
    /// The least, in radians or scene units.
    pub low: f64,
    /// The greatest: not less than the least.
    pub high: f64,
    /// Where it was declared.
    pub origin: Origin,
}

impl Motor {
    /// A motor without a declared range, step or law.
    #[must_use]
    pub fn new(joint: JointId, origin: Origin) -> Self {
        Self { joint, origin, range: None, step: None, law: None }
    }
}
