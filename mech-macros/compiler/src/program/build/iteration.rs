//! A loop's iteration: the gap, its rates, and the next round's unknowns.

use super::LoopSite;
use super::last::{LastUnknown, last_unknown};
use super::predictor::{History, Predictor};
use super::tied::all_columns;
use super::watching::{CoupledSide, Watches};
use crate::model::{Joint, JointKind, Model};
use crate::plan::{Algebra, Arithmetic, Placement, Residuals, Solution};
use crate::program::builder::SsaBuilder;
use crate::program::choice::{MOST_ROUNDS, Solver};
use crate::program::newton::{Limits, Newton, Rounds, Scalar};
use crate::program::node::{Op, Value};

/// Lowers the iteration of a loop.
pub(super) struct LoopIteration<'a> {
    pub(super) model: &'a Model,
    pub(super) placement: &'a Placement<'a, Value>,
    pub(super) ssa: &'a mut SsaBuilder,
    pub(super) predictor: &'a mut Predictor,
    pub(super) site: &'a LoopSite<'a>,
}

/// The unknowns of a round.
pub(super) struct Unknowns {
    names: Vec<String>,
    scalars: Vec<Scalar>,
    pub(super) now: Vec<Solution<Value>>,
    /// Their histories, if their start is predicted.
    histories: Vec<History>,
}

/// The equations of a round.
#[derive(Default)]
pub(super) struct System {
    /// The gap, in scene units.
    pub(super) gap: Vec<Value>,
    /// For each unknown, the rates of the gap with it.
    pub(super) columns: Vec<Vec<Value>>,
    /// The vectors that add to the gap.
    pub(super) sides: Vec<[Value; 2]>,
    /// The lengths that are not fixed, where something slides.
    pub(super) extent: Option<Value>,
    /// The legs of a middle link, whose pose the unknowns are: how far each turns is a part of the step.
    pub(super) legs: Vec<Lever>,
    /// For each unknown whether it is an angle, where the determinant's sign does not distinguish all assemblies.
    pub(super) angles: Option<Vec<bool>>,
    /// A number whose sign tells which sign the determinant must have: plus for that of the start. None if that cannot change.
    pub(super) side: Option<Value>,
}

/// A leg that a link turns.
pub(super) struct Lever {
    /// From the link's origin to the leg.
    pub(super) arm: [Value; 2],
    /// One over the leg's length.
    pub(super) inverse: Value,
}

/// A loop that is solved by iteration.
pub(super) struct IteratedLoop {
    pub(super) newton: Newton,
    /// The unknowns after the last round.
    pub(super) solution: Vec<Solution<Value>>,
    /// On which side of their change points coupled loops are, if that is carried.
    pub(super) side: Option<CoupledSide>,
}

