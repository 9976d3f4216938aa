//! Links that are taken farther out by all motors together: to where each alone takes them farthest, and on from there up slopes.

use super::Survey;
use super::WELL_KNOWN;
use super::line::{Line, Sample};
use super::seen::{SIDES, outwards};
use crate::plan::Halton;
use crate::program::Position;
use std::rc::Rc;

/// So many positions are tried, for each motor of an arm, in which all its motors have moved.
const TOGETHER: usize = 12;
/// Links that are taken outwards on each side: of loops, and of arms, which cost less.
const CLIMBS: [usize; 2] = [1, 2];
/// Rounds on the way outwards, and those of them that may lead nowhere.
const ROUNDS: usize = 6;
const FRUITLESS: usize = 2;
/// The first step and the longest, as parts of what is tried of motors; a step that leads nowhere is shortened to this part.
const FIRST_STEP: f64 = 1.0 / 16.0;
const FARTHEST_STEP: f64 = 0.5;
const SHORTER: f64 = 0.25;
/// By so small a step of a motor, as a part of its range, a slope is measured.
const NUDGE: f64 = 1e-6;
/// The sine below which a loop is near its end, and that below which it is too near to tell a slope.
const NEAR_END: f64 = 0.6;
const AT_END: f64 = 0.3;

/// The farthest that a link was seen out on a side, and the position there. If a loop is at its end there, the position before.
struct Top {
    side: usize,
    link: usize,
    out: f64,
    from: Rc<Position<f64>>,
}

/// The place of a link on a side, greater farther out, and its rates with the motors. With them stand the rates of the squared sine of the
/// loop that is nearest to its end.
struct Slope {
    here: f64,
    out: Vec<f64>,
    sine: Vec<f64>,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// A vector plus so many times another.
fn plus(a: &[f64], times: f64, b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + times * b).collect()
}

