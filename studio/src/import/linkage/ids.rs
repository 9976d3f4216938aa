//! The connectors and links that ids name, and the losses where they name nothing.

use super::document::{Connector, Fastening, Link};
use super::element::{Element, Id};
use crate::document::Message;
use crate::import::drawing::Omission;
use std::collections::BTreeMap;

/// The losses of something with a name.
pub(super) struct Losses<'o> {
    pub(super) of: String,
    pub(super) omissions: &'o mut Vec<Omission>,
}

/// The numbers of connectors and links by their ids: of several with one id, that of the first.
pub(super) struct Ids {
    pub(super) connectors: BTreeMap<Id, usize>,
    pub(super) links: BTreeMap<Id, usize>,
    /// By how much lengths of the document are multiplied.
    pub(super) scale: f64,
}

impl Losses<'_> {
    pub(super) fn note(&mut self, what: impl Into<String>) {
        self.omissions.push(Omission::new(&*self.of, what));
    }
}

impl Ids {
    /// The connector that an attribute names, if it names one that is there.
    pub(super) fn connector(
        &self,
        element: &Element<'_>,
        name: &str,
        losses: &mut Losses<'_>,
    ) -> Result<Option<usize>, Message> {
        named(&self.connectors, element, (name, "connector"), losses)
    }

    /// The link that an attribute names, if it names one that is there.
    pub(super) fn link(
        &self,
        element: &Element<'_>,
        name: &str,
        losses: &mut Losses<'_>,
    ) -> Result<Option<usize>, Message> {
        named(&self.links, element, (name, "link"), losses)
    }

    /// The connector that an element stands for, if it is there.
    pub(super) fn connector_of(
        &self,
        element: &Element<'_>,
        losses: &mut Losses<'_>,
    ) -> Result<Option<usize>, Message> {
        element.id()?;
        self.connector(element, "id", losses)
    }

    /// Finds the link or connector to which an element is fastened.
    pub(super) fn fastening(
        &self,
        element: &Element<'_>,
        losses: &mut Losses<'_>,
    ) -> Result<Option<Fastening>, Message> {
        for name in ["fastenlink", "fasten"] {
            if let Some(link) = self.link(element, name, losses)? {
                return Ok(Some(Fastening::Link(link)));
            }
        }
        let connector = self.connector(element, "fastenconnector", losses)?;
        Ok(connector.map(Fastening::Connector))
    }

    /// Of several connectors with one id, everything that names it means the first, as in Linkage: links, slides and fastenings.
    pub(super) fn settle_connectors(&self, all: &mut [Connector], omissions: &mut Vec<Omission>) {
        for number in 0..all.len() {
            let id = all[number].id;
            let Some(first) = self.connectors.get(&id).copied().filter(|one| *one != number) else {
                continue;
            };
            let later = &mut all[number];
            (later.is_of_mechanism, later.is_input, later.is_traced) = (false, false, false);
            let (slide, fastened) = (later.slide.take(), later.fastened.take());
            let first = &mut all[first];
            first.slide = slide.or(first.slide);
            first.fastened = fastened.or(first.fastened);
            let what = "an earlier connector has this id, too, and all that names it; this one is left out";
            omissions.push(Omission::new(format!("connector {id}"), what));
        }
    }

    /// Several links with one id are several links; what is fastened by the id is fastened to the first, as in Linkage.
    pub(super) fn settle_links(&self, all: &mut [Link], omissions: &mut Vec<Omission>) {
        for number in 0..all.len() {
            let id = all[number].id;
            let Some(first) = self.links.get(&id).copied().filter(|one| *one != number) else {
                continue;
            };
            let fastened = all[number].fastened.take();
            all[first].fastened = fastened.or(all[first].fastened);
            let what = "an earlier link has this id, too; both are read, and what names the id means the first";
            omissions.push(Omission::new(format!("link {id}"), what));
        }
    }
}

/// Elements by their ids. Of several with one id, the first has it.
pub(super) fn numbered(elements: &[Element<'_>]) -> Result<BTreeMap<Id, usize>, Message> {
    let mut numbers = BTreeMap::new();
    for (number, element) in elements.iter().enumerate() {
        numbers.entry(element.id()?).or_insert(number);
    }
    Ok(numbers)
}

fn named(
    numbers: &BTreeMap<Id, usize>,
    element: &Element<'_>,
    (name, what): (&str, &str),
    losses: &mut Losses<'_>,
) -> Result<Option<usize>, Message> {
    let Some(id) = element.reference(name)? else {
        return Ok(None);
    };
    let number = numbers.get(&id).copied();
    if number.is_none() {
        losses.note(format!("it names the {what} {id}, which is not there"));
    }
    Ok(number)
}
