//! The actions besides drawing: menus, keys, tooltips and help use one table.

mod dialog;
mod help;
mod keys;
mod menu;
mod table;

pub(super) use dialog::dialogs;
pub(super) use help::help;
pub(super) use keys::{key_of_tool, obey_keys};
pub(super) use menu::menu;

use super::Editor;
use eframe::egui::KeyboardShortcut;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Menu {
    File,
    Edit,
    View,
    Play,
}

impl Menu {
    const ALL: [(Self, &'static str); 4] =
        [(Self::File, "File"), (Self::Edit, "Edit"), (Self::View, "View"), (Self::Play, "Motion")];
}

struct Action {
    menu: Menu,
    name: &'static str,
    help: &'static str,
    key: Option<KeyboardShortcut>,
    is_possible: fn(&Editor) -> bool,
    perform: fn(&mut Editor),
}
