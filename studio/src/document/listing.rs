//! The names and numbers in the text of a mechanism, with their places in the file.

use super::reading::{range_of, tokens_of};
use super::{Declaration, Document};
use crate::failure::Failure;
use mech_compiler::catch;
use mech_compiler::syntax::{self, ListedName, ListedNumber};
use std::ops::Range;

/// The names and numbers in the text of a mechanism, with their places in the file, in bytes.
pub type Listing = syntax::Listing<Range<usize>>;

/// A name at one place.
pub type NameText = ListedName<Range<usize>>;

/// A number, or a pair of them, at its place.
pub type NumberText = ListedNumber<Range<usize>>;

/// Lists the names and numbers of a mechanism.
pub(super) fn listing(
    document: &Document,
    declaration: &Declaration,
) -> Result<Option<Listing>, Failure> {
    proc_macro2::extra::invalidate_current_thread_spans();
    let Ok(tokens) = tokens_of(document, declaration) else {
        return Ok(None);
    };
    let found = catch(|| syntax::listing(tokens)).map_err(Failure::internal)?;
    Ok(Some(
        found.map_places(|place| range_of(place, &declaration.whole)),
    ))
}
