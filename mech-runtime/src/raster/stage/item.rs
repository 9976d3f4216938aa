//! What is painted, one thing after the other: where it is seen, and whether it is as before.

use super::area::Areas;
use crate::raster::spans::Clip;

/// One thing that is painted.
#[derive(Clone, Copy)]
pub(super) struct Item {
    /// All that it is made of, in pixels, as one number: two things that differ have the same one time in 10¹⁹.
    pub(super) mark: u64,
    /// Where it is seen at most.
    pub(super) clip: Clip,
}

impl Item {
    const NONE: Self = Self {
        mark: 0,
        clip: Clip::none(),
    };
}

/// The things that were painted last, those beyond the last place together.
#[derive(Clone)]
pub(super) struct Items<const N: usize> {
    kept: [Item; N],
    /// How many there were, and how many there are now.
    before: usize,
    now: usize,
    /// How many of the first are as before.
    alike: usize,
    /// All that have no place of their own: as they were, and as they are.
    rest_before: Item,
    rest: Item,
}

impl<const N: usize> Items<N> {
    pub(super) const fn new() -> Self {
        Self {
            kept: [Item::NONE; N],
            before: 0,
            now: 0,
            alike: 0,
            rest_before: Item::NONE,
            rest: Item::NONE,
        }
    }

    /// Now they are told again.
    pub(super) const fn begin(&mut self) {
        self.before = self.now;
        (self.now, self.alike) = (0, 0);
        self.rest_before = self.rest;
        self.rest = Item::NONE;
    }

    /// The next one: where it has changed, what it leaves and what it covers has to be painted again.
    pub(super) fn tell(&mut self, item: Item, changed: &mut Areas) {
        if let Some(place) = self.kept.get_mut(self.now) {
            let is_new = self.now >= self.before;
            let old = core::mem::replace(place, item);
            if is_new {
                changed.add(item.clip);
            } else if old.mark != item.mark {
                changed.add(old.clip);
                changed.add(item.clip);
            } else if self.alike == self.now {
                self.alike += 1;
            }
        } else {
            let mark = mixed(self.rest.mark, item.mark);
            let clip = self.rest.clip.around(item.clip);
            self.rest = Item { mark, clip };
        }
        self.now += 1;
    }

    /// That was all: gives how many of the first are as before, and have a place of their own.
    pub(super) fn end(&self, changed: &mut Areas) -> usize {
        let gone = self.kept.get(self.now..self.before.min(N));
        for item in gone.unwrap_or_default() {
            changed.add(item.clip);
        }
        if self.rest.mark != self.rest_before.mark {
            changed.add(self.rest_before.clip);
            changed.add(self.rest.clip);
        }
        self.alike
    }

    /// Where the thing of this number is seen at most.
    pub(super) fn clip(&self, number: usize) -> Clip {
        self.kept.get(number).unwrap_or(&self.rest).clip
    }
}

/// A number in which another is mixed.
#[inline]
pub(super) const fn mixed(mark: u64, bits: u64) -> u64 {
    let product = (mark ^ bits).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    product ^ (product >> 29)
}
