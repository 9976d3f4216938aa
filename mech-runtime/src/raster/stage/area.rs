//! Rectangles of pixels that must be painted again.

use crate::raster::spans::Clip;

/// The most rectangles. Of more, those that lie next to each other are united.
const MOST: usize = 12;
/// The cost for a display to begin with a rectangle, in pixels.
const BEGIN: usize = 600;
/// The cost of painting one more rectangle, in pixels: shapes that lie in both are begun twice.
const PAINT: usize = 40_000;

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Area {
    /// The first column, from the left.
    pub x: usize,
    /// The first row, from the top.
    pub y: usize,
    /// The number of columns.
    pub width: usize,
    /// The number of rows.
    pub height: usize,
}

impl From<Clip> for Area {
    fn from(clip: Clip) -> Self {
        Self {
            x: clip.left,
            y: clip.top,
            width: clip.right.saturating_sub(clip.left),
            height: clip.bottom.saturating_sub(clip.top),
        }
    }
}

/// Some rectangles.
#[derive(Clone)]
pub(super) struct Areas {
    areas: [Clip; MOST],
    len: usize,
}

impl Areas {
    pub(super) const fn new() -> Self {
        Self { areas: [Clip::none(); MOST], len: 0 }
    }

    pub(super) const fn len(&self) -> usize {
        self.len
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.len == 0
    }

    pub(super) fn get(&self, index: usize) -> Clip {
        let areas = self.areas.get(..self.len).unwrap_or_default();
        areas.get(index).copied().unwrap_or(Clip::none())
    }

    /// The same rectangles, or fewer larger ones that cost less to paint.
    pub(super) fn to_be_painted(&self) -> Self {
        let mut larger = Self::new();
        for area in self.areas.iter().take(self.len) {
            larger.add_for(*area, PAINT);
        }
        larger
    }

    /// Adds a rectangle, or enlarges another where that costs less.
    pub(super) fn add(&mut self, area: Clip) {
        self.add_for(area, BEGIN);
    }

    fn add_for(&mut self, area: Clip, begin: usize) {
        let mut area = area;
        if area.is_empty() {
            return;
        }
        loop {
            let areas = self.areas.get(..self.len).unwrap_or_default();
            let more = |other: &Clip| other.around(area).area().saturating_sub(other.area());
            let nearest = (0..).zip(areas).min_by_key(|(_, other)| more(other));
            let is_full = self.len == MOST;
            match nearest {
                Some((index, near)) if is_full || more(near) <= area.area() + begin => {
                    // Taken out, and added as one: it may now come near another.
                    area = near.around(area);
                    self.len -= 1;
                    let last = self.areas.get(self.len).copied();
                    if let (Some(place), Some(last)) = (self.areas.get_mut(index), last) {
                        *place = last;
                    }
                }
                _ => break,
            }
        }
        if let Some(place) = self.areas.get_mut(self.len) {
            *place = area;
            self.len += 1;
        }
    }
}
