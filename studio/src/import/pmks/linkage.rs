//! The content of a link: joints, links and forces, with the names by which they call each other resolved; and its units.

use super::query::Field;
use crate::document::Message;
use crate::import::color::Color;
use crate::import::drawing::{MOST, Mass, Omission, Pair};
use std::collections::BTreeMap;

pub(super) struct Linkage {
    /// The unit of length, if it is known.
    pub(super) unit: Option<Unit>,
    pub(super) has_gravity: bool,
    pub(super) speeds: Speeds,
    pub(super) joints: Vec<Joint>,
    pub(super) links: Vec<Link>,
    pub(super) forces: Vec<Force>,
    pub(super) omissions: Vec<Omission>,
}

/// The speeds of inputs that have none of their own; counter-clockwise is above zero.
#[derive(Clone, Copy, Default)]
pub(super) struct Speeds {
    /// In turns a minute.
    pub(super) turning: f64,
    /// In units of length a second; 0 where it is not said.
    pub(super) sliding: f64,
}

#[expect(clippy::struct_excessive_bools, reason = "each is a flag of the format")]
pub(super) struct Joint {
    pub(super) name: String,
    pub(super) at: Pair,
    /// The direction of a prismatic joint, in radians; none of a revolute joint.
    pub(super) along: Option<f64>,
    pub(super) is_grounded: bool,
    pub(super) is_input: bool,
    pub(super) is_welded: bool,
    pub(super) is_traced: bool,
    /// Whether it is the piston of a cylinder, which does not turn in its barrel.
    pub(super) is_sealed: bool,
    /// The slot in a link on which it slides, if it does.
    pub(super) slot: Option<Slot>,
    /// Its speed as an input; 0 where it has none of its own.
    pub(super) speed: f64,
    /// The mass of the block that slides.
    pub(super) mass: f64,
}

/// A slot in a link, from one of its joints to another, by their numbers.
#[derive(Clone, Copy)]
pub(super) struct Slot {
    pub(super) carrier: usize,
    pub(super) ends: [usize; 2],
}

/// A link, or one that is welded into another.
pub(super) struct Link {
    pub(super) name: String,
    /// Whether it is not welded into another.
    pub(super) is_root: bool,
    /// Whether it is the block of a slider. Its centre of mass is at its pin.
    pub(super) is_block: bool,
    /// By their numbers, each once.
    pub(super) joints: Vec<usize>,
    pub(super) welded: Vec<usize>,
    pub(super) mass: Option<Mass>,
    pub(super) color: Option<Color>,
}

pub(super) struct Force {
    pub(super) name: String,
    pub(super) link: usize,
    pub(super) at: Pair,
    /// Its parts along x and y, in the scene at the start.
    pub(super) parts: Pair,
    /// Whether it turns with its link.
    pub(super) is_local: bool,
}

/// The numbers of joints or links by their ids.
pub(super) struct Ids<'q> {
    what: &'static str,
    numbers: BTreeMap<&'q str, usize>,
}

impl<'q> Ids<'q> {
    pub(super) fn of(what: &'static str) -> Self {
        Self { what, numbers: BTreeMap::new() }
    }

    /// Enters the id of the next one.
    pub(super) fn enter(&mut self, id: &Field<'q>) -> Result<(), Message> {
        let what = self.what;
        if id.text().is_empty() {
            return Err(id.wrong(format!("the id of a {what} is missing here")));
        }
        let number = self.numbers.len();
        if number >= MOST {
            return Err(
                id.wrong(format!("there are more than {MOST} {what}s, which no drawing has"))
            );
        }
        if self.numbers.insert(id.text(), number).is_some() {
            let text = id.text();
            return Err(id.wrong(format!(
                "there is an earlier {what} with the id `{text}`; ids are unique"
            )));
        }
        Ok(())
    }

    pub(super) fn has(&self, id: &Field<'q>) -> bool {
        self.numbers.contains_key(id.text())
    }

