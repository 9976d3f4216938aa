//! Films that are hindered: by frames that do not fit, and by writers that write little at a time or fail once.

use super::animations::{apng, gif, whole};
use super::{films, palette};
use mech_runtime::files::{Apng, FileError, Gif, Picture};
use mech_runtime::{Frame, Palette};
use proptest::prelude::*;
use std::io::{self, Write};
use std::time::Duration;

const DELAY: Duration = Duration::from_millis(33);

/// A writer that takes a few bytes at a time, is interrupted in between, and fails when it has taken so many: once, or for ever.
struct Unsteady {
    bytes: Vec<u8>,
    most: usize,
    fails_at: Option<usize>,
    stays_broken: bool,
    is_interrupted: bool,
}

impl Unsteady {
    const fn new(most: usize, fails_at: Option<usize>, stays_broken: bool) -> Self {
        Self { bytes: Vec::new(), most, fails_at, stays_broken, is_interrupted: false }
    }

    fn fail_there(&mut self) -> io::Result<()> {
        if self.fails_at.is_some_and(|place| self.bytes.len() >= place) {
            self.fails_at = self.fails_at.filter(|_| self.stays_broken);
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
        self.fail_there()?;
        let taken = bytes.len().min(self.most);
        self.bytes.extend_from_slice(&bytes[..taken]);
        Ok(taken)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.fail_there()
    }
}

/// Writes everything, whatever fails. Returns the first failure.
fn write_gif(writer: &mut Unsteady, pictures: &[Picture<'_>]) -> Result<(), FileError> {
    let mut gif = Gif::new(writer, pictures[0], DELAY)?;
    let added = pictures[1..].iter().map(|picture| gif.add(*picture));
    let added: Vec<_> = added.collect();
    added.into_iter().chain([gif.finish()]).collect()
}

fn write_apng(writer: &mut Unsteady, pictures: &[Picture<'_>]) -> Result<(), FileError> {
    let count = u32::try_from(pictures.len()).expect("a few");
    let mut apng = Apng::new(writer, pictures[0], count, DELAY)?;
    let added = pictures[1..].iter().map(|picture| apng.add(*picture));
    let added: Vec<_> = added.collect();
    added.into_iter().chain([apng.finish()]).collect()
}

/// A still, a GIF and an animated PNG.
fn whole_files(pictures: &[Picture<'_>]) -> [Vec<u8>; 3] {
    [
        pictures[0].png().expect("a file"),
        gif(pictures.iter().copied(), DELAY).expect("a file"),
        apng(pictures, DELAY).expect("a file"),
    ]
}

/// Whoever hears of no failure has the whole file of this kind. Whoever hears of one hears why.
fn check(kind: usize, wanted: &[u8], pictures: &[Picture<'_>], mut writer: Unsteady) {
    let written = match kind {
        0 => pictures[0].write_png(&mut writer),
        1 => write_gif(&mut writer, pictures),
        _ => write_apng(&mut writer, pictures),
    };
    if let Err(error) = written {
        assert!(matches!(&error, FileError::Write(_)), "{error:?}");
        assert!(error.to_string().contains("the cable is loose"), "{error}");
    } else {
        assert!(writer.bytes == wanted, "kind {kind}, {:?}", writer.fails_at);
    }
}

#[test]
fn by_a_writer_that_fails_anywhere() {
    let frame = Frame::<5, 4>::new();
    let pictures = [Picture::from(&frame); 2];
    for (kind, wanted) in whole_files(&pictures).iter().enumerate() {
        for place in 0..=wanted.len() {
            for stays_broken in [false, true] {
                let writer = Unsteady::new(1, Some(place), stays_broken);
                check(kind, wanted, &pictures, writer);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn by_a_writer(
        (size, pictures) in films(any::<u8>()),
        palette in palette(40),
        most in 1_usize..40,
        share in prop::option::of(0.0..1.001),
        stays_broken in any::<bool>(),
    ) {
        let pictures: Vec<_> = pictures.iter().map(|pixels| whole(size, pixels, &palette)).collect();
        for (kind, wanted) in whole_files(&pictures).iter().enumerate() {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "small")]
            let fails_at = share.map(|share| (share * wanted.len() as f64) as usize);
            check(kind, wanted, &pictures, Unsteady::new(most, fails_at, stays_broken));
        }
    }

    /// A picture that is refused leaves no trace.
    #[test]
    fn by_frames(
        (size, pictures) in films(any::<u8>()),
        palette in palette(40),
        tries in prop::collection::vec(0_u8..5, 8),
    ) {
        let [width, height] = size;
        let pictures: Vec<_> = pictures.iter().map(|pixels| whole(size, pixels, &palette)).collect();
        let [_, gif_expected, apng_expected] = whole_files(&pictures);
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
        prop_assert!(files == [gif_expected, apng_expected]);
    }
}
