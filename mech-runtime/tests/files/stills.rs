//! Stills: decoded, they are the very pixels.

use super::{films, palette, true_colour};
use mech_runtime::files::{FileError, Picture};
use mech_runtime::{Canvas, Frame, HeapSmooth, Outline, Palette, Pose, Smooth};
use proptest::prelude::*;
use std::io::Cursor;

fn decode(bytes: &[u8]) -> (png::OutputInfo, Option<Vec<u8>>, Vec<u8>) {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::IDENTITY);
    let mut reader = decoder.read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut pixels).expect("its pixels");
    let palette = reader.info().palette.as_deref().map(<[u8]>::to_vec);
    (info, palette, pixels)
}

#[test]
fn a_frame() {
    let mut frame = Frame::<33, 21>::new();
    frame.set_palette(Palette::NIGHT);
    let circle = Outline::Circle { center: [0.0, 1.0], radius: 8.5 };
    frame.fill(circle, Pose::identity(), Palette::TEAL);
    let (info, palette, pixels) = decode(&frame.png().expect("a file"));
    assert_eq!((info.width, info.height), (33, 21));
    assert_eq!(info.color_type, png::ColorType::Indexed);
    assert_eq!(pixels, frame.pixels().as_flattened());
    let used = usize::from(Palette::TEAL) + 1;
    assert_eq!(palette.expect("a palette"), Palette::NIGHT.entries()[..used].as_flattened());
}

#[test]
fn a_smooth_picture() {
    let mut picture = Smooth::<33, 21>::new();
    let circle = Outline::Circle { center: [0.0, 1.0], radius: 8.4 };
    picture.fill(circle, Pose::identity(), Palette::TEAL);
    let (info, _, pixels) = decode(&picture.png().expect("a file"));
    assert_eq!((info.width, info.height), (33, 21));
    assert_eq!(info.color_type, png::ColorType::Rgb);
    let opaque = pixels.chunks(3).map(|pixel| [pixel[0], pixel[1], pixel[2], 255]);
    assert!(opaque.eq(picture.pixels().as_flattened().iter().copied()));
}

#[test]
fn a_large_picture_on_the_heap_is_saved() {
    let mut picture = HeapSmooth::new(1920, 1080).expect("there is memory");
    let circle = Outline::Circle { center: [960.0, 540.0], radius: 400.3 };
    picture.fill(circle, Pose::identity(), Palette::TEAL);
    let path = std::env::temp_dir().join(format!("mech-stills-{}.png", std::process::id()));
    picture.save(&path).expect("a file");
    let bytes = std::fs::read(&path).expect("the file");
    std::fs::remove_file(&path).expect("the file");
    let (info, _, pixels) = decode(&bytes);
    assert_eq!((info.width, info.height), (1920, 1080));
    let opaque = pixels.chunks(3).map(|pixel| [pixel[0], pixel[1], pixel[2], 255]);
    assert!(opaque.eq(picture.pixels().iter().copied()));
}

#[test]
fn a_picture_that_cannot_be_saved_is_an_error() {
    let nowhere = std::env::temp_dir().join("mech-no-such-folder/picture.png");
    let saved = Frame::<3, 2>::new().save(&nowhere);
    assert!(matches!(saved, Err(FileError::Write(_))), "{saved:?}");
    // Of what has no pixels no file is made.
    let empty = std::env::temp_dir().join(format!("mech-empty-{}.png", std::process::id()));
    let saved = Frame::<0, 2>::new().save(&empty);
    assert!(matches!(saved, Err(FileError::Empty)), "{saved:?}");
    assert!(!empty.exists());
}

proptest! {
    #[test]
    fn with_a_palette((size, pictures) in films(any::<u8>()), palette in palette(256)) {
        let picture = Picture::indexed(size, &pictures[0], &palette).expect("whole");
        let (info, table, pixels) = decode(&picture.png().expect("a file"));
        prop_assert_eq!([info.width as usize, info.height as usize], size);
        prop_assert_eq!(&pixels, &pictures[0]);
        let last = usize::from(*pixels.iter().max().expect("a pixel"));
        prop_assert_eq!(table.expect("a palette"), palette.entries()[..=last].as_flattened());
    }

    #[test]
    fn in_true_colour((size, pictures) in true_colour()) {
        let picture = Picture::rgba(size, &pictures[0]).expect("whole");
        let (info, _, pixels) = decode(&picture.png().expect("a file"));
        let has_opacity = pictures[0].iter().any(|pixel| pixel[3] < 255);
        prop_assert_eq!(info.color_type == png::ColorType::Rgba, has_opacity);
        let samples = if has_opacity { 4 } else { 3 };
        let expected: Vec<u8> = pictures[0].iter().flat_map(|pixel| &pixel[..samples]).copied().collect();
        prop_assert_eq!(pixels, expected);
    }
}
