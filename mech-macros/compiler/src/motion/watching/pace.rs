//! Bounds on rates with the motors: by intervals, loop after loop.
//!
//! An unknown of a loop moves by no more than its goal, over the length of an arm and the sine of the loop. That sine has a lower bound
//! where the loop is free. Where the loop is watched, the bound grows without end near its zero, and says so.
//!
//! Through several loops such bounds become far wider than any motion: a product of the worst of each. A bound that is too wide is
//! cut down to a guess and says that, too: then a move goes no piece in which a sine is seen to change much.

use super::boxes::boxes;
use super::domain::Domain;
use super::most::{MOST, MOST_DIRECT, MOST_OF_ANGLE, MOST_OF_SINE, MOST_SHARP, tame};
use crate::certify::Interval;
use crate::certify::cone::{Cone, Cuts, Variable};
use crate::certify::slope::Slopes;
use crate::plan::Solution;
use crate::program::{Bound, ClosedForm, Dyad, Growth, Value};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A cone is looked at on so many boxes at most; the second number is for all cones together.
const MOST_BOXES: usize = 256;
const BOXES_OF_ALL: usize = 16_384;
/// An arm is taken to be no shorter than this part of its greatest length: where it is, the bound is lost anyway.
const SHORT: f64 = 0.01;
/// Loops that are solved by iteration are taken to turn no faster than so many times what drives them: only their steps are bounded.
const ITERATED: f64 = 16.0;
/// Finds bounds, each once.
pub(super) struct Paces<'d> {
    pub(super) domain: &'d Domain<'d>,
    loops: BTreeMap<usize, Goal>,
    values: BTreeMap<Value, Bound>,
    /// On how many boxes each cone may be looked at.
    boxes: usize,
    /// For each input the fastest that turns with it.
    pub(super) fastest: Vec<f64>,
}

/// The goal of a loop: the vector that its unknowns reach together.
#[derive(Clone, Debug)]
struct Goal {
    /// The rate at which it moves, arms and lines taken with it.
    moves: Bound,
    /// The rate at which the lines turn, if they do.
    turns: Bound,
    /// The greatest distance of the goal, and the causes that take it farther.
    reach: f64,
    far: Vec<Growth>,
    /// The lengths of the arms, at least and at most.
    arms: Vec<[f64; 2]>,
    /// Whether it is moved by motors and params alone.
    direct: bool,
    /// The greatest rate, with each input, of the motors and gears that turn the loop as a whole.
    driven: Vec<f64>,
}

/// The rates of a cone of vectors, over all its boxes: of goal, arms and lines with each variable.
#[derive(Clone, Debug, Default)]
struct ConeRates {
    goal: Vec<f64>,
    arms: Vec<f64>,
    lines: Vec<f64>,
    reach: f64,
    lengths: Vec<[f64; 2]>,
}

impl<'d> Paces<'d> {
    pub(super) fn new(domain: &'d Domain<'d>) -> Self {
        let mut paces = Self {
            domain,
            loops: BTreeMap::new(),
            values: BTreeMap::new(),
            boxes: (BOXES_OF_ALL / domain.known.len().max(1)).clamp(8, MOST_BOXES),
            fastest: Vec::new(),
        };
        paces.fastest = paces.fastest();
        paces
    }

    /// Looks at all loops in their order, so that each finds what it needs of earlier ones.
    pub(super) fn look_at_all(&mut self) {
        for (_, closed) in self.domain.cutter.program.closed_forms() {
            self.goal(closed.number);
        }
    }

    pub(super) fn inputs(&self) -> usize {
        self.domain.model.inputs()
    }

    /// Bounds the rate of the square of a loop's sine.
    pub(super) fn of_sine(&mut self, closed: &ClosedForm) -> Bound {
        let goal = self.goal(closed.number).clone();
        let mut bound = Bound::still(self.inputs());
        match &closed.dyad {
            Dyad::TwoCircles { .. } => {
                let [[a, long], [b, other]] = pair(&goal.arms);
                bound.add(2.0 * (long + other) / (a * b), &goal.moves);
            }
            Dyad::CircleAndLine { .. } => {
                let [[radius, _], _] = pair(&goal.arms);
                bound.add(2.0 / radius, &goal.moves);
            }
            // The greatest slope of x² / (1 + x²) is 0.65; where the line passes beside the pin, the height adds to that.
            Dyad::TurningLine { .. } => {
                let [[_, height], _] = pair(&goal.arms);
                bound.add((0.65 + 4.0 * height / closed.size) / closed.size, &goal.moves);
            }
            Dyad::TwoLines { .. } => bound.add(1.0, &goal.turns),
        }
        self.with_params(&mut bound, closed.number);
        let most = if goal.direct { MOST_DIRECT } else { MOST_OF_SINE };
        tame(&mut bound, most, &goal.driven);
        self.sharpen(&mut bound, 1.0 / MOST_SHARP);
        bound
    }

