//! Mechanisms of other programs, as texts of the language.
//!
//! `linkage` and `pmks` read what another program wrote; `formats` tells what anything else is. Both make a [`Drawing`](drawing::Drawing) of
//! it, and a list of what a drawing cannot hold. `terms` tries on the compiler which allowances, ranges and laws the drawing takes.
//! `writing` names everything in the drawing and prints it.

mod color;
mod drawing;
mod formats;
mod linkage;
mod names;
mod pmks;
mod terms;
mod writing;

pub(crate) use drawing::{Imported, Omission, listed};
pub(crate) use names::{is_type, type_name};
pub(crate) use pmks::is_link;
pub(crate) use writing::FileKind;

use crate::document::{Message, Source};
use crate::failure::Failure;

/// Reads what another program wrote: a link of PMKS+, or a document of Linkage.
///
/// # Errors
/// If the text is wrong; the message names the fault and its place.
pub(crate) fn read(source: &Source) -> Result<Imported, Message> {
    let text = source.text();
    if let Some((start, link)) = formats::shortcut(text) {
        return pmks::read(link).map_err(|message| Message {
            place: start + message.place.start..start + message.place.end,
            ..message
        });
    }
    if is_link(text) {
        pmks::read(text)
    } else if formats::is_of_linkage(text) {
        linkage::read(text)
    } else {
        Err(formats::unknown_format(text))
    }
}

/// A text, and what it does not say.
#[derive(Clone, Debug)]
pub(crate) struct Written {
    pub(crate) text: String,
    pub(crate) omissions: Vec<Omission>,
}

impl Imported {
    /// Writes it in the language, under a name, below a remark on its origin.
    pub(crate) fn written(
        &self,
        origin: &str,
        name: &str,
        kind: FileKind,
    ) -> Result<Written, Failure> {
        let mut drawing = self.drawing.clone();
        drawing.remarks.insert(0, format!("From {origin}."));
        let mut omissions = self.omissions.clone();
        let terms = terms::agreed(&drawing, &mut omissions)?;
        let text = writing::text(&drawing, &terms, name, kind)?;
        Ok(Written { text, omissions })
    }
}
