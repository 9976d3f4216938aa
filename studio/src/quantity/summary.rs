//! Summaries of quantities through a motion: their extremes and means.

use super::Measurement;
use super::measurement::{Prepared, columns};
use crate::failure::Failure;
use crate::motion::Drive;
use mech_compiler::model::{Measurand, Quantity};
use std::collections::VecDeque;

/// An extreme is looked for so often between its neighbours.
const ROUNDS: u32 = 10;
/// Each time at so many places on either side.
const PLACES: u32 = 4;
/// A transmission angle below this, in degrees, is that of a dead point or a change point.
pub(crate) const FLAT: f64 = 0.01;
/// What differs by less, in sizes of the quantity, differs by rounding alone.
const ROUNDING: f64 = 1e-13;

/// The summary of a quantity through a motion, in the unit in which it is shown.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Summary {
    /// The name of the quantity.
    pub(crate) name: String,
    pub(crate) unit: String,
    pub(crate) least: Extreme,
    pub(crate) greatest: Extreme,
    /// The mean over equal steps of what drives the motion.
    pub(crate) mean: f64,
    /// The root of the mean square, over the same.
    pub(crate) rms: f64,
    /// How much longer the slower way between the extremes takes than the quicker one, in a motion that is cyclic and has no other turning
    /// points and no rests.
    pub(crate) time_ratio: Option<f64>,
    /// The longest way of what drives the motion on which the quantity stays within the width that was asked for.
    pub(crate) dwell: Option<f64>,
}

/// An extreme of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extreme {
    pub(crate) value: f64,
    /// The value there of what drives the motion, in its unit.
    pub(crate) by: f64,
    /// The part of the motion, 0 to 1.
    part: f64,
}

impl Summary {
    /// How far the quantity goes: the stroke of a slide, the swing of an angle.
    pub(crate) fn extent(&self) -> f64 {
        self.greatest.value - self.least.value
    }

    /// Whether the extremes are at both ends of the motion.
    pub(crate) fn is_one_way(&self) -> bool {
        let [first, second] = [self.least.part, self.greatest.part];
        first.min(second) == 0.0 && first.max(second) == 1.0
    }
}

/// Summarizes quantities through a motion. What is determined nowhere is left out.
///
/// With a width, in the unit of each quantity, the longest dwell within it is looked for, too: between the steps along straight lines.
pub(crate) fn summarize(
    of: &Measurement<'_>,
    measurands: &[Measurand],
    width_of_dwell: Option<f64>,
) -> Result<Vec<Summary>, Failure> {
    let prepared = Prepared::new(of, measurands)?;
    let parts = of.parts();
    let is_cyclic = of.drive.is_cyclic(of.model);
    of.drive.attempt(|drive| {
        let rows = Rows::of(&prepared, drive, parts.clone())?;
        let columns = columns(of, measurands).into_iter().enumerate().skip(1);
        let mut found: Vec<(usize, Summary)> = columns
            .filter_map(|(column, named)| Some((column, rows.summary(column, named)?)))
            .collect();
        let mut width = 1.0 / f64::from(of.steps.max(1));
        for _ in 0..ROUNDS {
            let extremes = found.iter().flat_map(|(column, one)| {
                // Nearer to a dead point or a change point, nothing is learnt, and every move takes long.
                let is_over = is_transmission(&measurands[column - 1]) && one.least.value < FLAT;
                let least = (!is_over).then_some(one.least);
                least.into_iter().chain([one.greatest])
            });
            let mut near: Vec<f64> = extremes.flat_map(|one| around(one, width)).collect();
            near.sort_by(f64::total_cmp);
            near.dedup();
            let rows = Rows::of(&prepared, drive, near)?;
            for (column, summary) in &mut found {
                rows.refine(*column, summary);
            }
            width /= f64::from(PLACES);
        }
        for (column, summary) in &mut found {
            summary.dwell = width_of_dwell.map(|width| rows.dwell(*column, width, is_cyclic));
            if is_cyclic && rows.is_to_and_fro(*column) {
                let way = (summary.greatest.part - summary.least.part).abs();
                summary.time_ratio = Some(way.max(1.0 - way) / way.min(1.0 - way));
            }
        }
        Ok(found.into_iter().map(|(_, summary)| summary).collect())
    })
}

fn is_transmission(measurand: &Measurand) -> bool {
    matches!(measurand.quantity(), Some(Quantity::Transmission(_)))
}

/// Parts of the motion on both sides of an extreme.
fn around(extreme: Extreme, width: f64) -> impl Iterator<Item = f64> {
    let steps = (1..=PLACES).map(move |step| width * f64::from(step) / f64::from(PLACES));
    let both = steps.flat_map(move |step| [extreme.part - step, extreme.part + step]);
    both.filter(|part| (0.0..=1.0).contains(part))
}

/// What was measured in these parts of a motion.
struct Rows {
    parts: Vec<f64>,
    rows: Vec<Vec<Option<f64>>>,
}

