//! The space that a mechanism takes: found by moving it within a budget, and held by what lengths and ranges allow at most.
//!
//! Each motor goes alone through its range or whole turns, then all go together. Between two positions of one motor parabolas tell how far
//! out something may be seen, and there the next position is tried. What is guessed stays in the box, but nothing beyond what [`Bounds`]
//! proves. So the box is as wide as the motion where that was seen well, and never wider than the links reach.

mod bounds;
mod climb;
mod line;
mod seen;

use crate::certify::Interval;
use crate::model::{JointKind, LinkId, Model};
use crate::motion::sweep::{FARTHEST_SLIDE, MostTurns, Sweep, interpolate, sweep_each};
use crate::motion::walk::{Arrival, Walker, price};
use crate::plan::Plan;
use crate::program::{Op, Position, Program};
use bounds::Bounds;
use line::{Line, Sample};
pub(crate) use seen::Reach;
use seen::{EMPTY, Outermost, SIDES, SeenPoints, Sides};
use std::f64::consts::TAU;
use std::rc::Rc;

/// The operations that all of it may cost: some ten milliseconds of an optimised build. A small mechanism may take only a certain number
/// of positions, and so many for each motor.
const BUDGET: usize = 1_500_000;
const POSITIONS: [usize; 2] = [384, 64];
/// The positions that a way may cost if it goes in pieces, and a single move from an outermost position.
const OF_WAY: usize = 128;
const OF_PUSH: usize = 48;
/// The most turns of one motor: behind a worm, a wheel takes so many for a whole turn.
const MOST_TURNS: i64 = 1 << 16;
/// Positions of one turn of the fastest link, at least and at most, and of all turns if that is between.
const OF_TURN: [usize; 2] = [12, 24];
const OF_TURNS: usize = 96;
/// The number of times that a way is continued if it does not end where it began.
const MOST_WAYS: usize = 4;
/// A link without any bound is followed no farther than so many sizes of the mechanism beyond the start. It may fly away where slides
/// become parallel.
const LIMIT: f64 = 32.0;
/// The most positions that are tried between known ones, where something may be farther out.
const BETWEEN: usize = 32;
/// The search ends when no guess exceeds what was seen by more than this part of the box.
const WELL_KNOWN: f64 = 1e-7;
/// A place that is farther out by less than this part of the box may be so by rounding.
const ROUNDING: f64 = 1e-14;
/// Two positions count as equal if their parts differ by less than this part of the mechanism's size.
const SAME: f64 = 1e-6;
/// A reserve for links that several motors move, because not every combination is tried. The box grows to what is proved, if that is
/// within the second part of the motion; else by the first part. The pairs are for positions that depend on the motors alone, for all
/// others, and for a search that was cut short or blocked.
const UNSEEN: [[f64; 2]; 3] = [[0.04, 0.04], [0.1, 0.5], [0.2, 1.5]];

/// An upright box around all that is seen wherever the motors move the mechanism: lower left and upper right corner. What is seen are the
/// shapes of each link, or joints and named points if there is no shape; if there is nothing, the box is the origin.
pub(crate) fn extent(
    model: &Model,
    plan: &Plan,
    program: &Program,
    shapes: &[Vec<Reach>],
) -> [[f64; 2]; 2] {
    let mut survey = Survey::new(model, program, shapes);
    survey.sweep(plan);
    if model.motors.len() > 1 {
        survey.climb_all();
    }
    survey.look_between();
    survey.corners()
}

/// A mechanism that is moved, and the outermost that was seen of it.
struct Survey<'a> {
    model: &'a Model,
    program: &'a Program,
    seen: SeenPoints,
    walker: Walker<'a>,
    size: f64,
    /// The values of each motor that are tried, and whether it may go beyond them.
    ranges: Vec<([f64; 2], bool)>,
    /// The outermost place that each link can have on each side.
    most: Vec<Sides>,
    /// The outermost places that were seen of each link, and of everything.
    links: Vec<Sides>,
    sides: Sides,
    /// The outermost places of each link at the start.
    start: Vec<Outermost>,
    /// For each link whether several motors move it.
    is_shared: Vec<bool>,
    /// The ways of single motors.
    lines: Vec<Line>,
    /// The positions that the last move came past, and how far out links are seen there.
    passed: Vec<(Rc<Position<f64>>, Vec<Outermost>)>,
    /// Positions of all motors together.
    together: Vec<(Rc<Position<f64>>, Vec<Outermost>)>,
    /// Whether a motor was stopped before the end of its way: others may let it go on.
    was_blocked: bool,
    /// Whether some positions could not be paid.
    is_cut_short: bool,
}

