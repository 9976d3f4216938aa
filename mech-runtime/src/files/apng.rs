//! Animated PNG.

use super::Clock;
use super::FileError;
use super::patch::Patch;
use super::picture::{Picture, Pixels};
use super::still::{MOST, compress};
use super::table::Table;
use core::fmt;
use std::io::Write;
use std::time::Duration;
use std::{vec, vec::Vec};

/// An endless animated PNG, written frame by frame. Only the last frame stays in memory. The number of frames must be known first,
/// because the format has it before the frames.
///
/// All frames have the colours of the first one's palette, or all are in true colour. Each frame holds the rectangle that has changed,
/// and of it, where the format allows, only the changed pixels.
///
/// ```
/// use mech_runtime::files::Apng;
/// use mech_runtime::{Canvas, Frame, Outline, Palette, Pose};
/// use std::time::Duration;
///
/// let mut file = Vec::new(); // or a `BufWriter` of a `File`
/// let mut frame = Frame::<64, 48>::new();
/// let mut apng = Apng::new(&mut file, &frame, 11, Duration::from_millis(40))?;
/// for x in 0..10 {
///     frame.clear();
///     let circle = Outline::Circle { center: [f64::from(x), 0.0], radius: 8.0 };
///     frame.fill(circle, Pose::identity(), Palette::BLUE);
///     apng.add(&frame)?;
/// }
/// apng.finish()?;
/// # Ok::<(), mech_runtime::files::FileError>(())
/// ```
pub struct Apng<W: Write> {
    writer: png::Writer<W>,
    size: [usize; 2],
    announced: u32,
    written: u32,
    clock: Clock,
    last: Last,
}

/// The last frame, with which the next is compared.
enum Last {
    /// Entries of the table.
    Indexed(Table, Vec<u8>),
    Rgba(Vec<[u8; 4]>),
}

impl<W: Write> Apng<W> {
    /// Writes the first of `frames` frames. Each is shown for `delay`, in thousandths of a second. Other delays are right on average.
    ///
    /// # Errors
    /// [`FileError`] if the frame is empty, `frames` is zero, `delay` exceeds 65 seconds, or the writer fails.
    pub fn new<'a>(
        writer: W,
        first: impl Into<Picture<'a>>,
        frames: u32,
        delay: Duration,
    ) -> Result<Self, FileError> {
        let first = first.into();
        let [width, height] = first.size_within(MOST)?;
        let mut clock = Clock::new(delay, Duration::from_millis(1))?;
        if frames == 0 {
            return Err(FileError::OtherCount { announced: frames, found: 1 });
        }
        let mut encoder = png::Encoder::new(writer, width, height);
        compress(&mut encoder, first.pixels);
        encoder.set_animated(frames, 0)?;
        encoder.set_dispose_op(png::DisposeOp::None)?;
        encoder.set_frame_delay(clock.next(), MILLISECONDS)?;
        let last = match first.pixels {
            Pixels::Indexed(pixels, palette) => {
                let table = Table::of(palette);
                let entries = table.entries(pixels, palette);
                encoder.set_palette(table.bytes().to_vec());
                if table.has_as_before() {
                    encoder.set_trns(vec![0]); // of entry `Table::AS_BEFORE`
                }
                Last::Indexed(table, entries.map_err(FileError::OtherColor)?)
            }
            Pixels::Rgba(pixels) => Last::Rgba(pixels.to_vec()),
        };
        let mut writer = encoder.write_header()?;
        match &last {
            Last::Indexed(_, entries) => writer.write_image_data(entries)?,
            Last::Rgba(pixels) => writer.write_image_data(pixels.as_flattened())?,
        }
        Ok(Self { writer, size: first.size(), announced: frames, written: 1, clock, last })
    }

    /// Adds a frame.
    ///
    /// # Errors
    /// [`FileError`] if the frame is one too many, has another size or kind, or a colour that the first palette lacks. These errors change
    /// nothing. If the writer fails, the file is incomplete.
    pub fn add<'a>(&mut self, frame: impl Into<Picture<'a>>) -> Result<(), FileError> {
        let frame = frame.into().of_size(self.size)?;
        if self.written == self.announced {
            return Err(FileError::OtherCount {
                announced: self.announced,
                found: self.announced.saturating_add(1),
            });
        }
        let width = self.size[0];
        let (patch, blend, bytes) = match (&mut self.last, frame.pixels) {
            (Last::Indexed(table, before), Pixels::Indexed(pixels, palette)) => {
                let now = table.entries(pixels, palette);
                let now = now.map_err(FileError::OtherColor)?;
                let patch = Patch::of_change(before, &now, width);
                let has_as_before = table.has_as_before();
                let pairs = patch.of(before, width).zip(patch.of(&now, width));
                let entry = |(before, now): (&u8, &u8)| {
                    let is_as_before = has_as_before && before == now;
                    if is_as_before { Table::AS_BEFORE } else { *now }
                };
                let bytes: Vec<u8> = pairs.map(entry).collect();
                *before = now;
                (patch, has_as_before, bytes)
            }
            (Last::Rgba(before), Pixels::Rgba(now)) => {
                let patch = Patch::of_change(before, now, width);
                let pairs = || patch.of(before, width).zip(patch.of(now, width));
                // A clear pixel would let the last frame shine through.
                let is_in_frame =
                    |(before, now): (&[u8; 4], &[u8; 4])| before == now || now[3] == 255;
                let tells_changes = pairs().all(is_in_frame);
                let pixel = |(before, now): (&[u8; 4], &[u8; 4])| {
                    let is_as_before = tells_changes && before == now;
                    if is_as_before { [0; 4] } else { *now }
                };
                let bytes: Vec<u8> = pairs().flat_map(pixel).collect();
                before.copy_from_slice(now);
                (patch, tells_changes, bytes)
            }
            _ => return Err(FileError::OtherKind),
        };
        self.write(patch, blend, &bytes)
    }

    /// Ends the file.
    ///
    /// # Errors
    /// [`FileError::OtherCount`] if there are fewer frames than announced, [`FileError::Write`] if the writer fails.
    pub fn finish(self) -> Result<(), FileError> {
        if self.written != self.announced {
            return Err(FileError::OtherCount { announced: self.announced, found: self.written });
        }
        Ok(self.writer.finish()?)
    }

    fn write(&mut self, patch: Patch, blend: bool, bytes: &[u8]) -> Result<(), FileError> {
        let narrow = |pixels: usize| u32::try_from(pixels).unwrap_or(u32::MAX);
        let writer = &mut self.writer;
        writer.reset_frame_position()?;
        writer.set_frame_dimension(narrow(patch.width), narrow(patch.height))?;
        writer.set_frame_position(narrow(patch.left), narrow(patch.top))?;
        writer.set_blend_op(if blend { png::BlendOp::Over } else { png::BlendOp::Source })?;
        writer.set_frame_delay(self.clock.next(), MILLISECONDS)?;
        writer.write_image_data(bytes)?;
        self.written += 1;
        Ok(())
    }
}

/// The parts of a second in which delays are counted.
const MILLISECONDS: u16 = 1000;

/// The size and the number of frames, without pixels.
impl<W: Write> fmt::Debug for Apng<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Apng")
            .field("size", &self.size)
            .field("announced", &self.announced)
            .field("written", &self.written)
            .finish_non_exhaustive()
    }
}
