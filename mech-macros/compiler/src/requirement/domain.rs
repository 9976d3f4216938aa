//! The values of the motors for which a requirement is proved.

use super::Verdicts;
use super::case::Case;
use super::round_of;
use super::times::Timed;
use crate::certify::{Enclosure, Interval, Sources, Verdict, is_same};
use crate::evaluate::Machine;
use crate::model::MotorId;
use crate::motion::proof::unknowns;
use crate::program::{BlockId, Gauge, Program, Value};
use crate::structure::RequirementTrouble;

/// So many turns a motor may go until it is stopped, or so many sizes of the mechanism if it slides.
const MOST_REACH: [f64; 2] = [4.0 * std::f64::consts::TAU, 64.0];

/// Boxes narrower than this part of all values are not cut.
const NARROW: f64 = 1e-13;

/// The values of all motors, and which of them have a part. The time is one of them where motors follow laws.
pub(super) struct Ranges {
    /// For each motor its values; a motor that has no part stands at its start.
    pub(super) all: Vec<Interval>,
    /// The motors that have a part, by their numbers.
    pub(super) motors: Vec<usize>,
    /// The number of the time, if motors follow laws.
    pub(super) time: Option<usize>,
    /// The motors that go right round: at both ends of their values everything is as it was, but for whole turns.
    pub(super) round: Vec<usize>,
    /// The loops that may come to a dead point or change point there, or on the way there from the start, if that is known.
    pub(super) touching: Option<Vec<BlockId>>,
}

impl Ranges {
    /// The only motor that has a part.
    pub(super) fn only_motor(&self) -> Option<usize> {
        match self.motors[..] {
            [motor] => Some(motor),
            _ => None,
        }
    }

    /// The motor of a number; none if that is the time.
    pub(super) fn motor(&self, number: usize) -> Option<MotorId> {
        (self.time != Some(number)).then(|| MotorId::new(number))
    }

    /// The place among these values that is nearest to another.
    pub(super) fn nearest(&self, place: &[f64]) -> Vec<f64> {
        let all = place.iter().zip(&self.all);
        all.map(|(at, range)| at.max(range.low()).min(range.high())).collect()
    }

    /// A place, and the corners of all values that are reached from there by three motors at most.
    pub(super) fn corners(&self, from: Vec<f64>) -> Vec<Vec<f64>> {
        let mut corners = vec![from];
        for &motor in self.motors.iter().take(3) {
            let range = self.all[motor];
            let moved = corners.iter().flat_map(|corner| {
                [range.low(), range.high()].map(|end| {
                    let mut moved = corner.clone();
                    moved[motor] = end;
                    moved
                })
            });
            let moved: Vec<Vec<f64>> = moved.collect();
            corners.truncate(1);
            corners.extend(moved);
        }
        corners
    }

    /// A box cut across its longest side, if that can be cut.
    pub(super) fn halves(&self, place: &[Interval]) -> Option<[Vec<Interval>; 2]> {
        let part = |motor: &usize| {
            let whole = self.all[*motor].width();
            if whole > 0.0 { place[*motor].width() / whole } else { 0.0 }
        };
        let longest = self.motors.iter().copied();
        let longest = longest.max_by(|a, b| part(a).total_cmp(&part(b)))?;
        let range = place[longest];
        let middle = range.middle();
        if part(&longest) <= NARROW || !(range.low() < middle && middle < range.high()) {
            return None;
        }
        Some([range.low(), range.high()].map(|end| {
            let mut half = place.to_vec();
            half[longest] = Interval::new(middle, end);
            half
        }))
    }
}

