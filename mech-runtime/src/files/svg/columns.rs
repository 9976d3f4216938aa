//! Matching of figures at different moments.

use super::figure::Seen;
use std::{vec, vec::Vec};

/// A figure within this distance of the moment before, in pixels, is preferred to farther ones of its kind.
const NEAR: f64 = 20.0;

/// One thing: at each moment its figure, if it is visible.
pub(super) type Column<'a> = Vec<Option<&'a Seen>>;

/// All things, from back to front. Figures of the same kind in the same order are taken to be the same thing.
pub(super) fn columns(moments: &[Vec<Seen>]) -> Vec<Column<'_>> {
    let mut things: Vec<FigureTrack<'_>> = Vec::new();
    for (time, moment) in moments.iter().enumerate() {
        let matches = matches(&things, moment);
        let mut known = things.into_iter().enumerate().peekable();
        let mut merged = Vec::new();
        for (seen, found) in moment.iter().zip(matches) {
            let Some(found) = found else {
                let mut thing = FigureTrack {
                    last: seen,
                    seen: vec![None; time],
                };
                thing.see(Some(seen));
                merged.push(thing);
                continue;
            };
            while let Some((index, mut thing)) = known.next_if(|(index, _)| *index <= found) {
                thing.see((index == found).then_some(seen));
                merged.push(thing);
            }
        }
        for (_, mut thing) in known {
            thing.see(None);
            merged.push(thing);
        }
        things = merged;
    }
    things.into_iter().map(|thing| thing.seen).collect()
}

struct FigureTrack<'a> {
    /// The figure that was last seen.
    last: &'a Seen,
    seen: Column<'a>,
}

impl<'a> FigureTrack<'a> {
    fn see(&mut self, seen: Option<&'a Seen>) {
        self.last = seen.unwrap_or(self.last);
        self.seen.push(seen);
    }

    fn is_akin(&self, seen: &Seen) -> bool {
        self.last.figure.is_akin(&seen.figure)
    }

    /// The weight of the match with a figure. Zero if it cannot match.
    fn likeness(&self, seen: &Seen) -> usize {
        if !self.is_akin(seen) {
            return 0;
        }
        let [(x, y), (to_x, to_y)] = [self.last, seen].map(Seen::first_point);
        match (to_x - x).hypot(to_y - y) {
            0.0 => 3,
            distance if distance < NEAR => 2,
            _ => 1,
        }
    }
}

/// For each figure the index of its thing, in rising order, with the greatest weight in all.
fn matches(things: &[FigureTrack<'_>], moment: &[Seen]) -> Vec<Option<usize>> {
    let are_all = things.len() == moment.len()
        && things
            .iter()
            .zip(moment)
            .all(|(thing, seen)| thing.is_akin(seen));
    if are_all {
        return (0..moment.len()).map(Some).collect();
    }
    // The greatest weight of the remainder from each pair on.
    let width = moment.len() + 1;
    let mut most = vec![0_usize; (things.len() + 1) * width];
    let left = |most: &[usize], thing: usize, seen: usize| {
        most.get(thing * width + seen).copied().unwrap_or_default()
    };
    for (i, thing) in things.iter().enumerate().rev() {
        for (j, seen) in moment.iter().enumerate().rev() {
            let apart = left(&most, i + 1, j).max(left(&most, i, j + 1));
            let likeness = thing.likeness(seen);
            let best = if likeness > 0 {
                apart.max(likeness + left(&most, i + 1, j + 1))
            } else {
                apart
            };
            if let Some(entry) = most.get_mut(i * width + j) {
                *entry = best;
            }
        }
    }
    let mut i = 0;
    let matches = (0..moment.len()).map(|j| {
        // Things are passed over as long as that costs nothing.
        while i < things.len() && left(&most, i, j) == left(&most, i + 1, j) {
            i += 1;
        }
        let is_match = i < things.len() && left(&most, i, j) > left(&most, i, j + 1);
        let found = is_match.then_some(i);
        i += usize::from(is_match);
        found
    });
    matches.collect()
}
