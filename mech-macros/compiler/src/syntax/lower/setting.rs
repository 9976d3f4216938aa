//! What is wanted of the mechanism, and what is let pass.

use super::Lowering;
use crate::syntax::{Place, spelling};
use proc_macro2::Ident;

const PERMISSIONS: [&str; 2] = ["redundant", "coupled"];

impl Lowering {
    pub(super) fn lower_allow(&mut self, word: &Ident) {
        let text = word.to_string();
        let allow = &mut self.model.allow;
        let allowed = match text.as_str() {
            "redundant" => &mut allow.redundant,
            "coupled" => &mut allow.coupled,
            _ => {
                let remedy = spelling::remedy(&text, &PERMISSIONS);
                let text = format!("unknown permission `{text}`{remedy}");
                return self.report.error(Place::at(word.span()), text);
            }
        };
        if std::mem::replace(allowed, true) {
            let text = format!("`{text}` is allowed already; remove one of the two");
            self.report.error(Place::at(word.span()), text);
        }
    }
}
