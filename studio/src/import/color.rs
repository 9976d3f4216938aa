//! Colours, as the language names them.

use mech_core::colors::{EYE, NAMED, PAPER, darker, lighter};
use mech_runtime::Palette;

/// A colour by its red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Color(pub(super) [u8; 3]);

impl Color {
    /// The colour of the language that is nearest to it: `teal light`.
    pub(super) fn name(self) -> String {
        // Nothing is seen on the background in its own colour.
        let named = NAMED.iter().filter(|(_, entry)| ![PAPER, EYE].contains(entry));
        let shades = named.flat_map(|&(name, entry)| {
            let plain = (name.to_owned(), entry);
            let dark = (format!("{name} dark"), darker(entry));
            let light = (format!("{name} light"), lighter(entry));
            let shaded = [dark, light].into_iter().filter(move |one| one.1 != entry);
            [plain].into_iter().chain(shaded)
        });
        let nearest = shades.min_by_key(|(_, entry)| self.distance(Palette::TEXTBOOK.rgb(*entry)));
        nearest.map_or_else(|| "ink".to_owned(), |(name, _)| name)
    }

    /// The square of the distance of two colours.
    fn distance(self, other: [u8; 3]) -> u32 {
        let parts = self.0.into_iter().zip(other);
        parts.map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::Color;

    #[test]
    fn the_nearest_color_has_a_name() {
        assert_eq!(Color([0x2E, 0x9C, 0x90]).name(), "teal");
        assert_eq!(Color([0xC0, 0x50, 0x40]).name(), "red");
        assert_eq!(Color([0, 0, 0]).name(), "ink");
    }
}
