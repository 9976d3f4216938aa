//! Loops in which rolling ties directions or displacements: their unknowns are angles and displacements, because a tie is a relation of
//! these.

use super::closing::LoopSite;
use super::iteration::{IteratedLoop, LoopIteration, System};
use super::last::{LastUnknown, last_unknown};
use super::steps::PositionPass;
use crate::model::{JointId, LinkId, Model};
use crate::plan::{Algebra, Arithmetic, Equation, Residuals, Solution, Tie, Unknown, float_of};
use crate::program::builder::SsaBuilder;
use crate::program::node::{Op, Value};

/// The part of rounding that a radian of an angle adds to it, if the angle is counted from the start.
const OF_A_RADIAN: f64 = 0.125;

/// The unknowns of a tied loop.
pub(super) struct Tied {
    /// For each direction and displacement of the equation, how it follows from the unknowns.
    relations: Vec<Relation>,
    unknowns: Vec<TiedUnknown>,
}

/// The relation of a direction or displacement of the equation to the unknowns of the loop and to what is known.
struct Relation {
    /// Parts of unknowns, by their place.
    parts: Vec<(usize, f64)>,
    /// The share of sources.
    known: Value,
    /// Its value without all these.
    start: Start,
}

/// A direction or displacement at the start.
enum Start {
    /// A unit vector.
    Direction([f64; 2]),
    /// A length; zero for a displacement that is an unknown itself.
    Displacement(f64),
}

/// An unknown of a tied loop.
struct TiedUnknown {
    name: String,
    /// The direction or displacement of the equation that it is.
    index: usize,
    /// Whether it is an angle.
    turns: bool,
}

impl Tied {
    /// Whether an angle is among its unknowns: it is counted over whole turns.
    pub(super) fn counts_turns(&self) -> bool {
        self.unknowns.iter().any(|unknown| unknown.turns)
    }

    /// The known part of each direction and displacement, with its number in the equation.
    pub(super) fn known(&self) -> impl Iterator<Item = (usize, Value)> + '_ {
        let known = self.relations.iter().map(|relation| relation.known);
        known.enumerate()
    }

    /// The columns of the unknowns, from those of all directions and displacements.
    pub(super) fn columns(&self, ssa: &mut SsaBuilder, all: &[Vec<Value>]) -> Vec<Vec<Value>> {
        let column = |place: usize| {
            let mut sum = vec![ssa.constant(0.0); all[place].len()];
            for (relation, column) in self.relations.iter().zip(all) {
                for (_, part) in relation.parts.iter().filter(|(other, _)| *other == place) {
                    let part = ssa.constant(*part);
                    for (sum, &rate) in sum.iter_mut().zip(column) {
                        let share = ssa.mul(part, rate);
                        *sum = ssa.add(*sum, share);
                    }
                }
            }
            sum
        };
        (0..self.unknowns.len()).map(column).collect()
    }

    /// The columns of the unknowns at this solution of the equation.
    pub(super) fn columns_at(
        &self,
        ssa: &mut SsaBuilder,
        equation: &Equation<Value>,
        solution: &[Solution<Value>],
    ) -> Vec<Vec<Value>> {
        let residuals = equation.residuals(ssa, solution);
        self.columns(ssa, &all_columns(&residuals, solution.len()))
    }

    /// The rate of a direction or displacement of the equation, from the rates of the unknowns and of what is known.
    pub(super) fn rate(
        &self,
        ssa: &mut SsaBuilder,
        index: usize,
        rates: &[Value],
        of_known: impl FnOnce(&mut SsaBuilder, Value) -> Value,
    ) -> Value {
        let relation = &self.relations[index];
        let known = of_known(ssa, relation.known);
        relation.sum(ssa, known, rates)
    }

    /// The factor of additional rounding at these values of the unknowns: angles are counted from the start.
    pub(super) fn roundings(&self, ssa: &mut SsaBuilder, unknowns: &[Solution<Value>]) -> Value {
        let part = ssa.constant(OF_A_RADIAN);
        let mut sum = ssa.constant(0.0);
        for (tied, unknown) in self.unknowns.iter().zip(unknowns) {
            if let (true, Solution::Slide(angle)) = (tied.turns, *unknown) {
                let angle = ssa.abs(angle);
                let share = ssa.mul(part, angle);
                sum = ssa.add(sum, share);
            }
        }
        sum
    }

    /// All unknowns of the equation, from those of the tied loop.
    pub(super) fn all_unknowns(
        &self,
        ssa: &mut SsaBuilder,
        model: &Model,
        equation: &Equation<Value>,
        now: &[Solution<Value>],
    ) -> Vec<Solution<Value>> {
        // The unknown angles are iterated as plain numbers, as displacements are.
        let numbers: Vec<Value> = now
            .iter()
            .filter_map(|solution| solution.numbers().next())
            .collect();
        let mut all = Vec::new();
        for (unknown, relation) in equation.unknowns.iter().zip(&self.relations) {
            let moved = relation.sum(ssa, relation.known, &numbers);
            all.push(match (*unknown, &relation.start) {
                (Unknown::Direction(base), Start::Direction(start)) => {
                    let (sin, cos) = (ssa.make(Op::Sin(moved)), ssa.make(Op::Cos(moved)));
                    let start = ssa.vector(*start);
                    let direction = ssa.rotate([cos, sin], start);
                    Solution::Direction(ssa.name_direction(direction, &model.link(base).name))
                }
                (_, Start::Displacement(start)) => {
                    let start = ssa.constant(*start);
                    Solution::Slide(ssa.add(start, moved))
                }
                (_, Start::Direction(_)) => Solution::Slide(moved),
            });
        }
        all
    }
}

