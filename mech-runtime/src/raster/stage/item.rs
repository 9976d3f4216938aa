//! Items: the outlines and texts of a stage, one after the other.

use super::area::Areas;
use crate::raster::spans::Clip;
#[cfg(feature = "std")]
use std::vec::Vec;

/// An outline or a text that is painted.
#[derive(Clone, Copy)]
pub struct Item {
    /// A hash of its geometry in pixels. Two different items have the same hash once in 10¹⁹ times.
    pub(super) mark: u64,
    /// A rectangle around it.
    pub(super) clip: Clip,
}

impl Item {
    pub(super) const NONE: Self = Self { mark: 0, clip: Clip::none() };
}

/// Memory for items, in numbered slots.
pub trait Places: AsRef<[Item]> {
    /// The slot of this number, if there is one.
    fn place(&mut self, number: usize) -> Option<&mut Item>;
}

/// A fixed number of slots.
impl<const N: usize> Places for [Item; N] {
    #[inline]
    fn place(&mut self, number: usize) -> Option<&mut Item> {
        self.get_mut(number)
    }
}

/// As many slots as there is memory for.
#[cfg(feature = "std")]
impl Places for Vec<Item> {
    fn place(&mut self, number: usize) -> Option<&mut Item> {
        if number == self.len() && self.try_reserve(1).is_ok() {
            self.push(Item::NONE);
        }
        self.get_mut(number)
    }
}

/// The items that were painted last. Those beyond the last slot count as one.
#[derive(Clone)]
pub(super) struct Items<P> {
    slots: P,
    /// The number of items before, and now.
    before: usize,
    now: usize,
    /// The number of leading items that are unchanged.
    alike: usize,
    /// The items without a slot together: before, and now.
    remainder_before: Item,
    remainder: Item,
}

impl<P> Items<P> {
    /// No items, with these slots.
    pub(super) const fn new(slots: P) -> Self {
        Self {
            slots,
            before: 0,
            now: 0,
            alike: 0,
            remainder_before: Item::NONE,
            remainder: Item::NONE,
        }
    }
}

impl<P: Places> Items<P> {
    /// Begins to compare all items again.
    pub(super) const fn begin(&mut self) {
        self.before = self.now;
        (self.now, self.alike) = (0, 0);
        self.remainder_before = self.remainder;
        self.remainder = Item::NONE;
    }

    /// Adds the next item. If it has changed, its old and its new rectangle must be painted again.
    pub(super) fn add(&mut self, item: Item, changed: &mut Areas) {
        if let Some(place) = self.slots.place(self.now) {
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
            let mark = mix(self.remainder.mark, item.mark);
            let clip = self.remainder.clip.around(item.clip);
            self.remainder = Item { mark, clip };
        }
        self.now += 1;
    }

    /// Ends the comparison. Returns the number of leading items that are unchanged and have a slot.
    pub(super) fn end(&self, changed: &mut Areas) -> usize {
        let slots = self.slots.as_ref();
        let removed = slots.get(self.now..self.before.min(slots.len()));
        for item in removed.unwrap_or_default() {
            changed.add(item.clip);
        }
        if self.remainder.mark != self.remainder_before.mark {
            changed.add(self.remainder_before.clip);
            changed.add(self.remainder.clip);
        }
        self.alike
    }

    /// A rectangle around the item of this number.
    pub(super) fn clip(&self, number: usize) -> Clip {
        self.slots.as_ref().get(number).unwrap_or(&self.remainder).clip
    }
}

/// Mixes a number into a hash.
#[inline]
pub(super) const fn mix(mark: u64, bits: u64) -> u64 {
    let product = (mark ^ bits).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    product ^ (product >> 29)
}
