//! Loops in which rolling ties directions: their unknowns are angles, because a tie is a relation of angles.

use super::Writer;
use super::closing::System;
use crate::model::LinkId;
use crate::plan::{Algebra, Equation, Loop, Solution, Unknown};
use crate::program::builder::Builder;
use crate::program::newton::Newton;
use crate::program::node::{BlockId, Op, Value};
use num_traits::ToPrimitive;

/// How far a cluster has turned since the start: parts of the unknown angles, and what is known.
struct Turn {
    /// For each unknown that is an angle, its part.
    parts: Vec<(usize, f64)>,
    /// What sources add.
    known: Value,
    /// The direction at the start.
    start: [f64; 2],
}

/// The unknowns of a tied loop.
pub(super) struct Tied {
    /// For each direction of the equation, how it follows.
    turns: Vec<Turn>,
    /// For each unknown its name, and the direction or slide of the equation that it is.
    unknowns: Vec<(String, usize)>,
}

impl Tied {
    /// What each direction turns by besides the unknown angles: the direction's number, and what is known.
    pub(super) fn known(&self) -> impl Iterator<Item = (usize, Value)> + '_ {
        self.turns.iter().map(|turn| turn.known).enumerate()
    }

    /// The columns of the unknown angles and ways, from those of all directions and ways.
    pub(super) fn columns(&self, builder: &mut Builder, all: &[Vec<Value>]) -> Vec<Vec<Value>> {
        let column = |(place, (_, index)): (usize, &(String, usize))| {
            if *index >= self.turns.len() {
                return all[*index].clone();
            }
            let mut sum = vec![builder.constant(0.0); all[*index].len()];
            for (direction, turn) in self.turns.iter().enumerate() {
                for (_, part) in turn.parts.iter().filter(|(other, _)| *other == place) {
                    let part = builder.constant(*part);
                    for (sum, &rate) in sum.iter_mut().zip(&all[direction]) {
                        let share = builder.mul(part, rate);
                        *sum = builder.add(*sum, share);
                    }
                }
            }
            sum
        };
        self.unknowns.iter().enumerate().map(column).collect()
    }

    /// The rate of a direction or way of the equation, from those of the unknowns and of what is known.
    pub(super) fn rate(
        &self,
        builder: &mut Builder,
        (index, rates): (usize, &[Value]),
        of_known: impl FnOnce(&mut Builder, Value) -> Value,
    ) -> Value {
        let Some(turn) = self.turns.get(index) else {
            let place = self.unknowns.iter().position(|(_, own)| *own == index);
            return place.map_or_else(|| builder.constant(0.0), |place| rates[place]);
        };
        let mut sum = of_known(builder, turn.known);
        for (place, part) in &turn.parts {
            let part = builder.constant(*part);
            let share = builder.mul(part, rates[*place]);
            sum = builder.add(sum, share);
        }
        sum
    }
}

