//! What is copied and pasted.

use super::names::Names;
use super::{Editor, Gesture, Item};
use crate::edit::Command;

impl Editor {
    /// Notes the selected links.
    pub(super) fn copy(&mut self) {
        let links = self.selection.iter().filter_map(|item| match item {
            Item::Link(name) => Some(name.clone()),
            _ => None,
        });
        self.copied = links.collect();
        // An empty clipboard is never pasted.
        self.to_clipboard = Some(self.copied.join(" ")).filter(|names| !names.is_empty());
        match self.copied.len() {
            0 => self.refuse("links are copied; select one"),
            1 => self.tell("copied a link"),
            count => self.tell(format!("copied {count} links")),
        }
    }

    /// Declares the copied links once more.
    pub(super) fn paste(&mut self) {
        let mut names = Names::of(self.drawing.as_ref());
        let copies = self.copied.iter().map(|name| Command::Duplicate {
            name: name.clone(),
            copy: names.numbered(name.trim_end_matches(|last: char| last.is_ascii_digit())),
        });
        let copies: Vec<Command> = copies.collect();
        let copied = copies.iter().filter_map(|command| match command {
            Command::Duplicate { copy, .. } => Some(Item::Link(copy.clone())),
            _ => None,
        });
        self.selection = copied.collect();
        let title = match copies.len() {
            0 => return,
            1 => "paste a link".to_owned(),
            count => format!("paste {count} links"),
        };
        self.perform(Gesture::new(title, copies));
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
