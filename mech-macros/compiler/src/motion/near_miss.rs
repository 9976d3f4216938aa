//! Loops that come near a change point and do not reach it: lengths that were to match, and were rounded when they were written down.
//!
//! The pins of a dyad lie in one line at a change point. What is left of that line is a difference of squares that is smooth in the
//! motors: the distance of the two outer pins from the sum of the arms, or from their difference. Where it has a least value that is
//! small but not zero, the loop passes beside a change point, or stops before it.

use super::sweep::{MostTurns, sweep_each};
use super::walk::{Arrival, Walker, price};
use crate::bug::bug;
use crate::evaluate::Machine;
use crate::model::{Model, MotorId};
use crate::plan::Plan;
use crate::program::{AtZero, ClosedForm, Dyad, Position, Program, Value, computing};

/// A loop is near a change point if it misses that by less than this part of its size. Two decimals may hide as much of a link that is
/// ten units long.
const NEAR: f64 = 5e-4;
/// A least value that parabolas foretell is looked for if it may be as small as this.
const FORETOLD: f64 = 0.02;
/// Samples in a turn.
const SAMPLES: u32 = 20;
/// Turns of the fastest link that are looked at.
const TURNS: i64 = 4;
/// The operations that all of it may take, and for each motor the least and the greatest number of positions. Moves to these positions
/// may take as much again where loops pass change points.
const BUDGET: usize = 100_000;
const POSITIONS: [usize; 2] = [64, 192];
/// A loop that misses its change point by no more than so many roundings meets it.
const ROUNDINGS: f64 = 1024.0;
/// If this difference of squares is smaller for an earlier loop, that loop is near its own change point. Later loops then move so fast
/// that nothing is told of them.
const SHARP: f64 = 1e-3;
/// Rounds in which a least value is sought.
const ROUNDS: usize = 16;
/// The least value is found when the search moves by less than this part of the distance between samples.
const FOUND: f64 = 1e-8;
/// A step inwards from an end of a bracket: as much as keeps the longer part in proportion.
const GOLDEN: f64 = 0.381_966;

/// A place where a loop comes near a change point.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NearMiss {
    /// The number of the loop in the plan.
    pub number: usize,
    /// The joints of the loop whose coordinates are unknown.
    pub place: String,
    /// The motor that takes the loop there. All other motors are at the start.
    pub motor: MotorId,
    /// Its value.
    pub at: f64,
    /// By how much the outer pins are off, as a part of the loop's size: of the sum of the lengths of its goal and arms.
    pub distance: f64,
    /// Whether the loop passes that place. If not, it does not close there.
    pub passes: bool,
}

/// The places where loops come near change points as motors move alone: for each loop and motor the nearest.
pub(crate) fn near_misses(model: &Model, plan: &Plan, program: &Program) -> Vec<NearMiss> {
    let loops: Vec<Flatness> =
        program.closed_forms().filter_map(|(_, closed)| Flatness::new(program, closed)).collect();
    if loops.is_empty() {
        return Vec::new();
    }
    let mut found = Vec::new();
    let each = loops.iter();
    let wanted = each.flat_map(|one| one.numbers.iter().copied().chain([one.closed.margin]));
    let wanted: Vec<Value> = wanted.collect();
    let whole = computing(program, &wanted);
    let positions = BUDGET / price(program) / model.motors.len().max(1);
    let positions = positions.clamp(POSITIONS[0], POSITIONS[1]);
    let is_last = |number: usize| loops.last().is_some_and(|one| one.closed.number == number);
    // Positions after a change point depend on how that was passed.
    let mut watches = program.watches.iter();
    let walks = !program.is_closed()
        || watches.any(|watch| watch.at_zero == AtZero::ChangeBranch && !is_last(watch.number));
    let budget = positions * model.motors.len() * price(program);
    let mut way = Way {
        loops: &loops,
        start: &program.start,
        walker: walks.then(|| Walker::new(program, budget)),
        machine: Machine::new(&whole),
        wanted,
        motor: 0,
        samples: Vec::new(),
        positions,
        left: 0,
    };
    let mut last = None;
    sweep_each(model, plan, (MostTurns::OfFastest(TURNS), model.size()), &mut |sweep| {
        let displaced = sweep.displacements.iter().position(|by| *by != 0.0);
        let Some(motor) = displaced else { return true };
        if last != Some(motor) {
            found.extend(way.finish());
            (way.motor, way.left) = (motor, way.positions);
            last = Some(motor);
        }
        way.follow(sweep.displacements[motor], sweep.turns)
    });
    found.extend(way.finish());
    found.retain(|miss: &NearMiss| {
        let range = model.motor(miss.motor).range;
        range.is_none_or(|range| range.low <= miss.at && miss.at <= range.high)
    });
    found.sort_by(|a, b| a.number.cmp(&b.number).then(a.motor.cmp(&b.motor)));
    found
}

/// A loop whose flatness is measured.
struct Flatness<'p> {
    closed: &'p ClosedForm,
    /// The numbers that tell it.
    numbers: Vec<Value>,
    /// The index in the state of the square that rounding hides of its sine, if the loop is watched.
    hidden: Option<usize>,
    /// The gap that counts as closed, as a part of the loop's size.
    rounding: f64,
}

