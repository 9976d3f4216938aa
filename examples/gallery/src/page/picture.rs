//! A picture in true colour.

use mech_runtime::files::{self, FileError};

/// A picture in true colour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// In pixels.
    pub width: u16,
    /// In pixels.
    pub height: u16,
    /// Red, green, blue and opacity, row by row from the top.
    pub pixels: Vec<[u8; 4]>,
}

impl Picture {
    /// Its width and height.
    pub(crate) fn size(&self) -> [usize; 2] {
        [self.width, self.height].map(usize::from)
    }

    /// The bytes of a PNG file of it.
    ///
    /// # Errors
    /// [`FileError`] if there are not as many pixels as its size says, or none.
    pub fn png(&self) -> Result<Vec<u8>, FileError> {
        files::Picture::rgba(self.size(), &self.pixels)?.png()
    }
}
