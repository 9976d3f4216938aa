//! Pictures in true colour.

use mech_runtime::files::{self, FileError};

/// A picture in true colour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The width in pixels.
    pub width: u16,
    /// The height in pixels.
    pub height: u16,
    /// Red, green, blue and opacity, row by row from the top.
    pub pixels: Vec<[u8; 4]>,
}

impl Picture {
    /// The width and height in pixels.
    pub(crate) fn size(&self) -> [usize; 2] {
        [self.width, self.height].map(usize::from)
    }

    /// The bytes of a PNG file of the picture.
    ///
    /// # Errors
    /// [`FileError`] if the number of pixels does not match the size, or is zero.
    pub fn png(&self) -> Result<Vec<u8>, FileError> {
        files::Picture::rgba(self.size(), &self.pixels)?.png()
    }
}
