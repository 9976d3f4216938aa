//! The compiler's names of colours are those of the palettes.

use mech_core::colors::NAMED;
use mech_runtime::Palette;

#[test]
fn colors_have_the_same_numbers_in_messages() {
    let entries = [
        Palette::PAPER,
        Palette::GROUND,
        Palette::BLUE,
        Palette::ORANGE,
        Palette::TEAL,
        Palette::RED,
        Palette::YELLOW,
        Palette::PURPLE,
        Palette::GREEN,
        Palette::PINK,
        Palette::SKY,
        Palette::BROWN,
        Palette::OLIVE,
        Palette::SLATE,
        Palette::INK,
        Palette::EYE,
        Palette::HATCH,
        Palette::STEEL,
    ];
    assert_eq!(NAMED.map(|(_, number)| number), entries);
}
