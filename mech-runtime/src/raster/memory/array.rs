//! Pixels of a picture whose size is fixed at compile time.

use super::{Grid, Store};
use crate::raster::fixed;
use crate::raster::stage::Item;
use core::ops::Range;

/// `W` × `H` pixels in the picture itself: on the stack, in a static, or wherever the picture lies.
///
/// A picture has at most 2²¹ pixels in one direction. This does not compile:
///
/// ```compile_fail
/// let frame = mech_runtime::Frame::<2_097_153, 1>::new();
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Array<const W: usize, const H: usize> {}

impl<const W: usize, const H: usize> Array<W, H> {
    /// Fails to compile for a picture that is too large.
    pub(in crate::raster) const IS_PAINTABLE: () = assert!(
        W == 0 || H == 0 || (W <= fixed::MOST && H <= fixed::MOST),
        "a picture is at most 2,097,152 pixels wide and high"
    );
}

impl<const W: usize, const H: usize> Store for Array<W, H> {
    const PREFIX: &'static str = "";
    type Pixels<P: Copy + PartialEq> = [[P; W]; H];
    type Gains = [f32; W];
    type Places<const N: usize> = [Item; N];
}

impl<P, const W: usize, const H: usize> Grid<P> for [[P; W]; H] {
    type Row = [P; W];

    #[inline]
    fn size(&self) -> [usize; 2] {
        [W, H]
    }

    #[inline]
    fn row(&self, y: usize) -> Option<&[P; W]> {
        self.get(y)
    }

    #[inline]
    fn row_mut(&mut self, y: usize) -> Option<&mut [P; W]> {
        self.get_mut(y)
    }

    #[inline]
    fn rows<'g>(&'g self, rows: Range<usize>) -> impl Iterator<Item = &'g [P; W]>
    where
        P: 'g,
    {
        self.get(rows).unwrap_or_default().iter()
    }

    #[inline]
    fn rows_mut<'g>(&'g mut self, rows: Range<usize>) -> impl Iterator<Item = &'g mut [P; W]>
    where
        P: 'g,
    {
        self.get_mut(rows).unwrap_or_default().iter_mut()
    }

    #[inline]
    fn all(&self) -> &[P] {
        self.as_flattened()
    }

    #[inline]
    fn all_mut(&mut self) -> &mut [P] {
        self.as_flattened_mut()
    }
}
