//! The panel of a mechanism: every method at its price and its error.

use super::marks::{self, nearest};
use super::{Area, Drawn, LINE, SOFT, Side, TEXT, width, write};
use crate::frontier::frontier;
use crate::measurement::{Figures, Measurement, Row, STEPS, Step};
use crate::method::{Method, Precision};
use plotters::prelude::*;

const LEFT: i32 = 116;
const RIGHT: i32 = 36;
const TOP: i32 = 96;
const BOTTOM: i32 = 84;
/// The place of the crosses of blocked methods above the panel.
const BLOCKED: i32 = 22;
const NAME: f64 = 25.0;

/// The ranges of the axes: logarithms of nanoseconds and of errors by size.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    x: [f64; 2],
    y: [f64; 2],
}

impl Scale {
    /// The ranges of all measurements, the same in all panels.
    pub(super) fn fit(measurements: &[Measurement]) -> Self {
        let points = measurements.iter().flat_map(|measurement| {
            let figures = measurement.rows.iter().filter_map(|row| row.outcome.as_ref().ok());
            figures.map(|figures| logarithms(figures, measurement.size))
        });
        let (mut x, mut y) = ([f64::MAX, f64::MIN], [f64::MAX, f64::MIN]);
        for (at_x, at_y) in points {
            x = [x[0].min(at_x), x[1].max(at_x)];
            y = [y[0].min(at_y), y[1].max(at_y)];
        }
        // Room for marks and names.
        Self { x: [x[0] - 0.12, x[1] + 0.12], y: [(y[0] - 0.6).floor(), (y[1] + 0.4).ceil()] }
    }
}

fn logarithms(figures: &Figures, size: f64) -> (f64, f64) {
    // An error may be nothing at all.
    let relative = (figures.error / size).max(1e-18);
    (figures.nanoseconds.log10(), relative.log10())
}

/// The panel of a mechanism.
pub(super) struct Panel<'m> {
    measurement: &'m Measurement,
    scale: Scale,
    left: i32,
    right: i32,
    top: i32,
    bottom: i32,
}

/// A taken box of the picture: left, top, right, bottom.
type Taken = [i32; 4];

/// The name of a point on a frontier.
struct Name {
    text: String,
    place: Taken,
    /// The line from the point to the name.
    leader: [(i32, i32); 2],
    color: RGBColor,
}

impl<'m> Panel<'m> {
    /// A panel in a cell of this size.
    pub(super) fn new(
        measurement: &'m Measurement,
        scale: Scale,
        (width, height): (u32, u32),
    ) -> Self {
        Self {
            measurement,
            scale,
            left: LEFT,
            right: width.cast_signed() - RIGHT,
            top: TOP,
            bottom: height.cast_signed() - BOTTOM,
        }
    }

    /// Draws the panel.
    pub(super) fn draw<B: DrawingBackend>(&self, area: &Area<'_, B>) -> Drawn<B> {
        self.draw_axes(area)?;
        self.draw_frontiers(area)?;
        let names = self.names();
        for name in &names {
            area.draw(&PathElement::new(name.leader, name.color.stroke_width(2)))?;
        }
        self.draw_marks(area)?;
        for Name { text, place, .. } in &names {
            let [left, top, right, bottom] = *place;
            let middle = (i32::midpoint(left, right), i32::midpoint(top, bottom));
            write(area, (text, NAME, TEXT), middle, Side::Center)?;
        }
        Ok(())
    }

    fn x(&self, logarithm: f64) -> i32 {
        let [low, high] = self.scale.x;
        let part = (logarithm - low) / (high - low);
        self.left + nearest(part * f64::from(self.right - self.left))
    }

    fn y(&self, logarithm: f64) -> i32 {
        let [low, high] = self.scale.y;
        let part = (logarithm - low) / (high - low);
        self.bottom - nearest(part * f64::from(self.bottom - self.top))
    }

