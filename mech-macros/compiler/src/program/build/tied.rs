//! Loops in which rolling ties directions or ways: their unknowns are angles and ways, because a tie is a relation of these.

use super::Writer;
use super::closing::System;
use super::watching::Side;
use crate::model::{JointId, LinkId};
use crate::plan::{Algebra, Equation, Loop, Residuals, Solution, Tie, Unknown, float_of};
use crate::program::builder::Builder;
use crate::program::newton::Newton;
use crate::program::node::{BlockId, Op, Value};

/// What a radian of an angle that is counted from the start adds to rounding, as a part of it.
const OF_A_RADIAN: f64 = 0.125;

/// How a direction or way of the equation follows from the unknowns of the loop and from what is known.
struct Course {
    /// Parts of unknowns, by their place.
    parts: Vec<(usize, f64)>,
    /// What sources add.
    known: Value,
    /// What it is without all these.
    start: Start,
}

/// A direction or way at the start.
enum Start {
    /// A unit vector.
    Direction([f64; 2]),
    /// A length; zero for a way that is an unknown itself.
    Displacement(f64),
}

/// The unknowns of a tied loop.
pub(super) struct Tied {
    /// For each direction and way of the equation, how it follows.
    courses: Vec<Course>,
    /// For each unknown its name, and the direction or way of the equation that it is.
    unknowns: Vec<(String, usize)>,
}

impl Tied {
    /// What each direction and way moves by besides the unknowns: its number in the equation, and what is known.
    pub(super) fn known(&self) -> impl Iterator<Item = (usize, Value)> + '_ {
        self.courses.iter().map(|course| course.known).enumerate()
    }

    /// The columns of the unknowns, from those of all directions and ways.
    pub(super) fn columns(&self, builder: &mut Builder, all: &[Vec<Value>]) -> Vec<Vec<Value>> {
        let column = |place: usize| {
            let mut sum = vec![builder.constant(0.0); all[place].len()];
            for (course, column) in self.courses.iter().zip(all) {
                for (_, part) in course.parts.iter().filter(|(other, _)| *other == place) {
                    let part = builder.constant(*part);
                    for (sum, &rate) in sum.iter_mut().zip(column) {
                        let share = builder.mul(part, rate);
                        *sum = builder.add(*sum, share);
                    }
                }
            }
            sum
        };
        (0..self.unknowns.len()).map(column).collect()
    }

    /// The rate of a direction or way of the equation, from those of the unknowns and of what is known.
    pub(super) fn rate(
        &self,
        builder: &mut Builder,
        (index, rates): (usize, &[Value]),
        of_known: impl FnOnce(&mut Builder, Value) -> Value,
    ) -> Value {
        let course = &self.courses[index];
        let known = of_known(builder, course.known);
        course.sum(builder, known, rates)
    }
}

impl Course {
    /// What is known, and the parts of these values of the unknowns.
    fn sum(&self, builder: &mut Builder, known: Value, unknowns: &[Value]) -> Value {
        let mut sum = known;
        for (place, part) in &self.parts {
            let part = builder.constant(*part);
            let share = builder.mul(part, unknowns[*place]);
            sum = builder.add(sum, share);
        }
        sum
    }
}

