//! What is wanted of the mechanism, and what is let pass.

use super::Lowering;
use super::name::Named;
use crate::syntax::ast::End;
use crate::syntax::{Place, spelling};
use proc_macro2::{Ident, Span};

const PERMISSIONS: [&str; 2] = ["redundant", "coupled"];

impl Lowering {
    pub(super) fn lower_show(&mut self, keyword: Span, what: &[End]) {
        self.report.tell(
            Place::at(keyword),
            "`show` is not supported yet; everything is shown",
        );
        for end in what {
            match (self.names.look_up(&end.link), &end.axis) {
                (Some(Named::Joint(_)), None) | (Some(Named::Broken), _) => {}
                (None, None) => self.unknown(&end.link),
                _ => self.check_end(end),
            }
        }
    }

    pub(super) fn lower_allow(&mut self, word: &Ident) {
        let text = word.to_string();
        let allow = &mut self.model.allow;
        let allowed = match text.as_str() {
            "redundant" => &mut allow.redundant,
            "coupled" => &mut allow.coupled,
            _ => {
                let remedy = spelling::remedy(&text, &PERMISSIONS);
                let text = format!("unknown permission `{text}`{remedy}");
                return self.report.tell(Place::at(word.span()), text);
            }
        };
        if std::mem::replace(allowed, true) {
            let text = format!("`{text}` is allowed already; remove one of the two");
            self.report.tell(Place::at(word.span()), text);
        }
    }
}