/// All values of the motors that a requirement is about: with the times, and whether everything comes round in them, if motors follow
/// laws.
pub(super) fn ranges(
    case: &Case<'_, '_>,
    gauge: &Gauge,
    found: &[Value],
    times: Option<(Interval, bool)>,
) -> Result<Ranges, RequirementTrouble> {
    let Case { model, compiled, verdicts, requirement, setting, .. } = *case;
    let program = setting.positions(compiled);
    let time = setting.timed().map(Timed::input);
    let Sources { inputs, tested, .. } = Sources::of(&gauge.program, found);
    let made_from = [found, &gauge.differentiated].concat();
    let made_from = Sources::of(&gauge.program, &made_from);
    if let Some(block) = made_from.iterated {
        let unknowns = unknowns(&compiled.plan, program, block);
        return Err(RequirementTrouble::Iterated { unknowns });
    }
    if made_from.is_dense {
        return Err(RequirementTrouble::Together);
    }
    let given = inputs.iter().filter(|input| Some(**input) != time);
    if let Some(param) = given.into_iter().find_map(|&input| {
        let number = input.checked_sub(model.motors.len())?;
        model.params.ids().nth(number)
    }) {
        return Err(RequirementTrouble::Varies { param });
    }
    let mut ranges = Ranges {
        all: Interval::points(&program.start.motors),
        motors: inputs,
        time,
        round: Vec::new(),
        touching: None,
    };
    let loops = compiled.plan.loops().count();
    let mut open = Vec::new();
    for number in ranges.motors.clone() {
        let Some(motor) = ranges.motor(number) else {
            if let Some((times, is_round)) = times {
                ranges.all[number] = times;
                ranges.round.extend(is_round.then_some(number));
            }
            continue;
        };
        let start = program.start.motors[number];
        let mut cases = requirement.cases.iter();
        if let Some(case) = cases.find(|case| case.motor == motor) {
            let [low, high] = case.ends;
            ranges.all[number] = Interval::new(low, high);
            if [low, high] == [start; 2] {
                ranges.motors.retain(|motor| *motor != number);
            }
            continue;
        }
        if let Some(range) = model.motor(motor).range {
            // The start was allowed a rounding beyond the end.
            ranges.all[number] = Interval::new(range.low.min(start), range.high.max(start));
            continue;
        }
        let period = round_of(model, &gauge.program, (loops, number), found);
        let Some(period) = period else {
            // It may be stopped on both sides.
            let [turns, sizes] = MOST_REACH;
            let far =
                if model.turns(model.motor(motor).joint) { turns } else { sizes * model.size() };
            ranges.all[number] = Interval::new(start - far, start + far);
            open.push(number);
            continue;
        };
        ranges.all[number] = Interval::point(start) + Interval::new(-0.5 * period, 0.5 * period);
        ranges.round.push(number);
    }
    // While motors rest, nothing that they move with others is seen to move.
    if time.is_none() {
        hold_idle(&mut ranges, &tested, gauge, found);
    }
    open.retain(|motor| ranges.motors.contains(motor));
    let [motor] = ranges.motors[..] else {
        if let Some(&motor) = open.first() {
            let motor = MotorId::new(motor);
            return Err(RequirementTrouble::NoRange { motor });
        }
        // On the way there from the start loops may go over to their other side, too.
        let way = ranges.all.iter().zip(&program.start.motors);
        let way = way.map(|(range, start)| range.hull(Interval::point(*start)));
        if let Verdict::Proved { touching } = verdicts.on(&way.collect::<Vec<_>>()) {
            ranges.touching = Some(touching);
        }
        return Ok(ranges);
    };
    if ranges.motor(motor).is_none() {
        ranges.touching = touching_in_time(&ranges, verdicts, motor)?;
    } else {
        take_reach(&mut ranges, case, motor, !open.is_empty())?;
    }
    Ok(ranges)
}

/// At so many places a motor is put to each of these parts of its values, to see whether anything notices.
const TRIALS: usize = 4;
const PARTS: [f64; 3] = [0.11, 0.47, 0.83];
/// Places are spread by multiples of this.
const SPREAD: f64 = 0.618_033_988_749_894_9;

