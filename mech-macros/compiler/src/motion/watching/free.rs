//! Which loops never come near a dead point or change point, whatever the motors do: proved one by one.

use super::domain::Domain;
use super::influence::Motors;
use super::{Free, LoopProof};
use crate::bug::bug;
use crate::certify::Interval;
use crate::certify::always::{Question, always_closes};
use crate::certify::carried::Trial;
use crate::certify::cone::{Cone, Cuts, Variable};
use crate::plan::Solution;
use crate::program::{BlockId, ClosedForm, Dyad, Value};
use std::f64::consts::{PI, TAU};

/// The numbers of intervals that may be computed for a loop by itself, for one together with those before it, and for all loops.
const ALONE: usize = 60_000;
const TOGETHER: usize = 240_000;
const ALL: usize = 1_500_000;
/// So many more for each loop.
const EACH: usize = 12_000;

/// Looks at all loops in closed form, in their order: later ones are made from what earlier ones find.
///
/// Of each loop, `motors` has those that have a part in whether it closes.
pub(super) fn prove(domain: &mut Domain<'_>, motors: &[Motors]) {
    let mut left = ALL + EACH * domain.known.len();
    let program = domain.cutter.program;
    for (block, closed) in program.closed_forms() {
        if domain.varying.contains(&closed.number) {
            continue;
        }
        let free = prove_free(domain, block, closed, &motors[closed.number], &mut left);
        domain.known[closed.number] = LoopProof { free };
    }
}

/// Proves that a loop is free; none if that fails.
fn prove_free(
    domain: &Domain<'_>,
    block: BlockId,
    closed: &ClosedForm,
    motors: &Motors,
    left: &mut usize,
) -> Option<Free> {
    let asked = LoopQuery::new(domain, block, closed);
    let alone = Cuts { own: Some(closed.number), ..Cuts::ALONE };
    let cone = domain.cutter.cone(&asked.outputs, &alone)?;
    let ranges: Vec<Interval> =
        cone.variables.iter().map(|variable| domain.of_variable(*variable)).collect();
    let carriers = asked.carriers(domain, &cone);
    let held = carriers.iter().fold(ranges.clone(), |mut held, carrier| {
        held[carrier.variable] = Interval::point(carrier.start);
        held
    });
    let found = asked.answer(&cone, &held, (ALONE, left));
    let found = found.map(|free| turned_along(free, &carriers, &ranges));
    if found.is_some() || !hangs_together(domain, &cone, &carriers) {
        return found;
    }
    let together = Cuts {
        through: &|number| domain.known[number].free.is_some(),
        own: Some(closed.number),
        into: &|angle| domain.cutter.parts(angle).is_some(),
    };
    let cone = domain.cutter.cone(&asked.outputs, &together)?;
    let mut ranges = domain.of_inputs(&cone.variables, &asked.outputs, &together);
    let is_carried = hold_carriers(domain, &cone, motors, &mut ranges);
    let mut found = asked.answer(&cone, &ranges, (TOGETHER, left))?;
    if is_carried {
        asked.turn_anywhere(&mut found);
    }
    Some(found)
}

/// Holds the motors at the start that only carry the loop as a whole; returns whether there are any.
fn hold_carriers(
    domain: &Domain<'_>,
    cone: &Cone,
    motors: &Motors,
    ranges: &mut [Interval],
) -> bool {
    let Some(motors) = motors else {
        return false;
    };
    let mut is_carried = false;
    for (variable, range) in cone.variables.iter().zip(ranges) {
        if let Variable::Input(input) = variable
            && !motors.contains(input)
        {
            *range = Interval::point(domain.start(*input));
            is_carried = true;
        }
    }
    is_carried
}

/// A direction that carries a loop as a whole: whether it closes is the same in all of them.
struct Carrier {
    /// Its number in the cone.
    variable: usize,
    /// Its angle at the start.
    start: f64,
    /// For each unknown whether it turns along.
    along: Vec<bool>,
}

/// The ranges of what a loop finds, where its carriers may stand anywhere. Known is what it finds where they stand as at the start.
fn turned_along(mut free: Free, carriers: &[Carrier], ranges: &[Interval]) -> Free {
    for carrier in carriers {
        let turn = ranges[carrier.variable] - Interval::point(carrier.start);
        let unknowns = free.ranges.iter_mut().zip(&carrier.along);
        for (range, _) in unknowns.filter(|(_, along)| **along) {
            *range = range.map(|range| all_if_wide(range + turn));
        }
    }
    free
}

/// A range of angles, or all angles if the range is a whole turn.
fn all_if_wide(range: Interval) -> Interval {
    if range.width() < TAU { range } else { Interval::new(-PI.next_up(), PI.next_up()) }
}

/// Whether variables of a loop may depend on each other. Then a proof by itself, which takes them for independent, may be too weak.
fn hangs_together(domain: &Domain<'_>, cone: &Cone, carriers: &[Carrier]) -> bool {
    let is_free = |number: usize| domain.known[number].free.is_some();
    let found =
        |variable: &Variable| matches!(variable, Variable::Found(number, _) if is_free(*number));
    let has_part = |index: &usize| carriers.iter().all(|carrier| carrier.variable != *index);
    let with_part = (0..cone.variables.len()).filter(has_part);
    let with_part: Vec<Variable> = with_part.map(|index| cone.variables[index]).collect();
    let mut inputs = Vec::new();
    for variable in &with_part {
        match *variable {
            Variable::Angle(angle) => {
                inputs.extend(
                    domain.cutter.parts(angle).into_iter().flatten().map(|(input, _)| input),
                );
            }
            Variable::Input(input) => inputs.push(input),
            Variable::Found(..) => {}
        }
    }
    let count = inputs.len();
    inputs.sort_unstable();
    inputs.dedup();
    inputs.len() < count || with_part.iter().any(found)
}

