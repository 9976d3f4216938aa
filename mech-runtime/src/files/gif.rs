//! Animated GIF.

use super::Clock;
use super::FileError;
use super::patch::Patch;
use super::picture::{Picture, Pixels};
use super::table::Table;
use crate::Palette;
use core::fmt;
use std::io::Write;
use std::time::Duration;
use std::vec::Vec;

/// An endless GIF, written frame by frame. Only the last frame stays in memory.
///
/// All frames share the colours of the first one's palette. A frame with another colour has a table of its own. Each frame holds the
/// rectangle that has changed. With less than 256 different colours, it holds only the changed pixels.
///
/// ```
/// use mech_runtime::files::Gif;
/// use mech_runtime::{Canvas, Frame, Outline, Palette, Pose, View};
/// use std::time::Duration;
///
/// let mut frame = Frame::<64, 48>::new();
/// let mut file = Vec::new(); // or a `BufWriter` of a `File`
/// let mut gif = Gif::new(&mut file, &frame, Duration::from_millis(40))?;
/// for x in 0..10 {
///     frame.clear();
///     let circle = Outline::Circle { center: [f64::from(x), 0.0], radius: 8.0 };
///     frame.fill(circle, Pose::identity(), Palette::BLUE);
///     gif.add(&frame)?;
/// }
/// gif.finish()?;
/// assert!(file.starts_with(b"GIF89a"));
/// # Ok::<(), mech_runtime::files::FileError>(())
/// ```
pub struct Gif<W: Write> {
    encoder: gif::Encoder<W>,
    size: [usize; 2],
    table: Table,
    clock: Clock,
    before: Vec<[u8; 3]>,
}

impl<W: Write> Gif<W> {
    /// Writes the first frame. Each is shown for `delay`, in hundredths of a second. Other delays are right on average. Browsers show
    /// frames of less than 20 ms for 100 ms.
    ///
    /// # Errors
    /// [`FileError`] if the frame is empty, in true colour or larger than 65,535 pixels, if `delay` exceeds 655 seconds, or if the writer
    /// fails.
    pub fn new<'a>(
        writer: W,
        first: impl Into<Picture<'a>>,
        delay: Duration,
    ) -> Result<Self, FileError> {
        let first = first.into();
        let size = first.size_within::<u16>(u16::MAX.into())?;
        let (entries, palette) = entries_of(first)?;
        let clock = Clock::new(delay, Duration::from_millis(10))?;
        let table = Table::of(palette);
        let mut encoder = gif::Encoder::new(writer, size[0], size[1], table.bytes())?;
        encoder.set_repeat(gif::Repeat::Infinite)?;
        let mut gif = Self { encoder, size: first.size(), table, clock, before: Vec::new() };
        gif.write(entries, palette)?;
        Ok(gif)
    }

    /// Adds a frame.
    ///
    /// # Errors
    /// [`FileError`] if it has another size or is in true colour: then it is as if it had not been tried. Also if the writer fails: then the
    /// file is torn.
    pub fn add<'a>(&mut self, frame: impl Into<Picture<'a>>) -> Result<(), FileError> {
        let frame = frame.into().of_size(self.size)?;
        let (entries, palette) = entries_of(frame)?;
        self.write(entries, palette)
    }

    /// Ends the file.
    ///
    /// # Errors
    /// [`FileError::Write`] if the writer fails.
    pub fn finish(self) -> Result<(), FileError> {
        let mut writer = self.encoder.into_inner()?;
        Ok(writer.flush()?)
    }

    fn write(&mut self, pixels: &[u8], palette: &Palette) -> Result<(), FileError> {
        let own_table;
        let (table, mut entries) = if let Ok(entries) = self.table.entries(pixels, palette) {
            (&self.table, entries)
        } else {
            own_table = Table::of_pixels(pixels, palette);
            let entries = own_table.entries(pixels, palette);
            (&own_table, entries.map_err(FileError::OtherColor)?)
        };
        let now: Vec<_> = pixels.iter().map(|&entry| palette.rgb(entry)).collect();
        let is_first = self.before.is_empty();
        let patch = if is_first {
            Patch::whole(self.size)
        } else {
            Patch::of_change(&self.before, &now, self.size[0])
        };
        let as_before = table.has_as_before() && !is_first;
        if as_before {
            for ((entry, now), before) in entries.iter_mut().zip(&now).zip(&self.before) {
                if now == before {
                    *entry = Table::AS_BEFORE;
                }
            }
        }
        let is_own = !core::ptr::eq(table, &raw const self.table);
        let within: Vec<_> = patch.of(&entries, self.size[0]).copied().collect();
        let narrow = |pixels: usize| u16::try_from(pixels).unwrap_or(u16::MAX);
        self.encoder.write_frame(&gif::Frame {
            delay: self.clock.next(),
            dispose: gif::DisposalMethod::Keep,
            transparent: as_before.then_some(Table::AS_BEFORE),
            left: narrow(patch.left),
            top: narrow(patch.top),
            width: narrow(patch.width),
            height: narrow(patch.height),
            palette: is_own.then(|| table.bytes().to_vec()),
            buffer: within.into(),
            ..gif::Frame::default()
        })?;
        self.before = now;
        Ok(())
    }
}

/// The size, without pixels.
impl<W: Write> fmt::Debug for Gif<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Gif").field("size", &self.size).finish_non_exhaustive()
    }
}

fn entries_of(picture: Picture<'_>) -> Result<(&[u8], &Palette), FileError> {
    match picture.pixels {
        Pixels::Indexed(entries, palette) => Ok((entries, palette)),
        Pixels::Rgba(_) => Err(FileError::TrueColor),
    }
}
