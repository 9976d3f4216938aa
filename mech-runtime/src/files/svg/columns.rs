//! What is the same thing at different moments.

use super::layers::Seen;
use std::{vec, vec::Vec};

/// Nothing goes so far from one moment to the next, in pixels, if something else of its kind is nearer.
const NEAR: f64 = 20.0;

/// One thing: at each moment what is seen of it, if it is there.
pub(super) type Column<'a> = Vec<Option<&'a Seen>>;

/// All things, from back to front: what is akin and comes in the same order is taken to be the same.
pub(super) fn columns(moments: &[Vec<Seen>]) -> Vec<Column<'_>> {
    let mut things: Vec<Thing<'_>> = Vec::new();
    for (time, moment) in moments.iter().enumerate() {
        let matches = matches(&things, moment);
        let mut known = things.into_iter().enumerate().peekable();
        let mut merged = Vec::new();
        for (seen, found) in moment.iter().zip(matches) {
            let Some(found) = found else {
                let mut thing = Thing {
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

struct Thing<'a> {
    /// What was last seen of it.
    last: &'a Seen,
    seen: Column<'a>,
}

impl<'a> Thing<'a> {
    fn see(&mut self, seen: Option<&'a Seen>) {
        self.last = seen.unwrap_or(self.last);
        self.seen.push(seen);
    }

    fn is_akin(&self, seen: &Seen) -> bool {
        self.last.figure.is_akin(&seen.figure)
    }

    /// How much speaks for it that this is seen of it.
    fn likeness(&self, seen: &Seen) -> usize {
        if !self.is_akin(seen) {
            return 0;
        }
        let [(x, y), (to_x, to_y)] = [self.last, seen].map(Seen::first_point);
        match (to_x - x).hypot(to_y - y) {
            0.0 => 3,
            way if way < NEAR => 2,
            _ => 1,
        }
    }
}

/// For each figure that is seen the index of the thing that it is, in rising order: as many as possible.
fn matches(things: &[Thing<'_>], moment: &[Seen]) -> Vec<Option<usize>> {
    let are_all = things.len() == moment.len()
        && things
            .iter()
            .zip(moment)
            .all(|(thing, seen)| thing.is_akin(seen));
    if are_all {
        return (0..moment.len()).map(Some).collect();
    }
    // The most that can be had of what is left from each pair on.
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
