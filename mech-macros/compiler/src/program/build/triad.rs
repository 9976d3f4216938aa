//! Three links on three binary legs: contracted to three equations in the pose of the middle link.
//!
//! Each leg says how far its pin on the middle link is from its pin on what is known; its own direction follows.

use super::Writer;
use super::closing::System;
use super::watching::Side;
use crate::model::LinkId;
use crate::plan::{Algebra, Equation, Leg, Solution, Triad, Unknown};
use crate::program::newton::Newton;
use crate::program::node::{BlockId, Value};

impl Writer<'_> {
    /// The iteration on the pose of the middle link: a direction and the place of its origin.
    pub(super) fn contract(
        &mut self,
        block: BlockId,
        triad: &Triad,
        first: LinkId,
    ) -> (Newton, Vec<Solution<Value>>, Option<Side>) {
        let name = self.name_of(triad.middle).to_owned();
        let names = [name.clone(), format!("{name}_x"), format!("{name}_y")];
        let frame = self.last_pose(first).inverse(&mut self.builder);
        let last = self.last_pose(triad.middle);
        let last = frame.then(&mut self.builder, last);
        let direction = self.normalised(last.direction, &name);
        let [x, y] = last.origin;
        let firsts = [
            Solution::Direction(direction),
            Solution::Slide(x),
            Solution::Slide(y),
        ];
        let (scalars, now) = self.unknowns(block, names.iter().cloned().zip(firsts).collect());
        let mut system = System {
            gap: Vec::new(),
            columns: vec![Vec::new(); 3],
            sides: Vec::new(),
            extent: None,
            angles: Some(vec![true, false, false]),
            legs: Vec::new(),
            side: None,
        };
        for leg in triad.legs {
            self.leg_equation(leg, &now, &mut system);
        }
        let side = self.keep_coupled_side(&system.columns);
        system.side = side.map(|side| side.last);
        let (newton, solution) = self.advance(block, &names, scalars, &now, system);
        (newton, solution, side)
    }

    /// The leg's length is what it is: (|d|² − L²) / 2L = 0, with d from its foot to its head.
    fn leg_equation(&mut self, leg: Leg, now: &[Solution<Value>], system: &mut System) {
        let name = self.name_of(leg.base).to_owned();
        let (reach, arm) = self.reach(leg, now);
        let reach = self.builder.name_vector(reach, &format!("{name}_reach"));
        let span = self
            .placement
            .span(&mut self.builder, leg.foot.to, leg.head.from);
        let builder = &mut self.builder;
        let (square, wanted) = (builder.dot(reach, reach), builder.dot(span, span));
        let difference = builder.sub(square, wanted);
        // Divided by twice the length so that the gap is a length; the length itself would take a root.
        let (half, one) = (builder.constant(0.5), builder.constant(1.0));
        let length = builder.sqrt(wanted);
        let inverse = builder.div(one, length);
        let scale = builder.mul(half, inverse);
        let gap = builder.mul(scale, difference);
        system.gap.push(builder.name(gap, format!("{name}_gap")));
        let along = builder.scaled(inverse, reach);
        let turn = builder.cross(arm, along);
        for (column, rate) in system.columns.iter_mut().zip([turn, along[0], along[1]]) {
            column.push(rate);
        }
        system.sides.extend([reach, arm]);
        system.legs.push((arm, inverse));
    }

    /// The way from a leg's foot to its head, and the arm of the middle link to the head.
    fn reach(&mut self, leg: Leg, now: &[Solution<Value>]) -> ([Value; 2], [Value; 2]) {
        let foot = self.placement.spot(&mut self.builder, leg.foot.from);
        let head = self.placement.spot(&mut self.builder, leg.head.to);
        let (arm, origin) = match *now {
            [
                Solution::Direction(direction),
                Solution::Slide(x),
                Solution::Slide(y),
            ] => (self.builder.turned(direction, head), [x, y]),
            _ => (head, foot),
        };
        let head = self.builder.plus(origin, arm);
        (self.builder.minus(head, foot), arm)
    }

    /// The directions of all clusters, from the pose of the middle link.
    pub(super) fn expand(
        &mut self,
        triad: &Triad,
        equation: &Equation<Value>,
        solution: &[Solution<Value>],
    ) -> Vec<Solution<Value>> {
        let directions = equation.unknowns.iter().map(|unknown| {
            let Unknown::Direction(base) = *unknown else {
                return solution[0];
            };
            let Some(leg) = triad.legs.into_iter().find(|leg| leg.base == base) else {
                return solution[0];
            };
            let (reach, _) = self.reach(leg, solution);
            let span = self
                .placement
                .span(&mut self.builder, leg.foot.to, leg.head.from);
            let square = self.builder.dot(span, span);
            let one = self.builder.constant(1.0);
            let inverse = self.builder.div(one, square);
            let back = self.builder.conjugate(span);
            let turned = self.builder.turned(reach, back);
            let direction = self.builder.scaled(inverse, turned);
            let name = self.name_of(base).to_owned();
            let direction = self.normalised(direction, &name);
            Solution::Direction(self.builder.name_direction(direction, &name))
        });
        directions.collect()
    }
}
