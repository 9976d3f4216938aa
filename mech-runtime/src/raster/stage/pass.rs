//! A pass: one call of the function that paints a stage.

use super::area::Areas;
use super::extent::Extent;
use super::item::Items;
use crate::raster::memory::{Grid, Memory};
use crate::raster::spans::Clip;
use crate::raster::{Canvas, Indexed, View, paint};
use crate::{Outline, Pose, Real, Scalar};
use core::ops::Range;

/// The task of a pass.
#[derive(Clone)]
pub(super) enum Task {
    /// Compares all items with those before.
    Compare,
    /// Paints the items of these numbers.
    Ground(Range<usize>),
    /// Paints the items from this number on, within a rectangle.
    Paint(usize, Clip),
}

/// The [`Canvas`] of a [`Stage`](super::Stage).
pub struct Pass<'s, M: Memory, const N: usize> {
    frame: &'s mut Indexed<M>,
    view: View,
    items: &'s mut Items<M::Places<N>>,
    changed: &'s mut Areas,
    task: Task,
    /// The number of the next item.
    next: usize,
}

impl<'s, M: Memory, const N: usize> Pass<'s, M, N> {
    pub(super) fn new(
        frame: &'s mut Indexed<M>,
        view: View,
        items: &'s mut Items<M::Places<N>>,
        changed: &'s mut Areas,
        task: Task,
    ) -> Self {
        Self { frame, view, items, changed, task, next: 0 }
    }

    /// The rectangle in which the next item is to be painted, if it is.
    fn clip(&mut self) -> Option<Clip> {
        let number = self.next;
        self.next += 1;
        let within = match &self.task {
            Task::Compare => return None,
            Task::Ground(numbers) => numbers.contains(&number).then(|| self.frame.whole()),
            Task::Paint(first, within) => (number >= *first).then_some(*within),
        };
        let clip = within?.and(self.items.clip(number));
        (!clip.is_empty()).then_some(within?)
    }
}

impl<T: Scalar, M: Memory, const N: usize> Canvas<T> for Pass<'_, M, N> {
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8) {
        let size = self.frame.grid().size();
        let projection = self.view.projection::<T>(size);
        if matches!(self.task, Task::Compare) {
            let item = Extent::of_outline(projection, outline, pose, color).item(size);
            self.items.add(item, self.changed);
        } else if let Some(clip) = self.clip() {
            let mut part = self.frame.part(clip);
            paint::outline(&mut part, projection, outline, pose, color);
        }
    }

    fn text(&mut self, place: [T; 2], text: &str, color: u8) {
        let size = self.frame.grid().size();
        let place = self.view.projection::<T>(size).point(place);
        if matches!(self.task, Task::Compare) {
            let item = Extent::of_text(place, text, color).item(size);
            self.items.add(item, self.changed);
        } else if let Some(clip) = self.clip() {
            paint::text(&mut self.frame.part(clip), place, text, color);
        }
    }

    fn scale(&self) -> T {
        Real::from_f64(self.view.scale())
    }
}
