//! Endless animations, with a few colours in place of many.

use crate::Picture;
use mech_runtime::Palette;
use mech_runtime::files::{self, FileError, Gif};
use std::time::Duration;
use std::{array, collections::HashMap, iter};

/// The duration of a frame.
pub(crate) const DELAY: Duration = Duration::from_millis(30);

/// The bytes of a GIF file that repeats the pictures, with one table of colours.
///
/// # Errors
/// [`FileError`] if there is no picture, or if one has another size than the first or fewer pixels than its size says.
pub fn animation(pictures: &[Picture]) -> Result<Vec<u8>, FileError> {
    let swatches = Swatches::for_pictures(pictures);
    let palette = swatches.palette();
    let (first, others) = pictures.split_first().ok_or(FileError::Empty)?;
    let mut bytes = Vec::new();
    let entries = swatches.entries(first);
    let first = files::Picture::indexed(first.size(), &entries, &palette)?;
    let mut gif = Gif::new(&mut bytes, first, DELAY)?;
    for picture in others {
        let entries = swatches.entries(picture);
        gif.add(files::Picture::indexed(picture.size(), &entries, &palette)?)?;
    }
    gif.finish()?;
    Ok(bytes)
}

/// The most colours of an animation. One entry of its table means "as before".
const MOST: usize = 255;

/// At most 255 colours that replace all those of some pictures.
#[derive(Clone, Debug)]
pub struct Swatches {
    colors: Vec<[u8; 3]>,
    entries: HashMap<[u8; 3], u8>,
}

impl Swatches {
    /// Chooses the most frequent colours first, then those that are not near a chosen one. "Near" is the smallest distance that 255 colours
    /// allow. No pixel of any picture is farther from its true colour.
    #[must_use]
    pub fn for_pictures(pictures: &[Picture]) -> Self {
        let mut counts = HashMap::<[u8; 3], usize>::new();
        for picture in pictures {
            for run in picture.pixels.chunk_by(|one, next| one == next) {
                if let Some(&[red, green, blue, _]) = run.first() {
                    let color = [red, green, blue];
                    *counts.entry(color).or_default() += run.len();
                }
            }
        }
        let mut by_count: Vec<_> = counts.into_iter().collect();
        by_count.sort_unstable_by_key(|&(color, count)| (usize::MAX - count, color));
        let seen = by_count.into_iter().map(|(color, _)| color);
        let seen: Vec<_> = seen.collect();

        let colors = (0..).find_map(|radius| choose(&seen, radius * radius)).unwrap_or_default();
        let entries = seen.into_iter().filter_map(|color| {
            let nearest = (0..).zip(&colors).min_by_key(|&(_, &swatch)| distance(color, swatch));
            nearest.map(|(entry, _)| (color, entry))
        });
        let entries = entries.collect();
        Self { colors, entries }
    }

    /// The colours, most frequent ones first.
    #[must_use]
    pub fn colors(&self) -> &[[u8; 3]] {
        &self.colors
    }

    /// A palette of the colours. Unused entries are the first colour.
    #[must_use]
    pub fn palette(&self) -> Palette {
        let color = |entry| self.colors.get(entry).or(self.colors.first());
        Palette::new(array::from_fn(|entry| color(entry).copied().unwrap_or_default()))
    }

    /// The entry that replaces a colour: 0 if no picture has it.
    #[must_use]
    pub fn entry(&self, color: [u8; 3]) -> u8 {
        self.entries.get(&color).copied().unwrap_or_default()
    }

    /// The entries of all pixels of a picture.
    #[must_use]
    pub fn entries(&self, picture: &Picture) -> Vec<u8> {
        let runs = picture.pixels.chunk_by(|one, next| one == next);
        runs.flat_map(|run| {
            let [red, green, blue, _] = run.first().copied().unwrap_or_default();
            iter::repeat_n(self.entry([red, green, blue]), run.len())
        })
        .collect()
    }
}

/// Colours so that each seen colour is within this distance of one. `None` if that takes too many.
fn choose(seen: &[[u8; 3]], square: u32) -> Option<Vec<[u8; 3]>> {
    let mut colors = Vec::with_capacity(MOST);
    for &color in seen {
        if colors.iter().all(|&near| distance(color, near) > square) {
            if colors.len() == MOST {
                return None;
            }
            colors.push(color);
        }
    }
    Some(colors)
}

/// The square of the distance between two colours.
fn distance(one: [u8; 3], other: [u8; 3]) -> u32 {
    iter::zip(one, other).map(|(one, other)| u32::from(one.abs_diff(other)).pow(2)).sum()
}
