//! The proof of a condition, or a place where it does not hold.

use super::bound::{Bound, Limit};
use super::case::Case;
use super::details::Answers;
use super::domain::{Ranges, ranges};
use super::search::{BUDGET, Goal, Search, Sum};
use super::sides::{Way, subsets, turns_until_back};
use crate::certify::{Interval, Sources, side_changes};
use crate::model::{Condition, FormulaId, Measured, MotorId, RequiredBound, Requirement};
use crate::program::{BlockId, Gauge, Motion, Position, Value};
use crate::structure::{RequirementTrouble, Witness, WitnessPlace};
use std::rc::Rc;

/// It is known roughly if so many times that is open. For each of these a quarter of all intervals may be spent.
const ROUGH: [f64; 2] = [1e4, 1e2];

/// A number is told to fewer digits than this part of it.
const TOLD: f64 = 1e-5;

/// Numbers that differ by this part of them are equal but for rounding.
const ROUNDING: f64 = 1e-9;

/// A place where a condition does not hold is the worst if nothing is worse by more than this part, or than so many times what rounding
/// makes.
const WORST: f64 = 1e-6;
const ENOUGH: f64 = 100.0;

/// More loops than this that may change their side are not tried with every side of each.
const MOST_SIDES: usize = 4;

/// The difference between a link where it was proved to be and where it goes.
const ELSEWHERE: f64 = 1e-6;

/// What is searched through.
pub(super) struct Field<'a> {
    pub(super) gauge: &'a Gauge,
    found: &'a [Value],
    pub(super) ranges: &'a Ranges,
    /// Whether it is known on which sides loops are; else they may be on any of those that are searched through.
    pub(super) knows_sides: bool,
}

