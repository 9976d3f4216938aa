//! Units of length.

use super::element::Element;
use crate::document::Message;

/// Documents count in pixels, 96 to the inch.
const PIXELS: f64 = 96.0;

/// The names of units in a document, in the text, and how long an inch is in them.
const UNITS: [(&str, &str, f64); 5] = [
    ("Millimeters", "millimetres", 25.4),
    ("Centimeters", "centimetres", 2.54),
    ("Meters", "metres", 0.0254),
    ("Inches", "inches", 1.0),
    ("Feet", "feet", 1.0 / 12.0),
];

/// The unit of length, and how long a pixel is in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Units {
    pub(super) name: &'static str,
    pub(super) scale: f64,
}

/// Millimetres: what a document is in that does not say.
impl Default for Units {
    fn default() -> Self {
        let (_, name, inch) = UNITS[0];
        let scale = inch / PIXELS;
        Self { name, scale }
    }
}

impl Units {
    pub(super) fn read(program: &Element<'_>) -> Result<Self, Message> {
        let factor = match program.number("scalefactor")? {
            None | Some(0.0) => 1.0,
            Some(factor) if factor > 0.0 => factor,
            Some(_) => {
                return Err(program.wrong_at("scalefactor", "`scalefactor` is below zero"));
            }
        };
        let Some(word) = program.text("units") else {
            let scale = Self::default().scale * factor;
            return Ok(Self {
                scale,
                ..Self::default()
            });
        };
        let known = UNITS.iter().find(|(known, _, _)| *known == word);
        let (_, name, inch) = known.ok_or_else(|| {
            let known = UNITS.map(|(known, _, _)| format!("`{known}`")).join(", ");
            let text = format!("`units` is `{word}`, which is not known; known are {known}");
            program.wrong_at("units", text)
        })?;
        let scale = inch / PIXELS * factor;
        Ok(Self { name, scale })
    }
}
