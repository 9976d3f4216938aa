//! A picture as PNG.

use super::FileError;
use super::picture::{Picture, Pixels};
use crate::Frame;
use std::io::Write;
use std::vec::Vec;

/// The most pixels in one direction.
pub(super) const MOST: usize = 0x7FFF_FFFF;

impl Picture<'_> {
    /// The bytes of a PNG file of it: of a picture with a palette, 8 bits a pixel and the palette up to the last entry that is used.
    ///
    /// # Errors
    /// [`FileError`] if it is empty.
    pub fn png(self) -> Result<Vec<u8>, FileError> {
        let mut bytes = Vec::new();
        self.write_png(&mut bytes)?;
        Ok(bytes)
    }

    /// Writes the same to a writer.
    ///
    /// # Errors
    /// [`FileError`] if it is empty, or if the writer fails.
    pub fn write_png(self, writer: impl Write) -> Result<(), FileError> {
        let [width, height] = self.size_within(MOST)?;
        let mut encoder = png::Encoder::new(writer, width, height);
        compress(&mut encoder, self.pixels);
        let bytes = match self.pixels {
            Pixels::Indexed(entries, palette) => {
                let last = entries.iter().copied().max().unwrap_or_default();
                let used = palette.entries().iter().take(usize::from(last) + 1);
                encoder.set_palette(used.flatten().copied().collect::<Vec<_>>());
                entries
            }
            Pixels::Rgba(pixels) => pixels.as_flattened(),
        };
        let mut writer = encoder.write_header()?;
        writer.write_image_data(bytes)?;
        Ok(writer.finish()?)
    }
}

/// Says of which kind the pixels are, and how they are compressed.
pub(super) fn compress<W: Write>(encoder: &mut png::Encoder<'_, W>, pixels: Pixels<'_>) {
    let (color, filter) = match pixels {
        // Differences of entries mean nothing.
        Pixels::Indexed(..) => (png::ColorType::Indexed, png::Filter::NoFilter),
        Pixels::Rgba(_) => (png::ColorType::Rgba, png::Filter::Adaptive),
    };
    encoder.set_color(color);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    encoder.set_filter(filter);
}

impl<const W: usize, const H: usize> Frame<W, H> {
    /// The bytes of a PNG file of it: 8 bits a pixel, and the palette up to the last entry that is used. With feature `std`.
    ///
    /// ```
    /// use mech_runtime::Frame;
    ///
    /// let file = Frame::<64, 48>::new().png()?; // for `std::fs::write("frame.png", file)`
    /// assert!(file.starts_with(b"\x89PNG"));
    /// # Ok::<(), mech_runtime::files::FileError>(())
    /// ```
    ///
    /// # Errors
    /// [`FileError`] if it is 0 pixels wide or high.
    pub fn png(&self) -> Result<Vec<u8>, FileError> {
        Picture::from(self).png()
    }
}
