//! Runs of pixels of a row that the sides of a shape touch.

/// The number of separate runs. Of more, neighbours are united.
const MOST: usize = 8;

/// Some runs of pixels in a row, apart from each other and from left to right, each from its first pixel to its last.
#[derive(Clone, Copy)]
pub(super) struct Runs {
    runs: [(u32, u32); MOST],
    len: usize,
}

impl Runs {
    pub(super) const fn new() -> Self {
        Self { runs: [(0, 0); MOST], len: 0 }
    }

    /// Adds a run.
    #[inline]
    pub(super) fn add(&mut self, first: u32, last: u32) {
        let Some(runs) = self.runs.get_mut(..self.len) else {
            return;
        };
        // The first that it does not lie wholly behind: it lies before that, or they are one.
        let place = runs.iter().take_while(|run| run.1 + 1 < first).count();
        match runs.get_mut(place) {
            Some(run) if run.0 <= last + 1 => {
                run.0 = run.0.min(first);
                if last > run.1 {
                    run.1 = last;
                    self.close_up(place);
                }
            }
            _ => self.insert(place, (first, last)),
        }
    }

    /// Takes those together that a run has grown into.
    fn close_up(&mut self, place: usize) {
        while let Some(&next) = self.runs.get(..self.len).and_then(|runs| runs.get(place + 1))
            && let Some(run) = self.runs.get_mut(place)
            && next.0 <= run.1 + 1
        {
            run.1 = run.1.max(next.1);
            // Those behind it move up, from the last on.
            let behind = self.runs.get_mut(place + 1..self.len);
            let mut hand = (0, 0);
            for place in behind.unwrap_or_default().iter_mut().rev() {
                core::mem::swap(place, &mut hand);
            }
            self.len -= 1;
        }
    }

    fn insert(&mut self, place: usize, run: (u32, u32)) {
        if self.len == MOST {
            // The nearest before it, or else after it, takes it in.
            let near = place.saturating_sub(1);
            if let Some(near) = self.runs.get_mut(near) {
                *near = (near.0.min(run.0), near.1.max(run.1));
            }
            return;
        }
        // Those behind it make room, one after the other.
        let mut hand = run;
        for place in self.runs.get_mut(place..=self.len).unwrap_or_default() {
            core::mem::swap(place, &mut hand);
        }
        self.len += 1;
    }

    /// All of them; they are forgotten.
    #[inline]
    pub(super) fn take(&mut self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let len = core::mem::take(&mut self.len);
        let runs = self.runs.into_iter().take(len);
        runs.map(|(first, last)| (first as usize, last as usize))
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::Runs;
    use proptest::prelude::*;
    use std::vec::Vec;

    proptest! {
        #[test]
        fn every_pixel_is_in_one_run(added in prop::collection::vec((0_u32..90, 0_u32..12), 0..40)) {
            let mut runs = Runs::new();
            for &(first, more) in &added {
                runs.add(first, first + more);
            }
            let taken: Vec<_> = runs.take().collect();
            prop_assert!(taken.windows(2).all(|pair| pair[0].1 < pair[1].0), "{taken:?}");
            for (first, more) in added {
                let ends = (first as usize, (first + more) as usize);
                prop_assert!(taken.iter().any(|run| run.0 <= ends.0 && ends.1 <= run.1), "{ends:?} in {taken:?}");
            }
            prop_assert_eq!(runs.take().count(), 0);
        }
    }
}
