//! The symbols of a diagram.

/// A place on a link.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spot<T, L = usize> {
    /// The link: 0 is the ground, `n + 1` the moving link whose pose is `poses()[n]`.
    pub link: L,
    /// The place in its frame, in scene units.
    pub at: [T; 2],
}

/// A symbol of a mechanism. Lengths are in scene units. Directions have length one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Symbol<T, L = usize> {
    /// A side of a link, from one of its joints to the next.
    Bar {
        /// The link, numbered as in [`Spot`].
        link: L,
        /// Both ends, in its frame.
        ends: [[T; 2]; 2],
    },
    /// A named point of a link without a joint.
    Mark(Spot<T, L>),
    /// The pitch circle of a wheel.
    Wheel {
        /// The centre.
        center: Spot<T, L>,
        /// The radius.
        radius: T,
    },
    /// The strands of a belt between two wheels.
    Belt {
        /// The centres of the wheels.
        centers: [Spot<T, L>; 2],
        /// Their radii.
        radii: [T; 2],
    },
    /// The pitch line of a toothed bar.
    Rack {
        /// The centre of the pinion.
        pinion: Spot<T, L>,
        /// The pinion's pitch radius; negative if the bar is on its other side.
        radius: T,
        /// The bar, at the origin of the line along which it slides.
        bar: Spot<T, L>,
        /// The direction of that line, in the bar's frame.
        along: [T; 2],
    },
    /// A line along which something slides.
    Line {
        /// The origin.
        at: Spot<T, L>,
        /// The direction, in the link's frame.
        along: [T; 2],
    },
    /// A point about which something turns.
    Point(Spot<T, L>),
    /// A prismatic joint, or that of a slot.
    Slide {
        /// The part with the guide, at the origin of its line.
        guide: Spot<T, L>,
        /// The direction of the guide, in its link's frame.
        along: [T; 2],
        /// The part that slides.
        block: Spot<T, L>,
    },
    /// A weld.
    Weld(Spot<T, L>),
    /// A revolute joint; on the ground, a fixed pivot.
    Pivot(Spot<T, L>),
    /// A spring between two points.
    Spring {
        /// Its ends.
        ends: [Spot<T, L>; 2],
        /// The distance at which it is drawn to the left of the line between them, in pixels.
        beside: f32,
    },
    /// A damper between two points.
    Damper {
        /// Its ends.
        ends: [Spot<T, L>; 2],
        /// The distance at which it is drawn to the left of the line between them, in pixels.
        beside: f32,
    },
    /// A torsional spring at a joint.
    TorsionSpring(Spot<T, L>),
    /// A torsional damper at a joint.
    TorsionDamper(Spot<T, L>),
    /// A cam that turns, at its shaft.
    Cam(Spot<T, L>),
    /// A cam that slides.
    Wedge {
        /// Its place.
        at: Spot<T, L>,
        /// The direction in which it slides, in its link's frame.
        along: [T; 2],
    },
    /// A motor that turns.
    RotaryMotor(Spot<T, L>),
    /// A motor that slides.
    LinearMotor {
        /// The link that it moves.
        block: Spot<T, L>,
        /// The link with the guide, numbered as in [`Spot`].
        guide: L,
        /// The guide's direction, in that link's frame.
        along: [T; 2],
    },
}

impl<T, L> Spot<T, L> {
    /// The same with other numbers and another name of its link. `None` if the link has none.
    #[must_use]
    pub fn try_map<U, M>(
        self,
        number: impl Fn(T) -> U,
        link: impl Fn(L) -> Option<M>,
    ) -> Option<Spot<U, M>> {
        let at = self.at.map(number);
        link(self.link).map(|link| Spot { link, at })
    }
}

impl<T, L> Symbol<T, L> {
    /// The same with other numbers and other names of links. `None` if a link has none.
    #[must_use]
    pub fn try_map<U, M>(
        self,
        number: impl Fn(T) -> U,
        link: impl Fn(L) -> Option<M>,
    ) -> Option<Symbol<U, M>> {
        let pair = |pair: [T; 2]| pair.map(&number);
        let spot = |spot: Spot<T, L>| spot.try_map(&number, &link);
        let both = |[a, b]: [Spot<T, L>; 2]| Some([spot(a)?, spot(b)?]);
        Some(match self {
            Self::Bar { link: side, ends } => {
                Symbol::Bar { link: link(side)?, ends: ends.map(pair) }
            }
            Self::Mark(at) => Symbol::Mark(spot(at)?),
            Self::Wheel { center, radius } => {
                Symbol::Wheel { center: spot(center)?, radius: number(radius) }
            }
            Self::Belt { centers, radii } => {
                Symbol::Belt { centers: both(centers)?, radii: pair(radii) }
            }
            Self::Rack { pinion, radius, bar, along } => Symbol::Rack {
                pinion: spot(pinion)?,
                radius: number(radius),
                bar: spot(bar)?,
                along: pair(along),
            },
            Self::Line { at, along } => Symbol::Line { at: spot(at)?, along: pair(along) },
            Self::Point(at) => Symbol::Point(spot(at)?),
            Self::Slide { guide, along, block } => {
                Symbol::Slide { guide: spot(guide)?, along: pair(along), block: spot(block)? }
            }
            Self::Weld(at) => Symbol::Weld(spot(at)?),
            Self::Pivot(at) => Symbol::Pivot(spot(at)?),
            Self::Spring { ends, beside } => Symbol::Spring { ends: both(ends)?, beside },
            Self::Damper { ends, beside } => Symbol::Damper { ends: both(ends)?, beside },
            Self::TorsionSpring(at) => Symbol::TorsionSpring(spot(at)?),
            Self::TorsionDamper(at) => Symbol::TorsionDamper(spot(at)?),
            Self::Cam(at) => Symbol::Cam(spot(at)?),
            Self::Wedge { at, along } => Symbol::Wedge { at: spot(at)?, along: pair(along) },
            Self::RotaryMotor(at) => Symbol::RotaryMotor(spot(at)?),
            Self::LinearMotor { block, guide, along } => {
                Symbol::LinearMotor { block: spot(block)?, guide: link(guide)?, along: pair(along) }
            }
        })
    }
}
