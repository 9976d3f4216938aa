//! Films that are hindered: by frames that do not fit, and by writers that write little at a time or fail once.

use super::animations::{apng, gif, whole};
use super::{films, palette};
use mech_runtime::Palette;
use mech_runtime::files::{Apng, FileError, Gif, Picture};
use proptest::prelude::*;
use std::io::{self, Write};
use std::time::Duration;

const DELAY: Duration = Duration::from_millis(33);

/// A writer that takes a few bytes at a time, is interrupted in between, and fails once when it has taken so many.
struct Unsteady {
    bytes: Vec<u8>,
    most: usize,
    fails_at: Option<usize>,
    is_interrupted: bool,
}

impl Unsteady {
    const fn new(most: usize, fails_at: Option<usize>) -> Self {
        Self {
            bytes: Vec::new(),
            most,
            fails_at,
            is_interrupted: false,
        }
    }

    fn fail_once(&mut self) -> io::Result<()> {
        if self.fails_at.is_some_and(|place| self.bytes.len() >= place) {
            self.fails_at = None;
            return Err(io::Error::other("the cable is loose"));
        }
        Ok(())
    }
}

impl Write for Unsteady {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.is_interrupted = !self.is_interrupted;
        if self.is_interrupted {
            return Err(io::ErrorKind::Interrupted.into());
        }
        self.fail_once()?;
        let taken = bytes.len().min(self.most);
        self.bytes.extend_from_slice(&bytes[..taken]);
        Ok(taken)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.fail_once()
    }
}

/// Writes everything, whatever fails. Returns whether nothing failed.
fn write_gif(writer: &mut Unsteady, pictures: &[Picture<'_>]) -> bool {
    let Ok(mut gif) = Gif::new(writer, pictures[0], DELAY) else {
        return false;
    };
    let added = pictures[1..].iter().map(|picture| gif.add(*picture));
    let failures = added.filter(Result::is_err).count();
    gif.finish().is_ok() && failures == 0
}

fn write_apng(writer: &mut Unsteady, pictures: &[Picture<'_>]) -> bool {
    let count = u32::try_from(pictures.len()).expect("a few");
    let Ok(mut apng) = Apng::new(writer, pictures[0], count, DELAY) else {
        return false;
    };
    let added = pictures[1..].iter().map(|picture| apng.add(*picture));
    let failures = added.filter(Result::is_err).count();
    apng.finish().is_ok() && failures == 0
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// Whoever hears of no failure has the whole file.
    #[test]
    fn by_a_writer(
        (size, pictures) in films(any::<u8>()),
        palette in palette(40),
        most in 1_usize..40,
        share in prop::option::of(0.0..1.001),
    ) {
        let pictures: Vec<_> = pictures.iter().map(|pixels| whole(size, pixels, &palette)).collect();
        let still = pictures[0].png().expect("a file");
        let gif = gif(pictures.iter().copied(), DELAY).expect("a file");
        let apng = apng(&pictures, DELAY).expect("a file");
        for (kind, wanted) in [still, gif, apng].iter().enumerate() {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "small")]
            let fails_at = share.map(|share| (share * wanted.len() as f64) as usize);
            let mut writer = Unsteady::new(most, fails_at);
            let is_written = match kind {
                0 => pictures[0].write_png(&mut writer).is_ok(),
                1 => write_gif(&mut writer, &pictures),
                _ => write_apng(&mut writer, &pictures),
            };
            // A failure that comes only after the last byte may come too late.
            prop_assert!(is_written || share.is_some());
            if is_written {
                prop_assert!(&writer.bytes == wanted, "kind {}, {:?}", kind, fails_at);
            }
        }
    }

    /// What is refused leaves no trace.
    #[test]
    fn by_frames(
        (size, pictures) in films(any::<u8>()),
        palette in palette(40),
        tries in prop::collection::vec(0_u8..5, 8),
    ) {
        let [width, height] = size;
        let pictures: Vec<_> = pictures.iter().map(|pixels| whole(size, pixels, &palette)).collect();
        let expected = [
            gif(pictures.iter().copied(), DELAY).expect("a file"),
            apng(&pictures, DELAY).expect("a file"),
        ];
        let larger = vec![0; (width + 1) * height];
        let larger = whole([width + 1, height], &larger, &palette);
        let clear = vec![[0; 4]; width * height];
        let clear = Picture::rgba(size, &clear).expect("whole");
        let used = palette.entries();
        let is_missing = |color: &[u8; 3]| !used.contains(color);
        let missing = (0..=u8::MAX).map(|red| [red, 77, 7]).find(is_missing).expect("a colour");
        let foreign = Palette::new([missing; 256]);
        let entries = vec![9; width * height];
        let foreign = whole(size, &entries, &foreign);

        let count = u32::try_from(pictures.len()).expect("a few");
        let mut files = [Vec::new(), Vec::new()];
        let [gif_file, apng_file] = &mut files;
        let mut gif = Gif::new(gif_file, pictures[0], DELAY).expect("a file");
        let mut apng = Apng::new(apng_file, pictures[0], count, DELAY).expect("a file");
        for (picture, tried) in pictures[1..].iter().zip(tries) {
            match tried {
                0 => {
                    let are_refused = matches!(gif.add(larger), Err(FileError::OtherSize { .. }))
                        && matches!(apng.add(larger), Err(FileError::OtherSize { .. }));
                    prop_assert!(are_refused);
                }
                1 => {
                    prop_assert!(matches!(gif.add(clear), Err(FileError::TrueColor)));
                    prop_assert!(matches!(apng.add(clear), Err(FileError::OtherKind)));
                }
                2 => prop_assert!(matches!(apng.add(foreign), Err(FileError::OtherColor(color)) if color == missing)),
                _ => {}
            }
            gif.add(*picture).expect("a frame");
            apng.add(*picture).expect("a frame");
        }
        for more in [pictures[0], larger, clear, foreign] {
            prop_assert!(apng.add(more).is_err());
        }
        gif.finish().expect("an end");
        apng.finish().expect("an end");
        prop_assert!(files == expected);
    }
}
