//! The table.

use super::dialog::{ask_for, save};
use super::{Action, Menu};
use crate::editor::drawing::Drawing;
use crate::editor::pending::Waiting;
use crate::editor::question::{Destination, FileUse};
use crate::editor::settings::{Panel, Visible};
use crate::editor::{Editor, Tool};
use crate::play::Control;
use eframe::egui::{Key, KeyboardShortcut, Modifiers};

const fn with_command(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND, key)
}

const fn with_command_and_shift(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), key)
}

const fn alone(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::NONE, key)
}

const ALWAYS: fn(&Editor) -> bool = |_| true;
const MOVES: fn(&Editor) -> bool = |editor| editor.player().is_some();
const SELECTED: fn(&Editor) -> bool = |editor| !editor.selection().is_empty();

pub(super) const ACTIONS: &[Action] = &[
    Action {
        menu: Menu::File,
        name: "New",
        help: "begins with an empty text",
        key: Some(with_command(Key::N)),
        is_possible: ALWAYS,
        perform: |editor| editor.leave_for(Destination::Empty),
    },
    Action {
        menu: Menu::File,
        name: "Open",
        help: "reads a file: of the language, of Linkage, or a link of PMKS+",
        key: Some(with_command(Key::O)),
        is_possible: ALWAYS,
        perform: |editor| ask_for(editor, FileUse::Open),
    },
    Action {
        menu: Menu::File,
        name: "Save",
        help: "writes the text",
        key: Some(with_command(Key::S)),
        is_possible: ALWAYS,
        perform: |editor| {
            if editor.workspace().is_named() {
                save(editor, None, false, None);
            } else {
                ask_for(editor, FileUse::Save(None));
            }
        },
    },
    Action {
        menu: Menu::File,
        name: "Save as",
        help: "writes the text to a new file",
        key: Some(with_command_and_shift(Key::S)),
        is_possible: ALWAYS,
        perform: |editor| ask_for(editor, FileUse::Save(None)),
    },
    Action {
        menu: Menu::File,
        name: "Copy text",
        help: "puts the text on the clipboard",
        key: None,
        is_possible: ALWAYS,
        perform: |editor| {
            editor.clipboard.next = Some(editor.workspace().text().to_owned());
            editor.talk.tell("copied the text");
        },
    },
    #[cfg(target_arch = "wasm32")]
    Action {
        menu: Menu::File,
        name: "Copy link",
        help: "puts an address on the clipboard that opens this text",
        key: None,
        is_possible: ALWAYS,
        perform: |editor| match crate::browser::link_to(editor.workspace().text()) {
            Ok(link) => {
                editor.clipboard.next = Some(link);
                editor.talk.tell("copied an address that opens this text");
            }
            Err(failure) => editor.talk.refuse(failure),
        },
    },
    Action {
        menu: Menu::Edit,
        name: "Undo",
        help: "undoes the last step, or what was moved by hand since",
        key: Some(with_command(Key::Z)),
        is_possible: |editor| {
            !editor.is_at_rest()
                || editor.sight.playing.is_moved_by_hand()
                || !editor.workspace().history().made().is_empty()
        },
        perform: Editor::undo,
    },
    Action {
        menu: Menu::Edit,
        name: "Redo",
        help: "makes it again",
        key: Some(with_command_and_shift(Key::Z)),
        is_possible: |editor| {
            editor.is_at_rest() && !editor.workspace().history().undone().is_empty()
        },
        perform: Editor::redo,
    },
    Action {
        menu: Menu::Edit,
        name: "Stop",
        help: "ends what is done beside the window: an analysis, a search, a film",
        key: Some(with_command(Key::Period)),
        is_possible: |editor| editor.work().is_some(),
        perform: Editor::stop,
    },
    Action {
        menu: Menu::Edit,
        name: "Delete",
        help: "removes what is selected",
        key: Some(alone(Key::Delete)),
        is_possible: SELECTED,
        perform: Editor::remove_selected,
    },
    Action {
        menu: Menu::Edit,
        name: "Select all",
        help: "selects all links",
        key: Some(with_command(Key::A)),
        is_possible: |editor| editor.drawing().is_some(),
        perform: |editor| {
            let links = editor.sight.drawing().map(Drawing::declared_links);
            editor.selection.select_links(links.into_iter().flatten());
        },
    },
    Action {
        menu: Menu::Edit,
        name: "Copy",
        help: "notes the selected links with what joins them, to be pasted here or elsewhere",
        key: Some(with_command(Key::C)),
        is_possible: SELECTED,
        perform: copy,
    },
    Action {
        menu: Menu::Edit,
        name: "Paste",
        help: "declares what was copied, under names that are free",
        key: Some(with_command(Key::V)),
        is_possible: |editor| !editor.clipboard.copied.is_empty(),
        perform: |editor| paste(editor, ""),
    },
    Action {
        menu: Menu::Edit,
        name: "Group",
        help: "selects these together from now on",
        key: Some(with_command(Key::G)),
        is_possible: SELECTED,
        perform: |editor| {
            let items = editor.selection.with_handles(editor.sight.drawing());
            let grouped = editor.desk.group(items.clone());
            if grouped.is_ok() {
                editor.selection.items = items;
            }
            editor.talk.tell_done(grouped);
        },
    },
    Action {
        menu: Menu::Edit,
        name: "Ungroup",
        help: "selects each of them alone again",
        key: Some(with_command_and_shift(Key::G)),
        is_possible: SELECTED,
        perform: |editor| {
            editor.desk.ungroup(&editor.selection.items);
            editor.talk.tell("ungrouped");
        },
    },
    Action {
        menu: Menu::Edit,
        name: "Lock",
        help: "keeps the pointer from moving what is selected",
        key: Some(with_command(Key::L)),
        is_possible: SELECTED,
        perform: |editor| lock(editor, true),
    },
    Action {
        menu: Menu::Edit,
        name: "Unlock",
        help: "lets the pointer move it again",
        key: Some(with_command_and_shift(Key::L)),
        is_possible: SELECTED,
        perform: |editor| lock(editor, false),
    },
    Action {
        menu: Menu::Edit,
        name: "Stop the tool",
        help: "forgets what was picked, and selects again",
        key: Some(alone(Key::Escape)),
        is_possible: ALWAYS,
        perform: |editor| {
            editor.choose(Tool::Select);
            editor.selection.items.clear();
        },
    },
    Action {
        menu: Menu::View,
        name: "Picture behind",
        help: "puts a picture behind the drawing, to be traced",
        key: None,
        is_possible: ALWAYS,
        perform: |editor| ask_for(editor, FileUse::Picture),
    },
    Action {
        menu: Menu::View,
        name: "See everything",
        help: "fits the whole motion into the window, and what is constructed beside it",
        key: Some(alone(Key::Home)),
        is_possible: ALWAYS,
        perform: |editor| {
            let beside = editor.board().map(|board| board.extent());
            editor.sight.fit_with(beside);
        },
    },
    Action {
        menu: Menu::View,
        name: "Snap",
        help: "lets places snap to the grid and to what is near; Alt does the other",
        key: Some(alone(Key::Num1)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.snaps ^= true,
    },
    Action {
        menu: Menu::View,
        name: "Grid",
        help: "shows the grid",
        key: Some(alone(Key::Num2)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.toggle(Visible::Grid),
    },
    Action {
        menu: Menu::View,
        name: "Names",
        help: "shows the names of joints and links",
        key: Some(alone(Key::Num3)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.toggle(Visible::Names),
    },
    Action {
        menu: Menu::View,
        name: "Bodies",
        help: "shows the bodies of links; without, the schematic",
        key: Some(alone(Key::Num4)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.toggle(Visible::Bodies),
    },
    Action {
        menu: Menu::View,
        name: "Paths",
        help: "shows the whole paths of traced points",
        key: Some(alone(Key::Num5)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.toggle(Visible::Paths),
    },
    Action {
        menu: Menu::View,
        name: "Velocities",
        help: "shows the velocities of points as arrows, at 1 rad or unit per second of the plotted motor",
        key: Some(alone(Key::Num7)),
        is_possible: MOVES,
        perform: |editor| editor.settings.toggle(Visible::Velocities),
    },
    Action {
        menu: Menu::View,
        name: "Accelerations",
        help: "shows the accelerations of points as arrows, at the same rate",
        key: Some(alone(Key::Num8)),
        is_possible: MOVES,
        perform: |editor| editor.settings.toggle(Visible::Accelerations),
    },
    Action {
        menu: Menu::View,
        name: "Forces",
        help: "shows the forces in joints as arrows; masses, springs and gravity act",
        key: Some(alone(Key::Num9)),
        is_possible: MOVES,
        perform: |editor| editor.settings.toggle(Visible::Forces),
    },
    Action {
        menu: Menu::View,
        name: "Instant centres",
        help: "shows the instant centres of all links, as the plotted motor moves",
        key: None,
        is_possible: MOVES,
        perform: |editor| editor.settings.toggle(Visible::Centres),
    },
    Action {
        menu: Menu::View,
        name: "Velocity polygon",
        help: "draws the velocity polygon beside the mechanism, at 1 rad or unit per second of the plotted motor",
        key: None,
        is_possible: MOVES,
        perform: |editor| editor.settings.toggle(Visible::VelocityPolygon),
    },
    Action {
        menu: Menu::View,
        name: "Acceleration polygon",
        help: "draws the acceleration polygon beside it, at the same rate",
        key: None,
        is_possible: MOVES,
        perform: |editor| editor.settings.toggle(Visible::AccelerationPolygon),
    },
    Action {
        menu: Menu::View,
        name: "Free bodies",
        help: "draws each link alone beside it, with the forces and torques on it at rest",
        key: None,
        is_possible: MOVES,
        perform: |editor| editor.settings.toggle(Visible::FreeBodies),
    },
    Action {
        menu: Menu::View,
        name: "Inflection circles",
        help: "shows the inflection circles of the selected links",
        key: None,
        is_possible: MOVES,
        perform: |editor| editor.settings.toggle(Visible::InflectionCircles),
    },
    Action {
        menu: Menu::View,
        name: "Centrodes",
        help: "shows both centrodes of the selected links: the moving one rolls on the fixed one",
        key: None,
        is_possible: MOVES,
        perform: |editor| editor.settings.toggle(Visible::Centrodes),
    },
    Action {
        menu: Menu::View,
        name: "Day or night",
        help: "dark on light, or light on dark",
        key: Some(alone(Key::Num6)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.is_dark ^= true,
    },
    Action {
        menu: Menu::View,
        name: "Help",
        help: "shows what can be done",
        key: Some(alone(Key::F1)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.panel = Some(Panel::Help),
    },
    Action {
        menu: Menu::Play,
        name: "Play or pause",
        help: "lets the motors move",
        key: Some(alone(Key::Space)),
        is_possible: MOVES,
        perform: |editor| editor.sight.obey(Control::PlayOrPause),
    },
    Action {
        menu: Menu::Play,
        name: "Step forward",
        help: "moves by one step",
        key: Some(alone(Key::Period)),
        is_possible: MOVES,
        perform: |editor| editor.sight.obey(Control::Step(1.0)),
    },
    Action {
        menu: Menu::Play,
        name: "Step back",
        help: "moves back by one step",
        key: Some(alone(Key::Comma)),
        is_possible: MOVES,
        perform: |editor| editor.sight.obey(Control::Step(-1.0)),
    },
    Action {
        menu: Menu::Play,
        name: "Reverse",
        help: "plays the other way",
        key: Some(alone(Key::Backspace)),
        is_possible: MOVES,
        perform: |editor| editor.sight.obey(Control::Reverse),
    },
    Action {
        menu: Menu::Play,
        name: "Next motor",
        help: "plays the next motor alone; after the last, all",
        key: Some(alone(Key::Plus)),
        is_possible: MOVES,
        perform: |editor| editor.sight.obey(Control::NextMotor),
    },
    Action {
        menu: Menu::Play,
        name: "Back to the start",
        help: "puts all motors where they start",
        key: Some(alone(Key::Num0)),
        is_possible: MOVES,
        perform: |editor| editor.sight.obey(Control::Reset),
    },
];

/// Keeps the pointer from moving what is selected, or lets it move that again.
fn lock(editor: &mut Editor, is_locked: bool) {
    let items = editor.selection.with_handles(editor.sight.drawing());
    let told = editor.desk.lock(items, is_locked);
    editor.talk.tell(told);
}

/// Notes the selected links, with what is between them.
pub(super) fn copy(editor: &mut Editor) {
    let links = editor.selection.links().collect();
    let copied = editor.clipboard.copy(&links, &editor.session.workspace);
    editor.talk.tell_done(copied);
}

/// Declares what was copied, here or elsewhere.
pub(super) fn paste(editor: &mut Editor, text: &str) {
    if let Some(text) = editor.clipboard.to_paste(text) {
        editor.wait(Waiting::Paste(text));
    } else {
        let why = "nothing was copied that can be pasted; select links and copy them";
        editor.talk.refuse(why);
    }
}
