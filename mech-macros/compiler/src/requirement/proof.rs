//! The proof of a condition, or a place where it does not hold.

use super::Proof;
use super::bound::Limit;
use super::domain::{Ranges, ranges};
use super::search::{BUDGET, Goal, Search};
use super::sides::Sides;
use crate::certify::{Interval, Sources, side_changes};
use crate::compiled::Compiled;
use crate::evaluate::Machine;
use crate::model::{
    AxisId, Condition, FormulaId, JointId, Measured, Model, MotorId, Quantity, RequiredBound,
    Requirement, Spot, Summary,
};
use crate::plan::Loop;
use crate::program::{Gauge, Program, Value};
use crate::structure::{RequirementTrouble, Witness};

/// A number that sums up the motion is known well enough if this part of it is open.
const WELL_KNOWN: f64 = 1e-10;

/// Numbers that differ by this part of them are equal but for rounding.
const ROUNDING: f64 = 1e-9;

/// A place where a condition does not hold is the worst if nothing is worse by more than this part.
const WORST: f64 = 1e-6;

/// More loops than this that may change their side are not tried with every side of each.
const MOST_SIDES: usize = 4;

/// The difference between a link where it was proved to be and where it goes.
const ELSEWHERE: f64 = 1e-6;

/// Proves that bounds are kept wherever the motors may be.
pub(super) fn prove(
    model: &Model,
    compiled: &Compiled,
    requirement: &Requirement,
    bounds: (FormulaId, &[RequiredBound]),
) -> Result<Proof, RequirementTrouble> {
    refuse_params(model, requirement)?;
    let is_of_all =
        |measured: &Measured| *measured == Measured::Quantity(Quantity::Transmission(None));
    let mut dyads: Vec<Option<usize>> = vec![None];
    if requirement.measured.iter().any(is_of_all) {
        dyads = (0..compiled.plan.loops().count()).map(Some).collect();
        if dyads.is_empty() {
            return Err(RequirementTrouble::NoDyad {
                unknowns: Vec::new(),
            });
        }
    }
    let mut effort = 0;
    for dyad in dyads {
        let case = Case {
            model,
            compiled,
            requirement,
            dyad,
        };
        effort += case.prove(bounds)?;
    }
    Ok(Proof { effort })
}

/// Refuses what params place.
fn refuse_params(model: &Model, requirement: &Requirement) -> Result<(), RequirementTrouble> {
    let Some(param) = model.params.ids().next() else {
        return Ok(());
    };
    let depends = |axis: AxisId| {
        let axis = model.axis(axis);
        let mut formulas = axis.formulas.iter().chain(&axis.direction_formulas);
        formulas.any(Option::is_some)
    };
    let mut axes = requirement
        .measured
        .iter()
        .flat_map(|measured| match *measured {
            Measured::Quantity(Quantity::X(axis) | Quantity::Y(axis)) => vec![axis],
            Measured::Quantity(Quantity::Distance(spots)) => {
                let axes = spots.iter().filter_map(|spot| match spot {
                    Spot::Axis(axis) => Some(*axis),
                    Spot::At(_) => None,
                });
                axes.collect()
            }
            _ => Vec::new(),
        });
    if axes.any(depends) {
        return Err(RequirementTrouble::Varies { param });
    }
    Ok(())
}

/// A condition, for one dyad if it is about each.
struct Case<'a> {
    model: &'a Model,
    compiled: &'a Compiled,
    requirement: &'a Requirement,
    dyad: Option<usize>,
}

/// What is searched through.
struct Field<'a> {
    gauge: &'a Gauge,
    found: &'a [Value],
    ranges: &'a Ranges,
}