    fn at(&self, figures: &Figures) -> (i32, i32) {
        let (x, y) = logarithms(figures, self.measurement.size);
        (self.x(x), self.y(y))
    }

    fn draw_axes<B: DrawingBackend>(&self, area: &Area<'_, B>) -> Drawn<B> {
        let title = self.measurement.subject.title;
        write(area, (title, 34.0, TEXT), (self.left, 34), Side::Right)?;
        let line = |from, to| PathElement::new(vec![from, to], LINE.stroke_width(2));
        let [low, high] = self.scale.y.map(nearest);
        for decade in (low..=high).filter(|decade| decade % 3 == 0) {
            let y = self.y(decade.into());
            area.draw(&line((self.left, y), (self.right, y)))?;
            let label = if decade == 0 { "1".to_owned() } else { format!("1e{decade}") };
            write(area, (&label, 23.0, SOFT), (self.left - 10, y), Side::Left)?;
        }
        for nanoseconds in [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000] {
            let logarithm = f64::from(nanoseconds).log10();
            if logarithm < self.scale.x[0] || logarithm > self.scale.x[1] {
                continue;
            }
            let x = self.x(logarithm);
            area.draw(&line((x, self.top), (x, self.bottom)))?;
            let label = (&*nanoseconds.to_string(), 23.0, SOFT);
            write(area, label, (x, self.bottom + 22), Side::Center)?;
        }
        let below = (self.left + (self.right - self.left) / 2, self.bottom + 54);
        write(area, ("nanoseconds a position", 23.0, SOFT), below, Side::Center)?;
        let above = (self.right, 38);
        write(area, ("worst error / size", 23.0, SOFT), above, Side::Left)
    }

    /// The rows of a method in a precision, one for each step.
    fn series(&self, method: Method, precision: Precision) -> impl Iterator<Item = &Row> {
        let rows = self.measurement.rows.iter();
        rows.filter(move |row| row.method == method && row.precision == precision)
    }

    fn draw_frontiers<B: DrawingBackend>(&self, area: &Area<'_, B>) -> Drawn<B> {
        for step in STEPS {
            area.draw(&PathElement::new(self.stair(step), marks::stroke(step)))?;
        }
        Ok(())
    }

    /// The frontier at a step, from above to the right.
    fn stair(&self, step: Step) -> Vec<(i32, i32)> {
        let rows = frontier(self.measurement, step);
        let figures = rows.into_iter().filter_map(|row| row.outcome.as_ref().ok());
        let mut stair: Vec<(i32, i32)> = Vec::new();
        for (x, y) in figures.map(|figures| self.at(figures)) {
            let from = stair.last().map_or(self.top, |last| last.1);
            stair.extend([(x, from), (x, y)]);
        }
        if let Some(&(_, y)) = stair.last() {
            stair.push((self.right, y));
        }
        stair
    }

    fn draw_marks<B: DrawingBackend>(&self, area: &Area<'_, B>) -> Drawn<B> {
        let contestants = &self.measurement.subject.contestants;
        for one in contestants {
            let series = self.series(one.method, one.precision);
            let path = series.filter_map(|row| Some(self.at(row.outcome.as_ref().ok()?)));
            let color = marks::color(one.method);
            area.draw(&PathElement::new(path.collect::<Vec<_>>(), color.stroke_width(2)))?;
        }
        let mut is_blocked = false;
        // The large ones first, and on top what is worth most.
        for step in STEPS.into_iter().rev() {
            for one in contestants.iter().rev() {
                let radius = marks::radius(step);
                let mut series = self.series(one.method, one.precision);
                let Some(row) = series.find(|row| row.step == step) else {
                    continue;
                };
                if let Ok(figures) = &row.outcome {
                    let kind = (one.method, one.precision);
                    marks::draw(area, kind, radius, self.at(figures))?;
                } else {
                    is_blocked = true;
                    // What it would have cost is known from another step.
                    let mut others = self.series(one.method, one.precision);
                    let other = others.find_map(|row| row.outcome.as_ref().ok());
                    let x = other.map_or(self.right, |figures| self.at(figures).0);
                    marks::cross(area, one.method, radius, (x, self.top - BLOCKED))?;
                }
            }
        }
        if is_blocked {
            let at = (self.left - 10, self.top - BLOCKED);
            write(area, ("blocked", 23.0, SOFT), at, Side::Left)?;
        }
        Ok(())
    }

