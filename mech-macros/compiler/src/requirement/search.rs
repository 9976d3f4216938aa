//! The search for the least value of something on boxes of motor values.

use super::bound::Bound;
use super::domain::Ranges;
use super::follow::Follow;
use super::sides::Sides;
use crate::certify::{Enclosure, Interval, Sight};
use crate::program::{Gauge, Value};
use std::collections::BinaryHeap;
use std::f64::consts::{FRAC_PI_2, PI};
use std::rc::Rc;

/// The intervals that may be computed for one requirement: some hundredths of a second of an optimised build.
pub(super) const BUDGET: usize = 2_000_000;

/// Boxes narrower than this part of all values are not cut.
const NARROW: f64 = 1e-13;

/// An angle this near to half a turn from its reference may have passed it.
const CUT: f64 = PI - 1e-6;

/// On the way to a place so many steps may wait.
const MOST_STEPS: usize = 64;

/// So many sets of references are kept with their enclosures.
const KEPT: usize = 16;

/// Where angles over whole turns are counted from: valid at a place, and wherever they stay within half a turn on the way from there.
#[derive(Debug)]
struct Frame {
    references: Vec<f64>,
    at: Vec<f64>,
}

/// What is seen on a box.
struct Seen {
    sight: Sight,
    /// Whether an angle may have passed half a turn from its reference there.
    is_cut: bool,
    /// The value, with its sign.
    value: Interval,
    /// The value at the middle, where all loops close there.
    centre: Option<Interval>,
    /// Whether no loop can go over to its other side there.
    is_clear: bool,
}

/// A search through the values of the motors.
pub(super) struct Search<'a> {
    gauge: &'a Gauge,
    ranges: &'a Ranges,
    found: &'a [Value],
    sides: Sides<'a>,
    /// The numbers that sum up the motion, as far as they are known.
    summaries: Vec<(usize, Interval)>,
    enclosures: Vec<(Vec<f64>, Enclosure<'a>)>,
    start: Rc<Frame>,
    /// The angles as the mechanism moves, where loops may change their side.
    follow: Option<Follow>,
    left: usize,
}

/// What is asked for: the least of a value times its sign.
#[derive(Clone, Copy, Debug)]
pub(super) struct Goal {
    pub(super) value: Value,
    pub(super) sign: f64,
}

impl<'a> Search<'a> {
    /// A search that may compute so many intervals, where loops have these sides.
    pub(super) fn new(
        gauge: &'a Gauge,
        ranges: &'a Ranges,
        found: &'a [Value],
        sides: Sides<'a>,
        left: usize,
    ) -> Self {
        let position = &gauge.program.start;
        let is_followed = sides.are_told() && !gauge.angles.is_empty();
        let motor = ranges.only_motor().filter(|_| is_followed);
        let follow = motor.map(|(motor, _)| Follow::new(gauge, motor));
        let references = gauge.angles.iter();
        let references = references.map(|angle| position.state[angle.reference]);
        let start = Frame {
            references: references.collect(),
            at: position.motors.clone(),
        };
        Self {
            gauge,
            ranges,
            found,
            sides,
            summaries: Vec::new(),
            enclosures: Vec::new(),
            start: Rc::new(start),
            follow,
            left,
        }
    }

    /// Whether the loops are nowhere on these sides, but within rounding of where they change them.
    pub(super) fn is_nowhere(&self, bound: &Bound) -> bool {
        bound.is_complete && bound.place.is_empty() && self.sides.are_told()
    }

    /// The intervals that may still be computed.
    pub(super) fn left(&self) -> usize {
        self.left
    }

    /// Puts in a number that sums up the motion.
    pub(super) fn put(&mut self, state: usize, value: Interval) {
        self.summaries.push((state, value));
        self.enclosures.clear();
    }

    /// The enclosure for these references, by its number; none if one run of it would take too long.
    fn enclosure(&mut self, references: &[f64]) -> Option<usize> {
        let mut known = self.enclosures.iter();
        if let Some(number) = known.position(|(own, _)| own == references) {
            return Some(number);
        }
        let angles = self.gauge.angles.iter().zip(references);
        let angles = angles.map(|(angle, at)| (angle.reference, Interval::point(*at)));
        let carried: Vec<(usize, Interval)> =
            angles.chain(self.summaries.iter().copied()).collect();
        let made = Enclosure::new(
            &self.gauge.program,
            self.sides.turned(),
            &carried,
            self.found,
        )?;
        if self.enclosures.len() == KEPT {
            self.enclosures.remove(0);
        }
        self.enclosures.push((references.to_vec(), made));
        Some(self.enclosures.len() - 1)
    }