impl LoopIteration<'_> {
    /// Iterates on the unknowns of the loop's equation.
    pub(super) fn iterate(&mut self, watches: &Watches) -> IteratedLoop {
        let equation = &self.site.equation;
        let unknowns = equation.unknowns.iter();
        let mut last: Vec<LastUnknown> = unknowns
            .map(|unknown| last_unknown(self.ssa, self.model, *unknown, self.site.base))
            .collect();
        if let Some(direction) = self.only_direction() {
            last[0].value = Solution::Direction(direction);
        }
        let unknowns = self.begin(last);
        let now = &unknowns.now;
        let residuals = equation.residuals(self.ssa, now);
        self.name_residuals(&residuals, &unknowns.names);
        let columns = all_columns(&residuals, now.len());
        let is_coupled = equation.rings.len() > 1;
        // A loop whose unknowns are all displacements has one solution.
        let has_several = is_coupled && now.iter().any(Solution::is_direction);
        let choice = &self.site.choice;
        let side = is_coupled.then(|| self.ssa.carry_coupled_side(choice, &columns)).flatten();
        let system = System {
            gap: residuals.gap(),
            columns,
            sides: residuals.sides(),
            extent: self.redundant_extent(watches, now),
            angles: has_several.then(|| now.iter().map(Solution::is_direction).collect()),
            side: side.map(|side| side.last),
            ..System::default()
        };
        self.advance(unknowns, system, side)
    }

    /// The direction of the only unknown of a redundant loop: along the line between its pins. An iteration from the last position would
    /// end too soon.
    fn only_direction(&mut self) -> Option<[Value; 2]> {
        let [ring] = &self.site.equation.rings[..] else {
            return None;
        };
        let ([Some(arm)], true) = (&ring.arms[..], ring.slides.is_empty()) else {
            return None;
        };
        let choice = &self.site.choice;
        let is_free = matches!(self.rounds(), Rounds::UntilClosed(_)) && choice.predictor == 0;
        is_free.then(|| {
            let ssa = &mut *self.ssa;
            let back = ring.offset.map(|part| ssa.neg(part));
            let along = [ssa.dot(*arm, back), ssa.cross(*arm, back)];
            let length = ssa.dot(along, along);
            let length = ssa.sqrt(length);
            along.map(|part| ssa.div(part, length))
        })
    }

    /// The axes of the rings in their links, and their ends in the first cluster: rounding grows with these too, unless the vectors between
    /// them are no differences of these.
    pub(super) fn axes_of_rings(&mut self) -> Vec<[Value; 2]> {
        let mut places = Vec::new();
        for ring in &self.site.closing.rings {
            let follows = |index: usize| (index + 1) % ring.len();
            let far = |index: usize| {
                let (to, from) = (ring[index].to, ring[follows(index)].from);
                self.placement.are_far_off(self.ssa, to, from)
            };
            let far: Vec<Option<bool>> = (0..ring.len()).map(far).collect();
            // Axes on each other count as the others do.
            let any = far.contains(&Some(true));
            let far: Vec<bool> = far.into_iter().map(|far| far.unwrap_or(any)).collect();
            for (index, connection) in ring.iter().enumerate() {
                let before = far[(index + ring.len() - 1) % ring.len()];
                for (axis, far) in [(connection.from, before), (connection.to, far[index])] {
                    if !far {
                        places.push(self.ssa.place(self.model.axis(axis)));
                    }
                }
            }
            if far.last() == Some(&false) {
                let ends = [ring[0].from, ring[ring.len() - 1].to];
                places.extend(ends.map(|axis| self.placement.spot(self.ssa, axis)));
            }
        }
        places
    }

    /// The lengths of a loop that are not fixed, where something slides: a telescope may become any times longer than it is at the start.
    pub(super) fn extent(&mut self, now: &[Solution<Value>]) -> Option<Value> {
        let equation = &self.site.equation;
        let slides = |joint: &Joint| matches!(joint.kind, JointKind::Prismatic(..));
        let varying = self.ssa.varying_extent(equation);
        if !self.model.joints.iter().any(slides) {
            return varying;
        }
        let displacements = now.iter().filter_map(|solution| match solution {
            Solution::Slide(displacement) => Some(*displacement),
            Solution::Direction(_) => None,
        });
        let offsets = equation.rings.iter().flat_map(|ring| ring.offset);
        let lengths: Vec<Value> = displacements.chain(offsets).collect();
        let mut extent = self.ssa.about(&lengths);
        if let Some(varying) = varying {
            extent = self.ssa.add(extent, varying);
        }
        Some(self.ssa.name(extent, "extent"))
    }

    /// The number of rounds that the iteration takes.
    fn rounds(&self) -> Rounds {
        match self.site.choice.solver {
            Solver::ClosedForm => Rounds::UntilClosed(MOST_ROUNDS),
            Solver::Linear => Rounds::Exactly(1),
            Solver::Newton(rounds) => rounds,
        }
    }

    /// The lengths of a loop that are not fixed. A loop of one unknown holds again what earlier loops hold: their doubt adds to its lengths.
    fn redundant_extent(&mut self, watches: &Watches, now: &[Solution<Value>]) -> Option<Value> {
        let extent = self.extent(now);
        let linear = self.site.choice.solver == Solver::Linear;
        let accepted = self.rounds().accept(linear, self.ssa.epsilon);
        let doubt = (now.len() == 1)
            .then(|| watches.doubt(self.ssa, self.model.size(), accepted))
            .flatten();
        match (extent, doubt) {
            (Some(extent), Some(doubt)) => Some(self.ssa.add(extent, doubt)),
            (extent, doubt) => extent.or(doubt),
        }
    }

    /// The unknowns in a round of an iteration that begins at the last position, or further on.
    pub(super) fn begin(&mut self, mut last: Vec<LastUnknown>) -> Unknowns {
        let order = self.site.choice.predictor;
        let histories = self.predictor.predict(self.ssa, order, &mut last);
        let mut scalars = Vec::new();
        let now = last.iter().map(|unknown| self.unknown(unknown, &mut scalars));
        Unknowns {
            now: now.collect(),
            names: last.iter().map(|unknown| unknown.name.clone()).collect(),
            scalars,
            histories,
        }
    }

    /// From a round to the next.
    pub(super) fn advance(
        &mut self,
        unknowns: Unknowns,
        system: System,
        side: Option<CoupledSide>,
    ) -> IteratedLoop {
        let (steps, det) = self.ssa.solve_linear(self.site.block, &system.columns, &system.gap);
        let det = match system.side {
            Some(side) => {
                let one = self.ssa.constant(1.0);
                let sign = self.ssa.make(Op::CopySign(one, side));
                self.ssa.mul(sign, det)
            }
            None => det,
        };
        let det = self.ssa.name(det, "det");
        let step = system.angles.map(|angles| {
            if let ([turn, x, y], false) = (&steps[..], system.legs.is_empty()) {
                self.legs_square([*turn, *x, *y], &system.legs)
            } else {
                self.step_square(&steps, &angles, &system.sides)
            }
        });
        let linear = self.site.choice.solver == Solver::Linear;
        let mut next = Vec::new();
        for ((now, step), name) in unknowns.now.iter().zip(steps).zip(&unknowns.names) {
            match *now {
                Solution::Direction(direction) if linear => {
                    next.extend(self.ssa.rotate_slightly(direction, step, name));
                }
                Solution::Direction(direction) => {
                    next.extend(self.ssa.rotate_by(direction, step, name));
                }
                Solution::Slide(displacement) => next.push(self.ssa.add(displacement, step)),
            }
        }
        let scalars = unknowns.scalars.into_iter().zip(next);
        let scalars: Vec<Scalar> =
            scalars.map(|(scalar, next)| Scalar { next, ..scalar }).collect();
        let solution = self.solution(&unknowns.now, &scalars);
        self.predictor.remember(self.ssa, &unknowns.histories, &solution);
        let newton = Newton {
            number: self.site.number,
            place: self.site.place.clone(),
            dense: system.columns.len() > 3,
            scalars,
            gap: system.gap,
            det,
            columns: system.columns,
            sides: system.sides,
            step,
            extent: system.extent,
            rounds: self.rounds(),
            linear,
            limits: Limits::default(),
        };
        IteratedLoop { newton, solution, side }
    }

    /// The square of a step.
    fn step_square(&mut self, steps: &[Value], angles: &[bool], sides: &[[Value; 2]]) -> Value {
        // Of a whole loop's size, many steps of a part of it would lead far away.
        let length = mean_length(self.ssa.size_at_start(sides), sides.len());
        let inverse = self.ssa.constant(1.0 / length.max(f64::MIN_POSITIVE));
        let mut sum = self.ssa.constant(0.0);
        for (step, is_angle) in steps.iter().zip(angles) {
            let part = if *is_angle { *step } else { self.ssa.mul(inverse, *step) };
            let square = self.ssa.mul(part, part);
            sum = self.ssa.add(sum, square);
        }
        sum
    }

    /// The square of a step of a middle link on legs: how far it turns, and how far each leg does.
    fn legs_square(&mut self, [turn, x, y]: [Value; 3], legs: &[Lever]) -> Value {
        let ssa = &mut *self.ssa;
        let mut sum = ssa.mul(turn, turn);
        for &Lever { arm, inverse } in legs {
            let (up, along) = (ssa.mul(arm[1], turn), ssa.mul(arm[0], turn));
            let moved = [ssa.sub(x, up), ssa.add(y, along)];
            let turned = ssa.scale(inverse, moved);
            let square = ssa.dot(turned, turned);
            sum = ssa.add(sum, square);
        }
        sum
    }

    fn name_residuals(&mut self, residuals: &Residuals<Value>, names: &[String]) {
        for ring in &residuals.rings {
            self.ssa.name_vector(ring.gap, "gap");
            for &(unknown, side) in &ring.sides {
                if let Some(name) = unknown.map(|unknown| &names[unknown]) {
                    self.ssa.name_vector(side, &format!("{name}_side"));
                }
            }
        }
    }

    /// An unknown in a round, and its scalars.
    fn unknown(&mut self, last: &LastUnknown, scalars: &mut Vec<Scalar>) -> Solution<Value> {
        let mut scalar = |name: String, first: Value| {
            let unknown = Op::Unknown(self.site.block, scalars.len());
            let now = self.ssa.make(unknown);
            self.ssa.begins_with(now, first);
            self.ssa.name(now, &name);
            scalars.push(Scalar { name, first, now, next: now });
            now
        };
        let name = &last.name;
        match last.value {
            Solution::Direction([cos, sin]) => Solution::Direction([
                scalar(format!("{name}_cos"), cos),
                scalar(format!("{name}_sin"), sin),
            ]),
            Solution::Slide(displacement) => Solution::Slide(scalar(name.clone(), displacement)),
        }
    }

    /// The unknowns after the last round.
    fn solution(&mut self, now: &[Solution<Value>], scalars: &[Scalar]) -> Vec<Solution<Value>> {
        let mut index = 0;
        let mut next = || {
            let value = self.ssa.make(Op::Solved(self.site.block, index));
            self.ssa.begins_with(value, scalars[index].first);
            self.ssa.name(value, scalars[index].name.clone());
            index += 1;
            value
        };
        let solution = now.iter().map(|unknown| match unknown {
            Solution::Direction(_) => Solution::Direction([next(), next()]),
            Solution::Slide(_) => Solution::Slide(next()),
        });
        solution.collect()
    }
}

/// The mean length of so many sides.
fn mean_length(sum: f64, sides: usize) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "a handful of sides")]
    let count = sides.max(1) as f64;
    sum / count
}