impl<'a> Survey<'a> {
    fn new(model: &'a Model, program: &'a Program, shapes: &[Vec<Reach>]) -> Self {
        let seen = SeenPoints::new(model, program, shapes);
        let positions = POSITIONS[0] + POSITIONS[1] * model.motors.len();
        let walker = Walker::new(program, BUDGET.min(positions * price(program)));
        let start = &program.start;
        // A mechanism with all its axes in one place is as large as its shapes.
        let size = if model.size() > 0.0 { model.size() } else { seen.size() };
        let slide = FARTHEST_SLIDE * size;
        let range = |(motor, start): (_, &f64)| {
            let motor: &crate::model::Motor = motor;
            match (motor.range, model.joint(motor.joint).kind) {
                (Some(range), _) => ([range.low, range.high], false),
                (None, JointKind::Revolute(..)) => ([start - 0.5 * TAU, start + 0.5 * TAU], true),
                (None, _) => ([start - slide, start + slide], false),
            }
        };
        let ranges: Vec<([f64; 2], bool)> =
            model.motors.iter().zip(&start.motors).map(range).collect();
        let most = most((model, size), program, &seen, &ranges);
        let mut survey = Self {
            links: vec![EMPTY; seen.moving.len()],
            sides: seen.ground,
            start: seen.outermost(&start.poses),
            is_shared: motors_of_links(program)
                .iter()
                .map(|motors| motors.count_ones() > 1)
                .collect(),
            lines: Vec::new(),
            passed: Vec::new(),
            together: Vec::new(),
            was_blocked: false,
            is_cut_short: false,
            model,
            program,
            seen,
            walker,
            ranges,
            most,
            size,
        };
        survey.look();
        survey
    }

    /// Notes how far out is what is seen where the mechanism is.
    fn look(&mut self) -> Vec<Outermost> {
        self.look_at(&self.walker.here())
    }

    /// The same of another position that it came past.
    fn look_at(&mut self, position: &Position<f64>) -> Vec<Outermost> {
        self.walker.pay(self.seen.count());
        let links = self.seen.outermost(&position.poses);
        let all = self.links.iter_mut().zip(&links).zip(&self.most);
        for ((known, found), most) in all {
            for side in SIDES {
                let out = found.sides[side].min(most[side]);
                known[side] = known[side].max(out);
                self.sides[side] = self.sides[side].max(out);
            }
        }
        links
    }

    /// Moves towards a target as far as it can and looks; none if that cannot be paid.
    fn visit(&mut self, target: &[f64]) -> Option<Arrival> {
        let arrival = self.walker.visit(target);
        if arrival == Arrival::Unpaid {
            self.is_cut_short = true;
            return None;
        }
        self.passed.clear();
        let passed = std::mem::take(&mut self.walker.passed).into_iter().skip(1);
        for position in passed.chain([self.walker.here()]) {
            let links = self.look_at(&position);
            self.passed.push((position, links));
        }
        Some(arrival)
    }

    /// Moves each motor alone.
    fn sweep(&mut self, plan: &Plan) {
        let is_counted = !(self.program.watches.is_empty() && self.program.follows.is_empty());
        let affordable = BUDGET / (self.walker.price * OF_TURN[0]);
        let most_turns = if is_counted {
            MostTurns::OfFastest(
                i64::try_from(affordable).map_or(MOST_TURNS, |turns| turns.min(64)),
            )
        } else {
            MostTurns::OfMotor(MOST_TURNS)
        };
        let (model, size) = (self.model, self.size);
        sweep_each(model, plan, (most_turns, size), &mut |sweep| self.follow(sweep));
    }