impl Relation {
    /// The sum of what is known and of the parts of these unknowns.
    fn sum(&self, ssa: &mut SsaBuilder, known: Value, unknowns: &[Value]) -> Value {
        let mut sum = known;
        for (place, part) in &self.parts {
            let part = ssa.constant(*part);
            let share = ssa.mul(part, unknowns[*place]);
            sum = ssa.add(sum, share);
        }
        sum
    }
}

impl PositionPass<'_> {
    /// The relations of the directions and displacements of a loop to its unknowns.
    pub(super) fn tie(&mut self, site: &LoopSite<'_>) -> Tied {
        let model = self.lowering.model;
        let all = &site.equation.unknowns;
        let tie = |unknown: &Unknown| site.closing.ties.iter().find(|tie| tie.of == *unknown);
        let mut unknowns: Vec<TiedUnknown> = Vec::new();
        for (index, unknown) in all.iter().enumerate() {
            if tie(unknown).is_none() {
                let (name, turns) = match *unknown {
                    Unknown::Direction(base) => (format!("{}_angle", model.link(base).name), true),
                    Unknown::Slide(joint) => (model.joint(joint).name.clone(), false),
                };
                unknowns.push(TiedUnknown { name, index, turns });
            }
        }
        let place = |wanted: &Unknown| {
            unknowns
                .iter()
                .position(|unknown| all[unknown.index] == *wanted)
        };
        let mut relations = Vec::new();
        for unknown in all {
            relations.push(match tie(unknown) {
                None => Relation {
                    parts: place(unknown)
                        .map(|place| (place, 1.0))
                        .into_iter()
                        .collect(),
                    known: self.lowering.ssa.constant(0.0),
                    start: match *unknown {
                        Unknown::Direction(link) => self.direction_at_start(site.base, link),
                        Unknown::Slide(_) => Start::Displacement(0.0),
                    },
                },
                Some(tie) => {
                    let part = |(other, part): &(Unknown, _)| Some((place(other)?, float_of(part)));
                    Relation {
                        parts: tie.parts.iter().filter_map(part).collect(),
                        known: self.moved_by_sources(tie),
                        start: self.start_of_tied(tie, site.base),
                    }
                }
            });
        }
        Tied {
            relations,
            unknowns,
        }
    }

    /// The share of the sources in a tied direction or displacement, since the start.
    fn moved_by_sources(&mut self, tie: &Tie) -> Value {
        let turns = matches!(tie.of, Unknown::Direction(_));
        let mut known = self.lowering.ssa.constant(0.0);
        for (number, part) in &tie.sources {
            let start = self.lowering.plan.start.sources[*number];
            let share = self.share(*number, part, turns);
            let ssa = &mut self.lowering.ssa;
            let start = ssa.constant(start * float_of(part));
            let moved = ssa.sub(share, start);
            known = ssa.add(known, moved);
        }
        known
    }

    /// The value of a tied direction or displacement where all unknowns and sources are zero. An angle is counted from the start, a
    /// displacement is not.
    fn start_of_tied(&mut self, tie: &Tie, base: LinkId) -> Start {
        match tie.of {
            Unknown::Direction(link) => self.direction_at_start(base, link),
            Unknown::Slide(joint) => {
                let mut displacement = self.displacement_at_start(joint, base);
                for (other, part) in &tie.parts {
                    if let Unknown::Slide(other) = *other {
                        displacement -= float_of(part) * self.displacement_at_start(other, base);
                    }
                }
                Start::Displacement(displacement)
            }
        }
    }

    /// The direction of a link at the start, seen from another.
    fn direction_at_start(&self, base: LinkId, link: LinkId) -> Start {
        let pose = |link: LinkId| self.lowering.plan.start.poses[link.index()];
        let ([a, b, ..], [c, d, ..]) = (pose(base), pose(link));
        Start::Direction([a * c + b * d, a * d - b * c])
    }

    /// The coordinate of a sliding joint at the start.
    fn displacement_at_start(&mut self, joint: JointId, base: LinkId) -> f64 {
        let (model, ssa) = (self.lowering.model, &mut self.lowering.ssa);
        match last_unknown(ssa, model, Unknown::Slide(joint), base).value {
            Solution::Slide(displacement) => ssa.at_start(displacement),
            Solution::Direction(_) => 0.0,
        }
    }
}