    /// Looks at a box; nothing if that cannot be paid.
    fn look(&mut self, place: &[Interval], frame: &Frame, goal: Goal) -> Option<Seen> {
        let number = self.enclosure(&frame.references)?;
        let (_, enclosure) = &mut self.enclosures[number];
        self.left = self.left.checked_sub(enclosure.cost())?;
        let sight = enclosure.run(place);
        let mut angles = self.gauge.angles.iter();
        let is_cut = angles.any(|angle| enclosure.on_box(angle.beyond).abs().high() > CUT);
        let sign = Interval::point(goal.sign);
        let closes = sight != Sight::Blocked && enclosure.closes_at_centre() && !is_cut;
        Some(Seen {
            sight,
            is_cut,
            value: if is_cut {
                Interval::ENTIRE
            } else {
                sign * enclosure.on_box(goal.value)
            },
            centre: closes.then(|| sign * enclosure.at_centre(goal.value)),
            is_clear: enclosure.is_clear(self.sides.crossing()),
        })
    }

    /// A frame that is valid at a place: angles are followed from where another one is.
    fn frame_at(&mut self, from: &Rc<Frame>, to: &[f64], goal: Goal) -> Option<Rc<Frame>> {
        if self.gauge.angles.is_empty() {
            return Some(Rc::clone(from));
        }
        if let Some(follow) = &mut self.follow {
            let references = follow.angles_at(to)?;
            return Some(Rc::new(Frame {
                references: quarters(&references),
                at: to.to_vec(),
            }));
        }
        let mut here = Rc::clone(from);
        let mut waiting = vec![to.to_vec()];
        while let Some(next) = waiting.pop() {
            let ends = here.at.iter().zip(&next);
            let way: Vec<Interval> = ends.map(|(a, b)| Interval::new(*a, *b)).collect();
            if self.look(&way, &here, goal)?.is_cut {
                let middle: Vec<f64> = way.iter().map(|way| way.middle()).collect();
                if waiting.len() == MOST_STEPS || middle == next || middle == here.at {
                    return None;
                }
                waiting.extend([next, middle]);
                continue;
            }
            let references = self.angles_at(&here, &next, goal)?;
            here = Rc::new(Frame {
                references: quarters(&references),
                at: next,
            });
        }
        Some(here)
    }

    /// The angles at a place where a frame is valid.
    fn angles_at(&mut self, frame: &Frame, place: &[f64], goal: Goal) -> Option<Vec<f64>> {
        let point: Vec<Interval> = place.iter().copied().map(Interval::point).collect();
        self.look(&point, frame, goal)?;
        let number = self.enclosure(&frame.references)?;
        let enclosure = &self.enclosures[number].1;
        let angles = self.gauge.angles.iter().zip(&frame.references);
        let angles = angles.map(|(angle, from)| from + enclosure.on_box(angle.beyond).middle());
        Some(angles.collect())
    }

    /// Whether all angles are what they were after each motor that goes right round has done so; else the first motor that changes one.
    pub(super) fn endless(&mut self, goal: Goal) -> Option<Result<(), usize>> {
        if self.gauge.angles.is_empty() {
            return Some(Ok(()));
        }
        let start = Rc::clone(&self.start);
        for &motor in &self.ranges.round {
            let range = self.ranges.all[motor];
            let mut angles = Vec::new();
            for end in [range.low(), range.high()] {
                let mut place = start.at.clone();
                place[motor] = end;
                let frame = self.frame_at(&start, &place, goal)?;
                angles.push(self.angles_at(&frame, &place, goal)?);
            }
            let mut both = angles[0].iter().zip(&angles[1]);
            if both.any(|(a, b)| (a - b).abs() > 1.0) {
                return Some(Err(motor));
            }
        }
        Some(Ok(()))
    }

    /// A value at a place. That costs little, and can be had when nothing is left.
    pub(super) fn value_at(&mut self, place: &[f64], value: Value) -> Option<Interval> {
        let left = std::mem::replace(&mut self.left, BUDGET);
        let found = self.find_at(place, value);
        self.left = left;
        found
    }

    fn find_at(&mut self, place: &[f64], value: Value) -> Option<Interval> {
        let goal = Goal { value, sign: 1.0 };
        let frame = self.frame_at(&Rc::clone(&self.start), place, goal)?;
        let point: Vec<Interval> = place.iter().copied().map(Interval::point).collect();
        let seen = self.look(&point, &frame, goal)?;
        Some(seen.value)
    }

