//! What pictures look like.

use super::Lowering;
use crate::model::{Look, Quality};
use crate::syntax::{Place, spelling};
use proc_macro2::{Ident, Span};

const QUALITIES: [&str; 2] = ["hard", "smooth"];
const LOOKS: [&str; 3] = ["machine", "diagram", "none"];

impl Lowering {
    pub(super) fn lower_look(&mut self, keyword: Span, word: &Ident) {
        self.single(keyword, "look", "remove one of the two");
        let text = word.to_string();
        let look = match text.as_str() {
            "machine" => Look::Machine,
            "diagram" => Look::Diagram,
            "none" => Look::Shapes,
            _ => {
                let remedy = spelling::remedy(&text, &LOOKS);
                let text = format!("unknown look `{text}`{remedy}");
                return self.report.error(Place::at(word.span()), text);
            }
        };
        self.model.look = Some(look);
    }

    pub(super) fn lower_quality(&mut self, keyword: Span, word: &Ident) {
        self.single(keyword, "quality", "remove one of the two");
        let text = word.to_string();
        self.model.quality = match text.as_str() {
            "hard" => Quality::Hard,
            "smooth" => Quality::Smooth,
            _ => {
                let remedy = spelling::remedy(&text, &QUALITIES);
                let text = format!("unknown quality `{text}`{remedy}");
                return self.report.error(Place::at(word.span()), text);
            }
        };
    }
}
