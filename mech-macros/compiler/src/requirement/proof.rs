//! The proof of a condition, or a place where it does not hold.

use super::answers::Answers;
use super::bound::{Bound, Limit};
use super::circumstances::Rates;
use super::course::Course;
use super::domain::{Ranges, Verdicts, ranges, round_of};
use super::search::{BUDGET, Goal, Search, Sum};
use super::sides::{Way, Ways, subsets, turns_until_back};
use crate::certify::{Interval, Sources, side_changes};
use crate::compiled::Compiled;
use crate::evaluate::Machine;
use crate::model::{
    Condition, FormulaId, JointId, Measured, Model, MotorId, RequiredBound, Requirement, Summary,
};
use crate::plan::Loop;
use crate::program::{BlockId, Detail, Gauge, Position, Program, Value};
use crate::structure::{RequirementTrouble, Witness};
use std::rc::Rc;

/// A number that sums up the motion is known well enough if this part of it is open, or this part of its size.
const WELL_KNOWN: f64 = 1e-10;
const NOTHING: f64 = 1e-12;

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

/// A condition, for one detail if it is about each.
#[derive(Clone, Copy)]
pub(super) struct Case<'a> {
    pub(super) model: &'a Model,
    pub(super) compiled: &'a Compiled,
    pub(super) verdicts: &'a Verdicts<'a>,
    pub(super) ways: &'a Ways<'a>,
    pub(super) requirement: &'a Requirement,
    pub(super) detail: Detail,
}

/// What is searched through.
struct Field<'a> {
    gauge: &'a Gauge,
    found: &'a [Value],
    ranges: &'a Ranges,
}

