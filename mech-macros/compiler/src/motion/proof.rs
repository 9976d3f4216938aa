//! Declared ranges: proved by intervals to be free, or the reason why not.

use crate::bug::bug;
use crate::certify::cone::Cuts;
use crate::certify::{Interval, Verdict, certify_beside, motors_of};
use crate::evaluate;
use crate::model::{AtChangePoints, JointId, Model, MotorId};
use crate::motion::watching::{Domain, InputReads};
use crate::plan::Plan;
use crate::program::{
    AtZero, BlockId, Bound, Choice, ClosedForm, Growth, Program, Value, Watching, build_as,
};
use crate::structure::{Diagnosis, RangeTrouble};
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// A motor that has to make more turns than this until everything has turned as a whole needs a range.
const MOST_TURNS: f64 = 4096.0;

/// Proves that the mechanism moves wherever its motors are within their ranges, and takes out of the program what then needs no
/// test; gives how its loops then are solved, too.
pub(crate) fn prove_ranges(
    model: &Model,
    plan: &Plan,
    choices: Vec<Choice>,
    program: Program,
) -> Result<(Program, Vec<Choice>), Diagnosis> {
    let Some(ranged) = model.motors.iter().position(|motor| motor.range.is_some()) else {
        return Ok((program, choices));
    };
    if let Some(param) = model.params.ids().next() {
        return Err(Diagnosis::Range {
            motor: MotorId::new(ranged),
            unknowns: Vec::new(),
            trouble: RangeTrouble::Varies { param },
        });
    }
    if let Some((joint, ..)) = model.cams().next() {
        return Err(Diagnosis::Range {
            motor: MotorId::new(ranged),
            unknowns: Vec::new(),
            trouble: RangeTrouble::Cam(joint),
        });
    }
    if !program.has_loops() {
        // Nothing can be in the way.
        let program = Program { range: Some(ends(model)), ..program };
        return Ok((program, choices));
    }
    let touching = find_touching(model, plan, &choices, &program, ranged)?;
    let touches: Vec<usize> = touching
        .iter()
        .filter_map(|&block| program.closed_form(block))
        .map(|closed| closed.number)
        .collect();
    let asked = asked_for(plan, &choices, &touches);
    let settled = |(number, choice): (usize, Choice)| {
        if touches.contains(&number) {
            return choice;
        }
        let is_asked = asked.contains(&number);
        Choice {
            // It stays clear of its dead points, but others are the faster the nearer it comes.
            watching: choice
                .watching
                .filter(|_| is_asked)
                .map(|watching| Watching { at_zero: AtZero::Stay, ..watching }),
            proved: !is_asked,
            ..choice
        }
    };
    let free: Vec<Choice> = choices.iter().cloned().enumerate().map(settled).collect();
    let mut proved = build_as(model, plan, &free);
    if evaluate::settle(&mut proved).is_err() {
        return Ok((program, choices));
    }
    proved.range = Some(ends(model));
    Ok((proved, free))
}

