//! What is painted, one thing after the other: where it is seen, and whether it is as before.

use super::area::Areas;
use crate::raster::spans::Clip;
#[cfg(feature = "std")]
use std::vec::Vec;

/// One thing that is painted.
#[derive(Clone, Copy)]
pub struct Item {
    /// All that it is made of, in pixels, as one number: two things that differ have the same one time in 10¹⁹.
    pub(super) mark: u64,
    /// Where it is seen at most.
    pub(super) clip: Clip,
}

impl Item {
    pub(super) const NONE: Self = Self {
        mark: 0,
        clip: Clip::none(),
    };
}

/// Places for things.
pub trait Places: AsRef<[Item]> {
    /// The place of this number, if there is one.
    fn place(&mut self, number: usize) -> Option<&mut Item>;
}

/// As many as there are.
impl<const N: usize> Places for [Item; N] {
    #[inline]
    fn place(&mut self, number: usize) -> Option<&mut Item> {
        self.get_mut(number)
    }
}

/// As many as are asked for one after the other, while there is memory.
#[cfg(feature = "std")]
impl Places for Vec<Item> {
    fn place(&mut self, number: usize) -> Option<&mut Item> {
        if number == self.len() && self.try_reserve(1).is_ok() {
            self.push(Item::NONE);
        }
        self.get_mut(number)
    }
}

/// The things that were painted last, those beyond the last place together.
#[derive(Clone)]
pub(super) struct Items<P> {
    kept: P,
    /// How many there were, and how many there are now.
    before: usize,
    now: usize,
    /// How many of the first are as before.
    alike: usize,
    /// All that have no place of their own: as they were, and as they are.
    rest_before: Item,
    remainder: Item,
}

impl<P> Items<P> {
    /// None yet, with places for some.
    pub(super) const fn new(places: P) -> Self {
        Self {
            kept: places,
            before: 0,
            now: 0,
            alike: 0,
            rest_before: Item::NONE,
            remainder: Item::NONE,
        }
    }
}

impl<P: Places> Items<P> {
    /// Now they are told again.
    pub(super) const fn begin(&mut self) {
        self.before = self.now;
        (self.now, self.alike) = (0, 0);
        self.rest_before = self.remainder;
        self.remainder = Item::NONE;
    }

    /// The next one: where it has changed, what it leaves and what it covers has to be painted again.
    pub(super) fn tell(&mut self, item: Item, changed: &mut Areas) {
        if let Some(place) = self.kept.place(self.now) {
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
            let mark = mixed(self.remainder.mark, item.mark);
            let clip = self.remainder.clip.around(item.clip);
            self.remainder = Item { mark, clip };
        }
        self.now += 1;
    }

    /// That was all: gives how many of the first are as before, and have a place of their own.
    pub(super) fn end(&self, changed: &mut Areas) -> usize {
        let kept = self.kept.as_ref();
        let gone = kept.get(self.now..self.before.min(kept.len()));
        for item in gone.unwrap_or_default() {
            changed.add(item.clip);
        }
        if self.remainder.mark != self.rest_before.mark {
            changed.add(self.rest_before.clip);
            changed.add(self.remainder.clip);
        }
        self.alike
    }

    /// Where the thing of this number is seen at most.
    pub(super) fn clip(&self, number: usize) -> Clip {
        self.kept
            .as_ref()
            .get(number)
            .unwrap_or(&self.remainder)
            .clip
    }
}

/// A number in which another is mixed.
#[inline]
pub(super) const fn mixed(mark: u64, bits: u64) -> u64 {
    let product = (mark ^ bits).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    product ^ (product >> 29)
}
