//! Endless animations.

use crate::{Picture, Swatches};
use mech_runtime::files::{self, FileError, Gif};
use std::time::Duration;

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