/// The loops that may come to within rounding of a dead point or change point, if all close wherever the motors are within their ranges.
/// The first motor that has one is `ranged`.
fn find_touching(
    model: &Model,
    plan: &Plan,
    choices: &[Choice],
    program: &Program,
    ranged: usize,
) -> Result<Vec<BlockId>, Diagnosis> {
    let domain = Domain::new(model, program, choices.len());
    let whole =
        Cuts { through: &|_| true, own: None, into: &|angle| domain.parts(angle).is_some() };
    // A loop that is free wherever motors move needs no other proof.
    let is_free = |closed: &ClosedForm| {
        let choice = choices.get(closed.number);
        choice.is_some_and(|choice| choice.watching.is_none())
    };
    let free = program.margins().filter(|(_, closed)| is_free(closed));
    let free: Vec<BlockId> = free.map(|(block, _)| block).collect();
    let tested = program.margins().filter(|(_, closed)| !is_free(closed));
    let tested: Vec<Value> = tested.map(|(_, closed)| closed.discriminant).collect();
    let read = domain.read(&tested, &whole);
    let ranges: Vec<Interval> =
        model.motor_ids().map(|motor| range(&domain, &read, motor)).collect::<Result<_, _>>()?;
    let unknowns = |block: BlockId| unknowns(plan, program, block);
    let trouble = |motor: usize, block: BlockId, trouble| Diagnosis::Range {
        motor: MotorId::new(motor),
        unknowns: unknowns(block),
        trouble,
    };
    let verdict = certify_beside(program, &ranges, &free);
    let touching = match verdict {
        Verdict::Proved { touching } => touching,
        Verdict::Blocked(blocked) => {
            let others = blocked.motors.iter().filter(|motor| **motor != blocked.motor);
            let others = others.map(|&motor| (MotorId::new(motor), blocked.at[motor]));
            let (low, high) = (blocked.interval.low(), blocked.interval.high());
            let onwards = (high - blocked.limit).abs() >= (low - blocked.limit).abs();
            let blocking = RangeTrouble::Blocked {
                limit: blocked.limit,
                until: if onwards { high } else { low },
                others: others.collect(),
            };
            return Err(trouble(blocked.motor, blocked.block, blocking));
        }
        Verdict::Undecided { block, motors, place } => {
            let between = |&motor: &usize| {
                let place = place[motor];
                (MotorId::new(motor), (place.low(), place.high()))
            };
            let between: Vec<_> = motors.iter().map(between).collect();
            let motor = ranged_of(model, &motors).unwrap_or(ranged);
            return Err(trouble(motor, block, RangeTrouble::Undecided { between }));
        }
        Verdict::NoClosedForm { block } => {
            let motor = ranged_of(model, &motors_of(program, block)).unwrap_or(ranged);
            return Err(trouble(motor, block, RangeTrouble::Iterated));
        }
    };
    if let (AtChangePoints::Stop, Some(&block)) = (model.change_points, touching.first()) {
        let motor = ranged_of(model, &motors_of(program, block)).unwrap_or(ranged);
        return Err(trouble(motor, block, RangeTrouble::Stops));
    }
    Ok(touching)
}

/// The loops that are watched although they close: their sines bound how fast other loops, or angles with whole turns, change.
fn asked_for(plan: &Plan, choices: &[Choice], touches: &[usize]) -> BTreeSet<usize> {
    let near = |bound: &Bound| {
        let growth = bound.growth.iter();
        let near = growth.filter_map(|growth| match *growth {
            Growth::NearZero(number) => Some(number),
            Growth::FarOut(..) => None,
        });
        near.collect::<Vec<usize>>()
    };
    let mut asked: BTreeSet<usize> =
        plan.turning.iter().flat_map(|(_, bound)| near(bound)).collect();
    // Bounds ask for earlier loops only.
    for (number, choice) in choices.iter().enumerate().rev() {
        if let Some(watching) = &choice.watching
            && (asked.contains(&number) || touches.contains(&number))
        {
            asked.extend(near(&watching.bound));
        }
    }
    asked
}

/// The ends of all ranges; a motor without one may be anywhere.
fn ends(model: &Model) -> Vec<[f64; 2]> {
    let ends = model.motors.iter().map(|motor| match motor.range {
        Some(range) => [range.low, range.high],
        None => [f64::NEG_INFINITY, f64::INFINITY],
    });
    ends.collect()
}

/// The values of a motor that are to be proved. A motor without a range may be anywhere: so many turns are looked at that everything it
/// drives has made whole turns.
fn range(domain: &Domain<'_>, read: &InputReads, id: MotorId) -> Result<Interval, Diagnosis> {
    let input = id.index();
    let range = domain.of_input(input);
    if range.is_bounded() {
        return Ok(range);
    }
    let start = Interval::point(domain.start(input));
    if !domain.reads(read, input) {
        return Ok(start);
    }
    match domain.period(input, read) {
        Some(period) if period < MOST_TURNS * TAU => {
            Ok(start + Interval::new(-0.5 * period, 0.5 * period))
        }
        _ => Err(Diagnosis::Range {
            motor: id,
            unknowns: Vec::new(),
            trouble: RangeTrouble::Missing,
        }),
    }
}

/// The first of these motors that has a range. Where none has one, messages name the first motor that has.
fn ranged_of(model: &Model, motors: &[usize]) -> Option<usize> {
    let has_range = |motor: &usize| {
        let motor = model.motors.get(*motor);
        motor.is_some_and(|motor| motor.range.is_some())
    };
    motors.iter().copied().find(has_range)
}

/// The joints of unknown coordinate of the loop that a block closes.
pub(crate) fn unknowns(plan: &Plan, program: &Program, block: BlockId) -> Vec<JointId> {
    let Some(ring) = program.loop_of(block).and_then(|number| plan.loops().nth(number)) else {
        bug!("block {} closes no loop of the plan", block.index());
    };
    ring.unknowns()
}
