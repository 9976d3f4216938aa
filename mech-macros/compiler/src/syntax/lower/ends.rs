//! The ends of joints that are links.

use super::draft::Draft;
use super::find;
use super::name::Body;
use super::reader::Reader;
use crate::model::{LinkId, Origin};
use crate::syntax::Place;
use crate::syntax::ast::{End, JointBody};
use proc_macro2::Ident;

/// A joint whose ends are looked for.
pub(super) struct Joining<'t> {
    pub(super) name: &'t Ident,
    pub(super) body: &'t JointBody,
    /// Where it was declared.
    pub(super) origin: Origin,
}

impl Joining<'_> {
    /// A joint must be between two different links.
    pub(super) fn check_apart(&self, reader: &mut Reader, [a, b]: [LinkId; 2]) -> Option<()> {
        if a != b {
            return Some(());
        }
        let [_, second] = &self.body.ends;
        let (name, link) = (self.name, &second.link);
        let text = format!("joint `{name}` is between `{link}` and itself; name two links");
        reader.report.refuse(second.place(), text)
    }

    /// Complains about the place of a joint that has none of its own.
    pub(super) fn refuse_place(&self, reader: &mut Reader, why: &str) {
        for keyword in self.body.clauses() {
            let text = format!("a `{}` has no place of its own; its {why}", self.body.word);
            reader.report.error(Place::at(keyword), text);
        }
    }
}

/// The link at an end; told with these words if one of its axes is there.
pub(super) fn whole_link(
    reader: &mut Reader,
    draft: &Draft,
    end: &End,
    beginning: &str,
    ending: &str,
) -> Option<Body> {
    let link = find::body(reader, draft, &end.link)?;
    let Some(axis) = &end.axis else {
        return Some(link);
    };
    let name = &end.link;
    let text = format!("{beginning}; write `{name}` for `{name}.{axis}`{ending}");
    reader.report.refuse(end.place(), text)
}
