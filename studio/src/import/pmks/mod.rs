//! Links of PMKS+: the mechanism stands in the address itself.
//!
//! `compact`, `early` and `plain` read three generations of links. All make a [`Linkage`](linkage::Linkage); `translation` makes a drawing of it.

mod compact;
mod corrections;
mod digits;
mod early;
mod linkage;
mod plain;
mod query;
mod sections;
mod translation;

use crate::document::Message;
use crate::import::Imported;
use query::Query;

/// The beginnings of links of any kind.
const BEGINNINGS: [&str; 4] = ["https://", "http://", "?", "j="];

/// The beginning of documents of 2026.
const NATIVE: &str = "pmks2:";

/// Whether a text is a link, or the query of one.
pub(crate) fn is_link(text: &str) -> bool {
    // A file may begin with a mark of its encoding.
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let mut beginnings = BEGINNINGS.iter();
    beginnings.any(|beginning| text.starts_with(beginning)) || sections::has_sections(text)
}

pub(super) fn read(text: &str) -> Result<Imported, Message> {
    let query = Query::of(text)?;
    let whole = query.whole();
    let linkage = if plain::is_plain(whole.text()) {
        plain::read(&whole)?
    } else if whole.text().contains(NATIVE) {
        return Err(whole
            .wrong("this link holds a document of PMKS+ of 2026 (`pmks2:`), which is not read"));
    } else if !sections::has_sections(whole.text()) {
        return Err(whole.wrong(
            "this is no link of PMKS+: it would have settings, joints and links after a question mark",
        ));
    } else if early::is_early(&whole) {
        early::read(whole)?
    } else {
        compact::read(whole)?
    };
    Ok(translation::translate(linkage))
}