impl<'w> Case<'_, 'w> {
    /// Proves it; gives the intervals that were computed.
    pub(super) fn prove(
        &self,
        (subject, bounds): (FormulaId, &[RequiredBound]),
    ) -> Result<usize, RequirementTrouble> {
        let mut gauge = self.gauge()?;
        let found = values_to_find(self.requirement, &mut gauge, (subject, bounds));
        let times = self.times((subject, bounds))?;
        let mut ranges = ranges(self, &gauge, &found, times)?;
        let mut crossing = side_changes(&gauge.program, &found, ranges.touching.as_deref());
        crossing.sort_unstable();
        if crossing.len() > MOST_SIDES {
            return Err(RequirementTrouble::TooHard);
        }
        if !crossing.is_empty() && !gauge.angles.is_empty() {
            // Where it passes change points, the way decides which angle it comes to.
            match (ranges.only_motor(), ranges.round.first()) {
                (Some(_), None) if ranges.time.is_none() => {}
                (_, Some(&motor)) if ranges.time.is_none() => {
                    let motor = MotorId::new(motor);
                    return Err(RequirementTrouble::NoRange { motor });
                }
                _ => return Err(RequirementTrouble::TooHard),
            }
        }
        let way = self.find_way(&mut ranges, &crossing)?;
        let way = way.as_deref();
        let (lasting, passing): (Vec<_>, Vec<_>) = subsets(&crossing)
            .into_iter()
            .partition(|turned| way.is_none_or(|way| way.comes_to(turned)));
        // Where loops go over to their other side, little is to be looked through.
        let passing = passing.into_iter();
        let passing = passing.filter(|turned| way.is_some_and(|way| way.passes(turned)));
        let each = BUDGET / lasting.len().max(1);
        let lasting = lasting.into_iter().map(|turned| (turned, each));
        let all = lasting.chain(passing.map(|turned| (turned, BUDGET / 16)));
        let searches =
            all.map(|(turned, budget)| Search::new(&gauge, &ranges, &found, way, turned, budget));
        let mut searches: Vec<Search<'_>> = searches.collect();
        let field = Field {
            gauge: &gauge,
            found: &found,
            ranges: &ranges,
            knows_sides: crossing.is_empty() || way.is_some(),
        };
        self.prove_on_all(&field, &mut searches, (subject, bounds))?;
        Ok(searches.iter().map(Search::spent).sum())
    }

    /// The times for which it is proved, and whether everything comes round in them, if motors follow laws: these must not jump there.
    fn times(
        &self,
        bounds: (FormulaId, &[RequiredBound]),
    ) -> Result<Option<(Interval, bool)>, RequirementTrouble> {
        let Some(timed) = self.setting.timed() else {
            return Ok(None);
        };
        let Self { model, compiled, requirement, .. } = *self;
        let mut any = self.gauge_of(&compiled.program, Some(Motion::Any))?;
        let found = values_to_find(requirement, &mut any, bounds);
        let times = timed.times(model, compiled, requirement, (&any, &found))?;
        timed.refuse_jumps(times.0, (&any, &found))?;
        Ok(Some(times))
    }

    /// Finds the way of the only motor that has a part, if loops change their side on it. A motor that goes round gets as many turns as it
    /// takes until all loops are back on their sides.
    fn find_way(
        &self,
        ranges: &mut Ranges,
        crossing: &[BlockId],
    ) -> Result<Option<Rc<Way<'w>>>, RequirementTrouble> {
        let only = ranges.only_motor().filter(|_| ranges.time.is_none());
        let (false, Some(motor)) = (crossing.is_empty(), only) else {
            return Ok(None);
        };
        let program = &self.compiled.program;
        let start = Interval::point(program.start.motors[motor]);
        if ranges.round.contains(&motor) {
            let turn = ranges.all[motor].width();
            let turns = turns_until_back(program, crossing, motor, turn);
            let half = 0.5 * turn * turns.ok_or(RequirementTrouble::TooHard)?;
            ranges.all[motor] = start + Interval::new(-half, half);
        }
        let way = self.ways.find(crossing, motor, ranges.all[motor].hull(start));
        way.map(Some).ok_or(RequirementTrouble::TooHard)
    }

    /// Proves it wherever loops lie on any of their sides. What sums up the motion is taken over all sides.
    fn prove_on_all(
        &self,
        field: &Field<'_>,
        searches: &mut [Search<'_>],
        (subject, bounds): (FormulaId, &[RequiredBound]),
    ) -> Result<(), RequirementTrouble> {
        let gauge = field.gauge;
        let subject = gauge.formulas[subject.index()];
        for search in &mut *searches {
            search.come_round().ok_or(RequirementTrouble::TooHard)??;
        }
        let subject = (subject, bounds);
        // Numbers that sum up the motion are mostly needed only roughly.
        if gauge.summaries.iter().any(Option::is_some) {
            let left: Vec<usize> = searches.iter().map(Search::left).collect();
            let allow = |searches: &mut [Search<'_>], share: usize| {
                for (search, left) in searches.iter_mut().zip(&left) {
                    search.allow(left / share);
                }
            };
            for open in ROUGH {
                allow(searches, 4);
                match self.prove_with(field, searches, subject, open) {
                    Ok(()) => return Ok(()),
                    Err(RequirementTrouble::Fails(witness)) if is_told_well(&witness) => {
                        return Err(RequirementTrouble::Fails(witness));
                    }
                    Err(_) => {}
                }
            }
            allow(searches, 1);
        }
        self.prove_with(field, searches, subject, 1.0)
    }

    /// Proves it with numbers that sum up the motion, of which so many times what is usual may be open.
    fn prove_with(
        &self,
        field: &Field<'_>,
        searches: &mut [Search<'_>],
        (subject, bounds): (Value, &[RequiredBound]),
        open: f64,
    ) -> Result<(), RequirementTrouble> {
        let gauge = field.gauge;
        let mut places = None;
        let measured = self.requirement.measured.iter().zip(&gauge.summaries);
        for (measured, state) in measured {
            if let (Measured::Summary(summary, of), Some(state)) = (measured, state) {
                let value = gauge.formulas[of.index()];
                let summed = self.sum_up(field, searches, (*summary, value), open)?;
                for search in &mut *searches {
                    search.put(Sum { state: *state, value: summed.value, told: summed.told });
                }
                places.get_or_insert_with(Vec::new).extend(summed.places);
            }
        }
        let limited = bounds.iter().map(|bound| {
            let limit = self.limit(gauge, &mut searches[0], subject, bound);
            (bound, limit)
        });
        let limited: Vec<(&RequiredBound, Limit)> = limited.collect();
        let mut answers = Answers::default();
        for search in searches {
            let proved = self.prove_bounds(field, search, subject, &limited, places.as_deref());
            answers.add(proved.map(|()| 0));
        }
        answers.of_all().map(|_| ())
    }

    /// The limit of a bound's margin; the search is one with loops on their sides of the start.
    fn limit(
        &self,
        gauge: &Gauge,
        search: &mut Search<'_>,
        subject: Value,
        bound: &RequiredBound,
    ) -> Limit {
        let other = gauge.formulas[bound.limit.index()];
        Limit {
            is_strict: bound.is_strict,
            slack: ROUNDING * self.size(gauge, search, &[other, subject]),
        }
    }

    /// The size beside which rounding of some values is nothing.
    pub(super) fn size(&self, gauge: &Gauge, search: &mut Search<'_>, values: &[Value]) -> f64 {
        let places = match self.unit() {
            Some(_) => vec![gauge.program.start.motors.clone()],
            // Nobody knows how large forces and rates are.
            None => search.corners(),
        };
        let all = places.iter().flat_map(|place| values.iter().map(move |value| (place, *value)));
        let known = all.filter_map(|(place, value)| search.value_at(place, value));
        // What sums up the motion may be known so roughly that its middle says nothing.
        let sizes = known.map(|value| value.abs().low());
        sizes.fold(self.unit().unwrap_or(0.0), f64::max)
    }

    /// Proves that bounds are kept: both of a range at once. `places` are those of what sums up the motion, if anything does: a mean has
    /// none.
    fn prove_bounds(
        &self,
        field: &Field<'_>,
        search: &mut Search<'_>,
        subject: Value,
        bounds: &[(&RequiredBound, Limit)],
        places: Option<&[Vec<f64>]>,
    ) -> Result<(), RequirementTrouble> {
        let is_strict = bounds.iter().any(|(_, limit)| limit.is_strict);
        if bounds.len() > 1 && !is_strict {
            let values = bounds
                .iter()
                .map(|(bound, limit)| (field.gauge.formulas[bound.margin.index()], limit.slack));
            let goal = Goal { values: &values.collect::<Vec<_>>(), sign: 1.0 };
            let limit = Limit { is_strict, slack: 0.0 };
            let all = search.left();
            let least =
                search.least(goal, all, |found| limit.is_kept(found) || limit.is_broken(found));
            if limit.is_kept(&least) {
                return Ok(());
            }
            if !limit.is_broken(&least) {
                return Err(self.undecided(field, search, subject, &least));
            }
        }
        for (bound, limit) in bounds {
            self.prove_bound(field, search, subject, (bound, *limit), places)?;
        }
        Ok(())
    }

    fn prove_bound(
        &self,
        field: &Field<'_>,
        search: &mut Search<'_>,
        subject: Value,
        (bound, limit): (&RequiredBound, Limit),
        places: Option<&[Vec<f64>]>,
    ) -> Result<(), RequirementTrouble> {
        let goal = Goal { values: &[(field.gauge.formulas[bound.margin.index()], 0.0)], sign: 1.0 };
        let all = search.left();
        let least = search.least(goal, all, |found| {
            let is_worst = || found.gap() <= (WORST * found.seen.abs()).max(ENOUGH * limit.slack);
            limit.is_kept(found) || limit.is_broken(found) && is_worst()
        });
        if limit.is_kept(&least) {
            return Ok(());
        }
        let reached = (!least.place.is_empty()).then(|| self.reach(field, search, &least.place));
        let measured = reached.flatten().and_then(|position| {
            let margin = field.gauge.formulas[bound.margin.index()];
            let [value, margin] = search.measure(&position, [subject, margin])?;
            // Rates differ between the sides of a loop where poses do not.
            (margin <= ELSEWHERE * (1.0 + value.abs())).then_some(value)
        });
        let (true, Some(value)) = (limit.is_broken(&least), measured) else {
            return Err(self.undecided(field, search, subject, &least));
        };
        let at = |place: &[f64]| self.at(field.ranges, place);
        let places = match places {
            None => vec![at(&least.place)],
            Some(places) => places.iter().map(|place| at(place)).collect(),
        };
        let way = if bound.is_upper { 1.0 } else { -1.0 };
        let proved = value + way * (least.gap() + limit.slack);
        Err(RequirementTrouble::Fails(Witness {
            value,
            is_upper: bound.is_upper,
            proved: proved.is_finite().then_some(proved),
            places,
            is_in_time: self.setting.timed().is_some(),
            unknowns: self.unknowns(),
        }))
    }

    /// The trouble with a bound that was neither proved nor broken.
    fn undecided(
        &self,
        field: &Field<'_>,
        search: &mut Search<'_>,
        subject: Value,
        least: &Bound,
    ) -> RequirementTrouble {
        let place = &least.place;
        let value = (!place.is_empty()).then(|| search.value_at(place, subject));
        let undecided = |value: Interval| RequirementTrouble::Undecided {
            value: value.middle(),
            at: self.at(field.ranges, place),
            open: least.gap(),
        };
        value.flatten().map_or(RequirementTrouble::TooHard, undecided)
    }

    /// A place: of motors are told those that have a part, and those that stand elsewhere than at the start.
    fn at(&self, ranges: &Ranges, place: &[f64]) -> WitnessPlace {
        let start = &self.compiled.program.start.motors;
        self.place(place, |motor| {
            let motor = motor.index();
            ranges.motors.contains(&motor) || place[motor] != start[motor]
        })
    }

    /// What is compared is at least of this size, but for rounding: a radian, or the size of the mechanism. Forces and rates have none.
    fn unit(&self) -> Option<f64> {
        if self.requirement.is_about_forces() || self.requirement.is_about_rates() {
            return None;
        }
        Some(match self.requirement.condition {
            Condition::Bounds { is_angle: false, .. } => self.model.size(),
            _ => 1.0,
        })
    }

    /// The position at a place to which the mechanism comes from its start; nothing if it does not, or is not there as it was proved to
    /// be.
    pub(super) fn reach(
        &self,
        field: &Field<'_>,
        search: &mut Search<'_>,
        place: &[f64],
    ) -> Option<Position<f64>> {
        let program = self.setting.positions(self.compiled);
        let position = self.visit(place)?;
        let sources = Sources::of(&field.gauge.program, field.found);
        let numbers = program.poses.iter().flatten();
        let numbers = numbers.zip(position.poses.iter().flatten());
        let numbers = numbers.map(|(value, reached)| (*value, *reached));
        let (values, reached): (Vec<Value>, Vec<f64>) =
            numbers.filter(|(value, _)| sources.contain(*value)).unzip();
        let proved = search.values_at(place, &values)?;
        let is_there = proved.iter().zip(reached).all(|(proved, reached)| {
            (proved.middle() - reached).abs() <= ELSEWHERE * (1.0 + reached.abs())
        });
        is_there.then_some(position)
    }
}

/// Whether a value that breaks a limit is known to more digits than are told.
fn is_told_well(witness: &Witness) -> bool {
    let Witness { value, proved, .. } = witness;
    proved.is_some_and(|proved| (proved - value).abs() <= TOLD * value.abs())
}

/// The values that a gauge has to find, and the angles that are followed for it: no others are.
fn values_to_find(
    requirement: &Requirement,
    gauge: &mut Gauge,
    bounds: (FormulaId, &[RequiredBound]),
) -> Vec<Value> {
    let mut found = subjects(requirement, gauge, bounds);
    let sources = Sources::of(&gauge.program, &found);
    let state = &gauge.program.state;
    gauge.angles.retain(|angle| sources.contain(state[angle.reference]));
    found.extend(gauge.angles.iter().map(|angle| angle.beyond));
    found.sort_unstable();
    found.dedup();
    found
}

/// The values that a requirement is about.
fn subjects(
    requirement: &Requirement,
    gauge: &Gauge,
    (subject, bounds): (FormulaId, &[RequiredBound]),
) -> Vec<Value> {
    let summed = requirement.measured.iter();
    let summed = summed.filter_map(|measured| match measured {
        Measured::Summary(_, of) => Some(*of),
        Measured::Quantity(_) | Measured::Influence(..) | Measured::Rate(..) => None,
    });
    let bounds = bounds.iter().flat_map(|bound| [bound.margin, bound.limit]);
    let formulas = [subject].into_iter().chain(bounds).chain(summed);
    formulas.map(|formula| gauge.formulas[formula.index()]).collect()
}
