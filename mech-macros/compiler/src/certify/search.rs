//! The search through the ranges of all motors: its budget, and its view of a box.

use super::claim::Group;
use super::tape::{Outcome, Tape};
use super::{Interval, Verdict};
use crate::program::{BlockId, Program};

/// The number of intervals that may be computed for one verdict: that takes some hundredths of a second.
const BUDGET: usize = 800_000;

/// The part of the budget for telling loops that only just close from loops that stay clear of dead points.
const FOR_CLEARANCE: usize = BUDGET / 4;

/// Boxes narrower than this part of the range are not cut to tell whether a slack touches zero or only comes near.
const NEAR: f64 = 1e-8;

/// Boxes narrower than this part of the range are not cut at all.
const NARROW: f64 = 1e-14;

/// A budget: how many intervals may be computed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Share(pub(super) usize);

impl Share {
    /// An equal share of the budget that is left after so many intervals.
    pub(super) fn of(effort: usize, parts: usize) -> Self {
        Self(BUDGET.saturating_sub(effort) / parts.max(1))
    }
}

/// The result of all tests on a box.
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
    pub(super) motors: Vec<usize>,
    pub(super) ranges: Vec<Interval>,
    pub(super) start: Vec<f64>,
    pub(super) touching: Vec<BlockId>,
    pub(super) budget: usize,
    pub(super) for_clearance: usize,
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
            start: starts.map(|(start, range)| start.max(range.low()).min(range.high())).collect(),
            ranges,
            touching: Vec::new(),
            budget: BUDGET,
            for_clearance: FOR_CLEARANCE,
        }
    }

    /// The motors that have a part in what is searched.
    pub(super) fn motors(&self) -> &[usize] {
        &self.motors
    }

    pub(super) fn give_up_at(&self, block: BlockId, place: Vec<Interval>) -> Verdict {
        Verdict::Undecided { block, motors: self.motors.clone(), place }
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
    pub(super) fn part(&self, place: &[Interval]) -> f64 {
        self.parts(place).fold(0.0, |most, (_, part)| most.max(part))
    }

    pub(super) fn parts(&self, place: &[Interval]) -> impl Iterator<Item = (usize, f64)> {
        let part = |(range, place): (&Interval, &Interval)| {
            if range.width() > 0.0 { place.width() / range.width() } else { 0.0 }
        };
        let parts: Vec<f64> = self.ranges.iter().zip(place).map(part).collect();
        parts.into_iter().enumerate()
    }

    /// A box cut across its longest side, if that can be cut.
    pub(super) fn halves(&self, place: &[Interval]) -> Option<[Vec<Interval>; 2]> {
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
