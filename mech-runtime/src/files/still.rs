//! A picture as PNG.

use super::FileError;
use super::picture::{Picture, Pixels};
use crate::raster::{Indexed, Memory, Soft};
use std::io::Write;
use std::path::Path;
use std::vec::Vec;

/// The most pixels in one direction.
pub(super) const MOST: usize = 0x7FFF_FFFF;

impl Picture<'_> {
    /// The bytes of a PNG file of it: of a picture with a palette, 8 bits a pixel and the palette up to the last entry that is used; of
    /// one in true colour, opacity only if it has any part that is not opaque.
    ///
    /// # Errors
    /// [`FileError`] if it is empty.
    pub fn png(self) -> Result<Vec<u8>, FileError> {
        let mut bytes = Vec::new();
        self.write_png(&mut bytes)?;
        Ok(bytes)
    }

    /// Makes a PNG file of it at this path, whatever that ends in; a file that is there is overwritten.
    ///
    /// # Errors
    /// [`FileError`] if it is empty, or if the file cannot be written. Of an empty picture no file is made.
    pub fn save(self, path: impl AsRef<Path>) -> Result<(), FileError> {
        Ok(std::fs::write(path, self.png()?)?)
    }

    /// Writes the same to a writer.
    ///
    /// # Errors
    /// [`FileError`] if it is empty, or if the writer fails.
    pub fn write_png(self, writer: impl Write) -> Result<(), FileError> {
        let [width, height] = self.size_within(MOST)?;
        let mut encoder = png::Encoder::new(writer, width, height);
        compress(&mut encoder, self.pixels);
        let opaque: Vec<u8>;
        let bytes = match self.pixels {
            Pixels::Indexed(entries, palette) => {
                let last = entries.iter().copied().max().unwrap_or_default();
                let used = palette.entries().iter().take(usize::from(last) + 1);
                encoder.set_palette(used.flatten().copied().collect::<Vec<_>>());
                entries
            }
            Pixels::Rgba(pixels) if pixels.iter().all(|pixel| pixel[3] == u8::MAX) => {
                encoder.set_color(png::ColorType::Rgb);
                let colors = pixels
                    .iter()
                    .map(|&[red, green, blue, _]| [red, green, blue]);
                opaque = colors.flatten().collect();
                &opaque
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
    encoder.set_color(match pixels {
        Pixels::Indexed(..) => png::ColorType::Indexed,
        Pixels::Rgba(_) => png::ColorType::Rgba,
    });
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    // Areas of one colour: what repeats itself says more than differences.
    encoder.set_filter(png::Filter::NoFilter);
}

impl<M: Memory> Indexed<M> {
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

    /// Makes a PNG file of it at this path, whatever that ends in; a file that is there is overwritten. With feature `std`.
    ///
    /// # Errors
    /// [`FileError`] if it is 0 pixels wide or high, or if the file cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), FileError> {
        Picture::from(self).save(path)
    }
}

impl<M: Memory> Soft<M> {
    /// The bytes of a PNG file of it, in true colour. With feature `std`.
    ///
    /// # Errors
    /// [`FileError`] if it is 0 pixels wide or high.
    pub fn png(&self) -> Result<Vec<u8>, FileError> {
        Picture::from(self).png()
    }
    /// Makes a PNG file of it at this path, whatever that ends in; a file that is there is overwritten. With feature `std`.
    ///
    /// ```
    /// use mech_runtime::{HeapSmooth, mechanism};
    ///
    /// mechanism! {
    ///     struct Crank;
    ///     link crank { bar [(0, 0), (1, 0)] width 0.3; }
    ///     joint a = revolute(ground, crank) at (0, 0);
    ///     motor a;
    /// }
    /// let crank = Crank::new();
    /// let mut picture = HeapSmooth::of::<Crank>(1920, 1080)?;     // 8 MB on the heap, none on the stack
    /// crank.draw(&mut picture);
    /// # let path = std::env::temp_dir().join(format!("mech-{}.png", std::process::id()));
    /// picture.save(&path)?;                                       // such as "crank.png"
    /// # assert!(std::fs::read(&path)?.starts_with(b"\x89PNG"));
    /// # std::fs::remove_file(&path)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`FileError`] if it is 0 pixels wide or high, or if the file cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), FileError> {
        Picture::from(self).save(path)
    }
}
