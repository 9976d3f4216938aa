//! The named colours of all ready-made palettes.

/// The names and entries of the colours, in the order of the entries.
pub const NAMED: [(&str, u8); 18] = [
    ("paper", 0),
    ("ground", 1),
    ("blue", 2),
    ("orange", 3),
    ("teal", 4),
    ("red", 5),
    ("yellow", 6),
    ("purple", 7),
    ("green", 8),
    ("pink", 9),
    ("sky", 10),
    ("brown", 11),
    ("olive", 12),
    ("slate", 13),
    ("ink", 14),
    ("eye", 15),
    ("hatch", 16),
    ("steel", 17),
];

/// The background.
pub const PAPER: u8 = 0;
/// The ground.
pub const GROUND: u8 = 1;
/// Pins and lines.
pub const INK: u8 = 14;
/// The hole in a pin.
pub const EYE: u8 = 15;
/// Plain metal.
pub const STEEL: u8 = 17;

const FIRST_MAIN: u8 = 2;
const LAST_MAIN: u8 = 13;

/// The main colour with a number, for links: after the last comes the first again.
#[must_use]
pub const fn main(number: u8) -> u8 {
    FIRST_MAIN + number % MAIN_COUNT
}

/// The number of main colours.
pub const MAIN_COUNT: u8 = LAST_MAIN - FIRST_MAIN + 1;

/// The entry of a darker main colour, ground or steel. Any other entry stays the same.
#[must_use]
pub const fn darker(color: u8) -> u8 {
    match color {
        GROUND => 30,
        STEEL => 32,
        FIRST_MAIN..=LAST_MAIN => color + 16,
        _ => color,
    }
}

/// The entry of a lighter main colour, ground or steel. Any other entry stays the same.
#[must_use]
pub const fn lighter(color: u8) -> u8 {
    match color {
        GROUND => 31,
        STEEL => 33,
        FIRST_MAIN..=LAST_MAIN => color + 32,
        _ => color,
    }
}
