//! Looks through the ranges of all motors, box by box.

use super::line::Line;
use super::search::{Search, Share, Sight, is_narrow};
use super::{Blocked, Interval, Verdict};
use crate::bug::bug;
use std::collections::VecDeque;

impl Search<'_> {
    /// The verdict that this share of the budget is enough for.
    pub(super) fn verdict(mut self, effort: &mut usize, share: Share) -> Verdict {
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
        *effort += self.tape.evaluations();
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
            let to = if at[motor] < from { range.low() } else { range.high() };
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
}
