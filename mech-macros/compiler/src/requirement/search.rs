//! The search for the least value of something on boxes of motor values.

use super::bound::Bound;
use super::domain::Ranges;
use super::sides::{Stretch, Way, spread};
use super::waiting::{Frame, Part, Waiting};
use crate::certify::{Enclosure, Interval, Sight, Sources};
use crate::evaluate::Machine;
use crate::program::{BlockId, Gauge, Position, Value, computing};
use crate::structure::RequirementTrouble;
use std::collections::BinaryHeap;
use std::f64::consts::{FRAC_PI_2, PI};
use std::rc::Rc;

/// The intervals that may be computed for one requirement: some hundredths of a second of an optimised build.
pub(super) const BUDGET: usize = 2_000_000;

/// An angle this near to half a turn from its reference may have passed it.
const CUT: f64 = PI - 1e-6;

/// On the way to a place so many steps may wait.
const MOST_STEPS: usize = 64;

/// So many frames on the way are kept.
const MOST_KNOWN: usize = 256;

/// So many sets of references are kept with their enclosures.
const KEPT: usize = 64;

/// The view of a box.
struct Seen {
    sight: Sight,
    /// Whether an angle may have passed half a turn from its reference there.
    is_cut: bool,
    /// The value, with its sign.
    value: Interval,
    /// The value at the middle, where all loops close there.
    centre: Option<Interval>,
}

/// A search through the values of the motors.
pub(super) struct Search<'a> {
    gauge: &'a Gauge,
    ranges: &'a Ranges,
    found: &'a [Value],
    /// The way to each place, where loops change their side on it and only one motor moves.
    way: Option<&'a Way<'a>>,
    /// The loops that are on the other side than at the start.
    turned: Vec<BlockId>,
    /// The numbers that sum up the motion, as far as they are known.
    summaries: Vec<Sum>,
    enclosures: Vec<Framed<'a>>,
    /// The frame at the start.
    pub(super) start: Rc<Frame>,
    /// The frames on the way.
    known: Vec<Rc<Frame>>,
    budget: usize,
    left: usize,
}

/// A number that sums up the motion.
pub(super) struct Sum {
    /// The state in which it is carried.
    pub(super) state: usize,
    /// Its bounds.
    pub(super) value: Interval,
    /// That between them which is told.
    pub(super) told: f64,
}

/// An enclosure with its references, and the loops that are on the other side than at the start.
struct Framed<'a> {
    references: Vec<f64>,
    turned: Vec<BlockId>,
    enclosure: Enclosure<'a>,
}

/// A goal: to bound the least of some values, each times the sign and with what is added to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Goal<'v> {
    pub(super) values: &'v [(Value, f64)],
    pub(super) sign: f64,
}

impl<'a> Search<'a> {
    /// A search that may compute so many intervals, where these loops are turned.
    pub(super) fn new(
        gauge: &'a Gauge,
        ranges: &'a Ranges,
        found: &'a [Value],
        way: Option<&'a Way<'a>>,
        turned: Vec<BlockId>,
        budget: usize,
    ) -> Self {
        let position = &gauge.program.start;
        let references = gauge.angles.iter();
        let references = references.map(|angle| position.state[angle.reference]);
        let start = Frame {
            references: references.collect(),
            at: position.motors.clone(),
            turned: Vec::new(),
        };
        Self {
            gauge,
            ranges,
            found,
            way,
            turned,
            summaries: Vec::new(),
            enclosures: Vec::new(),
            start: Rc::new(start),
            known: Vec::new(),
            budget,
            left: budget,
        }
    }

    /// The intervals that may still be computed.
    pub(super) fn left(&self) -> usize {
        self.left
    }

    /// The intervals that were computed.
    pub(super) fn spent(&self) -> usize {
        self.budget - self.left
    }

    /// Allows so many intervals from now on.
    pub(super) fn allow(&mut self, count: usize) {
        self.budget = self.spent() + count;
        self.left = count;
    }

    /// Counts what was computed besides intervals.
    pub(super) fn spend(&mut self, count: usize) {
        self.left = self.left.saturating_sub(count);
    }

