//! Numbers that sum up the motion.

use super::bound::Bound;
use super::case::Case;
use super::course::Course;
use super::proof::Field;
use super::round_of;
use super::search::{Goal, Search};
use crate::certify::Interval;
use crate::model::Summary;
use crate::program::Value;
use crate::structure::RequirementTrouble;

/// A number that sums up the motion is known well enough if this part of it is open, or this part of its size.
const WELL_KNOWN: f64 = 1e-10;
const NOTHING: f64 = 1e-12;

/// A number that sums up the motion, and where what it is made from is.
pub(super) struct Summed {
    pub(super) value: Interval,
    /// What it is at these places, or the middle of its bounds.
    pub(super) told: f64,
    pub(super) places: Vec<Vec<f64>>,
}

impl Case<'_, '_> {
    /// Bounds a number that sums up the motion.
    pub(super) fn sum_up(
        &self,
        field: &Field<'_>,
        searches: &mut [Search<'_>],
        (summary, value): (Summary, Value),
        open: f64,
    ) -> Result<Summed, RequirementTrouble> {
        let mut end = |sign: f64| self.end(field, searches, (value, sign), open);
        match summary {
            Summary::Min => end(1.0),
            Summary::Max => end(-1.0),
            Summary::Swing => {
                let (low, high) = (end(1.0)?, end(-1.0)?);
                Ok(Summed {
                    value: (high.value - low.value).max(Interval::ZERO),
                    told: high.told - low.told,
                    places: [low.places, high.places].concat(),
                })
            }
            Summary::Mean | Summary::Rms | Summary::TimeRatio | Summary::Dwell(_) => {
                self.sum_up_course(field, searches, (summary, value), open)
            }
        }
    }

    /// Bounds a number that sums up how a value changes along the way of the only motor that has a part.
    fn sum_up_course(
        &self,
        field: &Field<'_>,
        searches: &mut [Search<'_>],
        (summary, value): (Summary, Value),
        open: f64,
    ) -> Result<Summed, RequirementTrouble> {
        let all = &field.ranges.all;
        let motors = field.ranges.motors.iter().copied();
        let motors: Vec<usize> = motors.filter(|motor| all[*motor].width() > 0.0).collect();
        let [motor] = motors[..] else {
            let ranges = field.ranges;
            let motors = motors.into_iter();
            return Err(RequirementTrouble::SeveralMotors {
                motors: motors.filter_map(|one| ranges.motor(one)).collect(),
                is_in_time: ranges.time.is_some(),
            });
        };
        // Where loops change their side, the course is in pieces.
        let [search] = searches else {
            return Err(RequirementTrouble::TooHard);
        };
        let loops = self.compiled.plan.loops().count();
        let is_time = field.ranges.motor(motor).is_none();
        let period = if is_time {
            let is_round = field.ranges.round.contains(&motor);
            is_round.then(|| all[motor].width())
        } else {
            round_of(self.model, &field.gauge.program, (loops, motor), &[value])
        };
        let near = field.ranges.nearest(&field.gauge.program.start.motors);
        let has_ends = !matches!(summary, Summary::Mean | Summary::Rms);
        let way = (motor, all[motor]);
        let course = Course::new(search, value, way, near.clone(), period, has_ends);
        let mut course = course.ok_or(RequirementTrouble::TooHard)?;
        let (value, ends) = match summary {
            Summary::Dwell(width) => course.dwell(width, open),
            Summary::TimeRatio => {
                let motor = field.ranges.motor(motor);
                let found = course.time_ratio(open);
                found.ok_or(RequirementTrouble::NotToAndFro { motor })?
            }
            // The value is the square.
            Summary::Rms => (course.mean(open).max(Interval::ZERO).sqrt(), Vec::new()),
            _ => (course.mean(open), Vec::new()),
        };
        let place = |end: f64| {
            let mut place = near.clone();
            place[motor] = end;
            place
        };
        if !value.is_bounded() {
            return Err(RequirementTrouble::TooHard);
        }
        Ok(Summed { value, told: value.middle(), places: ends.into_iter().map(place).collect() })
    }

    /// Bounds the least value, times its sign, over all sides of loops; with a place where it is told to be, to which the mechanism comes.
    /// Where nobody knows the sides, the value there is that of one side, and no bound.
    fn end(
        &self,
        field: &Field<'_>,
        searches: &mut [Search<'_>],
        (value, sign): (Value, f64),
        open: f64,
    ) -> Result<Summed, RequirementTrouble> {
        let goal = Goal { values: &[(value, 0.0)], sign };
        let nothing = NOTHING * self.size(field.gauge, &mut searches[0], &[value]);
        let mut proved = f64::INFINITY;
        let mut least: Option<(Bound, usize)> = None;
        for (number, search) in searches.iter_mut().enumerate() {
            let spend = search.left() / 3;
            let found = search.least(goal, spend, |found| {
                found.gap() <= open * nothing.max(WELL_KNOWN * found.seen.abs())
            });
            proved = proved.min(found.proved);
            if least.as_ref().is_none_or(|(least, _)| found.seen < least.seen) {
                least = Some((found, number));
            }
        }
        let Some((Bound { seen, place, .. }, number)) = least else {
            return Err(RequirementTrouble::TooHard);
        };
        if place.is_empty() || self.reach(field, &mut searches[number], &place).is_none() {
            return Err(RequirementTrouble::TooHard);
        }
        let mut other = seen;
        if !field.knows_sides {
            for search in searches {
                other = other.max(Self::greatest(search, (value, sign)));
            }
        }
        Ok(Summed {
            value: Interval::new(sign * proved, sign * other),
            told: sign * seen,
            places: vec![place],
        })
    }

    /// More than a value, times its sign, is anywhere.
    fn greatest(search: &mut Search<'_>, (value, sign): (Value, f64)) -> f64 {
        let goal = Goal { values: &[(value, 0.0)], sign: -sign };
        let spend = search.left() / 8;
        -search.least(goal, spend, |found| found.proved.is_finite()).proved
    }
}
