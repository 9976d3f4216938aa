//! Loops in which rolling ties directions or displacements: their unknowns are angles and displacements, because a tie is a relation of
//! these.

use crate::model::Model;
use crate::plan::{Algebra, Arithmetic, Equation, Residuals, Solution, Unknown};
use crate::program::builder::SsaBuilder;
use crate::program::node::{Op, Value};

/// By this part of itself, rounding grows for each radian of an angle that is counted from the start.
const OF_A_RADIAN: f64 = 0.125;

/// The unknowns of a tied loop.
pub(super) struct Tied {
    /// For each direction and displacement of the equation, how it follows from the unknowns.
    pub(super) relations: Vec<Relation>,
    pub(super) unknowns: Vec<TiedUnknown>,
}

/// The relation of a direction or displacement of the equation to the unknowns of the loop and to what is known.
pub(super) struct Relation {
    /// Parts of unknowns, by their place.
    pub(super) parts: Vec<(usize, f64)>,
    /// The share of sources.
    pub(super) known: Value,
    /// Its value without all these.
    pub(super) start: Start,
}

/// A direction or displacement at the start.
pub(super) enum Start {
    /// A unit vector.
    Direction([f64; 2]),
    /// A length; zero for a displacement that is an unknown itself.
    Displacement(f64),
}

/// An unknown of a tied loop.
pub(super) struct TiedUnknown {
    pub(super) name: String,
    /// The direction or displacement of the equation that it is.
    pub(super) index: usize,
    /// Whether it is an angle.
    pub(super) turns: bool,
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
        let numbers: Vec<Value> =
            now.iter().filter_map(|solution| solution.numbers().next()).collect();
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

/// The rates of all gaps with each direction and displacement of an equation.
pub(super) fn all_columns(residuals: &Residuals<Value>, unknowns: usize) -> Vec<Vec<Value>> {
    let column = |unknown: usize| -> Vec<Value> {
        let rings = residuals.rings.iter();
        rings.flat_map(|ring| ring.columns[unknown]).collect()
    };
    (0..unknowns).map(column).collect()
}
