//! Looks through the ranges of all motors, box by box.

use super::group::Group;
use super::line::Line;
use super::tape::{Outcome, Tape};
use super::{Blocked, Effort, Interval, Verdict};
use crate::bug::bug;
use crate::program::{BlockId, Program};
use std::collections::VecDeque;

/// How many numbers may be found for one verdict: that takes some hundredths of a second.
const BUDGET: usize = 800_000;

/// The part of it that may be spent on telling what only just closes from what stays clear of that.
const FOR_CLEARANCE: usize = BUDGET / 4;

/// Boxes narrower than this part of the range are not cut to tell whether a slack touches zero or only comes near.
const NEAR: f64 = 1e-8;

/// Boxes narrower than this part of the range are not cut at all.
const NARROW: f64 = 1e-14;

/// How many numbers may be found.
#[derive(Clone, Copy, Debug)]
pub(super) struct Share(usize);

impl Share {
    /// An equal part of what is left after this effort.
    pub(super) fn of(effort: &Effort, parts: usize) -> Self {
        Self(BUDGET.saturating_sub(effort.evaluations) / parts.max(1))
    }
}

/// What is seen on a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sight {
    /// All loops close; whether all of them stay clear of rounding.
    Closes { clear: bool },
    /// This test fails everywhere.
    Blocked(usize),
    /// This test fails in the middle.
    BlockedInside(usize),
    /// This test can fail or pass.
    Open(usize),
}

/// A search through the ranges of the motors.
pub(super) struct Search<'p> {
    pub(super) tape: Tape<'p>,
    /// The motors that have a part in it, by their numbers.
    motors: Vec<usize>,
    ranges: Vec<Interval>,
    start: Vec<f64>,
    boxes: usize,
    touching: Vec<BlockId>,
    budget: usize,
    for_clearance: usize,
}

impl<'p> Search<'p> {
    /// A search through ranges, one for each motor of the mechanism, of which those in the group are looked through.
    pub(super) fn new(
        tape: Tape<'p>,
        program: &'p Program,
        group: &Group,
        ranges: &[Interval],
    ) -> Self {
        let ranges = group.ranges(program, ranges);
        let starts = program.start.motors.iter().zip(&ranges);
        Self {
            tape,
            motors: group.motors.clone(),
            start: starts
                .map(|(start, range)| start.max(range.low()).min(range.high()))
                .collect(),
            ranges,
            boxes: 0,
            touching: Vec::new(),
            budget: BUDGET,
            for_clearance: FOR_CLEARANCE,
        }
    }

    /// What is found with this share of the budget.
    pub(super) fn verdict(mut self, effort: &mut Effort, share: Share) -> Verdict {
        let Share(budget) = share;
        self.budget = budget;
        self.for_clearance = self.for_clearance.min(self.budget / 2);
        let hopeless =
            self.tape.is_too_large() || self.ranges.iter().any(|range| !range.is_bounded());
        let verdict = match self.tape.block(0) {
            None => self.conclude(),
            Some(block) if hopeless => {
                let place = self.ranges.clone();
                self.give_up_at(block, place)
            }
            Some(_) => match self.motors[..] {
                [motor] => self.one_motor(motor),
                _ => self.boxes(),
            },
        };
        effort.boxes += self.boxes;
        effort.evaluations += self.tape.evaluations();
        verdict
    }

    /// Both ways from the start.
    fn one_motor(&mut self, motor: usize) -> Verdict {
        let (start, range) = (self.start[motor], self.ranges[motor]);
        let line = Line::new(motor, self.start.clone(), range.width());
        let up = line.verdict(self, start, range.high());
        if let Verdict::Blocked(_) = up {
            return up;
        }
        let down = line.verdict(self, start, range.low());
        match (up, down) {
            (Verdict::Proved { .. }, Verdict::Proved { .. }) => self.conclude(),
            (_, down @ Verdict::Blocked(_)) | (Verdict::Proved { .. }, down) => down,
            (up, _) => up,
        }
    }

    fn boxes(&mut self) -> Verdict {
        // Wide boxes first: where the border of what is blocked crosses the ranges, its far side is soon found.
        let mut waiting = VecDeque::from([self.ranges.clone()]);
        let mut open = None;
        while let Some(place) = waiting.pop_front() {
            let test = match self.look(&place) {
                Sight::Closes { clear } => {
                    if !clear {
                        if self.looks_closer(self.part(&place))
                            && let Some(halves) = self.halves(&place)
                        {
                            waiting.extend(halves);
                        } else {
                            self.touches();
                        }
                    }
                    continue;
                }
                Sight::Blocked(test) | Sight::BlockedInside(test) => return self.blocked(test),
                Sight::Open(test) => test,
            };
            let is_final = self.tape.is_sharp(test) || is_narrow(self.part(&place));
            match self.halves(&place) {
                Some(halves) if !is_final && !self.is_spent() => waiting.extend(halves),
                _ => {
                    // Another box may tell that it is blocked.
                    open.get_or_insert((test, place));
                    if self.is_spent() {
                        break;
                    }
                }
            }
        }
        match open {
            Some((test, place)) => self.give_up(test, place),
            None => self.conclude(),
        }
    }

