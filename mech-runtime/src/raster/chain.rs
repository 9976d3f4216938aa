//! Sides that lead down from the highest corner of a polygon, one after the other; and whether there are such.

use super::edge::Edge;
use super::tour::Tour;
use crate::Scalar;

/// One of the two chains of sides from the top to the bottom.
pub(super) struct Chain<'c, T, F> {
    tour: Tour<'c, T, F>,
    height: usize,
    side: Option<Edge>,
}

impl<'c, T: Scalar, F: Fn(usize) -> [T; 2]> Chain<'c, T, F> {
    /// Goes down on a tour from the highest corner, in a picture of so many rows.
    pub(super) const fn new(tour: Tour<'c, T, F>, height: usize) -> Self {
        Self { tour, height, side: None }
    }

    /// The side that crosses a row. Rows are asked for from the top.
    pub(super) fn side_at(&mut self, row: usize) -> Option<Edge> {
        while self.side.is_none_or(|side| side.end <= row) {
            let [from, to] = self.tour.next_side()?;
            self.side = Edge::new(from, to, self.height);
        }
        self.side
    }
}

/// Counts how often the corners of a polygon change between falling and rising: twice, if there are two chains.
pub(super) struct Directions<N> {
    first: Option<N>,
    last: Option<N>,
    first_direction: Option<bool>,
    direction: Option<bool>,
    turns: usize,
}

impl<N: Copy + PartialOrd> Directions<N> {
    pub(super) const fn new() -> Self {
        Self { first: None, last: None, first_direction: None, direction: None, turns: 0 }
    }

    /// Goes to the next corner, which is at this depth.
    #[inline]
    pub(super) fn add(&mut self, depth: N) {
        let Some(last) = self.last.replace(depth) else {
            self.first = Some(depth);
            return;
        };
        if depth != last {
            let direction = Some(depth > last);
            self.turns += usize::from(self.direction.is_some() && self.direction != direction);
            self.first_direction = self.first_direction.or(direction);
            self.direction = direction;
        }
    }

    /// Adds the first depth again, to close the polygon.
    pub(super) fn turns(mut self) -> usize {
        if let Some(first) = self.first {
            self.add(first);
        }
        self.turns + usize::from(self.direction != self.first_direction)
    }
}