/// Lets motors stand that have no part in what is found, though it is computed from them: they only carry it along. What is the same has
/// enclosures that overlap wherever it is computed; what is not differs by more than rounding at some place. Where an operation chooses,
/// what it chooses from has to be the same, too: elsewhere it may choose otherwise. Motors that stand somewhere stay there.
fn hold_idle(ranges: &mut Ranges, tested: &[usize], gauge: &Gauge, found: &[Value]) {
    if ranges.motors.len() < 2 {
        return;
    }
    let found = &[found, &Sources::of(&gauge.program, found).chosen(&gauge.program)].concat()[..];
    let carried = gauge.angles.iter().map(|angle| {
        let at_start = gauge.program.start.state[angle.reference];
        (angle.reference, Interval::point(at_start))
    });
    let summaries = gauge.summaries.iter().flatten();
    let carried: Vec<(usize, Interval)> =
        carried.chain(summaries.map(|state| (*state, Interval::ZERO))).collect();
    let Some(mut enclosure) = Enclosure::new(&gauge.program, &[], &carried, found) else {
        return;
    };
    let mut values = |place: &[f64]| {
        enclosure.run(&Interval::points(place));
        let values = found.iter().map(|value| enclosure.on_box(*value));
        values.collect::<Vec<Interval>>()
    };
    let part = |range: Interval, part: f64| range.low() + part * range.width();
    for motor in ranges.motors.clone() {
        if tested.contains(&motor) || ranges.all[motor].width() == 0.0 {
            continue;
        }
        let is_idle = (0..TRIALS).all(|trial| {
            #[expect(clippy::cast_precision_loss, reason = "a few hundred")]
            let spread = |index: usize| (SPREAD * (1 + index + trial * 7) as f64).fract();
            let all = ranges.all.iter().enumerate();
            let mut place: Vec<f64> =
                all.map(|(index, range)| part(*range, spread(index))).collect();
            let before = values(&place);
            PARTS.iter().all(|value| {
                place[motor] = part(ranges.all[motor], *value);
                let same = |(a, b): (&Interval, &Interval)| is_same(*a, *b);
                before.iter().zip(&values(&place)).all(same)
            })
        });
        if is_idle {
            ranges.motors.retain(|other| *other != motor);
            ranges.round.retain(|other| *other != motor);
            let near = ranges.nearest(&gauge.program.start.motors);
            ranges.all[motor] = Interval::point(near[motor]);
        }
    }
}

/// Moves a motor to a value while all others stand, and tells whether it comes there.
fn arrives(program: &Program, motor: usize, end: f64) -> bool {
    let mut goal = program.start.motors.clone();
    goal[motor] = end;
    Machine::<f64>::new(program).move_to(&goal).is_ok()
}

/// The loops that may come to a dead point or change point while laws are followed, or on the way there, if that is known.
fn touching_in_time(
    ranges: &Ranges,
    verdicts: &Verdicts<'_>,
    time: usize,
) -> Result<Option<Vec<BlockId>>, RequirementTrouble> {
    let mut way = ranges.all.clone();
    way[time] = way[time].hull(Interval::ZERO);
    match verdicts.on(&way) {
        Verdict::Proved { touching } => Ok(Some(touching)),
        Verdict::Blocked(blocked) if blocked.motor == time => {
            Err(RequirementTrouble::Astray { at: blocked.limit })
        }
        Verdict::Blocked(blocked) => Err(RequirementTrouble::Astray { at: blocked.at[time] }),
        Verdict::Undecided { .. } | Verdict::NoClosedForm { .. } => Ok(None),
    }
}

/// Narrows the values of the only motor that has a part to those that it can reach from the start. It may have to be stopped on both
/// sides.
fn take_reach(
    ranges: &mut Ranges,
    case: &Case<'_, '_>,
    motor: usize,
    must_stop: bool,
) -> Result<(), RequirementTrouble> {
    let (verdicts, requirement) = (case.verdicts, case.requirement);
    let program = &case.compiled.program;
    let start = program.start.motors[motor];
    let wanted = ranges.all[motor];
    let mut ends = [wanted.low(), wanted.high()];
    let mut touching = Some(Vec::new());
    for end in &mut ends {
        let mut way = ranges.all.clone();
        way[motor] = Interval::new(start, *end);
        match verdicts.on(&way) {
            Verdict::Proved { touching: own } if !must_stop => {
                if let Some(all) = &mut touching {
                    all.extend(&own);
                }
            }
            // What other motors have a part in may go farther where they stand elsewhere.
            // Loops that went over to another side may close where others of their sides do not.
            Verdict::Blocked(blocked)
                if blocked.motors == [motor] && !arrives(program, motor, *end) =>
            {
                let mut cases = requirement.cases.iter();
                let case = cases.find(|case| case.motor.index() == motor);
                if let Some(case) = case {
                    return Err(RequirementTrouble::Unreachable {
                        motor: case.motor,
                        limit: blocked.limit,
                        origin: case.origin,
                    });
                }
                *end = blocked.limit;
                touching = None;
                ranges.round.clear();
            }
            _ if must_stop => {
                let motor = MotorId::new(motor);
                return Err(RequirementTrouble::NoRange { motor });
            }
            _ => touching = None,
        }
    }
    ranges.touching = touching;
    ranges.all[motor] = Interval::new(ends[0], ends[1]);
    Ok(())
}
