//! PNG files.

use super::FileError;
use super::picture::{Picture, Pixels};
use crate::raster::{Indexed, Memory, Soft};
use std::io::Write;
use std::path::Path;
use std::vec::Vec;

/// The most pixels in one direction.
pub(super) const MOST: usize = 0x7FFF_FFFF;

impl Picture<'_> {
    /// The bytes of a PNG file of the picture.
    ///
    /// A picture with a palette takes 8 bits per pixel, and the palette up to the last entry that is used. A picture in true colour has
    /// opacity only if some pixel is not opaque.
    ///
    /// # Errors
    /// [`FileError`] if the picture has no pixels.
    pub fn png(self) -> Result<Vec<u8>, FileError> {
        let mut bytes = Vec::new();
        self.write_png(&mut bytes)?;
        Ok(bytes)
    }

    /// Writes a PNG file of the picture to this path, and overwrites an existing file.
    ///
    /// # Errors
    /// [`FileError`] if the picture has no pixels, or if the file cannot be written. Without pixels no file is made.
    pub fn save(self, path: impl AsRef<Path>) -> Result<(), FileError> {
        Ok(std::fs::write(path, self.png()?)?)
    }

    /// Writes the bytes of a PNG file of the picture.
    ///
    /// # Errors
    /// [`FileError`] if the picture has no pixels, or if the writer fails.
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
                let colors = pixels.iter().map(|&[red, green, blue, _]| [red, green, blue]);
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

/// Sets the kind and the compression of the pixels.
pub(super) fn compress<W: Write>(encoder: &mut png::Encoder<'_, W>, pixels: Pixels<'_>) {
    encoder.set_color(match pixels {
        Pixels::Indexed(..) => png::ColorType::Indexed,
        Pixels::Rgba(_) => png::ColorType::Rgba,
    });
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    // Areas of one colour: repetitions compress better than differences.
    encoder.set_filter(png::Filter::NoFilter);
}

/// The methods that write a picture to a PNG file.
macro_rules! png_files {
    ($($Picture:ident)*) => {
        $(
            impl<M: Memory> $Picture<M> {
                /// The bytes of a PNG file of the picture. With feature `std`.
                ///
                /// A picture with a palette takes 8 bits per pixel, and the palette up to the last entry that is used.
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
                /// [`FileError`] if the picture has no pixels.
                pub fn png(&self) -> Result<Vec<u8>, FileError> {
                    Picture::from(self).png()
                }

                /// Writes a PNG file of the picture to this path, and overwrites an existing file. With feature `std`.
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
                /// [`FileError`] if the picture has no pixels, or if the file cannot be written.
                pub fn save(&self, path: impl AsRef<Path>) -> Result<(), FileError> {
                    Picture::from(self).save(path)
                }
            }
        )*
    };
}

png_files!(Indexed Soft);
