//! The course of a value along the way of one motor: bounds on short stretches of it, which are cut where they decide.

use super::search::Search;
use super::waiting::Frame;
use crate::certify::Interval;
use crate::program::Value;
use std::collections::VecDeque;
use std::rc::Rc;

/// The way is cut into so many stretches at first.
const FIRST: u32 = 16;

/// A dwell is known well enough if no more than this part of it is open.
const WELL_KNOWN: f64 = 1e-7;

/// Shorter stretches than this part of the way are not cut.
const NARROW: f64 = 1e-11;

/// An extreme that may lie on more stretches than this is in no one place.
const MOST_CANDIDATES: usize = 256;

/// A mean is known if no more than this part of the greatest value is open.
const SUMMED: f64 = 1e-5;

/// A time ratio is known if so little of it is open. Extremes are found less well than values: nothing changes there.
const PLACED: f64 = 1e-6;

/// The longest part of the way that is one place of an extreme.
const ONE_PLACE: f64 = 1e-3;

/// The cost of looking at a stretch once more, in intervals.
const LOOK: usize = 4;

/// Numbers that differ by this part are equal but for rounding.
const ROUNDING: f64 = 1e-9;

/// A stretch of the way.
struct Stretch {
    range: Interval,
    /// All values on it.
    values: Interval,
    /// The mean of them, if the motor goes evenly.
    mean: Interval,
    /// The value at its beginning, or all values if nobody asks for that.
    first: Interval,
    frame: Rc<Frame>,
}

/// The course of a value along the way of one motor, while all others stand.
pub(super) struct Course<'s, 'a> {
    search: &'s mut Search<'a>,
    /// So many intervals are left for others.
    reserve: usize,
    value: Value,
    motor: usize,
    /// Where all other motors stand.
    near: Vec<f64>,
    whole: Interval,
    /// Whether anybody asks for values where stretches begin.
    has_ends: bool,
    /// Whether its end is its beginning.
    is_round: bool,
    stretches: Vec<Stretch>,
    /// The value at its end.
    last: Interval,
}

impl<'s, 'a> Course<'s, 'a> {
    /// The course of a value while a motor goes through a range, and all others stand near a place; nothing if it cannot be found within
    /// the time there is. With the turn of the motor after which the value is what it was, if there is one; and
    /// whether anybody asks for values where stretches begin.
    pub(super) fn new(
        search: &'s mut Search<'a>,
        value: Value,
        (motor, whole): (usize, Interval),
        near: Vec<f64>,
        period: Option<f64>,
        has_ends: bool,
    ) -> Option<Self> {
        let reserve = search.left() / 2;
        let start = Rc::clone(&search.start);
        let mut course = Self {
            search,
            reserve,
            value,
            motor,
            near,
            whole,
            has_ends,
            is_round: false,
            stretches: Vec::new(),
            last: Interval::ENTIRE,
        };
        let end = |number: u32| match number {
            0 => whole.low(),
            FIRST => whole.high(),
            _ => whole.low() + whole.width() * (f64::from(number) / f64::from(FIRST)),
        };
        let mut frame = start;
        for number in 0..FIRST {
            let range = Interval::new(end(number), end(number + 1));
            let stretch = course.stretch(range, &frame)?;
            frame = Rc::clone(&stretch.frame);
            course.stretches.push(stretch);
        }
        let place = course.place(Interval::point(whole.high()));
        course.last = course.search.look_in(&place, &frame, value)?.1;
        let (first, last) = (course.stretches[0].first, course.last);
        let is_back = (first - last).abs().high() <= ROUNDING * course.greatest();
        let rounds = period.map_or(0.0, |period| whole.width() / period);
        let is_whole = rounds.round() >= 1.0 && (rounds - rounds.round()).abs() <= ROUNDING;
        course.is_round = is_whole && is_back;
        Some(course)
    }

    /// The greatest size of the value where it has bounds.
    fn greatest(&self) -> f64 {
        let sizes = self.stretches.iter().map(|one| one.values.abs().high());
        sizes.filter(|size| size.is_finite()).fold(0.0, f64::max)
    }

    fn place(&self, range: Interval) -> Vec<Interval> {
        let mut place: Vec<Interval> = self.near.iter().copied().map(Interval::point).collect();
        place[self.motor] = range;
        place
    }

    fn stretch(&mut self, range: Interval, near: &Rc<Frame>) -> Option<Stretch> {
        let place = self.place(range);
        let (frame, values) = self.search.look_in(&place, near, self.value)?;
        // Without bounds, a frame may be that of another turn.
        let mean = if values.is_bounded() {
            self.search.mean(&frame, self.value, self.motor)
        } else {
            values
        };
        let first = if self.has_ends {
            let begin = self.place(Interval::point(range.low()));
            self.search.look_in(&begin, &frame, self.value)?.1
        } else {
            values
        };
        Some(Stretch { range, values, mean: values.meet(mean), first, frame })
    }

