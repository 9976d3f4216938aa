//! A loop's iteration: the gap, its rates, and the next round's unknowns.

use super::Writer;
use super::rates::Closing;
use super::tied::all_columns;
use super::watching::{Side, Watchable};
use crate::model::{Joint, JointKind, LinkId};
use crate::plan::{Algebra, Equation, Loop, Pose, Residuals, Solution, Triad, Unknown};
use crate::program::choice::{MOST_ROUNDS, Solver};
use crate::program::newton::{Limits, Newton, Rounds, Scalar};
use crate::program::node::{BlockId, Op, Part, Slot, Value};
use crate::program::stored::number_among_all;
use crate::program::{BlockKind, ClosedForm};

/// An unknown: what it is called, and where the iteration starts.
pub(super) type First = (String, Solution<Value>);

/// The equations of a round.
pub(super) struct System {
    /// What is missing.
    pub(super) gap: Vec<Value>,
    /// For each unknown, the rates of the gap with it.
    pub(super) columns: Vec<Vec<Value>>,
    /// The vectors that the way round is made of.
    pub(super) sides: Vec<[Value; 2]>,
    /// How far it has grown, where something slides.
    pub(super) extent: Option<Value>,
    /// For each leg of a middle link, whose pose the unknowns are, the arm of that link to the leg, and one over the leg's length: how
    /// far the leg turns is a part of the step.
    pub(super) legs: Vec<([Value; 2], Value)>,
    /// For each unknown whether it is an angle, where the determinant's sign does not tell all assemblies apart.
    pub(super) angles: Option<Vec<bool>>,
    /// A number with the sign that the determinant must have, plus for that of the start, if it may change.
    pub(super) side: Option<Value>,
}

