//! Reads a document.

use super::document::{Connector, Cylinder, Document, Fastening, Link, Slide};
use super::element::{Element, Id};
use super::ratio;
use super::units::Units;
use super::unknown::Unknown;
use crate::document::Message;
use crate::import::color::Color;
use crate::import::drawing::MOST;
use crate::import::omission::Omission;
use std::collections::BTreeMap;

/// The bit of the layers of what belongs to the mechanism.
const MECHANISM_LAYER: Id = 16;

/// The elements of a document by what they are.
#[derive(Default)]
struct Elements<'d> {
    program: Option<Element<'d>>,
    connectors: Vec<Element<'d>>,
    links: Vec<Element<'d>>,
    ratios: Vec<Element<'d>>,
    unknown: Unknown<'d>,
    omissions: Vec<Omission>,
}

/// The numbers of connectors and links by their ids.
pub(super) struct Ids {
    connectors: BTreeMap<Id, usize>,
    links: BTreeMap<Id, usize>,
}

/// Reads a document below its root.
pub(super) fn read(root: &Element<'_>) -> Result<Document, Message> {
    if root.name() != "linkage2" {
        return Err(root.wrong(format!(
            "the root is <{}>; a document of Linkage has the root <linkage2>",
            root.name()
        )));
    }
    let elements = Elements::of(root)?;
    let units = elements.program.as_ref().map(Units::read).transpose()?;
    let units = units.unwrap_or_default();
    let ids = Ids {
        connectors: numbered(&elements.connectors)?,
        links: numbered(&elements.links)?,
    };
    let mut omissions = elements.omissions;
    let connectors = elements.connectors.iter();
    let connectors = connectors
        .map(|element| connector(element, &ids, &units, &mut omissions))
        .collect::<Result<Vec<_>, _>>()?;
    let links = elements.links.iter();
    let links = links
        .map(|element| link(element, &ids, &units, &mut omissions))
        .collect::<Result<Vec<_>, _>>()?;
    let ratios = elements.ratios.iter();
    let ratios = ratios
        .map(|element| ratio::read(element, &ids, &units))
        .collect::<Result<Vec<_>, _>>()?;
    if !links.iter().any(|link| link.is_of_mechanism) {
        return Err(root.wrong("this document has no link, so it has no mechanism"));
    }
    omissions.extend(elements.unknown.omissions());
    Ok(Document {
        units,
        connectors,
        links,
        ratios,
        omissions,
    })
}

impl<'d> Elements<'d> {
    fn of(root: &Element<'d>) -> Result<Self, Message> {
        let mut found = Self::default();
        for element in root.children() {
            match element.name() {
                "program" => found.program = Some(element),
                "connector" => found.connectors.push(element),
                "Link" | "element" => found.links.push(element),
                "ratios" => found.ratios.extend(element.children()),
                "selected" => continue,
                "background" => {
                    if !element.is_empty() {
                        let what = "a picture behind the mechanism has no place in the language";
                        found.omissions.push(Omission::new("background", what));
                    }
                    continue;
                }
                _ => {
                    found.unknown.note(&element);
                    continue;
                }
            }
            found.unknown.note_attributes(&element);
            if found.connectors.len() + found.links.len() + found.ratios.len() > MOST {
                return Err(element.wrong(format!(
                    "there are more than {MOST} connectors and links, which no drawing has"
                )));
            }
        }
        Ok(found)
    }
}

