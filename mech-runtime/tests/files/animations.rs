//! Animations show the very pictures, one after the other.

use super::{films, palette, seen, true_colour};
use mech_runtime::files::{Apng, FileError, Gif, Picture};
use mech_runtime::{Canvas, Frame, Outline, Palette, Pose};
use proptest::prelude::*;
use std::time::Duration;

pub(crate) fn colors(pixels: &[u8], palette: &Palette) -> Vec<[u8; 4]> {
    let opaque = |&entry| {
        let [red, green, blue] = palette.rgb(entry);
        [red, green, blue, 255]
    };
    pixels.iter().map(opaque).collect()
}

pub(crate) fn whole<'a>(size: [usize; 2], pixels: &'a [u8], palette: &'a Palette) -> Picture<'a> {
    Picture::indexed(size, pixels, palette).expect("whole")
}

pub(crate) fn gif<'a>(
    pictures: impl IntoIterator<Item = Picture<'a>>,
    delay: Duration,
) -> Result<Vec<u8>, FileError> {
    let mut pictures = pictures.into_iter();
    let mut bytes = Vec::new();
    let mut gif = Gif::new(&mut bytes, pictures.next().expect("a first one"), delay)?;
    for picture in pictures {
        gif.add(picture)?;
    }
    gif.finish()?;
    Ok(bytes)
}

pub(crate) fn apng(pictures: &[Picture<'_>], delay: Duration) -> Result<Vec<u8>, FileError> {
    let (first, others) = pictures.split_first().expect("a first one");
    let count = u32::try_from(pictures.len()).expect("a few");
    let mut bytes = Vec::new();
    let mut apng = Apng::new(&mut bytes, *first, count, delay)?;
    for picture in others {
        apng.add(*picture)?;
    }
    apng.finish()?;
    Ok(bytes)
}

/// That the frames are seen in order, and that each begins at its moment to half a unit.
pub(crate) fn check(film: &seen::Film, expected: &[Vec<[u8; 4]>], delay_in_units: f64) {
    assert_eq!(film.len(), expected.len());
    let mut begin = 0;
    for (index, ((seen, delay), expected)) in film.iter().zip(expected).enumerate() {
        assert_eq!(seen, expected, "frame {index}");
        #[expect(clippy::cast_precision_loss, reason = "a few")]
        let exact = index as f64 * delay_in_units;
        assert!((f64::from(begin) - exact).abs() <= 0.5 + 1e-6, "{begin}, not {exact}");
        begin += delay;
    }
}

/// A palette most of whose entries are one colour.
fn nearly_black() -> impl Strategy<Value = Palette> {
    let entries = prop::collection::vec((any::<u8>(), prop::array::uniform3(0_u8..2)), 0..6);
    entries.prop_map(|entries| {
        let black = Palette::new([[0; 3]; 256]);
        let with = |palette: Palette, (entry, color)| palette.with(entry, color);
        entries.into_iter().fold(black, with)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn with_a_palette(
        (size, pictures) in films(any::<u8>()),
        palette in prop_oneof![palette(2), palette(40), palette(128), palette(255), palette(256)],
        micros in 0_u32..200_000,
    ) {
        let delay = Duration::from_micros(micros.into());
        let expected: Vec<_> = pictures.iter().map(|pixels| colors(pixels, &palette)).collect();
        let pictures: Vec<_> = pictures
            .iter()
            .map(|pixels| whole(size, pixels, &palette))
            .collect();
        let bytes = gif(pictures.iter().copied(), delay).expect("a file");
        check(&seen::gif(&bytes), &expected, f64::from(micros) / 1e4);
        let bytes = apng(&pictures, delay).expect("a file");
        check(&seen::apng(&bytes), &expected, f64::from(micros) / 1e3);
    }

    #[test]
    fn in_true_colour((size, pictures) in true_colour()) {
        let borrowed: Vec<_> = pictures
            .iter()
            .map(|pixels| Picture::rgba(size, pixels).expect("whole"))
            .collect();
        let bytes = apng(&borrowed, Duration::from_millis(33)).expect("a file");
        check(&seen::apng(&bytes), &pictures, 33.0);
    }

    #[test]
    fn with_another_palette_for_each_frame(
        (size, pictures) in films(any::<u8>()),
        palettes in prop_oneof![
            prop::collection::vec(prop_oneof![palette(3), palette(256)], 7),
            prop::collection::vec(nearly_black(), 7),
        ],
    ) {
        let pairs = || pictures.iter().zip(&palettes);
        let expected: Vec<_> = pairs().map(|(pixels, palette)| colors(pixels, palette)).collect();
        let whole = pairs().map(|(pixels, palette)| whole(size, pixels, palette));
        let bytes = gif(whole, Duration::from_millis(20)).expect("a file");
        check(&seen::gif(&bytes), &expected, 2.0);
    }
}

#[test]
fn only_what_changes_is_written() {
    let film = |count: usize| {
        let mut frame = Frame::<200, 150>::new();
        let mut gif_bytes = Vec::new();
        let mut apng_bytes = Vec::new();
        let delay = Duration::from_millis(40);
        let mut gif = Gif::new(&mut gif_bytes, &frame, delay).expect("a file");
        let announced = u32::try_from(count + 1).expect("a few");
        let mut apng = Apng::new(&mut apng_bytes, &frame, announced, delay).expect("a file");
        for index in 0..count {
            frame.clear();
            let center = [f64::from(u32::try_from(index % 2).expect("a bit")), 0.0];
            let radius = 3.0;
            frame.fill(Outline::Circle { center, radius }, Pose::identity(), Palette::RED);
            gif.add(&frame).expect("a frame");
            apng.add(&frame).expect("a frame");
        }
        gif.finish().expect("an end");
        apng.finish().expect("an end");
        [gif_bytes.len(), apng_bytes.len()]
    };
    let [few, many] = [film(10), film(110)];
    for (few, many) in few.into_iter().zip(many) {
        assert!((many - few) / 100 < 150, "{few} and {many} bytes");
    }
}