    /// A large displacement of an input: a radian if it turns, its scale if it is a param, else the size of the mechanism.
    pub(super) fn unit(&self, input: usize) -> f64 {
        let model = self.domain.model;
        let size = model.size().max(f64::MIN_POSITIVE);
        if self.domain.turns(input) {
            return 1.0;
        }
        let param = input.checked_sub(model.motors.len());
        let scale = param.and_then(|param| model.param_scale(model.params.ids().nth(param)?));
        scale.unwrap_or(size)
    }

    fn goal(&mut self, number: usize) -> &Goal {
        if !self.loops.contains_key(&number) {
            let goal = self.found_goal(number);
            self.loops.insert(number, goal);
        }
        &self.loops[&number]
    }

    fn closed_form(&self, number: usize) -> Option<&'d ClosedForm> {
        let mut all = self.domain.cutter.program.closed_forms();
        all.find(|(_, closed)| closed.number == number).map(|(_, closed)| closed)
    }

    fn found_goal(&mut self, number: usize) -> Goal {
        let inputs = self.inputs();
        let Some(closed) = self.closed_form(number) else {
            return Goal {
                moves: Bound::still(inputs),
                turns: Bound::still(inputs),
                reach: 0.0,
                far: Vec::new(),
                arms: Vec::new(),
                direct: false,
                driven: self.fastest.clone(),
            };
        };
        let vectors = closed.dyad.vectors();
        let mut outputs = vec![closed.discriminant, closed.tolerance];
        outputs.extend(vectors.iter().flatten());
        let Some(cone) = self.domain.cutter.cone(&outputs, &Cuts::ALONE) else {
            return self.unknown_goal(closed);
        };
        let (ranges, far) = self.ranges(&cone);
        let swept = self.bound_rates(&cone, &ranges, &closed.dyad);
        let two_lines = matches!(closed.dyad, Dyad::TwoLines { .. });
        let mut goal = Goal {
            moves: Bound::still(inputs),
            turns: Bound::still(inputs),
            reach: swept.reach,
            far,
            arms: swept.lengths.clone(),
            direct: cone.variables.iter().all(|variable| self.is_direct(*variable)),
            driven: self.fastest.clone(),
        };
        let turning = swept.lines.iter().any(|turned| *turned > 0.0);
        let grows = !goal.far.is_empty() && (turning || !self.is_steady(&cone));
        let farther = if grows { 2.0 } else { 1.0 };
        for (variable, of) in cone.variables.iter().enumerate() {
            let bound = self.of_variable(*of);
            if let Variable::Angle(_) = of {
                for (driven, rate) in goal.driven.iter_mut().zip(&bound.rates) {
                    *driven = driven.max(*rate);
                }
            }
            let [moved, arms, turned] =
                [&swept.goal, &swept.arms, &swept.lines].map(|all| all[variable]);
            goal.turns.add(turned, &bound);
            let swung = if turned > 0.0 { swept.reach * turned } else { 0.0 };
            goal.moves.add(farther * (moved + 3.0 * arms + swung), &bound);
        }
        if goal.direct && goal.far.is_empty() {
            self.move_together(&mut goal, (&cone, closed));
        }
        let far = goal.far.clone();
        if grows && goal.moves.rates.iter().any(|rate| *rate > 0.0) {
            goal.moves.grow_like(&far);
        }
        if two_lines {
            goal.arms.clear();
        }
        goal
    }

    /// The goal of a loop of which nothing is known but its arms at the start: too much is before it.
    fn unknown_goal(&self, closed: &ClosedForm) -> Goal {
        let at_start = |value: Value| self.domain.cutter.at_start[value.index()];
        let length = |[x, y]: [Value; 2]| at_start(x).hypot(at_start(y)).max(f64::MIN_POSITIVE);
        let vectors = closed.dyad.vectors().into_iter().enumerate();
        let arms = vectors.filter(|(number, _)| is_arm(&closed.dyad, *number));
        Goal {
            moves: self.unbounded(),
            turns: self.unbounded(),
            reach: 4.0 * self.domain.model.size().max(f64::MIN_POSITIVE),
            far: Vec::new(),
            arms: arms.map(|(_, vector)| [length(vector); 2]).collect(),
            direct: false,
            driven: self.fastest.clone(),
        }
    }

    /// The bound of something that may be as fast as it likes.
    pub(super) fn unbounded(&self) -> Bound {
        let mut bound = Bound::still(self.inputs());
        bound.rates.fill(f64::INFINITY);
        bound
    }

    /// Lessens the rates of a goal that several angles of the same inputs move. Taken one by one, each of these angles could be at its
    /// worst.
    fn move_together(&self, goal: &mut Goal, (alone, closed): (&Cone, &ClosedForm)) {
        let angles = alone.variables.iter();
        let angles = angles.filter(|variable| matches!(variable, Variable::Angle(_)));
        if angles.count() < 2 {
            return;
        }
        let mut outputs = vec![closed.discriminant, closed.tolerance];
        outputs.extend(closed.dyad.vectors().iter().flatten());
        let cuts = Cuts {
            own: Some(closed.number),
            into: &|angle| self.domain.parts(angle).is_some(),
            ..Cuts::ALONE
        };
        let Some(cone) = self.domain.cutter.cone(&outputs, &cuts) else {
            return;
        };
        let ranges = self.domain.of_inputs(&cone.variables, &outputs, &cuts);
        if !ranges.iter().all(|range| range.is_bounded()) {
            return;
        }
        let swept = self.bound_rates(&cone, &ranges, &closed.dyad);
        let mut moves = Bound::still(self.inputs());
        for (variable, of) in cone.variables.iter().enumerate() {
            let Variable::Input(input) = *of else { return };
            let [moved, arms, turned] =
                [&swept.goal, &swept.arms, &swept.lines].map(|all| all[variable]);
            let swung = if turned > 0.0 { swept.reach * turned } else { 0.0 };
            moves.rates[input] += moved + 3.0 * arms + swung;
        }
        goal.reach = goal.reach.min(swept.reach);
        for (rate, together) in goal.moves.rates.iter_mut().zip(moves.rates) {
            *rate = rate.min(together);
        }
    }

    /// Whether a variable is a motor or param, or in a constant ratio to some.
    fn is_direct(&self, variable: Variable) -> bool {
        match variable {
            Variable::Input(_) => true,
            Variable::Angle(angle) => self.domain.cutter.parts(angle).is_some(),
            Variable::Found(..) => false,
        }
    }

    /// Whether the outputs of a cone change no faster than some rate, however far its variables go.
    fn is_steady(&self, cone: &Cone) -> bool {
        let whole: Vec<Interval> =
            cone.variables.iter().map(|variable| self.domain.of_variable(*variable)).collect();
        let mut slopes = Slopes::new(cone);
        slopes.run(&whole);
        let vectors = if cone.outputs.len() > 2 { &cone.outputs[2..] } else { &cone.outputs };
        let bounded = |value: &Value| {
            (0..whole.len()).all(|variable| slopes.slope(*value, variable).is_bounded())
        };
        vectors.iter().all(bounded)
    }

    /// The ranges of a cone's variables in which it is looked at, and the causes that take variables beyond them.
    fn ranges(&self, cone: &Cone) -> (Vec<Interval>, Vec<Growth>) {
        let whole: Vec<Interval> =
            cone.variables.iter().map(|variable| self.domain.of_variable(*variable)).collect();
        let mut growth = Vec::new();
        let mut ranges = whole.clone();
        for (index, variable) in cone.variables.iter().enumerate() {
            if whole[index].is_bounded() {
                continue;
            }
            let (unit, far) = self.far(*variable);
            ranges[index] = Interval::new(-unit, unit);
            if !closes_nowhere_beyond(cone, &whole, (index, unit)) {
                growth.extend(far);
            }
        }
        (ranges, growth)
    }

    /// Returns the bound within which a variable without ends is looked at, and the causes that take it beyond.
    fn far(&self, variable: Variable) -> (f64, Vec<Growth>) {
        let size = self.domain.model.size().max(f64::MIN_POSITIVE);
        match variable {
            Variable::Input(input) => {
                let unit = if self.domain.turns(input) { TAU } else { 2.0 * size };
                (unit, vec![Growth::FarOut(input, unit)])
            }
            Variable::Found(number, index) => match self.loops.get(&number) {
                Some(goal) => {
                    let start = match self.domain.solution(number, index) {
                        Some(Solution::Slide(displacement)) => {
                            self.domain.cutter.at_start[displacement.index()].abs()
                        }
                        _ => 0.0,
                    };
                    let near = self.closed_form(number).filter(|closed| {
                        matches!(closed.dyad, Dyad::TwoLines { .. })
                            && self.domain.known[number].free.is_none()
                    });
                    let arms: f64 = goal.arms.iter().map(|[_, most]| most).sum();
                    let mut far = goal.far.clone();
                    far.extend(near.map(|_| Growth::NearZero(number)));
                    ((goal.reach + arms).max(size).max(2.0 * start), far)
                }
                None => (4.0 * size, Vec::new()),
            },
            Variable::Angle(_) => (TAU, Vec::new()),
        }
    }

    /// Bounds the rate of a variable.
    fn of_variable(&mut self, variable: Variable) -> Bound {
        match variable {
            Variable::Input(input) => Bound::of_input(input, self.inputs()),
            Variable::Angle(angle) => self.of_value(angle),
            Variable::Found(number, index) => self.of_found(number, index),
        }
    }

    /// Bounds the rate of an unknown that a loop finds.
    fn of_found(&mut self, number: usize, index: usize) -> Bound {
        let inputs = self.inputs();
        let mut bound = Bound::still(inputs);
        let direction = matches!(self.domain.solution(number, index), Some(Solution::Direction(_)));
        let Some(closed) = self.closed_form(number) else {
            let size = self.domain.model.size();
            let unit = if direction { ITERATED } else { ITERATED * size };
            bound.guessed = true;
            for input in 0..inputs {
                let one = Bound::of_input(input, inputs);
                bound.add(unit / self.unit(input), &one);
            }
            return bound;
        };
        let goal = self.goal(number).clone();
        let lever = match (&closed.dyad, direction) {
            (Dyad::TwoCircles { .. }, _) => 1.0 / goal.arms[index][0],
            (Dyad::CircleAndLine { .. }, true) => 1.0 / pair(&goal.arms)[0][0],
            (Dyad::TurningLine { .. }, true) => 1.0 / closed.size,
            (Dyad::TurningLine { .. }, false) => 1.0 + pair(&goal.arms)[0][1] / closed.size,
            (Dyad::CircleAndLine { .. } | Dyad::TwoLines { .. }, _) => 1.0,
        };
        let two_lines = matches!(closed.dyad, Dyad::TwoLines { .. });
        bound.add(lever, &goal.moves);
        if bound.rates.iter().any(|rate| *rate > 0.0) {
            // Of two lines, what turns them moves their ways the more, the farther these are.
            let times = if two_lines { 2 } else { 1 };
            let growth = std::iter::repeat_n(Growth::NearZero(number), times);
            bound.growth.extend(growth);
        }
        tame(&mut bound, MOST, &goal.driven);
        bound
    }

    /// Bounds the rate of an angle.
    pub(super) fn of_angle(&mut self, angle: Value) -> Bound {
        let mut bound = self.of_value(angle);
        self.sharpen(&mut bound, 0.0);
        bound
    }

    /// Bounds the rate of a value: of an angle, or of an operand of a law or a gear.
    fn of_value(&mut self, value: Value) -> Bound {
        if let Some(known) = self.values.get(&value) {
            return known.clone();
        }
        let Some(cone) = self.domain.cutter.cone(&[value], &Cuts::ALONE) else {
            let mut bound = self.unbounded();
            tame(&mut bound, MOST_DIRECT, &self.fastest);
            self.values.insert(value, bound.clone());
            return bound;
        };
        let (ranges, far) = self.ranges(&cone);
        let mut slopes = Slopes::new(&cone);
        let mut most = vec![0.0_f64; cone.variables.len()];
        for place in boxes(&ranges, self.boxes) {
            slopes.run(&place);
            for (variable, most) in most.iter_mut().enumerate() {
                *most = most.max(slopes.slope(cone.outputs[0], variable).abs().high());
            }
        }
        let mut bound = Bound::still(self.inputs());
        for (variable, most) in cone.variables.iter().zip(most) {
            let of = self.of_variable(*variable);
            bound.add(most, &of);
        }
        // A sum of constant parts has the same rate everywhere.
        if self.domain.cutter.parts(value).is_none() {
            if !self.is_steady(&cone) {
                bound.grow_like(&far);
            }
            let most = if bound.rates.iter().all(|rate| rate.is_finite()) {
                MOST_OF_ANGLE
            } else {
                MOST_DIRECT
            };
            tame(&mut bound, most, &self.fastest);
        }
        self.values.insert(value, bound.clone());
        bound
    }

    /// Looks at vectors on boxes of their variables, wherever the loop may close.
    fn bound_rates(&self, cone: &Cone, ranges: &[Interval], dyad: &Dyad<Value>) -> ConeRates {
        let [discriminant, tolerance] = [cone.outputs[0], cone.outputs[1]];
        let vectors: Vec<&[Value]> = cone.outputs[2..].chunks(2).collect();
        let count = cone.variables.len();
        let mut swept = ConeRates {
            goal: vec![0.0; count],
            arms: vec![0.0; count],
            lines: vec![0.0; count],
            ..ConeRates::default()
        };
        let is_arm = |vector: usize| is_arm(dyad, vector);
        swept.lengths =
            vec![[f64::INFINITY, 0.0]; (1..vectors.len()).filter(|&v| is_arm(v)).count()];
        let mut slopes = Slopes::new(cone);
        let mut closes = false;
        for place in boxes(ranges, self.boxes) {
            slopes.run(&place);
            if slopes.value(discriminant).high() < -slopes.value(tolerance).abs().high() {
                continue;
            }
            closes = true;
            let length = |parts: [Interval; 2]| (parts[0].square() + parts[1].square()).sqrt();
            let mut arm = 0;
            for (number, vector) in vectors.iter().enumerate() {
                let [x, y] = [vector[0], vector[1]];
                let own = length([slopes.value(x), slopes.value(y)]);
                if number == 0 {
                    swept.reach = swept.reach.max(own.high());
                } else if is_arm(number) {
                    swept.lengths[arm][0] = swept.lengths[arm][0].min(own.low());
                    swept.lengths[arm][1] = swept.lengths[arm][1].max(own.high());
                    arm += 1;
                }
                for variable in 0..count {
                    let moved =
                        length([slopes.slope(x, variable), slopes.slope(y, variable)]).high();
                    let of = if number == 0 {
                        &mut swept.goal
                    } else if is_arm(number) {
                        &mut swept.arms
                    } else {
                        &mut swept.lines
                    };
                    of[variable] = of[variable].max(moved);
                }
            }
        }
        if !closes {
            // It does where it was not looked: nothing is known.
            swept.goal.fill(f64::INFINITY);
        }
        for [least, most] in &mut swept.lengths {
            *least = least.max(SHORT * *most).max(f64::MIN_POSITIVE);
        }
        swept.reach += swept.lengths.iter().map(|[_, most]| most).sum::<f64>();
        swept
    }
}

