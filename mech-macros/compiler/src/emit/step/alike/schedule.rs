//! The order in which pieces are computed.

use super::pieces::{Pieces, Place};
use std::collections::{BTreeMap, BTreeSet};

/// The order of the blocks.
pub(super) fn in_order(pieces: &Pieces) -> Vec<usize> {
    (0..pieces.all.len()).filter(|&piece| pieces.is_run(piece)).collect()
}

/// An order in which pieces of one class stand together, as far as they do not wait for each other.
pub(super) fn side_by_side(pieces: &Pieces) -> Vec<usize> {
    let mut waiting = Waiting::new(pieces);
    let mut order = Vec::new();
    while let Some(next) = waiting.next() {
        order.extend(&next);
        for piece in next {
            waiting.done(piece);
        }
    }
    order
}

/// Pieces that are not computed yet.
struct Waiting<'p> {
    pieces: &'p Pieces,
    /// For each piece, those that read what it gives.
    readers: Vec<BTreeSet<usize>>,
    /// For each piece, the number of pieces that it waits for.
    missing: Vec<usize>,
    /// The pieces in no class that can be computed now.
    alone: BTreeSet<usize>,
    /// For each class its pieces that can be computed now.
    ready: BTreeMap<usize, BTreeSet<usize>>,
    /// The number of pieces of each class that are not computed yet.
    left: Vec<usize>,
}

impl<'p> Waiting<'p> {
    fn new(pieces: &'p Pieces) -> Self {
        let mut makers = BTreeMap::new();
        for (number, piece) in pieces.all.iter().enumerate() {
            makers.extend(piece.flow.gives.iter().map(|&value| (value, number)));
        }
        let mut waiting = Self {
            pieces,
            readers: vec![BTreeSet::new(); pieces.all.len()],
            missing: vec![0; pieces.all.len()],
            alone: BTreeSet::new(),
            ready: BTreeMap::new(),
            left: vec![0; pieces.classes.len()],
        };
        for number in in_order(pieces) {
            if let Some(Place { class, .. }) = pieces.all[number].row {
                waiting.left[class] += 1;
            }
            let takes = pieces.all[number].flow.takes.iter();
            let before: BTreeSet<usize> =
                takes.filter_map(|value| makers.get(value)).copied().collect();
            waiting.missing[number] = before.len();
            for maker in before {
                waiting.readers[maker].insert(number);
            }
        }
        for number in in_order(pieces) {
            if waiting.missing[number] == 0 {
                waiting.admit(number);
            }
        }
        waiting
    }

    /// Notes that a piece can be computed now: everything that it needs is computed.
    fn admit(&mut self, piece: usize) {
        match self.pieces.all[piece].row {
            None => self.alone.insert(piece),
            Some(Place { class, .. }) => self.ready.entry(class).or_default().insert(piece),
        };
    }

    /// The next pieces: one that is in no class, or all pieces of a class that can be computed now. Classes that are complete come first.
    /// Then come those of few operations: more pieces of other classes may become possible by them.
    fn next(&mut self) -> Option<Vec<usize>> {
        if let Some(piece) = self.alone.pop_first() {
            return Some(vec![piece]);
        }
        let classes = self.ready.iter().min_by_key(|(class, ready)| {
            let operations = self.pieces.classes[**class].shape.operations.len();
            let waits = ready.len() < self.left[**class];
            (waits, operations, ready.first().copied())
        });
        let class = *classes?.0;
        let ready = self.ready.remove(&class)?;
        self.left[class] -= ready.len();
        Some(ready.into_iter().collect())
    }

    /// Lets those go on that wait for a piece.
    fn done(&mut self, piece: usize) {
        for reader in std::mem::take(&mut self.readers[piece]) {
            self.missing[reader] -= 1;
            if self.missing[reader] == 0 {
                self.admit(reader);
            }
        }
    }
}
