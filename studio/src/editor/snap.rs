//! Where the pointer means.

use super::drawing::{Drawing, Hit, distance};
use super::tool::Pick;
use crate::play::nearest_on_line;

/// A place that the pointer means, and why.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Snapped {
    pub(super) pick: Pick,
    /// Places with which it is aligned: lines to them are shown.
    pub(super) guides: Vec<[f64; 2]>,
}

/// The targets of snapping, at a magnification.
pub(super) struct Snapping<'d> {
    pub(super) drawing: Option<&'d Drawing>,
    /// Pixels in a scene unit.
    pub(super) scale: f64,
    pub(super) is_on: bool,
    /// From where angles count, if they are to be multiples of 15 degrees.
    pub(super) angles_from: Option<[f64; 2]>,
    /// Whether places snap to bars: not those of a dragged item, which takes its bars along.
    pub(super) snaps_to_bars: bool,
    /// The dragged items, which do not snap to themselves.
    pub(super) without: &'d [super::Item],
}

/// The distance within which the pointer takes hold, in pixels.
pub(super) const REACH: f64 = 11.0;
/// The distance within which the pointer snaps where snapping is off, in pixels.
pub(super) const CLOSE: f64 = 3.0;
/// Where snapping is off, places are rounded to the spacing of the grid over this number. More would only add digits.
const FINE: f64 = 100.0;
/// The distance within which it snaps to an alignment, in pixels.
const ALIGNED: f64 = 6.0;
/// The least distance of lines of the grid, in pixels.
const APART: f64 = 12.0;

impl Snapping<'_> {
    /// The place that is meant by one under the pointer.
    pub(super) fn snap(&self, place: [f64; 2]) -> Snapped {
        let reach = if self.is_on { REACH } else { CLOSE } / self.scale;
        let hit = self.drawing.map_or(Hit::Paper, |drawing| drawing.hit(place, reach));
        if let Some(place) = self.handle(place, reach) {
            return Snapped { pick: Pick { place, hit }, guides: Vec::new() };
        }
        if !self.is_on {
            let fine = grid(self.scale) / FINE;
            return Snapped { pick: Pick { place: on_grid(place, fine), hit }, guides: Vec::new() };
        }
        let (place, guides) = match (self.angles_from, self.on_bar(place, &hit, reach)) {
            (Some(from), _) => (self.at_angle(from, place), vec![from]),
            (None, Some(on_bar)) => (on_bar, Vec::new()),
            (None, None) => self.aligned(place),
        };
        Snapped { pick: Pick { place, hit }, guides }
    }

    /// The handle that is near, or the other end of a joint that is apart.
    fn handle(&self, place: [f64; 2], reach: f64) -> Option<[f64; 2]> {
        let drawing = self.drawing?;
        let handles = drawing.handles();
        let others = handles.filter(|handle| !self.without.contains(handle.item));
        let gaps = drawing.ends_of_joints();
        let gaps = gaps.filter(|[seen, other]| distance(*seen, *other) > reach);
        let places = others.map(|handle| handle.place).chain(gaps.map(|[_, other]| other));
        let near = places.map(|other| (distance(other, place), other));
        let near = near.filter(|(away, _)| *away <= reach);
        near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, place)| place)
    }

    /// The place on the bar that was hit: where that crosses the line of the grid which is nearest.
    fn on_bar(&self, place: [f64; 2], hit: &Hit, reach: f64) -> Option<[f64; 2]> {
        let Hit::Link(link) = hit else { return None };
        let drawing = self.drawing.filter(|_| self.snaps_to_bars)?;
        let [from, to] = drawing.bar_at(*link, place, reach)?;
        let way = [to[0] - from[0], to[1] - from[1]];
        // The coordinate that changes most along the bar comes to the grid.
        let part = usize::from(way[1].abs() > way[0].abs());
        let near = nearest_on_line(place, [from, to]);
        let on_grid = on_grid(near, grid(self.scale))[part];
        let share = (on_grid - from[part]) / way[part];
        if !(0.0..=1.0).contains(&share) {
            return Some(near);
        }
        let mut found = [from[0] + share * way[0], from[1] + share * way[1]];
        found[part] = on_grid;
        Some(found)
    }

    /// A place on the grid, or aligned with handles.
    fn aligned(&self, place: [f64; 2]) -> ([f64; 2], Vec<[f64; 2]>) {
        let unit = grid(self.scale);
        let mut found = on_grid(place, unit);
        let mut guides = Vec::new();
        let handles = self.drawing.into_iter().flat_map(Drawing::handles);
        let others: Vec<[f64; 2]> = handles
            .filter(|handle| !self.without.contains(handle.item))
            .map(|handle| handle.place)
            .collect();
        for part in 0..2 {
            let away = |other: [f64; 2]| (other[part] - place[part]).abs();
            let nearest = others.iter().copied();
            let nearest = nearest.min_by(|a, b| away(*a).total_cmp(&away(*b)));
            let own = (found[part] - place[part]).abs();
            if let Some(nearest) =
                nearest.filter(|one| away(*one) <= (ALIGNED / self.scale).min(own + 1e-12))
            {
                found[part] = nearest[part];
                guides.push(nearest);
            }
        }
        (found, guides)
    }

    /// A place at a multiple of 15 degrees, and at a distance of the grid.
    fn at_angle(&self, from: [f64; 2], place: [f64; 2]) -> [f64; 2] {
        let unit = grid(self.scale);
        let step = 15_f64.to_radians();
        let [x, y] = [place[0] - from[0], place[1] - from[1]];
        let angle = (y.atan2(x) / step).round() * step;
        let length = (x.hypot(y) / unit).round() * unit;
        [from[0] + length * angle.cos(), from[1] + length * angle.sin()]
            .map(|part| tidy(part, unit))
    }
}

/// The place on a grid that is nearest.
fn on_grid(place: [f64; 2], unit: f64) -> [f64; 2] {
    place.map(|part| tidy((part / unit).round() * unit, unit))
}

/// A number without the digits that rounding adds, if it counts in these units.
fn tidy(value: f64, unit: f64) -> f64 {
    crate::text::rounded(value, 1e-6 * unit)
}

/// The distance of the lines of the grid at a magnification: 1, 2 or 5 times a power of ten.
pub(super) fn grid(scale: f64) -> f64 {
    let least = APART / scale;
    let power = 10_f64.powf(least.log10().floor());
    let found = [1.0, 2.0, 5.0].map(|digit| digit * power);
    found.into_iter().find(|unit| *unit >= least).unwrap_or(10.0 * power)
}