    /// Moves one motor along a sweep from the start; returns whether all that is seen on its way was seen then.
    fn follow(&mut self, sweep: &Sweep) -> bool {
        let Sweep { displacements, turns } = sweep;
        let of_turn = if self.ranges.len() > 1 {
            OF_TURN[0]
        } else {
            (OF_TURNS / turns).clamp(OF_TURN[0], OF_TURN[1])
        };
        let samples = of_turn * turns;
        let affordable =
            BUDGET / (4 * (self.walker.price + self.seen.count()) * self.ranges.len().max(1));
        let samples = samples.min(affordable.max(OF_TURN[0]));
        let Some(motor) = displacements.iter().position(|displacement| *displacement != 0.0) else {
            return true;
        };
        self.walker.begin(&self.program.start, OF_WAY);
        // Both ways begin at the start, and are one.
        if let Some(other) = self.lines.iter().find(|line| line.motor == motor) {
            for near in other.samples.iter().take(4).skip(1).rev() {
                self.walker.know(Rc::clone(&near.position));
            }
        }
        let links = self.look();
        let mut way = vec![Sample::new(motor, (self.walker.here(), links))];
        let passes = self.program.passes_change_points();
        let mut goes_on = true;
        let mut ways = 0;
        while goes_on {
            let from = self.walker.position().motors.clone();
            for sample in 1..=samples {
                #[expect(clippy::cast_precision_loss, reason = "a few thousand samples")]
                let part = sample as f64 / samples as f64;
                let Some(arrival) = self.visit(&interpolate(&from, displacements, part)) else {
                    self.is_cut_short = true;
                    goes_on = false;
                    break;
                };
                let passed = self.passed.drain(..);
                way.extend(passed.map(|seen| Sample::new(motor, seen)));
                if arrival == Arrival::Blocked {
                    goes_on = false;
                    break;
                }
            }
            ways += 1;
            let is_endless = self.ranges[motor].1;
            if !(goes_on && is_endless && passes) || self.is_as_at_start() || ways == MOST_WAYS {
                break;
            }
        }
        self.is_cut_short |= self.walker.is_unsure;
        self.add_way(motor, way);
        let at = self.walker.position().motors[motor];
        let ([low, high], is_endless) = self.ranges[motor];
        if !goes_on && (is_endless || low < at && at < high) {
            self.was_blocked = true;
        }
        goes_on && self.is_as_at_start()
    }

    /// Whether every link is where it was at the start.
    fn is_as_at_start(&self) -> bool {
        let poses = self.walker.position().poses.as_flattened();
        let start = self.program.start.poses.as_flattened();
        let size = self.size.max(1.0);
        let mut parts = poses.iter().zip(start);
        parts.all(|(now, start)| (now - start).abs() <= SAME * size)
    }

    /// Adds positions from the start on to the way of a motor.
    fn add_way(&mut self, motor: usize, mut way: Vec<Sample>) {
        let [.., last] = &way[..] else {
            return;
        };
        let forwards = last.at >= way[0].at;
        let known = self.lines.iter_mut().find(|line| line.motor == motor);
        // Both ways begin at the start.
        if let Some(line) = known {
            if forwards {
                line.samples.extend(way.drain(1..));
            } else {
                let rest = way.drain(1..).rev().collect::<Vec<Sample>>();
                line.samples.splice(0..0, rest);
            }
            return;
        }
        if !forwards {
            way.reverse();
        }
        self.lines.push(Line { motor, samples: way, guesses: Vec::new() });
    }

    /// Tries positions between others where something may be farther out than was seen, the farthest first.
    fn look_between(&mut self) {
        let mut lines = std::mem::take(&mut self.lines);
        for line in &mut lines {
            line.guess_all(&self.seen.moving, &self.most, self.sides);
        }
        for _ in 0..BETWEEN {
            let enough = WELL_KNOWN * self.width();
            let Some((line, pair, guess)) = self.farthest(&lines, enough) else {
                break;
            };
            let Line { motor, samples, .. } = &lines[line];
            let [from, to] = [pair, pair + 1].map(|sample| samples[sample].at);
            let mut target = samples[pair].position.motors.clone();
            target[*motor] = guess;
            self.walker.begin(&samples[pair].position, OF_PUSH);
            for near in [pair.saturating_sub(1), pair + 2, pair + 1] {
                if let Some(sample) = samples.get(near) {
                    self.walker.know(Rc::clone(&sample.position));
                }
            }
            let motor = *motor;
            let Some(seen) = self.visit(&target).and_then(|_| self.passed.pop()) else {
                break;
            };
            let sample = Sample::new(motor, seen);
            let is_between = from < sample.at && sample.at < to;
            if !is_between {
                // It is as near to one of them as the motor can be.
                break;
            }
            lines[line].insert((pair, sample), &self.seen.moving, &self.most, self.sides);
        }
        self.lines = lines;
    }