    /// The number of the one with this id.
    pub(super) fn find(&self, id: &Field<'q>) -> Result<usize, Message> {
        let number = self.numbers.get(id.text()).copied();
        number.ok_or_else(|| id.wrong(format!("there is no {} `{}`", self.what, id.text())))
    }

    /// The numbers of several, each once.
    pub(super) fn find_all(
        &self,
        ids: impl Iterator<Item = Field<'q>>,
    ) -> Result<Vec<usize>, Message> {
        let mut found = Vec::new();
        for id in ids {
            let number = self.find(&id)?;
            if !found.contains(&number) {
                found.push(number);
            }
        }
        Ok(found)
    }
}

/// A name; its id where it has none.
pub(super) fn name_of(name: &Field<'_>, id: &Field<'_>) -> String {
    let own = [name, id].into_iter().map(|one| one.text().trim());
    own.filter(|name| !name.is_empty()).map(ToOwned::to_owned).next().unwrap_or_default()
}

impl Joint {
    /// A joint of this form and place that is nothing more.
    pub(super) fn plain(name: String, at: Pair, along: Option<f64>) -> Self {
        Self {
            name,
            at,
            along,
            is_grounded: false,
            is_input: false,
            is_welded: false,
            is_traced: false,
            is_sealed: false,
            slot: None,
            speed: 0.0,
            mass: 0.0,
        }
    }
}

pub(super) fn mass_of(
    field: &Field<'_>,
    mass: f64,
    inertia: f64,
    at: Pair,
) -> Result<Option<Mass>, Message> {
    if mass < 0.0 || inertia < 0.0 {
        return Err(field.wrong("a mass and a moment of inertia are not below zero"));
    }
    Ok((mass > 0.0).then_some(Mass { value: mass, at, inertia }))
}

/// The parts of a force of this magnitude, from its start to its end or back.
pub(super) fn parts_of([from, to]: [Pair; 2], is_outward: bool, magnitude: f64) -> Pair {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let length = x.hypot(y);
    if length == 0.0 {
        return [0.0, 0.0];
    }
    let factor = magnitude / length * if is_outward { 1.0 } else { -1.0 };
    [x * factor, y * factor]
}

/// The acceleration of gravity in metres, as PMKS+ has it.
const GRAVITY: f64 = 9.806_65;
/// The same in inches: how many pounds of mass a pound of force gives an inch a second squared.
const GRAVITY_IN_INCHES: f64 = GRAVITY / 0.0254;

/// A unit of length. Masses become such that forces keep their numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unit {
    pub(super) name: &'static str,
    /// The remark in the text on masses and forces.
    pub(super) remark: &'static str,
    /// A mass of 1 of the link in the text.
    pub(super) mass: f64,
    /// A moment of inertia of 1 of the link in the text.
    pub(super) inertia: f64,
    pub(super) gravity: f64,
}

/// By their numbers in a link.
pub(super) const UNITS: [Unit; 3] = [
    // Pounds of mass and pound square inches; forces are in pounds.
    Unit {
        name: "inches",
        remark: "Forces are in pounds, torques in inch pounds, masses in units of 386.09 pounds, which fit these.",
        mass: 1.0 / GRAVITY_IN_INCHES,
        inertia: 1.0 / GRAVITY_IN_INCHES,
        gravity: GRAVITY_IN_INCHES,
    },
    // Grams and kilogram square centimetres; forces are in newtons.
    Unit {
        name: "centimetres",
        remark: "Forces are in newtons, torques in newton centimetres, masses in units of 100 kilograms, which fit these.",
        mass: 1e-5,
        inertia: 1e-2,
        gravity: 100.0 * GRAVITY,
    },
    Unit {
        name: "metres",
        remark: "Forces are in newtons, torques in newton metres, masses in kilograms.",
        mass: 1.0,
        inertia: 1.0,
        gravity: GRAVITY,
    },
];