/// Elements by their ids.
fn numbered(elements: &[Element<'_>]) -> Result<BTreeMap<Id, usize>, Message> {
    let mut numbers = BTreeMap::new();
    for (number, element) in elements.iter().enumerate() {
        let id = element.id()?;
        if numbers.insert(id, number).is_some() {
            let name = element.name();
            let text = format!("there is an earlier <{name}> with the id {id}; ids are unique");
            return Err(element.wrong_at("id", text));
        }
    }
    Ok(numbers)
}

impl Ids {
    /// The connector that an attribute names, if it names one.
    fn connector(&self, element: &Element<'_>, name: &str) -> Result<Option<usize>, Message> {
        named(&self.connectors, element, name, "connector")
    }

    /// The link that an attribute names, if it names one.
    pub(super) fn link(&self, element: &Element<'_>, name: &str) -> Result<Option<usize>, Message> {
        named(&self.links, element, name, "link")
    }

    /// The connector that an element stands for.
    fn needed_connector(&self, element: &Element<'_>) -> Result<usize, Message> {
        element.id()?;
        let found = self.connector(element, "id")?;
        found.ok_or_else(|| element.wrong("this element names no connector"))
    }

    /// What an element is fastened to.
    fn fastening(&self, element: &Element<'_>) -> Result<Option<Fastening>, Message> {
        for name in ["fastenlink", "fasten"] {
            if let Some(link) = self.link(element, name)? {
                return Ok(Some(Fastening::Link(link)));
            }
        }
        let connector = self.connector(element, "fastenconnector")?;
        Ok(connector.map(Fastening::Connector))
    }
}

fn named(
    numbers: &BTreeMap<Id, usize>,
    element: &Element<'_>,
    name: &str,
    what: &str,
) -> Result<Option<usize>, Message> {
    let Some(id) = element.whole(name)? else {
        return Ok(None);
    };
    match numbers.get(&id) {
        Some(number) => Ok(Some(*number)),
        None => Err(element.wrong_at(name, format!("there is no {what} {id}"))),
    }
}

fn connector(
    element: &Element<'_>,
    ids: &Ids,
    units: &Units,
    omissions: &mut Vec<Omission>,
) -> Result<Connector, Message> {
    let id = element.id()?;
    let of = format!("connector {id}");
    let at = [element.needed_number("x")?, element.needed_number("y")?];
    let is_input = element.flag("input")?;
    let rpm = element.number("rpm")?.unwrap_or(0.0);
    if is_input && rpm != 0.0 {
        let what = format!("its speed is {rpm} turns a minute; a motor has no speed of its own");
        omissions.push(Omission::new(&*of, what));
    }
    if is_input && element.flag("alwaysmanual")? {
        omissions.push(Omission::new(&*of, "its motor is turned by hand"));
    }
    for (name, what) in [
        (
            "limitangle",
            "the angle to which its motor is limited is not read",
        ),
        ("startoffset", "the offset of its motor is not read"),
    ] {
        if element.number(name)?.is_some_and(|value| value != 0.0) {
            omissions.push(Omission::new(&*of, what));
        }
    }
    let slide = slide(element, ids, units)?;
    if slide.is_none() && element.flag("slider")? {
        omissions.push(Omission::new(
            &*of,
            "it slides, but no connectors say where",
        ));
    }
    Ok(Connector {
        id,
        name: element.own_name(),
        at: at.map(|part| part * units.scale),
        is_anchor: element.flag("anchor")?,
        is_input,
        is_traced: element.flag("draw")?,
        is_of_mechanism: is_of_mechanism(element)?,
        slide,
        fastened: ids.fastening(element)?,
    })
}

/// Whether something is neither a mere picture nor a measure.
fn is_of_mechanism(element: &Element<'_>) -> Result<bool, Message> {
    let layers = element.whole("layer")?.unwrap_or(0);
    let is_measure = element.flag("measurementelement")?;
    Ok((layers == 0 || layers & MECHANISM_LAYER != 0) && !is_measure)
}

/// Between which connectors one slides.
fn slide(element: &Element<'_>, ids: &Ids, units: &Units) -> Result<Option<Slide>, Message> {
    let radius = element.number("slideradius")?.unwrap_or(0.0);
    if !element.flag("slider")? {
        return Ok(None);
    }
    let limits = element
        .children()
        .filter(|child| child.name() == "slidelimit");
    let limits = limits
        .map(|child| ids.needed_connector(&child))
        .collect::<Result<Vec<_>, _>>()?;
    let limits = match limits[..] {
        [] => return Ok(None),
        [a, b] if a != b => [a, b],
        _ => {
            let text = format!(
                "a connector slides between two others; {} <slidelimit> are given",
                limits.len()
            );
            return Err(element.wrong(text));
        }
    };
    // Its sign says on which side of the limits the centre is, which is seen from the connector itself.
    let radius = radius.abs() * units.scale;
    Ok(Some(Slide {
        limits,
        radius: (radius > 0.0).then_some(radius),
    }))
}

fn link(
    element: &Element<'_>,
    ids: &Ids,
    units: &Units,
    omissions: &mut Vec<Omission>,
) -> Result<Link, Message> {
    let id = element.id()?;
    let mut connectors = Vec::new();
    let mut fastened_connectors = Vec::new();
    for child in element.children() {
        let list = match child.name() {
            "connector" => &mut connectors,
            "fastenconnector" => &mut fastened_connectors,
            other => {
                let what = format!("<{other}> in it is not known");
                omissions.push(Omission::new(format!("link {id}"), what));
                continue;
            }
        };
        let connector = ids.needed_connector(&child)?;
        if !list.contains(&connector) {
            list.push(connector);
        }
    }
    Ok(Link {
        id,
        name: element.own_name(),
        cylinder: cylinder(element, id, (&connectors, units), omissions)?,
        connectors,
        is_wheel: element.flag("gear")?,
        is_of_mechanism: is_of_mechanism(element)?,
        fastened_connectors,
        fastened: ids.fastening(element)?,
        color: color(element)?,
    })
}

fn cylinder(
    element: &Element<'_>,
    id: Id,
    (connectors, units): (&[usize], &Units),
    omissions: &mut Vec<Omission>,
) -> Result<Option<Cylinder>, Message> {
    if !element.flag("actuator")? {
        return Ok(None);
    }
    let of = format!("link {id}");
    let &[first, second] = connectors else {
        let count = connectors.len();
        let text = format!("a cylinder has two connectors; this one has {count}");
        return Err(element.wrong(text));
    };
    let stroke = element.number("throw")?.filter(|stroke| *stroke != 0.0);
    if stroke.is_none() {
        let what = "it has no throw, so its motor has no range";
        omissions.push(Omission::new(&*of, what));
    }
    let cycles = element.number("cpm")?.unwrap_or(0.0);
    if cycles != 0.0 {
        let what = format!("it goes {cycles} times a minute; a motor has no speed of its own");
        omissions.push(Omission::new(&*of, what));
    }
    if element.flag("alwaysmanual")? {
        omissions.push(Omission::new(of, "its motor is moved by hand"));
    }
    Ok(Some(Cylinder {
        ends: [first, second],
        // One that goes backwards becomes shorter first.
        stroke: stroke.map(|stroke| stroke * units.scale * cycles.signum()),
    }))
}

/// The colour that a user chose: blue, green and red, from the highest byte on.
fn color(element: &Element<'_>) -> Result<Option<Color>, Message> {
    let color = element.whole("color")?;
    let is_chosen = element.flag("usercolor")?;
    Ok(color.filter(|_| is_chosen).map(|color| {
        let [red, green, blue, _] = color.to_le_bytes();
        Color([red, green, blue])
    }))
}
