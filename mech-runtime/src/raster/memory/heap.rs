//! Pixels of a picture whose size is chosen at run time.

use super::{Grid, Store};
use crate::raster::fixed;
use crate::raster::stage::Item;
use core::fmt;
use core::ops::Range;
use std::vec::Vec;

/// Pixels on the heap, in a picture whose size is chosen at run time. With feature `std`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heap {}

impl Store for Heap {
    const PREFIX: &'static str = "Heap";
    type Pixels<P: Copy + PartialEq> = Block<P>;
    type Gains = Vec<f32>;
    type Places<const N: usize> = Vec<Item>;
}

/// The pixels of a picture.
#[derive(Clone, PartialEq)]
pub struct Block<P> {
    pixels: Vec<P>,
    width: usize,
    height: usize,
}

impl<P: Copy> Block<P> {
    /// Pixels of one colour.
    pub(in crate::raster) fn new(pixel: P, size: [usize; 2]) -> Result<Self, TooLarge> {
        let [width, height] = size;
        if width.max(height) > fixed::MOST {
            return Err(TooLarge::Sides(size));
        }
        // Where a `usize` has 32 bits, this too may overflow.
        let count = width.checked_mul(height);
        let pixels = count.and_then(|count| repeat(pixel, count));
        Ok(Self { pixels: pixels.ok_or(TooLarge::Memory(size))?, width, height })
    }
}

impl<P> Block<P> {
    /// The places of the pixels of some rows. `None` if a row does not exist.
    #[inline]
    fn places(&self, rows: Range<usize>) -> Option<Range<usize>> {
        (rows.end <= self.height).then(|| rows.start * self.width..rows.end * self.width)
    }

    /// The number of pixels in a row, at least 1.
    #[inline]
    const fn step(&self) -> usize {
        if self.width == 0 { 1 } else { self.width }
    }
}

impl<P> Grid<P> for Block<P> {
    type Row = [P];

    #[inline]
    fn size(&self) -> [usize; 2] {
        [self.width, self.height]
    }

    #[inline]
    fn row(&self, y: usize) -> Option<&[P]> {
        self.pixels.get(self.places(y..y.checked_add(1)?)?)
    }

    #[inline]
    fn row_mut(&mut self, y: usize) -> Option<&mut [P]> {
        let places = self.places(y..y.checked_add(1)?)?;
        self.pixels.get_mut(places)
    }

    #[inline]
    fn rows<'g>(&'g self, rows: Range<usize>) -> impl Iterator<Item = &'g [P]>
    where
        P: 'g,
    {
        let pixels = self.places(rows).and_then(|places| self.pixels.get(places));
        pixels.unwrap_or_default().chunks_exact(self.step())
    }

    #[inline]
    fn rows_mut<'g>(&'g mut self, rows: Range<usize>) -> impl Iterator<Item = &'g mut [P]>
    where
        P: 'g,
    {
        let (places, step) = (self.places(rows), self.step());
        let pixels = places.and_then(|places| self.pixels.get_mut(places));
        pixels.unwrap_or_default().chunks_exact_mut(step)
    }

    #[inline]
    fn all(&self) -> &[P] {
        &self.pixels
    }

    #[inline]
    fn all_mut(&mut self) -> &mut [P] {
        &mut self.pixels
    }
}

/// So many equal parts, if there is memory for them.
pub(in crate::raster) fn repeat<P: Copy>(part: P, count: usize) -> Option<Vec<P>> {
    let mut parts = Vec::new();
    parts.try_reserve_exact(count).ok()?;
    parts.resize(count, part);
    Some(parts)
}

/// The error of a picture on the heap that could not be made, with its width and height in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TooLarge {
    /// A side exceeds 2²¹ pixels.
    Sides([usize; 2]),
    /// There is no memory for the pixels.
    Memory([usize; 2]),
}

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sides([width, height]) => write!(
                f,
                "a picture of {width} × {height} pixels has more than {} in one direction",
                fixed::MOST
            ),
            Self::Memory([width, height]) => {
                write!(f, "there is no memory for a picture of {width} × {height} pixels")
            }
        }
    }
}

impl core::error::Error for TooLarge {}