    /// Cuts stretches in two, by their numbers. Tells whether any was cut.
    fn cut(&mut self, mut numbers: Vec<usize>) -> bool {
        numbers.sort_unstable();
        numbers.dedup();
        let narrow = NARROW * self.whole.width();
        let mut has_cut = false;
        // Who asked has looked at all of them.
        self.search.spend(LOOK * self.stretches.len());
        // What is cut moves only what comes after it.
        for number in numbers.into_iter().rev() {
            let Stretch { range, frame, .. } = &self.stretches[number];
            let (range, frame, middle) = (*range, Rc::clone(frame), range.middle());
            if range.width() <= narrow || self.search.left() <= self.reserve {
                continue;
            }
            let ends = [(range.low(), middle), (middle, range.high())];
            let halves = ends.map(|(low, high)| self.stretch(Interval::new(low, high), &frame));
            if let [Some(first), Some(second)] = halves {
                self.stretches.splice(number..=number, [first, second]);
                has_cut = true;
            }
        }
        has_cut
    }

    /// Where a stretch begins, or the last one ends. A round goes on after its end.
    fn begin(&self, number: usize) -> f64 {
        let (rounds, rest) = (number / self.stretches.len(), number % self.stretches.len());
        let begin = self.stretches[rest].range.low();
        match rounds {
            0 => begin,
            1 if rest == 0 => self.whole.high(),
            _ => begin + self.whole.width(),
        }
    }

    fn values_on(&self, number: usize) -> Interval {
        self.stretches[number % self.stretches.len()].values
    }

    fn value_at(&self, number: usize) -> Interval {
        if number == self.stretches.len() && !self.is_round {
            return self.last;
        }
        self.stretches[number % self.stretches.len()].first
    }

    /// A place beyond the end of a round, within it.
    fn within(&self, at: f64) -> f64 {
        if at > self.whole.high() { at - self.whole.width() } else { at }
    }

    /// The longest way on which the value stays within a width, with both ends of one that is certain. So many times what is usual may be
    /// open.
    pub(super) fn dwell(&mut self, width: f64, open: f64) -> (Interval, Vec<f64>) {
        loop {
            let count = self.stretches.len();
            let all = if self.is_round { 2 * count } else { count };
            let whole = self.whole.width();
            let way = |from, to: usize| (self.begin(to) - self.begin(from)).min(whole);
            // On all of these stretches it certainly stays within the width.
            let outer = |number| {
                let values = self.values_on(number);
                [values.low(), values.high()]
            };
            let sure = longest(all, width, outer, |from, to| way(from, to + 1));
            // At all of these places it may be within the width. Nobody knows how far it stays so beyond them.
            let inner = |number| {
                let values = self.value_at(number);
                [values.high(), values.low()]
            };
            let around = |from: usize, to: usize| way(from.saturating_sub(1), (to + 1).min(all));
            let possible = longest(all + 1, width, inner, around);
            let low = sure.map_or(0.0, |[from, to]| way(from, to + 1));
            let high = possible.map_or(whole, |[from, to]| around(from, to));
            let found = Interval::new(low, high.max(low));
            let ends = sure.map_or(Vec::new(), |[from, to]| {
                [from, to + 1].map(|end| self.within(self.begin(end))).to_vec()
            });
            let deciding = self.deciding(sure, possible);
            if found.width() <= open * WELL_KNOWN * high || !self.cut(deciding) {
                return (found, ends);
            }
        }
    }

    /// The stretches that decide how long a dwell is, of one that is certain and one that is possible.
    fn deciding(&self, sure: Option<[usize; 2]>, possible: Option<[usize; 2]>) -> Vec<usize> {
        let count = self.stretches.len();
        let before = |number: usize| match number {
            0 => self.is_round.then(|| count - 1),
            number => Some(number - 1),
        };
        let mut open: Vec<usize> = Vec::new();
        if let Some([from, to]) = sure {
            open.extend(before(from).into_iter().chain([to + 1]));
        }
        if let Some([from, to]) = possible {
            open.extend(before(from).into_iter().chain([to]));
            let within = from..to;
            let by = |one: usize, other: usize, end: fn(Interval) -> f64| {
                end(self.values_on(one)).total_cmp(&end(self.values_on(other)))
            };
            let high = |one: &usize, other: &usize| by(*one, *other, Interval::high);
            let low = |one: &usize, other: &usize| by(*one, *other, Interval::low);
            open.extend(within.clone().max_by(high));
            open.extend(within.clone().min_by(low));
            if sure.is_none() {
                open.extend(within);
            }
        }
        let is_there = |number: &usize| self.is_round || *number < count;
        open.retain(is_there);
        open.into_iter().map(|number| number % count).collect()
    }