/// The flatness of a loop in one of two ways: stretched out, or folded.
#[derive(Clone, Copy, Debug, Default)]
struct Flat {
    /// A difference of squares, as a part of the square of the loop's size: zero at a change point, negative where it is open.
    square: f64,
    /// The same difference as one of lengths instead of squares, as a part of the loop's size.
    distance: f64,
    /// The square of the sine of its transmission angle.
    sine_square: f64,
}

impl<'p> Flatness<'p> {
    fn new(program: &'p Program, closed: &'p ClosedForm) -> Option<Self> {
        if matches!(closed.dyad, Dyad::TwoLines { .. }) {
            return None;
        }
        let numbers: Vec<Value> = closed.dyad.vectors().into_iter().flatten().collect();
        let mut watches = program.watches.iter();
        let watch = watches.find(|watch| watch.number == closed.number);
        Some(Self {
            closed,
            numbers,
            hidden: watch.map(|watch| watch.rounding_square),
            rounding: ROUNDINGS * program.precision.epsilon(),
        })
    }

    /// Computes both flatnesses from these numbers.
    fn of(&self, numbers: &[f64]) -> [Flat; 2] {
        let vector = |index: usize| [numbers[2 * index], numbers[2 * index + 1]];
        let length = |[x, y]: [f64; 2]| x.hypot(y);
        let cross = |[a, b]: [f64; 2], [c, d]: [f64; 2]| a * d - b * c;
        let goal = length(vector(0));
        let size = self.closed.size;
        let flat = |longer: f64, shorter: f64, sine_square: f64| Flat {
            square: (longer - shorter) * (longer + shorter) / (size * size),
            distance: (longer - shorter) / size,
            sine_square,
        };
        match self.closed.dyad {
            Dyad::TwoCircles { .. } => {
                let [a, b] = [length(vector(1)), length(vector(2))];
                let (most, least) = (a + b, (a - b).abs());
                let area = (most - goal) * (most + goal) * (goal - least) * (goal + least);
                let sine_square = area / (4.0 * a * a * b * b);
                [flat(most, goal, sine_square), flat(goal, least, sine_square)]
            }
            Dyad::CircleAndLine { .. } => {
                let radius = length(vector(1));
                let height = cross(vector(2), vector(0)).abs();
                let sine_square = (radius - height) * (radius + height) / (radius * radius);
                [flat(radius, height, sine_square); 2]
            }
            Dyad::TurningLine { .. } | Dyad::TwoLines { .. } => {
                let height = cross(vector(2), vector(1)).abs();
                let grown = (goal - height) * (goal + height) / (size * size);
                [flat(goal, height, grown / (1.0 + grown)); 2]
            }
        }
    }

    /// Whether that is a change point but for rounding.
    fn is_exact(&self, flat: Flat, position: &Position<f64>) -> bool {
        let hidden = self.hidden.and_then(|place| position.state.get(place));
        flat.square.abs() <= self.rounding
            || hidden.is_some_and(|hidden| flat.sine_square.abs() <= *hidden)
    }
}

/// A position on the way of a motor, and how flat all loops are there, as far as that is known.
struct Sample {
    at: f64,
    position: Position<f64>,
    flats: Vec<Option<[Flat; 2]>>,
    is_open: bool,
}

/// The way of a motor that moves alone.
struct Way<'l, 'p> {
    loops: &'l [Flatness<'p>],
    start: &'l Position<f64>,
    /// Follows the motor in small moves, where positions depend on how it came there.
    walker: Option<Walker<'p>>,
    machine: Machine<'l, f64>,
    wanted: Vec<Value>,
    motor: usize,
    samples: Vec<Sample>,
    /// The number of positions that each motor may take, and the number that is left.
    positions: usize,
    left: usize,
}

impl Way<'_, '_> {
    /// Computes the flatness of all loops with the motor at this value, in one step from a position. Loops after one that does not close
    /// get none. Returns none if the budget is used up.
    fn look(&mut self, from: &Position<f64>, at: f64) -> Option<Sample> {
        self.left = self.left.checked_sub(1)?;
        self.machine.put_back(from.clone());
        let mut inputs = from.motors.clone();
        inputs[self.motor] = at;
        let numbers = self.machine.look_at(&inputs, &self.wanted);
        let mut rest = numbers.as_deref().unwrap_or_default();
        let mut is_open = numbers.is_none();
        let flats = self.loops.iter().map(|one| {
            if is_open {
                return None;
            }
            let (own, others) = rest.split_at(one.numbers.len());
            is_open = others[0] < 0.0;
            rest = &others[1..];
            Some(one.of(own))
        });
        let flats = flats.collect();
        Some(Sample { at, flats, position: self.machine.position().clone(), is_open })
    }

