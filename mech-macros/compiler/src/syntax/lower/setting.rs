//! What is wanted of the mechanism, and what is let pass.

use super::draft::Draft;
use super::reader::Reader;
use crate::syntax::{Place, spelling};
use proc_macro2::Ident;

const PERMISSIONS: [&str; 2] = ["redundant", "coupled"];

pub(super) fn allow(reader: &mut Reader, draft: &mut Draft, word: &Ident) {
    let text = word.to_string();
    let allow = &mut draft.model.allow;
    let allowed = match text.as_str() {
        "redundant" => &mut allow.redundant,
        "coupled" => &mut allow.coupled,
        _ => {
            let remedy = spelling::remedy(&text, &PERMISSIONS);
            let text = format!("unknown permission `{text}`{remedy}");
            return reader.report.error(Place::at(word.span()), text);
        }
    };
    if std::mem::replace(allowed, true) {
        let text = format!("`{text}` is allowed already; remove one of the two");
        reader.report.error(Place::at(word.span()), text);
    }
}
