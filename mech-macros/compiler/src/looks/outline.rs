//! Outlines.

use crate::model::{LinkId, Measure, Place};
use mech_core::wheel::{fill_ring, fill_wheel};
use std::ops::Deref;

/// A place that does not change.
pub(super) fn fixed(place: [f64; 2]) -> Place {
    place.map(Measure::fixed)
}

/// An outline that is filled, in the frame of a link.
pub type Outline = mech_core::Outline<Measure, Points>;

/// A list of points.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Points {
    /// The points.
    places: Vec<Place>,
    /// The toothed wheel whose corners they are, if they are; it depends on no param.
    pub wheel: Option<Toothed>,
}

impl Points {
    /// The points at the start.
    #[must_use]
    pub fn at_start(&self) -> Vec<[f64; 2]> {
        let places = self.places.iter();
        places.map(|place| place.map(Measure::at_start)).collect()
    }
}

impl Deref for Points {
    type Target = [Place];

    fn deref(&self) -> &[Place] {
        &self.places
    }
}

impl From<Vec<Place>> for Points {
    fn from(places: Vec<Place>) -> Self {
        let wheel = None;
        Self { places, wheel }
    }
}

impl From<Toothed> for Points {
    fn from(wheel: Toothed) -> Self {
        Self { places: wheel.corners().into_iter().map(fixed).collect(), wheel: Some(wheel) }
    }
}

impl FromIterator<Place> for Points {
    fn from_iter<I: IntoIterator<Item = Place>>(places: I) -> Self {
        places.into_iter().collect::<Vec<_>>().into()
    }
}

/// The outline of a toothed wheel: one tooth, repeated around a centre.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Toothed {
    /// Its centre.
    pub center: [f64; 2],
    /// The corners of the first tooth, counter-clockwise around the centre, and as seen from it.
    pub tooth: Vec<[f64; 2]>,
    /// The number of teeth.
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
        let mut teeth: Vec<[f64; 2]> =
            (0..self.count).flat_map(|_| tooth.iter().copied()).collect();
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

/// The same with all numbers that do not vary rounded, and no shares of them: short numbers are easier to read.
pub(super) fn rounded(outline: &Outline, grid: Grid) -> Outline {
    let number = |measure: Measure| match measure.formula {
        None => Measure::fixed(grid.round(measure.at_start())),
        Some(_) => measure,
    };
    let points = |points: &Points| match points.wheel {
        None => points.iter().map(|place| place.map(number)).collect(),
        // Teeth have to fit.
        Some(_) => points.clone(),
    };
    match (outline.map(number, points), outline) {
        (Outline::Arc { center, start, width, .. }, &Outline::Arc { angle, .. }) => {
            Outline::Arc { center, start, angle, width }
        }
        (rounded, _) => rounded,
    }
}

/// Numbers with so many digits that nobody sees what was rounded off.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    /// The number of steps from one whole number to the next: a power of ten.
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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Painted {
    /// The link that it is fixed to; the ground too.
    pub link: LinkId,
    /// The plane it lies in: greater is nearer to the eye.
    pub plane: i32,
    /// The outline.
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
    outlines.into_iter().map(move |(outline, color)| Painted { link, plane, outline, color })
}

impl Painted {
    /// Whether it depends on a param.
    #[must_use]
    pub fn varies(&self) -> bool {
        let points = self.outline.points().into_iter();
        let points = points.flat_map(|points| points.iter().flatten().copied());
        let mut numbers = self.outline.numbers().chain(points);
        numbers.any(|number| number.formula.is_some())
    }

    /// Some of its points at the start, each with how far it reaches around it.
    pub(crate) fn points(&self) -> impl Iterator<Item = ([f64; 2], f64)> {
        let at_start = |place: &Place| place.map(Measure::at_start);
        let (points, reach) = match &self.outline {
            Outline::Circle { center, radius } | Outline::Ring { center, radius, .. } => {
                (vec![at_start(center)], radius.at_start())
            }
            Outline::Polygon(points) | Outline::Winding(points) => match &points.wheel {
                Some(wheel) => (vec![wheel.center], wheel.reach()),
                None => (points.at_start(), 0.0),
            },
            Outline::Line { points, width } => (points.at_start(), 0.5 * width.at_start()),
            Outline::Arc { center, start, width, .. } => {
                let [center, start] = [center, start].map(at_start);
                let radius = (start[0] - center[0]).hypot(start[1] - center[1]);
                (vec![center], radius + 0.5 * width.at_start())
            }
        };
        points.into_iter().map(move |point| (point, reach))
    }
}