    /// Which loop blocks in the middle of the last box, and how far one motor can be moved towards it.
    fn blocked(&mut self, test: usize) -> Verdict {
        let at = self.tape.centre().to_vec();
        for motor in self.motors.clone() {
            let range = self.ranges[motor];
            let line = Line::new(motor, at.clone(), range.width());
            let from = self.start[motor];
            let to = if at[motor] < from {
                range.low()
            } else {
                range.high()
            };
            if let Sight::Closes { .. } = line.look(self, from, from)
                && let blocked @ Verdict::Blocked(_) = line.verdict(self, from, to)
            {
                return blocked;
            }
        }
        match self.tape.block(test) {
            Some(block) => {
                let Some(&motor) = self.motors.first() else {
                    bug!("a loop is blocked in which no motor has a part");
                };
                Verdict::Blocked(Blocked {
                    block,
                    motors: self.motors.clone(),
                    motor,
                    limit: self.start[motor],
                    interval: Interval::point(at[motor]),
                    at,
                })
            }
            None => self.conclude(),
        }
    }

    /// The motors that have a part in what is searched.
    pub(super) fn motors(&self) -> &[usize] {
        &self.motors
    }

    fn give_up_at(&self, block: BlockId, place: Vec<Interval>) -> Verdict {
        Verdict::Undecided {
            block,
            motors: self.motors.clone(),
            place,
        }
    }

    pub(super) fn conclude(&mut self) -> Verdict {
        self.touching.sort_unstable();
        self.touching.dedup();
        let touching = self.touching.clone();
        Verdict::Proved { touching }
    }

    pub(super) fn give_up(&mut self, test: usize, place: Vec<Interval>) -> Verdict {
        match self.tape.block(test) {
            Some(block) => self.give_up_at(block, place),
            None => self.conclude(),
        }
    }

    /// Runs the program on a box.
    pub(super) fn look(&mut self, place: &[Interval]) -> Sight {
        self.boxes += 1;
        self.tape.run(place);
        let tests = || 0..self.tape.tests();
        let on_box = |test: &usize| self.tape.on_box(*test);
        let first = |outcome| tests().find(|test| on_box(test) == outcome);
        if let Some(test) = first(Outcome::Fails) {
            Sight::Blocked(test)
        } else if let Some(test) = tests().find(|&test| self.tape.at_centre(test) == Outcome::Fails)
        {
            Sight::BlockedInside(test)
        } else if let Some(test) = first(Outcome::Open) {
            Sight::Open(test)
        } else {
            let clear = first(Outcome::Passes).is_none();
            Sight::Closes { clear }
        }
    }

    /// On the last box some loops only just close: whether a narrower one should tell if they stay clear.
    pub(super) fn looks_closer(&mut self, part: f64) -> bool {
        let cost = self.tape.cost();
        let affords = part > NEAR && self.for_clearance >= cost && !self.is_spent();
        if affords {
            self.for_clearance -= cost;
        }
        affords
    }

    /// On the last box some loops only just close.
    pub(super) fn touches(&mut self) {
        for test in 0..self.tape.tests() {
            if self.tape.on_box(test) == Outcome::Passes {
                self.touching.extend(self.tape.block(test));
            }
        }
        if self.touching.len() > 64 {
            self.touching.sort_unstable();
            self.touching.dedup();
        }
    }

    pub(super) fn is_spent(&self) -> bool {
        self.tape.evaluations() >= self.budget
    }

    /// The greatest part of a motor's range that a box takes.
    fn part(&self, place: &[Interval]) -> f64 {
        self.parts(place)
            .fold(0.0, |most, (_, part)| most.max(part))
    }

    fn parts(&self, place: &[Interval]) -> impl Iterator<Item = (usize, f64)> {
        let part = |(range, place): (&Interval, &Interval)| {
            if range.width() > 0.0 {
                place.width() / range.width()
            } else {
                0.0
            }
        };
        let parts: Vec<f64> = self.ranges.iter().zip(place).map(part).collect();
        parts.into_iter().enumerate()
    }

    /// A box cut across its longest side, if that can be cut.
    fn halves(&self, place: &[Interval]) -> Option<[Vec<Interval>; 2]> {
        let longest =
            |best: (usize, f64), next: (usize, f64)| if next.1 > best.1 { next } else { best };
        let (motor, _) = self.parts(place).reduce(longest)?;
        let middle = place[motor].middle();
        if !(place[motor].low() < middle && middle < place[motor].high()) {
            return None;
        }
        let half = |end: f64| {
            let mut half = place.to_vec();
            half[motor] = Interval::new(middle, end);
            half
        };
        Some([half(place[motor].low()), half(place[motor].high())])
    }
}

/// Whether a box is too narrow to be cut, by the part of the range that it takes.
pub(super) fn is_narrow(part: f64) -> bool {
    part <= NARROW
}