impl Writer<'_> {
    /// How the directions of a loop follow from its unknown angles.
    pub(super) fn tied(
        &mut self,
        closing: &Loop,
        equation: &Equation<Value>,
        first: LinkId,
    ) -> Tied {
        let tie = |base: LinkId| closing.ties.iter().find(|tie| tie.base == base);
        let mut unknowns: Vec<(String, usize)> = Vec::new();
        let mut place_of: Vec<(LinkId, usize)> = Vec::new();
        for (index, unknown) in equation.unknowns.iter().enumerate() {
            match *unknown {
                Unknown::Direction(base) if tie(base).is_none() => {
                    place_of.push((base, unknowns.len()));
                    unknowns.push((format!("{}_angle", self.name_of(base)), index));
                }
                Unknown::Direction(_) => {}
                Unknown::Slide(joint) => {
                    unknowns.push((self.model.joint(joint).name.clone(), index));
                }
            }
        }
        let mut turns = Vec::new();
        for unknown in &equation.unknowns {
            let Unknown::Direction(base) = *unknown else {
                continue;
            };
            let place = |base: LinkId| {
                place_of
                    .iter()
                    .find(|(known, _)| *known == base)
                    .map(|(_, place)| *place)
            };
            let mut known = self.builder.constant(0.0);
            let mut parts: Vec<(usize, f64)> = Vec::new();
            match tie(base) {
                None => parts.extend(place(base).map(|place| (place, 1.0))),
                Some(tie) => {
                    for (other, part) in &tie.parts {
                        parts.extend(
                            place(*other).map(|place| (place, part.to_f64().unwrap_or(0.0))),
                        );
                    }
                    for (number, part) in &tie.sources {
                        let start = self
                            .plan
                            .start
                            .sources
                            .get(*number)
                            .copied()
                            .unwrap_or_default();
                        let share = self.share(*number, part, true);
                        let start = start * part.to_f64().unwrap_or(0.0);
                        let start = self.builder.constant(start);
                        let moved = self.builder.sub(share, start);
                        known = self.builder.add(known, moved);
                    }
                }
            }
            let pose = |link: LinkId| self.plan.start.poses[link.index()];
            let ([a, b, ..], [c, d, ..]) = (pose(first), pose(base));
            turns.push(Turn {
                parts,
                known,
                start: [a * c + b * d, a * d - b * c],
            });
        }
        Tied { turns, unknowns }
    }

    /// The iteration on the unknown angles and ways.
    pub(super) fn iterate_tied(
        &mut self,
        block: BlockId,
        tied: &Tied,
        equation: &Equation<Value>,
        base: LinkId,
    ) -> (Newton, Vec<Solution<Value>>) {
        let mut firsts = Vec::new();
        let mut kept = Vec::new();
        for (name, index) in &tied.unknowns {
            firsts.push(match equation.unknowns[*index] {
                Unknown::Direction(_) => {
                    self.winds = true;
                    kept.push(self.kept.len());
                    let last = self.keep(0.0);
                    (name.clone(), Solution::Slide(last))
                }
                unknown @ Unknown::Slide(_) => self.first(unknown, base),
            });
        }
        let names: Vec<String> = firsts.iter().map(|(name, _)| name.clone()).collect();
        let (scalars, now) = self.unknowns(block, firsts);
        let full = self.all_directions(tied, equation, &now);
        let measure = equation.measure(&mut self.builder, &full);
        let walks = || measure.rings.iter();
        let column = |unknown: usize| -> Vec<Value> {
            walks().flat_map(|walk| walk.columns[unknown]).collect()
        };
        let all: Vec<Vec<Value>> = (0..full.len()).map(column).collect();
        let columns = tied.columns(&mut self.builder, &all);
        let system = System {
            gap: walks().flat_map(|walk| walk.gap).collect(),
            columns,
            sides: walks()
                .flat_map(|walk| walk.sides.iter().map(|(_, side)| *side))
                .collect(),
            extent: self.extent(equation, &full),
            angles: Some(
                tied.unknowns
                    .iter()
                    .map(|(_, index)| matches!(equation.unknowns[*index], Unknown::Direction(_)))
                    .collect(),
            ),
        };
        let (newton, solution) = self.advance(block, &names, scalars, &now, system);
        let mut kept = kept.into_iter();
        for ((_, index), solved) in tied.unknowns.iter().zip(&solution) {
            if let (Unknown::Direction(_), Solution::Slide(angle)) =
                (equation.unknowns[*index], *solved)
                && let Some(kept) = kept.next()
            {
                self.kept[kept] = angle;
            }
        }
        (newton, solution)
    }

    /// All unknowns of the equation, from those of the tied loop.
    pub(super) fn all_directions(
        &mut self,
        tied: &Tied,
        equation: &Equation<Value>,
        now: &[Solution<Value>],
    ) -> Vec<Solution<Value>> {
        let mut turns = tied.turns.iter();
        let mut full = Vec::new();
        for (index, unknown) in equation.unknowns.iter().enumerate() {
            let own = tied.unknowns.iter().position(|(_, known)| *known == index);
            full.push(match (unknown, own) {
                (Unknown::Direction(base), _) => {
                    let name = self.name_of(*base).to_owned();
                    match turns.next() {
                        Some(turn) => self.turned_since(turn, now, &name),
                        None => Solution::Direction(self.builder.vector([1.0, 0.0])),
                    }
                }
                (Unknown::Slide(_), Some(place)) => now[place],
                (Unknown::Slide(_), None) => Solution::Slide(self.builder.constant(0.0)),
            });
        }
        full
    }

    fn turned_since(
        &mut self,
        turn: &Turn,
        now: &[Solution<Value>],
        name: &str,
    ) -> Solution<Value> {
        let builder = &mut self.builder;
        let mut angle = turn.known;
        for (place, part) in &turn.parts {
            if let Solution::Slide(own) = now[*place] {
                let part = builder.constant(*part);
                let share = builder.mul(part, own);
                angle = builder.add(angle, share);
            }
        }
        let (sin, cos) = (builder.make(Op::Sin(angle)), builder.make(Op::Cos(angle)));
        let start = builder.vector(turn.start);
        let direction = builder.turned([cos, sin], start);
        Solution::Direction(builder.name_direction(direction, name))
    }
}