    /// The time of the slower way between least and greatest, divided by that of the quicker one, and where these are. Nothing if the way is
    /// no round, or if one of the two is not in one place.
    pub(super) fn time_ratio(&mut self, open: f64) -> Option<(Interval, Vec<f64>)> {
        if !self.is_round {
            return None;
        }
        loop {
            let candidates = [1.0, -1.0].map(|sign| self.candidates(sign));
            let [least, greatest] = candidates.each_ref().map(|all| self.around(all));
            let ratio = self.ratio(least, greatest);
            let is_known = ratio.width() <= open * PLACED * ratio.low();
            let is_over = candidates.iter().any(|all| all.len() > MOST_CANDIDATES);
            if is_known || is_over || !self.cut(candidates.concat()) {
                let most = ONE_PLACE * self.whole.width();
                let places = [least, greatest];
                let is_placed = places.iter().all(|place| place.width() <= most);
                let middles = places.map(|place| self.within(place.middle()));
                return is_placed.then(|| (ratio, middles.to_vec()));
            }
        }
    }

    /// The stretches on which the value, times its sign, may be least.
    fn candidates(&self, sign: f64) -> Vec<usize> {
        let sign = Interval::point(sign);
        let seen = self.stretches.iter().map(|one| (sign * one.first).high());
        let least = seen.fold(f64::INFINITY, f64::min);
        let all = self.stretches.iter().enumerate();
        all.filter(|(_, one)| (sign * one.values).low() <= least)
            .map(|(number, _)| number)
            .collect()
    }

    /// The shortest way in a round on which all of these stretches lie.
    fn around(&self, numbers: &[usize]) -> Interval {
        let count = self.stretches.len();
        let next = numbers.iter().skip(1).copied();
        let next = next.chain(numbers.first().map(|first| first + count));
        let gap = |(from, to): &(usize, usize)| self.begin(*to) - self.begin(from + 1);
        let gaps = numbers.iter().copied().zip(next);
        match gaps.max_by(|a, b| gap(a).total_cmp(&gap(b))) {
            // It begins after the longest gap, and ends before that one round later.
            Some((from, to)) => {
                let (begin, end) = (self.begin(to), self.begin(from + 1) + self.whole.width());
                let back = if to >= count { self.whole.width() } else { 0.0 };
                Interval::new(begin - back, end - back)
            }
            None => self.whole,
        }
    }

    /// The slower of the ways between two places of a round beside the quicker one.
    fn ratio(&self, one: Interval, other: Interval) -> Interval {
        let whole = self.whole.width();
        let way = other - one;
        let way = way - Interval::point(whole * (way.middle() / whole).floor());
        let half = Interval::point(0.5 * whole);
        // By so much the slower way is longer than half a round.
        let more = (way - half).abs();
        let [low, high] = [more.low(), more.high()].map(|more| {
            let more = Interval::point(more);
            (half + more) / (half - more)
        });
        low.hull(high)
    }

    /// The mean on the whole way.
    pub(super) fn mean(&mut self, open: f64) -> Interval {
        let whole = Interval::point(self.whole.width());
        loop {
            let parts = self.stretches.iter().map(|one| {
                let length = Interval::point(one.range.high()) - Interval::point(one.range.low());
                length * one.mean
            });
            let parts: Vec<Interval> = parts.collect();
            let sum = parts.iter().fold(Interval::ZERO, |sum, part| sum + *part);
            let mean = sum / whole;
            if mean.width() <= open * SUMMED * self.greatest() {
                return mean;
            }
            // Those of which most is open.
            let mut order: Vec<usize> = (0..parts.len()).collect();
            order.sort_by(|a, b| parts[*b].width().total_cmp(&parts[*a].width()));
            order.truncate(parts.len() / 4);
            if !self.cut(order) {
                return mean;
            }
        }
    }
}

/// The longest run of numbers whose bands, from a low end to a high one, lie within a width together.
fn longest(
    count: usize,
    width: f64,
    band: impl Fn(usize) -> [f64; 2],
    length: impl Fn(usize, usize) -> f64,
) -> Option<[usize; 2]> {
    let mut best: Option<([usize; 2], f64)> = None;
    let mut from = 0;
    // The least and the greatest so far, each with what may follow it when it is left behind.
    let (mut least, mut greatest) = (VecDeque::new(), VecDeque::new());
    for to in 0..count {
        let [low, high] = band(to);
        while least.back().is_some_and(|(_, last)| *last >= low) {
            least.pop_back();
        }
        while greatest.back().is_some_and(|(_, last)| *last <= high) {
            greatest.pop_back();
        }
        least.push_back((to, low));
        greatest.push_back((to, high));
        while let (Some((_, low)), Some((_, high))) = (least.front(), greatest.front())
            && high - low > width
        {
            for ends in [&mut least, &mut greatest] {
                if ends.front().is_some_and(|(number, _)| *number == from) {
                    ends.pop_front();
                }
            }
            from += 1;
        }
        if from > to {
            continue;
        }
        let own = length(from, to);
        if best.is_none_or(|(_, longest)| own > longest) {
            best = Some(([from, to], own));
        }
    }
    best.map(|(run, _)| run)
}