/// Whether a vector of a dyad, by its number, is an arm: the first is the goal, and some are lines.
fn is_arm(dyad: &Dyad<Value>, vector: usize) -> bool {
    let lines: &[usize] = match dyad {
        Dyad::TwoCircles { .. } => &[],
        Dyad::CircleAndLine { .. } | Dyad::TurningLine { .. } => &[2],
        Dyad::TwoLines { .. } => &[1, 2],
    };
    vector > 0 && !lines.contains(&vector)
}

/// The lengths of two arms, or of one.
fn pair(arms: &[[f64; 2]]) -> [[f64; 2]; 2] {
    // Where there is no arm, its length is of no matter.
    let arm = |index: usize| arms.get(index).copied().unwrap_or([1.0, 1.0]);
    [arm(0), arm(1)]
}

/// Whether a loop closes nowhere if one variable is beyond this number, wherever the other variables are.
fn closes_nowhere_beyond(cone: &Cone, whole: &[Interval], (index, unit): (usize, f64)) -> bool {
    if cone.outputs.len() < 2 {
        return false;
    }
    let [discriminant, tolerance] = [cone.outputs[0], cone.outputs[1]];
    let mut slopes = Slopes::new(cone);
    [f64::INFINITY, f64::NEG_INFINITY].iter().all(|&end| {
        let mut place = whole.to_vec();
        place[index] = Interval::new(unit.copysign(end), end);
        slopes.run(&place);
        slopes.value(discriminant).high() < -slopes.value(tolerance).abs().high()
    })
}