impl LoopIteration<'_> {
    /// Iterates on the unknown angles and displacements.
    pub(super) fn iterate_tied(&mut self, tied: &Tied) -> IteratedLoop {
        let equation = &self.site.equation;
        let mut last = Vec::new();
        let mut angles = Vec::new();
        for TiedUnknown { name, index, turns } in &tied.unknowns {
            last.push(if *turns {
                let carried = self.ssa.carry(0.0);
                angles.push(carried.index);
                LastUnknown {
                    name: name.clone(),
                    value: Solution::Slide(carried.last),
                }
            } else {
                let unknown = equation.unknowns[*index];
                last_unknown(self.ssa, self.model, unknown, self.site.base)
            });
        }
        let unknowns = self.begin(last);
        let all = tied.all_unknowns(self.ssa, self.model, equation, &unknowns.now);
        let residuals = equation.residuals(self.ssa, &all);
        let columns = tied.columns(self.ssa, &all_columns(&residuals, all.len()));
        let choice = &self.site.choice;
        let coupled = (equation.rings.len() > 1)
            .then(|| self.ssa.carry_coupled_side(choice, &columns))
            .flatten();
        let side = match coupled {
            Some(side) => Some(side.last),
            None => self.ssa.carry_side(choice, &columns),
        };
        let sides = residuals.sides();
        let slides = self.extent(&all);
        let turns = tied.roundings(self.ssa, &unknowns.now);
        let size = self.ssa.constant(self.ssa.size_at_start(&sides));
        let turns = self.ssa.mul(size, turns);
        let extent = match slides {
            Some(slides) => self.ssa.add(slides, turns),
            None => turns,
        };
        // What only slides has one solution.
        let has_several = all.iter().any(Solution::is_direction);
        let system = System {
            gap: residuals.gap(),
            columns,
            extent: Some(self.ssa.name(extent, "extent")),
            sides,
            angles: has_several
                .then(|| tied.unknowns.iter().map(|unknown| unknown.turns).collect()),
            side,
            ..System::default()
        };
        let iterated = self.advance(unknowns, system, coupled);
        let solved = tied.unknowns.iter().zip(&iterated.solution);
        let turning = solved.filter(|(unknown, _)| unknown.turns);
        for (angle, (_, solved)) in angles.into_iter().zip(turning) {
            for number in solved.numbers() {
                self.ssa.update(angle, number);
            }
        }
        iterated
    }
}

/// The rates of all gaps with each direction and displacement of an equation.
pub(super) fn all_columns(residuals: &Residuals<Value>, unknowns: usize) -> Vec<Vec<Value>> {
    let column = |unknown: usize| -> Vec<Value> {
        let rings = residuals.rings.iter();
        rings.flat_map(|ring| ring.columns[unknown]).collect()
    };
    (0..unknowns).map(column).collect()
}
