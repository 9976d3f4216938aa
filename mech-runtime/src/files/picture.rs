//! Pictures that are written to files.

use super::FileError;
use crate::Palette;
use crate::raster::{Grid, Indexed, Memory, Soft};

/// A borrowed picture of any size: entries of a palette, or true colours. `From` makes one of a [`Frame`](crate::Frame), a
/// [`Smooth`](crate::Smooth), a [`HeapFrame`](crate::HeapFrame) or a [`HeapSmooth`](crate::HeapSmooth).
///
/// ```
/// use mech_runtime::Palette;
/// use mech_runtime::files::Picture;
///
/// let (blue, paper) = (Palette::BLUE, Palette::PAPER);
/// let entries = [blue, paper, paper, blue, paper, blue];
/// let file = Picture::indexed([3, 2], &entries, &Palette::TEXTBOOK)?.png()?;
/// assert!(file.starts_with(b"\x89PNG"));
/// # Ok::<(), mech_runtime::files::FileError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    size: [usize; 2],
    pub(super) pixels: Pixels<'a>,
}

/// Row by row from the top.
#[derive(Clone, Copy, Debug)]
pub(super) enum Pixels<'a> {
    Indexed(&'a [u8], &'a Palette),
    Rgba(&'a [[u8; 4]]),
}

impl<'a> Picture<'a> {
    /// A picture of this width and height whose pixels are entries of a palette, row by row from the top.
    ///
    /// # Errors
    /// [`FileError::Torn`] if the number of pixels does not match the size.
    pub fn indexed(
        size: [usize; 2],
        entries: &'a [u8],
        palette: &'a Palette,
    ) -> Result<Self, FileError> {
        Self::of(size, entries.len(), Pixels::Indexed(entries, palette))
    }

    /// A picture of this width and height whose pixels are red, green, blue and opacity, row by row from the top.
    ///
    /// # Errors
    /// [`FileError::Torn`] if the number of pixels does not match the size.
    pub fn rgba(size: [usize; 2], pixels: &'a [[u8; 4]]) -> Result<Self, FileError> {
        Self::of(size, pixels.len(), Pixels::Rgba(pixels))
    }

    fn of(size: [usize; 2], found: usize, pixels: Pixels<'a>) -> Result<Self, FileError> {
        let expected = size[0].saturating_mul(size[1]);
        if found == expected {
            Ok(Self { size, pixels })
        } else {
            Err(FileError::Torn { expected, found })
        }
    }

    /// The width and height in pixels.
    #[must_use]
    pub const fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The picture itself, if it has this size.
    pub(super) fn of_size(self, expected: [usize; 2]) -> Result<Self, FileError> {
        if self.size == expected {
            Ok(self)
        } else {
            Err(FileError::OtherSize { expected, found: self.size })
        }
    }

    /// The width and height, in a file that allows `most` pixels in each direction.
    pub(super) fn size_within<N: TryFrom<usize>>(&self, most: usize) -> Result<[N; 2], FileError> {
        let [width, height] = self.size;
        if width == 0 || height == 0 {
            return Err(FileError::Empty);
        }
        match (width.max(height) <= most, N::try_from(width), N::try_from(height)) {
            (true, Ok(width), Ok(height)) => Ok([width, height]),
            _ => Err(FileError::TooLarge { most }),
        }
    }
}

impl<'a, M: Memory> From<&'a Indexed<M>> for Picture<'a> {
    fn from(frame: &'a Indexed<M>) -> Self {
        let grid = frame.grid();
        Self { size: grid.size(), pixels: Pixels::Indexed(grid.all(), frame.palette()) }
    }
}

impl<'a, M: Memory> From<&'a Soft<M>> for Picture<'a> {
    fn from(picture: &'a Soft<M>) -> Self {
        let grid = picture.grid();
        Self { size: grid.size(), pixels: Pixels::Rgba(grid.all()) }
    }
}
