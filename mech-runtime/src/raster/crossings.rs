//! Crossings of the sides of a polygon with some rows.

use super::edge::Edge;
use super::fixed;
use super::spans::{Clip, Spans};

/// The inside of a polygon that crosses itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rule {
    /// The region that is surrounded an odd number of times.
    EvenOdd,
    /// The region whose winding number is not zero.
    NonZero,
}

/// Rows that are looked at together.
const ROWS: usize = 16;
/// The number of stored crossings of each row. Rows with more are rare, and are searched several times.
const MOST: usize = 14;

/// The crossings of some rows, each in order from left to right.
pub(super) struct Crossings {
    band: Clip,
    rows: [Row; ROWS],
}

#[derive(Clone, Copy)]
struct Row {
    crossings: [Crossing; MOST],
    /// The number of crossings, also of those without a slot.
    count: usize,
}

/// The pixel to the right of a side, doubled, and one more if the side falls.
type Crossing = u32;

impl Row {
    const fn new() -> Self {
        Self { crossings: [0; MOST], count: 0 }
    }

    /// Adds a crossing, in order.
    fn insert(&mut self, crossing: Crossing) {
        let places = self.crossings.get_mut(..=self.count);
        if let Some((last, earlier)) = places.and_then(<[_]>::split_last_mut) {
            let mut hand = crossing;
            for place in earlier {
                if *place > hand {
                    core::mem::swap(place, &mut hand);
                }
            }
            *last = hand;
        }
        self.count += 1;
    }
}

impl Crossings {
    pub(super) const fn new() -> Self {
        Self { band: Clip::all(0, 0), rows: [Row::new(); ROWS] }
    }

    /// Forgets all crossings, and begins with the first of these rows: those are given back that are looked at.
    pub(super) fn begin(&mut self, rows: Clip) -> Clip {
        self.band = Clip { bottom: rows.bottom.min(rows.top + ROWS), ..rows };
        for row in &mut self.rows {
            row.count = 0;
        }
        self.band
    }

    /// Marks where a side crosses them.
    #[inline]
    pub(super) fn mark(&mut self, side: Edge) {
        let Clip { top, bottom, .. } = self.band;
        let (from, to) = (side.first.max(top), side.end.min(bottom));
        if from >= to {
            return;
        }
        let mut at = side.at(from);
        let rows = self.rows.get_mut(from - top..to - top);
        for row in rows.unwrap_or_default() {
            row.insert(crossing(at, side, self.band));
            at = at.wrapping_add(side.step());
        }
    }

    /// Fills a row by its crossings. If some have no slot, they are found again among all sides.
    pub(super) fn fill<S: Iterator<Item = Edge>>(
        &self,
        surface: &mut impl Spans,
        row: usize,
        rule: Rule,
        color: u8,
        sides: impl Fn() -> S,
    ) {
        let Some(Row { crossings, count }) = self.rows.get(row - self.band.top) else {
            return;
        };
        let mut filling = Filling::new(rule, row, color);
        if let Some(crossings) = crossings.get(..*count) {
            for &crossing in crossings {
                filling.pass(crossing, surface);
            }
            return;
        }
        // From left to right, as many at a time as there is room for; of two in one place the first declared is passed first.
        let mut passed = None;
        loop {
            let mut next = [(Crossing::MAX, usize::MAX); MOST];
            for (number, side) in sides().enumerate() {
                if !(side.first..side.end).contains(&row) {
                    continue;
                }
                let mut hand = (crossing(side.at(row), side, self.band), number);
                if passed.is_some_and(|passed| hand <= passed) {
                    continue;
                }
                for place in &mut next {
                    if *place > hand {
                        core::mem::swap(place, &mut hand);
                    }
                }
            }
            for found in next {
                if found.1 == usize::MAX {
                    return;
                }
                filling.pass(found.0, surface);
                passed = Some(found);
            }
        }
    }
}

/// The crossing of a side with a row. A crossing beyond the margins counts as on them.
#[inline]
fn crossing(at: i64, side: Edge, band: Clip) -> Crossing {
    let pixel = fixed::within(fixed::pixel(at), band.left, band.right);
    let pixel = Crossing::try_from(pixel).unwrap_or(Crossing::MAX / 2);
    2 * pixel + Crossing::from(side.falls)
}

/// A row that is filled from left to right.
struct Filling {
    rule: Rule,
    row: usize,
    color: u8,
    /// The winding number of the next pixels.
    winding: i32,
    start: usize,
}

impl Filling {
    const fn new(rule: Rule, row: usize, color: u8) -> Self {
        Self { rule, row, color, winding: 0, start: 0 }
    }

    const fn is_inside(&self) -> bool {
        match self.rule {
            Rule::EvenOdd => self.winding & 1 != 0,
            Rule::NonZero => self.winding != 0,
        }
    }

    /// Passes a crossing: fills what lies before it, if that is inside.
    fn pass(&mut self, crossing: Crossing, surface: &mut impl Spans) {
        let pixel = (crossing / 2) as usize;
        let was_inside = self.is_inside();
        self.winding += if crossing & 1 == 0 { -1 } else { 1 };
        if was_inside && !self.is_inside() {
            surface.fill(self.row, self.start..pixel, self.color);
        } else if !was_inside {
            self.start = pixel;
        }
    }
}
