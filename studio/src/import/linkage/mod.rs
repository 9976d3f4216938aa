//! Documents of Linkage: files `.linkage2`.
//!
//! `reading` makes a [`Document`](document::Document) of the XML; `unions` finds which of its links are one; `translation` makes a drawing.

mod document;
mod element;
mod ids;
mod ratio;
mod reading;
mod sliding;
mod tags;
mod translation;
mod unions;
mod unknown;

use crate::document::Message;
use crate::import::Imported;
use crate::import::drawing::Omission;
use element::Element;
use roxmltree::{ParsingOptions, TextPos};

/// The most nodes of a tree that is read: elements, texts and comments.
const MOST_NODES: u32 = 100_000;

pub(super) fn read(text: &str) -> Result<Imported, Message> {
    if let Some(place) = tags::overfull(text) {
        let most = tags::MOST;
        return Err(Message {
            place,
            text: format!("this tag has more than {most} attributes, which no drawing has"),
        });
    }
    let mended = tags::Mended::of(text);
    let read = read_xml(&mended.text);
    let mut document =
        read.map_err(|message| Message { place: mended.old(&message.place), ..message })?;
    if mended.has_spaces {
        let what = "attributes without a space between them are read all the same";
        document.omissions.push(Omission::new("document", what));
    }
    Ok(translation::translate(document))
}

fn read_xml(text: &str) -> Result<document::Document, Message> {
    let options = ParsingOptions { nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    let tree = roxmltree::Document::parse_with_options(text, options);
    let tree = tree.map_err(|error| unparsed(text, &error))?;
    reading::read(&Element::new(tree.root_element()))
}

/// Why a text is no XML.
fn unparsed(text: &str, error: &roxmltree::Error) -> Message {
    let start = match error {
        // It lacks its end.
        roxmltree::Error::UnclosedRootNode | roxmltree::Error::UnexpectedEndOfStream => {
            let last = text.trim_end().char_indices().next_back();
            last.map_or(0, |(at, _)| at)
        }
        _ => byte_of(text, error.pos()),
    };
    let end = text[start..].chars().next().map_or(start, |letter| start + letter.len_utf8());
    let why = match error {
        roxmltree::Error::NodesLimitReached => {
            format!("it has more than {MOST_NODES} elements, which no drawing has")
        }
        roxmltree::Error::DtdDetected => "a document type has no place in it".to_owned(),
        other => {
            // The place is told apart.
            let told = other.to_string();
            let place = format!(" at {}", error.pos());
            told.strip_suffix(&place).unwrap_or(&told).to_owned()
        }
    };
    Message {
        place: start..end,
        text: format!("this is no document of Linkage that can be read: {why}"),
    }
}

/// Where a line and a column begin, in bytes.
fn byte_of(text: &str, place: TextPos) -> usize {
    let before = place.row.saturating_sub(1) as usize;
    let lines: usize = text.split_inclusive('\n').take(before).map(str::len).sum();
    let letters = text[lines..].char_indices();
    let column = place.col.saturating_sub(1) as usize;
    letters.map(|(at, _)| lines + at).nth(column).unwrap_or(text.len())
}