    /// The names of points on a frontier, where there is room for them.
    fn names(&self) -> Vec<Name> {
        let rows = self.measurement.rows.iter();
        let marks = rows.filter_map(|row| {
            let (x, y) = self.at(row.outcome.as_ref().ok()?);
            let half = nearest(marks::radius(row.step));
            Some([x - half, y - half, x + half, y + half])
        });
        let mut taken: Vec<Taken> = marks.collect();
        for stair in STEPS.map(|step| self.stair(step)) {
            taken.extend(stair.windows(2).map(|ends| around(ends[0], ends[1])));
        }
        let mut named: Vec<(Method, Precision)> = Vec::new();
        let mut names = Vec::new();
        // Where they differ most, at the longest step, they are named first.
        for step in STEPS.into_iter().rev() {
            for row in frontier(self.measurement, step) {
                let kind = (row.method, row.precision);
                let (false, Ok(figures)) = (named.contains(&kind), &row.outcome) else {
                    continue;
                };
                named.push(kind);
                let text = format!("{} {}", row.method, row.precision);
                let at = self.at(figures);
                let place = self.place(&text, at, &taken);
                taken.push(place);
                names.push(Name {
                    leader: leader(at, &place),
                    color: marks::color(row.method),
                    text,
                    place,
                });
            }
        }
        names
    }

    /// The place near a point where a name covers least.
    fn place(&self, name: &str, (x, y): (i32, i32), taken: &[Taken]) -> Taken {
        let (half_width, half_height) = (width(name, NAME) / 2 + 4, 14);
        let aside = half_width + 18;
        let columns = [0, 50, 100, 150].map(|more| aside + more);
        let columns = [0].into_iter().chain(columns).chain(columns.map(|dx| -dx));
        let moves = columns.flat_map(|dx| (-7..=7).map(move |row| (dx, 26 * row)));
        let places = moves.map(|(dx, dy)| {
            let (x, y) = (x + dx, y + dy);
            let place = [x - half_width, y - half_height, x + half_width, y + half_height];
            let inside = place[0] > self.left
                && place[2] < self.right
                && place[1] > self.top
                && place[3] < self.bottom;
            let covered: i32 = taken.iter().map(|other| overlap(&place, other)).sum();
            let away = (dx.abs() - aside).max(0) + dy.abs();
            (place, 4 * covered + away + if inside { 0 } else { 100_000 })
        });
        let best = places.min_by_key(|(_, badness)| *badness);
        best.map_or([x, y, x, y], |(place, _)| place)
    }
}

/// The shortest line from a point to a box.
fn leader((x, y): (i32, i32), place: &Taken) -> [(i32, i32); 2] {
    let nearest = (x.clamp(place[0], place[2]), y.clamp(place[1] + 6, place[3] - 6));
    [(x, y), nearest]
}

/// The box around a line that is upright or level.
fn around(a: (i32, i32), b: (i32, i32)) -> Taken {
    const HALF: i32 = 4;
    [a.0.min(b.0) - HALF, a.1.min(b.1) - HALF, a.0.max(b.0) + HALF, a.1.max(b.1) + HALF]
}

/// The area that two boxes share.
fn overlap(a: &Taken, b: &Taken) -> i32 {
    let wide = a[2].min(b[2]) - a[0].max(b[0]);
    let high = a[3].min(b[3]) - a[1].max(b[1]);
    wide.max(0) * high.max(0)
}
