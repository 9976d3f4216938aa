//! Summaries of quantities through a motion: their extremes and means.

use super::Measurement;
use super::kind::Quantity;
use super::meter::{Prepared, columns};
use crate::failure::Failure;
use crate::motion::Drive;

/// An extreme is looked for so often between its neighbours.
const ROUNDS: u32 = 10;
/// Each time at so many places on either side.
const PLACES: u32 = 4;
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
    /// points.
    pub(crate) time_ratio: Option<f64>,
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
}

/// Summarizes quantities through a motion. What is determined nowhere is left out.
pub(crate) fn summarize(
    of: &Measurement<'_>,
    quantities: &[Quantity],
) -> Result<Vec<Summary>, Failure> {
    let prepared = Prepared::new(of, quantities)?;
    let parts = of.parts();
    let is_cyclic = of.drive.is_cyclic(of.model);
    of.drive.attempt(|drive| {
        let rows = Rows::of(&prepared, drive, parts.clone())?;
        let columns = columns(of, quantities).into_iter().enumerate().skip(1);
        let mut found: Vec<(usize, Summary)> = columns
            .filter_map(|(column, named)| Some((column, rows.summary(column, named)?)))
            .collect();
        let mut width = 1.0 / f64::from(of.steps.max(1));
        for _ in 0..ROUNDS {
            let near = found
                .iter()
                .flat_map(|(_, one)| around(one.least, width).chain(around(one.greatest, width)));
            let mut near: Vec<f64> = near.collect();
            near.sort_by(f64::total_cmp);
            near.dedup();
            let rows = Rows::of(&prepared, drive, near)?;
            for (column, summary) in &mut found {
                rows.refine(*column, summary);
            }
            width /= f64::from(PLACES);
        }
        for (column, summary) in &mut found {
            if is_cyclic && rows.turning_points(*column) == 2 {
                let way = (summary.greatest.part - summary.least.part).abs();
                summary.time_ratio = Some(way.max(1.0 - way) / way.min(1.0 - way));
            }
        }
        Ok(found.into_iter().map(|(_, summary)| summary).collect())
    })
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
            Some(Extreme {
                value: row[column]?,
                by: row[0]?,
                part: *part,
            })
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
        };
        self.refine(column, &mut summary);
        // By trapezoids: the first and the last count half.
        let weighted = self.values(column).map(|one| {
            let is_end = one.part == 0.0 || one.part == 1.0;
            (if is_end { 0.5 } else { 1.0 }, one.value)
        });
        let [weight, sum, squares] =
            weighted.fold([0.0; 3], |[weight, sum, squares], (own, value)| {
                [
                    weight + own,
                    sum + own * value,
                    squares + own * value * value,
                ]
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

    /// How often a quantity turns round in a cyclic motion.
    fn turning_points(&self, column: usize) -> usize {
        let values: Vec<f64> = self.values(column).map(|one| one.value).collect();
        let size = values
            .iter()
            .fold(0.0, |size: f64, value| size.max(value.abs()));
        let ways = values.windows(2).map(|pair| pair[1] - pair[0]);
        let ways: Vec<bool> = ways
            .filter(|way| way.abs() > ROUNDING * size)
            .map(|way| way > 0.0)
            .collect();
        let next = ways.iter().cycle().skip(1);
        ways.iter()
            .zip(next)
            .filter(|(one, next)| one != next)
            .count()
    }
}