impl Writer<'_> {
    /// How the directions and ways of a loop follow from its unknowns.
    pub(super) fn tied(
        &mut self,
        closing: &Loop,
        equation: &Equation<Value>,
        first: LinkId,
    ) -> Tied {
        let tie = |unknown: &Unknown| closing.ties.iter().find(|tie| tie.of == *unknown);
        let mut unknowns: Vec<(String, usize)> = Vec::new();
        for (index, unknown) in equation.unknowns.iter().enumerate() {
            if tie(unknown).is_none() {
                let name = match *unknown {
                    Unknown::Direction(base) => format!("{}_angle", self.name_of(base)),
                    Unknown::Slide(joint) => self.model.joint(joint).name.clone(),
                };
                unknowns.push((name, index));
            }
        }
        let place = |wanted: &Unknown| {
            unknowns
                .iter()
                .position(|(_, index)| equation.unknowns[*index] == *wanted)
        };
        let mut courses = Vec::new();
        for unknown in &equation.unknowns {
            courses.push(match tie(unknown) {
                None => Course {
                    parts: place(unknown)
                        .map(|place| (place, 1.0))
                        .into_iter()
                        .collect(),
                    known: self.builder.constant(0.0),
                    start: match *unknown {
                        Unknown::Direction(base) => Start::Direction(self.seen_from(first, base)),
                        Unknown::Slide(_) => Start::Displacement(0.0),
                    },
                },
                Some(tie) => {
                    let part = |(other, part): &(Unknown, _)| Some((place(other)?, float_of(part)));
                    Course {
                        parts: tie.parts.iter().filter_map(part).collect(),
                        known: self.moved_by_sources(tie),
                        start: self.start_of(tie, first),
                    }
                }
            });
        }
        Tied { courses, unknowns }
    }

    /// What the sources add to a tied direction or way since the start.
    fn moved_by_sources(&mut self, tie: &Tie) -> Value {
        let turns = matches!(tie.of, Unknown::Direction(_));
        let mut known = self.builder.constant(0.0);
        for (number, part) in &tie.sources {
            let start = self.plan.start.sources[*number];
            let share = self.share(*number, part, turns);
            let start = self.builder.constant(start * float_of(part));
            let moved = self.builder.sub(share, start);
            known = self.builder.add(known, moved);
        }
        known
    }

    /// What a tied direction or way is where all unknowns and sources are zero. An angle is counted from the start, a way is not.
    fn start_of(&mut self, tie: &Tie, first: LinkId) -> Start {
        match tie.of {
            Unknown::Direction(base) => Start::Direction(self.seen_from(first, base)),
            Unknown::Slide(joint) => {
                let mut displacement = self.way_at_start(joint, first);
                for (other, part) in &tie.parts {
                    if let Unknown::Slide(other) = *other {
                        displacement -= float_of(part) * self.way_at_start(other, first);
                    }
                }
                Start::Displacement(displacement)
            }
        }
    }

    /// The iteration on the unknown angles and ways.
    pub(super) fn iterate_tied(
        &mut self,
        block: BlockId,
        tied: &Tied,
        equation: &Equation<Value>,
        base: LinkId,
    ) -> (Newton, Vec<Solution<Value>>, Option<Side>) {
        let mut firsts = Vec::new();
        let mut state = Vec::new();
        for (name, index) in &tied.unknowns {
            firsts.push(match equation.unknowns[*index] {
                Unknown::Direction(_) => {
                    self.winds = true;
                    state.push(self.state.len());
                    let last = self.keep(0.0);
                    (name.clone(), Solution::Slide(last))
                }
                unknown @ Unknown::Slide(_) => self.first(unknown, base),
            });
        }
        let names: Vec<String> = firsts.iter().map(|(name, _)| name.clone()).collect();
        let (scalars, now) = self.unknowns(block, firsts);
        let full = self.all_directions(tied, equation, &now);
        let residuals = equation.residuals(&mut self.builder, &full);
        let rings = || residuals.rings.iter();
        let columns = tied.columns(&mut self.builder, &all_columns(&residuals, full.len()));
        let coupled = (equation.rings.len() > 1)
            .then(|| self.keep_coupled_side(&columns))
            .flatten();
        let side = match coupled {
            Some(side) => Some(side.last),
            None => self.keep_side(&columns),
        };
        let sides: Vec<[Value; 2]> = rings()
            .flat_map(|ring| ring.sides.iter().map(|(_, side)| *side))
            .collect();
        let angles: Vec<bool> = tied
            .unknowns
            .iter()
            .map(|(_, index)| matches!(equation.unknowns[*index], Unknown::Direction(_)))
            .collect();
        let slides = self.extent(equation, &full);
        let turns = self.rounded_by_turns(tied, equation, &now);
        let size = self.builder.constant(self.size_at_start(&sides));
        let turns = self.builder.mul(size, turns);
        let extent = match slides {
            Some(slides) => self.builder.add(slides, turns),
            None => turns,
        };
        let system = System {
            gap: rings().flat_map(|ring| ring.gap).collect(),
            columns,
            extent: Some(self.builder.name(extent, "extent")),
            sides,
            legs: Vec::new(),
            angles: Some(angles),
            side,
        };
        let (newton, solution) = self.advance(block, &names, scalars, &now, system);
        let mut state = state.into_iter();
        for ((_, index), solved) in tied.unknowns.iter().zip(&solution) {
            if let (Unknown::Direction(_), Solution::Slide(angle)) =
                (equation.unknowns[*index], *solved)
                && let Some(state) = state.next()
            {
                self.state[state] = angle;
            }
        }
        (newton, solution, coupled)
    }

    /// How much more is rounded where the angles of a tied loop have these values: they are counted from the start.
    pub(super) fn rounded_by_turns(
        &mut self,
        tied: &Tied,
        equation: &Equation<Value>,
        unknowns: &[Solution<Value>],
    ) -> Value {
        let part = self.builder.constant(OF_A_RADIAN);
        let mut sum = self.builder.constant(0.0);
        for ((_, index), unknown) in tied.unknowns.iter().zip(unknowns) {
            if let (Unknown::Direction(_), Solution::Slide(angle)) =
                (equation.unknowns[*index], *unknown)
            {
                let angle = self.builder.abs(angle);
                let share = self.builder.mul(part, angle);
                sum = self.builder.add(sum, share);
            }
        }
        sum
    }

    /// The columns of the unknowns of a tied loop where it is closed.
    pub(super) fn tied_columns(
        &mut self,
        tied: &Tied,
        equation: &Equation<Value>,
        solution: &[Solution<Value>],
    ) -> Vec<Vec<Value>> {
        let residuals = equation.residuals(&mut self.builder, solution);
        tied.columns(&mut self.builder, &all_columns(&residuals, solution.len()))
    }

    /// All unknowns of the equation, from those of the tied loop.
    pub(super) fn all_directions(
        &mut self,
        tied: &Tied,
        equation: &Equation<Value>,
        now: &[Solution<Value>],
    ) -> Vec<Solution<Value>> {
        // The unknown angles are iterated as plain numbers, as ways are.
        let numbers: Vec<Value> = now
            .iter()
            .map(|solution| match *solution {
                Solution::Slide(number) => number,
                Solution::Direction([cos, _]) => cos,
            })
            .collect();
        let mut full = Vec::new();
        for (unknown, course) in equation.unknowns.iter().zip(&tied.courses) {
            let moved = course.sum(&mut self.builder, course.known, &numbers);
            full.push(match (*unknown, &course.start) {
                (Unknown::Direction(base), Start::Direction(start)) => {
                    let name = self.name_of(base).to_owned();
                    self.turned_since(*start, moved, &name)
                }
                (_, Start::Displacement(start)) => {
                    let start = self.builder.constant(*start);
                    Solution::Slide(self.builder.add(start, moved))
                }
                (_, Start::Direction(_)) => Solution::Slide(moved),
            });
        }
        full
    }

    fn turned_since(&mut self, start: [f64; 2], angle: Value, name: &str) -> Solution<Value> {
        let builder = &mut self.builder;
        let (sin, cos) = (builder.make(Op::Sin(angle)), builder.make(Op::Cos(angle)));
        let start = builder.vector(start);
        let direction = builder.turned([cos, sin], start);
        Solution::Direction(builder.name_direction(direction, name))
    }

    /// The direction of a link at the start, seen from another.
    fn seen_from(&self, first: LinkId, base: LinkId) -> [f64; 2] {
        let pose = |link: LinkId| self.plan.start.poses[link.index()];
        let ([a, b, ..], [c, d, ..]) = (pose(first), pose(base));
        [a * c + b * d, a * d - b * c]
    }

    /// The coordinate of a sliding joint at the start.
    fn way_at_start(&mut self, joint: JointId, first: LinkId) -> f64 {
        let (_, now) = self.first(Unknown::Slide(joint), first);
        match now {
            Solution::Slide(displacement) => self.builder.at_start(displacement),
            Solution::Direction(_) => 0.0,
        }
    }
}

/// The rates of all gaps with each direction and way of an equation.
pub(super) fn all_columns(residuals: &Residuals<Value>, unknowns: usize) -> Vec<Vec<Value>> {
    let column = |unknown: usize| -> Vec<Value> {
        let rings = residuals.rings.iter();
        rings.flat_map(|ring| ring.columns[unknown]).collect()
    };
    (0..unknowns).map(column).collect()
}
