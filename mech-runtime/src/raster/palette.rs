//! Palettes.

use mech_core::colors;

/// A palette of 256 colours: red, green and blue of each entry.
///
/// All ready-made palettes have the same order, so a scene can change its palette:
///
/// | entry | colour |
/// |---|---|
/// | 0 | [`PAPER`](Self::PAPER), the background |
/// | 1 | [`GROUND`](Self::GROUND) |
/// | 2 ..= 13 | twelve main colours for links: [`BLUE`](Self::BLUE), [`ORANGE`](Self::ORANGE), [`TEAL`](Self::TEAL), [`RED`](Self::RED), [`YELLOW`](Self::YELLOW), [`PURPLE`](Self::PURPLE), [`GREEN`](Self::GREEN), [`PINK`](Self::PINK), [`SKY`](Self::SKY), [`BROWN`](Self::BROWN), [`OLIVE`](Self::OLIVE), [`SLATE`](Self::SLATE) |
/// | 14 | [`INK`](Self::INK), for pins and lines |
/// | 15 | [`EYE`](Self::EYE), for the hole in a pin |
/// | 16 | [`HATCH`](Self::HATCH), for the hatching of the ground |
/// | 17 | [`STEEL`](Self::STEEL), for plain metal |
/// | 18 ..= 29 | the main colours, darker (nearer the ink): see [`darker`](Self::darker) |
/// | 30, 31 | [`GROUND_DARK`](Self::GROUND_DARK), [`GROUND_LIGHT`](Self::GROUND_LIGHT) |
/// | 32, 33 | [`STEEL_DARK`](Self::STEEL_DARK), [`STEEL_LIGHT`](Self::STEEL_LIGHT) |
/// | 34 ..= 45 | the main colours, lighter (nearer the paper): see [`lighter`](Self::lighter) |
/// | 46, 47 | [`SHADE`](Self::SHADE) and [`GRID`](Self::GRID), a little off the background |
/// | 48 ..= 63 | sixteen steps from [`INK`](Self::INK) to [`PAPER`](Self::PAPER) |
/// | 64 ..= 255 | twelve ramps of sixteen steps, from a main colour near the ink to one near the paper: see [`shade`](Self::shade) |
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Palette {
    entries: [[u8; 3]; 256],
}

impl Palette {
    /// The background.
    pub const PAPER: u8 = colors::PAPER;
    /// The ground, and other fixed parts.
    pub const GROUND: u8 = colors::GROUND;
    /// The first main colour.
    pub const BLUE: u8 = 2;
    /// A main colour.
    pub const ORANGE: u8 = 3;
    /// A main colour.
    pub const TEAL: u8 = 4;
    /// A main colour.
    pub const RED: u8 = 5;
    /// A main colour.
    pub const YELLOW: u8 = 6;
    /// A main colour.
    pub const PURPLE: u8 = 7;
    /// A main colour.
    pub const GREEN: u8 = 8;
    /// A main colour.
    pub const PINK: u8 = 9;
    /// A main colour.
    pub const SKY: u8 = 10;
    /// A main colour.
    pub const BROWN: u8 = 11;
    /// A main colour.
    pub const OLIVE: u8 = 12;
    /// The last main colour.
    pub const SLATE: u8 = 13;
    /// Pins and lines: stands out against all other colours.
    pub const INK: u8 = colors::INK;
    /// The hole in a pin: stands out against the ink.
    pub const EYE: u8 = colors::EYE;
    /// The hatching of the ground.
    pub const HATCH: u8 = 16;
    /// Plain metal.
    pub const STEEL: u8 = colors::STEEL;
    /// The ground, darker.
    pub const GROUND_DARK: u8 = 30;
    /// The ground, lighter.
    pub const GROUND_LIGHT: u8 = 31;
    /// Plain metal, darker.
    pub const STEEL_DARK: u8 = 32;
    /// Plain metal, lighter.
    pub const STEEL_LIGHT: u8 = 33;
    /// A soft shadow on the background.
    pub const SHADE: u8 = 46;
    /// Faint lines on the background.
    pub const GRID: u8 = 47;

    /// The palette of a textbook: calm colours on warm white paper, distinct also for the colour-blind.
    pub const TEXTBOOK: Self = Self::build(&[
        [0xFA, 0xF6, 0xED], // paper
        [0x9A, 0x90, 0x84], // ground
        [0x3F, 0x74, 0xB0], // blue
        [0xE0, 0x85, 0x36], // orange
        [0x2E, 0x9C, 0x90], // teal
        [0xC9, 0x4F, 0x45], // red
        [0xEB, 0xBE, 0x4D], // yellow
        [0x7B, 0x62, 0xA6], // purple
        [0x76, 0xA8, 0x56], // green
        [0xDC, 0x8F, 0xA9], // pink
        [0x86, 0xBB, 0xDD], // sky
        [0x8F, 0x61, 0x43], // brown
        [0xA6, 0x9F, 0x3C], // olive
        [0x4D, 0x5D, 0x78], // slate
        [0x2A, 0x2C, 0x39], // ink
        [0xFF, 0xFF, 0xFF], // eye
        [0xD3, 0xCB, 0xBE], // hatch
        [0xA3, 0xAB, 0xB4], // steel
    ]);