impl Survey<'_> {
    /// Moves an arm to combinations of its motors' values, evenly distributed.
    fn visit_combinations(&mut self) {
        let mut points = Halton::default();
        for _ in 0..TOGETHER * self.ranges.len() {
            let ranges = self.ranges.iter().enumerate();
            let mut target: Vec<f64> = ranges
                .map(|(motor, ([low, high], _))| low + (high - low) * points.at(motor))
                .collect();
            target.extend_from_slice(&self.program.start.motors[target.len()..]);
            if self.visit(&target).is_none() {
                return;
            }
            self.together.append(&mut self.passed);
            points.advance();
        }
    }

    /// Moves all motors together: each link to where every motor alone takes it farthest out, and on from there.
    pub(super) fn climb_all(&mut self) {
        if self.program.is_function() {
            self.visit_combinations();
        }
        let is_arm = self.program.is_function();
        let of_side = |side: usize| {
            let links = (0..self.links.len()).filter(|&link| self.is_shared[link]);
            // A combination may have taken an arm farther out than its motors alone do.
            let may_go_on = |&(out, link): &(f64, usize)| {
                let farthest = if is_arm { self.most[link][side] } else { out };
                farthest >= self.sides[side]
            };
            let mut links: Vec<(f64, usize)> =
                links.map(|link| (self.expected(side, link).0, link)).filter(may_go_on).collect();
            links.sort_by(|a, b| b.0.total_cmp(&a.0));
            links
        };
        let links = SIDES.map(of_side);
        for rank in 0..CLIMBS[usize::from(is_arm)] {
            for side in SIDES {
                if let Some(&(out, link)) = links[side].get(rank)
                    && (rank == 0 || out > self.sides[side])
                {
                    self.climb(side, link);
                }
            }
        }
    }

    /// Returns a link's expected place on a side if the effects of all motors add up. With it come the motors' values there, and a position
    /// on the way of the motor that does most.
    fn expected(&self, side: usize, link: usize) -> (f64, Vec<f64>, Rc<Position<f64>>) {
        let out = |sample: &&Sample| sample.links[link].sides[side];
        let mut from = Rc::new(self.program.start.clone());
        let mut motors = from.motors.clone();
        let start = self.start[link].sides[side];
        let (mut expected, mut most) = (start, 0.0);
        for line in &self.lines {
            let best = line.samples.iter().max_by(|a, b| out(a).total_cmp(&out(b)));
            if let Some(best) = best.filter(|best| out(best) > start) {
                let gain = out(&best) - start;
                expected += gain;
                motors[line.motor] = best.at;
                if gain > most {
                    (from, most) = (self.before_end(line, best.at), gain);
                }
            }
        }
        (expected.min(self.most[link][side]), motors, from)
    }

    /// The position of a line nearest to a value of its motor where no loop is at its end.
    fn before_end(&self, line: &Line, at: f64) -> Rc<Position<f64>> {
        let samples = line.samples.iter();
        let clear = samples.filter(|sample| !self.is_at_end(&sample.position));
        let away = |sample: &&Sample| (sample.at - at).abs();
        let nearest = clear.min_by(|a, b| away(a).total_cmp(&away(b)));
        nearest.map_or_else(
            || Rc::new(self.program.start.clone()),
            |sample| Rc::clone(&sample.position),
        )
    }

    /// Whether a loop is too near its end to tell how things change.
    fn is_at_end(&self, position: &Position<f64>) -> bool {
        let mut watches = self.program.watches.iter();
        watches.any(|watch| position.state[watch.sine].abs() < AT_END)
    }

    /// Takes a link farther out on a side as long as it can: up the slope, or, at the end of a loop, along that end.
    fn climb(&mut self, side: usize, link: usize) {
        let (_, motors, from) = self.expected(side, link);
        self.walker.begin_roughly(&from);
        let out = self.seen.of_link(link, from.poses[link]).sides[side];
        let mut top = Top { side, link, out, from };
        if self.visit(&motors).is_none() {
            return;
        }
        self.note(&mut top);
        for (position, links) in &self.together {
            if links[link].sides[side] > top.out {
                (top.out, top.from) = (links[link].sides[side], Rc::clone(position));
            }
        }
        let mut step = FIRST_STEP;
        let mut last: Option<[Vec<f64>; 2]> = None;
        let mut fruitless = 0;
        for _ in 0..ROUNDS {
            let from = Rc::clone(&top.from);
            let before = top.out;
            let Some(Slope { here, out, sine }) = self.slope(&top) else {
                return;
            };
            let inwards = dot(&out, &sine);
            let is_at_end = inwards < 0.0;
            let mut along = out.clone();
            if is_at_end {
                along = plus(&out, -inwards / dot(&sine, &sine), &sine);
            } else if let Some([slope, way]) = &last {
                // The way before was climbed already.
                let part = dot(&out, &plus(&out, -1.0, slope)) / dot(slope, slope);
                along = plus(&out, part.max(0.0), way);
            }
            self.walker.begin_roughly(&from);
            let Some(there) = self.move_along(&mut top, &along, step) else {
                return;
            };
            if is_at_end {
                self.move_along(&mut top, &out, FARTHEST_STEP);
            } else {
                let rise = step * dot(&out, &along) / dot(&along, &along).sqrt();
                let best = 0.5 * step * rise / (here + rise - there);
                if best > 0.0 && best < FARTHEST_STEP {
                    let near = self.walker.here();
                    self.walker.begin_roughly(&from);
                    self.walker.know(near);
                    self.move_along(&mut top, &along, best);
                    step = best;
                }
            }
            last = (!is_at_end).then_some([out, along]);
            let gain = top.out - before;
            step = (step * if gain > 0.0 { 2.0 } else { SHORTER }).min(FARTHEST_STEP);
            fruitless += usize::from(gain < WELL_KNOWN * self.width());
            if fruitless == FRUITLESS {
                return;
            }
        }
    }

    /// Notes where on the last move something came farther out.
    fn note(&self, top: &mut Top) {
        let mut from = Rc::clone(&top.from);
        for (position, links) in &self.passed {
            if !self.is_at_end(position) {
                from = Rc::clone(position);
            }
            let out = links[top.link].sides[top.side];
            if out > top.out {
                (top.out, top.from) = (out, Rc::clone(&from));
            }
        }
    }

    /// Finds the rates of a link's place on a side with the motors, in parts of the motors' ranges; none if nothing moves it.
    fn slope(&mut self, top: &Top) -> Option<Slope> {
        let Top { side, link, from, .. } = top;
        let seen = self.seen.of_link(*link, from.poses[*link]);
        let here = seen.sides[*side];
        let point = *self.seen.moving[*link].get(seen.points[*side] as usize)?;
        let sines = self.program.watches.iter().map(|watch| watch.sine);
        let flattest = sines.min_by(|a, b| from.state[*a].abs().total_cmp(&from.state[*b].abs()));
        let flattest = flattest.filter(|&sine| from.state[sine].abs() < NEAR_END);
        let square =
            |position: &Position<f64>| flattest.map_or(0.0, |sine| position.state[sine].powi(2));
        let [mut out, mut sine] = [vec![0.0; self.ranges.len()], vec![0.0; self.ranges.len()]];
        for (motor, ([low, high], is_endless)) in self.ranges.iter().enumerate() {
            for step in [NUDGE, -NUDGE] {
                let mut motors = from.motors.clone();
                motors[motor] += step * (high - low);
                if !is_endless && !(*low..=*high).contains(&motors[motor]) {
                    continue;
                }
                if let Some(beside) = self.walker.beside(from, &motors) {
                    out[motor] = (outwards(point, beside.poses[*link])[*side] - here) / step;
                    sine[motor] = (square(beside) - square(from)) / step;
                    let value = from.motors[motor];
                    let is_beyond = if out[motor] > 0.0 { value >= *high } else { value <= *low };
                    if is_beyond && !is_endless {
                        out[motor] = 0.0;
                    }
                    break;
                }
            }
        }
        (dot(&out, &out) > 0.0).then_some(Slope { here, out, sine })
    }

    /// Moves the motors in a direction, by this part of their ranges. Gives how far out the link then is, if the budget allows it.
    fn move_along(&mut self, top: &mut Top, direction: &[f64], step: f64) -> Option<f64> {
        let length = dot(direction, direction).sqrt();
        let mut target = self.walker.position().motors.clone();
        let parts = target.iter_mut().zip(direction).zip(&self.ranges);
        for ((value, part), ([low, high], is_endless)) in parts {
            *value += step * (high - low) * part / length;
            if !is_endless {
                *value = value.clamp(*low, *high);
            }
        }
        self.visit(&target)?;
        self.note(top);
        let (_, links) = self.passed.last()?;
        Some(links[top.link].sides[top.side])
    }
}