impl Case<'_> {
    /// Proves it; gives the intervals that were computed.
    fn prove(
        &self,
        (subject, bounds): (FormulaId, &[RequiredBound]),
    ) -> Result<usize, RequirementTrouble> {
        let Self {
            model,
            compiled,
            requirement,
            ..
        } = *self;
        let gauge = Gauge::new(model, &compiled.program, requirement, |joint| {
            self.dyad_of(joint)
        });
        let Some(gauge) = gauge else {
            let unknowns = self.unknowns(self.dyad);
            return Err(RequirementTrouble::NoDyad { unknowns });
        };
        let mut found = gauge.formulas.clone();
        found.sort_unstable();
        found.dedup();
        let ranges = ranges(model, compiled, requirement, &gauge, &found)?;
        let field = Field {
            gauge: &gauge,
            found: &found,
            ranges: &ranges,
        };
        let crossing = side_changes(&gauge.program, &found, ranges.touching.as_deref());
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
        let mut effort = 0;
        for sides in 0..1_usize << crossing.len() {
            let turned = crossing.iter().enumerate();
            let turned = turned.filter(|(index, _)| sides >> index & 1 == 1);
            let turned = turned.map(|(_, block)| *block).collect();
            let left = BUDGET >> crossing.len();
            let sides = Sides::new(
                &compiled.program,
                [crossing.clone(), turned],
                ranges.only_motor(),
            );
            effort += self.prove_on(&field, sides, left, (subject, bounds))?;
        }
        Ok(effort)
    }

    /// The loop whose transmission angle is meant.
    fn dyad_of(&self, joint: Option<JointId>) -> Option<usize> {
        let Some(joint) = joint else {
            return self.dyad;
        };
        let mut loops = self.compiled.plan.loops();
        loops.position(|ring| ring.unknowns().contains(&joint))
    }

    fn unknowns(&self, dyad: Option<usize>) -> Vec<JointId> {
        let ring = dyad.and_then(|number| self.compiled.plan.loops().nth(number));
        ring.map_or(Vec::new(), Loop::unknowns)
    }

    /// Proves it with these loops on their other side.
    fn prove_on(
        &self,
        field: &Field<'_>,
        sides: Sides<'_>,
        left: usize,
        (subject, bounds): (FormulaId, &[RequiredBound]),
    ) -> Result<usize, RequirementTrouble> {
        let gauge = field.gauge;
        let mut search = Search::new(gauge, field.ranges, field.found, sides, left);
        let subject = gauge.formulas[subject.index()];
        let goal = Goal {
            value: subject,
            sign: 1.0,
        };
        match search.endless(goal) {
            Some(Ok(())) => {}
            Some(Err(motor)) => {
                let motor = MotorId::new(motor);
                return Err(RequirementTrouble::Endless { motor });
            }
            None => return Err(RequirementTrouble::TooHard),
        }
        let mut places = Vec::new();
        let measured = self.requirement.measured.iter().zip(&gauge.summaries);
        for (measured, state) in measured {
            if let (Measured::Summary(summary, of), Some(state)) = (measured, state) {
                let value = gauge.formulas[of.index()];
                let summed = sum_up(&mut search, *summary, value);
                search.put(*state, summed.value);
                places.extend(summed.places);
            }
        }
        for bound in bounds {
            self.keep(field, &mut search, (subject, bound), &places)?;
        }
        Ok(left - search.left())
    }

    /// Proves that a bound is kept. `places` are those of what sums up the motion, if anything does.
    fn keep(
        &self,
        field: &Field<'_>,
        search: &mut Search<'_>,
        (subject, bound): (Value, &RequiredBound),
        places: &[Vec<f64>],
    ) -> Result<(), RequirementTrouble> {
        let gauge = field.gauge;
        let [margin, other] =
            [bound.margin, bound.limit].map(|formula| gauge.formulas[formula.index()]);
        let sizes = [other, subject].map(|value| {
            let at_start = search.value_at(&gauge.program.start.motors, value);
            at_start.map_or(0.0, |value| value.middle().abs())
        });
        let slack = ROUNDING * sizes[0].max(sizes[1]).max(self.unit());
        let limit = Limit {
            is_strict: bound.is_strict,
            slack,
        };
        let goal = Goal {
            value: margin,
            sign: 1.0,
        };
        let all = search.left();
        let least = search.least(goal, all, |found| {
            limit.is_kept(found)
                || limit.is_broken(found) && found.gap() <= WORST * found.seen.abs()
        });
        if limit.is_kept(&least) || search.is_nowhere(&least) {
            return Ok(());
        }
        if least.place.is_empty() {
            return Err(RequirementTrouble::TooHard);
        }
        let value = search.value_at(&least.place, subject);
        let value = value.map_or(f64::NAN, Interval::middle);
        let at = |place: &[f64]| at(field.ranges, place);
        if !limit.is_broken(&least) || !self.is_reached(field, search, &least.place) {
            return Err(RequirementTrouble::Undecided {
                value,
                at: at(&least.place),
                open: least.gap(),
            });
        }
        let places = if places.is_empty() {
            vec![at(&least.place)]
        } else {
            places.iter().map(|place| at(place)).collect()
        };
        let way = if bound.is_upper { 1.0 } else { -1.0 };
        let proved = value + way * (least.gap() + slack);
        Err(RequirementTrouble::Fails(Witness {
            value,
            is_upper: bound.is_upper,
            proved: proved.is_finite().then_some(proved),
            places,
            unknowns: self.unknowns(self.dyad),
        }))
    }

    /// What is compared is at least of this size, but for rounding: a radian, or the size of the mechanism.
    fn unit(&self) -> f64 {
        match self.requirement.condition {
            Condition::Bounds {
                is_angle: false, ..
            } => self.model.size(),
            _ => 1.0,
        }
    }

    /// Whether the mechanism comes to a place from its start, and is there as it was proved to be.
    fn is_reached(&self, field: &Field<'_>, search: &mut Search<'_>, place: &[f64]) -> bool {
        let program = &self.compiled.program;
        let Some(poses) = visit(program, place) else {
            return false;
        };
        let sources = Sources::of(&field.gauge.program, field.found);
        let numbers = program.poses.iter().flatten().zip(poses.iter().flatten());
        for (value, reached) in numbers {
            if !sources.contain(*value) {
                continue;
            }
            let Some(proved) = search.value_at(place, *value) else {
                return false;
            };
            if (proved.middle() - reached).abs() > ELSEWHERE * (1.0 + reached.abs()) {
                return false;
            }
        }
        true
    }
}

