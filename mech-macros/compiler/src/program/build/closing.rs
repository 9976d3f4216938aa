//! A loop: the equation it must satisfy, its solution in closed form or by iteration, and its watch.

use super::dyad::DyadLowering;
use super::iteration::{IteratedLoop, LoopIteration};
use super::last::last_unknown;
use super::pass::PositionPass;
use super::tied::Tied;
use super::triad::triad_directions;
use super::{LoopSite, SolvedLoop};
use crate::model::LinkId;
use crate::plan::{Dyad, Equation, Loop, Solution, Triad, Unknown};
use crate::program::BlockKind;
use crate::program::choice::{Choice, Solver};
use crate::program::node::Value;

impl PositionPass<'_> {
    /// Lowers the loop of this number.
    pub(super) fn close(&mut self, closing: &Loop, number: usize, choice: Choice) {
        let lowering = &mut self.lowering;
        let model = lowering.model;
        let hanging = closing.tree.iter();
        let bases = hanging.map(|connection| lowering.placement.base(connection.to));
        let bases: Vec<LinkId> = bases.collect();
        let unknowns = closing.unknowns().into_iter();
        let joints = unknowns.map(|joint| format!("`{}`", model.joint(joint).name));
        let place = joints.collect::<Vec<_>>().join(", ");
        let links: Vec<&str> = bases.iter().map(|&base| lowering.name_of(base)).collect();
        let name = format!("close_{}", links.join("_"));
        let title = format!("Loop {}, closed by {place}.", number + 1);
        let block = lowering.ssa.block(name.clone(), title);
        let equation = Equation::new(&mut lowering.ssa, &lowering.placement, closing);
        for ring in &equation.rings {
            lowering.ssa.name_vector(ring.offset, "known");
        }
        let mut site = LoopSite {
            number,
            block,
            choice,
            iterated: false,
            closing,
            equation,
            base: lowering.placement.base(closing.first().from),
            place,
        };
        let closed = self.solve_in_closed_form(&site);
        site.iterated = closed.is_none();
        let (solution, tied) =
            closed.map_or_else(|| self.solve_by_iteration(&site), |solution| (solution, None));
        let lowering = &mut self.lowering;
        let placement = &mut lowering.placement;
        site.equation.place(&mut lowering.ssa, placement, closing, &solution);
        lowering.name_moved();
        self.loops.push(SolvedLoop {
            number,
            name,
            place: site.place,
            equation: site.equation,
            solution,
            tied,
        });
    }

    /// Solves a loop in closed form, if it has one and it is to be solved so. Where all slides, the equations are linear: Newton's step
    /// is their closed form, but would not be made where the loop passes for closed without it.
    fn solve_in_closed_form(&mut self, site: &LoopSite<'_>) -> Option<Vec<Solution<Value>>> {
        let (model, ssa) = (self.lowering.model, &mut self.lowering.ssa);
        let choice = &site.choice;
        let mut unknowns = site.equation.unknowns.iter();
        let is_linear = unknowns.all(|unknown| matches!(unknown, Unknown::Slide(_)));
        if choice.solver != Solver::ClosedForm && !choice.changes_branch() && !is_linear {
            return None;
        }
        let unknowns = site.equation.unknowns.iter();
        let (names, last): (Vec<String>, Vec<Solution<Value>>) = unknowns
            .map(|unknown| last_unknown(ssa, model, *unknown, site.base))
            .map(|last| (last.name, last.value))
            .unzip();
        if !site.closing.ties.is_empty() {
            return None;
        }
        let dyad = Dyad::of(ssa, &site.equation)?;
        let mut dyads = DyadLowering {
            ssa,
            choice,
            last: &last,
            across: site.equation.rings.first().and_then(|ring| ring.across),
        };
        let (closed, solution) = dyads.lower(dyad, site.number, &site.place);
        let has_branch = closed.has_branches && choice.changes_branch();
        let sine = [closed.sine, closed.rounding_square];
        self.watches.watch(ssa, site, sine, has_branch);
        if model.allow.redundant {
            self.watches.note_tilt(ssa, &closed);
        }
        for (name, unknown) in names.iter().zip(&solution) {
            match *unknown {
                Solution::Direction(direction) => {
                    ssa.name_direction(direction, name);
                }
                Solution::Slide(displacement) => {
                    ssa.name(displacement, name);
                }
            }
        }
        ssa.set_kind(site.block, BlockKind::ClosedForm(closed));
        Some(solution.to_vec())
    }

    /// Solves a loop by iteration: the directions and displacements of its equation, and how they follow from fewer unknowns if rolling
    /// ties them.
    fn solve_by_iteration(&mut self, site: &LoopSite<'_>) -> (Vec<Solution<Value>>, Option<Tied>) {
        let placement = &self.lowering.placement;
        // Its middle link would be found by its place.
        let far_off = |triad: &Triad| {
            let [a, b, c] = triad.legs.map(|leg| leg.foot.from);
            let ssa = &self.lowering.ssa;
            let far_off = |a, b| placement.are_far_off(ssa, a, b) == Some(true);
            far_off(a, b) && far_off(b, c)
        };
        let triad = Triad::of(site.closing, |axis| placement.base(axis));
        let triad = triad.filter(|triad| !far_off(triad));
        let is_tied = !site.closing.ties.is_empty();
        let tied = is_tied.then(|| self.tie(site));
        let (model, ssa) = (self.lowering.model, &mut self.lowering.ssa);
        ssa.enter();
        let mut iteration = LoopIteration {
            model,
            placement: &self.lowering.placement,
            ssa,
            predictor: &mut self.predictor,
            site,
        };
        let IteratedLoop { mut newton, solution, side } = match (&tied, &triad) {
            (Some(tied), _) => iteration.iterate_tied(tied),
            (None, Some(triad)) => iteration.iterate_triad(triad),
            (None, None) => iteration.iterate(&self.watches),
        };
        newton.sides.extend(iteration.axes_of_rings());
        ssa.leave();
        let watches = &mut self.watches;
        if let Some(side) = side {
            watches.watch_coupled(ssa, site, &newton, side);
        }
        let equation = &site.equation;
        let solution = match (&tied, &triad) {
            (Some(tied), _) => {
                let all = tied.all_unknowns(ssa, model, equation, &solution);
                let roundings = tied.roundings(ssa, &solution);
                if site.choice.watching.is_some() {
                    let columns = tied.columns_at(ssa, equation, &all);
                    watches.watch_tied(ssa, site, &columns, roundings);
                }
                all
            }
            (None, Some(triad)) => {
                triad_directions(ssa, &self.lowering.placement, triad, equation, &solution)
            }
            (None, None) => {
                watches.watch_iteration(ssa, site, equation, &solution);
                solution
            }
        };
        ssa.set_kind(site.block, BlockKind::Newton(newton));
        (solution, tied)
    }
}