    /// A palette for the night: brighter colours on deep blue. Its ink is light and its paper dark. So darker colours of the day are lighter
    /// at night, and stand out as much.
    pub const NIGHT: Self = Self::build(&[
        [0x15, 0x18, 0x22], // paper
        [0x6C, 0x72, 0x80], // ground
        [0x5B, 0x93, 0xD6], // blue
        [0xF0, 0x9A, 0x4E], // orange
        [0x43, 0xB8, 0xAB], // teal
        [0xE2, 0x6B, 0x60], // red
        [0xF3, 0xCC, 0x66], // yellow
        [0x9A, 0x82, 0xCB], // purple
        [0x8F, 0xC2, 0x6E], // green
        [0xEA, 0xA3, 0xBC], // pink
        [0x9F, 0xD0, 0xEF], // sky
        [0xB0, 0x80, 0x5F], // brown
        [0xBF, 0xB8, 0x55], // olive
        [0x7F, 0x90, 0xAE], // slate
        [0xEC, 0xEA, 0xE4], // ink
        [0x0B, 0x0D, 0x13], // eye
        [0x3A, 0x40, 0x4E], // hatch
        [0x8D, 0x97, 0xA6], // steel
    ]);

    /// A palette of these colours.
    #[must_use]
    pub const fn new(entries: [[u8; 3]; 256]) -> Self {
        Self { entries }
    }

    /// Replaces the colour of one entry.
    #[must_use]
    pub const fn with(mut self, entry: u8, rgb: [u8; 3]) -> Self {
        self.entries[entry as usize] = rgb;
        self
    }

    /// Red, green and blue of an entry.
    #[must_use]
    pub const fn rgb(&self, entry: u8) -> [u8; 3] {
        self.entries[entry as usize]
    }

    /// Red, green, blue and full opacity of an entry.
    #[must_use]
    pub const fn rgba(&self, entry: u8) -> [u8; 4] {
        let [red, green, blue] = self.rgb(entry);
        [red, green, blue, 255]
    }

    /// Red, green and blue of every entry.
    #[must_use]
    pub const fn entries(&self) -> &[[u8; 3]; 256] {
        &self.entries
    }

    /// The entry of a darker main colour, ground or steel. Any other entry stays the same.
    #[must_use]
    pub const fn darker(color: u8) -> u8 {
        colors::darker(color)
    }

    /// The entry of a lighter main colour, ground or steel. Any other entry stays the same.
    #[must_use]
    pub const fn lighter(color: u8) -> u8 {
        colors::lighter(color)
    }

    /// The entry of a step from the ink (step 0) through a main colour (between 7 and 8) to the paper (step 15 and above). For any other
    /// colour, the entry of a step from plain ink to plain paper.
    #[must_use]
    pub const fn shade(color: u8, step: u8) -> u8 {
        let step = if step < 16 { step } else { 15 };
        match color {
            Self::BLUE..=Self::SLATE => 32 + 16 * color + step,
            _ => 48 + step,
        }
    }

    /// The whole table from its first 18 entries.
    const fn build(base: &[[u8; 3]; 18]) -> Self {
        let mut entries = [[0; 3]; 256];
        let mut color = 0;
        while color < base.len() {
            entries[color] = base[color];
            color += 1;
        }
        let paper = base[Self::PAPER as usize];
        let ground = base[Self::GROUND as usize];
        let ink = base[Self::INK as usize];
        let steel = base[Self::STEEL as usize];
        entries[Self::GROUND_DARK as usize] = mix(ground, ink, 100);
        entries[Self::GROUND_LIGHT as usize] = mix(ground, paper, 110);
        entries[Self::STEEL_DARK as usize] = mix(steel, ink, 100);
        entries[Self::STEEL_LIGHT as usize] = mix(steel, paper, 130);
        entries[Self::SHADE as usize] = mix(paper, ink, 24);
        entries[Self::GRID as usize] = mix(paper, ink, 40);
        let mut step = 0;
        while step < 16 {
            entries[48 + step] = mix(ink, paper, 17 * step);
            step += 1;
        }
        let mut main = Self::BLUE as usize;
        while main <= Self::SLATE as usize {
            let color = base[main];
            entries[main + 16] = mix(color, ink, 90);
            entries[main + 32] = mix(color, paper, 130);
            let mut step = 0;
            while step < 8 {
                entries[32 + 16 * main + step] = mix(ink, color, 30 + 30 * step);
                entries[32 + 16 * main + 8 + step] = mix(color, paper, 15 + 30 * step);
                step += 1;
            }
            main += 1;
        }
        Self { entries }
    }
}

/// [`TEXTBOOK`](Palette::TEXTBOOK).
impl Default for Palette {
    fn default() -> Self {
        Self::TEXTBOOK
    }
}

/// A colour with `part`/255 of another in it.
const fn mix(one: [u8; 3], other: [u8; 3], part: usize) -> [u8; 3] {
    let mut mixture = [0; 3];
    let mut channel = 0;
    while channel < 3 {
        let sum = one[channel] as usize * (255 - part) + other[channel] as usize * part;
        #[expect(clippy::cast_possible_truncation, reason = "a mean of two bytes")]
        let byte = ((sum + 127) / 255) as u8;
        mixture[channel] = byte;
        channel += 1;
    }
    mixture
}
