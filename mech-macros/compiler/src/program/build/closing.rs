//! A loop's iteration: the gap, its rates, and the next round's unknowns.

use super::{MOST_ROUNDS, Writer};
use crate::model::{Joint, JointKind, LinkId, Method};
use crate::plan::{Algebra, ConnectionKind, Equation, Loop, Pose, Solution, Unknown};
use crate::program::BlockKind;
use crate::program::newton::{Limits, Newton, Rounds, Scalar};
use crate::program::node::{BlockId, Op, Part, Slot, Value};

impl Writer<'_> {
    pub(super) fn close(&mut self, ring: &Loop) {
        self.loops += 1;
        let bases = ring
            .ring
            .map(|connection| self.placement.base(connection.from));
        let joints = ring
            .ring
            .map(|connection| self.model.joint(connection.joint).name.clone());
        let links: Vec<&str> = bases[1..].iter().map(|&base| self.name_of(base)).collect();
        let place = joints
            .iter()
            .map(|joint| format!("`{joint}`"))
            .collect::<Vec<_>>()
            .join(", ");
        let name = format!("close_{}", links.join("_"));
        let title = format!("Loop {}, closed by {place}.", self.loops);
        let block = self.builder.block(name, title);
        let Some(equation) = Equation::new(&mut self.builder, &self.placement, ring) else {
            return;
        };
        self.builder.name_vector(equation.offset, "known");
        let firsts = self.firsts(ring, &equation, bases);
        self.builder.enter();
        let (mut newton, solution) = self.iterate(block, &equation, firsts, place);
        self.builder.leave();
        newton.sides.extend(self.spots(ring));
        if let Some(block) = self.builder.blocks.last_mut() {
            block.kind = BlockKind::Newton(newton);
        }
        for connection in ring
            .ring
            .iter()
            .filter(|connection| connection.kind == ConnectionKind::Prismatic)
        {
            let (from, to) = (self.link_of(connection.from), self.link_of(connection.to));
            let fixed = self.builder.constant(connection.frame_angle(self.model));
            self.angles.join(&mut self.builder, from, to, fixed);
        }
        equation.place(&mut self.builder, &mut self.placement, ring, solution);
        bases[1..].iter().for_each(|&base| self.name_cluster(base));
    }

    /// Where the axes of a ring are in their links and in the first cluster: rounding grows with these too.
    fn spots(&mut self, ring: &Loop) -> Vec<[Value; 2]> {
        let [first, _, third] = ring.ring;
        let ends = ring
            .ring
            .iter()
            .flat_map(|connection| [connection.from, connection.to]);
        let mut spots: Vec<[Value; 2]> = ends
            .map(|axis| self.builder.vector(self.model.axis(axis).at))
            .collect();
        spots.extend(
            [first.from, third.to].map(|axis| self.placement.spot(&mut self.builder, axis)),
        );
        spots
    }

    /// How far a loop has grown where something slides: a telescope may become any times longer than it is at the start.
    fn extent(&mut self, offset: [Value; 2], now: &[Solution<Value>; 2]) -> Option<Value> {
        let slides = |joint: &Joint| matches!(joint.kind, JointKind::Prismatic(..));
        if !self.model.joints.iter().any(slides) {
            return None;
        }
        let ways = now.iter().filter_map(|solution| match solution {
            Solution::Slide(way) => Some(*way),
            Solution::Direction(_) => None,
        });
        let mut extent = self.builder.constant(0.0);
        for length in ways.chain(offset) {
            let length = self.builder.abs(length);
            extent = self.builder.add(extent, length);
        }
        Some(self.builder.name(extent, "extent"))
    }

    /// The pose that the last position left behind.
    fn last_pose(&mut self, link: LinkId) -> Pose<Value> {
        match link.index().checked_sub(1) {
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

    /// For each unknown its name and where the iteration starts: at the last position.
    fn firsts(
        &mut self,
        ring: &Loop,
        equation: &Equation<Value>,
        bases: [LinkId; 3],
    ) -> [(String, Solution<Value>); 2] {
        equation.unknowns.map(|unknown| match unknown {
            Unknown::Direction { cluster, .. } => {
                let link = bases[cluster];
                let frame = self.last_pose(bases[0]).direction;
                let back = self.builder.conjugate(frame);
                let direction = self.last_pose(link).direction;
                let direction = self.builder.turned(back, direction);
                let name = self.name_of(link).to_owned();
                let direction = self.normalised(direction, &name);
                (name, Solution::Direction(direction))
            }
            Unknown::Slide { connection, .. } => {
                let walked = ring.ring[connection];
                let connection = if self.placement.as_declared(walked) {
                    walked
                } else {
                    walked.reversed()
                };
                let (from, to) = (
                    self.model.axis(connection.from).clone(),
                    self.model.axis(connection.to).clone(),
                );
                let (start, end) = (self.last_pose(from.link), self.last_pose(to.link));
                let heading = start.turn(&mut self.builder, from.direction);
                let start = start.carry(&mut self.builder, from.at);
                let end = end.carry(&mut self.builder, to.at);
                let way = self.builder.minus(end, start);
                let way = self.builder.dot(heading, way);
                (
                    self.model.joint(connection.joint).name.clone(),
                    Solution::Slide(way),
                )
            }
        })
    }

    /// One step towards length one, so that rounding never adds up.
    fn normalised(&mut self, v: [Value; 2], name: &str) -> [Value; 2] {
        let square = self.builder.dot(v, v);
        let (half, three) = (self.builder.constant(0.5), self.builder.constant(1.5));
        let half = self.builder.mul(half, square);
        let factor = self.builder.sub(three, half);
        let factor = self.builder.name(factor, format!("{name}_scale"));
        self.builder.scaled(factor, v)
    }

    /// The iteration: the gap, its rates, and the next round's unknowns.
    fn iterate(
        &mut self,
        block: BlockId,
        equation: &Equation<Value>,
        firsts: [(String, Solution<Value>); 2],
        place: String,
    ) -> (Newton, [Solution<Value>; 2]) {
        let mut scalars = Vec::new();
        let names = firsts.each_ref().map(|(name, _)| name.clone());
        let now = firsts.map(|(name, first)| self.unknown(block, &name, first, &mut scalars));
        let (gap, columns, sides) = self.gap(equation, &now, &names);
        let gap = self.builder.name_vector(gap, "gap");
        let det = self.builder.cross(columns[0], columns[1]);
        let det = self.builder.name(det, "det");
        let extent = self.extent(equation.offset, &now);
        let (p, q) = (
            self.builder.cross(columns[1], gap),
            self.builder.cross(gap, columns[0]),
        );
        let steps = [self.builder.div(p, det), self.builder.div(q, det)];
        let mut next = Vec::new();
        for ((now, step), name) in now.iter().zip(steps).zip(&names) {
            match *now {
                Solution::Direction(direction) => {
                    next.extend(self.turned_by(direction, step, name));
                }
                Solution::Slide(way) => next.push(self.builder.add(way, step)),
            }
        }
        let scalars: Vec<Scalar> = scalars
            .into_iter()
            .zip(next)
            .map(|(scalar, next)| Scalar { next, ..scalar })
            .collect();
        let solution = self.solved(block, &now, &scalars);
        let rounds = match self.model.method {
            Method::Newton => Rounds::UntilClosed(MOST_ROUNDS),
            Method::NewtonSteps(rounds) => Rounds::Exactly(rounds),
        };
        let newton = Newton {
            number: self.loops - 1,
            place,
            scalars,
            gap,
            det,
            columns,
            sides,
            extent,
            rounds,
            limits: Limits::default(),
        };
        (newton, solution)
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
            Solution::Slide(way) => Solution::Slide(scalar(name.to_owned(), way)),
        }
    }

    /// The gap, its rate with each unknown, and the vectors it is made of.
    fn gap(
        &mut self,
        equation: &Equation<Value>,
        now: &[Solution<Value>; 2],
        names: &[String; 2],
    ) -> ([Value; 2], [[Value; 2]; 2], Vec<[Value; 2]>) {
        let builder = &mut self.builder;
        let mut gap = equation.offset;
        let mut sides = vec![equation.offset];
        let mut arms: [Option<[Value; 2]>; 2] = equation.unknowns.map(|unknown| match unknown {
            Unknown::Direction { arm, .. } => Some(arm),
            Unknown::Slide { .. } => None,
        });
        let mut slides = [None; 2];
        for (index, unknown) in equation.unknowns.iter().enumerate() {
            if let (
                &Unknown::Slide {
                    along, turned_by, ..
                },
                Solution::Slide(way),
            ) = (unknown, now[index])
            {
                let part = builder.scaled(way, along);
                if let Some(arm) = turned_by.and_then(|turning| arms[turning].as_mut()) {
                    *arm = builder.plus(*arm, part);
                } else {
                    gap = builder.plus(gap, part);
                    sides.push(part);
                }
                slides[index] = Some((along, turned_by));
            }
        }
        let mut columns = [equation.offset; 2];
        for index in 0..2 {
            if let (Some(arm), Solution::Direction(direction)) = (arms[index], now[index]) {
                let side = builder.turned(direction, arm);
                let side = builder.name_vector(side, &format!("{}_side", names[index]));
                gap = builder.plus(gap, side);
                sides.push(side);
                columns[index] = [builder.neg(side[1]), side[0]];
            }
        }
        for (index, slide) in slides.into_iter().enumerate() {
            if let Some((along, turned_by)) = slide {
                columns[index] = match turned_by.map(|turning| now[turning]) {
                    Some(Solution::Direction(direction)) => builder.turned(direction, along),
                    _ => along,
                };
            }
        }
        (gap, columns, sides)
    }

    /// A direction turned by a small angle, by the rational map that keeps its length (Cayley's).
    fn turned_by(&mut self, direction: [Value; 2], angle: Value, name: &str) -> [Value; 2] {
        let builder = &mut self.builder;
        let (half, one) = (builder.constant(0.5), builder.constant(1.0));
        let tangent = builder.mul(half, angle);
        let tangent = builder.name(tangent, format!("{name}_tangent"));
        let square = builder.mul(tangent, tangent);
        let sum = builder.add(one, square);
        let two = builder.constant(2.0);
        // cos = 2/(1 + t²) − 1 and sin = t · 2/(1 + t²), with t the tangent of half the angle.
        let factor = builder.div(two, sum);
        let factor = builder.name(factor, format!("{name}_factor"));
        let turn = [builder.sub(factor, one), builder.mul(tangent, factor)];
        let turn = builder.name_direction(turn, &format!("{name}_turn"));
        builder.turned(direction, turn)
    }

    /// The unknowns after the last round.
    fn solved(
        &mut self,
        block: BlockId,
        now: &[Solution<Value>; 2],
        scalars: &[Scalar],
    ) -> [Solution<Value>; 2] {
        let mut index = 0;
        let mut next = || {
            let value = self.builder.make(Op::Solved(block, index));
            self.builder.name(value, scalars[index].name.clone());
            index += 1;
            value
        };
        now.map(|unknown| match unknown {
            Solution::Direction(_) => Solution::Direction([next(), next()]),
            Solution::Slide(_) => Solution::Slide(next()),
        })
    }
}