impl<'a> Case<'a> {
    /// Proves it; gives the intervals that were computed.
    pub(super) fn prove(
        &self,
        (subject, bounds): (FormulaId, &[RequiredBound]),
    ) -> Result<usize, RequirementTrouble> {
        let Self {
            model,
            compiled,
            verdicts,
            requirement,
            ..
        } = *self;
        let mut gauge = self.gauge()?;
        let mut found = subjects(requirement, &gauge, (subject, bounds));
        let sources = Sources::of(&gauge.program, &found);
        let state = &gauge.program.state;
        gauge
            .angles
            .retain(|angle| sources.contain(state[angle.reference]));
        found.extend(gauge.angles.iter().map(|angle| angle.beyond));
        found.sort_unstable();
        found.dedup();
        let mut ranges = ranges(model, compiled, verdicts, requirement, &gauge, &found)?;
        let mut crossing = side_changes(&gauge.program, &found, ranges.touching.as_deref());
        crossing.sort_unstable();
        if crossing.len() > MOST_SIDES {
            return Err(RequirementTrouble::TooHard);
        }
        if !crossing.is_empty() && !gauge.angles.is_empty() {
            // Where it passes change points, the way decides which angle it comes to.
            match (ranges.only_motor(), ranges.round.first()) {
                (Some(_), None) => {}
                (_, Some(&motor)) => {
                    let motor = MotorId::new(motor);
                    return Err(RequirementTrouble::NoRange { motor });
                }
                (None, None) => return Err(RequirementTrouble::TooHard),
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
        };
        self.prove_on_all(&field, &mut searches, (subject, bounds))?;
        Ok(searches.iter().map(Search::spent).sum())
    }

    /// The program that measures it.
    pub(super) fn gauge(&self) -> Result<Gauge, RequirementTrouble> {
        let Self {
            model,
            compiled,
            requirement,
            ..
        } = *self;
        let rates = Rates::of(model, requirement)?;
        let forces = rates.forces(model, compiled, requirement)?;
        let gauge = Gauge::new(
            model,
            (&compiled.plan, &compiled.program),
            &rates.circumstances(requirement, forces.as_deref()),
            requirement,
            self.detail,
            |joint| self.dyad_of(joint),
        );
        gauge.ok_or_else(|| {
            if requirement.is_about_forces() {
                return RequirementTrouble::NoForces;
            }
            let unknowns = self.unknowns();
            RequirementTrouble::NoDyad { unknowns }
        })
    }

    /// Finds the way of the only motor that has a part, if loops change their side on it. A motor that goes round gets as many turns as it
    /// takes until all loops are back on their sides.
    fn find_way(
        &self,
        ranges: &mut Ranges,
        crossing: &[BlockId],
    ) -> Result<Option<Rc<Way<'a>>>, RequirementTrouble> {
        let (false, Some(motor)) = (crossing.is_empty(), ranges.only_motor()) else {
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
        let way = self
            .ways
            .find(crossing, motor, ranges.all[motor].hull(start));
        way.map(Some).ok_or(RequirementTrouble::TooHard)
    }

    /// The loop whose transmission angle is meant.
    fn dyad_of(&self, joint: JointId) -> Option<usize> {
        let mut loops = self.compiled.plan.loops();
        loops.position(|ring| ring.unknowns().contains(&joint))
    }

    /// The unknown joints of the loop that it is about, if it is about one.
    fn unknowns(&self) -> Vec<JointId> {
        let Detail::Dyad(number) = self.detail else {
            return Vec::new();
        };
        let ring = self.compiled.plan.loops().nth(number);
        ring.map_or(Vec::new(), Loop::unknowns)
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
                    search.put(Sum {
                        state: *state,
                        value: summed.value,
                        told: summed.told,
                    });
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
    fn size(&self, gauge: &Gauge, search: &mut Search<'_>, values: &[Value]) -> f64 {
        let places = match self.unit() {
            Some(_) => vec![gauge.program.start.motors.clone()],
            // Nobody knows how large forces and rates are.
            None => search.corners(),
        };
        let all = places
            .iter()
            .flat_map(|place| values.iter().map(move |value| (place, *value)));
        let known = all.filter_map(|(place, value)| search.value_at(place, value));
        // What sums up the motion may be known so roughly that its middle says nothing.
        let sizes = known.map(|value| value.abs().low());
        sizes.fold(self.unit().unwrap_or(0.0), f64::max)
    }

    /// Bounds a number that sums up the motion.
    fn sum_up(
        &self,
        field: &Field<'_>,
        searches: &mut [Search<'_>],
        (summary, value): (Summary, Value),
        open: f64,
    ) -> Result<Summed, RequirementTrouble> {
        let mut end = |sign: f64| self.end(field, searches, (value, sign), open);
        match summary {
            Summary::Min => end(1.0).map(|(value, place)| Summed {
                value,
                told: value.high(),
                places: vec![place],
            }),
            Summary::Max => end(-1.0).map(|(value, place)| Summed {
                value,
                told: value.low(),
                places: vec![place],
            }),
            Summary::Swing => {
                let ((low, first), (high, second)) = (end(1.0)?, end(-1.0)?);
                Ok(Summed {
                    value: high - low,
                    told: high.low() - low.high(),
                    places: vec![first, second],
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
            let motors = motors.into_iter().map(MotorId::new).collect();
            return Err(RequirementTrouble::SeveralMotors { motors });
        };
        // Where loops change their side, the course is in pieces.
        let [search] = searches else {
            return Err(RequirementTrouble::TooHard);
        };
        let period = round_of(
            self.model,
            &field.gauge.program,
            (self.compiled.plan.loops().count(), motor),
            &[value],
        );
        let near = field.ranges.nearest(&field.gauge.program.start.motors);
        let has_ends = !matches!(summary, Summary::Mean | Summary::Rms);
        let way = (motor, all[motor]);
        let course = Course::new(search, value, way, near.clone(), period, has_ends);
        let mut course = course.ok_or(RequirementTrouble::TooHard)?;
        let (value, ends) = match summary {
            Summary::Dwell(width) => course.dwell(width, open),
            Summary::TimeRatio => {
                let motor = MotorId::new(motor);
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
        Ok(Summed {
            value,
            told: value.middle(),
            places: ends.into_iter().map(place).collect(),
        })
    }

    /// Bounds the least value, times its sign, over all sides of loops; with the place where one end of the bounds is attained, to which the
    /// mechanism comes.
    fn end(
        &self,
        field: &Field<'_>,
        searches: &mut [Search<'_>],
        (value, sign): (Value, f64),
        open: f64,
    ) -> Result<(Interval, Vec<f64>), RequirementTrouble> {
        let goal = Goal {
            values: &[(value, 0.0)],
            sign,
        };
        let nothing = NOTHING * self.size(field.gauge, &mut searches[0], &[value]);
        let mut proved = f64::INFINITY;
        let mut least: Option<(Bound, usize)> = None;
        for (number, search) in searches.iter_mut().enumerate() {
            let spend = search.left() / 3;
            let found = search.least(goal, spend, |found| {
                found.gap() <= open * nothing.max(WELL_KNOWN * found.seen.abs())
            });
            proved = proved.min(found.proved);
            if least
                .as_ref()
                .is_none_or(|(least, _)| found.seen < least.seen)
            {
                least = Some((found, number));
            }
        }
        let Some((Bound { seen, place, .. }, number)) = least else {
            return Err(RequirementTrouble::TooHard);
        };
        if place.is_empty() || self.reach(field, &mut searches[number], &place).is_none() {
            return Err(RequirementTrouble::TooHard);
        }
        Ok((Interval::new(sign * proved, sign * seen), place))
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
            let goal = Goal {
                values: &values.collect::<Vec<_>>(),
                sign: 1.0,
            };
            let limit = Limit {
                is_strict,
                slack: 0.0,
            };
            let all = search.left();
            let least = search.least(goal, all, |found| {
                limit.is_kept(found) || limit.is_broken(found)
            });
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
        let goal = Goal {
            values: &[(field.gauge.formulas[bound.margin.index()], 0.0)],
            sign: 1.0,
        };
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
            let value = search.measure(&position, subject)?;
            let margin = field.gauge.formulas[bound.margin.index()];
            let margin = search.measure(&position, margin)?;
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
        value
            .flatten()
            .map_or(RequirementTrouble::TooHard, undecided)
    }

    /// The values of motors at a place: of those that have a part, and of those that stand elsewhere than at the start.
    fn at(&self, ranges: &Ranges, place: &[f64]) -> Vec<(MotorId, f64)> {
        let start = &self.compiled.program.start.motors;
        let motors = place.iter().take(self.model.motors.len()).enumerate();
        let told = motors
            .filter(|(motor, value)| ranges.motors.contains(motor) || **value != start[*motor]);
        told.map(|(motor, value)| (MotorId::new(motor), *value))
            .collect()
    }

    /// What is compared is at least of this size, but for rounding: a radian, or the size of the mechanism. Forces and rates have none.
    fn unit(&self) -> Option<f64> {
        if self.requirement.is_about_forces() || self.requirement.is_about_rates() {
            return None;
        }
        Some(match self.requirement.condition {
            Condition::Bounds {
                is_angle: false, ..
            } => self.model.size(),
            _ => 1.0,
        })
    }

    /// The position at a place to which the mechanism comes from its start; nothing if it does not, or is not there as it was proved to
    /// be.
    fn reach(
        &self,
        field: &Field<'_>,
        search: &mut Search<'_>,
        place: &[f64],
    ) -> Option<Position<f64>> {
        let program = &self.compiled.program;
        let position = visit(program, place)?;
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
    formulas
        .map(|formula| gauge.formulas[formula.index()])
        .collect()
}

/// The position at a place to which the motors go together, or one after the other.
pub(super) fn visit(program: &Program, place: &[f64]) -> Option<Position<f64>> {
    let mut machine = Machine::<f64>::new(program);
    if machine.move_to(place).is_err() {
        let mut values = program.start.motors.clone();
        for (motor, goal) in place.iter().enumerate() {
            values[motor] = *goal;
            machine.move_to(&values).ok()?;
        }
    }
    Some(machine.into_position())
}

/// A number that sums up the motion, and where what it is made from is.
struct Summed {
    value: Interval,
    /// What it is at these places, or the middle of its bounds.
    told: f64,
    places: Vec<Vec<f64>>,
}
