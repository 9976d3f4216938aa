//! One motor alone: how far it moves, and where it moves again.

use super::search::{Search, Sight, is_narrow};
use super::{Blocked, Interval, Verdict};

/// The values of one motor, all others held.
#[derive(Clone, Debug)]
pub(super) struct Line {
    motor: usize,
    /// The values of all motors; that of this one does not matter.
    held: Vec<f64>,
    /// The width of the motor's range.
    width: f64,
}

/// The kind of places that is looked for on a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ground {
    /// Where all loops close.
    Free,
    /// Where some loop does not.
    Blocked,
}

/// The result of a walk along a line.
struct Walk {
    /// Up to here the motor has the ground that was looked for, except where it cannot be told (`open`).
    reached: f64,
    /// The first place that certainly is not, and the test that tells.
    wall: Option<(f64, usize)>,
    /// The first place where it cannot be told.
    open: Option<(f64, f64, usize)>,
}

impl Line {
    /// One motor, by its number, and the values of all.
    pub(super) fn new(motor: usize, held: Vec<f64>, width: f64) -> Self {
        Self { motor, held, width }
    }

    /// Whether the motor moves all the way from one value to another.
    pub(super) fn verdict(&self, search: &mut Search<'_>, from: f64, to: f64) -> Verdict {
        let walk = self.walk(search, from, to, Ground::Free);
        match (walk.wall, walk.open) {
            (Some((wall, test)), _) => self.blocked(search, &walk, wall, test, to),
            (None, Some((near, far, test))) => {
                let place = self.place(near, far);
                search.give_up(test, place)
            }
            (None, None) => search.conclude(),
        }
    }

    fn blocked(
        &self,
        search: &mut Search<'_>,
        walk: &Walk,
        wall: f64,
        test: usize,
        to: f64,
    ) -> Verdict {
        let Some(block) = search.tape.block(test) else {
            return search.conclude();
        };
        let limit = self.border(search, walk.reached, wall);
        let beyond = self.walk(search, wall, to, Ground::Blocked);
        let end = match beyond.wall {
            Some((free, _)) => self.border(search, free, beyond.reached),
            None => beyond.reached,
        };
        let mut at = self.held.clone();
        at[self.motor] = wall;
        Verdict::Blocked(Blocked {
            block,
            motors: search.motors().to_vec(),
            at,
            motor: self.motor,
            limit,
            interval: Interval::new(limit, end),
        })
    }

    /// From one value towards another, nearest boxes first, as far as the ground is of this kind.
    fn walk(&self, search: &mut Search<'_>, from: f64, to: f64, ground: Ground) -> Walk {
        let mut walk = Walk { reached: from, wall: None, open: None };
        let mut waiting = vec![(from, to)];
        while let Some((near, far)) = waiting.pop() {
            let part = (far - near).abs() / self.width;
            let middle = Interval::new(near, far).middle();
            let is_cut = (near < middle && middle < far) || (far < middle && middle < near);
            let halves = [(middle, far), (near, middle)];
            let test = match (self.look(search, near, far), ground) {
                (Sight::Closes { clear }, Ground::Free) => {
                    if !clear && is_cut && search.looks_closer(part) {
                        waiting.extend(halves);
                        continue;
                    }
                    if !clear {
                        search.touches();
                    }
                    walk.reached = far;
                    continue;
                }
                (Sight::Blocked(_), Ground::Blocked) => {
                    walk.reached = far;
                    continue;
                }
                (Sight::Closes { .. }, Ground::Blocked) => {
                    walk.wall = Some((near, 0));
                    break;
                }
                (Sight::Blocked(test), Ground::Free) => {
                    walk.wall = Some((near, test));
                    break;
                }
                (Sight::BlockedInside(test), Ground::Free) => {
                    // Places beyond do not matter any more.
                    walk.wall = Some((middle, test));
                    waiting.clear();
                    if is_cut && !is_narrow(part) && !search.is_spent() {
                        waiting.push((near, middle));
                        continue;
                    }
                    break;
                }
                (Sight::Open(test) | Sight::BlockedInside(test), _) => test,
            };
            if search.is_spent() {
                let end = waiting.first().map_or(far, |&(_, end)| end);
                walk.open.get_or_insert((near, end, test));
                break;
            }
            if is_cut && !is_narrow(part) && !search.tape.is_sharp(test) {
                waiting.extend(halves);
            } else {
                // Such a box stands beside every dead point: what comes after it tells.
                walk.open.get_or_insert((near, far, test));
            }
        }
        walk
    }

    /// The last value at which the loops close, between one at which they do and one at which they do not.
    fn border(&self, search: &mut Search<'_>, closing: f64, open: f64) -> f64 {
        let (mut closing, mut open) = (closing, open);
        loop {
            let middle = Interval::new(closing, open).middle();
            if middle == closing || middle == open {
                return closing;
            }
            self.look(search, middle, middle);
            let closes = |test| search.tape.closes_at_centre(test);
            if (0..search.tape.tests()).all(closes) {
                closing = middle;
            } else {
                open = middle;
            }
        }
    }

    /// Runs the program between two values of the motor.
    pub(super) fn look(&self, search: &mut Search<'_>, near: f64, far: f64) -> Sight {
        let place = self.place(near, far);
        search.look(&place)
    }

    fn place(&self, near: f64, far: f64) -> Vec<Interval> {
        let mut place: Vec<Interval> = self.held.iter().copied().map(Interval::point).collect();
        place[self.motor] = Interval::new(near, far);
        place
    }
}