/// The motors that have a part, with their values at a place.
fn at(ranges: &Ranges, place: &[f64]) -> Vec<(MotorId, f64)> {
    let motors = ranges.motors.iter();
    let values = motors.filter_map(|&motor| Some((MotorId::new(motor), *place.get(motor)?)));
    values.collect()
}

/// The poses of all links at a place to which the motors go together, or one after the other.
fn visit(program: &Program, place: &[f64]) -> Option<Vec<[f64; 4]>> {
    let mut machine = Machine::<f64>::new(program);
    if machine.move_to(place).is_ok() {
        return Some(machine.position().poses.clone());
    }
    let mut values = program.start.motors.clone();
    for (motor, goal) in place.iter().enumerate() {
        values[motor] = *goal;
        machine.move_to(&values).ok()?;
    }
    Some(machine.position().poses.clone())
}

/// A number that sums up the motion, and where what it is made from is.
struct Summed {
    value: Interval,
    places: Vec<Vec<f64>>,
}

fn sum_up(search: &mut Search<'_>, summary: Summary, value: Value) -> Summed {
    let mut end = |sign: f64| {
        let spend = search.left() / 3;
        let found = search.least(Goal { value, sign }, spend, |found| {
            found.gap() <= WELL_KNOWN * found.seen.abs()
        });
        let ends = [sign * found.proved, sign * found.seen];
        (Interval::new(ends[0], ends[1]), found.place)
    };
    match summary {
        Summary::Min => {
            let (value, place) = end(1.0);
            Summed {
                value,
                places: vec![place],
            }
        }
        Summary::Max => {
            let (value, place) = end(-1.0);
            Summed {
                value,
                places: vec![place],
            }
        }
        Summary::Swing => {
            let ((low, first), (high, second)) = (end(1.0), end(-1.0));
            Summed {
                value: high - low,
                places: vec![first, second],
            }
        }
    }
}
