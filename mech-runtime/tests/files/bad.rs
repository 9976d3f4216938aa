//! A picture that cannot be a file is an error that says why, and leaves the file as it was.

use mech_runtime::files::{Apng, FileError, Gif, Picture};
use mech_runtime::{Frame, Palette};
use std::time::Duration;

const DELAY: Duration = Duration::from_millis(40);

#[test]
fn no_pixels() {
    let wide = Frame::<3, 0>::new();
    let high = Frame::<0, 3>::new();
    for picture in [Picture::from(&wide), Picture::from(&high)] {
        assert!(matches!(picture.png(), Err(FileError::Empty)));
        assert!(matches!(Gif::new(Vec::new(), picture, DELAY), Err(FileError::Empty)));
        assert!(matches!(Apng::new(Vec::new(), picture, 1, DELAY), Err(FileError::Empty)));
    }
    assert!(matches!(wide.png(), Err(FileError::Empty)));
}

#[test]
fn pixels_that_are_too_few_or_many() {
    for count in [0, 5, 7] {
        let pixels = vec![0; count];
        let error = Picture::indexed([3, 2], &pixels, &Palette::TEXTBOOK);
        let error = error.expect_err("six are needed");
        assert_eq!(error.to_string(), format!("there are {count} pixels, where its size takes 6"));
        assert!(Picture::rgba([3, 2], &vec![[0; 4]; count]).is_err());
    }
    assert!(Picture::rgba([usize::MAX, 3], &[[0; 4]; 3]).is_err());
}

#[test]
fn too_large() {
    let pixels = vec![0; 65_536];
    let wide = Picture::indexed([65_536, 1], &pixels, &Palette::TEXTBOOK).expect("whole");
    assert!(matches!(Gif::new(Vec::new(), wide, DELAY), Err(FileError::TooLarge { most: 65_535 })));
    assert!(wide.png().is_ok());
}

#[test]
fn too_long() {
    let frame = Frame::<2, 2>::new();
    let [long, longer] = [65, 656].map(Duration::from_secs);
    assert!(Gif::new(Vec::new(), &frame, long).is_ok());
    assert!(Apng::new(Vec::new(), &frame, 1, long).is_ok());
    for delay in [longer, Duration::MAX] {
        assert!(matches!(Gif::new(Vec::new(), &frame, delay), Err(FileError::TooLong)));
        assert!(matches!(Apng::new(Vec::new(), &frame, 1, delay), Err(FileError::TooLong)));
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

    let mut gif = Gif::new(Vec::new(), &frame, DELAY).expect("a file");
    let error = gif.add(&other).expect_err("of another size");
    assert_eq!(error.to_string(), "the frame is 2 × 3 pixels, where the first one is 2 × 2");
    assert!(matches!(Gif::new(Vec::new(), clear, DELAY), Err(FileError::TrueColor)));

    let mut apng = Apng::new(Vec::new(), &frame, 2, DELAY).expect("a file");
    let error = apng.add(&pink).expect_err("of another colour");
    assert_eq!(error.to_string(), "the palette of the first frame lacks the colour #ff00ff");
    apng.add(&frame).expect("one that fits");
    let error = apng.add(&frame).expect_err("one too many");
    assert_eq!(error.to_string(), "2 frames were announced, not 3");

    let mut apng = Apng::new(Vec::new(), clear, 2, DELAY).expect("a file");
    assert!(matches!(apng.add(&frame), Err(FileError::OtherKind)));
    let error = apng.finish().expect_err("one too few");
    assert!(matches!(error, FileError::OtherCount { announced: 2, found: 1 }));
    assert!(matches!(Apng::new(Vec::new(), clear, 0, DELAY), Err(FileError::OtherCount { .. })));
}
