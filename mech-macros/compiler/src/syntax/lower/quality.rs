//! What pictures look like.

use super::draft::Draft;
use super::reader::Reader;
use crate::model::{Look, Quality};
use crate::syntax::{Place, spelling};
use proc_macro2::Ident;

const QUALITIES: [&str; 2] = ["hard", "smooth"];
const LOOKS: [&str; 3] = ["machine", "diagram", "none"];

pub(super) fn look(reader: &mut Reader, draft: &mut Draft, word: &Ident) {
    let text = word.to_string();
    let look = match text.as_str() {
        "machine" => Look::Machine,
        "diagram" => Look::Diagram,
        "none" => Look::Shapes,
        _ => {
            let remedy = spelling::remedy(&text, &LOOKS);
            let text = format!("unknown look `{text}`{remedy}");
            return reader.report.error(Place::at(word.span()), text);
        }
    };
    draft.model.look = Some(look);
}

pub(super) fn quality(reader: &mut Reader, draft: &mut Draft, word: &Ident) {
    let text = word.to_string();
    draft.model.quality = match text.as_str() {
        "hard" => Quality::Hard,
        "smooth" => Quality::Smooth,
        _ => {
            let remedy = spelling::remedy(&text, &QUALITIES);
            let text = format!("unknown quality `{text}`{remedy}");
            return reader.report.error(Place::at(word.span()), text);
        }
    };
}
