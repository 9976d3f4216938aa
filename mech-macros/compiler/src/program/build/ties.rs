//! The ties of a loop's unknowns by rolling, and the iteration of a tied loop.

use super::LoopSite;
use super::iteration::{IteratedLoop, LoopIteration, System};
use super::last::{LastUnknown, last_unknown};
use super::pass::PositionPass;
use super::tied::{Relation, Start, Tied, TiedUnknown, all_columns};
use crate::model::{JointId, LinkId};
use crate::plan::{Arithmetic, Solution, Tie, Unknown, float_of};
use crate::program::node::Value;

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
        let place =
            |wanted: &Unknown| unknowns.iter().position(|unknown| all[unknown.index] == *wanted);
        let mut relations = Vec::new();
        for unknown in all {
            relations.push(match tie(unknown) {
                None => Relation {
                    parts: place(unknown).map(|place| (place, 1.0)).into_iter().collect(),
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
        Tied { relations, unknowns }
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
                LastUnknown { name: name.clone(), value: Solution::Slide(carried.last) }
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
        // A loop whose unknowns are all displacements has one solution.
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
