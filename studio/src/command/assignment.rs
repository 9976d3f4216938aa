//! Constants and params that have other values than in the file.

use crate::document::Document;
use crate::edit::{self, apply};
use crate::failure::Failure;
use crate::text::quoted;
use std::str::FromStr;

/// A constant or a param and its value, as it is typed: `size=2`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Assignment {
    name: String,
    /// A number in the language of mechanisms.
    value: String,
}

impl FromStr for Assignment {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, value) = text
            .split_once('=')
            .ok_or("expected a constant or a param and its value, as `size=2`")?;
        Ok(Self { name: name.trim().to_owned(), value: value.trim().to_owned() })
    }
}

impl Assignment {
    /// The text with this value in the mechanism with this number.
    pub(super) fn apply_to(&self, document: &Document, index: usize) -> Result<Document, Failure> {
        let declaration = document.declarations().get(index);
        let declaration =
            declaration.ok_or_else(|| Failure::internal("a mechanism is not in its file"))?;
        let Some(listing) = document.listing(declaration)? else {
            // The reading of the text reports faults of the brackets.
            return Ok(document.clone());
        };
        let Self { name, value } = self;
        if !listing.constants().any(|known| known == name) {
            let known = quoted(listing.constants());
            let mechanism = declaration.name.as_deref().unwrap_or("the mechanism");
            return Err(Failure::usage(format!(
                "`{mechanism}` has no constant or param `{name}`; it has {known}"
            )));
        }
        let command = edit::Command::Set {
            owner: name.clone(),
            role: "value".to_owned(),
            value: value.clone(),
        };
        Ok(apply(document, index, &command)?.document)
    }
}
