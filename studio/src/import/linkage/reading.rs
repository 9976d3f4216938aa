//! Reads a document.

use super::document::{Connector, Cylinder, Document, Link, Slide, Units};
use super::element::Element;
use super::ids::{Ids, Losses, numbered};
use super::ratio;
use super::unknown::Unknown;
use crate::document::Message;
use crate::import::color::Color;
use crate::import::drawing::{MOST, Omission};

/// The bit of the layers of what belongs to the mechanism.
const MECHANISM_LAYER: u32 = 16;

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
        scale: units.scale,
    };
    let mut omissions = elements.omissions;
    let connectors = elements.connectors.iter();
    let mut connectors = connectors
        .map(|element| connector(element, &ids, &mut omissions))
        .collect::<Result<Vec<_>, _>>()?;
    let links = elements.links.iter();
    let mut links =
        links.map(|element| link(element, &ids, &mut omissions)).collect::<Result<Vec<_>, _>>()?;
    let ratios = elements.ratios.iter().zip(1..);
    let ratios = ratios
        .map(|(element, number)| {
            let of = format!("ratio {number}");
            let omissions = &mut omissions;
            ratio::read(element, &ids, &mut Losses { of, omissions })
        })
        .collect::<Result<Vec<_>, _>>()?;
    let ratios = ratios.into_iter().flatten().collect();
    ids.settle_connectors(&mut connectors, &mut omissions);
    ids.settle_links(&mut links, &mut omissions);
    if !links.iter().any(|link| link.is_of_mechanism) {
        return Err(root.wrong("this document has no link, so it has no mechanism"));
    }
    omissions.extend(elements.unknown.omissions());
    Ok(Document { units, connectors, links, ratios, omissions })
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

fn connector(
    element: &Element<'_>,
    ids: &Ids,
    omissions: &mut Vec<Omission>,
) -> Result<Connector, Message> {
    let id = element.id()?;
    let of = format!("connector {id}");
    let mut losses = Losses { of, omissions };
    let at = [element.needed_number("x")?, element.needed_number("y")?];
    let is_input = element.flag("input")?;
    let mut turns = element.number("rpm")?.filter(|turns| *turns != 0.0);
    if is_input && element.flag("alwaysmanual")? {
        losses.note("its motor is turned by hand");
        turns = None;
    }
    for (name, what) in [
        ("limitangle", "the angle to which its motor is limited is not read"),
        ("startoffset", "the offset of its motor is not read"),
    ] {
        if element.number(name)?.is_some_and(|value| value != 0.0) {
            losses.note(what);
        }
    }
    let slide = slide(element, ids, &mut losses)?;
    if slide.is_none() && element.flag("slider")? {
        losses.note("it slides, but no two connectors say where");
    }
    Ok(Connector {
        id,
        name: element.own_name(),
        at: at.map(|part| part * ids.scale),
        is_anchor: element.flag("anchor")?,
        is_input,
        turns,
        is_traced: element.flag("draw")?,
        is_of_mechanism: is_of_mechanism(element)?,
        slide,
        fastened: ids.fastening(element, &mut losses)?,
    })
}

/// Whether something is neither a mere picture nor a measure.
fn is_of_mechanism(element: &Element<'_>) -> Result<bool, Message> {
    let layers = element.whole("layer")?.unwrap_or(0);
    let is_measure = element.flag("measurementelement")?;
    Ok((layers == 0 || layers & MECHANISM_LAYER != 0) && !is_measure)
}

/// Between which connectors one slides. As in Linkage the first two that are there count.
fn slide(
    element: &Element<'_>,
    ids: &Ids,
    losses: &mut Losses<'_>,
) -> Result<Option<Slide>, Message> {
    let radius = element.number("slideradius")?.unwrap_or(0.0);
    if !element.flag("slider")? {
        return Ok(None);
    }
    let limits = element.children().filter(|child| child.name() == "slidelimit");
    let limits =
        limits.map(|child| ids.connector_of(&child, losses)).collect::<Result<Vec<_>, _>>()?;
    let limits: Vec<usize> = limits.into_iter().flatten().collect();
    let limits = match limits[..] {
        [a, b, ..] if a != b => [a, b],
        _ => return Ok(None),
    };
    // Its sign says on which side of the limits the centre is, which is seen from the connector itself.
    let radius = radius.abs() * ids.scale;
    Ok(Some(Slide { limits, radius: (radius > 0.0).then_some(radius) }))
}

fn link(element: &Element<'_>, ids: &Ids, omissions: &mut Vec<Omission>) -> Result<Link, Message> {
    let id = element.id()?;
    let of = format!("link {id}");
    let mut losses = Losses { of, omissions };
    let mut connectors = Vec::new();
    let mut fastened_connectors = Vec::new();
    for child in element.children() {
        let list = match child.name() {
            "connector" => &mut connectors,
            "fastenconnector" => &mut fastened_connectors,
            other => {
                losses.note(format!("<{other}> in it is not known"));
                continue;
            }
        };
        if let Some(found) = ids.connector_of(&child, &mut losses)?
            && !list.contains(&found)
        {
            list.push(found);
        }
    }
    Ok(Link {
        id,
        name: element.own_name(),
        cylinder: cylinder(element, (&connectors, ids), &mut losses)?,
        connectors,
        is_wheel: element.flag("gear")?,
        is_of_mechanism: is_of_mechanism(element)?,
        fastened_connectors,
        fastened: ids.fastening(element, &mut losses)?,
        color: color(element)?,
    })
}

fn cylinder(
    element: &Element<'_>,
    (connectors, ids): (&[usize], &Ids),
    losses: &mut Losses<'_>,
) -> Result<Option<Cylinder>, Message> {
    if !element.flag("actuator")? {
        return Ok(None);
    }
    let &[first, second] = connectors else {
        let count = connectors.len();
        losses.note(format!("a cylinder has two connectors; this one has {count}, so it is none"));
        return Ok(None);
    };
    let stroke = element.number("throw")?.filter(|stroke| *stroke != 0.0);
    if stroke.is_none() {
        losses.note("it has no throw, so its motor has no range");
    }
    let cycles = element.number("cpm")?.unwrap_or(0.0);
    let is_manual = element.flag("alwaysmanual")?;
    if is_manual {
        losses.note("its motor is moved by hand");
    }
    Ok(Some(Cylinder {
        ends: [first, second],
        // One that goes backwards becomes shorter first.
        stroke: stroke.map(|stroke| stroke * ids.scale * cycles.signum()),
        cycles: (!is_manual && cycles != 0.0).then_some(cycles.abs()),
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