impl Writer<'_> {
    pub(super) fn close(&mut self, closing: &Loop) {
        self.loops += 1;
        let bases: Vec<LinkId> = closing
            .tree
            .iter()
            .map(|connection| self.placement.base(connection.to))
            .collect();
        let joints: Vec<String> = closing
            .unknowns()
            .iter()
            .map(|&joint| format!("`{}`", self.model.joint(joint).name))
            .collect();
        let place = joints.join(", ");
        let links: Vec<&str> = bases.iter().map(|&base| self.name_of(base)).collect();
        let name = format!("close_{}", links.join("_"));
        let title = format!("Loop {}, closed by {place}.", self.loops);
        let block = self.builder.block(name.clone(), title);
        let equation = Equation::new(&mut self.builder, &self.placement, closing);
        for ring in &equation.rings {
            self.builder.name_vector(ring.offset, "known");
        }
        let first = self.placement.base(closing.first().from);
        let choice = self.choice();
        if (choice.solver == Solver::ClosedForm || choice.changes_branch())
            && let Some(solution) = self.in_closed_form(block, closing, &equation, (first, &place))
        {
            equation.place(&mut self.builder, &mut self.placement, closing, &solution);
            for &base in &bases {
                self.name_cluster(base);
            }
            self.closed(Closing {
                number: self.loops - 1,
                name,
                place,
                equation,
                solution,
                tied: None,
            });
            return;
        }
        let triad = Triad::of(closing, |axis| self.placement.base(axis));
        let tied = (!closing.ties.is_empty()).then(|| self.tied(closing, &equation, first));
        self.builder.enter();
        let (mut newton, solution, side) = match (&tied, &triad) {
            (Some(tied), _) => self.iterate_tied(block, tied, &equation, first),
            (None, Some(triad)) => self.contract(block, triad, first),
            (None, None) => self.iterate(block, &equation, first),
        };
        newton.place.clone_from(&place);
        newton.sides.extend(self.spots(closing));
        self.builder.leave();
        if let Some(side) = side {
            self.watch_coupled(block, &newton, side);
        }
        let solution = match (&tied, &triad) {
            (Some(tied), _) => {
                let all = self.all_directions(tied, &equation, &solution);
                let turned = self.rounded_by_turns(tied, &equation, &solution);
                self.watch_tied(block, tied, &equation, &all, turned);
                all
            }
            (None, Some(triad)) => self.expand(triad, &equation, &solution),
            (None, None) => {
                self.watch_iteration(block, &equation, &solution);
                solution
            }
        };
        if let Some(block) = self.builder.blocks.last_mut() {
            block.kind = BlockKind::Newton(newton);
        }
        equation.place(&mut self.builder, &mut self.placement, closing, &solution);
        for &base in &bases {
            self.name_cluster(base);
        }
        self.closed(Closing {
            number: self.loops - 1,
            name,
            place,
            equation,
            solution,
            tied,
        });
    }

    /// Closes a loop in closed form, if it has one.
    fn in_closed_form(
        &mut self,
        block: BlockId,
        closing: &Loop,
        equation: &Equation<Value>,
        (first, place): (LinkId, &str),
    ) -> Option<Vec<Solution<Value>>> {
        let firsts: Vec<First> = equation
            .unknowns
            .iter()
            .map(|unknown| self.first(*unknown, first))
            .collect();
        let solutions: Vec<Solution<Value>> = firsts.iter().map(|(_, first)| *first).collect();
        let choice = self.choice();
        let (closed, solution) = self.dyad(closing, equation, &solutions, &choice)?;
        let is = Watchable {
            has_branch: closed.has_branches && choice.changes_branch(),
            iterated: false,
        };
        self.watch_loop(block, [closed.sine, closed.rounding_square], is);
        for ((name, _), solution) in firsts.iter().zip(&solution) {
            match *solution {
                Solution::Direction(direction) => {
                    self.builder.name_direction(direction, name);
                }
                Solution::Slide(displacement) => {
                    self.builder.name(displacement, name);
                }
            }
        }
        let numbers = solution.iter().flat_map(|found| match *found {
            Solution::Direction(direction) => direction.to_vec(),
            Solution::Slide(displacement) => vec![displacement],
        });
        let closed = ClosedForm {
            place: place.to_owned(),
            found: numbers.collect(),
            ..closed
        };
        if let Some(block) = self.builder.blocks.last_mut() {
            block.kind = BlockKind::ClosedForm(closed);
        }
        Some(solution)
    }

    /// Where the axes of the rings are in their links and in the first cluster: rounding grows with these too.
    fn spots(&mut self, closing: &Loop) -> Vec<[Value; 2]> {
        let mut spots = Vec::new();
        for ring in &closing.rings {
            for axis in ring
                .iter()
                .flat_map(|connection| [connection.from, connection.to])
            {
                spots.push(self.builder.place(self.model.axis(axis)));
            }
            let ends = ring.first().map(|connection| connection.from).into_iter();
            for axis in ends.chain(ring.last().map(|connection| connection.to)) {
                spots.push(self.placement.spot(&mut self.builder, axis));
            }
        }
        spots
    }

    /// How far a loop has grown where something slides: a telescope may become any times longer than it is at the start.
    pub(super) fn extent(
        &mut self,
        equation: &Equation<Value>,
        now: &[Solution<Value>],
    ) -> Option<Value> {
        let slides = |joint: &Joint| matches!(joint.kind, JointKind::Prismatic(..));
        let varying = self.varying_extent(equation);
        if !self.model.joints.iter().any(slides) {
            return varying;
        }
        let displacements = now.iter().filter_map(|solution| match solution {
            Solution::Slide(displacement) => Some(*displacement),
            Solution::Direction(_) => None,
        });
        let mut extent = self.builder.constant(0.0);
        for length in displacements.chain(equation.rings.iter().flat_map(|ring| ring.offset)) {
            let length = self.builder.abs(length);
            extent = self.builder.add(extent, length);
        }
        if let Some(varying) = varying {
            extent = self.builder.add(extent, varying);
        }
        Some(self.builder.name(extent, "extent"))
    }

    /// How many rounds a loop takes that is iterated.
    fn rounds(&self) -> Rounds {
        match self.choice().solver {
            Solver::ClosedForm => Rounds::UntilClosed(MOST_ROUNDS),
            Solver::Linear => Rounds::Exactly(1),
            Solver::Newton(rounds) => rounds,
        }
    }

    /// How far a loop has grown; one of one unknown, whose joints hold again what earlier loops hold, closes as well as these know it.
    fn redundant_extent(
        &mut self,
        equation: &Equation<Value>,
        now: &[Solution<Value>],
    ) -> Option<Value> {
        let extent = self.extent(equation, now);
        let linear = self.choice().solver == Solver::Linear;
        let accepted = self.rounds().accept(linear, self.model.precision.epsilon());
        let doubt = (now.len() == 1).then(|| self.doubt(accepted)).flatten();
        match (extent, doubt) {
            (Some(extent), Some(doubt)) => Some(self.builder.add(extent, doubt)),
            (extent, doubt) => extent.or(doubt),
        }
    }

    /// The pose that the last position left behind. A die was where the pin and the guide of its slot were.
    pub(super) fn last_pose(&mut self, link: LinkId) -> Pose<Value> {
        if let Some((pin, guide)) = self.model.link(link).die {
            let (pin, guide) = (self.model.axis(pin), self.model.axis(guide));
            let origin = self.last_pose(pin.link).carry(&mut self.builder, pin);
            let direction = self.last_pose(guide.link).heading(&mut self.builder, guide);
            return Pose { direction, origin };
        }
        match number_among_all(link) {
            None => Pose::identity(&mut self.builder),
            Some(index) => {
                let [cos, sin, x, y] =
                    Part::ALL.map(|part| self.builder.make(Op::Last(Slot::Pose(index, part))));
                Pose {
                    direction: [cos, sin],
                    origin: [x, y],
                }
            }
        }
    }

    /// The name of an unknown and where the iteration starts: at the last position.
    pub(super) fn first(&mut self, unknown: Unknown, base: LinkId) -> First {
        match unknown {
            Unknown::Direction(link) => {
                let frame = self.last_pose(base).direction;
                let back = self.builder.conjugate(frame);
                let direction = self.last_pose(link).direction;
                let direction = self.builder.turned(back, direction);
                let name = self.name_of(link).to_owned();
                let direction = self.normalised(direction, &name);
                (name, Solution::Direction(direction))
            }
            Unknown::Slide(joint) => {
                let name = self.model.joint(joint).name.clone();
                let displacement = match self.model.joint(joint).kind {
                    JointKind::Prismatic(from, to) => {
                        let (from, to) = (self.model.axis(from), self.model.axis(to));
                        let (start, end) = (self.last_pose(from.link), self.last_pose(to.link));
                        let heading = start.heading(&mut self.builder, from);
                        let start = start.carry(&mut self.builder, from);
                        let end = end.carry(&mut self.builder, to);
                        let displacement = self.builder.minus(end, start);
                        self.builder.dot(heading, displacement)
                    }
                    _ => self.builder.constant(0.0),
                };
                (name, Solution::Slide(displacement))
            }
        }
    }

    /// The iteration: the gap, its rates, and the next round's unknowns.
    fn iterate(
        &mut self,
        block: BlockId,
        equation: &Equation<Value>,
        base: LinkId,
    ) -> (Newton, Vec<Solution<Value>>, Option<Side>) {
        let firsts: Vec<First> = equation
            .unknowns
            .iter()
            .map(|unknown| self.first(*unknown, base))
            .collect();
        let names: Vec<String> = firsts.iter().map(|(name, _)| name.clone()).collect();
        let (scalars, now) = self.unknowns(block, firsts);
        let residuals = equation.residuals(&mut self.builder, &now);
        self.name_residuals(&residuals, &names);
        let rings = || residuals.rings.iter();
        let columns = all_columns(&residuals, now.len());
        let is_coupled = equation.rings.len() > 1;
        let side = is_coupled
            .then(|| self.keep_coupled_side(&columns))
            .flatten();
        let system = System {
            gap: rings().flat_map(|ring| ring.gap).collect(),
            columns,
            sides: rings()
                .flat_map(|ring| ring.sides.iter().map(|(_, side)| *side))
                .collect(),
            extent: self.redundant_extent(equation, &now),
            legs: Vec::new(),
            angles: is_coupled.then(|| now.iter().map(Solution::is_direction).collect()),
            side: side.map(|side| side.last),
        };
        let (newton, solution) = self.advance(block, &names, scalars, &now, system);
        (newton, solution, side)
    }

    /// The scalars of an iteration, and its unknowns in a round.
    pub(super) fn unknowns(
        &mut self,
        block: BlockId,
        firsts: Vec<First>,
    ) -> (Vec<Scalar>, Vec<Solution<Value>>) {
        let (firsts, histories) = self.predicted(firsts);
        self.histories = histories;
        let mut scalars = Vec::new();
        let now = firsts
            .into_iter()
            .map(|(name, first)| self.unknown(block, &name, first, &mut scalars))
            .collect();
        (scalars, now)
    }

    /// From a round to the next.
    pub(super) fn advance(
        &mut self,
        block: BlockId,
        names: &[String],
        scalars: Vec<Scalar>,
        now: &[Solution<Value>],
        system: System,
    ) -> (Newton, Vec<Solution<Value>>) {
        let System {
            gap,
            columns,
            sides,
            extent,
            legs,
            angles,
            side,
        } = system;
        let (steps, det) = self.steps(block, &columns, &gap);
        let det = match side {
            Some(side) => {
                let one = self.builder.constant(1.0);
                let sign = self.builder.make(Op::CopySign(one, side));
                self.builder.mul(sign, det)
            }
            None => det,
        };
        let det = self.builder.name(det, "det");
        let step = angles.map(|angles| {
            if let ([turn, x, y], false) = (&steps[..], legs.is_empty()) {
                self.legs_square([*turn, *x, *y], &legs)
            } else {
                self.step_square(&steps, &angles, &sides)
            }
        });
        let linear = self.choice().solver == Solver::Linear;
        let mut next = Vec::new();
        for ((now, step), name) in now.iter().zip(steps).zip(names) {
            match *now {
                Solution::Direction(direction) if linear => {
                    next.extend(self.turned_a_little(direction, step, name));
                }
                Solution::Direction(direction) => {
                    next.extend(self.turned_by(direction, step, name));
                }
                Solution::Slide(displacement) => next.push(self.builder.add(displacement, step)),
            }
        }
        let scalars: Vec<Scalar> = scalars
            .into_iter()
            .zip(next)
            .map(|(scalar, next)| Scalar { next, ..scalar })
            .collect();
        let solution = self.solved(block, now, &scalars);
        let histories = std::mem::take(&mut self.histories);
        self.remember(&histories, &solution);
        let newton = Newton {
            number: self.loops - 1,
            place: String::new(),
            dense: columns.len() > 3,
            scalars,
            gap,
            det,
            columns,
            sides,
            step,
            extent,
            rounds: self.rounds(),
            linear,
            limits: Limits::default(),
        };
        (newton, solution)
    }

    /// The square of a step.
    fn step_square(&mut self, steps: &[Value], angles: &[bool], sides: &[[Value; 2]]) -> Value {
        // Of a whole loop's size, many steps of a part of it would lead far away.
        let length = mean_length(self.size_at_start(sides), sides.len());
        let inverse = self.builder.constant(1.0 / length.max(f64::MIN_POSITIVE));
        let mut sum = self.builder.constant(0.0);
        for (step, is_angle) in steps.iter().zip(angles) {
            let part = if *is_angle {
                *step
            } else {
                self.builder.mul(inverse, *step)
            };
            let square = self.builder.mul(part, part);
            sum = self.builder.add(sum, square);
        }
        sum
    }

    /// The square of a step of a middle link on legs: how far it turns, and how far each leg does.
    fn legs_square(&mut self, [turn, x, y]: [Value; 3], legs: &[([Value; 2], Value)]) -> Value {
        let builder = &mut self.builder;
        let mut sum = builder.mul(turn, turn);
        for &(arm, inverse) in legs {
            let (up, along) = (builder.mul(arm[1], turn), builder.mul(arm[0], turn));
            let moved = [builder.sub(x, up), builder.add(y, along)];
            let turned = builder.scaled(inverse, moved);
            let square = builder.dot(turned, turned);
            sum = builder.add(sum, square);
        }
        sum
    }

    fn name_residuals(&mut self, residuals: &Residuals<Value>, names: &[String]) {
        for ring in &residuals.rings {
            self.builder.name_vector(ring.gap, "gap");
            for &(unknown, side) in &ring.sides {
                if let Some(name) = unknown.map(|unknown| &names[unknown]) {
                    self.builder.name_vector(side, &format!("{name}_side"));
                }
            }
        }
    }

    fn unknown(
        &mut self,
        block: BlockId,
        name: &str,
        first: Solution<Value>,
        scalars: &mut Vec<Scalar>,
    ) -> Solution<Value> {
        let mut scalar = |name: String, first: Value| {
            let now = self.builder.make(Op::Unknown(block, scalars.len()));
            self.builder.begins_with(now, first);
            self.builder.name(now, &name);
            scalars.push(Scalar {
                name,
                first,
                now,
                next: now,
            });
            now
        };
        match first {
            Solution::Direction([cos, sin]) => Solution::Direction([
                scalar(format!("{name}_cos"), cos),
                scalar(format!("{name}_sin"), sin),
            ]),
            Solution::Slide(displacement) => Solution::Slide(scalar(name.to_owned(), displacement)),
        }
    }

    /// The unknowns after the last round.
    fn solved(
        &mut self,
        block: BlockId,
        now: &[Solution<Value>],
        scalars: &[Scalar],
    ) -> Vec<Solution<Value>> {
        let mut index = 0;
        let mut next = || {
            let value = self.builder.make(Op::Solved(block, index));
            self.builder.begins_with(value, scalars[index].first);
            self.builder.name(value, scalars[index].name.clone());
            index += 1;
            value
        };
        let solved = now.iter().map(|unknown| match unknown {
            Solution::Direction(_) => Solution::Direction([next(), next()]),
            Solution::Slide(_) => Solution::Slide(next()),
        });
        solved.collect()
    }
}

/// The mean length of so many sides.
fn mean_length(sum: f64, sides: usize) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "a handful of sides")]
    let count = sides.max(1) as f64;
    sum / count
}
