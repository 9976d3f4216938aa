//! What cannot be a file is an error that says why, and leaves what was there.

use super::seen;
use mech_runtime::files::{Apng, FileError, Gif, Picture};
use mech_runtime::{Frame, Palette};
use std::io::{self, Write};
use std::time::Duration;

const DELAY: Duration = Duration::from_millis(40);

/// A writer that has room for so many bytes.
struct Full(usize);

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = bytes.len().min(self.0);
        self.0 -= written;
        if written > 0 {
            Ok(written)
        } else {
            Err(io::Error::other("the disc is full"))
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.0 > 0 {
            Ok(())
        } else {
            Err(io::Error::other("the disc is full"))
        }
    }
}

#[test]
fn no_pixels() {
    let wide = Frame::<3, 0>::new();
    let high = Frame::<0, 3>::new();
    for picture in [Picture::from(&wide), Picture::from(&high)] {
        assert!(matches!(picture.png(), Err(FileError::Empty)));
        assert!(matches!(
            Gif::new(Vec::new(), picture, DELAY),
            Err(FileError::Empty)
        ));
        assert!(matches!(
            Apng::new(Vec::new(), picture, 1, DELAY),
            Err(FileError::Empty)
        ));
    }
    assert!(matches!(wide.png(), Err(FileError::Empty)));
}

#[test]
fn pixels_that_are_too_few_or_many() {
    for count in [0, 5, 7] {
        let pixels = vec![0; count];
        let error = Picture::indexed([3, 2], &pixels, &Palette::TEXTBOOK);
        let error = error.expect_err("six are needed");
        assert_eq!(
            error.to_string(),
            format!("there are {count} pixels, where its size takes 6")
        );
        assert!(Picture::rgba([3, 2], &vec![[0; 4]; count]).is_err());
    }
    assert!(Picture::rgba([usize::MAX, 3], &[[0; 4]; 3]).is_err());
}

#[test]
fn too_large() {
    let pixels = vec![0; 65_536];
    let wide = Picture::indexed([65_536, 1], &pixels, &Palette::TEXTBOOK).expect("whole");
    assert!(matches!(
        Gif::new(Vec::new(), wide, DELAY),
        Err(FileError::TooLarge { most: 65_535 })
    ));
    assert!(wide.png().is_ok());
}

#[test]
fn too_long() {
    let frame = Frame::<2, 2>::new();
    let [long, longer] = [65, 656].map(Duration::from_secs);
    assert!(Gif::new(Vec::new(), &frame, long).is_ok());
    assert!(Apng::new(Vec::new(), &frame, 1, long).is_ok());
    for delay in [longer, Duration::MAX] {
        assert!(matches!(
            Gif::new(Vec::new(), &frame, delay),
            Err(FileError::TooLong)
        ));
        assert!(matches!(
            Apng::new(Vec::new(), &frame, 1, delay),
            Err(FileError::TooLong)
        ));
    }
}

#[test]
fn frames_that_do_not_fit() {
    let frame = Frame::<2, 2>::new();
    let clear = [[1, 2, 3, 0]; 4];
    let clear = Picture::rgba([2, 2], &clear).expect("whole");
    let other = Frame::<2, 3>::new();
    let mut pink = Frame::<2, 2>::new();
    pink.set_palette(Palette::TEXTBOOK.with(Palette::PAPER, [255, 0, 255]));

    let mut bytes = Vec::new();
    let mut gif = Gif::new(&mut bytes, &frame, DELAY).expect("a file");
    assert!(matches!(gif.add(clear), Err(FileError::TrueColor)));
    let error = gif.add(&other).expect_err("of another size");
    assert_eq!(
        error.to_string(),
        "the frame is 2 × 3 pixels, where the first one is 2 × 2"
    );
    gif.add(&frame).expect("one that fits");
    gif.finish().expect("an end");
    assert_eq!(seen::gif(&bytes).len(), 2);
    assert!(matches!(
        Gif::new(Vec::new(), clear, DELAY),
        Err(FileError::TrueColor)
    ));

    let mut bytes = Vec::new();
    let mut apng = Apng::new(&mut bytes, &frame, 2, DELAY).expect("a file");
    assert!(matches!(apng.add(clear), Err(FileError::OtherKind)));
    assert!(matches!(apng.add(&other), Err(FileError::OtherSize { .. })));
    let error = apng.add(&pink).expect_err("of another colour");
    assert_eq!(
        error.to_string(),
        "the palette of the first frame lacks the colour #ff00ff"
    );
    apng.add(&frame).expect("one that fits");
    let error = apng.add(&frame).expect_err("one too many");
    assert_eq!(error.to_string(), "2 frames were announced, not 3");
    apng.finish().expect("an end");
    assert_eq!(seen::apng(&bytes).len(), 2);

    let mut apng = Apng::new(Vec::new(), clear, 2, DELAY).expect("a file");
    assert!(matches!(apng.add(&frame), Err(FileError::OtherKind)));
    let error = apng.finish().expect_err("one too few");
    assert!(matches!(
        error,
        FileError::OtherCount {
            announced: 2,
            found: 1
        }
    ));
    assert!(matches!(
        Apng::new(Vec::new(), clear, 0, DELAY),
        Err(FileError::OtherCount { .. })
    ));
}

/// Wherever the room ends, somebody says so.
#[test]
fn a_writer_that_fails() {
    let frame = Frame::<5, 4>::new();
    let write = |room: usize| -> [Result<(), FileError>; 3] {
        let gif = || {
            let mut gif = Gif::new(Full(room), &frame, DELAY)?;
            gif.add(&frame)?;
            gif.finish()
        };
        let apng = || {
            let mut apng = Apng::new(Full(room), &frame, 2, DELAY)?;
            apng.add(&frame)?;
            apng.finish()
        };
        [Picture::from(&frame).write_png(Full(room)), gif(), apng()]
    };
    let fit = |room| write(room).map(|result| result.is_ok());
    assert_eq!(fit(1 << 20), [true; 3]);
    let mut before = [false; 3];
    for room in 0..2000 {
        for result in write(room) {
            if let Err(error) = result {
                assert!(matches!(&error, FileError::Write(_)), "{error:?}");
                assert!(error.to_string().contains("the disc is full"), "{error}");
            }
        }
        let now = fit(room);
        for (before, now) in before.into_iter().zip(now) {
            assert!(now || !before, "more room, and it does not fit any more");
        }
        before = now;
    }
    assert_eq!(before, [true; 3]);
}