/// The values of a loop that are asked for.
struct LoopQuery<'c> {
    block: BlockId,
    closed: &'c ClosedForm,
    /// Discriminant, floor, sine; the coordinates of its vectors; what it finds.
    outputs: Vec<Value>,
    /// Each of its unknowns, and what it is at the start, if it is a direction.
    unknowns: Vec<(Solution<Value>, f64)>,
}

impl<'c> LoopQuery<'c> {
    fn new(domain: &Domain<'_>, block: BlockId, closed: &'c ClosedForm) -> Self {
        let solutions = (0..2).filter_map(|index| domain.solution(closed.number, index));
        let unknowns: Vec<(Solution<Value>, f64)> =
            solutions.map(|solution| (solution, domain.angle_at_start(&solution))).collect();
        let mut outputs = vec![closed.discriminant, closed.tolerance, closed.sine];
        outputs.extend(closed.dyad.vectors().into_iter().flatten());
        for (solution, _) in &unknowns {
            match *solution {
                Solution::Direction(direction) => outputs.extend(direction),
                Solution::Slide(displacement) => outputs.push(displacement),
            }
        }
        Self { block, closed, outputs, unknowns }
    }

    /// The directions among the variables of a cone that carry the loop.
    fn carriers(&self, domain: &Domain<'_>, cone: &Cone) -> Vec<Carrier> {
        let output = |value: Value| cone.outputs[self.place(value)];
        let vector = |vector: [Value; 2]| vector.map(output);
        let mut numbers = vec![cone.outputs[0], cone.outputs[1], cone.outputs[2]];
        let mut vectors = Vec::new();
        for (solution, _) in &self.unknowns {
            match *solution {
                Solution::Direction(direction) => vectors.push(vector(direction)),
                Solution::Slide(displacement) => numbers.push(output(displacement)),
            }
        }
        let directions = vectors.len();
        vectors.extend(self.closed.dyad.vectors().into_iter().map(vector));
        let Some(mut trial) = Trial::new(cone, &numbers, &vectors) else {
            return Vec::new();
        };
        let carrier = |(variable, what): (usize, &Variable)| {
            let start = domain.angle_of(*what)?;
            let turned = trial.turned_along(variable)?;
            let mut turned = turned.into_iter().take(directions);
            let along = self.unknowns.iter().map(|(solution, _)| match solution {
                Solution::Direction(_) => {
                    turned.next().unwrap_or_else(|| bug!("a direction of a loop is not looked at"))
                }
                Solution::Slide(_) => false,
            });
            Some(Carrier { variable, start, along: along.collect() })
        };
        cone.variables.iter().enumerate().filter_map(carrier).collect()
    }

    /// Where a value of the program is among the outputs of a cone.
    fn place(&self, value: Value) -> usize {
        let mut outputs = self.outputs.iter();
        let Some(place) = outputs.position(|output| *output == value) else {
            bug!("a value of a loop is not among its outputs");
        };
        place
    }

    /// Forgets the directions of a loop that is carried about.
    fn turn_anywhere(&self, free: &mut Free) {
        for (range, (solution, _)) in free.ranges.iter_mut().zip(&self.unknowns) {
            if matches!(solution, Solution::Direction(_)) {
                *range = None;
            }
        }
    }

    fn answer(
        &self,
        cone: &Cone,
        ranges: &[Interval],
        (most, left): (usize, &mut usize),
    ) -> Option<Free> {
        let question = Question {
            block: self.block,
            discriminant: cone.outputs[0],
            tolerance: cone.outputs[1],
            found: cone.outputs.clone(),
        };
        let mut free = Free {
            least_sine: f64::INFINITY,
            ranges: vec![None; self.unknowns.len()],
            least_distance_square: f64::INFINITY,
        };
        let mut budget = most.min(*left);
        let before = budget;
        let closes = always_closes(cone, &question, ranges, &mut budget, |value| {
            let at = |of: Value| value(cone.outputs[self.place(of)]);
            free.least_sine = free.least_sine.min(at(self.closed.sine).abs().low());
            if let Dyad::TwoCircles { goal, arms } = self.closed.dyad {
                let square = |[x, y]: [Value; 2]| at(x).square() + at(y).square();
                let [a, b] = arms.map(|arm| square(arm).sqrt().high());
                let least = square(goal).low() / (a * b);
                free.least_distance_square = free.least_distance_square.min(least);
            }
            for (range, (solution, start)) in free.ranges.iter_mut().zip(&self.unknowns) {
                let found = match *solution {
                    Solution::Direction([cos, sin]) => angle([at(cos), at(sin)], *start),
                    Solution::Slide(displacement) => at(displacement),
                };
                *range = Some(range.map_or(found, |range| range.hull(found)));
            }
        });
        *left -= before - budget;
        closes.then_some(free)
    }
}

/// The angles of directions, as near those of another as may be.
fn angle([cos, sin]: [Interval; 2], start: f64) -> Interval {
    let (c, s) = (Interval::point(start.cos()), Interval::point(start.sin()));
    let (along, across) = (cos * c + sin * s, sin * c - cos * s);
    let beyond = across.atan2(along);
    if beyond.width() >= PI {
        // Anything at all.
        return Interval::new(-PI.next_up(), PI.next_up());
    }
    Interval::point(start) + beyond
}