    /// Puts in a number that sums up the motion.
    pub(super) fn put(&mut self, sum: Sum) {
        self.summaries.retain(|known| known.state != sum.state);
        self.summaries.push(sum);
        self.enclosures.clear();
    }

    /// The numbers that are carried, with these references.
    fn carried(&self, references: &[f64]) -> Vec<(usize, Interval)> {
        let angles = self.gauge.angles.iter().zip(references);
        let angles = angles.map(|(angle, at)| (angle.reference, Interval::point(*at)));
        let sums = self.summaries.iter().map(|sum| (sum.state, sum.value));
        angles.chain(sums).collect()
    }

    /// Values at a position to which the mechanism came, as it computes them there.
    pub(super) fn measure<const N: usize>(
        &mut self,
        position: &Position<f64>,
        values: [Value; N],
    ) -> Option<[f64; N]> {
        let start = Rc::clone(&self.start);
        let frame = self.freely(|search| search.frame_at(&start, &position.motors))?;
        let gauged = &self.gauge.program;
        let program = computing(gauged, &[&values, &gauged.state[..]].concat());
        let mut whole = position.clone();
        whole.state.clone_from(&program.start.state);
        whole.state[..position.state.len()].copy_from_slice(&position.state);
        for (state, number) in self.carried(&frame.references) {
            whole.state[state] = number.middle();
        }
        for sum in &self.summaries {
            whole.state[sum.state] = sum.told;
        }
        let mut machine = Machine::<f64>::new(&program);
        machine.put_back(whole);
        machine.look_at(&position.motors, &values)?.try_into().ok()
    }