impl Rows {
    fn of(prepared: &Prepared<'_>, drive: &Drive, parts: Vec<f64>) -> Result<Self, Failure> {
        let rows = prepared.rows(drive, &parts)?;
        Ok(Self { parts, rows })
    }

    /// The values of a quantity where it is determined.
    fn values(&self, column: usize) -> impl Iterator<Item = Extreme> {
        let all = self.parts.iter().zip(&self.rows);
        all.filter_map(move |(part, row)| {
            Some(Extreme { value: row[column]?, by: row[0]?, part: *part })
        })
    }

    fn summary(&self, column: usize, (name, unit): (String, String)) -> Option<Summary> {
        let first = self.values(column).next()?;
        let mut summary = Summary {
            name,
            unit,
            least: first,
            greatest: first,
            mean: 0.0,
            rms: 0.0,
            time_ratio: None,
            dwell: None,
        };
        self.refine(column, &mut summary);
        // By trapezoids: the first and the last count half.
        let weighted = self.values(column).map(|one| {
            let is_end = one.part == 0.0 || one.part == 1.0;
            (if is_end { 0.5 } else { 1.0 }, one.value)
        });
        let [weight, sum, squares] =
            weighted.fold([0.0; 3], |[weight, sum, squares], (own, value)| {
                [weight + own, sum + own * value, squares + own * value * value]
            });
        summary.mean = sum / weight;
        summary.rms = (squares / weight).sqrt();
        Some(summary)
    }

    /// Takes the extremes that are farther out.
    fn refine(&self, column: usize, summary: &mut Summary) {
        for one in self.values(column) {
            let slack = ROUNDING * one.value.abs();
            if one.value < summary.least.value - slack {
                summary.least = one;
            }
            if one.value > summary.greatest.value + slack {
                summary.greatest = one;
            }
        }
    }

    /// Whether a quantity turns round twice in a cyclic motion, without a rest.
    fn is_to_and_fro(&self, column: usize) -> bool {
        let values: Vec<f64> = self.values(column).map(|one| one.value).collect();
        let size = values.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        let ways = values.windows(2).map(|pair| pair[1] - pair[0]);
        let (moves, rests): (Vec<f64>, Vec<f64>) =
            ways.partition(|way| way.abs() > ROUNDING * size);
        let next = moves.iter().cycle().skip(1);
        let turning_points =
            moves.iter().zip(next).filter(|(one, next)| (**one > 0.0) != (**next > 0.0));
        // A step from one side of an extreme to the other is no rest.
        turning_points.count() == 2 && rests.len() <= 2
    }

    /// The longest way of what drives the motion on which a quantity stays within a width. A cyclic motion goes on from its end.
    fn dwell(&self, column: usize, width: f64, is_cyclic: bool) -> f64 {
        let all: Vec<Extreme> = self.values(column).collect();
        let (first, last) = (all[0], all[all.len() - 1]);
        let whole = last.by - first.by;
        let mut way: Vec<[f64; 2]> = all.iter().map(|one| [one.by, one.value]).collect();
        if is_cyclic {
            // Once more, without the end that is the beginning; what has turned round by then has not come back to its value.
            let gain = last.value - first.value;
            let again = all.iter().skip(1);
            way.extend(again.map(|one| [one.by + whole, one.value + gain]));
        }
        let longest = longest_within(&way, width);
        longest.min(whole.abs())
    }
}

/// The longest stretch of the first numbers on which the second ones, on straight lines between these, stay within a width.
fn longest_within(way: &[[f64; 2]], width: f64) -> f64 {
    let mut longest: f64 = 0.0;
    let mut start = 0;
    // The greatest and the least so far, each with what may follow it when it is left behind.
    let (mut greatest, mut least) = (VecDeque::new(), VecDeque::new());
    for end in 0..way.len() {
        let value = |index: usize| way[index][1];
        while greatest.back().is_some_and(|&last| value(last) <= value(end)) {
            greatest.pop_back();
        }
        while least.back().is_some_and(|&last| value(last) >= value(end)) {
            least.pop_back();
        }
        greatest.push_back(end);
        least.push_back(end);
        while value(greatest[0]) - value(least[0]) > width {
            start += 1;
            for ends in [&mut greatest, &mut least] {
                if ends[0] < start {
                    ends.pop_front();
                }
            }
        }
        let mut band = [value(least[0]), value(greatest[0])];
        let mut stretch = (way[end][0] - way[start][0]).abs();
        let beyond = [(start, start.checked_sub(1)), (end, Some(end + 1))];
        for (inside, outside) in beyond {
            let Some(next) = outside.and_then(|outside| way.get(outside)) else {
                continue;
            };
            let [by, from] = way[inside];
            // How far the line may go before the band is wider.
            let limit = next[1].clamp(band[1] - width, band[0] + width);
            let part = if next[1] == from { 1.0 } else { (limit - from) / (next[1] - from) };
            stretch += (next[0] - by).abs() * part;
            band = [band[0].min(limit), band[1].max(limit)];
        }
        longest = longest.max(stretch);
    }
    longest
}