    /// Moves the motor from the start by this displacement, and one sample farther. Returns whether it came there.
    fn follow(&mut self, displacement: f64, turns: usize) -> bool {
        let Ok(turns) = u32::try_from(turns) else {
            bug!("a sweep of {turns} turns is looked at turn by turn");
        };
        let samples = SAMPLES * turns;
        let step = displacement / f64::from(samples);
        let from = self.start.motors[self.motor];
        let mut position = self.start.clone();
        if let Some(walker) = &mut self.walker {
            walker.begin_roughly(&position);
        }
        for number in 0..=samples + 1 {
            let mut target = self.start.motors.clone();
            target[self.motor] = from + step * f64::from(number);
            let mut is_blocked = false;
            if let Some(walker) = &mut self.walker {
                match walker.visit(&target) {
                    Arrival::There => position = walker.position().clone(),
                    Arrival::Blocked => is_blocked = true,
                    Arrival::Unpaid => return true,
                }
            }
            let Some(sample) = self.look(&position, target[self.motor]) else {
                return true;
            };
            is_blocked |= sample.is_open;
            position = sample.position.clone();
            // The start was seen on the first way.
            if number > 0 || self.samples.is_empty() {
                self.samples.push(sample);
            }
            if is_blocked {
                // One more, so that a least value just beyond the end has two neighbours.
                let beyond = self.look(&position, target[self.motor] + step);
                self.samples.extend(beyond);
                return number > samples;
            }
        }
        true
    }

    /// Returns the near misses on the way: for each loop the nearest place.
    fn finish(&mut self) -> Vec<NearMiss> {
        let mut samples = std::mem::take(&mut self.samples);
        samples.sort_by(|a, b| a.at.total_cmp(&b.at));
        let mut found: Vec<NearMiss> = Vec::new();
        for number in 0..self.loops.len() {
            let all = samples.windows(3).flat_map(|around| [0, 1].map(|way| (around, way)));
            let near = all.filter_map(|(around, way)| self.least(around, (number, way)));
            let near: Vec<NearMiss> = near.collect();
            let nearest = |a: &NearMiss, b: &NearMiss| a.distance.total_cmp(&b.distance);
            found.extend(near.into_iter().min_by(nearest));
        }
        found
    }

    /// The place near a change point between three samples, if there is one.
    fn least(&mut self, around: &[Sample], (number, way): (usize, usize)) -> Option<NearMiss> {
        let [a, b, c] = around else { return None };
        let flat = |sample: &Sample| sample.flats[number].map(|flats| flats[way]);
        let [low, middle, high] = [flat(a)?, flat(b)?, flat(c)?];
        let mut bracket = [(a.at, low), (b.at, middle), (c.at, high)];
        if middle.square > low.square || middle.square > high.square {
            return None;
        }
        let (vertex, foretold) = vertex(&bracket)?;
        if foretold.abs() > FORETOLD && middle.square.abs() > FORETOLD {
            return None;
        }
        let enough = FOUND * (c.at - a.at);
        let mut next = vertex;
        for round in 0..ROUNDS {
            let [low, middle, high] = bracket.map(|(at, _)| at);
            if (next - middle).abs() < enough {
                break;
            }
            let flat = self.look(&b.position, next)?.flats[number]?[way];
            bracket = narrowed(bracket, (next, flat));
            let [_, found, _] = bracket.map(|(at, _)| at);
            let parabola = self::vertex(&bracket).map(|(vertex, _)| vertex);
            next = match parabola {
                Some(vertex) if round % 4 != 3 && vertex != found => vertex,
                // The longer part of what is left.
                _ if high - middle > middle - low => found + GOLDEN * (bracket[2].0 - found),
                _ => found - GOLDEN * (found - bracket[0].0),
            };
        }
        let (at, flat) = bracket[1];
        let one = &self.loops[number];
        if flat.distance.abs() >= NEAR || one.is_exact(flat, &b.position) {
            return None;
        }
        let there = self.look(&b.position, at)?.flats;
        let mut before = there[..number].iter().flatten().flatten();
        let is_near = before.all(|flat| flat.square.abs() > SHARP);
        is_near.then(|| NearMiss {
            number: one.closed.number,
            place: one.closed.place.clone(),
            motor: MotorId::new(self.motor),
            at,
            distance: flat.distance.abs(),
            passes: flat.square >= 0.0,
        })
    }
}

/// Where a parabola through three places is least, and how little.
fn vertex([a, b, c]: &[(f64, Flat); 3]) -> Option<(f64, f64)> {
    let (low, high) = (a.0 - b.0, c.0 - b.0);
    let (left, right) = ((a.1.square - b.1.square) / low, (c.1.square - b.1.square) / high);
    let bend = (right - left) / (high - low);
    let slope = left - bend * low;
    let by = -slope / (2.0 * bend);
    let is_within = bend > 0.0 && by > low && by < high;
    is_within.then(|| (b.0 + by, b.1.square - 0.25 * slope * slope / bend))
}

/// Three places around the least of four.
fn narrowed(bracket: [(f64, Flat); 3], new: (f64, Flat)) -> [(f64, Flat); 3] {
    let [a, b, c] = bracket;
    let is_less = new.1.square < b.1.square;
    match (new.0 < b.0, is_less) {
        (true, true) => [a, new, b],
        (true, false) => [new, b, c],
        (false, true) => [b, new, c],
        (false, false) => [a, b, new],
    }
}
