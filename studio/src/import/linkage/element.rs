//! An element of a document, and its attributes.

use crate::document::Message;
use crate::import::drawing::LARGEST;
use roxmltree::{Attribute, Node};
use std::fmt::Display;
use std::ops::Range;
use std::str::FromStr;

/// The number by which a document names a connector or a link.
pub(super) type Id = i64;

#[derive(Clone, Copy)]
pub(super) struct Element<'d> {
    node: Node<'d, 'd>,
}

impl<'d> Element<'d> {
    pub(super) fn new(node: Node<'d, 'd>) -> Self {
        Self { node }
    }

    pub(super) fn name(&self) -> &'d str {
        self.node.tag_name().name()
    }

    /// The elements in it, without those deeper.
    pub(super) fn children(&self) -> impl Iterator<Item = Self> + use<'d> {
        let nodes = self.node.children().filter(Node::is_element);
        nodes.map(Self::new)
    }

    /// Whether it has no attributes, text and children.
    pub(super) fn is_empty(&self) -> bool {
        let text = self.node.text().unwrap_or_default();
        self.node.attributes().len() == 0 && text.trim().is_empty() && self.children().count() == 0
    }

    pub(super) fn attributes(&self) -> impl Iterator<Item = &'d str> {
        self.node.attributes().map(|attribute| attribute.name())
    }

    /// Where it begins, in bytes: `<connector`.
    pub(super) fn place(&self) -> Range<usize> {
        let start = self.node.range().start;
        start..start + 1 + self.name().len()
    }

    pub(super) fn wrong(&self, text: impl Into<String>) -> Message {
        let text = text.into();
        Message { place: self.place(), text }
    }

    /// Makes a message on one of its attributes.
    pub(super) fn wrong_at(&self, name: &str, text: impl Into<String>) -> Message {
        let place = self.attribute(name).map(|found| found.range_value());
        Message { place: place.unwrap_or_else(|| self.place()), text: text.into() }
    }

    fn attribute(&self, name: &str) -> Option<Attribute<'d, 'd>> {
        self.node.attribute_node(name)
    }

    /// A text; none where it is missing or empty.
    pub(super) fn text(&self, name: &str) -> Option<&'d str> {
        let found = self.attribute(name)?.value();
        (!found.is_empty()).then_some(found)
    }

    /// The name that somebody gave it. Spaces are none.
    pub(super) fn own_name(&self) -> Option<String> {
        let name = self.text("name")?.trim();
        (!name.is_empty()).then(|| name.to_owned())
    }

    /// Reads a flag; false where it is missing.
    pub(super) fn flag(&self, name: &str) -> Result<bool, Message> {
        match self.text(name) {
            None | Some("false") => Ok(false),
            Some("true") => Ok(true),
            Some(other) => Err(self.misread(name, other, "neither `true` nor `false`")),
        }
    }

    pub(super) fn number(&self, name: &str) -> Result<Option<f64>, Message> {
        let Some(text) = self.text(name) else {
            return Ok(None);
        };
        let number: f64 = text.trim().parse().map_err(|_| self.misread(name, text, "no number"))?;
        if !number.is_finite() {
            Err(self.misread(name, text, "no finite number"))
        } else if number.abs() > LARGEST {
            Err(self.misread(name, text, "too large"))
        } else {
            Ok(Some(number))
        }
    }

    pub(super) fn needed_number(&self, name: &str) -> Result<f64, Message> {
        self.number(name)?.ok_or_else(|| self.missing(name))
    }

    pub(super) fn whole(&self, name: &str) -> Result<Option<u32>, Message> {
        self.parsed(name, "no whole number from 0 on")
    }

    /// The number of something, if an attribute names it.
    pub(super) fn reference(&self, name: &str) -> Result<Option<Id>, Message> {
        self.parsed(name, "no whole number")
    }

    /// The number by which it is named.
    pub(super) fn id(&self) -> Result<Id, Message> {
        self.reference("id")?.ok_or_else(|| self.missing("id"))
    }

    fn parsed<N: FromStr>(&self, name: &str, what: &str) -> Result<Option<N>, Message> {
        let Some(text) = self.text(name) else {
            return Ok(None);
        };
        let number = text.trim().parse();
        let number = number.map_err(|_| self.misread(name, text, what))?;
        Ok(Some(number))
    }

    fn missing(&self, name: &str) -> Message {
        self.wrong(format!("this <{}> has no `{name}`", self.name()))
    }

    fn misread(&self, name: &str, text: impl Display, what: &str) -> Message {
        self.wrong_at(name, format!("`{name}` is `{text}`, which is {what}"))
    }
}