    /// Bounds the least value, until `is_enough`, or so many intervals are spent.
    pub(super) fn least(
        &mut self,
        goal: Goal,
        spend: usize,
        is_enough: impl Fn(&Bound) -> bool,
    ) -> Bound {
        let reserve = self.left.saturating_sub(spend);
        let mut bound = Bound::default();
        let mut waiting = BinaryHeap::new();
        let from = self.start_within();
        let Some(frame) = self.frame_at(&Rc::clone(&self.start), &from, goal) else {
            return bound;
        };
        for corner in self.corners() {
            if let Some(frame) = self.frame_at(&frame, &corner, goal) {
                let point: Vec<Interval> = corner.iter().copied().map(Interval::point).collect();
                if let Some(seen) = self.look(&point, &frame, goal) {
                    self.see(&mut bound, seen.centre, &corner);
                }
            }
        }
        waiting.push(Waiting {
            least: f64::NEG_INFINITY,
            place: self.ranges.all.clone(),
            frame,
            is_known: !self.sides.are_told(),
        });
        let mut stuck = f64::INFINITY;
        while let Some(next) = waiting.pop() {
            bound.proved = next.least.min(stuck).min(bound.seen);
            if is_enough(&bound) || self.left <= reserve {
                return bound;
            }
            let Some(seen) = self.look(&next.place, &next.frame, goal) else {
                return bound;
            };
            if seen.sight == Sight::Blocked {
                continue;
            }
            let centre: Vec<f64> = next.place.iter().map(|range| range.middle()).collect();
            let is_known = next.is_known || seen.is_clear;
            if is_known && !next.is_known && !self.sides.are_reached(&centre) {
                continue;
            }
            self.see(&mut bound, seen.centre, &centre);
            let least = next.least.max(seen.value.low());
            // Nothing there is less than what was seen.
            if least >= bound.seen {
                continue;
            }
            let Some(halves) = self.halves(&next.place) else {
                stuck = stuck.min(least);
                continue;
            };
            for place in halves {
                let Some(frame) = self.frame_in(&place, &next.frame, seen.is_cut, goal) else {
                    return bound;
                };
                waiting.push(Waiting {
                    least,
                    place,
                    frame,
                    is_known,
                });
            }
        }
        bound.proved = stuck.min(bound.seen);
        bound.is_complete = true;
        bound
    }

    /// Takes a value at a place, if the loops come to their sides there.
    fn see(&mut self, bound: &mut Bound, value: Option<Interval>, place: &[f64]) {
        if value.is_some_and(|value| value.high() < bound.seen) && self.sides.are_reached(place) {
            bound.see(value, place);
        }
    }

    /// A frame for a part of a box, of which another one is known to be valid at a place.
    fn frame_in(
        &mut self,
        place: &[Interval],
        of_whole: &Rc<Frame>,
        is_cut: bool,
        goal: Goal,
    ) -> Option<Rc<Frame>> {
        if self.follow.is_some() {
            let centre: Vec<f64> = place.iter().map(|range| range.middle()).collect();
            return self.frame_at(of_whole, &centre, goal);
        }
        let near = |(range, at): (&Interval, &f64)| at.max(range.low()).min(range.high());
        let nearest: Vec<f64> = place.iter().zip(&of_whole.at).map(near).collect();
        if nearest == of_whole.at {
            return Some(Rc::clone(of_whole));
        }
        if is_cut {
            return self.frame_at(of_whole, &nearest, goal);
        }
        // It is valid on the whole box.
        let references = of_whole.references.clone();
        Some(Rc::new(Frame {
            references,
            at: nearest,
        }))
    }

    /// The start, or the nearest place to it that is asked about.
    fn start_within(&self) -> Vec<f64> {
        let all = self.start.at.iter().zip(&self.ranges.all);
        all.map(|(at, range)| at.max(range.low()).min(range.high()))
            .collect()
    }

    /// The corners of all values, and the start.
    fn corners(&self) -> Vec<Vec<f64>> {
        let mut corners = vec![self.start_within()];
        for &motor in self.ranges.motors.iter().take(3) {
            let range = self.ranges.all[motor];
            let moved = corners.iter().flat_map(|corner| {
                [range.low(), range.high()].map(|end| {
                    let mut moved = corner.clone();
                    moved[motor] = end;
                    moved
                })
            });
            let moved: Vec<Vec<f64>> = moved.collect();
            corners.truncate(1);
            corners.extend(moved);
        }
        corners
    }

    /// A box cut across its longest side, if that can be cut.
    fn halves(&self, place: &[Interval]) -> Option<[Vec<Interval>; 2]> {
        let part = |motor: &usize| {
            let whole = self.ranges.all[*motor].width();
            if whole > 0.0 {
                place[*motor].width() / whole
            } else {
                0.0
            }
        };
        let longest = self.ranges.motors.iter().copied();
        let longest = longest.max_by(|a, b| part(a).total_cmp(&part(b)))?;
        let range = place[longest];
        let middle = range.middle();
        if part(&longest) <= NARROW || !(range.low() < middle && middle < range.high()) {
            return None;
        }
        Some([range.low(), range.high()].map(|end| {
            let mut half = place.to_vec();
            half[longest] = Interval::new(middle, end);
            half
        }))
    }
}

/// Angles rounded to quarters of a turn: near enough for references, of which there are few then.
fn quarters(angles: &[f64]) -> Vec<f64> {
    let quarter = |angle: &f64| (angle / FRAC_PI_2).round() * FRAC_PI_2;
    angles.iter().map(quarter).collect()
}

/// A box that waits, with a bound on what is least there.
struct Waiting {
    least: f64,
    place: Vec<Interval>,
    frame: Rc<Frame>,
    /// Whether the loops certainly come to their sides there, or that is not asked.
    is_known: bool,
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Waiting {}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Waiting {
    /// The least comes first.
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        other.least.total_cmp(&self.least)
    }
}
