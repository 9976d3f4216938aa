//! An endless animation.

use crate::{Error, Picture, Swatches};
use gif::{DisposalMethod, Encoder, Frame, Repeat};

/// How long a frame is seen, in hundredths of a second.
const DELAY: u16 = 3;

/// The bytes of a GIF file that shows the pictures again and again; any of another size than the first are left out.
///
/// All frames share one table of colours, and each holds only what has changed.
///
/// # Errors
/// [`Error::Gif`] if a picture has fewer pixels than its size says.
pub fn animation(pictures: &[Picture]) -> Result<Vec<u8>, Error> {
    let swatches = Swatches::for_pictures(pictures);
    let colors = swatches.colors();
    let as_before = u8::try_from(colors.len()).unwrap_or(u8::MAX);
    let [width, height] = pictures.first().map_or([0, 0], |p| [p.width, p.height]);

    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height, colors.as_flattened())?;
    encoder.set_repeat(Repeat::Infinite)?;
    let mut before: Option<Vec<u8>> = None;
    let fitting = |picture: &&Picture| [picture.width, picture.height] == [width, height];
    for picture in pictures.iter().filter(fitting) {
        let now = swatches.entries(picture);
        let patch = match &before {
            None => Patch {
                left: 0,
                top: 0,
                width,
                height,
                entries: now.clone(),
            },
            Some(before) => Patch::between(before, &now, width, as_before),
        };
        encoder.write_frame(&Frame {
            delay: DELAY,
            dispose: DisposalMethod::Keep,
            transparent: before.is_some().then_some(as_before),
            left: patch.left,
            top: patch.top,
            width: patch.width,
            height: patch.height,
            buffer: patch.entries.into(),
            ..Frame::default()
        })?;
        before = Some(now);
    }
    drop(encoder);
    Ok(bytes)
}

/// A part of a picture.
struct Patch {
    left: u16,
    top: u16,
    width: u16,
    height: u16,
    entries: Vec<u8>,
}

impl Patch {
    /// The smallest patch with all that differs between two pictures; what does not differ in it is `as_before`.
    fn between(before: &[u8], now: &[u8], width: u16, as_before: u8) -> Self {
        let row = usize::from(width).max(1);
        let rows = before.chunks_exact(row).zip(now.chunks_exact(row));
        let changed = |before: &[u8], now: &[u8]| {
            let mut pixels = before.iter().zip(now);
            let first = pixels.position(|(before, now)| before != now)?;
            let last = before
                .iter()
                .zip(now)
                .rposition(|(before, now)| before != now)?;
            Some((first, last))
        };
        let extents = (0_u16..)
            .zip(rows.clone())
            .filter_map(|(y, (before, now))| {
                changed(before, now).map(|(first, last)| (y, y, first, last))
            });
        let (top, bottom, left, right) = extents
            .reduce(|(top, _, left, right), (_, bottom, first, last)| {
                (top, bottom, left.min(first), right.max(last))
            })
            .unwrap_or_default(); // one pixel, so that the frame takes its time
        let mut entries = Vec::new();
        for (before, now) in rows.take(usize::from(bottom) + 1).skip(top.into()) {
            let pixels = before.iter().zip(now).take(right + 1).skip(left);
            entries
                .extend(pixels.map(|(before, now)| if before == now { as_before } else { *now }));
        }
        let narrow = |pixels: usize| u16::try_from(pixels).unwrap_or(u16::MAX);
        Self {
            left: narrow(left),
            top,
            width: narrow(right - left + 1),
            height: bottom - top + 1,
            entries,
        }
    }
}
