//! Pictures as text: each character shows two pixels, one above the other.

use mech_runtime::HeapSmooth;
use std::fmt::Write;

/// The colours of a terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// By red, green and blue.
    True,
    /// By a table of 256: a cube with six steps of each.
    Cube,
}

impl Depth {
    /// Finds the depth of the terminal's colours in the environment of the process.
    pub(crate) fn of_environment() -> Self {
        let says = |name: &str, words: &[&str]| {
            std::env::var(name).is_ok_and(|value| words.iter().any(|word| value.contains(word)))
        };
        if says("COLORTERM", &["truecolor", "24bit"]) || says("TERM", &["direct", "kitty"]) {
            Self::True
        } else {
            Self::Cube
        }
    }
}

/// The lines of a picture: every two rows of it are one.
#[must_use]
pub fn lines(picture: &HeapSmooth, depth: Depth) -> Vec<String> {
    let width = picture.width().max(1);
    let rows: Vec<&[[u8; 4]]> = picture.pixels().chunks(width).collect();
    rows.chunks(2).map(|rows| line(rows, depth)).collect()
}

fn line(rows: &[&[[u8; 4]]], depth: Depth) -> String {
    let mut text = String::new();
    let mut last = None;
    let [upper, lower] = [rows.first(), rows.get(1).or(rows.first())];
    let (Some(upper), Some(lower)) = (upper, lower) else {
        return text;
    };
    for colors in upper.iter().zip(*lower) {
        if last.replace(colors) != Some(colors) {
            let (&[r, g, b, _], &[s, h, c, _]) = colors;
            // Writing to a string does not fail.
            let _ = match depth {
                Depth::True => {
                    write!(text, "\x1b[38;2;{r};{g};{b};48;2;{s};{h};{c}m")
                }
                Depth::Cube => {
                    write!(text, "\x1b[38;5;{};48;5;{}m", entry([r, g, b]), entry([s, h, c]))
                }
            };
        }
        text.push('▀');
    }
    text.push_str("\x1b[0m");
    text
}

/// The entry of the table of 256 colours that comes nearest: in the cube, or among the greys.
fn entry(color: [u8; 3]) -> u8 {
    const STEPS: [u8; 6] = [0, 95, 135, 175, 215, 255];
    let nearest = |channel: u8| {
        let steps = (0_u8..).zip(STEPS);
        let nearest = steps.min_by_key(|(_, step)| step.abs_diff(channel));
        nearest.unwrap_or((0, 0))
    };
    let [red, green, blue] = color.map(nearest);
    let cube = 16 + 36 * red.0 + 6 * green.0 + blue.0;
    let mean = color.iter().map(|&channel| u32::from(channel)).sum::<u32>() / 3;
    let step = u8::try_from((mean.saturating_sub(3) / 10).min(23)).unwrap_or(0);
    let grey = 8 + 10 * step;
    let distance = |other: [u8; 3]| -> u32 {
        let pairs = color.iter().zip(other);
        pairs.map(|(one, other)| u32::from(one.abs_diff(other)).pow(2)).sum()
    };
    if distance([grey; 3]) < distance([red.1, green.1, blue.1]) { 232 + step } else { cube }
}
