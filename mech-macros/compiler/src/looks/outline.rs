//! Outlines.

use crate::model::{LinkId, Measure, Place};
use mech_core::wheel::{fill_ring, fill_wheel};

/// A place that does not change.
pub(super) fn fixed(place: [f64; 2]) -> Place {
    place.map(Measure::fixed)
}

/// What is filled, in the frame of a link.
#[derive(Clone, Debug, PartialEq)]
pub enum Outline {
    /// A disc.
    Circle {
        /// Its centre.
        center: Place,
        /// Its radius.
        radius: Measure,
    },
    /// A disc with a hole of the same centre.
    Ring {
        /// Its centre.
        center: Place,
        /// Its radius.
        radius: Measure,
        /// The radius of its hole.
        hole: Measure,
    },
    /// A polygon, by the even-odd rule.
    Polygon(Vec<Place>),
    /// A thick line with round ends and joins.
    Line {
        /// Its corners.
        points: Vec<Place>,
        /// Its width.
        width: Measure,
    },
    /// A thick arc with round ends.
    Arc {
        /// Its centre.
        center: [f64; 2],
        /// The start of its middle line.
        start: [f64; 2],
        /// Its angle, in radians, counter-clockwise.
        angle: f64,
        /// Its width.
        width: f64,
    },
    /// A toothed wheel.
    Toothed(Toothed),
}

/// The outline of a toothed wheel: one tooth, repeated around a centre.
#[derive(Clone, Debug, PartialEq)]
pub struct Toothed {
    /// Its centre.
    pub center: [f64; 2],
    /// The corners of the first tooth, counter-clockwise around the centre, and as seen from it.
    pub tooth: Vec<[f64; 2]>,
    /// How many teeth.
    pub count: u32,
    /// The radius of the ring that has its teeth inside; none of a wheel.
    pub rim: Option<f64>,
}

impl Toothed {
    /// The cosine and the sine of its pitch.
    pub(crate) fn turn(&self) -> [f64; 2] {
        let (sin, cos) = (std::f64::consts::TAU / f64::from(self.count)).sin_cos();
        [cos, sin]
    }

    /// The corners of all teeth; of a ring, and those of its rim.
    #[must_use]
    pub fn corners(&self) -> Vec<[f64; 2]> {
        let (center, tooth, turn) = (self.center, &self.tooth, self.turn());
        let mut teeth: Vec<[f64; 2]> = (0..self.count)
            .flat_map(|_| tooth.iter().copied())
            .collect();
        match self.rim {
            None => fill_wheel(&mut teeth, center, tooth, turn),
            Some(rim) => {
                teeth.resize(2 * (teeth.len() + 1), [0.0; 2]);
                fill_ring(&mut teeth, center, tooth, turn, rim);
            }
        }
        teeth
    }

    /// The radius of a circle around all of it.
    fn reach(&self) -> f64 {
        let corners = self.tooth.iter().map(|[x, y]| x.hypot(*y));
        corners.chain(self.rim).fold(0.0, f64::max)
    }
}

impl Outline {
    /// All its numbers that may depend on params.
    fn measures(&self) -> Vec<Measure> {
        match self {
            Self::Circle { center, radius } => [&center[..], &[*radius]].concat(),
            Self::Ring {
                center,
                radius,
                hole,
            } => [&center[..], &[*radius, *hole]].concat(),
            Self::Polygon(corners) => corners.concat(),
            Self::Line { points, width } => [&points.concat()[..], &[*width]].concat(),
            Self::Arc { .. } | Self::Toothed(_) => Vec::new(),
        }
    }

    /// The same with all numbers that do not vary rounded, and no shares of them: short numbers are easier to read.
    pub(super) fn rounded(self, grid: Grid) -> Self {
        let number = |measure: Measure| match measure.formula {
            None => Measure::fixed(grid.round(measure.at_start())),
            Some(_) => measure,
        };
        let place = |place: Place| place.map(number);
        let places = |places: Vec<Place>| places.into_iter().map(place).collect();
        match self {
            Self::Circle { center, radius } => Self::Circle {
                center: place(center),
                radius: number(radius),
            },
            Self::Ring {
                center,
                radius,
                hole,
            } => Self::Ring {
                center: place(center),
                radius: number(radius),
                hole: number(hole),
            },
            Self::Polygon(corners) => Self::Polygon(places(corners)),
            Self::Line { points, width } => Self::Line {
                points: places(points),
                width: number(width),
            },
            Self::Arc {
                center,
                start,
                angle,
                width,
            } => Self::Arc {
                center: center.map(|part| grid.round(part)),
                start: start.map(|part| grid.round(part)),
                angle,
                width: grid.round(width),
            },
            // Teeth have to fit.
            Self::Toothed(wheel) => Self::Toothed(wheel),
        }
    }

    /// Whether it depends on a param.
    #[must_use]
    pub fn varies(&self) -> bool {
        self.measures().iter().any(|one| one.formula.is_some())
    }

    /// Some of its points at the start, and how far it reaches around them.
    fn reach(&self) -> (Vec<[f64; 2]>, f64) {
        let start = |place: &Place| place.map(Measure::at_start);
        match self {
            Self::Circle { center, radius } | Self::Ring { center, radius, .. } => {
                (vec![start(center)], radius.at_start())
            }
            Self::Polygon(corners) => (corners.iter().map(start).collect(), 0.0),
            Self::Line { points, width } => (
                points.iter().map(start).collect(),
                width.times(0.5).at_start(),
            ),
            Self::Arc {
                center,
                start,
                width,
                ..
            } => {
                let radius = (start[0] - center[0]).hypot(start[1] - center[1]);
                (vec![*center], radius + 0.5 * width)
            }
            Self::Toothed(wheel) => (vec![wheel.center], wheel.reach()),
        }
    }
}

/// Numbers with so many digits that nobody sees what was rounded off.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    /// How many numbers there are from one whole number to the next: a power of ten.
    fineness: f64,
}

impl Grid {
    /// So fine that a ten-thousandth of this length is seen.
    pub(super) fn for_width(width: f64) -> Self {
        let fineness = 10.0_f64.powf(4.0 - width.log10().floor());
        Self { fineness }
    }

    fn round(self, value: f64) -> f64 {
        let rounded = (value * self.fineness).round() / self.fineness;
        if rounded.is_finite() { rounded } else { value }
    }
}

/// An outline that is painted.
#[derive(Clone, Debug, PartialEq)]
pub struct Painted {
    /// The link that it is fixed to; the ground too.
    pub link: LinkId,
    /// The plane it lies in: greater is nearer to the eye.
    pub plane: i32,
    /// What is filled.
    pub outline: Outline,
    /// Its entry in the palette.
    pub color: u8,
}

/// Outlines of a link in a plane, with their colours.
pub(super) fn painted(
    link: LinkId,
    plane: i32,
    outlines: impl IntoIterator<Item = (Outline, u8)>,
) -> impl Iterator<Item = Painted> {
    outlines.into_iter().map(move |(outline, color)| Painted {
        link,
        plane,
        outline,
        color,
    })
}

impl Painted {
    /// Some of its points at the start, each with how far it reaches around it.
    pub(crate) fn points(&self) -> impl Iterator<Item = ([f64; 2], f64)> {
        let (points, reach) = self.outline.reach();
        points.into_iter().map(move |point| (point, reach))
    }
}