    /// The way and the pair of neighbours with the farthest guess beyond what was seen, and the motor's value there.
    fn farthest(&self, lines: &[Line], enough: f64) -> Option<(usize, usize, f64)> {
        let mut found = None;
        let mut most = enough;
        for (number, line) in lines.iter().enumerate() {
            for (pair, guesses) in line.guesses.iter().enumerate() {
                for side in SIDES {
                    let beyond = guesses[side].out - self.sides[side];
                    if beyond > most {
                        most = beyond;
                        found = Some((number, pair, guesses[side].at));
                    }
                }
            }
        }
        found
    }

    /// The longer side of what was seen.
    fn width(&self) -> f64 {
        let [left, lower, right, upper] = self.sides;
        (left + right).max(lower + upper).max(f64::MIN_POSITIVE)
    }

    fn corners(&self) -> [[f64; 2]; 2] {
        let mut sides = self.sides;
        let guesses = self.lines.iter().flat_map(|line| &line.guesses);
        for guess in guesses.flatten().zip(SIDES.into_iter().cycle()) {
            let (guess, side) = guess;
            sides[side] = sides[side].max(guess.out);
        }
        let several = self.ranges.len() > 1;
        let [unseen, wasteful] = if self.is_cut_short || self.was_blocked {
            UNSEEN[2]
        } else {
            UNSEEN[usize::from(!self.program.is_function())]
        };
        for (link, (seen, most)) in self.links.iter().zip(&self.most).enumerate() {
            let is_moved_by_several = several && (self.was_blocked || self.is_shared[link]);
            if !(is_moved_by_several || self.is_cut_short) {
                continue;
            }
            let motion = (seen[0] + seen[2]).max(seen[1] + seen[3]);
            for side in SIDES {
                let proved = most[side] - seen[side];
                let beyond = if proved <= wasteful * motion { proved } else { unseen * motion };
                sides[side] = sides[side].max(seen[side] + beyond);
            }
        }
        let rounding = ROUNDING * self.width();
        for side in SIDES {
            if sides[side] - self.sides[side] <= rounding {
                sides[side] = self.sides[side];
            }
        }
        let [left, lower, right, upper] = sides;
        if left == f64::NEG_INFINITY {
            return [[0.0; 2]; 2];
        }
        [[-left, -lower], [right, upper]]
    }
}

/// Bounds each link's outermost place on each side, for all values of the motors that are tried.
fn most(
    (model, size): (&Model, f64),
    program: &Program,
    seen: &SeenPoints,
    ranges: &[([f64; 2], bool)],
) -> Vec<Sides> {
    let anywhere = |&(range, is_endless): &([f64; 2], bool)| {
        if is_endless { Interval::ENTIRE } else { Interval::new(range[0], range[1]) }
    };
    let ranges: Vec<Interval> = ranges.iter().map(anywhere).collect();
    let bounds = Bounds::new(model, &ranges);
    let start = seen.outermost(&program.start.poses);
    let start = start
        .iter()
        .fold(seen.ground, |sides, link| SIDES.map(|side| sides[side].max(link.sides[side])));
    let of_link = |(&link, points): (&LinkId, &Vec<Reach>)| {
        let proved = points.iter().fold(EMPTY, |sides, &(at, radius)| {
            let [x, y] = bounds.of_point(link, at);
            let out = [-x.low(), -y.low(), x.high(), y.high()];
            SIDES.map(|side| sides[side].max(radius + out[side]))
        });
        SIDES.map(|side| {
            if proved[side] < f64::INFINITY { proved[side] } else { start[side] + LIMIT * size }
        })
    };
    program.stored.iter().zip(&seen.moving).map(of_link).collect()
}

/// For each stored link the motors that move it, as bits.
fn motors_of_links(program: &Program) -> Vec<u64> {
    let mut motors = vec![0_u64; program.ssa.nodes.len()];
    for value in program.live_values() {
        motors[value.index()] = match program.node(value).op {
            Op::Input(input) | Op::Turns(input) | Op::PartOfTurns(input, ..) => {
                1 << input.index().min(63)
            }
            // An iterated value may depend on all motors.
            Op::Unknown(..) | Op::Solved(..) | Op::Dense(..) => u64::MAX,
            op => op.operands().fold(0, |all, operand| all | motors[operand.index()]),
        };
    }
    let of_pose = |pose: &[_; 4]| {
        pose.iter().fold(0, |all, value: &crate::program::Value| all | motors[value.index()])
    };
    program.poses.iter().map(of_pose).collect()
}
