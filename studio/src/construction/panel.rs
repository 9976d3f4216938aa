//! Fields beside a picture in which something is drawn to a scale of its own.

use super::Place;
use super::mark::Mark;
use crate::quantity::{round_step, tick};
use mech_core::colors::INK;

/// The part of a field's side that what is drawn in it may take.
const FILLED: f64 = 0.68;
/// How far below its upper edge the title of a field is, and its scale above its lower edge, in pixels.
const TITLE: f64 = -14.0;
const SCALE: f64 = 8.0;
/// What is this much greater than the median is not what a scale is made for: near dead points, rates are as great as one likes.
const GREAT: f64 = 4.0;

/// A square field.
#[derive(Clone, Copy)]
pub(super) struct Panel {
    /// The lower left corner.
    low: Place,
    side: f64,
}

impl Panel {
    /// So many fields beside or below a box, and the box around all.
    pub(super) fn beside(extent: [Place; 2], count: usize) -> (Vec<Self>, [Place; 2]) {
        let [low, high] = extent;
        let [width, height] = [0, 1].map(|part| high[part] - low[part]);
        let is_wide = width > 1.6 * height;
        let along = if is_wide {
            2 + usize::from(count > 2) + usize::from(count > 6)
        } else {
            1 + usize::from(count > 1) + usize::from(count > 4)
        };
        let long = if is_wide { width.max(0.6 * height) } else { height.max(0.6 * width) };
        #[expect(clippy::cast_precision_loss, reason = "no mechanism has 2⁵² links")]
        let side = long / along as f64;
        let mut whole = extent;
        let panels = (0..count).map(|number| {
            #[expect(clippy::cast_precision_loss, reason = "no mechanism has 2⁵² links")]
            let [first, second] = [number % along, number / along].map(|n| n as f64);
            let corner = if is_wide {
                [low[0] + side * first, low[1] - side * (second + 1.0)]
            } else {
                [high[0] + side * second, high[1] - side * (first + 1.0)]
            };
            for part in 0..2 {
                whole[0][part] = whole[0][part].min(corner[part]);
                whole[1][part] = whole[1][part].max(corner[part] + side);
            }
            Self { low: corner, side }
        });
        let panels = panels.collect();
        (panels, whole)
    }
}

/// Drawings for a field, one for each position, to a scale of their own.
pub(super) struct Inset {
    pub(super) title: String,
    /// What is drawn to scale.
    pub(super) unit: &'static str,
    /// The part of the field's side that stands for one unit.
    pub(super) scale: f64,
    /// In parts of the field's side, from its middle.
    pub(super) drawings: Vec<Vec<Mark>>,
}

impl Inset {
    /// Drawings in a unit of their own, which fill a field.
    pub(super) fn filling(title: String, unit: &'static str, drawings: &[Vec<Mark>]) -> Self {
        let reach = usual(drawings.iter().map(|marks| {
            let lengths = marks.iter().flat_map(Mark::places).map(|[x, y]| x.hypot(*y));
            lengths.fold(0.0, f64::max)
        }));
        let [mut low, mut high] = [[0.0; 2]; 2];
        let places = drawings.iter().flatten().flat_map(Mark::places);
        for place in places.filter(|[x, y]| x.hypot(*y) <= reach) {
            for part in 0..2 {
                low[part] = f64::min(low[part], place[part]);
                high[part] = f64::max(high[part], place[part]);
            }
        }
        let size = (high[0] - low[0]).max(high[1] - low[1]);
        let scale = FILLED / if size > 0.0 { size } else { 1.0 };
        let to = |place: Place| {
            [0, 1].map(|part| scale * (place[part] - f64::midpoint(low[part], high[part])))
        };
        let all = drawings.iter();
        let drawings = all.map(|marks| marks.iter().map(|mark| mark.map(to)).collect());
        Self { title, unit, scale, drawings: drawings.collect() }
    }

    /// The same in a field, each with its title and its scale.
    pub(super) fn placed(self, panel: Panel) -> Vec<Vec<Mark>> {
        let Panel { low, side } = panel;
        let length = round_step(&(0.0..0.15 / self.scale), self.unit, 1);
        let from = [low[0] + 0.05 * side, low[1]];
        let to = [from[0] + side * self.scale * length, low[1]];
        let text = |at, up, text| Mark::Text { at, away: [0.0, up], text };
        let frame = [
            text([low[0], low[1] + side], TITLE, self.title),
            Mark::Line { ends: [from, to], color: INK },
            Mark::Dot(from),
            Mark::Dot(to),
            text(from, SCALE, format!("{} {}", tick(length), self.unit)),
        ];
        let inside = |place: Place| [0, 1].map(|part| low[part] + side * (0.5 + place[part]));
        let placed = self.drawings.iter().map(|marks| {
            let marks = marks.iter().map(|mark| mark.map(inside));
            frame.iter().cloned().chain(marks).collect()
        });
        placed.collect()
    }
}

/// The greatest of these numbers that is not far beyond the usual ones.
pub(super) fn usual(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut numbers: Vec<f64> = numbers.filter(|number| number.is_finite()).collect();
    numbers.sort_by(f64::total_cmp);
    let most = GREAT * numbers.get(numbers.len() / 2).copied().unwrap_or(0.0);
    numbers.into_iter().filter(|number| *number <= most).fold(0.0, f64::max)
}
