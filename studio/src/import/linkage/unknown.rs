//! The attributes and elements of a document that are not read.

use super::element::Element;
use crate::import::drawing::Omission;
use std::collections::{BTreeMap, BTreeSet};

/// Attributes that are read, or that only the editor of drawings needs.
const READ: [&str; 36] = [
    "actuator",
    "alwaysmanual",
    "anchor",
    "color",
    "cpm",
    "draw",
    "editlayers",
    "fasten",
    "fastenconnector",
    "fastenlink",
    "gear",
    "id",
    "input",
    "layer",
    "limitangle",
    "locked",
    "measurementelement",
    "name",
    "rpm",
    "scalefactor",
    "selected",
    "size",
    "sizeassize",
    "slider",
    "slideradius",
    "startoffset",
    "throw",
    "type",
    "units",
    "usercolor",
    "viewlayers",
    "x",
    "xoffset",
    "y",
    "yoffset",
    "zoom",
];

/// Attributes that only change what a drawing looks like.
const LOOKS: [&str; 8] = [
    "backgroundscale",
    "backgroundtransparency",
    "drawcircle",
    "linesize",
    "shapetype",
    "solid",
    "xgrid",
    "ygrid",
];

#[derive(Default)]
pub(super) struct Unknown<'d> {
    looks: BTreeSet<&'d str>,
    attributes: BTreeMap<(&'d str, &'d str), usize>,
    elements: BTreeMap<&'d str, usize>,
}

impl<'d> Unknown<'d> {
    pub(super) fn note_attributes(&mut self, element: &Element<'d>) {
        for name in element.attributes() {
            if LOOKS.contains(&name) {
                self.looks.insert(name);
            } else if !READ.contains(&name) {
                *self.attributes.entry((name, element.name())).or_default() += 1;
            }
        }
    }

    /// Notes an element that is not read.
    pub(super) fn note(&mut self, element: &Element<'d>) {
        *self.elements.entry(element.name()).or_default() += 1;
    }

    pub(super) fn omissions(self) -> impl Iterator<Item = Omission> {
        let looks: Vec<&str> = self.looks.into_iter().collect();
        let looks = (!looks.is_empty()).then(|| {
            let what = format!("{}, which only change how it is drawn", looks.join(", "));
            Omission::new("looks", what)
        });
        let attributes = self.attributes.into_iter();
        let attributes = attributes.map(|((name, element), count)| {
            let of = format!("`{name}` of {count} <{element}>");
            Omission::new(of, "this attribute is not known")
        });
        let elements = self.elements.into_iter().map(|(name, count)| {
            Omission::new(format!("{count} <{name}>"), "this element is not known")
        });
        looks.into_iter().chain(attributes).chain(elements)
    }
}
