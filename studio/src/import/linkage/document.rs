//! The content of a document: connectors, links and ratios, with the numbers by which they name each other resolved; and its units.

use super::element::{Element, Id};
use crate::document::Message;
use crate::import::color::Color;
use crate::import::drawing::{Omission, Pair, Sizes};

pub(super) struct Document {
    pub(super) units: Units,
    pub(super) connectors: Vec<Connector>,
    pub(super) links: Vec<Link>,
    pub(super) ratios: Vec<Ratio>,
    pub(super) omissions: Vec<Omission>,
}

#[expect(clippy::struct_excessive_bools, reason = "each is a flag of the format")]
pub(super) struct Connector {
    pub(super) id: Id,
    pub(super) name: Option<String>,
    /// In the unit of length.
    pub(super) at: Pair,
    pub(super) is_anchor: bool,
    pub(super) is_input: bool,
    /// The speed of its motor in turns a minute, clockwise above zero; none where it is turned by hand.
    pub(super) turns: Option<f64>,
    pub(super) is_traced: bool,
    /// Not a mere picture.
    pub(super) is_of_mechanism: bool,
    pub(super) slide: Option<Slide>,
    pub(super) fastened: Option<Fastening>,
}

/// Between which connectors another slides, by their numbers.
#[derive(Clone, Copy)]
pub(super) struct Slide {
    pub(super) limits: [usize; 2],
    /// The radius of the arc; none where it is straight.
    pub(super) radius: Option<f64>,
}

/// The number of the link or connector to which something is rigidly fastened.
#[derive(Clone, Copy)]
pub(super) enum Fastening {
    Link(usize),
    Connector(usize),
}

/// A rigid link, a wheel or a cylinder.
pub(super) struct Link {
    pub(super) id: Id,
    pub(super) name: Option<String>,
    /// By their numbers, each once.
    pub(super) connectors: Vec<usize>,
    pub(super) cylinder: Option<Cylinder>,
    pub(super) is_wheel: bool,
    /// Neither a mere picture nor a measure.
    pub(super) is_of_mechanism: bool,
    /// Connectors that are rigidly one with it.
    pub(super) fastened_connectors: Vec<usize>,
    pub(super) fastened: Option<Fastening>,
    /// A colour that its user chose.
    pub(super) color: Option<Color>,
}

/// A link that changes its length.
#[derive(Clone, Copy)]
pub(super) struct Cylinder {
    /// From the first of these connectors to the second.
    pub(super) ends: [usize; 2],
    /// Its stroke: below zero if it becomes shorter.
    pub(super) stroke: Option<f64>,
    /// Its speed in cycles a minute, to the end of its stroke and back; none where it is moved by hand.
    pub(super) cycles: Option<f64>,
}

/// Two wheels that roll on each other.
pub(super) struct Ratio {
    pub(super) is_chain: bool,
    /// By their numbers.
    pub(super) links: [usize; 2],
    pub(super) sizes: Sizes,
}

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
            return Ok(Self { scale, ..Self::default() });
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
