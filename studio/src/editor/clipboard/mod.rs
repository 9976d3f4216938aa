//! What is copied and pasted.

mod fragment;
mod pasting;

use super::names::Names;
use super::snap::grid;
use super::state::Waiting;
use super::{Editor, Gesture, Item};
use crate::edit::Command;
use crate::failure::Failure;
use crate::text::shortest;
use mech_compiler::model::{AxisId, AxisKind};
use std::collections::BTreeSet;

impl Editor {
    /// Notes the selected links as statements, with what is between them.
    pub(super) fn copy(&mut self) {
        let links = self.selection.iter().filter_map(|item| match item {
            Item::Link(name) => Some(name.clone()),
            _ => None,
        });
        let links: BTreeSet<String> = links.collect();
        let copied = match self.fragment_of(&links) {
            Ok(Some(copied)) => copied,
            Ok(None) => return self.refuse("links are copied; select one that is declared here"),
            Err(failure) => return self.refuse(failure),
        };
        self.to_clipboard = Some(copied.clone());
        self.copied = copied;
        match links.len() {
            1 => self.tell("copied a link"),
            count => self.tell(format!("copied {count} links")),
        }
    }

    fn fragment_of(&self, links: &BTreeSet<String>) -> Result<Option<String>, Failure> {
        let document = self.workspace().document();
        fragment::copied(&document, self.workspace().index(), links)
    }

    /// Declares what was copied, here or elsewhere.
    pub(super) fn paste(&mut self, text: &str) {
        let text = if text.is_empty() { &self.copied } else { text };
        if !pasting::can_be_pasted(text) {
            self.refuse("nothing was copied that can be pasted; select links and copy them");
            return;
        }
        self.wait(Waiting::Paste(text.to_owned()));
    }

    /// Declares statements that were copied, as one step. The copies are selected.
    pub(super) fn paste_now(&mut self, copied: &str) {
        let (document, index) = (self.workspace().document(), self.workspace().index());
        let step = grid(self.scene.scale());
        match pasting::pasted(&document, index, copied, [step, -step]) {
            Ok((text, links)) => {
                let title = match links.len() {
                    1 => "paste a link".to_owned(),
                    count => format!("paste {count} links"),
                };
                self.session.workspace.push(title.as_str(), &text);
                self.let_go();
                self.selection = links.into_iter().map(Item::Link).collect();
                self.read();
                self.tell(title);
            }
            Err(why) => self.refuse(why),
        }
    }

    /// Declares links once more, as soon as the gestures before that are made: until then nobody knows which names are free.
    pub(super) fn declare_again(&mut self, links: Vec<String>) {
        self.wait(Waiting::Copies(links));
    }

    /// What declares links once more; none if there are none. The copies are selected.
    pub(super) fn gesture_of_copies(&mut self, links: &[String]) -> Option<Gesture> {
        let copies = self.copies(links);
        let title = match (&copies[..], links) {
            ([], _) => return None,
            ([(copy, _)], [name, ..]) => format!("copy {name} as {copy}"),
            (several, _) => format!("copy {} links", several.len()),
        };
        self.selection = copies
            .iter()
            .map(|(copy, _)| Item::Link(copy.clone()))
            .collect();
        let commands = copies.into_iter().flat_map(|(_, commands)| commands);
        Some(Gesture::new(title, commands.collect()))
    }

    /// What declares links once more, each under a name that is free.
    fn copies(&self, links: &[String]) -> Vec<(String, Vec<Command>)> {
        let mut names = Names::of(self.scene.drawing());
        let copies = links.iter().map(|name| {
            let copy = names.numbered(name.trim_end_matches(|last: char| last.is_ascii_digit()));
            let duplicate = Command::Duplicate {
                name: name.clone(),
                copy: copy.clone(),
            };
            let points = self.points_of_copy(name, &copy);
            (copy, [vec![duplicate], points].concat())
        });
        copies.collect()
    }

    /// Points where a link is joined, for its copy, which no joint gives a place. A link that nothing else gives one is copied beside itself.
    fn points_of_copy(&self, name: &str, copy: &str) -> Vec<Command> {
        let drawn = self.scene.drawing().and_then(|drawing| {
            let link = drawing.link(name)?;
            drawing.model.link(link).drawn.then_some((drawing, link))
        });
        let Some((drawing, link)) = drawn else {
            return Vec::new();
        };
        let (own, joined): (Vec<AxisId>, Vec<AxisId>) = drawing
            .axes_on(link)
            .partition(|axis| drawing.path(*axis).is_some());
        let is_free = own.is_empty() && drawing.model.link(link).shapes.is_empty();
        let beside = if is_free {
            grid(self.scene.scale())
        } else {
            0.0
        };
        let pins = joined
            .into_iter()
            .map(|axis| drawing.model.axis(axis))
            .filter(|axis| axis.kind == AxisKind::Point);
        let mut places: Vec<[f64; 2]> = Vec::new();
        for axis in pins {
            let place = [axis.at[0] + beside, axis.at[1] - beside];
            if !places.contains(&place) {
                places.push(place);
            }
        }
        let tolerance = 1e-6 * drawing.model.size();
        // The copy has the points of the other, too.
        let numbers =
            (1_u32..).filter(|number| drawing.axis(&format!("{name}.end{number}")).is_none());
        let points = numbers.zip(places).map(|(number, place)| Command::Axis {
            path: format!("{copy}.end{number}"),
            at: place.map(|part| shortest(part, tolerance)),
            along: None,
        });
        points.collect()
    }

    /// Puts the text on the clipboard.
    pub(super) fn copy_text(&mut self) {
        self.to_clipboard = Some(self.workspace().text().to_owned());
        self.tell("copied the text");
    }

    /// Puts an address on the clipboard that opens this text.
    #[cfg(target_arch = "wasm32")]
    pub(super) fn copy_link(&mut self) {
        match crate::browser::link_to(self.workspace().text()) {
            Ok(link) => {
                self.to_clipboard = Some(link);
                self.tell("copied an address that opens this text");
            }
            Err(failure) => self.refuse(failure),
        }
    }
}
