//! Three links on three binary legs: contracted to three equations in the pose of the middle link.
//!
//! Each leg says how far its pin on the middle link is from its pin on what is known; its own direction follows.

use super::iteration::{IteratedLoop, Lever, LoopIteration, System};
use super::last::{LastUnknown, last_pose};
use crate::plan::{Algebra, Arithmetic, Equation, Leg, Placement, Solution, Triad, Unknown};
use crate::program::builder::SsaBuilder;
use crate::program::node::Value;

impl LoopIteration<'_> {
    /// Iterates on the pose of the middle link: a direction and the place of its origin.
    pub(super) fn iterate_triad(&mut self, triad: &Triad) -> IteratedLoop {
        let name = &self.model.link(triad.middle).name;
        let frame = last_pose(self.ssa, self.model, self.site.base).inverse(self.ssa);
        let last = last_pose(self.ssa, self.model, triad.middle);
        let last = frame.then(self.ssa, last);
        let direction = self.ssa.normalise(last.direction, name);
        let [x, y] = last.origin;
        let unknown = |name: String, value| LastUnknown { name, value };
        let unknowns = self.begin(vec![
            unknown(name.clone(), Solution::Direction(direction)),
            unknown(format!("{name}_x"), Solution::Slide(x)),
            unknown(format!("{name}_y"), Solution::Slide(y)),
        ]);
        let mut system = System {
            columns: vec![Vec::new(); 3],
            angles: Some(vec![true, false, false]),
            ..System::default()
        };
        for leg in triad.legs {
            self.leg_equation(leg, &unknowns.now, &mut system);
        }
        let side = self.ssa.carry_coupled_side(&self.site.choice, &system.columns);
        system.side = side.map(|side| side.last);
        self.advance(unknowns, system, side)
    }

    /// Adds the equation of a leg, that its length L stays the same: (|d|² − L²) / 2L = 0, with d from its foot to its head.
    fn leg_equation(&mut self, leg: Leg, now: &[Solution<Value>], system: &mut System) {
        let name = &self.model.link(leg.base).name;
        let ssa = &mut *self.ssa;
        let Reach { span, arm } = reach(ssa, self.placement, leg, now);
        let span = ssa.name_vector(span, &format!("{name}_reach"));
        let own = self.placement.span(ssa, leg.foot.to, leg.head.from);
        let (square, wanted) = (ssa.dot(span, span), ssa.dot(own, own));
        let difference = ssa.sub(square, wanted);
        // Divided by twice the length so that the gap is a length; the length itself would take a root.
        let (half, one) = (ssa.constant(0.5), ssa.constant(1.0));
        let length = ssa.sqrt(wanted);
        let inverse = ssa.div(one, length);
        let scale = ssa.mul(half, inverse);
        let gap = ssa.mul(scale, difference);
        system.gap.push(ssa.name(gap, format!("{name}_gap")));
        let along = ssa.scale(inverse, span);
        let turn = ssa.cross(arm, along);
        for (column, rate) in system.columns.iter_mut().zip([turn, along[0], along[1]]) {
            column.push(rate);
        }
        system.sides.extend([span, arm]);
        system.legs.push(Lever { arm, inverse });
    }
}

/// The directions of all clusters, from the pose of the middle link.
pub(super) fn triad_directions(
    ssa: &mut SsaBuilder,
    placement: &Placement<'_, Value>,
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
        let Reach { span, .. } = reach(ssa, placement, leg, solution);
        let own = placement.span(ssa, leg.foot.to, leg.head.from);
        let square = ssa.dot(own, own);
        let one = ssa.constant(1.0);
        let inverse = ssa.div(one, square);
        let back = ssa.conjugate(own);
        let turned = ssa.rotate(span, back);
        let direction = ssa.scale(inverse, turned);
        let name = &placement.model.link(base).name;
        let direction = ssa.normalise(direction, name);
        Solution::Direction(ssa.name_direction(direction, name))
    });
    directions.collect()
}

/// The vectors of a leg.
struct Reach {
    /// From its foot to its head.
    span: [Value; 2],
    /// From the origin of the middle link to the head.
    arm: [Value; 2],
}

/// The vectors of a leg at this pose of the middle link.
fn reach(
    ssa: &mut SsaBuilder,
    placement: &Placement<'_, Value>,
    leg: Leg,
    now: &[Solution<Value>],
) -> Reach {
    let foot = placement.spot(ssa, leg.foot.from);
    let head = placement.spot(ssa, leg.head.to);
    let (arm, origin) = match *now {
        [Solution::Direction(direction), Solution::Slide(x), Solution::Slide(y)] => {
            (ssa.rotate(direction, head), [x, y])
        }
        _ => (head, foot),
    };
    let head = ssa.plus(origin, arm);
    Reach { span: ssa.minus(head, foot), arm }
}