    /// The enclosure for these references where these loops are turned; none if one run of it would take too long.
    fn enclosure(&mut self, references: &[f64], turned: &[BlockId]) -> Option<&mut Enclosure<'a>> {
        let is_same = |known: &Framed<'_>| known.references == references && known.turned == turned;
        let number = if let Some(number) = self.enclosures.iter().position(is_same) {
            number
        } else {
            let carried = self.carried(references);
            let program = &self.gauge.program;
            let mut enclosure = Enclosure::new(program, turned, &carried, self.found)?;
            if self.ranges.time.is_some() {
                enclosure.follow_stairs();
            }
            if self.enclosures.len() == KEPT {
                self.enclosures.remove(0);
            }
            self.enclosures.push(Framed {
                references: references.to_vec(),
                turned: turned.to_vec(),
                enclosure,
            });
            self.enclosures.len() - 1
        };
        Some(&mut self.enclosures[number].enclosure)
    }

    /// Runs the enclosure of a frame where these loops are turned; nothing if that cannot be paid. Tells whether an angle may have passed
    /// half a turn from its reference, too.
    fn run(
        &mut self,
        place: &[Interval],
        frame: &Frame,
        turned: &[BlockId],
    ) -> Option<(Sight, bool, &Enclosure<'a>)> {
        let gauge = self.gauge;
        let cost = self.enclosure(&frame.references, turned)?.cost();
        self.left = self.left.checked_sub(cost)?;
        let enclosure = self.enclosure(&frame.references, turned)?;
        let sight = enclosure.run(place);
        let mut angles = gauge.angles.iter();
        let is_cut = angles.any(|angle| enclosure.on_box(angle.beyond).abs().high() > CUT);
        Some((sight, is_cut, enclosure))
    }

    /// Looks at a box; nothing if that cannot be paid.
    fn look(&mut self, place: &[Interval], frame: &Frame, goal: Goal<'_>) -> Option<Seen> {
        let turned = self.turned.clone();
        let (sight, is_cut, enclosure) = self.run(place, frame, &turned)?;
        let sign = Interval::point(goal.sign);
        let closes = sight != Sight::Blocked && enclosure.closes_at_centre() && !is_cut;
        let least = |of: fn(&Enclosure<'a>, Value) -> Interval| {
            let all = goal.values.iter();
            let all =
                all.map(|(value, more)| sign * of(enclosure, *value) + Interval::point(*more));
            all.reduce(Interval::min)
        };
        Some(Seen {
            sight,
            is_cut,
            value: least(Enclosure::on_box).filter(|_| !is_cut).unwrap_or(Interval::ENTIRE),
            centre: least(Enclosure::at_centre).filter(|_| closes),
        })
    }

    /// The way, if angles depend on the sides of loops.
    fn sided(&self) -> Option<&'a Way<'a>> {
        self.way.filter(|_| !self.gauge.angles.is_empty())
    }

    /// Whether an angle may pass half a turn from its reference in a box, on the way from where a frame is valid: with the sides that
    /// loops have there, and those to which they may go over.
    fn is_cut(&mut self, place: &[Interval], frame: &Frame) -> Option<bool> {
        let crossing = self.sided().map_or(&[][..], Way::crossing);
        let (mut any_cut, mut is_paid) = (false, true);
        spread(&frame.turned, |turned| {
            let Some((sight, is_cut, enclosure)) = self.run(place, frame, turned) else {
                is_paid = false;
                return Vec::new();
            };
            if sight == Sight::Blocked {
                return Vec::new();
            }
            any_cut |= is_cut;
            let touching = crossing.iter().copied();
            touching.filter(|block| !enclosure.is_clear(&[*block])).collect()
        });
        is_paid.then_some(any_cut)
    }

    /// A frame that is valid at a place: angles are followed from where another one is.
    fn frame_at(&mut self, from: &Rc<Frame>, to: &[f64]) -> Option<Rc<Frame>> {
        if self.gauge.angles.is_empty() {
            return Some(Rc::clone(from));
        }
        let mut here = self.nearest(to).unwrap_or_else(|| Rc::clone(from));
        let mut waiting = vec![to.to_vec()];
        while let Some(next) = waiting.pop() {
            let ends = here.at.iter().zip(&next);
            let way: Vec<Interval> = ends.map(|(a, b)| Interval::new(*a, *b)).collect();
            if self.is_cut(&way, &here)? {
                let middle: Vec<f64> = way.iter().map(|way| way.middle()).collect();
                if waiting.len() == MOST_STEPS || middle == next || middle == here.at {
                    return None;
                }
                waiting.extend([next, middle]);
                continue;
            }
            let turned = match self.sided() {
                Some(way) => way.turned_at(&next)?,
                None => self.turned.clone(),
            };
            let references = self.angles_at(&here, &next, &turned)?;
            here = Rc::new(Frame { references: quarters(&references), at: next, turned });
            if self.sided().is_some() && self.known.len() < MOST_KNOWN {
                self.known.push(Rc::clone(&here));
            }
        }
        Some(here)
    }

    /// The frame on the way that is nearest to a place.
    fn nearest(&self, to: &[f64]) -> Option<Rc<Frame>> {
        let motor = self.ranges.only_motor()?;
        let far = |frame: &Rc<Frame>| (frame.at[motor] - to[motor]).abs();
        let nearest = self.known.iter().min_by(|a, b| far(a).total_cmp(&far(b)));
        nearest.cloned()
    }

    /// The angles at a place where a frame is valid, with loops on these sides.
    fn angles_at(&mut self, frame: &Frame, place: &[f64], turned: &[BlockId]) -> Option<Vec<f64>> {
        let gauge = self.gauge;
        let (.., enclosure) = self.run(&Interval::points(place), frame, turned)?;
        let angles = gauge.angles.iter().zip(&frame.references);
        let angles = angles.map(|(angle, from)| from + enclosure.on_box(angle.beyond).middle());
        Some(angles.collect())
    }

    /// Tests whether all angles are what they were after each motor that goes right round has done so; nothing if that cannot be paid.
    pub(super) fn come_round(&mut self) -> Option<Result<(), RequirementTrouble>> {
        let gauge = self.gauge;
        if gauge.angles.is_empty() {
            return Some(Ok(()));
        }
        let start = Rc::clone(&self.start);
        for &motor in &self.ranges.round {
            let range = self.ranges.all[motor];
            let mut angles = Vec::new();
            for end in [range.low(), range.high()] {
                let mut place = start.at.clone();
                place[motor] = end;
                let frame = self.frame_at(&start, &place)?;
                angles.push(self.angles_at(&frame, &place, &frame.turned)?);
            }
            let both = angles[0].iter().zip(&angles[1]).zip(&gauge.angles);
            let goes_on = both.filter(|((a, b), _)| (*a - *b).abs() > 1.0);
            let mut goes_on = goes_on.map(|(_, angle)| angle.is_measured);
            if let Some(first) = goes_on.next() {
                let Some(motor) = self.ranges.motor(motor) else {
                    return Some(Err(RequirementTrouble::NoTimes { goes_on: true }));
                };
                return Some(Err(if first || goes_on.any(|is_measured| is_measured) {
                    RequirementTrouble::Endless { motor }
                } else {
                    // A wheel that it drives may take more turns until it is back.
                    RequirementTrouble::NoRange { motor }
                }));
            }
        }
        Some(Ok(()))
    }

    /// Does what costs little, and can be done when nothing is left.
    fn freely<T>(&mut self, act: impl FnOnce(&mut Self) -> T) -> T {
        let left = std::mem::replace(&mut self.left, BUDGET);
        let done = act(self);
        self.left = left;
        done
    }

    /// A value at a place.
    pub(super) fn value_at(&mut self, place: &[f64], value: Value) -> Option<Interval> {
        self.values_at(place, &[value])?.first().copied()
    }

    /// Some values at a place.
    pub(super) fn values_at(&mut self, place: &[f64], values: &[Value]) -> Option<Vec<Interval>> {
        self.freely(|search| {
            let frame = search.frame_at(&Rc::clone(&search.start), place)?;
            let turned = search.turned.clone();
            let (_, is_cut, enclosure) = search.run(&Interval::points(place), &frame, &turned)?;
            let value = |value: &Value| {
                if is_cut { Interval::ENTIRE } else { enclosure.on_box(*value) }
            };
            Some(values.iter().map(value).collect())
        })
    }

    /// A value on a box, with a frame for parts of that, from the frame of a box of which this is a part, or which is beside it; nothing
    /// if that cannot be paid.
    pub(super) fn look_in(
        &mut self,
        place: &[Interval],
        near: &Rc<Frame>,
        value: Value,
    ) -> Option<(Rc<Frame>, Interval)> {
        let frame = self.frame_in(place, near, true)?;
        let goal = Goal { values: &[(value, 0.0)], sign: 1.0 };
        let seen = self.look(place, &frame, goal)?;
        Some((frame, seen.value))
    }

    /// The mean of a value over those of a motor on the box that was looked at last, with its frame.
    pub(super) fn mean(&mut self, frame: &Frame, value: Value, motor: usize) -> Interval {
        let turned = self.turned.clone();
        let enclosure = self.enclosure(&frame.references, &turned);
        enclosure.map_or(Interval::ENTIRE, |enclosure| enclosure.mean(value, motor))
    }

    /// Bounds the least value, until `is_enough`, or so many intervals are spent.
    pub(super) fn least(
        &mut self,
        goal: Goal<'_>,
        spend: usize,
        is_enough: impl Fn(&Bound) -> bool,
    ) -> Bound {
        let reserve = self.left.saturating_sub(spend);
        let mut bound = Bound::default();
        let mut waiting = BinaryHeap::new();
        let from = self.ranges.nearest(&self.start.at);
        let Some(frame) = self.frame_at(&Rc::clone(&self.start), &from) else {
            return bound;
        };
        for corner in self.corners() {
            if let Some(frame) = self.frame_at(&frame, &corner)
                && let Some(seen) = self.look(&Interval::points(&corner), &frame, goal)
            {
                bound.see(seen.centre, &corner);
            }
        }
        for part in self.parts() {
            let Some(frame) = self.frame_in(&part.place, &frame, true) else {
                return bound;
            };
            waiting.push(Waiting { least: f64::NEG_INFINITY, frame, part });
        }
        let values: Vec<Value> = goal.values.iter().map(|(value, _)| *value).collect();
        let mut inputs = Sources::of(&self.gauge.program, &values).inputs.into_iter();
        let is_moving = inputs.any(|motor| self.ranges.motors.contains(&motor));
        let mut stuck = f64::INFINITY;
        while let Some(Waiting { least, part, frame }) = waiting.pop() {
            bound.proved = least.min(stuck).min(bound.seen);
            if is_enough(&bound) || self.left <= reserve {
                return bound;
            }
            let Some(mut seen) = self.look(&part.place, &frame, goal) else {
                return bound;
            };
            if seen.sight == Sight::Blocked {
                continue;
            }
            if part.is_sure {
                let centre: Vec<f64> = part.place.iter().map(|range| range.middle()).collect();
                bound.see(seen.centre, &centre);
            } else if self.sided().is_some() {
                let Some(is_cut) = self.is_cut(&part.place, &frame) else {
                    return bound;
                };
                if is_cut {
                    seen.is_cut = true;
                    seen.value = Interval::ENTIRE;
                }
            }
            let least = least.max(seen.value.low());
            // Nothing there is less than what was seen.
            if least >= bound.seen {
                continue;
            }
            // What nothing moves is the same on all parts.
            let halves = self.ranges.halves(&part.place);
            let Some(halves) = halves.filter(|_| is_moving || seen.is_cut) else {
                stuck = stuck.min(least);
                continue;
            };
            for place in halves {
                let Some(frame) = self.frame_in(&place, &frame, seen.is_cut) else {
                    return bound;
                };
                let part = Part { place, ..part };
                waiting.push(Waiting { least, part, frame });
            }
        }
        bound.proved = stuck.min(bound.seen);
        bound
    }

    /// The parts of all values where the loops have these sides, or may have.
    fn parts(&self) -> Vec<Part> {
        let all = &self.ranges.all;
        let (Some(way), Some(motor)) = (self.way, self.ranges.only_motor()) else {
            return vec![Part { place: all.clone(), is_sure: true }];
        };
        let stretches = way.parts(&self.turned, all[motor]).into_iter();
        let parts = stretches.map(|Stretch { range, is_sure, .. }| {
            let mut place = all.clone();
            place[motor] = range;
            Part { place, is_sure }
        });
        parts.collect()
    }

    /// A frame for a part of a box, of which another one is known to be valid at a place.
    fn frame_in(
        &mut self,
        place: &[Interval],
        of_whole: &Rc<Frame>,
        is_cut: bool,
    ) -> Option<Rc<Frame>> {
        if self.sided().is_some() {
            let centre: Vec<f64> = place.iter().map(|range| range.middle()).collect();
            return self.frame_at(of_whole, &centre);
        }
        let near = |(at, range): (&f64, &Interval)| at.max(range.low()).min(range.high());
        let nearest: Vec<f64> = of_whole.at.iter().zip(place).map(near).collect();
        if nearest == of_whole.at {
            return Some(Rc::clone(of_whole));
        }
        if is_cut {
            return self.frame_at(of_whole, &nearest);
        }
        // It is valid on the whole box.
        let references = of_whole.references.clone();
        Some(Rc::new(Frame { references, at: nearest, turned: of_whole.turned.clone() }))
    }

    /// The places that are looked at first: the start and the corners of all values, or the ends of the parts where the loops have these
    /// sides.
    pub(super) fn corners(&self) -> Vec<Vec<f64>> {
        match (self.way, self.ranges.only_motor()) {
            (Some(way), Some(motor)) => way.places(&self.turned, self.ranges.all[motor]),
            _ => self.ranges.corners(self.ranges.nearest(&self.start.at)),
        }
    }
}

/// Angles rounded to quarters of a turn: near enough for references, of which there are few then.
fn quarters(angles: &[f64]) -> Vec<f64> {
    let quarter = |angle: &f64| (angle / FRAC_PI_2).round() * FRAC_PI_2;
    angles.iter().map(quarter).collect()
}
