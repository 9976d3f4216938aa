//! The diagram of a mechanism: its joints, links, motors and axes as a textbook draws them.

mod diagram;
mod elastic;
mod rolling;

use crate::model::{AxisId, LinkId, Model};
pub(crate) use diagram::elastic_symbols;
pub use diagram::{moving_points, symbols};

/// A place on a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The link; the ground too.
    pub link: LinkId,
    /// The coordinates in its frame, in scene units; at the start, if params move it.
    pub at: [f64; 2],
    /// The axis at this place.
    pub axis: AxisId,
}

impl Spot {
    /// The place of an axis.
    pub(crate) fn of(model: &Model, id: AxisId) -> Self {
        let axis = model.axis(id);
        Self {
            link: axis.link,
            at: axis.at,
            axis: id,
        }
    }

    /// Whether another is in the same place on the same link, for all values of the params.
    fn coincides_with(&self, other: &Self, model: &Model) -> bool {
        let formulas = |spot: &Self| model.axis(spot.axis).formulas;
        self.link == other.link && self.at == other.at && formulas(self) == formulas(other)
    }
}

impl Symbol {
    /// The places between or about which a spring or damper is drawn; none of other symbols.
    pub(crate) fn spots(&self) -> Vec<Spot> {
        match *self {
            Self::Spring { ends, .. } | Self::Damper { ends, .. } => ends.to_vec(),
            Self::TorsionSpring(at) | Self::TorsionDamper(at) => vec![at],
            _ => Vec::new(),
        }
    }
}

/// Where a spring or damper is drawn, seen from its first end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// On the line between its ends.
    Middle,
    /// To the left: a damper lies between the same points.
    Left,
    /// To the right: a spring lies between the same points.
    Right,
}

impl Side {
    /// How many pixels to the left of the line between its ends a spring or damper is drawn.
    #[must_use]
    pub fn pixels(self) -> f32 {
        match self {
            Self::Middle => 0.0,
            Self::Left => 8.0,
            Self::Right => -8.0,
        }
    }
}

/// An element of a diagram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Symbol {
    /// A side of a link, between two of its joints or points.
    Bar {
        /// The link.
        link: LinkId,
        /// Both ends, on the link.
        ends: [Spot; 2],
    },
    /// A named point without a joint.
    Mark(Spot),
    /// The pitch circle of a wheel, of the size that it has at the start.
    Wheel {
        /// Its centre.
        center: Spot,
        /// Its radius, in scene units.
        radius: f64,
    },
    /// The strands of a belt between two wheels.
    Belt {
        /// The centres of the wheels.
        centers: [Spot; 2],
        /// Their radii, in scene units.
        radii: [f64; 2],
    },
    /// The pitch line of a toothed bar.
    Rack {
        /// The centre of the pinion.
        pinion: Spot,
        /// The pinion's pitch radius, in scene units, as declared: negative on the other side.
        radius: f64,
        /// The origin of the line along which the bar slides.
        bar: Spot,
        /// That line.
        along: AxisId,
    },
    /// A declared line.
    Line {
        /// Its origin.
        at: Spot,
        /// The line.
        along: AxisId,
    },
    /// A declared point of the ground or of a link, as the axis of a joint.
    Point(Spot),
    /// A prismatic joint or a slot.
    Slide {
        /// The origin of the guide's line.
        guide: Spot,
        /// The line of the guide.
        along: AxisId,
        /// The place of the sliding block.
        block: Spot,
    },
    /// A weld.
    Weld(Spot),
    /// A revolute joint; on the ground, a fixed pivot.
    Pivot(Spot),
    /// A spring between two points.
    Spring {
        /// Its ends.
        ends: [Spot; 2],
        /// On which side of the line between them it is drawn.
        side: Side,
    },
    /// A damper between two points.
    Damper {
        /// Its ends.
        ends: [Spot; 2],
        /// On which side of the line between them it is drawn.
        side: Side,
    },
    /// A torsional spring.
    TorsionSpring(Spot),
    /// A torsional damper.
    TorsionDamper(Spot),
    /// A cam that turns, at its shaft.
    Cam(Spot),
    /// A cam that slides.
    Wedge {
        /// Its place.
        at: Spot,
        /// The line along which it slides.
        along: AxisId,
    },
    /// A rotary motor.
    RotaryMotor(Spot),
    /// A linear motor.
    LinearMotor {
        /// The place of the block that it moves.
        block: Spot,
        /// The link of the guide.
        guide: LinkId,
        /// The line of the guide.
        along: AxisId,
    },
}
