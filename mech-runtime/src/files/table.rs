//! The table of colours of an animation.

use crate::Palette;
use std::vec::Vec;

/// Different colours, and entry 0 that means "as before", if a byte has room for it.
#[derive(Debug)]
pub(super) struct Table {
    colors: Vec<[u8; 3]>,
    has_as_before: bool,
}

impl Table {
    /// The entry that means "as before", in a table that has it.
    pub(super) const AS_BEFORE: u8 = 0;

    /// The different colours of a palette.
    pub(super) fn of(palette: &Palette) -> Self {
        Self::of_colors(palette.entries().iter().copied())
    }

    /// The colours of a palette that these pixels have.
    pub(super) fn of_pixels(entries: &[u8], palette: &Palette) -> Self {
        let mut is_used = [false; 256];
        for &entry in entries {
            is_used[usize::from(entry)] = true;
        }
        let used = (0..=u8::MAX).filter(|&entry| is_used[usize::from(entry)]);
        Self::of_colors(used.map(|entry| palette.rgb(entry)))
    }

    fn of_colors(all: impl Iterator<Item = [u8; 3]>) -> Self {
        let mut colors = Vec::with_capacity(256);
        for color in all {
            if !colors.contains(&color) {
                colors.push(color);
            }
        }
        let has_as_before = colors.len() < 256;
        if has_as_before {
            colors.insert(usize::from(Self::AS_BEFORE), [0; 3]);
        }
        Self { colors, has_as_before }
    }

    /// Whether it has an entry that means "as before".
    pub(super) const fn has_as_before(&self) -> bool {
        self.has_as_before
    }

    /// Red, green and blue of each entry.
    pub(super) fn bytes(&self) -> &[u8] {
        self.colors.as_flattened()
    }

    /// The entry for a colour.
    fn entry(&self, color: [u8; 3]) -> Option<u8> {
        let skipped = usize::from(self.has_as_before);
        let found = self.colors.iter().skip(skipped).position(|&c| c == color)?;
        u8::try_from(found + skipped).ok()
    }

    /// The entries for pixels of a picture.
    ///
    /// # Errors
    /// The first colour that the table lacks.
    pub(super) fn entries(&self, pixels: &[u8], palette: &Palette) -> Result<Vec<u8>, [u8; 3]> {
        let entries: [Option<u8>; 256] = palette.entries().map(|color| self.entry(color));
        let entries =
            pixels.iter().map(|&pixel| entries[usize::from(pixel)].ok_or(palette.rgb(pixel)));
        entries.collect()
    }
}
